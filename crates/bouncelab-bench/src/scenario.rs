//! Simulated drops for which the model of the inference is true, or not exactly true.
//!
//! Drops of balls that obey no law of the inference, of which impacts are missing or outliers, whose times
//! are rounded, and so on; their times are what a list of times or the detector would give.

use bouncelab::analysis::Options;
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::restitution::Restitution;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

use crate::misfit::{Case, Observed, Truth};

/// What differs from the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scenario {
    /// Nothing: one of five laws of the inference, each as likely.
    True,
    /// The restitution is e0 - 0.03 v^(1/4), none of the laws of the inference.
    NoLaw,
    /// One impact in ten is missing, independently of the others.
    Missing,
    /// As many are missing, in runs of two on average.
    MissingRuns,
    /// 3 % of the impacts scatter ten times as much.
    Wild,
    /// Times are rounded to a millisecond.
    Rounded,
    /// Times have errors of about 2 ms that are not stated, as those noted by hand.
    Noted,
    /// The ball drifts away from the microphone, or to it, at about 10 cm/s.
    Drifting,
    /// From some impact on, the restitution is that of another surface, about 1 % higher or lower.
    TwoSurfaces,
    /// The contact lasts twice as long as stated.
    WrongContact,
    /// Restitution scatters by about 2 %, three times as much as assumed.
    Rough,
    /// The same scatter, stated.
    RoughStated,
}

impl Scenario {
    /// Every scenario.
    pub const ALL: [Self; 12] = [
        Self::True,
        Self::NoLaw,
        Self::Missing,
        Self::MissingRuns,
        Self::Wild,
        Self::Rounded,
        Self::Noted,
        Self::Drifting,
        Self::TwoSurfaces,
        Self::WrongContact,
        Self::Rough,
        Self::RoughStated,
    ];

    /// Its name, as in arguments and tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::True => "true",
            Self::NoLaw => "no-law",
            Self::Missing => "missing",
            Self::MissingRuns => "missing-runs",
            Self::Wild => "wild",
            Self::Rounded => "rounded",
            Self::Noted => "noted",
            Self::Drifting => "drifting",
            Self::TwoSurfaces => "two-surfaces",
            Self::WrongContact => "wrong-contact",
            Self::Rough => "rough",
            Self::RoughStated => "rough-stated",
        }
    }

    /// The settings with which its drops are analysed: those given, with the scatter if it is stated.
    #[must_use]
    pub fn stated(self, mut options: Options) -> Options {
        if self == Self::RoughStated {
            options.priors.restitution_scatter = ROUGH;
        }
        options
    }
}

/// Drops end at this many impacts unless fewer are asked for, as they do in recordings.
pub const MAX_IMPACTS: usize = 40;
/// Drops end before the first flight that is shorter than this.
pub(crate) const SHORTEST_FLIGHT_S: f64 = 0.05;
/// A drop with more impacts than this never rests.
const MAX_BOUNCES: usize = 2000;
/// After a launch as slow as this, in m/s, the flights are a geometric series.
pub(crate) const REST_M_S: f64 = 0.01;
/// Scatter of the restitution on a rough surface.
const ROUGH: f64 = 0.02;
/// The detector finds no drop in fewer impacts; only a list of times may have fewer.
pub(crate) const MIN_IMPACTS: usize = 5;
/// The reference speed of the restitution laws, m/s.
const REFERENCE_M_S: f64 = 1.5;

/// A drop as detected, and its truth.
#[derive(Debug)]
pub struct Drop {
    /// Times of the impacts detected, s.
    pub times_s: Vec<f64>,
    law: Law,
    /// Restitution of the second surface over that of the first, and the speed of the first impact on it, m/s.
    second: (f64, f64),
    /// Drop height, m.
    pub height_m: f64,
    /// Speed of the first impact, m/s.
    pub first_impact_m_s: f64,
    /// Speed of the last impact detected, m/s.
    slowest_m_s: f64,
    /// From the release until rest, s; `None` if it never rests.
    pub rest_s: Option<f64>,
    /// From the release until the first impact, s.
    pub fall_s: f64,
    /// Numbers of the impacts detected, 1 for the first.
    pub numbers: Vec<usize>,
}

#[derive(Debug)]
enum Law {
    OfInference(Restitution),
    QuarterPower(f64),
}

impl Law {
    fn drawn(scenario: Scenario, rng: &mut ChaCha8Rng) -> Option<Self> {
        let e = 0.6 + 0.37 * rng.random::<f64>();
        let slope = 0.1 * rng.sample::<f64, _>(StandardNormal);
        if scenario == Scenario::NoLaw {
            return Some(Self::QuarterPower(e + 0.03));
        }
        let v = REFERENCE_M_S;
        let law = match rng.random_range(0..5) {
            0 => Restitution::constant(e),
            1 => Restitution::linear(e * (1.0 + slope * v / 4.0), e * slope / 4.0),
            2 => Restitution::power(e, v, slope),
            3 => Restitution::viscoelastic_through(e, v),
            _ => Restitution::knee(e, v, 0.05 * e / v),
        };
        law.ok().map(Self::OfInference)
    }

    fn at(&self, speed_m_s: f64) -> f64 {
        match self {
            Self::OfInference(law) => law.at(speed_m_s),
            Self::QuarterPower(at_rest) => at_rest - 0.03 * speed_m_s.powf(0.25),
        }
    }
}

impl Drop {
    /// A drop of the ball of these settings, drawn from their priors; `None` if it is too short to be
    /// detected as a drop.
    pub fn drawn(
        scenario: Scenario,
        max_impacts: usize,
        options: &Options,
        rng: &mut ChaCha8Rng,
    ) -> Option<Self> {
        let Options {
            ball,
            environment,
            contact_time_s,
            priors,
            ..
        } = options;
        let normal = |rng: &mut ChaCha8Rng| rng.sample::<f64, _>(StandardNormal);
        let law = Law::drawn(scenario, rng)?;
        let height_m = 0.15 * 10_f64.powf(rng.random());
        let environment = Environment {
            gravity_m_s2: environment.gravity_m_s2 * (priors.gravity_rel_sd * normal(rng)).exp(),
            // Half of the balls have the drag of the law, half a constant coefficient.
            drag: if rng.random::<bool>() {
                environment.drag.clone()
            } else {
                DragLaw::Constant(0.4 * (priors.drag_rel_sd * normal(rng)).exp())
            },
            ..*environment
        };
        let model = FlightModel::new(ball, &environment).ok()?;
        let usual = match scenario {
            Scenario::Rough | Scenario::RoughStated => ROUGH,
            _ => 0.003,
        };
        let scatter = usual * (0.7 * normal(rng)).exp();
        let usual_s = if scenario == Scenario::Noted {
            2e-3
        } else {
            5e-5
        };
        let sigma_s = usual_s * (0.7 * normal(rng)).exp();
        let contact_s = match scenario {
            Scenario::WrongContact => 2.0 * contact_time_s,
            _ => contact_time_s * (0.3 * normal(rng)).exp(),
        };
        // Sound takes 2.9 ms for each metre.
        let delay_per_s = match scenario {
            Scenario::Drifting => 0.1 * normal(rng) / 343.0,
            _ => 0.0,
        };
        let (second_per_first, second_from) = match scenario {
            Scenario::TwoSurfaces => ((0.01 * normal(rng)).exp(), rng.random_range(2..12)),
            _ => (1.0, usize::MAX),
        };
        let mut second = (1.0, 0.0);
        let fall = model.fall(height_m).ok()?;
        let first_impact_m_s = fall.impact_speed_m_s;
        let (mut speed, mut slowest_m_s) = (first_impact_m_s, first_impact_m_s);
        let (mut time_s, mut missing, mut detected, mut rest_s) = (0.0, false, true, None);
        let (mut times_s, mut numbers) = (Vec::new(), Vec::new());
        for number in 1..=MAX_BOUNCES {
            missing = match scenario {
                Scenario::Missing => rng.random::<f64>() < 0.1,
                // A run goes on with probability 1/2: 10 % of all impacts are missing.
                Scenario::MissingRuns => rng.random::<f64>() < if missing { 0.5 } else { 0.055 },
                _ => false,
            };
            let off = sigma_s * normal(rng);
            if number == 1 || detected && !missing {
                let detected_s = time_s * (1.0 + delay_per_s) + off;
                // 1 µs: effectively no rounding.
                let grid_s = if scenario == Scenario::Rounded {
                    1e-3
                } else {
                    1e-6
                };
                times_s.push((detected_s / grid_s).round() * grid_s);
                numbers.push(number);
                slowest_m_s = speed;
            }
            let is_outlier = scenario == Scenario::Wild && rng.random::<f64>() < 0.03;
            let spread = if is_outlier { 10.0 * scatter } else { scatter };
            if number == second_from {
                second = (second_per_first, speed);
            }
            let expected = second.0 * law.at(speed);
            let kept = expected * (spread * normal(rng)).exp();
            let launch = speed * kept.min(1.0);
            time_s += contact_s;
            if launch < (0.5 * environment.gravity_m_s2 * contact_s).max(REST_M_S) {
                let last_s = 2.0 * launch / environment.gravity_m_s2 / (1.0 - expected);
                rest_s = (expected < 1.0).then_some(fall.time_s + time_s + last_s);
                break;
            }
            let flight = model.launch(launch).ok()?;
            detected &= number < max_impacts && flight.time_s() >= SHORTEST_FLIGHT_S;
            time_s += flight.time_s();
            speed = flight.impact_speed_m_s;
        }
        (times_s.len() >= MIN_IMPACTS.min(max_impacts)).then_some(Self {
            times_s,
            law,
            second,
            height_m,
            first_impact_m_s,
            slowest_m_s,
            rest_s,
            fall_s: fall.time_s,
            numbers,
        })
    }

    /// The true restitution at an impact speed, m/s, on the surface of the impacts of this speed.
    fn restitution(&self, speed_m_s: f64) -> f64 {
        let (factor, fastest_m_s) = self.second;
        let on_second = speed_m_s <= fastest_m_s;
        self.law.at(speed_m_s) * if on_second { factor } else { 1.0 }
    }

    /// It, as a list of times to be analysed with these options.
    pub(crate) fn case(self, options: Options) -> Case {
        Case {
            observed: Observed::Times(self.times_s.clone()),
            options,
            truth: Truth {
                middle_m_s: (self.first_impact_m_s * self.slowest_m_s).sqrt(),
                height_m: self.height_m,
                rest_s: self.rest_s,
                numbers: Some(self.numbers.clone()),
                restitution: Box::new(move |speed_m_s| self.restitution(speed_m_s)),
            },
        }
    }
}
