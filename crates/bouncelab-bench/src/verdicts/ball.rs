//! Balls and floors of known rebound, and simulated drops of them.

use bouncelab::Impact;
use bouncelab::analysis::{self, Drop, Options};
use bouncelab::ball::{self, Ball, Preset};
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::inference::Measured;
use bouncelab::restitution::Restitution;
use bouncelab::rulebook::{
    self, Conditions, Decision, Formula, Limits, Outcome, Reading, Requirement, Rule,
};
use bouncelab_testkit::bouncing;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// The ball is held by hand beside a ruler.
const HEIGHT_SD_M: f64 = 0.001;
/// The timing error of the detector in low background noise.
const TIMING_S: f64 = 5e-5;
/// Scatter of a good surface.
const SCATTER: f64 = 0.004;

/// A kind of rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A height that the rule measures itself, as of table-tennis balls: 24 to 26 cm from 30.5 cm.
    Height,
    /// A height by a formula of the rule, as of football turf: 60 to 85 cm by 1.23 (T - 0.025)² from 2 m.
    Formula,
    /// A share of a reference, as of tennis courts: 80 % or more.
    Share,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::Height, Self::Formula, Self::Share];

    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Height => "height",
            Self::Formula => "formula",
            Self::Share => "share",
        }
    }

    fn drop_m(self) -> f64 {
        match self {
            Self::Height | Self::Share => 0.305,
            Self::Formula => 2.0,
        }
    }

    /// The limits of heights (m) or of shares.
    pub const fn limits(self) -> Limits {
        match self {
            Self::Height => Limits::between(0.24, 0.26),
            Self::Formula => Limits::between(0.6, 0.85),
            Self::Share => Limits::at_least(0.8),
        }
    }

    /// Its ball, if it is not the table-tennis ball.
    fn ball(self) -> Option<&'static Preset> {
        match self {
            Self::Height | Self::Share => None,
            Self::Formula => ball::preset("football").ok(),
        }
    }

    fn rule(self) -> Rule {
        let limits = self.limits();
        Rule {
            requirement: match self {
                Self::Share => Requirement::Share {
                    limits,
                    of: "granite".to_owned(),
                },
                Self::Height | Self::Formula => Requirement::Height(limits),
            },
            formula: (self == Self::Formula).then_some(FORMULA),
            ..Rule::new("rule", "A rule", self.drop_m())
        }
    }
}

const FORMULA: Formula = Formula {
    factor_m_s2: 1.23,
    offset_s: 0.025,
    read: Reading::Memory,
};

/// The rebound of the reference of a share, m.
const REFERENCE_M: f64 = 0.25;

/// How balls are tried.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// The kind of rule.
    pub kind: Kind,
    /// What the rule limits, as it is: a height, m, or a share.
    pub truth: f64,
    /// Drops of each ball.
    pub drops: usize,
    /// By how much the restitution differs from drop to drop, as a share.
    pub between: f64,
}

impl Trial {
    /// The verdict on one ball; the seed decides everything about it.
    pub fn verdict(&self, seed: u64) -> Outcome {
        let mut chance = ChaCha8Rng::seed_from_u64(seed);
        let rule = self.kind.rule();
        let mut settings = self.kind.ball().map_or_else(Options::default, Options::new);
        settings.inference = None;
        settings.priors.drop_height_m = Some(Measured {
            value: self.kind.drop_m(),
            sd: HEIGHT_SD_M,
        });
        let real = RealBall::new(self.kind, &settings, &mut chance);
        let mut place = |rebound: Rebound| -> Vec<Drop> {
            (0..self.drops)
                .map(|_| real.dropped(rebound, self.between, &settings, &mut chance))
                .collect()
        };
        let (surface, reference) = match self.kind {
            Kind::Height => (place(Rebound::Height(self.truth)), Vec::new()),
            Kind::Formula => (
                place(Rebound::FirstFlight(
                    FORMULA.offset_s + (self.truth / FORMULA.factor_m_s2).sqrt(),
                )),
                Vec::new(),
            ),
            Kind::Share => (
                place(Rebound::Height(self.truth * REFERENCE_M)),
                place(Rebound::Height(REFERENCE_M)),
            ),
        };
        let verdict = rulebook::judge(
            &rule,
            &settings,
            &Conditions::default(),
            &[surface.iter().collect()],
            &[reference.iter().collect()],
            Decision::default(),
        );
        verdict.map_or(Outcome::CannotDecide, |verdict| verdict.outcome)
    }
}

/// What is known of a rebound, from the height of the rule.
#[derive(Clone, Copy)]
enum Rebound {
    /// Its height, m.
    Height(f64),
    /// The time to the second impact, s.
    FirstFlight(f64),
}

/// A ball as it is, within what the preset says of balls.
struct RealBall {
    kind: Kind,
    model: FlightModel,
    contact_time_s: f64,
}

impl RealBall {
    /// A ball, air and gravity drawn from what is known of them.
    fn new(kind: Kind, settings: &Options, chance: &mut ChaCha8Rng) -> Self {
        let known = &settings.priors;
        let mut off = |sd: f64| (sd * normal(chance)).exp();
        let nominal = &settings.environment;
        let ball = Ball::new(
            settings.ball.mass_kg() * off(known.mass_rel_sd),
            settings.ball.diameter_m() * off(known.diameter_rel_sd),
        )
        .unwrap();
        let reynolds = nominal.air.reynolds(&ball, 2.4);
        let coefficient = nominal.drag.coefficient(reynolds).unwrap() * off(known.drag_rel_sd);
        let environment = Environment {
            gravity_m_s2: nominal.gravity_m_s2 * off(known.gravity_rel_sd),
            drag: DragLaw::Constant(coefficient),
            ..*nominal
        };
        Self {
            kind,
            model: FlightModel::new(&ball, &environment).unwrap(),
            contact_time_s: settings.contact_time_s * off(known.contact_time_rel_sd.min(0.3)),
        }
    }

    /// A drop of it, detected and analysed.
    fn dropped(
        &self,
        rebound: Rebound,
        between: f64,
        settings: &Options,
        chance: &mut ChaCha8Rng,
    ) -> Drop {
        let drop_m = self.kind.drop_m();
        let impact_m_s = self.model.fall(drop_m).unwrap().impact_speed_m_s;
        let launch_m_s = match rebound {
            Rebound::Height(rebound_m) => self.model.from_apex(rebound_m).unwrap().launch_speed_m_s,
            Rebound::FirstFlight(time_s) => {
                self.model
                    .from_flight_time(time_s - self.contact_time_s)
                    .unwrap()
                    .launch_speed_m_s
            }
        };
        let law = Restitution::constant(launch_m_s / impact_m_s).unwrap();
        let height_m = drop_m + HEIGHT_SD_M * normal(chance);
        let livelier = (between * normal(chance)).exp();
        let first_m_s = self.model.fall(height_m).unwrap().impact_speed_m_s;
        let restitution =
            |speed_m_s| law.at(speed_m_s) * livelier * (SCATTER * normal(chance)).exp();
        let times: Vec<f64> = bouncing(
            self.model.clone(),
            self.contact_time_s,
            first_m_s,
            restitution,
        )
        .take(3)
        .map(|strike| strike.time_s)
        .collect();
        let impacts = times.iter().zip(1..).map(|(time_s, number)| {
            let time_s = time_s + TIMING_S * normal(chance);
            Impact::new(number, time_s).with_time_sd_s(TIMING_S)
        });
        analysis::analyze_impacts(impacts.collect(), settings)
    }
}

fn normal(chance: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(chance)
}
