//! One drop: what its impact times say.
//!
//! This is where the inverse rooms meet. From the times of the impacts it makes the flights, the
//! paper's straight line ([`crate::regression`]) and, for the chosen ball, air and drag law, the
//! restitution of each impact without the bias of drag ([`crate::restitution`]), and it says what
//! is odd about them.
//!
//! ```
//! use bouncelab::analysis::{self, Impact, Options};
//!
//! let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045];
//! let impacts: Vec<Impact> = analysis::impacts_of_times(&times_s);
//! let drop = analysis::analyze(impacts, &Options::default());
//! let line = drop.line.as_ref().unwrap();
//! assert!((line.restitution().value - 0.932).abs() < 0.001);
//! // Without the bias of drag the ball is livelier.
//! assert!(drop.corrected_restitution().unwrap().value > line.restitution().value);
//! ```

use std::fmt;
use std::ops::RangeInclusive;

use crate::air::{Air, Conditions};
use crate::ball::{self, Ball};
use crate::drag::DragLaw;
use crate::flight::{Environment, FlightModel};
use crate::gravity;
use crate::inference::{self, InferenceOptions, Posterior, Priors};
use crate::regression::{self, Estimate, NumberedFlight, Regression};
use crate::restitution::{self, Corrected, ImpactRestitution, TimedFlight, TimedImpact};
use crate::stats::{median, robust_sd};
use crate::text::list;
use crate::train::{self, HeardImpact};
use crate::{Error, Result};

/// What is known, or assumed, of the ball and what it flies through.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The ball.
    pub ball: Ball,
    /// Air, drag, gravity, buoyancy.
    pub environment: Environment,
    /// How long the ball touches the surface, in seconds.
    pub contact_time_s: f64,
    /// The flights that go into the straight line, by number; if `None`, all between impacts that
    /// are sure ([`CONFIDENT_PROBABILITY`]).
    pub flights: Option<RangeInclusive<usize>>,
    /// What is known besides the sounds.
    pub priors: Priors,
    /// What to ask of the inference; `None` leaves it out.
    pub inference: Option<InferenceOptions>,
}

impl Default for Options {
    /// A 40 mm table-tennis ball in air of 20 °C with the standard drag curve and gravity, and
    /// with buoyancy and added mass.
    fn default() -> Self {
        let preset = ball::usual();
        let air = Air::moist(&Conditions::default());
        Self {
            ball: preset.ball,
            environment: Environment {
                gravity_m_s2: gravity::STANDARD_M_S2,
                air: air.unwrap_or(Air::vacuum()),
                drag: DragLaw::CliftGraceWeber,
                buoyancy: true,
                added_mass: true,
            },
            contact_time_s: preset.contact_time_s,
            flights: None,
            priors: Priors::of_preset(preset),
            inference: Some(InferenceOptions::default()),
        }
    }
}

/// An impact below this probability is marked as uncertain, and no flight from or to it goes into
/// the straight line unless it is asked for.
pub const CONFIDENT_PROBABILITY: f64 = 0.9;

/// Why a list of times can hold no drop.
pub const TOO_FEW_TIMES: &str = "a flight needs two impact times, and there are fewer";

/// The time of an impact and how it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// Number, 1 for the first impact known; a missed impact leaves a gap.
    pub number: usize,
    /// Time in seconds.
    pub time_s: f64,
    /// Standard error of the time in seconds, where it is known.
    pub sigma_s: Option<f64>,
    /// Probability that this is an impact of the drop.
    pub probability: f64,
    /// Level in dB relative to full scale, if it was heard.
    pub level_db: Option<f64>,
}

impl From<&HeardImpact> for Impact {
    fn from(heard: &HeardImpact) -> Self {
        Self {
            number: heard.number as usize + 1,
            time_s: heard.onset.time_s,
            sigma_s: Some(heard.onset.sigma_s),
            probability: heard.probability,
            level_db: Some(heard.onset.level_db),
        }
    }
}

impl From<&Impact> for TimedImpact {
    fn from(impact: &Impact) -> Self {
        Self {
            number: impact.number,
            time_s: impact.time_s,
            standard_error_s: impact.sigma_s,
        }
    }
}

/// Impacts known by their times alone, in increasing order; where the intervals say that one was
/// missed, the numbers have a gap.
pub fn impacts_of_times(times_s: &[f64]) -> Vec<Impact> {
    std::iter::zip(times_s, train::number_impacts(times_s))
        .map(|(&time_s, number)| Impact {
            number: number as usize + 1,
            time_s,
            sigma_s: None,
            probability: 1.0,
            level_db: None,
        })
        .collect()
}

/// The same impacts with others left out and added by hand, and numbered anew.
///
/// A time to leave out means the nearest impact within 20 ms; one that means none is returned in
/// the second list.
pub fn edit(impacts: &[Impact], exclude_s: &[f64], include_s: &[f64]) -> (Vec<Impact>, Vec<f64>) {
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
pub fn renumbered(mut impacts: Vec<Impact>) -> Vec<Impact> {
    impacts.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
    impacts.dedup_by(|a, b| a.time_s <= b.time_s);
    let times_s: Vec<f64> = impacts.iter().map(|impact| impact.time_s).collect();
    for (impact, number) in impacts.iter_mut().zip(train::number_impacts(&times_s)) {
        impact.number = number as usize + 1;
    }
    impacts
}

/// The time between two impacts, one after the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlightFound {
    /// Number of the impact with which it begins.
    pub number: usize,
    /// Time between the two impacts in seconds, contact included.
    pub time_s: f64,
    /// Whether it goes into the straight line.
    pub in_line: bool,
    /// Apex height in metres by g T²/8, without drag (paper Eq. 5).
    pub plain_height_m: f64,
}

/// What the impact times of one drop say.
#[derive(Clone, Debug)]
pub struct Drop {
    /// The impacts, in order of time.
    pub impacts: Vec<Impact>,
    /// The flights between successive impacts.
    pub flights: Vec<FlightFound>,
    /// The paper's straight line through the logarithms of the flight times, or why there is none.
    pub line: Result<Regression>,
    /// Restitution of each impact, corrected for drag, or why there is none.
    pub corrected: Result<Corrected>,
    /// The full inference, or why there is none.
    pub estimate: Result<Posterior>,
    /// What is odd.
    pub warnings: Vec<Warning>,
}

/// Something odd about a drop.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// So many impacts between the first and the last were not heard.
    Missed(usize),
    /// These impacts (by number) seem to give energy: a double trigger, a moved surface or a
    /// sound that is no impact.
    Gains(Vec<usize>),
    /// So many impacts have a probability below one half.
    Doubtful(usize),
    /// A flight lasts longer than the one before.
    Grows(usize),
    /// The flights last longer than 30 s: the times are probably in milliseconds.
    Milliseconds,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missed(1) => write!(f, "one impact in between was not heard; it is counted"),
            Self::Missed(count) => {
                write!(
                    f,
                    "{count} impacts in between were not heard; they are counted"
                )
            }
            Self::Gains(numbers) => write!(
                f,
                "impact{} {} would give energy (restitution above 1): a double trigger, a moving \
                 surface, or a sound that is no impact; leave it out by hand (--exclude TIME)",
                if numbers.len() == 1 { "" } else { "s" },
                list(numbers)
            ),
            Self::Doubtful(count) => write!(
                f,
                "{count} impact{} more likely something else (probability below 1/2)",
                if *count == 1 { " is" } else { "s are" }
            ),
            Self::Grows(number) => write!(
                f,
                "flight {number} is longer than the one before it, which no surface at rest does"
            ),
            Self::Milliseconds => write!(
                f,
                "flights of more than 30 s: times are read in seconds; are these milliseconds?"
            ),
        }
    }
}

/// Analyses the impacts of one drop, in order of time.
///
/// What cannot be told is an error in its own place, so that the rest remains: two impacts have a
/// flight and a height, but no straight line.
pub fn analyze(impacts: Vec<Impact>, settings: &Options) -> Drop {
    let gravity_m_s2 = settings.environment.gravity_m_s2;
    let flights = flights(&impacts, settings);
    let in_line: Vec<NumberedFlight> = flights
        .iter()
        .filter(|flight| flight.in_line)
        .map(|flight| NumberedFlight {
            number: flight.number,
            time_s: flight.time_s,
        })
        .collect();
    let line = regression::fit(&in_line, gravity_m_s2);
    let corrected = corrected(&impacts, settings);
    let estimate = estimate(&impacts, settings);
    let warnings = warnings(&impacts, &flights, corrected.as_ref().ok());
    Drop {
        impacts,
        flights,
        line,
        corrected,
        estimate,
        warnings,
    }
}

fn flights(impacts: &[Impact], settings: &Options) -> Vec<FlightFound> {
    let sure = |pair: &[Impact]| {
        pair.iter()
            .all(|impact| impact.probability >= CONFIDENT_PROBABILITY)
    };
    let successive = impacts
        .windows(2)
        .filter(|pair| pair[1].number == pair[0].number + 1);
    let enough = successive.clone().filter(|pair| sure(pair)).count() >= 2;
    successive
        .map(|pair| {
            let number = pair[0].number;
            let time_s = pair[1].time_s - pair[0].time_s;
            let gravity_m_s2 = settings.environment.gravity_m_s2;
            let in_line = match &settings.flights {
                Some(range) => range.contains(&number),
                None => !enough || sure(pair),
            };
            FlightFound {
                number,
                time_s,
                in_line,
                plain_height_m: regression::height_of_flight_m(time_s, gravity_m_s2),
            }
        })
        .collect()
}

fn corrected(impacts: &[Impact], settings: &Options) -> Result<Corrected> {
    let model = FlightModel::new(&settings.ball, &settings.environment)?;
    let timed: Vec<TimedImpact> = impacts.iter().map(TimedImpact::from).collect();
    restitution::of_impacts(&timed, settings.contact_time_s, &model)
}

/// The inference from all impacts that are more likely than not; the others count as missed.
fn estimate(impacts: &[Impact], settings: &Options) -> Result<Posterior> {
    let Some(inference) = &settings.inference else {
        return Err(Error::CannotInfer("it was not asked for".to_owned()));
    };
    let timed: Vec<TimedImpact> = impacts
        .iter()
        .filter(|impact| impact.probability >= 0.5)
        .map(TimedImpact::from)
        .collect();
    inference::infer(
        &timed,
        &settings.ball,
        &settings.environment,
        settings.contact_time_s,
        &settings.priors,
        inference,
    )
}

fn warnings(
    impacts: &[Impact],
    flights: &[FlightFound],
    corrected: Option<&Corrected>,
) -> Vec<Warning> {
    /// No ball that one drops flies so long, in seconds.
    const TOO_LONG_S: f64 = 30.0;
    /// A flight longer than the one before by this factor is no error of the times.
    const GROWS: f64 = 1.02;
    let mut warnings = Vec::new();
    if flights.iter().any(|flight| flight.time_s > TOO_LONG_S) {
        warnings.push(Warning::Milliseconds);
    }
    let span = impacts
        .last()
        .map_or(0, |last| last.number + 1 - impacts[0].number);
    if span > impacts.len() {
        warnings.push(Warning::Missed(span - impacts.len()));
    }
    let gains: Vec<usize> = corrected
        .into_iter()
        .flat_map(|corrected| &corrected.impacts)
        .filter(|impact| {
            // Timing noise alone may lift a late, short flight above 1.
            let error = impact.restitution.standard_error.unwrap_or(0.0);
            impact.restitution.value > 1.0 + 3.0 * error
        })
        .map(|impact| impact.number)
        .collect();
    if gains.is_empty() {
        let grows = flights
            .windows(2)
            .find(|pair| pair[1].time_s > GROWS * pair[0].time_s);
        if let (Some(pair), None) = (grows, corrected) {
            warnings.push(Warning::Grows(pair[1].number));
        }
    } else {
        warnings.push(Warning::Gains(gains));
    }
    let doubtful = impacts
        .iter()
        .filter(|impact| impact.probability < 0.5)
        .count();
    if doubtful > 0 {
        warnings.push(Warning::Doubtful(doubtful));
    }
    warnings
}

impl Drop {
    /// The flight after the impact of this number, if it and the next were heard.
    pub fn flight(&self, number: usize) -> Option<&FlightFound> {
        self.flights.iter().find(|flight| flight.number == number)
    }

    /// The restitution of the impact of this number, corrected for drag, if there is one.
    pub fn corrected_impact(&self, number: usize) -> Option<&ImpactRestitution> {
        let impacts = &self.corrected.as_ref().ok()?.impacts;
        impacts.iter().find(|impact| impact.number == number)
    }

    /// The flight after the impact of this number by the flight model, if there is one.
    pub fn modelled_flight(&self, number: usize) -> Option<&TimedFlight> {
        let flights = &self.corrected.as_ref().ok()?.flights;
        flights.iter().find(|flight| flight.number == number)
    }

    /// The restitution corrected for drag: the median over the impacts, and its standard error
    /// from their scatter. `None` with fewer than three impacts that have one.
    ///
    /// It is the restitution at the typical speed of the drop; see
    /// [`Self::corrected`](Drop::corrected) for how it depends on speed.
    pub fn corrected_restitution(&self) -> Option<Estimate> {
        let corrected = self.corrected.as_ref().ok()?;
        let values = || corrected.impacts.iter().map(|i| i.restitution.value);
        let count = corrected.impacts.len();
        if count < 3 {
            return None;
        }
        let middle = median(values())?;
        let sd = robust_sd(values().map(|value| value - middle))?;
        // Of the median of so many values with a normal scatter.
        let error = sd * (std::f64::consts::FRAC_PI_2 / count as f64).sqrt();
        Some(Estimate {
            value: middle,
            standard_error: Some(error),
        })
    }

    /// The range of impact speeds at which the corrected restitution was seen, in m/s.
    pub fn speed_range_m_s(&self) -> Option<(f64, f64)> {
        let impacts = &self.corrected.as_ref().ok()?.impacts;
        let speeds = impacts.iter().map(|impact| impact.impact_speed_m_s);
        let least = speeds.clone().reduce(f64::min)?;
        Some((least, speeds.reduce(f64::max)?))
    }
}

impl Options {
    /// The flight model of these settings.
    ///
    /// # Errors
    ///
    /// Those of [`FlightModel::new`].
    pub fn model(&self) -> Result<FlightModel> {
        FlightModel::new(&self.ball, &self.environment)
    }
}
