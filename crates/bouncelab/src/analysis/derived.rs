//! Further results that are computed on request: height histories, drag curves, and the height from fewer flights.

use super::result::Drop;
use super::{Options, analyze_impacts};
use crate::Result;
use crate::drag::DragLaw;
use crate::drop::{self, History, Start, Stop};
use crate::estimate::Estimate;
use crate::flight::{Environment, FlightModel};
use crate::inference::{BestFit, InferenceOptions, SamplerConfig};
use crate::restitution::Contact;

/// The height of the ball by the flight model, from impact to impact.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct HeightHistory {
    /// Time in s and height in m; a height that is not a number separates flights between which an
    /// impact was missed.
    pub points: Vec<[f64; 2]>,
    /// Time in s and height in m of each apex.
    pub apexes: Vec<[f64; 2]>,
}

/// A drop as the posterior describes it.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SimulatedHistory {
    /// Time in s and height in m of the most probable drop.
    pub points: Vec<[f64; 2]>,
    /// Time in s, and the heights in m between which 95 % of the draws are at that time.
    pub band: Vec<[f64; 3]>,
}

/// The drag of a law over the weight of the ball.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DragCurve {
    /// The law.
    pub law: DragLaw,
    /// Whether it is that of the options; else a constant coefficient to compare with.
    pub is_chosen: bool,
    /// Speed in m/s and drag over weight there.
    pub points: Vec<[f64; 2]>,
}

/// The drop height from the first flights only.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Truncation {
    /// How many flights.
    pub flights: usize,
    /// By the log-linear fit, in m.
    pub log_linear_fit_m: Option<Estimate>,
    /// By the inference, in m.
    pub posterior_m: Option<Estimate>,
}

impl Drop {
    /// The height of each flight by the flight model; empty if it cannot be computed.
    pub fn height_history(&self, options: &Options) -> HeightHistory {
        /// Points along each flight.
        const POINTS: usize = 24;
        let options = &options.with_ball_of(self.posterior.as_ref().ok());
        let mut history = HeightHistory::default();
        let (Ok(found), Ok(model)) = (&self.per_impact, options.model()) else {
            return history;
        };
        let mut last = None;
        for timed in &found.flights {
            let mut impacts = self.impacts.iter();
            let Some(impact) = impacts.find(|impact| impact.number == timed.number) else {
                continue;
            };
            let start_s = impact.time_s + options.contact_time_s;
            if last.is_some_and(|last| last + 1 != timed.number) {
                history.points.push([start_s, f64::NAN]);
            }
            last = Some(timed.number);
            history.points.extend((0..=POINTS).map(|point| {
                let after_s = timed.flight.time_s() * point as f64 / POINTS as f64;
                let height_m = model.state(&timed.flight, after_s).height_m;
                [start_s + after_s, height_m]
            }));
            let apex_s = start_s + timed.flight.rise_time_s;
            history.apexes.push([apex_s, timed.flight.apex_m]);
        }
        history
    }

    /// The drop that the posterior describes, from its release on, in the time of the recording, simulated with the drag
    /// of the options. Empty without inference.
    ///
    /// # Errors
    ///
    /// Those of [`drop::simulate`](drop::simulate()).
    pub fn simulated_history(&self, options: &Options) -> Result<SimulatedHistory> {
        /// Points of the whole curve for each bounce.
        const POINTS: usize = 40;
        /// Points of the band for each bounce: it costs `DRAWS` simulations.
        const BAND_POINTS: usize = 12;
        /// The second lowest and the second highest of forty are quantiles of 2.5 and 97.5 %.
        const DRAWS: usize = 40;
        let Ok(found) = &self.posterior else {
            return Ok(SimulatedHistory::default());
        };
        let mut impacts = self.impacts.iter();
        let first = impacts.find(|impact| impact.number == found.first_impact());
        let (Some(best), Some(first)) = (found.best_fit(), first) else {
            return Ok(SimulatedHistory::default());
        };
        let last = impacts.next_back().unwrap_or(first);
        let missed = found
            .missed_first_impacts
            .as_deref()
            .map_or(0, most_probable);
        let bounces = last.number + 1 - first.number + missed;
        let model = options.with_ball_of(Some(found)).model()?;
        let simulated = |fit: &BestFit| -> Result<(History, f64)> {
            let contact = Contact::new(fit.law, fit.contact_time_s)?;
            let start = Start::Height(fit.drop_height_m);
            let history = drop::simulate(&model, &contact, start, Stop::after(bounces))?;
            // The first impact that was detected is at the time at which it was detected.
            let first_s = history.bounces().get(missed).map_or(0.0, |b| b.time_s);
            Ok((history, first.time_s - first_s))
        };
        let (best, shift_s) = simulated(&best)?;
        let times = |points: usize| {
            let step_s = best.total_time_s() / points as f64;
            (0..=points).map(move |point| step_s * point as f64)
        };
        let points =
            times(POINTS * bounces).map(|time_s| [time_s + shift_s, best.height_at(time_s)]);
        let drawn: Vec<(History, f64)> = found
            .some_draws(DRAWS)
            .iter()
            .filter_map(|fit| simulated(fit).ok())
            .collect();
        let band = times(BAND_POINTS * bounces).filter_map(|time_s| {
            let time_s = time_s + shift_s;
            let heights = drawn
                .iter()
                .map(|(history, shift_s)| history.height_at(time_s - shift_s));
            let mut heights: Vec<f64> = heights.collect();
            heights.sort_unstable_by(f64::total_cmp);
            let end = heights.len() / DRAWS;
            let high = heights.len().checked_sub(1 + end)?;
            Some([time_s, heights[end], heights[high]])
        });
        Ok(SimulatedHistory {
            band: band.collect(),
            points: points.collect(),
        })
    }

    /// The numbers of first flights of [`Self::truncations`]: some, and all; fewer than three choices
    /// for a short drop.
    pub fn truncation_points(&self) -> Vec<usize> {
        const TRUNCATIONS: [usize; 4] = [6, 10, 20, 40];
        let all = self.impacts.len().saturating_sub(1);
        let shorter = TRUNCATIONS.into_iter().filter(|&flights| flights < all);
        shorter.chain([all]).collect()
    }

    /// The drop height from the first flights only, whatever height was stated: the inference runs anew
    /// for each number of flights.
    pub fn truncations(&self, options: &Options) -> Vec<Truncation> {
        let truncation = |flights: usize| {
            let options = options_of_truncation(options, self.impacts[flights].number);
            let found = analyze_impacts(self.impacts[..=flights].to_vec(), &options);
            Truncation {
                flights,
                log_linear_fit_m: found.log_linear_fit.ok().map(|fit| fit.drop_height_m),
                posterior_m: found.posterior.ok().map(|found| found.drop_height_m),
            }
        };
        self.truncation_points()
            .into_iter()
            .map(truncation)
            .collect()
    }
}

impl Options {
    /// Drag over weight of the chosen law, and of a constant coefficient that agrees with it at the
    /// fastest impact; empty without drag.
    ///
    /// # Errors
    ///
    /// If the law is not valid up to the fastest impact, and the errors of [`FlightModel::new`].
    pub fn drag_curves(&self, fastest_m_s: f64) -> Result<Vec<DragCurve>> {
        let model = self.model()?;
        let share = model.drag_over_weight(fastest_m_s)?;
        let with_constant = |coefficient| {
            let drag = DragLaw::Constant(coefficient);
            let environment = Environment {
                drag,
                ..self.environment
            };
            FlightModel::new(&self.ball, &environment)
        };
        let unit_share = with_constant(1.0)?.drag_over_weight(fastest_m_s)?;
        if unit_share <= 0.0 {
            return Ok(Vec::new());
        }
        let curve = |model: &FlightModel, law, is_chosen| DragCurve {
            law,
            is_chosen,
            points: drag_points(model, fastest_m_s),
        };
        let law = &self.environment.drag;
        let mut curves = vec![curve(&model, law.clone(), true)];
        if !matches!(law, DragLaw::Constant(_) | DragLaw::None) {
            let coefficient = (100.0 * share / unit_share).round() / 100.0;
            let model = with_constant(coefficient)?;
            curves.push(curve(&model, DragLaw::Constant(coefficient), false));
        }
        Ok(curves)
    }
}

fn most_probable(probabilities: &[f64]) -> usize {
    let numbered = probabilities.iter().enumerate();
    numbered
        .max_by(|a, b| a.1.total_cmp(b.1))
        .map_or(0, |(number, _)| number)
}

fn options_of_truncation(options: &Options, last_flight: usize) -> Options {
    /// A comparison needs fewer draws than a result.
    const SAMPLER: SamplerConfig = SamplerConfig {
        draws: 600,
        seed: 1,
    };
    let mut options = Options {
        flights: Some(1..=last_flight),
        inference: Some(InferenceOptions {
            sampler: SAMPLER,
            each_impact: false,
            ..InferenceOptions::default()
        }),
        ..options.clone()
    };
    // The height that was stated is left out: it would decide the result.
    options.priors.drop_height_m = None;
    options.priors.release_s = None;
    options
}

fn drag_points(model: &FlightModel, fastest_m_s: f64) -> Vec<[f64; 2]> {
    // From a fiftieth of the fastest impact to half above it, in equal ratios.
    let (from, to) = (0.02 * fastest_m_s, 1.5 * fastest_m_s);
    (0..=200)
        .map(|step| from * (to / from).powf(f64::from(step) / 200.0))
        // Beyond the range of the law the curve ends.
        .map_while(|speed| Some([speed, model.drag_over_weight(speed).ok()?]))
        .collect()
}
