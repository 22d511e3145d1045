//! Balls and floors of known rebound, and simulated drops of them.

use bouncelab::Impact;
use bouncelab::analysis::{self, Drop, Options};
use bouncelab::ball::{self, Ball, Preset};
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::inference::Measured;
use bouncelab::restitution::Restitution;
use bouncelab::rulebook::{
    self, Averaging, Conditions, Decision, Evenness, Formula, Limits, Outcome, Reading,
    Requirement, Rule,
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
    /// The same of each drop in place of the mean; one drop is the lowest.
    EachDrop,
    /// A height by a formula of the rule, as of football turf: 60 to 85 cm by 1.23 (T - 0.025)² from 2 m.
    Formula,
    /// A share of a reference, as of tennis courts: 80 % or more.
    Share,
    /// Each place within 3 % of the mean, as of sports floors; one place is off.
    WithinOfMean,
    /// The shares of the places at most 10 points apart, as of tennis courts; some are high, the others low.
    Range,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Self; 6] = [
        Self::Height,
        Self::EachDrop,
        Self::Formula,
        Self::Share,
        Self::WithinOfMean,
        Self::Range,
    ];

    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Height => "height",
            Self::EachDrop => "each drop",
            Self::Formula => "formula",
            Self::Share => "share",
            Self::WithinOfMean => "within of mean",
            Self::Range => "range",
        }
    }

    /// The limit that is tried: the least height (m) or share, or the greatest difference of places.
    pub const fn limit(self) -> f64 {
        match self {
            Self::Height | Self::EachDrop => 0.24,
            Self::Formula => 0.6,
            Self::Share => 0.8,
            Self::WithinOfMean => 0.03,
            Self::Range => 0.1,
        }
    }

    /// Whether it compares places.
    pub const fn compares_places(self) -> bool {
        matches!(self, Self::WithinOfMean | Self::Range)
    }

    fn drop_m(self) -> f64 {
        if self == Self::Formula { 2.0 } else { 0.305 }
    }

    /// Its ball, if it is not the table-tennis ball.
    fn ball(self) -> Option<&'static Preset> {
        (self == Self::Formula).then(|| ball::preset("football").ok())?
    }

    fn rule(self) -> Rule {
        let share = |least: f64| Requirement::Share {
            limits: Limits::at_least(least),
            of: "granite".to_owned(),
        };
        Rule {
            requirement: match self {
                Self::Height | Self::EachDrop => Requirement::Height(Limits::between(0.24, 0.26)),
                Self::Formula => Requirement::Height(Limits::between(0.6, 0.85)),
                Self::WithinOfMean => Requirement::Height(Limits::at_least(0.2)),
                Self::Share => share(0.8),
                Self::Range => share(0.5),
            },
            averaging: if self == Self::EachDrop {
                Averaging::Each
            } else {
                Averaging::Mean
            },
            evenness: match self {
                Self::WithinOfMean => Some(Evenness::WithinOfMean(self.limit())),
                Self::Range => Some(Evenness::Range(self.limit())),
                _ => None,
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

/// The rebound of the reference of a share, or of an even floor, m.
const REFERENCE_M: f64 = 0.25;

/// How balls and floors are tried.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// The kind of rule.
    pub kind: Kind,
    /// How far inside the limit the truth is, as a share of the limit; outside if negative.
    pub inside: f64,
    /// Drops of each ball, or in each place.
    pub drops: usize,
    /// By how much the restitution differs from drop to drop, as a share.
    pub between: f64,
}

impl Trial {
    /// What the rule limits, as it is: a height, m, a share, or a difference of places.
    pub fn truth(&self) -> f64 {
        let inside = if self.kind.compares_places() {
            -self.inside
        } else {
            self.inside
        };
        self.kind.limit() * (1.0 + inside)
    }

    /// The verdict on one ball or floor; the seed decides everything about it.
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
        let mut place = |rebounds: Vec<Rebound>| -> Vec<Drop> {
            let drops = rebounds.into_iter();
            drops
                .map(|rebound| real.dropped(rebound, self, &settings, &mut chance))
                .collect()
        };
        let surface: Vec<Vec<Drop>> = self.surface().into_iter().map(&mut place).collect();
        let reference = if rule.needs_reference() {
            place(vec![Rebound::Height(REFERENCE_M); self.drops])
        } else {
            Vec::new()
        };
        let surface: Vec<Vec<&Drop>> = surface.iter().map(|place| place.iter().collect()).collect();
        let verdict = rulebook::judge(
            &rule,
            &settings,
            &Conditions::default(),
            &surface,
            &[reference.iter().collect()],
            Decision::default(),
        );
        verdict.map_or(Outcome::CannotDecide, |verdict| verdict.outcome)
    }

    /// The rebounds of the drops in each place.
    fn surface(&self) -> Vec<Vec<Rebound>> {
        let truth = self.truth();
        let drops = |height_m: f64| vec![Rebound::Height(height_m); self.drops];
        match self.kind {
            Kind::Height => vec![drops(truth)],
            Kind::EachDrop => {
                let mut drops = drops(0.25);
                drops[0] = Rebound::Height(truth);
                vec![drops]
            }
            Kind::Formula => {
                let time_s = FORMULA.offset_s + (truth / FORMULA.factor_m_s2).sqrt();
                vec![vec![Rebound::FirstFlight(time_s); self.drops]]
            }
            Kind::Share => vec![drops(truth * REFERENCE_M)],
            // The others differ by a quarter as much from the mean, the other way.
            Kind::WithinOfMean => [
                -truth,
                0.25 * truth,
                0.25 * truth,
                0.25 * truth,
                0.25 * truth,
            ]
            .map(|off| drops(REFERENCE_M * (1.0 + off)))
            .into(),
            Kind::Range => [0.0, truth, 0.0, truth, truth]
                .map(|above| drops(REFERENCE_M * (0.7 + above)))
                .into(),
        }
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
        trial: &Trial,
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
        let livelier = (trial.between * normal(chance)).exp();
        // Where each drop counts, the rebound that it had is the truth.
        let scatter = if trial.kind == Kind::EachDrop {
            0.0
        } else {
            SCATTER
        };
        let first_m_s = self.model.fall(height_m).unwrap().impact_speed_m_s;
        let restitution =
            |speed_m_s| law.at(speed_m_s) * livelier * (scatter * normal(chance)).exp();
        let times: Vec<f64> = bouncing(
            self.model.clone(),
            self.contact_time_s,
            first_m_s,
            restitution,
        )
        .take(3)
        .map(|event| event.time_s)
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
