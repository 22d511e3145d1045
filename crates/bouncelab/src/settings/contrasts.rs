//! How the results of a drop depend on the ball, where none was given.

use super::{Settings, Setup};
use crate::analysis::{Drop, analyze_impacts};
use crate::estimate::Estimate;
use crate::inference::SamplerConfig;

/// The results of a drop for a ball that may have been dropped, where none was given.
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
    /// How the results of a drop depend on the ball: what they would be for a tennis ball and for a steel
    /// ball of 20 mm. Empty without a posterior.
    ///
    /// A fifth of the usual draws takes some ten milliseconds: values and standard uncertainties are those of
    /// an analysis with that ball to about a tenth of the uncertainty.
    ///
    /// ```
    /// use bouncelab::{analyze_times, demo, settings::Settings};
    ///
    /// let times_s: Vec<f64> = demo::history()?.impact_events().map(|strike| strike.time_s).collect();
    /// let setup = Settings::default().resolve()?;
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
        let with = |(ball, kind): (&'static str, &str)| {
            let (_, other) = Settings::of_ball(kind).ball.known().ok()?;
            let mut options = self.options.clone().with_ball(other);
            options.compares_balls = false;
            let sampler = SamplerConfig {
                draws: DRAWS,
                ..SamplerConfig::default()
            };
            let drop = analyze_impacts(drop.impacts.clone(), &options.with_sampler(sampler));
            let posterior = drop.posterior.ok()?;
            Some(BallContrast {
                ball,
                restitution: posterior.restitution,
                drop_height_m: posterior.drop_height_m,
            })
        };
        let balls = [("tennis", "tennis"), ("steel", "steel:0.02")];
        balls.into_iter().filter_map(with).collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::settings::Settings;
    use crate::{analyze_times, ball, demo};

    /// The results for a tennis ball are those of an analysis with a tennis ball, also where few impacts leave the
    /// restitution law open.
    #[test]
    fn contrasts_are_the_results_for_that_ball() {
        let setup = Settings::default().resolve().unwrap();
        let tennis = ball::preset("tennis").unwrap();
        let tennis = setup.options.clone().with_ball(tennis);
        let times_s: Vec<f64> = demo::history()
            .unwrap()
            .impact_events()
            .map(|strike| strike.time_s)
            .collect();
        for count in [5, times_s.len()] {
            let drop = &analyze_times(&times_s[..count], &setup.options).drops[0];
            let contrast = setup.ball_contrasts(drop)[0];
            let drop = &analyze_times(&times_s[..count], &tennis).drops[0];
            let full = drop.posterior.as_ref().unwrap();
            for (contrast, full) in [
                (contrast.restitution, full.restitution),
                (contrast.drop_height_m, full.drop_height_m),
            ] {
                let off = (contrast.value - full.value).abs() / full.sd;
                let ratio = contrast.sd / full.sd;
                assert!(
                    off < 0.25 && (0.7..1.4).contains(&ratio),
                    "{count}: {off} {ratio}"
                );
            }
        }
    }
}
