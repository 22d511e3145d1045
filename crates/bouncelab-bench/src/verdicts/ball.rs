//! Balls of known rebound, and simulated drops of them.

use bouncelab::Impact;
use bouncelab::analysis::{self, Drop, Options};
use bouncelab::ball::Ball;
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::impact::ImpactEvent;
use bouncelab::inference::{InferenceOptions, Measured, SamplerConfig};
use bouncelab::restitution::Restitution;
use bouncelab::rulebook::{self, Conditions, Decision, Limits, Outcome, Requirement, Rule};
use bouncelab_testkit::bouncing;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// The rule of table tennis: from 30.5 cm to 24 to 26 cm.
const DROP_M: f64 = 0.305;
pub(crate) const LIMITS: Limits = Limits::between(0.24, 0.26);

/// The ball is held by hand beside a ruler.
const HEIGHT_SD_M: f64 = 0.001;
/// The timing error of the detector in low background noise.
const TIMING_S: f64 = 5e-5;
/// Scatter of a good surface.
const SCATTER: f64 = 0.004;
/// How much restitution may change with speed, as the exponent of a power law.
const EXPONENT_SD: f64 = 0.03;
const MAX_IMPACTS: usize = 30;

/// How balls are tried.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// The rebound that the ball has, from the height of the rule, m.
    pub rebound_m: f64,
    /// Drops of each ball.
    pub drops: usize,
    /// By how much the restitution differs from drop to drop, as a share.
    pub between: f64,
    /// Draws of each inference.
    pub draws: usize,
}

impl Trial {
    /// The verdict on one ball; the seed decides everything about it.
    pub fn verdict(&self, seed: u64) -> Outcome {
        let mut chance = ChaCha8Rng::seed_from_u64(seed);
        let settings = self.settings(seed);
        let real = RealBall::new(self.rebound_m, &settings, &mut chance);
        let drops: Vec<Drop> = (0..self.drops)
            .map(|_| real.dropped(self.between, &settings, &mut chance))
            .collect();
        let rule = Rule {
            requirement: Requirement::Height(LIMITS),
            ..Rule::new("ittf-ball", "Table-tennis ball", DROP_M)
        };
        let places = [drops.iter().collect()];
        let conditions = Conditions::default();
        let verdict = rulebook::judge(
            &rule,
            &settings,
            &conditions,
            &places,
            &[],
            Decision::default(),
        );
        verdict.map_or(Outcome::CannotDecide, |verdict| verdict.outcome)
    }

    fn settings(&self, seed: u64) -> Options {
        let mut settings = Options::default();
        settings.priors.drop_height_m = Some(Measured {
            value: DROP_M,
            sd: HEIGHT_SD_M,
        });
        settings.inference = Some(InferenceOptions {
            sampler: SamplerConfig {
                draws: self.draws,
                seed,
            },
            ..InferenceOptions::default()
        });
        settings
    }
}

/// A ball as it is, within what the preset says of balls.
struct RealBall {
    model: FlightModel,
    law: Restitution,
    contact_time_s: f64,
}

impl RealBall {
    /// A ball, air and gravity drawn from what is known of them, with the restitution that makes it
    /// rebound so high from the height of the rule.
    fn new(rebound_m: f64, settings: &Options, chance: &mut ChaCha8Rng) -> Self {
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
        let model = FlightModel::new(&ball, &environment).unwrap();
        let impact_m_s = model.fall(DROP_M).unwrap().impact_speed_m_s;
        let launch_m_s = model.from_apex(rebound_m).unwrap().launch_speed_m_s;
        let exponent = EXPONENT_SD * normal(chance);
        Self {
            law: Restitution::power(launch_m_s / impact_m_s, impact_m_s, exponent).unwrap(),
            contact_time_s: settings.contact_time_s,
            model,
        }
    }

    /// A drop of it, detected and analysed.
    fn dropped(&self, between: f64, settings: &Options, chance: &mut ChaCha8Rng) -> Drop {
        let height_m = DROP_M + HEIGHT_SD_M * normal(chance);
        let livelier = (between * normal(chance)).exp();
        let first_m_s = self.model.fall(height_m).unwrap().impact_speed_m_s;
        let restitution =
            |speed_m_s| self.law.at(speed_m_s) * livelier * (SCATTER * normal(chance)).exp();
        let strikes: Vec<ImpactEvent> = bouncing(
            self.model.clone(),
            self.contact_time_s,
            first_m_s,
            restitution,
        )
        .take(MAX_IMPACTS)
        .collect();
        let impacts = strikes.iter().zip(1..).map(|(strike, number)| {
            let time_s = strike.time_s + TIMING_S * normal(chance);
            Impact::new(number, time_s).with_time_sd_s(TIMING_S)
        });
        analysis::analyze_impacts(impacts.collect(), settings)
    }
}

fn normal(chance: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(chance)
}
