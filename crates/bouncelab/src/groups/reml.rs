//! Restricted maximum likelihood of variance components (H. D. Patterson and R. Thompson, Biometrika 58, 545,
//! 1971).
//!
//! Values are y = X b + Z u + e: fixed effects, deviations of levels, whose variance is that of their random
//! factor, and what is left of each drop, whose variance is that between drops and that of its own error. With
//! W the inverse of the last and T = (X, Z S), S the standard deviations of the deviations, the mixed-model
//! equations (C. R. Henderson, Biometrics 31, 423, 1975) are A t = T' W y with A = T' W T + (0, I), and the
//! restricted likelihood is
//!
//! -2 ln L = -ln |W| + ln |A| + y' W (y - T t).
//!
//! Sums over the drops are made once for all of them; the rest is algebra as large as all levels together, in
//! which a variance may be zero.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::mean::check;
use super::mixed::{Drop, Factor};
use crate::error::{Error, Result};
use crate::stats::sd;

/// A fixed effect, or a column of a level of a random factor, and how much of it a drop has.
pub(super) type Term = (usize, f64);

/// The drops in the form in which the likelihood needs them.
#[derive(Debug, Clone)]
pub(super) struct Design {
    /// Of all drops, one after the other: fixed effects first, then levels, the value as the last column.
    terms: Vec<Term>,
    /// Where the terms of each drop end.
    ends: Vec<usize>,
    own_variances: Vec<f64>,
    fixed_effects: usize,
    /// For each column of a level the place of its variance among all.
    variance_of: Vec<usize>,
    /// How many variances there are: that between drops, and one for each random factor.
    variances: usize,
    /// A length within which all standard deviations lie.
    pub(super) scale: f64,
    /// Subtracted from the values, so that sums of squares keep their digits.
    pub(super) origin: f64,
}

/// What the likelihood says for given variances.
#[derive(Debug, Clone)]
pub(super) struct Fit {
    /// Up to a constant.
    pub(super) log_likelihood: f64,
    pub(super) effects: DVector<f64>,
    pub(super) covariance: DMatrix<f64>,
    /// Derivatives of the log-likelihood by the variances.
    pub(super) score: DVector<f64>,
    /// The average of what was observed and what is expected of minus its second derivatives (A. R. Gilmour,
    /// R. Thompson and B. R. Cullis, Biometrics 51, 1440, 1995).
    information: DMatrix<f64>,
}

/// Sums over the drops of the products of their terms, for a variance between drops.
struct Sums {
    /// Weighed by W, and by its second and third power.
    products: [DMatrix<f64>; 3],
    weights: f64,
    log_variances: f64,
}

impl Design {
    /// Drops with their fixed effects; those without any are left out.
    ///
    /// # Errors
    /// [`Error::TooFewDrops`] unless each effect is that of a drop and there are two more drops than effects,
    /// [`Error::OutOfRange`] for values that are not finite.
    pub(super) fn new(
        drops: &[Drop],
        factors: &[Factor],
        effects: impl Iterator<Item = Option<Vec<Term>>>,
        fixed_effects: usize,
        random: &[usize],
    ) -> Result<Self> {
        let mut starts = Vec::new();
        let mut variance_of = Vec::new();
        for (place, &factor) in random.iter().enumerate() {
            starts.push(fixed_effects + variance_of.len());
            variance_of.extend(factors[factor].levels.iter().map(|_| 1 + place));
        }
        let mut design = Self {
            terms: Vec::new(),
            ends: Vec::new(),
            own_variances: Vec::new(),
            fixed_effects,
            variance_of,
            variances: 1 + random.len(),
            scale: 0.0,
            origin: 0.0,
        };
        let mut values = Vec::new();
        let mut empty = vec![true; fixed_effects];
        for (drop, effects) in drops.iter().zip(effects) {
            let Some(effects) = effects else {
                continue;
            };
            check(&drop.measured)?;
            if values.is_empty() {
                design.origin = drop.measured.value;
            }
            let value = drop.measured.value - design.origin;
            for (effect, _) in &effects {
                empty[*effect] = false;
            }
            let levels = random.iter().zip(&starts);
            let levels =
                levels.filter_map(|(&factor, start)| Some((start + drop.levels[factor]?, 1.0)));
            design.terms.extend(effects.into_iter().chain(levels));
            design.terms.push((design.columns(), value));
            design.ends.push(design.terms.len());
            design.own_variances.push(drop.measured.sd.powi(2));
            values.push(value);
        }
        if empty.contains(&true) || values.len() < fixed_effects + 2 {
            return Err(Error::TooFewDrops {
                needed: fixed_effects + 2,
                drops: values.len(),
            });
        }
        design.scale = sd(&values).max(1e-150);
        Ok(design)
    }

    pub(super) fn drops(&self) -> usize {
        self.ends.len()
    }

    pub(super) fn fixed_effects(&self) -> usize {
        self.fixed_effects
    }

    /// Fixed effects and levels together.
    fn columns(&self) -> usize {
        self.fixed_effects + self.variance_of.len()
    }

    /// The variances of greatest likelihood, and what it says there; `None` if the effects cannot be told apart.
    ///
    /// The likelihood may have several hills, so it is climbed from several places.
    pub(super) fn greatest(&self) -> Option<(Vec<f64>, Fit)> {
        let [large, small] = [0.25, 0.01].map(|share| (share * self.scale).powi(2));
        let one_is_large = |one: usize| {
            let size = |place: usize| if place == one { large } else { small };
            (0..self.variances).map(size).collect()
        };
        let starts = std::iter::once(vec![large; self.variances]);
        let starts = starts.chain((0..self.variances).map(one_is_large));
        let climbed = starts.filter_map(|start| self.climb(start, None));
        climbed.max_by(|(_, a), (_, b)| a.log_likelihood.total_cmp(&b.log_likelihood))
    }

    /// Climbs from variances to those of greatest likelihood nearby, all but the one held, by Newton's method with
    /// the average information, damped where that leads down (D. W. Marquardt, J. Soc. Ind. Appl. Math. 11, 431,
    /// 1963).
    pub(super) fn climb(&self, start: Vec<f64>, held: Option<usize>) -> Option<(Vec<f64>, Fit)> {
        /// What a step promises of the log-likelihood if it is the last.
        const STILL: f64 = 1e-9;
        const MOST_STEPS: usize = 100;
        const LEAST_DAMPING: f64 = 1e-6;
        let mut fit = self.fit(&start)?;
        let mut variances = start;
        let mut damping = LEAST_DAMPING;
        for _ in 0..MOST_STEPS {
            let may_move = |&place: &usize| {
                Some(place) != held && (variances[place] > 0.0 || fit.score[place] > 0.0)
            };
            let free: Vec<usize> = (0..self.variances).filter(may_move).collect();
            let step = fit.step(&free, damping);
            let Some((step, _)) = step.filter(|(_, promise)| *promise > STILL) else {
                break;
            };
            let mut tried = variances.clone();
            for (&place, step) in free.iter().zip(&step) {
                tried[place] = (tried[place] + step).max(0.0);
            }
            match self.fit(&tried) {
                Some(better) if better.log_likelihood > fit.log_likelihood => {
                    (variances, fit) = (tried, better);
                    damping = (0.1 * damping).max(LEAST_DAMPING);
                }
                _ => damping *= 10.0,
            }
        }
        Some((variances, fit))
    }

    /// What the likelihood says for these variances; `None` if the effects cannot be told apart, or a drop is known
    /// exactly.
    pub(super) fn fit(&self, variances: &[f64]) -> Option<Fit> {
        let Sums {
            products: [one, two, three],
            weights,
            log_variances,
        } = self.sums(variances[0])?;
        let (fixed, columns) = (self.fixed_effects, self.columns());
        let scales = DVector::from_fn(columns, |column, _| match column.checked_sub(fixed) {
            None => 1.0,
            Some(level) => variances[self.variance_of[level]].sqrt(),
        });
        let scaled = |matrix: DMatrix<f64>| {
            DMatrix::from_fn(columns, columns, |i, j| {
                scales[i] * matrix[(i, j)] * scales[j]
            })
        };
        let terms = |of: &DMatrix<f64>| of.view((0, 0), (columns, columns)).into_owned();
        let mut system = scaled(terms(&one));
        for level in fixed..columns {
            system[(level, level)] += 1.0;
        }
        let system = Cholesky::new(system)?;
        let right = one.column(columns).rows(0, columns).component_mul(&scales);
        let solved = system.solve(&right).component_mul(&scales);
        // What is left of a drop, y - T t, by its terms.
        let left = (-&solved).push(1.0);
        let [by_one, by_two, by_three] = [&one, &two, &three].map(|products| products * &left);
        let log_determinant: f64 = system
            .l_dirty()
            .diagonal()
            .iter()
            .map(|d| 2.0 * d.ln())
            .sum();
        let inverse = scaled(system.inverse());

        let mut score = DVector::zeros(self.variances);
        score[0] = left.dot(&by_two) - weights + inverse.dot(&terms(&two));
        // The deviation of the variance of each in the direction of its greatest change, and its products.
        let mut moved = DMatrix::zeros(columns, self.variances);
        for (level, &variance) in self.variance_of.iter().enumerate() {
            let level = fixed + level;
            let products = one.column(level).rows(0, columns).into_owned();
            let explained = products.dot(&(&inverse * &products));
            score[variance] += by_one[level].powi(2) - (products[level] - explained);
            moved[(level, variance)] = by_one[level];
        }
        let mut across = terms(&one) * &moved;
        across.set_column(0, &by_two.rows(0, columns));
        let mut information = moved.transpose() * &across;
        let with_drops = moved.transpose() * by_two.rows(0, columns);
        information.set_column(0, &with_drops);
        information.set_row(0, &with_drops.transpose());
        information[(0, 0)] = left.dot(&by_three);
        information -= across.transpose() * (&inverse * &across);
        Some(Fit {
            log_likelihood: -0.5 * (log_variances + log_determinant + by_one[columns].max(0.0)),
            effects: solved.rows(0, fixed).into_owned(),
            covariance: inverse.view((0, 0), (fixed, fixed)).into_owned(),
            score: 0.5 * score,
            information: 0.5 * information,
        })
    }

    /// The sums over the drops; `None` if one of them is known exactly.
    fn sums(&self, between: f64) -> Option<Sums> {
        let size = self.columns() + 1;
        let mut products: [DMatrix<f64>; 3] = std::array::from_fn(|_| DMatrix::zeros(size, size));
        let (mut weights, mut log_variances) = (0.0, 0.0);
        let mut start = 0;
        for (&end, own) in self.ends.iter().zip(&self.own_variances) {
            let variance = own + between;
            if variance <= 0.0 {
                return None;
            }
            let weight = 1.0 / variance;
            weights += weight;
            log_variances += variance.ln();
            let terms = &self.terms[start..end];
            start = end;
            for (place, &(column, amount)) in terms.iter().enumerate() {
                for &(row, other) in &terms[place..] {
                    let mut product = amount * other;
                    for products in &mut products {
                        product *= weight;
                        products[(row, column)] += product;
                    }
                }
            }
        }
        products
            .iter_mut()
            .for_each(DMatrix::fill_upper_triangle_with_lower_triangle);
        Some(Sums {
            products,
            weights,
            log_variances,
        })
    }
}

impl Fit {
    /// The step of some of the variances towards those of greatest likelihood, and what it promises of the
    /// log-likelihood; `None` if the values tell nothing of them.
    fn step(&self, free: &[usize], damping: f64) -> Option<(DVector<f64>, f64)> {
        /// A variance of which the values tell less than this part of what they tell of another is moved as if they
        /// told so much.
        const LEAST_KNOWN: f64 = 1e-9;
        let score = DVector::from_fn(free.len(), |i, _| self.score[free[i]]);
        let mut information = DMatrix::from_fn(free.len(), free.len(), |i, j| {
            self.information[(free[i], free[j])]
        });
        let most = information.diagonal().iter().copied().fold(0.0, f64::max);
        for place in 0..free.len() {
            let own = information[(place, place)];
            information[(place, place)] += damping * own.max(LEAST_KNOWN * most);
        }
        let step = Cholesky::new(information)?.solve(&score);
        let promise = 0.5 * step.dot(&score);
        Some((step, promise))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inference::Measured;

    /// Twelve drops of three balls on two surfaces, of one of which the surface was not noted.
    fn design() -> Design {
        let drops: Vec<Drop> = (0..12_u8)
            .map(|number| Drop {
                measured: Measured {
                    value: 0.9 + 0.01 * f64::from(number * number % 7),
                    sd: 0.002 + 0.0005 * f64::from(number % 4),
                },
                levels: vec![
                    Some(usize::from(number % 3)),
                    (number != 5).then_some(usize::from(number / 2 % 2)),
                ],
            })
            .collect();
        let factors = [("ball", 3), ("surface", 2)].map(|(name, levels)| Factor {
            name: name.to_owned(),
            levels: (0..levels).map(|level: usize| level.to_string()).collect(),
        });
        let mean = (0..drops.len()).map(|_| Some(vec![(0, 1.0)]));
        Design::new(&drops, &factors, mean, 1, &[0, 1]).unwrap()
    }

    /// The likelihood against that of the dense covariance of the values, and its derivatives against differences;
    /// also for a variance of zero.
    #[test]
    fn likelihood_and_score_are_those_of_the_dense_covariance() {
        let design = design();
        let dense = |variances: &[f64]| {
            let drops = design.drops();
            let starts = std::iter::once(0).chain(design.ends.iter().copied());
            let terms: Vec<&[Term]> = starts
                .zip(&design.ends)
                .map(|(start, &end)| &design.terms[start..end])
                .collect();
            let share = |a: usize, b: usize| {
                let common = terms[a].iter().filter(|(column, _)| {
                    (1..design.columns()).contains(column)
                        && terms[b].iter().any(|it| it.0 == *column)
                });
                common
                    .map(|(column, _)| variances[design.variance_of[column - 1]])
                    .sum::<f64>()
            };
            let covariance = DMatrix::from_fn(drops, drops, |a, b| {
                let own = design.own_variances[a] + variances[0];
                share(a, b) + if a == b { own } else { 0.0 }
            });
            let values = DVector::from_fn(drops, |drop, _| terms[drop].last().unwrap().1);
            let ones = DVector::from_element(drops, 1.0);
            let covariance = Cholesky::new(covariance).unwrap();
            let known = ones.dot(&covariance.solve(&ones));
            let mean = ones.dot(&covariance.solve(&values)) / known;
            let left = values - mean * ones;
            let square = left.dot(&covariance.solve(&left));
            (
                mean,
                -0.5 * (covariance.determinant().ln() + known.ln() + square),
            )
        };
        for variances in [[1e-4, 3e-5, 2e-4], [2e-5, 0.0, 1e-5]] {
            let fit = design.fit(&variances).unwrap();
            let (mean, log_likelihood) = dense(&variances);
            assert!((fit.effects[0] - mean).abs() < 1e-12);
            assert!((fit.log_likelihood - log_likelihood).abs() < 1e-9);
            for place in 0..variances.len() {
                let at = |change: f64| {
                    let mut moved = variances;
                    moved[place] += change;
                    dense(&moved).1
                };
                let expected = (at(2e-9) - at(0.0)) / 2e-9;
                let scale = expected.abs().max(1e3);
                assert!(
                    (fit.score[place] - expected).abs() < 2e-3 * scale,
                    "{place}"
                );
            }
        }
    }

    /// At the greatest likelihood nothing is left to climb but for a variance that would be below zero.
    #[test]
    fn the_score_vanishes_at_the_greatest_likelihood() {
        let (variances, fit) = design().greatest().unwrap();
        for (variance, score) in variances.iter().zip(&fit.score) {
            assert!(
                score * variance.max(1e-6) < 1e-4
                    && (*variance == 0.0 || score.abs() * variance < 1e-4)
            );
        }
    }
}
