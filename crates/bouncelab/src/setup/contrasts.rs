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
    /// With a fifth of the usual draws, which takes some ten milliseconds: values and standard uncertainties are those of
    /// an analysis with that ball to about a tenth of the uncertainty.
    ///
    /// ```
    /// use bouncelab::{analyze_times, demo, setup::Settings};
    ///
    /// let times_s: Vec<f64> = demo::history()?.impact_events().map(|strike| strike.time_s).collect();
    /// let setup = Settings::default().resolve(true)?;
    /// let drop = &analyze_times(&times_s, &setup.options).drops[0];
    /// let steel = setup.ball_contrasts(drop)[1];
    /// // Air takes nearly nothing from steel, so that the impacts must have taken more.
    /// assert!(steel.restitution.value < drop.posterior.as_ref().unwrap().restitution.value);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn ball_contrasts(&self, drop: &Drop) -> Vec<BallContrast> {
        const DRAWS: usize = 200;
        if drop.posterior.is_err() {
            return Vec::new();
        }
        let with = |(ball, stated): (&'static str, BallInput)| {
            let stated = SetupInput {
                ball: Some(stated),
                ..SetupInput::default()
            };
            let stated = stated.resolve().ok()?;
            let mut options = self.options.clone().with_ball_of(&stated.options);
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

#[cfg(test)]
mod tests {
    use crate::setup::Settings;
    use crate::{analyze_times, ball, demo};

    /// The answers for a tennis ball are those of an analysis of a tennis ball, also where a few impacts leave the
    /// restitution law open.
    #[test]
    fn contrasts_are_the_answers_for_that_ball() {
        let setup = Settings::default().resolve(true).unwrap();
        let tennis = ball::preset("tennis").unwrap();
        let tennis = setup.options.clone().with_preset(tennis);
        let times_s: Vec<f64> = demo::history()
            .unwrap()
            .impact_events()
            .map(|strike| strike.time_s)
            .collect();
        for count in [5, times_s.len()] {
            let drop = &analyze_times(&times_s[..count], &setup.options).drops[0];
            let contrast = setup.ball_contrasts(drop)[0];
            let drop = &analyze_times(&times_s[..count], &tennis).drops[0];
            let found = drop.posterior.as_ref().unwrap();
            for (contrast, found) in [
                (contrast.restitution, found.restitution),
                (contrast.drop_height_m, found.drop_height_m),
            ] {
                let off = (contrast.value - found.value).abs() / found.sd;
                let ratio = contrast.sd / found.sd;
                assert!(
                    off < 0.25 && (0.7..1.4).contains(&ratio),
                    "{count}: {off} {ratio}"
                );
            }
        }
    }
}
