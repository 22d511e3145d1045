//! The mean of several rebounds, with its budget of uncertainty after the Guide to the expression of uncertainty in
//! measurement (JCGM 100:2008).
//!
//! Drops of the same ball share what is not known of the ball, the air, gravity and the height of release, so that a mean
//! does not make that smaller; how drops differ shows in their scatter.

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use super::rebound::Rebound;
use super::rule::{Limits, Rule};
use crate::analysis::Options;
use crate::estimate::Estimate;
use crate::stats;

/// What makes a measured height uncertain.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Cause {
    /// The time between two impacts includes a contact.
    Contact,
    /// The air carries the ball and moves with it: effective gravity is weaker.
    Buoyancy,
    /// Drag shortens the flight.
    Drag,
    /// Gravity of the place.
    Gravity,
    /// The height of release: the rebound is proportional to it.
    Release,
    /// The times of the two impacts.
    Times,
    /// Scatter of the drops, which the errors of the times are part of.
    Scatter,
    /// Scatter of single impacts that is assumed, since one drop shows none.
    AssumedScatter,
}

impl Cause {
    /// Its name in data.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::Buoyancy => "buoyancy",
            Self::Drag => "drag",
            Self::Gravity => "gravity",
            Self::Release => "release",
            Self::Times => "times",
            Self::Scatter => "scatter",
            Self::AssumedScatter => "assumed-scatter",
        }
    }

    /// Whether it differs from drop to drop, and not for all in the same way.
    const fn averages_out(self) -> bool {
        matches!(self, Self::Times | Self::Scatter | Self::AssumedScatter)
    }
}

/// One source of the uncertainty of a mean.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Component {
    /// The source.
    pub cause: Cause,
    /// What it corrects g T²/8 by, m; 0 where the formula of the rule decides.
    pub correction_m: f64,
    /// Standard uncertainty of the mean that it makes, m.
    pub sd_m: f64,
    /// Degrees of freedom of this uncertainty; infinite unless it is the scatter of drops.
    pub degrees_of_freedom: f64,
}

/// The mean rebound over the drops on a surface, by the procedure of a rule.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MeanRebound {
    /// The mean, m, of the point at which the rule measures.
    pub height_m: Estimate,
    /// The sources of its uncertainty.
    pub budget: Vec<Component>,
    pub(super) spread: Spread,
}

impl MeanRebound {
    /// The mean of drops of which all have a height; `None` without one.
    pub(super) fn new(
        drops: &[Rebound],
        fall_m: Option<f64>,
        rule: &Rule,
        settings: &Options,
    ) -> Option<Self> {
        let heights_m: Vec<f64> = drops
            .iter()
            .map(|drop| drop.height_m)
            .collect::<Option<_>>()?;
        if heights_m.is_empty() {
            return None;
        }
        let mean_m = stats::mean(&heights_m);
        let mut budget = shared(drops, mean_m, fall_m, rule, settings);
        budget.extend(of_each(drops, &heights_m, mean_m, settings));
        let spread = Spread::of_budget(mean_m, &budget, |_| true);
        Some(Self {
            height_m: spread.estimate(),
            budget,
            spread,
        })
    }

    /// The ratio to another of the same ball in the same air, where gravity and buoyancy cancel. All else is taken
    /// as independent, which overstates the uncertainty.
    pub(super) fn over(&self, reference: &Self) -> Spread {
        let differs = |cause| !matches!(cause, Cause::Gravity | Cause::Buoyancy);
        let [above, below] = [self, reference]
            .map(|mean| Spread::of_budget(mean.height_m.value, &mean.budget, differs));
        above.over(&below)
    }
}

/// What is the same for all drops.
fn shared(
    drops: &[Rebound],
    mean_m: f64,
    fall_m: Option<f64>,
    rule: &Rule,
    settings: &Options,
) -> Vec<Component> {
    let priors = &settings.priors;
    let component = |cause, correction_m, sd_m| Component {
        cause,
        correction_m,
        sd_m,
        degrees_of_freedom: f64::INFINITY,
    };
    let mut budget = Vec::new();
    if rule.formula.is_none() {
        let corrections: [f64; 3] = std::array::from_fn(|step| {
            stats::mean(
                &drops
                    .iter()
                    .map(|drop| drop.corrections_m[step])
                    .collect::<Vec<_>>(),
            )
        });
        // Air displaced over mass of the ball: ρ d³/m, of which added mass has a third of the effect, (1 - r)/(1 + r/2).
        let displaced = (priors.air_density_rel_sd.powi(2)
            + (3.0 * priors.diameter_rel_sd).powi(2)
            + priors.mass_rel_sd.powi(2)
            + (priors.added_mass_rel_sd / 3.0).powi(2))
        .sqrt();
        // Drag over weight: C_D ρ d²/m.
        let drag = (priors.drag_rel_sd.powi(2)
            + priors.air_density_rel_sd.powi(2)
            + (2.0 * priors.diameter_rel_sd).powi(2)
            + priors.mass_rel_sd.powi(2))
        .sqrt();
        let known = [priors.contact_time_rel_sd, displaced, drag];
        let causes = [Cause::Contact, Cause::Buoyancy, Cause::Drag];
        for ((cause, correction_m), relative) in causes.into_iter().zip(corrections).zip(known) {
            budget.push(component(
                cause,
                correction_m,
                correction_m.abs() * relative,
            ));
        }
        budget.push(component(
            Cause::Gravity,
            0.0,
            mean_m * priors.gravity_rel_sd,
        ));
    }
    if let (Some(released), Some(fall_m)) = (priors.drop_height_m, fall_m) {
        budget.push(component(
            Cause::Release,
            0.0,
            mean_m * released.sd / fall_m,
        ));
    }
    budget
}

/// What differs from drop to drop: their scatter if there are several and it is larger than the errors of the times, which
/// it includes. Of one drop the scatter of the restitution is assumed, of which a rebound has twice as much.
fn of_each(
    drops: &[Rebound],
    heights_m: &[f64],
    mean_m: f64,
    settings: &Options,
) -> Vec<Component> {
    let count = heights_m.len() as f64;
    let times_m = drops
        .iter()
        .map(|drop| drop.times_sd_m.powi(2))
        .sum::<f64>()
        .sqrt()
        / count;
    let component = |cause, sd_m, degrees_of_freedom| Component {
        cause,
        correction_m: 0.0,
        sd_m,
        degrees_of_freedom,
    };
    if heights_m.len() == 1 {
        let assumed_m = 2.0 * settings.priors.restitution_scatter * mean_m;
        return vec![
            component(Cause::Times, times_m, f64::INFINITY),
            component(Cause::AssumedScatter, assumed_m, f64::INFINITY),
        ];
    }
    // Sample standard deviation over the root of the count.
    let scatter_m = stats::sd(heights_m) / (count - 1.0).sqrt();
    vec![component(
        Cause::Scatter,
        scatter_m.max(times_m),
        count - 1.0,
    )]
}

/// A value whose uncertainty is in part the same for all drops and in part their scatter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spread {
    pub(super) value: f64,
    /// Variance of what is the same for all drops.
    pub(super) shared: f64,
    /// Variance of the mean from what differs between them.
    pub(super) scatter: f64,
    /// Degrees of freedom of the scatter.
    pub(super) degrees: f64,
}

impl Spread {
    fn of_budget(value: f64, budget: &[Component], counts: impl Fn(Cause) -> bool) -> Self {
        let of = |averages_out: bool| {
            let part = budget
                .iter()
                .filter(|part| counts(part.cause) && part.cause.averages_out() == averages_out);
            part.map(|part| part.sd_m.powi(2)).sum::<f64>()
        };
        let degrees = budget.iter().map(|part| part.degrees_of_freedom);
        Self {
            value,
            shared: of(false),
            scatter: of(true),
            degrees: degrees.fold(f64::INFINITY, f64::min),
        }
    }

    /// A single drop, whose own rebound counts: nothing of it is scatter.
    pub(super) fn of_drop(&self, height_m: f64, times_sd_m: f64) -> Self {
        Self {
            value: height_m,
            shared: self.shared,
            scatter: times_sd_m.powi(2),
            degrees: f64::INFINITY,
        }
    }

    /// The mean of estimates that share their uncertainty, and their scatter.
    pub(super) fn of_estimates(estimates: &[Estimate]) -> Self {
        let values: Vec<f64> = estimates.iter().map(|estimate| estimate.value).collect();
        let sds: Vec<f64> = estimates.iter().map(|estimate| estimate.sd).collect();
        let several = values.len() > 1;
        Self {
            value: stats::mean(&values),
            shared: stats::mean(&sds).powi(2),
            scatter: if several {
                stats::sd(&values).powi(2) / (values.len() as f64 - 1.0)
            } else {
                0.0
            },
            degrees: if several {
                values.len() as f64 - 1.0
            } else {
                f64::INFINITY
            },
        }
    }

    pub(super) fn over(&self, below: &Self) -> Self {
        let value = self.value / below.value;
        let square = value.powi(2);
        let relative = |variance: f64, of: &Self| variance / of.value.powi(2);
        let scatters = [relative(self.scatter, self), relative(below.scatter, below)];
        Self {
            value,
            shared: square * (relative(self.shared, self) + relative(below.shared, below)),
            scatter: square * (scatters[0] + scatters[1]),
            degrees: effective([(scatters[0], self.degrees), (scatters[1], below.degrees)]),
        }
    }

    /// The same with the scatter of a mean of `count` drops in place of `now`, from whose deviations `means`
    /// means were estimated.
    pub(super) fn with_drops(&self, now: usize, count: usize, means: usize) -> Self {
        Self {
            scatter: self.scatter * now as f64 / count as f64,
            degrees: count as f64 - means as f64,
            ..*self
        }
    }

    pub(super) fn sd(&self) -> f64 {
        (self.shared + self.scatter).sqrt()
    }

    /// Effective degrees of freedom (Welch-Satterthwaite), truncated to an integer (JCGM 100:2008, G.4.1): the formula is
    /// too optimistic where they are few.
    fn degrees_of_freedom(&self) -> f64 {
        effective([(self.shared, f64::INFINITY), (self.scatter, self.degrees)])
            .floor()
            .max(1.0)
    }

    pub(super) fn estimate(&self) -> Estimate {
        match self.student() {
            Some(_) => Estimate::student(self.value, self.sd(), self.degrees_of_freedom()),
            None => Estimate::normal(self.value, self.sd()),
        }
    }

    /// Student's t, unless the uncertainty is known so well that it is a normal distribution.
    fn student(&self) -> Option<StudentsT> {
        /// Beyond this the two agree to 1e-5.
        const NORMAL: f64 = 1e5;
        let degrees = self.degrees_of_freedom();
        (degrees < NORMAL)
            .then(|| StudentsT::new(0.0, 1.0, degrees).ok())
            .flatten()
    }

    /// Probability of being within limits.
    pub(super) fn within(&self, limits: &Limits) -> f64 {
        let sd = self.sd();
        if sd == 0.0 {
            return f64::from(u8::from(limits.contain(self.value)));
        }
        let below = |end: f64| {
            let steps = (end - self.value) / sd;
            self.student().map_or_else(
                || Normal::standard().cdf(steps),
                |student| student.cdf(steps),
            )
        };
        limits.greatest.map_or(1.0, below) - limits.least.map_or(0.0, below)
    }

    /// How far inside a limit a value must be to be outside with at most this probability.
    pub(super) fn guard(&self, risk: f64) -> f64 {
        let steps = self.student().map_or_else(
            || Normal::standard().inverse_cdf(1.0 - risk),
            |student| student.inverse_cdf(1.0 - risk),
        );
        steps * self.sd()
    }
}

fn effective(parts: [(f64, f64); 2]) -> f64 {
    let sum: f64 = parts.iter().map(|(variance, _)| variance).sum();
    let weights: f64 = parts
        .iter()
        .map(|(variance, degrees)| variance.powi(2) / degrees)
        .sum();
    if weights > 0.0 {
        sum.powi(2) / weights
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: Spread = Spread {
        value: 10.0,
        shared: 9.0,
        scatter: 16.0,
        degrees: 4.0,
    };

    /// 25²/(16²/4) = 9.77 degrees of freedom, truncated to 9.
    #[test]
    fn degrees_of_freedom_are_those_of_welch_and_satterthwaite() {
        assert!((ONE.sd() - 5.0).abs() < 1e-12);
        assert!((ONE.degrees_of_freedom() - 9.0).abs() < 1e-12);
        let [low, high] = ONE.estimate().interval95;
        // Student's t of 9 degrees of freedom: 2.262.
        assert!(((high - low) / 2.0 / 5.0 - 2.262).abs() < 0.001);
    }

    /// Four times the drops halve the scatter; what they share stays.
    #[test]
    fn what_is_shared_does_not_average_out() {
        let more = ONE.with_drops(5, 20, 1);
        assert!((more.sd() - 13.0_f64.sqrt()).abs() < 1e-12);
    }

    /// Relative variances add up: 0.09 + 0.16 of the numerator, nothing of an exact denominator.
    #[test]
    fn a_ratio_has_the_relative_uncertainty() {
        let exact = Spread {
            value: 2.0,
            shared: 0.0,
            scatter: 0.0,
            degrees: f64::INFINITY,
        };
        let ratio = ONE.over(&exact);
        assert!((ratio.value - 5.0).abs() < 1e-12 && (ratio.sd() - 2.5).abs() < 1e-12);
        assert!((ratio.degrees_of_freedom() - ONE.degrees_of_freedom()).abs() < 1e-9);
    }
}
