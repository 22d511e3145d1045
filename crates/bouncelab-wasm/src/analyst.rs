//! What do the impacts say?

use bouncelab::analysis::{self, Drop, Impact, Options};
use bouncelab::detection::Envelope;
use bouncelab::drop::{self, Start, Stop};
use bouncelab::impact::{Contact, Restitution};
use bouncelab::inference::Posterior;
use bouncelab::setup::Setup;
use bouncelab_report::Figure;
use bouncelab_report::document::{Document, rows};
use bouncelab_report::illustration;
use bouncelab_report::language::Say;
use bouncelab_report::report::{self, Provenance, Recording};
use bouncelab_report::theme::Meaning;

use crate::refusal::Result;
use crate::settings::setting;
use crate::wire::{
    Analysed, AnalysisRequest, DragCurve, Drawn, Draws, DropMarks, Energy, HeightCurve, Series,
};

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

    /// Draws one of the figures that [`Analysed::figures`] names, with its words said by `say`; `over`
    /// is laid over that of the height.
    ///
    /// # Errors
    ///
    /// Those of [`Self::analyse`], and if there is no figure of this name.
    pub fn figure(
        &mut self,
        request: &AnalysisRequest,
        name: &str,
        over: Option<&HeightCurve>,
        say: &mut Say<'_>,
    ) -> Result<Drawn> {
        let figure = self.answer(request)?.figure(name, over);
        figure
            .map(|figure| drawn(name, figure, say))
            .ok_or_else(|| setting(&format!("there is no figure \"{name}\" of this drop")))
    }

    /// Draws the sound with its impacts, its words said by `say`.
    ///
    /// # Errors
    ///
    /// Those of [`Self::analyse`].
    pub fn waveform(
        &mut self,
        request: &AnalysisRequest,
        sound: &Envelope,
        say: &mut Say<'_>,
    ) -> Result<Drawn> {
        let answered = self.answer(request)?;
        let figure = illustration::waveform(sound, &answered.drops)?;
        Ok(drawn("waveform", figure, say))
    }

    /// The report as one HTML file, in the language of this code, which `say` knows.
    ///
    /// # Errors
    ///
    /// Those of [`Self::analyse`].
    pub fn report(
        &mut self,
        request: &AnalysisRequest,
        sound: Option<&Envelope>,
        made: Option<String>,
        (language, say): (&str, &mut Say<'_>),
    ) -> Result<String> {
        let answered = self.answer(request)?;
        let mut page = report::of_recording(
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
        );
        page.translate(language, say);
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
        let drops = self.drops.iter();
        Analysed {
            document: self.document(),
            effort: self.request.effort,
            ball: self.setup.ball_label.clone(),
            series: drops.map(|drop| series(drop, self.settings())).collect(),
            drag: self.drag().unwrap_or_default(),
            figures: self.figures(),
        }
    }

    fn fastest_m_s(&self) -> Option<f64> {
        let speeds = self.drops.iter().filter_map(Drop::speed_range_m_s);
        speeds.map(|(_, fastest)| fastest).reduce(f64::max)
    }

    fn drag(&self) -> Option<Vec<DragCurve>> {
        let curves = illustration::drag_curves(self.settings(), self.fastest_m_s()?).ok()?;
        let curves = curves.into_iter().map(|curve| {
            let (speed_m_s, drag_over_weight) = curve.points.into_iter().unzip();
            DragCurve {
                law: curve.name,
                chosen: curve.meaning == Meaning::Drag,
                speed_m_s,
                drag_over_weight,
            }
        });
        Some(curves.collect())
    }

    /// The name of a figure of a drop, which has a number if there are several.
    fn named(&self, index: usize, name: &str) -> String {
        match self.drops.len() {
            1 => name.to_owned(),
            _ => format!("drop{}-{name}", index + 1),
        }
    }

    fn figures(&self) -> Vec<String> {
        let mut names = Vec::new();
        for (index, drop) in self.drops.iter().enumerate() {
            let inferred: &[&str] = match &drop.estimate {
                Ok(found) if found.models.len() > 1 => {
                    &["posterior", "residuals", "budget", "models", "cut"]
                }
                Ok(_) => &["posterior", "residuals", "budget", "cut"],
                Err(_) => &[],
            };
            let heard = [
                "flight-times",
                "restitution",
                "height",
                "bounce-heights",
                "bounce-energies",
            ];
            let all = heard.iter().chain(inferred);
            names.extend(all.map(|name| self.named(index, name)));
        }
        if self.fastest_m_s().is_some() {
            names.extend(["drag", "drag-log"].map(str::to_owned));
        }
        names
    }

    fn figure(&self, name: &str, over: Option<&HeightCurve>) -> Option<Figure> {
        let settings = self.settings();
        match name {
            "drag" => return illustration::drag(settings, self.fastest_m_s()?),
            "drag-log" => return illustration::drag_log(settings, self.fastest_m_s()?),
            _ => {}
        }
        self.drops.iter().enumerate().find_map(|(index, drop)| {
            let is = |plain: &str| self.named(index, plain) == name;
            let found = drop.estimate.as_ref().ok();
            match () {
                () if is("flight-times") => Some(illustration::flight_times(drop)),
                () if is("restitution") => Some(illustration::restitution(drop)),
                () if is("height") => {
                    let over = over.map(HeightCurve::points);
                    Some(illustration::height_with(drop, settings, over))
                }
                () if is("bounce-heights") => Some(illustration::bounce_heights(drop)),
                () if is("bounce-energies") => Some(illustration::bounce_energies(drop, settings)),
                () if is("posterior") => found.map(illustration::corner),
                () if is("residuals") => found.map(illustration::residuals),
                () if is("budget") => found.map(illustration::budget),
                () if is("models") => found.and_then(illustration::models),
                () if is("cut") => illustration::cut(drop, settings),
                () => None,
            }
        })
    }
}

/// A figure as data, its words said by `say`.
pub(crate) fn drawn(name: &str, mut figure: Figure, say: &mut Say<'_>) -> Drawn {
    figure.translate(say);
    let (width_px, height_px) = figure.size();
    Drawn {
        name: name.to_owned(),
        title: figure.title().to_owned(),
        caption: figure.caption().to_owned(),
        svg: figure.svg(),
        width_px,
        height_px,
    }
}

fn series(drop: &Drop, settings: &Options) -> Series {
    let flown = illustration::flown(drop, settings);
    let found = drop.estimate.as_ref().ok();
    Series {
        measured: HeightCurve::of(flown.points),
        apexes: HeightCurve::of(flown.apexes),
        simulated: found
            .and_then(|found| simulated(drop, found, settings).ok())
            .unwrap_or_default(),
        energies: energies(drop, settings),
        draws: found.map(draws).unwrap_or_default(),
    }
}

impl HeightCurve {
    /// Of points of time and height.
    pub(crate) fn of(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let (time_s, height_m) = points
            .into_iter()
            .map(|(time_s, height_m)| (time_s, Some(height_m).filter(|h| h.is_finite())))
            .unzip();
        Self { time_s, height_m }
    }

    /// Its points; a height that is not a number interrupts it.
    fn points(&self) -> Vec<(f64, f64)> {
        let heights = self.height_m.iter().map(|h| h.unwrap_or(f64::NAN));
        self.time_s.iter().copied().zip(heights).collect()
    }
}

fn draws(found: &Posterior) -> Draws {
    /// More points say no more on a screen.
    const SHOWN: usize = 1000;
    let all = &found.draws;
    let step = all.restitution.len().div_ceil(SHOWN).max(1);
    let thinned = |values: &[f64]| values.iter().copied().step_by(step).collect();
    Draws {
        restitution: thinned(&all.restitution),
        drag_coefficient: thinned(&all.drag_coefficient),
        drop_height_m: thinned(&all.drop_height_m),
    }
}

/// The drop that the answers describe, from its release on, in the time of the recording.
fn simulated(drop: &Drop, found: &Posterior, settings: &Options) -> bouncelab::Result<HeightCurve> {
    /// Points of the whole curve for each bounce.
    const POINTS: usize = 40;
    let law = Restitution::power(
        found.restitution.value,
        found.at_speed_m_s,
        found.slope.value,
    )?;
    let contact = Contact::new(law, settings.contact_time_s)?;
    let bounces = drop.impacts.last().map_or(1, |last| last.number);
    let start = Start::Height(found.drop_height_m.value);
    let missed = found.missed_first.as_deref().map_or(0, most_probable);
    let stop = Stop::after(bounces + missed);
    let history = drop::simulate(&settings.model()?, &contact, start, stop)?;
    // The first impact that was heard is at the time at which it was heard.
    let first_heard_s = history.bounces().get(missed).map_or(0.0, |b| b.time_s);
    let shift_s = drop.impacts.first().map_or(0.0, |first| first.time_s) - first_heard_s;
    let end_s = history.total_time_s();
    let points = POINTS * (bounces + missed);
    Ok(HeightCurve::of((0..=points).map(|point| {
        let time_s = end_s * point as f64 / points as f64;
        (time_s + shift_s, history.height_at(time_s))
    })))
}

fn most_probable(probabilities: &[f64]) -> usize {
    let numbered = probabilities.iter().enumerate();
    numbered
        .max_by(|a, b| a.1.total_cmp(b.1))
        .map_or(0, |(number, _)| number)
}

fn energies(drop: &Drop, settings: &Options) -> Vec<Energy> {
    let energies = illustration::energies(drop, settings).into_iter();
    energies
        .map(|energy| Energy {
            number: energy.number,
            before_j: energy.before_j,
            lost_to_surface_j: energy.lost_to_surface_j,
            lost_to_air_j: energy.lost_to_air_j,
        })
        .collect()
}
