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

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

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

/// The error of a drop is at least this part of the spread of all.
const KNOWN_AT_BEST: f64 = 1e-5;

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

/// The mixed-model equations, solved.
struct Solved {
    sums: Sums,
    /// The diagonal of S, with one for each fixed effect.
    scales: DVector<f64>,
    /// A.
    system: Cholesky<f64, Dyn>,
    /// What is left of a drop, y - T t, by its terms.
    left: DVector<f64>,
    /// The products times that.
    by_products: [DVector<f64>; 3],
    /// ln |A| - ln |W|.
    log_determinants: f64,
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
        design.scale = sd(&values).max(1e-100);
        // Values that agree exactly, by drops known exactly, would make any variance but zero unlikely without end.
        let least = (KNOWN_AT_BEST * design.scale).powi(2);
        for own in &mut design.own_variances {
            *own = own.max(least);
        }
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
        let large = (0.25 * self.scale).powi(2);
        let one_is_large = |one: usize| {
            let size = |place: usize| if place == one { large } else { self.small() };
            (0..self.variances).map(size).collect()
        };
        let starts = std::iter::once(vec![large; self.variances]);
        let starts = starts.chain((0..self.variances).map(one_is_large));
        let climbed = starts.filter_map(|start| self.climb(start, None));
        climbed.max_by(|(_, a), (_, b)| a.log_likelihood.total_cmp(&b.log_likelihood))
    }

    /// A variance that is small beside that of all values.
    fn small(&self) -> f64 {
        (0.01 * self.scale).powi(2)
    }

    /// Climbs from variances to those of greatest likelihood nearby, all but the one held, by Newton's method with
    /// the average information, damped where that leads down (D. W. Marquardt, J. Soc. Ind. Appl. Math. 11, 431,
    /// 1963).
    pub(super) fn climb(&self, start: Vec<f64>, held: Option<usize>) -> Option<(Vec<f64>, Fit)> {
        const MAX_STEPS: usize = 100;
        const MIN_DAMPING: f64 = 1e-6;
        /// Far beyond the greatest likelihood differences of large numbers are left of it.
        const MAX_GROWTH: f64 = 10.0;
        let mut fit = self.fit(&start)?;
        let mut variances = start;
        let mut damping = MIN_DAMPING;
        for _ in 0..MAX_STEPS {
            let may_move = |&place: &usize| {
                Some(place) != held && (variances[place] > 0.0 || fit.score[place] > 0.0)
            };
            let free: Vec<usize> = (0..self.variances).filter(may_move).collect();
            let Some(step) = fit.step(&free, damping) else {
                break;
            };
            let mut tried = variances.clone();
            for (&place, step) in free.iter().zip(&step) {
                let most = MAX_GROWTH * tried[place].max(self.small());
                tried[place] = (tried[place] + step).clamp(0.0, most);
            }
            match self.fit(&tried) {
                Some(better) if better.log_likelihood > fit.log_likelihood => {
                    (variances, fit) = (tried, better);
                    damping = (0.1 * damping).max(MIN_DAMPING);
                }
                _ => damping *= 10.0,
            }
        }
        Some((variances, fit))
    }

    /// What the likelihood says for these variances; `None` if the effects cannot be told apart.
    pub(super) fn fit(&self, variances: &[f64]) -> Option<Fit> {
        let solved = self.solved(variances)?;
        let (fixed, columns) = (self.fixed_effects, self.columns());
        let square = solved.by_products[0][columns].max(0.0);
        let unit = DMatrix::identity(columns, fixed);
        let (score, information) = self.derivatives(&solved);
        Some(Fit {
            log_likelihood: -0.5 * (solved.log_determinants + square),
            effects: -solved.left.rows(0, fixed),
            covariance: solved.system.solve(&unit).rows(0, fixed).into_owned(),
            score,
            information,
        })
    }

    /// Solves the mixed-model equations for these variances.
    fn solved(&self, variances: &[f64]) -> Option<Solved> {
        let (fixed, columns) = (self.fixed_effects, self.columns());
        let sums = self.sums(variances[0]);
        let [one, two, three] = &sums.products;
        let scales = DVector::from_fn(columns, |column, _| match column.checked_sub(fixed) {
            None => 1.0,
            Some(level) => variances[self.variance_of[level]].sqrt(),
        });
        let mut system = scaled(one, &scales);
        for level in fixed..columns {
            system[(level, level)] += 1.0;
        }
        let system = Cholesky::new(system)?;
        let right = one.column(columns).rows(0, columns).component_mul(&scales);
        let effects = system.solve(&right).component_mul(&scales);
        let left = (-effects).push(1.0);
        let roots = system.l_dirty().diagonal();
        let log_determinant = 2.0 * roots.iter().map(|root| root.ln()).sum::<f64>();
        Some(Solved {
            by_products: [one, two, three].map(|products| products * &left),
            log_determinants: sums.log_variances + log_determinant,
            sums,
            scales,
            system,
            left,
        })
    }

    /// The derivatives of the log-likelihood by the variances, (y' P V P y - tr(P V))/2 for a variance whose matrix is
    /// V, with P y = W (y - T t), and the average information, half of f' P f for all pairs of f = V P y.
    fn derivatives(&self, solved: &Solved) -> (DVector<f64>, DMatrix<f64>) {
        let Solved {
            sums,
            scales,
            system,
            left,
            by_products: [_, by_two, by_three],
            ..
        } = solved;
        let columns = self.columns();
        let levels = self.variance_of.len();
        let [one, two, _] = &sums.products;
        // T' W of each column of Z, of the values, and of P y.
        let mut products = one
            .view((0, self.fixed_effects), (columns, levels))
            .into_owned();
        products.extend([
            one.column(columns).rows(0, columns),
            by_two.rows(0, columns),
        ]);
        let projected = self.projected(solved, &products);
        // Of a random factor f is a sum of columns of Z with these amounts; of the drops it is P y.
        let mut amounts = DMatrix::zeros(levels, self.variances);
        let mut score = DVector::zeros(self.variances);
        for (level, &variance) in self.variance_of.iter().enumerate() {
            let amount = projected[(level, levels)];
            amounts[(level, variance)] = amount;
            score[variance] += amount * amount - projected[(level, level)];
        }
        let trace = system.solve(&scaled(two, scales)).trace();
        score[0] = left.dot(by_two) - (sums.weights - trace);
        let mut information = amounts.transpose() * projected.columns(0, levels) * &amounts;
        let with_drops = amounts.transpose() * projected.column(levels + 1);
        information.set_column(0, &with_drops);
        information.set_row(0, &with_drops.transpose());
        let own = by_two.rows(0, columns).component_mul(scales);
        information[(0, 0)] = left.dot(by_three) - own.dot(&system.solve(&own));
        (0.5 * score, 0.5 * information)
    }

    /// Z' P x for vectors x of which T' W x are the columns. With A u = S T' W x it is u/S, or what the effects leave
    /// of it, Z' W x - Z' W T S u. Where the drops of a level are known well beside its variance, the latter is a
    /// difference of large numbers; where its variance is small, the former divides rounding by it.
    fn projected(&self, solved: &Solved, products: &DMatrix<f64>) -> DMatrix<f64> {
        /// Up to so much of the variance with which its drops tell a level, a variance is small.
        const SMALL: f64 = 1e-3;
        let fixed = self.fixed_effects;
        let Solved {
            sums,
            scales,
            system,
            ..
        } = solved;
        let one = &sums.products[0];
        let rows_scaled = |matrix: &DMatrix<f64>| {
            DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
                scales[row] * matrix[(row, column)]
            })
        };
        let solution = system.solve(&rows_scaled(products));
        let (levels, columns) = (self.variance_of.len(), self.columns());
        let explained = one.view((fixed, 0), (levels, columns)) * rows_scaled(&solution);
        DMatrix::from_fn(levels, products.ncols(), |level, of| {
            let row = fixed + level;
            if scales[row].powi(2) * one[(row, row)] > SMALL {
                solution[(row, of)] / scales[row]
            } else {
                products[(row, of)] - explained[(level, of)]
            }
        })
    }

    /// The sums over the drops.
    fn sums(&self, between: f64) -> Sums {
        let size = self.columns() + 1;
        let mut products: [DMatrix<f64>; 3] = std::array::from_fn(|_| DMatrix::zeros(size, size));
        let (mut weights, mut log_variances) = (0.0, 0.0);
        let mut start = 0;
        for (&end, own) in self.ends.iter().zip(&self.own_variances) {
            let variance = own + between;
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
        Sums {
            products,
            weights,
            log_variances,
        }
    }
}

/// The products of terms, each times its scales.
fn scaled(products: &DMatrix<f64>, scales: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(scales.len(), scales.len(), |row, column| {
        scales[row] * products[(row, column)] * scales[column]
    })
}

impl Fit {
    /// The step of some of the variances towards those of greatest likelihood; `None` if it promises nothing, or the
    /// values tell nothing of them.
    fn step(&self, free: &[usize], damping: f64) -> Option<DVector<f64>> {
        /// What a step promises of the log-likelihood if it is not worth taking.
        const STILL: f64 = 1e-9;
        /// Damping takes the values to tell at least this part of what they tell of another variance.
        const MIN_PART: f64 = 1e-9;
        let score = DVector::from_fn(free.len(), |i, _| self.score[free[i]]);
        let mut information = DMatrix::from_fn(free.len(), free.len(), |i, j| {
            self.information[(free[i], free[j])]
        });
        let most = information.diagonal().iter().copied().fold(0.0, f64::max);
        for place in 0..free.len() {
            let own = information[(place, place)];
            information[(place, place)] += damping * own.max(MIN_PART * most);
        }
        let step = Cholesky::new(information)?.solve(&score);
        (0.5 * step.dot(&score) > STILL).then_some(step)
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
        for variances in [[1e-4, 3e-5, 2e-4], [2e-5, 0.0, 1e-5], [1e-8, 1e-2, 1e-3]] {
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
                // At zero from above, elsewhere from both sides.
                let step = 2e-9_f64.max(1e-4 * variances[place]);
                let below = if variances[place] > 0.0 { step } else { 0.0 };
                let expected = (at(step) - at(-below)) / (step + below);
                let found = fit.score[place];
                assert!(
                    (found - expected).abs() < 2e-3 * expected.abs() + 1e-2,
                    "{variances:?} {place}: {found} {expected}"
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
