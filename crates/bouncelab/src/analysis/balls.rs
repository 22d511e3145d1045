//! Which ball bounced: the evidence of the impact times for each preset.

use super::{Drop, Options, analyze_impacts};
use crate::ball::{self, Preset};
use crate::diagnostic::{Code, Diagnostic};
use crate::estimate::Estimate;
use crate::impact::Impact;
use crate::inference;
use crate::restitution::{ImpactRestitution, PerImpact};
use crate::stats::sort_by_number;

/// Minimum odds for a remark about another ball: "strong" evidence on the scale of H. Jeffreys,
/// *Theory of Probability*, appendix B.
const STRONG: f64 = 10.0;

/// The results of a drop for a preset ball.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct BallComparison {
    /// The name of the preset.
    pub ball: &'static str,
    /// Natural logarithm of the Bayes factor: the evidence of this ball over that of the ball that was
    /// stated or assumed. It is coarsened, as no model is exactly true: n flights count for no more than
    /// n · 50 / (50 + n).
    pub log_bayes_factor: f64,
    /// The restitution, if it was this ball.
    pub restitution: Estimate,
    /// The drop height in metres, if it was this ball.
    pub drop_height_m: Estimate,
}

/// Logarithm of a Bayes factor for a model that is not exactly true: J. W. Miller and D. B. Dunson, "Robust
/// Bayesian inference via coarsening", Journal of the American Statistical Association 114, 1113 (2019); their power of the likelihood, applied to the evidence.
///
/// Without it small faults of the model, which add up over the flights, would decide between balls.
fn coarsened(log_bayes_factor: f64, flights: usize) -> f64 {
    /// Inverse of the expected relative entropy of the model to the truth for each flight: that of a normal scatter to
    /// one of 1.16 times its standard deviation.
    const PRECISION: f64 = 50.0;
    log_bayes_factor * PRECISION / (PRECISION + flights as f64)
}

/// The inference with each preset ball, the best first; empty without a posterior.
///
/// The Bayes factor weighs whole set-ups: mass, diameter, drag and contact time as the preset states
/// them. Balls with the same deceleration by the air cannot be distinguished.
pub(super) fn compare(drop: &Drop, options: &Options) -> Vec<BallComparison> {
    let Ok(stated) = &drop.posterior else {
        return Vec::new();
    };
    let flights = drop.impacts.len().saturating_sub(1);
    let with = |preset: &Preset| {
        let mut options = options.clone().with_ball(preset);
        options.compares_balls = false;
        // Neither the impacts nor doubts of the ball are asked for.
        options
            .inference
            .iter_mut()
            .for_each(|it| it.each_impact = false);
        let found = analyze_impacts(drop.impacts.clone(), &options)
            .posterior
            .ok()?;
        Some(BallComparison {
            ball: preset.name,
            log_bayes_factor: coarsened(found.log_evidence - stated.log_evidence, flights),
            restitution: found.restitution,
            drop_height_m: found.drop_height_m,
        })
    };
    let mut balls: Vec<BallComparison> = ball::presets().iter().filter_map(with).collect();
    sort_by_number(&mut balls, |ball| -ball.log_bayes_factor);
    balls
}

/// A diagnostic if another kind of ball explains the times much better than the one that was stated; `None` if the times
/// cannot tell.
pub(super) fn better(impacts: &[Impact], options: &Options) -> Option<Diagnostic> {
    /// Maximum odds that are reported: beyond this they mean certainty.
    const GREATEST_ODDS: f64 = 1000.0;
    let Options {
        ball,
        environment,
        contact_time_s,
        priors,
        ..
    } = options;
    let kinds = inference::better_kinds(impacts, ball, environment, *contact_time_s, priors);
    let flights = impacts.len().saturating_sub(1);
    let coarsened = |(kind, factor): (&'static str, f64)| (kind, coarsened(factor, flights));
    let kinds: Vec<_> = kinds.ok()?.into_iter().map(coarsened).collect();
    let best = kinds.iter().map(|kind| kind.1).reduce(f64::max)?;
    let odds = best.exp().min(GREATEST_ODDS);
    // Kinds that are nearly as good as the best cannot be distinguished from it.
    let good = kinds.iter().filter(|kind| best - kind.1 < STRONG.ln());
    let names: Vec<&str> = good.map(|kind| kind.0).collect();
    (odds >= STRONG).then(|| {
        let better = Diagnostic::new(Code::OtherBallFitsBetter);
        better
            .with("balls", names.join(", "))
            .with("odds", odds.floor())
    })
}

/// A diagnostic if the corrected restitution rises with the speed: real balls lose the same share or a
/// greater one the faster they are (W. Goldsmith, *Impact*, 1960, chapter 6), so losses of the impacts were
/// attributed to the air.
///
/// The correction for drag is larger for the longer of two flights. If the ratio of flight times, the restitution
/// without correction, rises too, no ball explains it, and there is no diagnostic.
pub(super) fn rising(found: &PerImpact) -> Option<Diagnostic> {
    /// Minimum relative rise.
    const MIN_RISE: f64 = 0.01;
    /// Minimum slope in standard errors: smaller ones occur by chance among many drops.
    const STANDARD_ERRORS: f64 = 4.0;
    const MIN_IMPACTS: usize = 5;
    if found.impacts.len() < MIN_IMPACTS {
        return None;
    }
    let corrected = Trend::of(&found.impacts, |impact| impact.restitution.value);
    let uncorrected = Trend::of(&found.impacts, |impact| impact.flight_time_ratio);
    let [slow, fast] = [found.slowest_m_s?, found.fastest_m_s?].map(|speed| corrected.at(speed));
    let rises = fast > (1.0 + MIN_RISE) * slow
        && corrected.slope > STANDARD_ERRORS * corrected.slope_sd
        && uncorrected.slope < 0.0;
    rises.then(|| {
        let rises = Diagnostic::new(Code::RestitutionRises);
        rises.with("slow", slow).with("fast", fast)
    })
}

/// The straight line through a quantity of the impacts against their speed, by least squares.
struct Trend {
    mean_speed_m_s: f64,
    mean: f64,
    slope: f64,
    slope_sd: f64,
}

impl Trend {
    fn of(impacts: &[ImpactRestitution], quantity: fn(&ImpactRestitution) -> f64) -> Self {
        let count = impacts.len() as f64;
        let mean = |of: fn(&ImpactRestitution) -> f64| impacts.iter().map(of).sum::<f64>() / count;
        let mean_speed_m_s = mean(|impact| impact.impact_speed_m_s);
        let mean = mean(quantity);
        let off = || {
            let both = |impact: &ImpactRestitution| {
                (
                    impact.impact_speed_m_s - mean_speed_m_s,
                    quantity(impact) - mean,
                )
            };
            impacts.iter().map(both)
        };
        let spread: f64 = off().map(|(speed, _)| speed * speed).sum();
        let slope = off().map(|(speed, value)| speed * value).sum::<f64>() / spread;
        let unexplained: f64 = off()
            .map(|(speed, value)| (value - slope * speed).powi(2))
            .sum();
        Self {
            mean_speed_m_s,
            mean,
            slope,
            slope_sd: (unexplained / (count - 2.0) / spread).sqrt(),
        }
    }

    fn at(&self, speed_m_s: f64) -> f64 {
        self.mean + self.slope * (speed_m_s - self.mean_speed_m_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flight::FlightModel;
    use crate::impact::Impact;
    use crate::restitution;

    /// The diagnostic of a drop of this ball from 2.5 m, analysed as the default ball.
    fn said(true_ball: &str, restitution: fn(f64) -> f64) -> Option<Diagnostic> {
        let of = |options: &Options| FlightModel::new(&options.ball, &options.environment).unwrap();
        let stated = Options::default();
        let truth = stated.clone().with_ball(ball::preset(true_ball).unwrap());
        let model = of(&truth);
        let mut speed_m_s = model.fall(2.5).unwrap().impact_speed_m_s;
        let mut time_s = 0.0;
        let impacts: Vec<Impact> = (1..12)
            .map(|number| {
                let impact = Impact::new(number, time_s);
                let flight = model.launch(speed_m_s * restitution(speed_m_s)).unwrap();
                time_s += flight.time_s();
                speed_m_s = flight.impact_speed_m_s;
                impact
            })
            .collect();
        rising(&restitution::of_impacts(&impacts, 0.0, &of(&stated)).unwrap())
    }

    #[test]
    fn a_heavier_ball_than_stated_is_noticed() {
        assert!(said("golf", |_| 0.8).is_some());
        assert!(said("table-tennis-40", |_| 0.8).is_none());
    }

    #[test]
    fn restitution_that_rises_without_correction_too_says_nothing_of_the_ball() {
        assert!(said("golf", |speed_m_s| 0.7 + 0.02 * speed_m_s).is_none());
    }
}
