//! Variance components of several crossed factors.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::mean::{check, climb};
use super::quantile::{chi_squared, interval95};
use crate::error::{Error, InferenceFailure, Result};
use crate::inference::Measured;
use crate::stats::{mean, sd};

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
    /// Standard deviations: of the drops, then of the random factors.
    sds: Vec<f64>,
    fit: Fit,
}

/// The drops in the form in which the likelihood needs them.
#[derive(Debug, Clone)]
struct Design {
    values: Vec<f64>,
    own_variances: Vec<f64>,
    /// For each drop what of which fixed effect it has.
    fixed: Vec<Vec<(usize, f64)>>,
    fixed_effects: usize,
    /// For each drop the columns of its random levels, with the random factor of each.
    columns: Vec<Vec<(usize, usize)>>,
    column_count: usize,
    random_factors: usize,
    /// A length within which all standard deviations lie.
    scale: f64,
    /// Subtracted from the values, so that sums of squares keep their digits.
    origin: f64,
}

/// What the likelihood says for given variances.
#[derive(Debug, Clone)]
struct Fit {
    log_likelihood: f64,
    /// Of the fixed effects: means of levels, or mean and slope.
    effects: DVector<f64>,
    covariance: DMatrix<f64>,
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
        let effects = |(_, drop): (usize, &Drop)| Some(vec![(level(drop)?, 1.0)]);
        let effects = drops.iter().enumerate().map(effects).collect();
        Self::climbed(Design::new(drops, factors, effects, levels, random)?)
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
        Self::climbed(Design::new(drops, factors, effects.collect(), 2, random)?)
    }

    /// How much the value of a line grows for each unit of the amount, its standard error, and the
    /// degrees of freedom of that.
    pub(super) fn slope(&self) -> (Measured, f64) {
        self.contrast(&DVector::from_vec(vec![0.0, 1.0]))
    }

    fn climbed(design: Design) -> Result<Self> {
        let mut sds = vec![design.scale / 4.0; 1 + design.random_factors];
        design.climb_all(&mut sds, None, 40);
        let fit = design
            .fit(&sds)
            .ok_or(Error::CannotInfer(InferenceFailure::Confounded))?;
        Ok(Self { design, sds, fit })
    }

    /// How many drops it is of.
    pub fn drops(&self) -> usize {
        self.design.values.len()
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
        let mut contrast = DVector::zeros(self.design.fixed_effects);
        contrast[level] = 1.0;
        interval95(self.mean(level), self.degrees(&contrast))
    }

    /// Mean of level `a` less mean of level `b`, its standard error, and the degrees of freedom of
    /// that.
    pub(super) fn difference(&self, a: usize, b: usize) -> (Measured, f64) {
        let mut contrast = DVector::zeros(self.design.fixed_effects);
        contrast[a] = 1.0;
        contrast[b] = -1.0;
        self.contrast(&contrast)
    }

    fn contrast(&self, contrast: &DVector<f64>) -> (Measured, f64) {
        let measured = Measured {
            value: contrast.dot(&self.fit.effects),
            sd: contrast.dot(&(&self.fit.covariance * contrast)).sqrt(),
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
            sd: self.sds[place],
            sd95: self.profile(place),
        }
    }

    /// Where the restricted log-likelihood, the other variances at their best, lies within half the
    /// 95 % quantile of chi-squared with one degree of freedom.
    fn profile(&self, place: usize) -> Option<[f64; 2]> {
        /// Beyond so many times the spread of the values no variance makes sense.
        const FARTHEST: f64 = 100.0;
        let cut = self.fit.log_likelihood - 0.5 * chi_squared(0.95, 1.0);
        let within = |sd: f64| {
            let mut sds = self.sds.clone();
            sds[place] = sd;
            let height = self.design.climb_all(&mut sds, Some(place), 4);
            height >= cut
        };
        let high = self.design.scale * FARTHEST;
        if within(high) {
            return None;
        }
        let best = self.sds[place];
        let low = if within(0.0) {
            0.0
        } else {
            bisect(0.0, best, |sd| !within(sd))
        };
        Some([low, bisect(best, high, within)])
    }

    /// Degrees of freedom of a contrast of the means (Satterthwaite 1946; Giesbrecht and Burns
    /// 1985): from how its variance answers to the variance components, and how well those are known.
    fn degrees(&self, contrast: &DVector<f64>) -> f64 {
        let most = (self.design.values.len() - self.design.fixed_effects) as f64;
        let variance_of = |variances: &[f64]| {
            let sds: Vec<f64> = variances.iter().map(|v| v.max(0.0).sqrt()).collect();
            let fit = self.design.fit(&sds)?;
            Some((
                contrast.dot(&(&fit.covariance * contrast)),
                fit.log_likelihood,
            ))
        };
        self.satterthwaite(variance_of)
            .unwrap_or(most)
            .clamp(1.0, most)
    }

    fn satterthwaite(&self, variance_of: impl Fn(&[f64]) -> Option<(f64, f64)>) -> Option<f64> {
        /// A component this far below the largest stands at zero and is not counted.
        const NONE: f64 = 1e-6;
        const STEP: f64 = 0.02;
        let variances: Vec<f64> = self.sds.iter().map(|sd| sd * sd).collect();
        let largest = variances.iter().copied().fold(0.0, f64::max);
        let free: Vec<usize> = (0..variances.len())
            .filter(|&place| variances[place] > NONE * largest)
            .collect();
        let moved = |moves: &[(usize, f64)]| {
            let mut variances = variances.clone();
            for &(place, share) in moves {
                variances[place] *= 1.0 + share;
            }
            variance_of(&variances)
        };
        let (variance, height) = variance_of(&variances)?;
        // In units of each variance.
        let mut gradient = DVector::zeros(free.len());
        let mut information = DMatrix::zeros(free.len(), free.len());
        for (i, &a) in free.iter().enumerate() {
            let (more, less) = (moved(&[(a, STEP)])?, moved(&[(a, -STEP)])?);
            gradient[i] = (more.0 - less.0) / (2.0 * STEP);
            information[(i, i)] = (2.0 * height - more.1 - less.1) / (STEP * STEP);
            for (j, &b) in free.iter().enumerate().take(i) {
                let both = |s: f64, t: f64| Some(moved(&[(a, s * STEP), (b, t * STEP)])?.1);
                let mixed =
                    both(1.0, 1.0)? - both(1.0, -1.0)? - both(-1.0, 1.0)? + both(-1.0, -1.0)?;
                let second = -mixed / (4.0 * STEP * STEP);
                information[(i, j)] = second;
                information[(j, i)] = second;
            }
        }
        let covariance = Cholesky::new(information)?.inverse();
        let uncertainty = gradient.dot(&(covariance * &gradient));
        (uncertainty > 0.0).then(|| 2.0 * variance * variance / uncertainty)
    }
}

/// The place between `from`, where it holds, and `to`, where it does not.
fn bisect(mut from: f64, mut to: f64, holds: impl Fn(f64) -> bool) -> f64 {
    const STEPS: usize = 18;
    for _ in 0..STEPS {
        let middle = f64::midpoint(from, to);
        // In proportion, as soon as both ends are on the same side of zero.
        let middle = if from > 0.0 && to > 4.0 * from {
            (from * to).sqrt()
        } else {
            middle
        };
        if holds(middle) {
            from = middle;
        } else {
            to = middle;
        }
    }
    f64::midpoint(from, to)
}

impl Design {
    fn new(
        drops: &[Drop],
        factors: &[Factor],
        effects: Vec<Option<Vec<(usize, f64)>>>,
        fixed_effects: usize,
        random: &[usize],
    ) -> Result<Self> {
        let mut starts = Vec::new();
        let mut column_count = 0;
        for &factor in random {
            starts.push(column_count);
            column_count += factors[factor].levels.len();
        }
        let used: Vec<(&Drop, Vec<(usize, f64)>)> = drops
            .iter()
            .zip(effects)
            .filter_map(|(drop, effects)| Some((drop, effects?)))
            .collect();
        for (drop, _) in &used {
            check(&drop.measured)?;
        }
        let has = |effect: usize, of: &[(usize, f64)]| of.iter().any(|(known, _)| *known == effect);
        let empty = (0..fixed_effects).any(|effect| !used.iter().any(|(_, of)| has(effect, of)));
        if empty || used.len() < fixed_effects + 2 {
            return Err(Error::TooFewDrops {
                needed: fixed_effects + 2,
                drops: used.len(),
            });
        }
        let columns = used.iter().map(|(drop, _)| {
            let of_factor = random.iter().zip(&starts).enumerate();
            of_factor
                .filter_map(|(place, (&factor, start))| Some((start + drop.levels[factor]?, place)))
                .collect()
        });
        let origin = used[0].0.measured.value;
        let values: Vec<f64> = used
            .iter()
            .map(|(drop, _)| drop.measured.value - origin)
            .collect();
        Ok(Self {
            own_variances: used.iter().map(|(d, _)| d.measured.sd.powi(2)).collect(),
            columns: columns.collect(),
            fixed: used.into_iter().map(|(_, effects)| effects).collect(),
            fixed_effects,
            column_count,
            random_factors: random.len(),
            scale: sd(&values).max(1e-150),
            values,
            origin,
        })
    }

    /// Improves the standard deviations one after the other until the likelihood stands still, all
    /// but the one held, and returns its logarithm.
    fn climb_all(&self, sds: &mut [f64], held: Option<usize>, rounds: usize) -> f64 {
        /// Far below what any interval shows.
        const STILL: f64 = 1e-7;
        let height = |sds: &[f64]| self.fit(sds).map_or(f64::MIN, |fit| fit.log_likelihood);
        let mut best = height(sds);
        for _ in 0..rounds {
            let before = best;
            for place in (0..sds.len()).filter(|&place| Some(place) != held) {
                let now = sds.to_vec();
                let with = |sd: f64| {
                    let mut tried = now.clone();
                    tried[place] = sd;
                    tried
                };
                // Near where it was, and anywhere.
                let reach = 4.0 * self.scale;
                let near = [0.5 * now[place], (2.0 * now[place]).max(1e-4 * self.scale)];
                let candidates = [
                    0.0,
                    climb(near, |sd| height(&with(sd))),
                    climb([0.0, reach], |sd| height(&with(sd))),
                ];
                for sd in candidates {
                    let found = height(&with(sd));
                    if found > best {
                        best = found;
                        sds[place] = sd;
                    }
                }
            }
            if best - before < STILL {
                break;
            }
        }
        best
    }

    /// Means, their covariance and the restricted log-likelihood (up to a constant), by the identity
    /// of Woodbury: only a matrix of the size of all levels together is taken apart.
    fn fit(&self, sds: &[f64]) -> Option<Fit> {
        let (p, q) = (self.fixed_effects, self.column_count);
        let mut inner = DMatrix::<f64>::identity(q, q);
        let mut across = DMatrix::<f64>::zeros(q, p + 1);
        let mut information = DMatrix::<f64>::zeros(p, p);
        let mut fixed_by_value = DVector::<f64>::zeros(p);
        let mut value_by_value = 0.0;
        let mut log_determinant = 0.0;
        for (drop, &value) in self.values.iter().enumerate() {
            let variance = self.own_variances[drop] + sds[0] * sds[0];
            if variance <= 0.0 {
                return None;
            }
            let weight = 1.0 / variance;
            log_determinant += variance.ln();
            let effects = &self.fixed[drop];
            for &(effect, amount) in effects {
                fixed_by_value[effect] += weight * amount * value;
                for &(other, other_amount) in effects {
                    information[(effect, other)] += weight * amount * other_amount;
                }
            }
            value_by_value += weight * value * value;
            let columns = &self.columns[drop];
            for &(column, factor) in columns {
                let scaled = weight * sds[1 + factor];
                for &(effect, amount) in effects {
                    across[(column, effect)] += scaled * amount;
                }
                across[(column, p)] += scaled * value;
                for &(other, other_factor) in columns {
                    inner[(column, other)] += scaled * sds[1 + other_factor];
                }
            }
        }
        let inner: Cholesky<f64, Dyn> = Cholesky::new(inner)?;
        let solved = inner.solve(&across);
        let corrected = across.transpose() * solved;
        information -= corrected.view((0, 0), (p, p));
        let projected = fixed_by_value - corrected.view((0, p), (p, 1)).column(0);
        let total = value_by_value - corrected[(p, p)];
        let information = Cholesky::new(information)?;
        let effects = information.solve(&projected);
        let residual = (total - projected.dot(&effects)).max(0.0);
        let log_of = |cholesky: &Cholesky<f64, Dyn>| {
            2.0 * cholesky
                .l_dirty()
                .diagonal()
                .iter()
                .map(|d| d.ln())
                .sum::<f64>()
        };
        let log_determinant = log_determinant + log_of(&inner) + log_of(&information);
        Some(Fit {
            log_likelihood: -0.5 * (log_determinant + residual),
            effects,
            covariance: information.inverse(),
        })
    }
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
