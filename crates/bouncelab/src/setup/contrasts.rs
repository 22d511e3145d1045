//! How the answers of a drop depend on the ball, for those who did not say which it is.

use super::{BallInput, Setup, SetupInput};
use crate::analysis::{Drop, analyze_impacts};
use crate::estimate::Estimate;
use crate::inference::SamplerConfig;

/// What a drop would say if it was a ball that the air slows little: for those who did not say which.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BallContrast {
    /// The ball: `tennis` or `steel`.
    pub ball: &'static str,
    /// The restitution, if it was this ball.
    pub restitution: Estimate,
    /// The drop height in metres, if it was this ball.
    pub drop_height_m: Estimate,
}

impl Setup {
    /// How the answers of a drop depend on the ball: what they would be for a tennis ball and for a steel
    /// ball of 20 mm. Nothing without a posterior.
    ///
    /// With few draws of the most probable law alone, which takes a few milliseconds: the intervals are
    /// good to a tenth.
    ///
    /// ```
    /// use bouncelab::{analyze_times, demo, setup::Settings};
    ///
    /// let times_s: Vec<f64> = demo::history()?.strikes().map(|strike| strike.time_s).collect();
    /// let setup = Settings::default().resolve(true)?;
    /// let drop = &analyze_times(&times_s, &setup.options).drops[0];
    /// let steel = setup.ball_contrasts(drop)[1];
    /// // Air takes nearly nothing from steel, so that the impacts must have taken more.
    /// assert!(steel.restitution.value < drop.posterior.as_ref().unwrap().restitution.value);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn ball_contrasts(&self, drop: &Drop) -> Vec<BallContrast> {
        const DRAWS: usize = 200;
        let found = drop.posterior.as_ref().ok();
        let Some(model) = found.and_then(|found| found.models.first()) else {
            return Vec::new();
        };
        let with = |(ball, stated): (&'static str, BallInput)| {
            let stated = SetupInput {
                ball: Some(stated),
                ..SetupInput::default()
            };
            let stated = stated.resolve().ok()?;
            let mut options = self.options.clone().with_ball_of(&stated.options);
            options.priors.restitution_laws = vec![model.restitution_law];
            options.compares_balls = false;
            let sampler = SamplerConfig {
                draws: DRAWS,
                ..SamplerConfig::default()
            };
            let drop = analyze_impacts(drop.impacts.clone(), &options.with_sampler(sampler));
            let found = drop.posterior.ok()?;
            Some(BallContrast {
                ball,
                restitution: found.restitution,
                drop_height_m: found.drop_height_m,
            })
        };
        let balls = [
            ("tennis", BallInput::Named("tennis".to_owned())),
            ("steel", BallInput::Steel(0.02)),
        ];
        balls.into_iter().filter_map(with).collect()
    }
}
