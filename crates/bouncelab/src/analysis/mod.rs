//! The pipeline: from samples, or impact times, to the result.
//!
//! [`analyze`] and [`analyze_times`] do all of it. A stream goes through a
//! [`Detector`](crate::Detector) first and then, as a [`Plan`], to its result; the caller may
//! analyse its drops in threads. Ball, air, surface and questions are the [`Options`].
//!
//! ```
//! use bouncelab::{Options, ball};
//! use bouncelab::analysis::{analyze_impacts, impacts_of_times};
//!
//! let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045];
//! let options = Options::new(ball::preset("table-tennis-40")?);
//! let drop = analyze_impacts(impacts_of_times(&times_s), &options);
//! let fit = drop.log_linear_fit.clone()?;
//! assert!((fit.restitution.value - 0.932).abs() < 0.001);
//! // Without the bias of drag the ball is livelier.
//! assert!(drop.per_impact_restitution().unwrap().value > fit.restitution.value);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod balls;
mod contact;
mod derived;
mod gap;
mod listed;
mod pipeline;
mod result;

use std::ops::RangeInclusive;

use crate::air::{Air, Conditions};
use crate::ball::{self, Ball, KnownBall};
use crate::diagnostic::{Code, Diagnostic};
use crate::drag::DragLaw;
use crate::error::InferenceFailure;
use crate::flight::{Environment, FlightModel};
use crate::gravity;
use crate::impact::Impact;
use crate::inference::{self, InferenceOptions, Posterior, Priors, SamplerConfig};
use crate::regression::{self, NumberedFlight};
use crate::restitution::{self, PerImpact};
use crate::stats::sort_by_number;
use crate::train::{self, TrainImpact};
use crate::{Error, Result};

pub use crate::detection::DetectionOptions;
pub use balls::BallComparison;
pub use derived::{DragCurve, HeightHistory, SimulatedHistory, Truncation};
pub use gap::{Gap, rests_at_s};
pub use listed::ListOrigin;
pub use pipeline::{DropCandidate, DropTask, Plan, analyze, analyze_channels, analyze_times};
pub use result::{BounceEnergy, Drop, MeasuredFlight, Recording, Source, StrongestBand};

/// Ball, air and gravity, given or assumed; priors; and what to compute.
///
/// ```
/// use bouncelab::inference::SamplerConfig;
/// use bouncelab::{Options, ball};
///
/// let options = Options::new(ball::preset("tennis")?)
///     .with_gravity_m_s2(9.78)
///     .with_sampler(SamplerConfig { draws: 1000, seed: 7 });
/// assert!((options.ball.mass_kg() - 0.0577).abs() < 1e-3);
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Options {
    /// The ball.
    pub ball: Ball,
    /// Air, drag, gravity, buoyancy.
    pub environment: Environment,
    /// How long the ball touches the surface, in seconds.
    pub contact_time_s: f64,
    /// The flights that go into the log-linear fit, by number; if `None`, all between impacts that
    /// are certain ([`CONFIDENT_PROBABILITY`]).
    pub flights: Option<RangeInclusive<usize>>,
    /// Measurements and priors besides the impact times.
    pub priors: Priors,
    /// The questions to the inference; `None` leaves it out.
    pub inference: Option<InferenceOptions>,
    /// Where in a recording to look for impacts.
    pub detection: DetectionOptions,
    /// Impacts excluded and included by hand.
    pub edits: Edits,
    /// Whether to compare the preset balls, which takes as long as an inference of each.
    pub compares_balls: bool,
}

/// Candidates accepted, impacts excluded and included by hand, and gaps.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Edits {
    /// Candidates that are drops, by their place in [`Recording::candidates`], the first being 1.
    pub accept: Vec<usize>,
    /// Times of impacts to exclude, in seconds: of each, the nearest impact within 20 ms.
    pub exclude_s: Vec<f64>,
    /// Times of impacts to add, in seconds.
    pub include_s: Vec<f64>,
    /// Where sound was lost: no flight across a gap is used.
    pub gaps: Vec<Gap>,
}

impl Default for Options {
    /// A 40 mm table-tennis ball in air of 20 °C with the standard drag curve and gravity, and
    /// with buoyancy and added mass.
    fn default() -> Self {
        Self::new(ball::usual())
    }
}

impl Options {
    /// A ball in ordinary air, with the full inference; see [`Self::with_ball`].
    pub fn new(ball: impl Into<KnownBall>) -> Self {
        let known = ball.into();
        let air = Air::moist(&Conditions::default());
        Self {
            ball: known.ball,
            environment: Environment {
                gravity_m_s2: gravity::STANDARD_M_S2,
                air: air.unwrap_or(Air::vacuum()),
                drag: DragLaw::Standard,
                buoyancy: true,
                added_mass: true,
            },
            contact_time_s: known.contact_time_s,
            flights: None,
            priors: Priors::default().with_ball(&known),
            inference: Some(InferenceOptions::default()),
            detection: DetectionOptions::default(),
            edits: Edits::default(),
            compares_balls: false,
        }
    }

    /// The same with another ball: a preset, or one of which only mass and diameter are known. Its contact time, and how
    /// well it and its drag are known, come with it.
    ///
    /// ```
    /// use bouncelab::ball::{self, Ball};
    /// use bouncelab::Options;
    ///
    /// let tennis = Options::default().with_ball(ball::preset("tennis")?);
    /// assert_eq!(tennis.ball.mass_kg(), 57.7e-3);
    /// let own = Options::default().with_ball(Ball::new(0.6, 0.243)?);
    /// assert!(own.contact_time_s > 5e-3);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    #[must_use]
    pub fn with_ball(mut self, ball: impl Into<KnownBall>) -> Self {
        let known = ball.into();
        self.ball = known.ball;
        self.contact_time_s = known.contact_time_s;
        self.priors = self.priors.with_ball(&known);
        self
    }

    /// The same in other air.
    #[must_use]
    pub fn with_air(mut self, air: Air) -> Self {
        self.environment.air = air;
        self
    }

    /// The same with another gravity, m/s².
    #[must_use]
    pub fn with_gravity_m_s2(mut self, gravity_m_s2: f64) -> Self {
        self.environment.gravity_m_s2 = gravity_m_s2;
        self
    }

    /// The same with another drag law.
    ///
    /// ```
    /// use bouncelab::drag::DragLaw;
    /// use bouncelab::{Options, analyze_times};
    ///
    /// let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045];
    /// let restitution = |options| analyze_times(&times_s, &options).drops[0].per_impact_restitution();
    /// let options = Options::default().without_inference();
    /// let (with, without) = (restitution(options.clone()), restitution(options.with_drag(DragLaw::None)));
    /// assert!(with.unwrap().value > without.unwrap().value);
    /// ```
    #[must_use]
    pub fn with_drag(mut self, drag: DragLaw) -> Self {
        self.environment.drag = drag;
        self
    }

    /// The same with another number of draws or seed.
    #[must_use]
    pub fn with_sampler(mut self, sampler: SamplerConfig) -> Self {
        let inference = self.inference.unwrap_or_default();
        self.inference = Some(InferenceOptions {
            sampler,
            ..inference
        });
        self
    }

    /// The same without the inference: log-linear fit and restitution of each impact alone.
    ///
    /// ```
    /// use bouncelab::{Options, analyze_times};
    ///
    /// let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045];
    /// let drop = &analyze_times(&times_s, &Options::default().without_inference()).drops[0];
    /// assert!(drop.log_linear_fit.is_ok() && drop.posterior.is_err());
    /// ```
    #[must_use]
    pub fn without_inference(mut self) -> Self {
        self.inference = None;
        self
    }

    /// The same for the drop that begins at `start_s`. A release belongs to the drop that begins next after it, if no
    /// sound was lost in between.
    #[must_use]
    pub fn for_drop(&self, start_s: f64, other_starts_s: &[f64]) -> Self {
        let is_its_own = |released_s: f64| {
            let is_between = |&start: &f64| released_s < start && start < start_s;
            let is_apart = |gap: &Gap| gap.lies_between(released_s, start_s);
            released_s < start_s
                && !other_starts_s.iter().any(is_between)
                && !self.edits.gaps.iter().any(is_apart)
        };
        let mut options = self.clone();
        let release = options.priors.release_s;
        options.priors.release_s = release.filter(|it| is_its_own(it.value));
        options
    }

    /// A diagnostic if a release was stated and no drop begins after it.
    pub fn release_without_drop(&self, starts_s: &[f64]) -> Option<Diagnostic> {
        let released_s = self.priors.release_s?.value;
        let begins = starts_s.iter().any(|&start_s| released_s < start_s);
        let diagnostic = Diagnostic::new(Code::ReleaseWithoutDrop).with("time_s", released_s);
        (!begins && !starts_s.is_empty()).then_some(diagnostic)
    }

    /// The same with the most probable ball of a posterior, if the ball was not stated.
    #[must_use]
    pub(crate) fn with_ball_of(&self, posterior: Option<&Posterior>) -> Self {
        let mut options = self.clone();
        if let Some(posterior) = posterior.filter(|_| !self.priors.possible_balls.is_empty()) {
            (options.ball, options.contact_time_s) = posterior.most_probable_ball();
        }
        options
    }

    /// Whether to ask if another ball explains the times better: it was stated, and the result is not only one of many.
    fn doubts_ball(&self) -> bool {
        let asked = self.inference.as_ref().is_some_and(|it| it.each_impact);
        asked && self.priors.possible_balls.is_empty()
    }

    /// The contact time of the ball, or the shortest of the kinds that it may be, s.
    fn shortest_contact_s(&self) -> f64 {
        let possible = self.priors.possible_balls.iter();
        let shortest = possible.map(|it| it.known.contact_time_s);
        shortest.reduce(f64::min).unwrap_or(self.contact_time_s)
    }

    /// The flight model of these options.
    ///
    /// # Errors
    ///
    /// Those of [`FlightModel::new`].
    ///
    /// ```
    /// let terminal = bouncelab::Options::default().model()?.terminal_speed_m_s();
    /// assert!((8.0..10.0).contains(&terminal.unwrap()));
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn model(&self) -> Result<FlightModel> {
        FlightModel::new(&self.ball, &self.environment)
    }
}

/// An impact below this probability is marked as uncertain, and no flight from or to it goes into
/// the log-linear fit unless it is requested.
pub const CONFIDENT_PROBABILITY: f64 = 0.9;

impl From<&TrainImpact> for Impact {
    fn from(detected: &TrainImpact) -> Self {
        Self {
            number: detected.number as usize + 1,
            time_s: detected.onset.time_s,
            time_sd_s: Some(detected.onset.sigma_s),
            probability: detected.probability,
            level_db: Some(detected.onset.level_db),
            quiet_before_s: None,
            ln_alike: None,
        }
    }
}

/// Impacts of a list of times, in increasing order; where the intervals indicate a missed impact, the numbers have a gap.
///
/// ```
/// use bouncelab::analysis::impacts_of_times;
///
/// // The sixth impact was missed.
/// let impacts = impacts_of_times(&[0.0, 0.5, 0.95, 1.355, 1.7195, 2.3428, 2.6085, 2.8477]);
/// assert_eq!((impacts[4].number, impacts[5].number), (5, 7));
/// ```
pub fn impacts_of_times(times_s: &[f64]) -> Vec<Impact> {
    std::iter::zip(times_s, train::number_impacts(times_s))
        .map(|(&time_s, number)| Impact::new(number as usize + 1, time_s))
        .collect()
}

/// The same impacts with some excluded and others included, and numbered anew.
///
/// A time to exclude means the nearest impact within 20 ms; times without one are returned in the second list.
fn edit(impacts: &[Impact], exclude_s: &[f64], include_s: &[f64]) -> (Vec<Impact>, Vec<f64>) {
    const NEAR_S: f64 = 0.02;
    let mut edited = impacts.to_vec();
    let mut unmatched = Vec::new();
    for &time_s in exclude_s {
        let distance = |impact: &Impact| (impact.time_s - time_s).abs();
        let nearest = (0..edited.len())
            .filter(|&index| distance(&edited[index]) <= NEAR_S)
            .min_by(|&a, &b| distance(&edited[a]).total_cmp(&distance(&edited[b])));
        match nearest {
            Some(index) => drop(edited.remove(index)),
            None => unmatched.push(time_s),
        }
    }
    edited.extend(impacts_of_times(include_s));
    (renumbered(edited), unmatched)
}

/// Impacts in any order: in order of time, no two at the same, numbered as [`impacts_of_times`] does.
///
/// ```
/// use bouncelab::Impact;
/// use bouncelab::analysis::renumbered;
///
/// // The third impact was not detected: the flight before the last counts twice.
/// let times_s = [1.0, 0.5, 0.0, 1.75];
/// let impacts = renumbered(times_s.map(|time_s| Impact::new(1, time_s)).to_vec());
/// assert_eq!(impacts.iter().map(|it| it.number).collect::<Vec<_>>(), [1, 2, 3, 5]);
/// assert_eq!(impacts[1].time_s, 0.5);
/// ```
pub fn renumbered(mut impacts: Vec<Impact>) -> Vec<Impact> {
    sort_by_number(&mut impacts, |impact| impact.time_s);
    impacts.dedup_by(|a, b| a.time_s <= b.time_s);
    let times_s: Vec<f64> = impacts.iter().map(|impact| impact.time_s).collect();
    for (impact, number) in impacts.iter_mut().zip(train::number_impacts(&times_s)) {
        impact.number = number as usize + 1;
    }
    impacts
}

/// Analyses the impacts of one drop, in order of time.
///
/// A result that cannot be computed is an error in its own field, and the others remain.
///
/// ```
/// use bouncelab::Options;
/// use bouncelab::analysis::{analyze_impacts, impacts_of_times};
///
/// let options = Options::default().without_inference();
/// let drop = analyze_impacts(impacts_of_times(&[0.0, 0.46, 0.8875, 1.2848]), &options);
/// assert_eq!(drop.flights.len(), 3);
/// assert!((drop.log_linear_fit.unwrap().restitution.value - 0.929).abs() < 0.001);
/// ```
pub fn analyze_impacts(impacts: Vec<Impact>, options: &Options) -> Drop {
    let (flying, too_close) = contact::flying(&impacts, options.shortest_contact_s());
    let posterior = posterior(flying, options);
    let doubts_ball = posterior.is_ok() && options.doubts_ball();
    let other_ball = doubts_ball.then(|| balls::better(flying, options));
    let options = &options.with_ball_of(posterior.as_ref().ok());
    let per_impact = per_impact(flying, options);
    let first = posterior.as_ref().map_or(0, Posterior::first_impact);
    let flights = flights(&impacts, options, per_impact.as_ref().ok(), first);
    let in_fit: Vec<NumberedFlight> = flights
        .iter()
        .filter(|flight| flight.in_fit)
        .map(|flight| NumberedFlight {
            number: flight.number,
            time_s: flight.flight_time_s,
        })
        .collect();
    let log_linear_fit = regression::fit(&in_fit, options.environment.gravity_m_s2);
    let mut diagnostics = diagnostics(&impacts, &flights, per_impact.as_ref().ok());
    diagnostics.extend(too_close);
    diagnostics.extend(other_ball.flatten());
    match &posterior {
        Ok(posterior) => diagnostics.extend(posterior.diagnostics.iter().cloned()),
        Err(Error::CannotInfer(InferenceFailure::NotRequested)) => {}
        Err(reason) => diagnostics.push(reason.diagnostic()),
    }
    let mut drop = Drop {
        probability: 1.0,
        impacts,
        flights,
        log_linear_fit,
        per_impact,
        posterior,
        balls: Vec::new(),
        diagnostics,
    };
    if options.compares_balls {
        drop.balls = balls::compare(&drop, options);
    }
    drop
}

/// The flights. Those before the first impact of the drop, by its number, are not in the log-linear fit.
fn flights(
    impacts: &[Impact],
    options: &Options,
    per_impact: Option<&PerImpact>,
    first: usize,
) -> Vec<MeasuredFlight> {
    let certain = |pair: &[Impact]| {
        let mut impacts = pair.iter();
        impacts.all(|impact| impact.probability >= CONFIDENT_PROBABILITY)
    };
    let successive = impacts
        .windows(2)
        .filter(|pair| pair[1].number == pair[0].number + 1);
    let enough = successive.clone().filter(|pair| certain(pair)).count() >= 2;
    let modelled = |number: usize| {
        let mut flights = per_impact?.flights.iter();
        flights.find(|flight| flight.number == number)
    };
    successive
        .map(|pair| {
            let number = pair[0].number;
            let flight_time_s = pair[1].time_s - pair[0].time_s;
            let gravity_m_s2 = options.environment.gravity_m_s2;
            let in_fit = match &options.flights {
                Some(range) => range.contains(&number),
                None => number >= first && (!enough || certain(pair)),
            };
            let modelled = modelled(number);
            MeasuredFlight {
                number,
                flight_time_s,
                in_fit,
                drag_free_height_m: regression::height_of_flight_m(flight_time_s, gravity_m_s2),
                apex_m: modelled.map(|modelled| modelled.flight.apex_m),
                apex_sd_m: modelled.and_then(|modelled| modelled.apex_sd_m),
                launch_speed_m_s: modelled.map(|modelled| modelled.flight.launch_speed_m_s),
            }
        })
        .collect()
}

fn per_impact(impacts: &[Impact], options: &Options) -> Result<PerImpact> {
    restitution::of_impacts(impacts, options.contact_time_s, &options.model()?)
}

/// The inference from all impacts that are more likely than not; the others count as missed.
fn posterior(impacts: &[Impact], options: &Options) -> Result<Posterior> {
    let Some(inference) = &options.inference else {
        return Err(Error::CannotInfer(InferenceFailure::NotRequested));
    };
    let likely: Vec<Impact> = impacts
        .iter()
        .filter(|impact| impact.probability >= 0.5)
        .copied()
        .collect();
    contact::check(&likely, options.shortest_contact_s())?;
    inference::infer(
        &likely,
        &options.ball,
        &options.environment,
        options.contact_time_s,
        &options.priors,
        inference,
    )
}

fn diagnostics(
    impacts: &[Impact],
    flights: &[MeasuredFlight],
    per_impact: Option<&PerImpact>,
) -> Vec<Diagnostic> {
    /// Minimum ratio of a flight time to the one before that errors of the times do not explain.
    const GROWS: f64 = 1.02;
    let mut diagnostics = Vec::new();
    let span = impacts
        .last()
        .map_or(0, |last| last.number + 1 - impacts[0].number);
    if span > impacts.len() {
        let missed = Diagnostic::new(Code::ImpactsMissed);
        diagnostics.push(missed.with("count", span - impacts.len()));
    }
    let gains: Vec<usize> = per_impact
        .into_iter()
        .flat_map(|per_impact| &per_impact.impacts)
        .filter(|impact| {
            // Timing noise alone may lift a late, short flight above 1.
            let error = impact.restitution.known_sd().unwrap_or(0.0);
            impact.restitution.value > 1.0 + 3.0 * error
        })
        .map(|impact| impact.number)
        .collect();
    if gains.is_empty() {
        let grows = flights
            .windows(2)
            .find(|pair| pair[1].flight_time_s > GROWS * pair[0].flight_time_s);
        if let (Some(pair), None) = (grows, per_impact) {
            let grows = Diagnostic::new(Code::FlightGrows);
            diagnostics.push(grows.with("flight", pair[1].number));
        }
    } else {
        let gaining = Diagnostic::new(Code::ImpactGainsEnergy).with("count", gains.len());
        diagnostics.push(gaining.with("impacts", gains.as_slice()));
    }
    diagnostics.extend(per_impact.and_then(balls::rising));
    let doubtful = impacts
        .iter()
        .filter(|impact| impact.probability < 0.5)
        .count();
    if doubtful > 0 {
        let diagnostic = Diagnostic::new(Code::ImpactsDoubtful);
        diagnostics.push(diagnostic.with("count", doubtful));
    }
    diagnostics
}
