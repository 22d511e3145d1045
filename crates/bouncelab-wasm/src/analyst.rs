//! What do the impacts say?

use bouncelab::analysis::{self, Drop, Impact, Options};
use bouncelab::detection::Envelope;
use bouncelab::setup::Setup;
use bouncelab_report::Chart;
use bouncelab_report::document::{Document, rows};
use bouncelab_report::figure::{self, Mark, Subject};
use bouncelab_report::messages::Translator;
use bouncelab_report::report::{self, Provenance, Recording};

use crate::refusal::Result;
use crate::settings::setting;
use crate::simulator;
use crate::wire::{Analysed, AnalysisRequest, Drawn, DropMarks, SimulationRequest};

/// So many analyses of single drops are remembered: those of a recording with many drops, and of
/// the last few edits.
const REMEMBERED: usize = 64;

/// Analyses drops, and remembers the last ones: who edits one drop need not wait for the others,
/// and who wants a figure need not wait for the numbers.
#[derive(Default)]
pub struct Analyst {
    /// The latest last.
    known: Vec<Known>,
}

struct Known {
    impacts: Vec<Impact>,
    settings: Options,
    analysis: Drop,
}

/// A request with its answer.
struct Answered<'a> {
    request: &'a AnalysisRequest,
    setup: Setup,
    drops: Vec<Drop>,
}

impl Analyst {
    /// Analyses every drop of a request.
    ///
    /// # Errors
    ///
    /// If a setting makes no sense. A drop of which something cannot be told is no error.
    pub fn analyse(&mut self, request: &AnalysisRequest) -> Result<Analysed> {
        Ok(self.answer(request)?.analysed())
    }

    /// One of the figures that [`Analysed::figures`] names, of the drop of this index; `simulation` is
    /// what the drop is compared with, its first impact at the time of the first one heard.
    ///
    /// # Errors
    ///
    /// Those of [`Self::analyse`], and if there is no figure of this name.
    pub fn chart(
        &mut self,
        request: &AnalysisRequest,
        (drop, name): (usize, &str),
        simulation: Option<&SimulationRequest>,
        translator: &Translator,
    ) -> Result<Chart> {
        let answered = self.answer(request)?;
        let found = answered.drops.get(drop);
        let first = found.and_then(|found| found.impacts.first());
        let simulation = simulation.zip(first);
        let simulation = simulation
            .map(|(request, first)| simulator::moved_curve(request, first.time_s))
            .transpose()?;
        let subject = found.map(|found| {
            Subject::new(found, answered.settings()).with_simulation(simulation.as_deref())
        });
        let of_drop = subject.and_then(|subject| figure::chart(name, &subject, translator));
        let of_air = || {
            let charts = figure::of_air(&answered.drops, answered.settings(), translator);
            let named = charts.into_iter().find(|(known, _)| *known == name);
            named.map(|(_, chart)| chart)
        };
        of_drop
            .or_else(of_air)
            .ok_or_else(|| setting(&format!("there is no figure \"{name}\" of this drop")))
    }

    /// The sound with its impacts.
    ///
    /// # Errors
    ///
    /// Those of [`Self::analyse`].
    pub fn waveform(
        &mut self,
        request: &AnalysisRequest,
        sound: &Envelope,
        translator: &Translator,
    ) -> Result<Chart> {
        let marks = Mark::of_drops(&self.answer(request)?.drops);
        Ok(figure::waveform(sound, &marks, translator))
    }

    /// The report as one HTML file.
    ///
    /// # Errors
    ///
    /// Those of [`Self::analyse`].
    pub fn report(
        &mut self,
        request: &AnalysisRequest,
        sound: Option<&Envelope>,
        made: Option<String>,
        translator: &Translator,
    ) -> Result<String> {
        let answered = self.answer(request)?;
        let page = report::of_recording(
            &Recording {
                name: &request.name,
                origin: &request.source,
                settings: &answered.setup.settings,
                ball_label: &answered.setup.ball_label,
                assumptions: &answered.setup.assumptions,
                drops: &answered.drops,
                no_drop: request.no_drop.as_deref(),
                warnings: &request.warnings,
                sound,
            },
            &Provenance {
                made,
                ..Provenance::default()
            },
            translator,
        );
        Ok(page.html())
    }

    /// The impacts as rows, the first of them the names of the columns.
    ///
    /// # Errors
    ///
    /// Those of [`Self::analyse`].
    pub fn rows(&mut self, request: &AnalysisRequest) -> Result<Vec<Vec<String>>> {
        let header = rows::HEADER.map(str::to_owned).to_vec();
        let rows = rows::of(&self.answer(request)?.document());
        Ok(std::iter::once(header).chain(rows).collect())
    }

    fn answer<'a>(&mut self, request: &'a AnalysisRequest) -> Result<Answered<'a>> {
        let setup = request.settings.resolve(request.effort)?;
        let drops = request.drops.iter();
        let drops = drops
            .map(|marks| self.know(impacts(marks), &setup.settings))
            .collect();
        Ok(Answered {
            request,
            setup,
            drops,
        })
    }

    /// The analysis of one drop, from memory if it is there.
    fn know(&mut self, impacts: Vec<Impact>, settings: &Options) -> Drop {
        let is_it = |known: &Known| known.impacts == impacts && known.settings == *settings;
        let known = match self.known.iter().position(is_it) {
            Some(index) => self.known.remove(index),
            None => Known {
                analysis: analysis::analyze(impacts.clone(), settings),
                impacts,
                settings: settings.clone(),
            },
        };
        let analysis = known.analysis.clone();
        if self.known.len() == REMEMBERED {
            self.known.remove(0);
        }
        self.known.push(known);
        analysis
    }
}

/// The impacts of marks: in order of time, no two at the same, numbered anew if edited.
fn impacts(marks: &DropMarks) -> Vec<Impact> {
    let impacts: Vec<Impact> = marks.impacts.iter().copied().map(Impact::from).collect();
    if marks.edited {
        analysis::renumbered(impacts)
    } else {
        impacts
    }
}

impl Answered<'_> {
    fn settings(&self) -> &Options {
        &self.setup.settings
    }

    fn document(&self) -> Document {
        let request = self.request;
        let document = Document::new(
            &request.name,
            request.source.clone(),
            self.settings(),
            self.setup.assumptions.clone(),
            &self.drops,
            request.warnings.clone(),
        );
        match &request.no_drop {
            Some(reason) if self.drops.is_empty() => document.without_drop(reason),
            _ => document,
        }
    }

    fn analysed(&self) -> Analysed {
        Analysed {
            document: self.document(),
            effort: self.request.effort,
            ball: self.setup.ball_label.clone(),
            figures: self.figures(),
        }
    }

    fn figures(&self) -> Vec<Vec<String>> {
        let of_air = figure::of_air(&self.drops, self.settings(), &Translator::english());
        let of_air: Vec<&str> = of_air.iter().map(|(name, _)| *name).collect();
        let of_drop = |drop| {
            let subject = Subject::new(drop, self.settings());
            let names = figure::of_drop(&subject).map(|figure| figure.name);
            names
                .chain(of_air.iter().copied())
                .map(str::to_owned)
                .collect()
        };
        self.drops.iter().map(of_drop).collect()
    }
}

/// A figure as a picture.
pub(crate) fn drawn(name: &str, chart: &Chart) -> Drawn {
    let (width_px, height_px) = chart.size();
    Drawn {
        name: name.to_owned(),
        svg: chart.svg(),
        width_px,
        height_px,
    }
}
