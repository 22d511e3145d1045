//! A ball in air under gravity, with their uncertainties.

use super::observed::Observed;
use super::parameters::{TABLE_REACH, TABLE_STEPS};
use super::possible_balls::PossibleBall;
use super::priors::Priors;
use crate::ball::Ball;
use crate::drag::DragLaw;
use crate::error::Result;
use crate::flight::table::{DragProfile, FlightTables};
use crate::flight::{Environment, FlightModel};

/// A ball in air under gravity, with their uncertainties.
#[derive(Debug, Clone)]
pub(super) struct Medium {
    /// Kind of the ball, if it was not stated.
    pub(super) kind: &'static str,
    pub(super) ball: Ball,
    /// Flights with the nominal drag and gravity.
    pub(super) model: FlightModel,
    pub(super) flights: FlightTables,
    /// Effective gravity, m/s².
    pub(super) gravity_m_s2: f64,
    pub(super) drag_sd: f64,
    /// Contact time, s, and its relative standard uncertainty.
    pub(super) contact_time_s: f64,
    pub(super) contact_sd: f64,
    pub(super) inputs: Inputs,
}

/// The inputs affect a flight only through the effective gravity and drag over weight. Their joint prior is normal in the
/// logarithms; this is its triangular root:
/// `ln g = gravity_sd z1`, `ln drag = drag_on_gravity z1 + drag_sd z2`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Inputs {
    /// One row for each input: name, d ln g, d ln(drag), each for one standard uncertainty.
    pub(super) sources: Vec<(&'static str, f64, f64)>,
    pub(super) gravity_sd: f64,
    pub(super) drag_on_gravity: f64,
    pub(super) drag_sd: f64,
}

impl Medium {
    pub(super) fn new(
        possible: &PossibleBall,
        environment: &Environment,
        observed: &Observed,
        priors: &Priors,
    ) -> Result<Self> {
        let priors = possible.inform(priors);
        let model = FlightModel::new(&possible.known.ball, environment)?;
        let gravity_m_s2 = model.gravity_m_s2();
        let mut fastest = 0.5 * gravity_m_s2 * observed.longest_flight_s();
        if let Some(height) = priors.drop_height_m {
            fastest = fastest.max((2.0 * gravity_m_s2 * height.value).sqrt());
        }
        let dragless = environment.drag == DragLaw::None || environment.air.is_vacuum();
        // Higher for drag, and for the fall before a dead first impact.
        let reach = (2.0 / observed.first_ratio()).clamp(TABLE_REACH[0], TABLE_REACH[1]);
        let steps = (TABLE_STEPS * reach) as usize;
        Ok(Self {
            kind: possible.kind,
            ball: possible.known.ball,
            flights: FlightTables::new(DragProfile::new(&model, reach * fastest, steps)?),
            gravity_m_s2,
            drag_sd: if dragless { 0.0 } else { priors.drag_rel_sd },
            contact_time_s: possible.known.contact_time_s,
            contact_sd: priors.contact_time_rel_sd,
            inputs: Inputs::new(&possible.known.ball, environment, &priors, dragless),
            model,
        })
    }

    /// Mass of the ball, with that of the air that moves with it, kg.
    pub(super) fn mass_kg(&self) -> f64 {
        self.model.moving_mass_kg().unwrap_or(self.ball.mass_kg())
    }
}

impl Inputs {
    /// With r the mass of the displaced air over that of the ball and c the added mass as a share
    /// of it, effective gravity is g (1 - r)/(1 + c r), and drag over weight goes as D² rho/((1 - r) m g).
    fn new(ball: &Ball, environment: &Environment, priors: &Priors, dragless: bool) -> Self {
        let displaced = environment.air.density_kg_m3() * ball.volume_m3() / ball.mass_kg();
        let r = if environment.buoyancy { displaced } else { 0.0 };
        let cr = if environment.added_mass {
            0.5 * displaced
        } else {
            0.0
        };
        let lift = r / (1.0 - r);
        let on_gravity = lift + cr / (1.0 + cr);
        let drag = if dragless { 0.0 } else { 1.0 };
        let mut sources = vec![
            (
                "gravity",
                priors.gravity_rel_sd,
                -drag * priors.gravity_rel_sd,
            ),
            (
                "air-density",
                -on_gravity * priors.air_density_rel_sd,
                drag * (1.0 + lift) * priors.air_density_rel_sd,
            ),
            (
                "ball-mass",
                on_gravity * priors.mass_rel_sd,
                -drag * (1.0 + lift) * priors.mass_rel_sd,
            ),
            (
                "ball-diameter",
                -3.0 * on_gravity * priors.diameter_rel_sd,
                drag * (2.0 + 3.0 * lift) * priors.diameter_rel_sd,
            ),
            (
                "added-mass",
                -cr / (1.0 + cr) * priors.added_mass_rel_sd,
                0.0,
            ),
        ];
        sources.retain(|&(_, g, d)| g != 0.0 || d != 0.0);
        let sum = |f: fn(f64, f64) -> f64| sources.iter().map(|&(_, g, d)| f(g, d)).sum::<f64>();
        let gravity_sd = sum(|g, _| g * g).sqrt();
        let drag_on_gravity = if gravity_sd > 0.0 {
            sum(|g, d| g * d) / gravity_sd
        } else {
            0.0
        };
        let rest = sum(|_, d| d * d) - drag_on_gravity * drag_on_gravity;
        Self {
            gravity_sd,
            drag_on_gravity,
            drag_sd: rest.max(0.0).sqrt(),
            sources,
        }
    }

    /// Expected share of gravity itself in a change of ln(effective gravity): its share of the prior variance.
    pub(super) fn gravity_share(&self) -> f64 {
        let own = self.sources.iter().find(|(name, ..)| *name == "gravity");
        match own {
            Some((_, sd, _)) if self.gravity_sd > 0.0 => (sd / self.gravity_sd).powi(2),
            _ => 0.0,
        }
    }

    /// Change of the two standard normals by one standard uncertainty of an input.
    pub(super) fn whitened(&self, source: usize) -> [f64; 2] {
        let (_, gravity, drag) = self.sources[source];
        let divide = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
        let first = divide(gravity, self.gravity_sd);
        [
            first,
            divide(drag - self.drag_on_gravity * first, self.drag_sd),
        ]
    }
}
