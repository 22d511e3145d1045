//! Variance components of several crossed factors.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::quantile::{chi_squared, interval95};
use super::reml::{Design, Fit};
use crate::error::{Error, InferenceFailure, Result};
use crate::inference::Measured;
use crate::stats::mean;

/// Something noted of each drop that takes a few values: the ball, the surface, the operator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Factor {
    /// What it is.
    pub name: String,
    /// Its values.
    pub levels: Vec<String>,
}

/// A drop: its value with its own error, and where it stands in each factor.
#[derive(Debug, Clone, PartialEq)]
pub struct Drop {
    /// Value and standard error.
    pub measured: Measured,
    /// Level of each factor, in the order of the factors; `None` where it was not noted.
    pub levels: Vec<Option<usize>>,
}

/// A variance component.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Component {
    /// Standard deviation.
    pub sd: f64,
    /// Its 95 % interval by the profile of the restricted likelihood; `None` if it has no upper end
    /// within reason, as for a factor of two levels.
    pub sd95: Option<[f64; 2]>,
}

/// A linear mixed model, fitted by restricted maximum likelihood (Patterson and Thompson 1971).
///
/// The value of a drop is the mean of its fixed level, or a straight line at its amount, plus a normal
/// deviation for its level of each random factor, plus a normal deviation of its own, plus its known
/// error. Factors may be crossed, nested or unbalanced.
#[derive(Debug, Clone)]
pub struct Mixed {
    design: Design,
    /// Of the drops, then of the random factors.
    variances: Vec<f64>,
    fit: Fit,
    /// `None` where the values do not tell how well the variances are known.
    doubt: Option<Doubt>,
}

/// How much the variances are in doubt.
#[derive(Debug, Clone)]
struct Doubt {
    /// Covariance of their logarithms, of those that do not stand at zero.
    covariance: DMatrix<f64>,
    /// How the covariance of the fixed effects answers to each.
    answers: Vec<DMatrix<f64>>,
}

impl Mixed {
    /// Fits the model: `fixed` is the factor whose levels get a mean each (`None`: one mean for
    /// all), `random` the factors that vary. Drops without a noted level of the fixed factor are
    /// left out.
    ///
    /// # Errors
    /// [`Error::TooFewDrops`] unless there are at least two more drops than means,
    /// [`Error::OutOfRange`] for values that are not finite.
    ///
    /// ```
    /// use bouncelab::groups::{Drop, Factor, Mixed};
    /// use bouncelab::inference::Measured;
    ///
    /// let factor = Factor { name: "surface".to_owned(), levels: vec!["steel".to_owned(), "wood".to_owned()] };
    /// let drops: Vec<Drop> = [(0, 0.930), (0, 0.934), (0, 0.931), (1, 0.880), (1, 0.884), (1, 0.879)]
    ///     .map(|(level, value)| Drop { measured: Measured { value, sd: 0.001 }, levels: vec![Some(level)] })
    ///     .into();
    /// let fit = Mixed::fit(&drops, &[factor], Some(0), &[])?;
    /// assert!((fit.mean(0).value - 0.9317).abs() < 1e-3);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn fit(
        drops: &[Drop],
        factors: &[Factor],
        fixed: Option<usize>,
        random: &[usize],
    ) -> Result<Self> {
        let levels = fixed.map_or(1, |factor| factors[factor].levels.len());
        let level = |drop: &Drop| fixed.map_or(Some(0), |factor| drop.levels[factor]);
        let effects = drops.iter().map(|drop| Some(vec![(level(drop)?, 1.0)]));
        Self::greatest(Design::new(drops, factors, effects, levels, random)?)
    }

    /// Fits the model with a straight line: each drop stands at an amount, those without one are left
    /// out, the factors in `random` vary.
    ///
    /// # Errors
    /// [`Error::TooFewDrops`] for fewer than four drops, [`Error::CannotInfer`] if all of them stand
    /// at the same amount, [`Error::OutOfRange`] for values that are not finite.
    pub(super) fn line(
        drops: &[Drop],
        factors: &[Factor],
        amounts: &[Option<f64>],
        random: &[usize],
    ) -> Result<Self> {
        let known: Vec<f64> = amounts.iter().copied().flatten().collect();
        let middle = mean(&known);
        let effects = amounts.iter();
        let effects = effects.map(|amount| Some(vec![(0, 1.0), (1, (*amount)? - middle)]));
        Self::greatest(Design::new(drops, factors, effects, 2, random)?)
    }

    /// How much the value of a line grows for each unit of the amount, its standard error, and the
    /// degrees of freedom of that.
    pub(super) fn slope(&self) -> (Measured, f64) {
        self.contrast(&DVector::from_vec(vec![0.0, 1.0]))
    }

    fn greatest(design: Design) -> Result<Self> {
        let (variances, fit) = design
            .greatest()
            .ok_or(Error::CannotInfer(InferenceFailure::Confounded))?;
        Ok(Self {
            doubt: Doubt::of(&design, &variances),
            design,
            variances,
            fit,
        })
    }

    /// How many drops it is of.
    pub fn drops(&self) -> usize {
        self.design.drops()
    }

    /// The mean of a level of the fixed factor, with its standard error.
    pub fn mean(&self, level: usize) -> Measured {
        Measured {
            value: self.fit.effects[level] + self.design.origin,
            sd: self.fit.covariance[(level, level)].sqrt(),
        }
    }

    /// The 95 % interval of the mean of a level.
    pub fn mean95(&self, level: usize) -> [f64; 2] {
        let mut contrast = DVector::zeros(self.design.fixed_effects());
        contrast[level] = 1.0;
        interval95(self.mean(level), self.degrees(&contrast))
    }

    /// Mean of level `a` less mean of level `b`, its standard error, and the degrees of freedom of
    /// that.
    pub(super) fn difference(&self, a: usize, b: usize) -> (Measured, f64) {
        let mut contrast = DVector::zeros(self.design.fixed_effects());
        contrast[a] = 1.0;
        contrast[b] = -1.0;
        self.contrast(&contrast)
    }

    fn contrast(&self, contrast: &DVector<f64>) -> (Measured, f64) {
        let measured = Measured {
            value: contrast.dot(&self.fit.effects),
            sd: variance(&self.fit.covariance, contrast).sqrt(),
        };
        (measured, self.degrees(contrast))
    }

    /// The scatter between drops of the same levels, beyond their own errors.
    pub fn between_drops(&self) -> Component {
        self.component(0)
    }

    /// The scatter between the levels of a random factor, by its place in the list given.
    pub fn between_levels(&self, random: usize) -> Component {
        self.component(1 + random)
    }

    fn component(&self, place: usize) -> Component {
        Component {
            sd: self.variances[place].sqrt(),
            sd95: self.profile(place),
        }
    }

    /// Where the restricted log-likelihood, the other variances at their best, lies within half the
    /// 95 % quantile of chi-squared with one degree of freedom.
    fn profile(&self, place: usize) -> Option<[f64; 2]> {
        /// Upper limit of a standard deviation, as a multiple of the spread of the values.
        const FARTHEST: f64 = 100.0;
        /// Where a best of zero begins to be left, as a part of the spread.
        const NEAREST: f64 = 1e-3;
        /// Below this log-likelihood relative to the cut the profile is flat to rounding.
        const DEEP: f64 = -10.0;
        let cut = self.fit.log_likelihood - 0.5 * chi_squared(0.95, 1.0);
        let above = |sd: f64| {
            let mut variances = self.variances.clone();
            variances[place] = sd * sd;
            let best = self.design.climb(variances, Some(place));
            best.map_or(DEEP, |(_, fit)| (fit.log_likelihood - cut).max(DEEP))
        };
        let farthest = self.design.scale * FARTHEST;
        let at_farthest = above(farthest);
        if at_farthest >= 0.0 {
            return None;
        }
        let best = self.variances[place].sqrt();
        let top = (best, self.fit.log_likelihood - cut);
        let zero = (0.0, above(0.0));
        let low = if zero.1 >= 0.0 {
            0.0
        } else {
            crossing(zero, top, above)
        };
        let mut inside = top;
        let mut outside = (farthest, at_farthest);
        let mut next = (2.0 * best).max(NEAREST * self.design.scale);
        while next < farthest {
            let found = (next, above(next));
            if found.1 < 0.0 {
                outside = found;
                break;
            }
            inside = found;
            next *= 2.0;
        }
        Some([low, crossing(inside, outside, above)])
    }

    /// Degrees of freedom of a contrast of the means (Satterthwaite 1946; Giesbrecht and Burns
    /// 1985): from how its variance answers to the variance components, and how well those are known.
    fn degrees(&self, contrast: &DVector<f64>) -> f64 {
        let most = (self.drops() - self.design.fixed_effects()) as f64;
        let known = self.doubt.as_ref().map(|doubt| {
            let answers = doubt
                .answers
                .iter()
                .map(|answer| variance(answer, contrast));
            let answers = DVector::from_iterator(doubt.answers.len(), answers);
            2.0 * variance(&self.fit.covariance, contrast).powi(2)
                / variance(&doubt.covariance, &answers)
        });
        known
            .filter(|degrees| *degrees > 0.0)
            .unwrap_or(most)
            .clamp(1.0, most)
    }
}

impl Doubt {
    /// By small changes of each variance.
    fn of(design: &Design, variances: &[f64]) -> Option<Self> {
        /// A component this far below the largest stands at zero and is not counted.
        const NONE: f64 = 1e-6;
        const STEP: f64 = 0.02;
        let largest = variances.iter().copied().fold(0.0, f64::max);
        let free: Vec<usize> = (0..variances.len())
            .filter(|&place| variances[place] > NONE * largest)
            .collect();
        let mut information = DMatrix::zeros(free.len(), free.len());
        let mut answers = Vec::with_capacity(free.len());
        for (row, &place) in free.iter().enumerate() {
            let moved = |share: f64| {
                let mut variances = variances.to_vec();
                variances[place] *= 1.0 + share;
                design.fit(&variances)
            };
            let (more, less) = (moved(STEP)?, moved(-STEP)?);
            answers.push((more.covariance - less.covariance) / (2.0 * STEP));
            let bend = (less.score - more.score) / (2.0 * STEP);
            for (column, &other) in free.iter().enumerate() {
                information[(row, column)] = bend[other] * variances[other];
            }
        }
        let covariance = Cholesky::new(information)?.inverse();
        Some(Self {
            covariance,
            answers,
        })
    }
}

/// The variance of a contrast of values with a covariance.
fn variance(covariance: &DMatrix<f64>, contrast: &DVector<f64>) -> f64 {
    contrast.dot(&(covariance * contrast))
}

/// The place between two others at which a function is zero, which is above zero at one of them and below at the
/// other: by secants, of which the end that stays counts half (M. Dowell and P. Jarratt, BIT 11, 168, 1971).
fn crossing(mut one: (f64, f64), mut other: (f64, f64), function: impl Fn(f64) -> f64) -> f64 {
    const NEAR: f64 = 1e-6;
    const STEPS: usize = 60;
    for _ in 0..STEPS {
        let place = (one.0 * other.1 - other.0 * one.1) / (other.1 - one.1);
        let found = (place, function(place));
        if found.1.abs() < NEAR {
            return place;
        }
        if (found.1 < 0.0) == (other.1 < 0.0) {
            one.1 *= 0.5;
        } else {
            one = other;
        }
        other = found;
    }
    other.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factor(name: &str, levels: usize) -> Factor {
        Factor {
            name: name.to_owned(),
            levels: (0..levels).map(|level| level.to_string()).collect(),
        }
    }

    fn drop(value: f64, levels: &[usize]) -> Drop {
        Drop {
            measured: Measured { value, sd: 0.0 },
            levels: levels.iter().copied().map(Some).collect(),
        }
    }

    #[track_caller]
    fn close(value: f64, published: f64, tolerance: f64) {
        assert!((value - published).abs() < tolerance, "{value} {published}");
    }

    /// Yield of dyestuff from six batches (Davies and Goldsmith 1972, Table 6.1).
    const DYESTUFF: [[f64; 5]; 6] = [
        [1545.0, 1440.0, 1440.0, 1520.0, 1580.0],
        [1540.0, 1555.0, 1490.0, 1560.0, 1495.0],
        [1595.0, 1550.0, 1605.0, 1510.0, 1560.0],
        [1445.0, 1440.0, 1595.0, 1465.0, 1545.0],
        [1595.0, 1630.0, 1515.0, 1635.0, 1625.0],
        [1520.0, 1455.0, 1450.0, 1480.0, 1445.0],
    ];

    /// The R package lme4, `lmer(Yield ~ 1 + (1 | Batch), Dyestuff)`: between batches 42.00, within
    /// 49.51, mean 1527.50 with standard error 19.38.
    #[test]
    fn dyestuff_varies_by_batch_and_within() {
        let drops: Vec<Drop> = DYESTUFF
            .iter()
            .enumerate()
            .flat_map(|(batch, yields)| yields.map(|value| drop(value, &[batch])))
            .collect();
        let fit = Mixed::fit(&drops, &[factor("batch", 6)], None, &[0]).unwrap();
        close(fit.between_levels(0).sd, 42.00, 0.01);
        close(fit.between_drops().sd, 49.51, 0.01);
        close(fit.mean(0).value, 1527.5, 1e-6);
        close(fit.mean(0).sd, 19.38, 0.01);
        // Balanced data: the mean varies by batch alone, so t has 5 degrees of freedom.
        let [low, high] = fit.mean95(0);
        close(0.5 * (high - low), 2.5706 * 19.383, 0.2);
        let [low, high] = fit.between_drops().sd95.unwrap();
        assert!(
            low > 36.0 && low < 40.0 && high > 66.0 && high < 71.0,
            "{low} {high}"
        );
    }

    /// Yield of penicillin by treatment and blend (Box, Hunter and Hunter 1978, Table 7.2), analysed
    /// by J. Faraway with lme4: between blends 3.43, within 4.34, means of the treatments 84, 85, 89,
    /// 86, standard error of a mean 2.48, of a difference 2.75.
    #[test]
    fn penicillin_differs_little_by_treatment() {
        let yields = [
            [89.0, 84.0, 81.0, 87.0, 79.0],
            [88.0, 77.0, 87.0, 92.0, 81.0],
            [97.0, 92.0, 87.0, 89.0, 80.0],
            [94.0, 79.0, 85.0, 84.0, 88.0],
        ];
        let mut drops = Vec::new();
        for (treatment, of_blend) in yields.iter().enumerate() {
            for (blend, &value) in of_blend.iter().enumerate() {
                drops.push(drop(value, &[treatment, blend]));
            }
        }
        let factors = [factor("treatment", 4), factor("blend", 5)];
        let fit = Mixed::fit(&drops, &factors, Some(0), &[1]).unwrap();
        close(fit.between_levels(0).sd, 3.43, 0.01);
        close(fit.between_drops().sd, 4.34, 0.01);
        for (level, mean) in [84.0, 85.0, 89.0, 86.0].into_iter().enumerate() {
            close(fit.mean(level).value, mean, 1e-6);
            close(fit.mean(level).sd, 2.48, 0.01);
        }
        let (difference, degrees) = fit.difference(2, 0);
        close(difference.value, 5.0, 1e-6);
        close(difference.sd, 2.75, 0.01);
        // Blends cancel: the residual line of the analysis of variance has 12.
        close(degrees, 12.0, 0.1);
    }

    /// With one mean and no factor it is the random-effects mean.
    #[test]
    fn without_factors_it_is_the_mean() {
        let measured = [(0.92, 0.002), (0.93, 0.004), (0.915, 0.001), (0.926, 0.003)]
            .map(|(value, sd)| Measured { value, sd });
        let drops = measured.map(|measured| Drop {
            measured,
            levels: Vec::new(),
        });
        let fit = Mixed::fit(&drops, &[], None, &[]).unwrap();
        let mean = super::super::Mean::of(&measured).unwrap();
        close(fit.mean(0).value, mean.value, 1e-6);
        close(fit.between_drops().sd, mean.between.unwrap(), 1e-6);
    }

    /// Forbes' boiling points of water (1857, in Weisberg, *Applied Linear Regression*): 100 log10 of
    /// the pressure over the temperature has, in R, slope 0.8955 with standard error 0.0164 and 15
    /// degrees of freedom.
    #[test]
    fn a_line_without_factors_is_least_squares() {
        let points = [
            (194.5, 131.79),
            (194.3, 131.79),
            (197.9, 135.02),
            (198.4, 135.55),
            (199.4, 136.46),
            (199.9, 136.83),
            (200.9, 137.82),
            (201.1, 138.00),
            (201.4, 138.06),
            (201.3, 138.05),
            (203.6, 140.04),
            (204.6, 142.44),
            (209.5, 145.47),
            (208.6, 144.34),
            (210.7, 146.30),
            (211.9, 147.54),
            (212.2, 147.80),
        ];
        let drops = points.map(|(_, value)| drop(value, &[]));
        let amounts = points.map(|(amount, _)| Some(amount));
        let (slope, degrees) = Mixed::line(&drops, &[], &amounts, &[]).unwrap().slope();
        close(slope.value, 0.8955, 5e-5);
        close(slope.sd, 0.0164, 1e-4);
        close(degrees, 15.0, 1e-2);
    }

    /// Each ball has its own level, and was dropped at other temperatures: the line of each is what
    /// counts.
    #[test]
    fn a_line_compares_like_with_like() {
        let drops: Vec<Drop> = (0..24)
            .map(|n| {
                let (ball, kelvin) = (n % 3, f64::from(n as u8 / 3) + 5.0 * (n % 3) as f64);
                let value = 0.9 - 0.05 * ball as f64 + 0.001 * kelvin;
                drop(value + 1e-4 * f64::from(n as u8 % 5), &[ball])
            })
            .collect();
        let amounts: Vec<Option<f64>> = (0..24)
            .map(|n| Some(f64::from(n / 3) + 5.0 * f64::from(n % 3)))
            .collect();
        let line = |random: &[usize]| {
            let fit = Mixed::line(&drops, &[factor("ball", 3)], &amounts, random);
            fit.unwrap().slope().0.value
        };
        assert!(line(&[]) < -0.003);
        close(line(&[0]), 0.001, 1e-4);
    }

    #[test]
    fn drops_at_one_amount_tell_no_slope() {
        let drops = [1.0, 1.1, 0.9, 1.0, 1.2].map(|value| drop(value, &[]));
        let fit = Mixed::line(&drops, &[], &[Some(3.0); 5], &[]);
        assert!(matches!(fit.unwrap_err(), Error::CannotInfer(_)));
        assert!(Mixed::line(&drops, &[], &[None; 5], &[]).is_err());
    }

    /// The variance between two levels whose drops agree exactly is half of the square of their difference, and the
    /// mean is known by two values.
    #[test]
    fn levels_whose_drops_agree_exactly_vary_by_their_difference() {
        let drops: Vec<Drop> = (0..6)
            .map(|n| drop(0.9 + 0.01 * f64::from(n % 2), &[n as usize % 2]))
            .collect();
        let fit = Mixed::fit(&drops, &[factor("ball", 2)], None, &[0]).unwrap();
        close(fit.between_levels(0).sd, 0.01 / 2_f64.sqrt(), 1e-6);
        close(fit.between_drops().sd, 0.0, 1e-6);
        close(fit.mean(0).sd, 0.005, 1e-6);
        let [low, high] = fit.mean95(0);
        close(0.5 * (high - low), 12.706 * 0.005, 1e-3);
    }

    #[test]
    fn a_factor_of_two_levels_tells_no_upper_end() {
        let drops = [
            drop(1.0, &[0]),
            drop(1.1, &[0]),
            drop(0.9, &[0]),
            drop(2.0, &[1]),
            drop(2.1, &[1]),
            drop(1.9, &[1]),
        ];
        let fit = Mixed::fit(&drops, &[factor("ball", 2)], None, &[0]).unwrap();
        let between = fit.between_levels(0);
        close(between.sd, 0.7047, 1e-3);
        assert!(between.sd95.is_none_or(|[_, high]| high > 5.0));
    }

    #[test]
    fn too_few_drops_are_refused() {
        let drops = [drop(1.0, &[0]), drop(2.0, &[1])];
        let refused = Mixed::fit(&drops, &[factor("ball", 2)], Some(0), &[]);
        assert!(matches!(
            refused.unwrap_err(),
            Error::TooFewDrops {
                needed: 4,
                drops: 2
            }
        ));
    }
}
