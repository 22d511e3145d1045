//! A ball, its surroundings and its restitution as they may be before the data.

use rand::RngExt;
use rand_distr::{Distribution, StandardNormal, StudentT};

use super::parameters::SCATTER_FREEDOM;
use super::priors::Priors;
use crate::air::Air;
use crate::ball::Ball;
use crate::error::Result;
use crate::flight::{Environment, FlightModel};
use crate::restitution::{MAX_SHAPES, Restitution, SpeedRange};

/// A drop of this factor of speed is drawn: from that of the first impact to a quarter of it, with v* in the middle.
const RANGE: f64 = 4.0;

/// A draw of the priors, as [`Priors::draw`] gives it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PriorDraw {
    /// The ball.
    pub ball: Ball,
    /// Gravity, air and drag.
    pub environment: Environment,
    /// Contact time, s.
    pub contact_time_s: f64,
    /// The restitution law.
    pub restitution: Restitution,
    /// Standard deviation of ln e from impact to impact.
    pub scatter: f64,
}

impl PriorDraw {
    /// Deviation of ln e of an impact from the law, with the tails that the inference expects: Student's t.
    pub fn deviation(&self, random: &mut impl RngExt) -> f64 {
        let tail = StudentT::new(SCATTER_FREEDOM).map_or(0.0, |tail| tail.sample(random));
        // Its variance is n/(n - 2).
        self.scatter * tail * ((SCATTER_FREEDOM - 2.0) / SCATTER_FREEDOM).sqrt()
    }
}

impl Priors {
    /// Draws what is unknown of a drop from this height, given the nominal ball, surroundings and contact time: the kind of
    /// ball if it may be one of several, each input about its nominal value, one of the laws with its numbers, and the scatter. The
    /// added mass stays half that of the displaced air, and errors of times are no part of a drop.
    ///
    /// ```
    /// use bouncelab::analysis::Options;
    /// use rand::SeedableRng;
    ///
    /// let Options { ball, environment, contact_time_s, priors, .. } = Options::default();
    /// let mut random = rand::rngs::Xoshiro256PlusPlus::seed_from_u64(1);
    /// let drawn = priors.draw(&ball, &environment, contact_time_s, 0.3, &mut random)?;
    /// assert!((drawn.ball.mass_kg() / ball.mass_kg() - 1.0).abs() < 0.1);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`FlightModel::new`] and [`FlightModel::fall`] for a ball that cannot fall from there.
    pub fn draw(
        &self,
        ball: &Ball,
        environment: &Environment,
        contact_time_s: f64,
        height_m: f64,
        random: &mut impl RngExt,
    ) -> Result<PriorDraw> {
        let stated = self.known(*ball, contact_time_s);
        let known = match self.possible_balls.as_slice() {
            [] => stated,
            kinds => kinds[random.random_range(0..kinds.len())].known,
        };
        let mut factor = |rel_sd: f64| {
            let normal: f64 = StandardNormal.sample(random);
            (rel_sd * normal).exp()
        };
        let ball = Ball::new(
            known.ball.mass_kg() * factor(known.mass_rel_sd),
            known.ball.diameter_m() * factor(known.diameter_rel_sd),
        )?;
        let density = environment.air.density_kg_m3() * factor(self.air_density_rel_sd);
        let environment = Environment {
            gravity_m_s2: environment.gravity_m_s2 * factor(self.gravity_rel_sd),
            air: Air::new(density, environment.air.viscosity_pa_s())?,
            drag: environment.drag.scaled(factor(known.drag_rel_sd))?,
            ..environment.clone()
        };
        let contact_time_s = known.contact_time_s * factor(known.contact_time_rel_sd);
        let fall = FlightModel::new(&ball, &environment)?.fall(height_m)?;
        let fastest_m_s = fall.impact_speed_m_s;
        let speeds = SpeedRange {
            reference_m_s: fastest_m_s / RANGE.sqrt(),
            slowest_m_s: fastest_m_s / RANGE,
            fastest_m_s,
        };
        let scatter = self.scatter_at(StandardNormal.sample(random));
        let laws = self.laws();
        let law = laws[random.random_range(0..laws.len())];
        let stated = self.restitution.as_ref().map(|prior| prior.over(&speeds));
        // A law that no surface has is drawn again.
        let restitution = loop {
            let normals: [f64; MAX_SHAPES] = std::array::from_fn(|_| StandardNormal.sample(random));
            let drawn = match &stated {
                None => law.of_normals(random.random(), normals, &speeds),
                Some(prior) => prior.law(prior.draw_restitution(random), normals),
            };
            if let Ok(law) = drawn {
                break law;
            }
        };
        Ok(PriorDraw {
            ball,
            environment,
            contact_time_s,
            restitution,
            scatter,
        })
    }
}
