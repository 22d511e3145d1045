//! Does a ball or a floor obey a rule?

use std::path::PathBuf;

use bouncelab::rulebook::{self, Decision, Item, Rebound, Rule};
use bouncelab::settings::Setup;
use bouncelab_report::document::verdict::{Evaluation, Surface, VerdictDocument};
use bouncelab_report::figure;
use bouncelab_report::report::Provenance;
use bouncelab_report::report::verdict::of_verdict;
use bouncelab_report::rules;
use pyo3::prelude::*;

use crate::analyzer::Analyzer;
use crate::chart::Chart;
use crate::failure::{Failure, Result};
use crate::page::Page;
use crate::physics::translator;
use crate::recording::Recording;

/// A rule, of those built in or of files.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Judge {
    rule: Rule,
}

#[pymethods]
impl Judge {
    #[new]
    fn new(name: &str, files: Vec<PathBuf>) -> Result<Self> {
        let rules = rules::all(&files)?;
        let rule = rulebook::find(&rules, name)?.clone();
        Ok(Self { rule })
    }

    /// The ball of the rule, if it names one.
    fn ball(&self) -> Option<String> {
        self.rule.ball.clone()
    }

    /// Whether it compares with another surface.
    fn needs_reference(&self) -> bool {
        self.rule.needs_reference()
    }

    /// Settings with what the rule says of the drops that it judges.
    fn complete(&self, analyzer: &Analyzer, is_its_ball: bool) -> Analyzer {
        let mut completed = analyzer.clone();
        completed.setup.assume(&self.rule, is_its_ball);
        completed
    }

    /// Judges recordings, each of which is one place.
    fn judge(
        &self,
        py: Python<'_>,
        analyzer: &Analyzer,
        places: Vec<Py<Recording>>,
        reference: Vec<Py<Recording>>,
        risk: Option<f64>,
        kept: Vec<String>,
    ) -> Result<Verdict> {
        let decision = risk.map_or(Decision::Simple, |risk| Decision::Guarded { risk });
        let kept = kept.iter().map(|name| Item::stated(name));
        let mut setup = analyzer.setup.clone();
        setup.conditions.kept = kept.collect::<bouncelab::Result<_>>()?;
        let (here, there) = (
            self.surface(py, &setup, &places)?,
            self.surface(py, &setup, &reference)?,
        );
        let judged = py.detach(|| Evaluation::new(&self.rule, &setup, here, there, decision))?;
        Ok(Verdict(judged))
    }
}

impl Judge {
    /// The rebounds in recordings, each of which is a place.
    fn surface(&self, py: Python<'_>, setup: &Setup, places: &[Py<Recording>]) -> Result<Surface> {
        let mut surface = Surface::default();
        for place in places {
            let drops = place.get().result(py)?.drops.iter();
            let rebounds = drops.map(|drop| Rebound::new(drop, &self.rule, &setup.options));
            surface.push(place.get().name().to_owned(), rebounds.collect());
        }
        Ok(surface)
    }
}

/// A verdict.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Verdict(Evaluation);

#[pymethods]
impl Verdict {
    /// The document of the schema `bouncelab.verdict/4`.
    fn document(&self, language: &str) -> Result<String> {
        let words = translator(language)?;
        let document = VerdictDocument::new(&self.0, &words);
        Ok(serde_json::to_string(&document)?)
    }

    /// The report.
    fn page(&self, language: &str) -> Result<Page> {
        let words = translator(language)?;
        let provenance = Provenance::default();
        Ok(Page(of_verdict(&self.0, &provenance, None, &words)))
    }

    /// What it is about, against the limits of the rule.
    fn figure(&self, name: &str, language: &str) -> Result<Chart> {
        if name != "limits" {
            return Err(Failure::from(bouncelab::Error::unknown_name(
                "figure",
                name,
                &["limits"],
            )));
        }
        let words = translator(language)?;
        Ok(Chart(figure::verdict(
            &self.0.rule,
            &self.0.verdict,
            &self.0.files,
            &words,
        )))
    }
}

/// Names and titles of the rules that are built in.
#[pyfunction]
pub(crate) fn rules_built_in() -> Result<Vec<(String, String, String)>> {
    let rules = rules::all(&[])?.into_iter();
    Ok(rules
        .map(|rule| (rule.name, rule.title, rule.source.citation()))
        .collect())
}
