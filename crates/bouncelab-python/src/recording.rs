//! What is there to know of a result?

use std::sync::OnceLock;

use bouncelab::analysis::{Drop, DropCandidate, Plan, Source, StrongestBand};
use bouncelab::detection::Envelope;
use bouncelab::inference::Draws;
use bouncelab::{Diagnostic, InferenceFailure, Options};
use bouncelab_report::chart::Chart as Data;
use bouncelab_report::columns::{DropRecord, TableKind};
use bouncelab_report::data_table::{Cell, DataTable, Definition};
use bouncelab_report::define_columns;
use bouncelab_report::document::Document;
use bouncelab_report::figure::{self, FigureInput, Mark};
use bouncelab_report::messages::Translator;
use bouncelab_report::quantities;
use bouncelab_report::report::{self, Block, Provenance};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use crate::analyzer::Analyzer;
use crate::chart::Chart;
use crate::failure::Result;
use crate::page::Page;
use crate::physics::translator;
use crate::table::Table;
use crate::watch::interruptible;

/// A recording, or a list of times, and what it says.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Recording {
    name: String,
    analyzer: Analyzer,
    result: OnceLock<bouncelab::Recording>,
    /// What the result is made of again after a pickle.
    kept: Option<Kept>,
}

/// All of a result but what follows from its impacts and the settings, to the last digit. The package keeps the answers
/// beside it; only what it does not keep (figures, reports, other languages) takes the inference again.
#[derive(Clone, Serialize, Deserialize)]
struct Kept {
    source: Source,
    strongest_band: Option<StrongestBand>,
    drops: Vec<DropCandidate>,
    no_drop: Option<Diagnostic>,
    diagnostics: Vec<Diagnostic>,
    /// Length of a step, least and greatest sample of each.
    envelope: Option<(f64, Vec<f32>, Vec<f32>)>,
}

impl Kept {
    fn of(result: &bouncelab::Recording) -> Self {
        let drops = result.drops.iter().map(|drop| DropCandidate {
            impacts: drop.impacts.clone(),
            probability: drop.probability,
        });
        let envelope = result.envelope.as_ref().map(|it| {
            let (least, greatest) = (it.min().to_vec(), it.max().to_vec());
            (it.step_s(), least, greatest)
        });
        Self {
            source: result.source.clone(),
            strongest_band: result.strongest_band,
            drops: drops.collect(),
            no_drop: result.no_drop.clone(),
            diagnostics: result.diagnostics.clone(),
            envelope,
        }
    }

    /// The same result again: the random numbers have their seed.
    fn analyze(&self, options: &Options) -> bouncelab::Recording {
        let mut options = options.clone();
        // The impacts are those after the edits.
        options.edits = bouncelab::analysis::Edits::default();
        let plan = Plan::of_candidates(self.source.clone(), self.drops.clone(), &options);
        let mut result = plan.run();
        result.strongest_band = self.strongest_band;
        result.no_drop.clone_from(&self.no_drop);
        result.diagnostics.clone_from(&self.diagnostics);
        let envelope = self.envelope.clone();
        result.envelope =
            envelope.map(|(step_s, least, greatest)| Envelope::of_steps(step_s, least, greatest));
        result
    }
}

impl Recording {
    pub(crate) fn new(name: &str, analyzer: Analyzer, result: bouncelab::Recording) -> Self {
        Self {
            name: name.to_owned(),
            analyzer,
            result: result.into(),
            kept: None,
        }
    }

    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    pub(crate) fn result(&self, py: Python<'_>) -> Result<&bouncelab::Recording> {
        if let (None, Some(kept)) = (self.result.get(), self.kept.clone()) {
            let options = self.analyzer.setup.options.clone();
            let again = py.detach(|| interruptible(move || kept.analyze(&options)))?;
            // Another thread may have been faster, with the same result.
            self.result.set(again).ok();
        }
        Ok(self
            .result
            .get()
            .expect("a result is there, or what it is made of"))
    }

    fn at(&self, py: Python<'_>, drop: usize) -> Result<&Drop> {
        Ok(&self.result(py)?.drops[drop])
    }

    fn input(&self, py: Python<'_>, drop: usize) -> Result<FigureInput<'_>> {
        Ok(FigureInput::new(
            self.at(py, drop)?,
            &self.analyzer.setup.options,
        ))
    }

    fn seed(&self) -> u64 {
        let inference = self.analyzer.setup.options.inference.as_ref();
        inference.map_or(0, |asked| asked.sampler.seed)
    }

    /// A random order of so many draws.
    fn order(&self, draws: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..draws).collect();
        order.shuffle(&mut ChaCha8Rng::seed_from_u64(self.seed()));
        order
    }

    /// The figures of the recording as a whole, with their names.
    fn own_charts(&self, py: Python<'_>, words: &Translator) -> Result<Vec<(&'static str, Data)>> {
        let result = self.result(py)?;
        let waveform = result.envelope.as_ref().map(|sound| {
            let marks = Mark::of_drops(&result.drops);
            ("waveform", figure::waveform(sound, &marks, words))
        });
        let of_air = figure::of_air(&result.drops, &self.analyzer.setup.options, words);
        Ok(waveform.into_iter().chain(of_air).collect())
    }
}

/// The columns of draws: those of the posterior of a drop, one row for each; the last one only with drag.
#[expect(
    clippy::type_complexity,
    reason = "an alias would fix the lifetime of the rows"
)]
const DRAWN: &[Definition<fn(&(&Draws, usize)) -> Cell>] = define_columns! { |row: (&Draws, usize)|
    restitution: Number [""] "restitution" = row.0.restitution.get(row.1).copied();
    drop_height_m: Number ["m"] "drop height" = row.0.drop_height_m.get(row.1).copied();
    drag_coefficient: Number [""] "drag coefficient" = row.0.drag_coefficient.get(row.1).copied();
};

#[pymethods]
impl Recording {
    /// A recording from what `kept` gives.
    #[new]
    fn restore(name: String, analyzer: &Analyzer, kept: &str) -> Result<Self> {
        Ok(Self {
            name,
            analyzer: analyzer.clone(),
            result: OnceLock::new(),
            kept: Some(serde_json::from_str(kept)?),
        })
    }

    fn __getnewargs__(&self, py: Python<'_>) -> Result<(String, Analyzer, String)> {
        let kept = match &self.kept {
            Some(kept) => serde_json::to_string(kept)?,
            None => serde_json::to_string(&Kept::of(self.result(py)?))?,
        };
        Ok((self.name.clone(), self.analyzer.clone(), kept))
    }

    /// The document of the schema `bouncelab.analysis/3`, with sentences in a language.
    fn document(&self, py: Python<'_>, language: &str) -> Result<String> {
        let words = translator(language)?;
        let mut result = self.result(py)?.clone();
        words.complete(&mut result);
        let setup = &self.analyzer.setup;
        let mut assumptions = setup.assumptions.clone();
        words.complete_each(&mut assumptions);
        let document = Document::new(&self.name, &result, &setup.options, &assumptions);
        Ok(serde_json::to_string(&document)?)
    }

    /// A table of the recording, or of one of its drops: drops, impacts or flights.
    #[pyo3(signature = (name, drop = None))]
    fn table(&self, py: Python<'_>, name: &str, drop: Option<usize>) -> Result<Table> {
        let known = TableKind::ALL.map(TableKind::name);
        let kind = TableKind::ALL.into_iter().find(|kind| kind.name() == name);
        let kind = kind.ok_or_else(|| bouncelab::Error::unknown_name("table", name, &known))?;
        Ok(Table(match drop {
            None => kind.table(&self.name, self.result(py)?),
            Some(drop) => DataTable {
                columns: kind.columns(),
                rows: kind.rows(&DropRecord::from(self.at(py, drop)?)),
            },
        }))
    }

    /// Raises why a drop has no posterior, if it has none.
    fn require_posterior(&self, py: Python<'_>, drop: usize) -> Result<()> {
        let posterior = self.at(py, drop)?.posterior.as_ref();
        posterior.map(|_| ()).map_err(|why| why.clone().into())
    }

    /// Raises why a drop has no log-linear fit, if it has none.
    fn require_fit(&self, py: Python<'_>, drop: usize) -> Result<()> {
        let fit = self.at(py, drop)?.log_linear_fit.as_ref();
        fit.map(|_| ()).map_err(|why| why.clone().into())
    }

    /// The draws of the posterior of a drop, in random order: they come sorted by model, and whoever reads them as a
    /// chain would take that for a correlation.
    fn draws(&self, py: Python<'_>, drop: usize) -> Result<Table> {
        let posterior = self.at(py, drop)?.posterior.as_ref();
        let posterior = posterior.map_err(Clone::clone)?;
        let draws = &posterior.draws;
        let drawn = if draws.drag_coefficient.is_empty() {
            &DRAWN[..2]
        } else {
            DRAWN
        };
        let order = self.order(draws.restitution.len()).into_iter();
        let rows = order.map(|index| (draws, index));
        Ok(Table(DataTable::of(drawn, rows)))
    }

    /// Every unknown of each draw, as JSON, with the order in which `draws` has them and the kinds of ball.
    fn drawn_unknowns(&self, py: Python<'_>, drop: usize) -> Result<String> {
        let posterior = self.at(py, drop)?.posterior.as_ref();
        let posterior = posterior.map_err(Clone::clone)?;
        let failed = bouncelab::Error::CannotInfer(InferenceFailure::SamplingFailed);
        let (posterior, seed) = (posterior.clone(), self.seed());
        let found = py.detach(|| {
            interruptible(move || {
                let drawn = posterior.drawn_unknowns(seed);
                drawn.map(|drawn| (drawn, posterior.possible_kinds()))
            })
        })?;
        let (drawn, kinds) = found.ok_or(failed)?;
        let order = self.order(drawn.log_likelihood.values.len() / drawn.intervals_s.len());
        Ok(serde_json::to_string(&(drawn, order, kinds))?)
    }

    /// Covariance of the restitutions of single impacts of a drop, row after row, and their numbers.
    fn restitution_covariance<'py>(
        &self,
        py: Python<'py>,
        drop: usize,
    ) -> Result<(Vec<usize>, Bound<'py, PyBytes>)> {
        let drop = self.at(py, drop)?;
        let found = drop.per_impact.as_ref().map_err(Clone::clone)?;
        let numbers = found.impacts.iter().map(|impact| impact.number).collect();
        Ok((numbers, bytes(py, &found.covariance(&drop.impacts))))
    }

    /// The answer in a few sentences, of a drop or of all.
    #[pyo3(signature = (language, drop = None))]
    fn summary(&self, py: Python<'_>, language: &str, drop: Option<usize>) -> Result<Vec<String>> {
        let (words, setup) = (translator(language)?, &self.analyzer.setup);
        let drops = match drop {
            Some(drop) => std::slice::from_ref(self.at(py, drop)?),
            None => &self.result(py)?.drops,
        };
        let blocks = drops
            .iter()
            .flat_map(|drop| report::in_words(drop, setup, &words));
        let sentences = blocks.filter_map(|block| match block {
            Block::Lead(text) | Block::Text(text) | Block::Note(text) => Some(text),
            _ => None,
        });
        let no_drop = self.result(py)?.no_drop.iter();
        Ok(sentences
            .chain(no_drop.map(|why| words.diagnostic(why)))
            .collect())
    }

    /// The answer of a drop in one line; an empty text without an answer.
    fn in_one_line(&self, py: Python<'_>, drop: usize, language: &str) -> Result<String> {
        let options = &self.analyzer.setup.options;
        let (drop, translator) = (self.at(py, drop)?, translator(language)?);
        Ok(quantities::in_one_line(drop, options, &translator))
    }

    /// Names of the figures of a drop, or of the recording as a whole.
    #[pyo3(signature = (drop = None))]
    fn figure_names(&self, py: Python<'_>, drop: Option<usize>) -> Result<Vec<&'static str>> {
        if let Some(drop) = drop {
            let input = self.input(py, drop)?;
            return Ok(figure::of_drop(&input).map(|it| it.name).collect());
        }
        let charts = self.own_charts(py, &Translator::english())?.into_iter();
        Ok(charts.map(|(name, _)| name).collect())
    }

    /// A figure of a drop, or of the recording as a whole.
    #[pyo3(signature = (name, language, drop = None))]
    fn figure(
        &self,
        py: Python<'_>,
        name: &str,
        language: &str,
        drop: Option<usize>,
    ) -> Result<Chart> {
        let words = translator(language)?;
        let chart = if let Some(drop) = drop {
            figure::chart(name, &self.input(py, drop)?, &words)
        } else {
            let mut charts = self.own_charts(py, &words)?.into_iter();
            charts.find(|(own, _)| *own == name).map(|(_, chart)| chart)
        };
        if let Some(chart) = chart {
            return Ok(Chart(chart));
        }
        let known = self.figure_names(py, drop)?;
        Err(bouncelab::Error::unknown_name("figure", name, &known).into())
    }

    /// The report, its details unfolded or not.
    fn page(&self, py: Python<'_>, language: &str, unfolded: bool) -> Result<Page> {
        let words = translator(language)?;
        let input = report::ReportInput {
            name: &self.name,
            setup: &self.analyzer.setup,
            result: self.result(py)?,
        };
        Ok(Page(py.detach(|| report::Page {
            unfolded,
            ..report::of_recording(&input, &Provenance::default(), &words)
        })))
    }
}

/// Numbers as the bytes of 64-bit floats.
pub(crate) fn bytes<'py>(py: Python<'py>, values: &[f64]) -> Bound<'py, PyBytes> {
    let bytes: Vec<u8> = values
        .iter()
        .flat_map(|value| value.to_ne_bytes())
        .collect();
    PyBytes::new(py, &bytes)
}
