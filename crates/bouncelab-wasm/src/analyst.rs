//! Analyses impacts.

use std::collections::BTreeMap;

use bouncelab::Recording;
use bouncelab::analysis::{Drop, DropTask, Plan};
use bouncelab::detection::Envelope;
use bouncelab::inference::PriorContraction;
use bouncelab::settings::Setup;
use bouncelab_report::Chart;
use bouncelab_report::columns::TableKind;
use bouncelab_report::data_table::Formulas;
use bouncelab_report::document::Document;
use bouncelab_report::figure::{self, FigureInput, Mark};
use bouncelab_report::messages::{Translator, capital};
use bouncelab_report::quantities::{self, Headline, QuantityList};
use bouncelab_report::report::{self, Provenance};
use bouncelab_report::tables;

use crate::refusal::{Result, unknown};
use crate::simulator;
use crate::wire::{
    Analysed, AnalysisRequest, Comparable, Drawn, DropMarks, FigureTab, SimulationRequest,
};

/// Maximum number of remembered analyses of single drops: those of a recording with many drops, and of
/// the last few edits.
const MAX_REMEMBERED: usize = 64;

/// Analyses drops, and remembers the last ones: an edit of one drop does not repeat the others, and
/// a figure does not repeat the numbers.
#[derive(Debug, Default)]
pub struct Analyst {
    /// The latest last.
    remembered: Vec<(DropTask, Drop)>,
}

/// A request with its result, in a language.
#[derive(Debug)]
pub struct Analysis<'a> {
    request: &'a AnalysisRequest,
    translator: &'a Translator,
    setup: Setup,
    result: Recording,
}

impl Analyst {
    /// Analyses every drop of a request.
    ///
    /// # Errors
    ///
    /// If a setting is out of range. An unknown result of a drop is no error.
    pub fn analyse<'a>(
        &mut self,
        request: &'a AnalysisRequest,
        translator: &'a Translator,
    ) -> Result<Analysis<'a>> {
        let settings = request.settings.clone();
        let mut setup = if request.inference {
            settings.resolve()?
        } else {
            settings.without_inference().resolve()?
        };
        let candidates = request.drops.iter().map(DropMarks::candidate).collect();
        let plan = Plan::of_candidates(request.source.clone(), candidates, &setup.options);
        let drops = plan.tasks().iter().map(|task| self.drop(task)).collect();
        let mut result = plan.finish(drops);
        result.strongest_band = request.strongest_band;
        result.candidates.clone_from(&request.candidates);
        let of_recording = request.diagnostics.iter().cloned();
        result.diagnostics.splice(0..0, of_recording);
        if result.no_drop.is_some() && request.no_drop.is_some() {
            result.no_drop.clone_from(&request.no_drop);
        }
        translator.complete(&mut result);
        translator.complete_each(&mut setup.assumptions);
        Ok(Analysis {
            request,
            translator,
            setup,
            result,
        })
    }

    /// The analysis of one drop, from memory if it is there.
    pub(crate) fn drop(&mut self, task: &DropTask) -> Drop {
        let analysed = match self.remembered.iter().position(|(other, _)| other == task) {
            Some(index) => self.remembered.remove(index),
            None => (task.clone(), task.run()),
        };
        let drop = analysed.1.clone();
        if self.remembered.len() == MAX_REMEMBERED {
            self.remembered.remove(0);
        }
        self.remembered.push(analysed);
        drop
    }
}

impl Analysis<'_> {
    /// The numbers.
    pub fn numbers(&self) -> Analysed<'_> {
        let mut questions = self.request.settings.questions();
        self.translator.complete_each(&mut questions);
        Analysed {
            document: Document::new(
                &self.request.name,
                &self.result,
                &self.setup.options,
                &self.setup.assumptions,
            ),
            ball: self.translator.ball(&self.setup.ball),
            questions,
            headlines: self.headlines(),
            quantities: self.quantities(),
            unknowns: self.unknowns(),
            doubtful_restitutions: self.result.drops.iter().map(doubtful).collect(),
            figures: self.figures(),
            comparable: self.result.drops.iter().map(comparable).collect(),
        }
    }

    fn headlines(&self) -> Vec<Headline> {
        let of_drop = |drop| Headline::of(drop, &self.setup, self.translator);
        self.result.drops.iter().map(of_drop).collect()
    }

    fn quantities(&self) -> Vec<Vec<QuantityList>> {
        let of_drop = |drop| quantities::of_drop(drop, &self.setup.options, self.translator);
        self.result.drops.iter().map(of_drop).collect()
    }

    fn unknowns(&self) -> BTreeMap<&'static str, String> {
        let drops = self.result.drops.iter();
        let posteriors = drops.filter_map(|drop| drop.posterior.as_ref().ok());
        let contracted = posteriors.flat_map(|posterior| &posterior.prior_contraction);
        let named = contracted.map(|PriorContraction { unknown, .. }| {
            let name = capital(&tables::unknown(*unknown, self.translator));
            (unknown.name(), name)
        });
        named.collect()
    }

    fn figures(&self) -> Vec<Vec<FigureTab>> {
        let tab = |name| FigureTab {
            name,
            tab: figure::tab(name, self.translator),
        };
        let names = self.figure_names().into_iter();
        names
            .map(|names| names.into_iter().map(tab).collect())
            .collect()
    }

    /// The names of the figures of each drop.
    fn figure_names(&self) -> Vec<Vec<&'static str>> {
        let of_air: Vec<_> = self.of_air().into_iter().map(|(name, _)| name).collect();
        let of_drop = |drop| {
            let input = FigureInput::new(drop, &self.setup.options);
            let names = figure::of_drop(&input).map(|figure| figure.name);
            names.chain(of_air.iter().copied()).collect()
        };
        self.result.drops.iter().map(of_drop).collect()
    }

    fn of_air(&self) -> Vec<(&'static str, Chart)> {
        figure::of_air(&self.result.drops, &self.setup.options, self.translator)
    }

    /// One of the figures that [`Analysed::figures`] names, of the drop of this index; `simulation` is
    /// what the drop is compared with, its first impact at the time of the first one detected.
    ///
    /// # Errors
    ///
    /// If there is no figure of this name, or the simulation is out of range.
    pub fn chart(
        &self,
        drop: usize,
        name: &str,
        simulation: Option<&SimulationRequest>,
    ) -> Result<Chart> {
        let analysed = self.result.drops.get(drop);
        let first = analysed.and_then(|drop| drop.impacts.first());
        let simulation = simulation.zip(first);
        let simulation = simulation
            .map(|(request, first)| simulator::moved_curve(request, first.time_s))
            .transpose()?;
        let input = analysed.map(|drop| {
            FigureInput::new(drop, &self.setup.options).with_simulation(simulation.as_deref())
        });
        let of_drop = input.and_then(|input| figure::chart(name, &input, self.translator));
        let of_air = || {
            let mut charts = self.of_air().into_iter();
            charts.find_map(|(other, chart)| (other == name).then_some(chart))
        };
        of_drop
            .or_else(of_air)
            .ok_or_else(|| unknown("figure", name, &self.figure_names().concat()))
    }

    /// The sound with its impacts.
    pub fn waveform(&self, sound: &Envelope) -> Chart {
        figure::waveform(sound, &Mark::of_drops(&self.result.drops), self.translator)
    }

    /// The report as one HTML file.
    pub fn report(mut self, sound: Option<Envelope>, made: Option<String>) -> String {
        self.result.envelope = sound;
        let recording = report::ReportInput {
            name: &self.request.name,
            setup: &self.setup,
            result: &self.result,
        };
        let provenance = Provenance {
            made,
            ..Provenance::default()
        };
        report::of_recording(&recording, &provenance, self.translator).html()
    }

    /// The impacts as CSV, its first line the names of the columns.
    pub fn csv(&self) -> String {
        let impacts = TableKind::Impacts.table(&self.request.name, &self.result);
        impacts.csv(Formulas::Guarded)
    }
}

/// The numbers of the impacts whose restitution is in doubt.
fn doubtful(drop: &Drop) -> Vec<usize> {
    let corrected = drop.per_impact.iter().flat_map(|it| &it.impacts);
    let doubtful = corrected.filter(|impact| tables::is_in_doubt(drop, impact));
    doubtful.map(|impact| impact.number).collect()
}

fn comparable(drop: &Drop) -> Option<Comparable> {
    Comparable::of(drop.posterior.as_ref().ok()?)
}

/// A figure as a picture, and as data.
pub fn drawn(name: &str, chart: &Chart) -> Drawn {
    let (width_px, height_px) = chart.size();
    Drawn {
        name: name.to_owned(),
        svg: chart.svg(),
        csv: chart.csv(),
        width_px,
        height_px,
    }
}
