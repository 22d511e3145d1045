//! The curve of a group and the scatter of its drops.
//!
//! Drop i of a group reads its curve through `B_i` β + (`u_i` + o) 1 + `L_i` z: β are the coefficients of the group, `u_i` ~ N(0, τ²)
//! is the level of the drop, o that of its operator, z the inputs that all drops of the ball share. Given τ all of this is
//! linear and Gaussian. τ is integrated out over a grid with its marginal likelihood, since a few drops hardly tell it; so is
//! the scatter of the operators. z keeps the uncertainty that it has in a single drop: an error of the drag law or of the
//! contact time that drops share must not average out.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn, SMatrix, SVector};

use super::evidence::SHARED_INPUTS;
use super::mixture::{Mixture, of_weighted, relevant, weights};
use super::sums::{Basis, SCATTER_STEP, SCATTERS, Sums, scatter_at};
use crate::estimate::Estimate;

/// A number for each shared input.
pub(super) type Shared = SVector<f64, SHARED_INPUTS>;

/// Means of the exponential priors of the relative scatters of drops, and of operators: they exceed 4.6 times this once in a
/// hundred times (the penalised complexity prior of Simpson et al., Stat. Sci. 32, 1, 2017).
const MEAN_BETWEEN_DROPS: f64 = 0.01;
const MEAN_BETWEEN_OPERATORS: f64 = 0.002;

/// Scatter of operators while nothing is known of it, relative.
const FREE_EFFECT: f64 = 0.05;

/// The drops of a group that have the same operator.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    /// The effects that move its level, by index.
    pub(super) effects: Vec<usize>,
    pub(super) sums: Sums,
}

/// What the drops of a ball share, with the uncertainty that a single drop leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Inputs {
    pub(super) mean: Shared,
    pub(super) covariance: SMatrix<f64, SHARED_INPUTS, SHARED_INPUTS>,
}

/// What groups are fitted with.
#[derive(Debug)]
pub(super) struct Frame {
    pub(super) basis: Basis,
    prior: DMatrix<f64>,
    log_prior: f64,
    /// The factor of each effect.
    pub(super) factors: Vec<usize>,
}

impl Frame {
    pub(super) fn new(basis: Basis, factors: Vec<usize>) -> Self {
        let prior = basis.prior();
        Self {
            basis,
            log_prior: prior
                .clone()
                .cholesky()
                .map_or(f64::NAN, |root| log_determinant(&root)),
            prior,
            factors,
        }
    }
}

fn log_determinant(root: &Cholesky<f64, Dyn>) -> f64 {
    2.0 * root
        .l_dirty()
        .diagonal()
        .iter()
        .map(|it| it.ln())
        .sum::<f64>()
}

/// A group given the scatter of its drops.
#[derive(Debug)]
pub(super) struct Given {
    pub(super) scatter: f64,
    /// Of the precision of the coefficients given the effects.
    root: Cholesky<f64, Dyn>,
    /// The coefficients without effects.
    pub(super) curve: DVector<f64>,
    /// By how much one of the effects, and one of the inputs, moves them.
    by_effects: DMatrix<f64>,
    by_inputs: DMatrix<f64>,
    /// Information of the group on the effects: matrix, and vector.
    precision: DMatrix<f64>,
    pull: DVector<f64>,
}

impl Given {
    /// With the logarithm of the marginal likelihood, the effects being nearly free.
    fn new(frame: &Frame, cells: &[Cell], scatter: usize, inputs: &Inputs) -> Option<(Self, f64)> {
        let (len, effects) = (frame.basis.len(), frame.factors.len());
        let columns = effects + SHARED_INPUTS + 1;
        let mut curve = frame.prior.clone();
        let mut with_others = DMatrix::zeros(len, columns);
        let mut others = DMatrix::zeros(columns, columns);
        let mut log_determinants = -frame.log_prior;
        for cell in cells {
            let (products, log) = cell.sums.at(scatter);
            log_determinants += log;
            curve += products.view((0, 0), (len, len));
            let fixed = SHARED_INPUTS + 1;
            let mut to = with_others.view_mut((0, effects), (len, fixed));
            to += products.view((0, len), (len, fixed));
            let mut to = others.view_mut((effects, effects), (fixed, fixed));
            to += products.view((len, len), (fixed, fixed));
            // An effect adds one to every coefficient.
            let moved = products.rows(0, len).row_sum();
            let level = moved.columns(0, len).sum();
            for &effect in &cell.effects {
                let mut to = with_others.column_mut(effect);
                to += moved.columns(0, len).transpose();
                for &other in &cell.effects {
                    others[(effect, other)] += level;
                }
                for column in 0..fixed {
                    others[(effect, effects + column)] += moved[len + column];
                    others[(effects + column, effect)] += moved[len + column];
                }
            }
        }
        let root = Cholesky::new(curve)?;
        let solved = root.solve(&with_others);
        others -= with_others.tr_mul(&solved);
        // Without the coefficients a group is a quadratic form of effects, inputs and -1.
        let mut fixed = DVector::from_element(SHARED_INPUTS + 1, -1.0);
        fixed.rows_mut(0, SHARED_INPUTS).copy_from(&inputs.mean);
        let square = (fixed
            .tr_mul(&others.view((effects, effects), (SHARED_INPUTS + 1, SHARED_INPUTS + 1)))
            * &fixed)[0];
        let given = Self {
            scatter: scatter_at(scatter),
            curve: -(solved.columns(effects, SHARED_INPUTS + 1) * &fixed),
            by_effects: -solved.columns(0, effects),
            by_inputs: -solved.columns(effects, SHARED_INPUTS),
            precision: others.view((0, 0), (effects, effects)).into_owned(),
            pull: -(others.view((0, effects), (effects, SHARED_INPUTS + 1)) * &fixed),
            root,
        };
        let free = Effects::new(&given.precision, &given.pull, &vec![FREE_EFFECT; effects])?;
        log_determinants += log_determinant(&given.root);
        Some((given, free.1 - 0.5 * (square + log_determinants)))
    }

    /// A linear function of the coefficients.
    fn linear(&self, weight: f64, of: &DVector<f64>) -> Linear {
        Linear {
            weight,
            mean: of.dot(&self.curve),
            variance: of.dot(&self.root.solve(of)),
            by_effects: self.by_effects.tr_mul(of),
            by_inputs: Shared::from_iterator(self.by_inputs.tr_mul(of).iter().copied()),
            scatter: self.scatter,
        }
    }
}

/// A linear function of the curve of a group, given a scatter.
#[derive(Debug, Clone)]
pub(super) struct Linear {
    pub(super) weight: f64,
    pub(super) mean: f64,
    /// Given effects and inputs.
    pub(super) variance: f64,
    pub(super) by_effects: DVector<f64>,
    pub(super) by_inputs: Shared,
    pub(super) scatter: f64,
}

/// The effects of operators, given their scatters.
#[derive(Debug)]
pub(super) struct Effects {
    pub(super) mean: DVector<f64>,
    pub(super) covariance: DMatrix<f64>,
}

impl Effects {
    /// With these standard deviations before the data, and the logarithm of their marginal likelihood.
    fn new(precision: &DMatrix<f64>, pull: &DVector<f64>, sds: &[f64]) -> Option<(Self, f64)> {
        let sds = DMatrix::from_diagonal(&DVector::from_column_slice(sds));
        // In units of the standard deviations, which may be zero.
        let root =
            Cholesky::new(&sds * precision * &sds + DMatrix::identity(pull.len(), pull.len()))?;
        let covariance = &sds * root.inverse() * &sds;
        let mean = &covariance * pull;
        let log = 0.5 * (pull.dot(&mean) - log_determinant(&root));
        Some((Self { mean, covariance }, log))
    }

    /// The effects of all groups together over scatters of the factors with their weights, and the scatter of each factor.
    pub(super) fn of<'a>(
        frame: &Frame,
        groups: impl Iterator<Item = &'a GroupFit>,
        factors: usize,
    ) -> (Vec<(f64, Self)>, Vec<Estimate>) {
        /// Scatters of a factor.
        const STEPS: usize = 20;
        const MIN_SCATTER: f64 = 1e-5;
        const STEP: f64 = 0.5;
        let sd_of = |step: usize| MIN_SCATTER * (STEP * step as f64).exp();
        let effects = frame.factors.len();
        let (mut precision, mut pull) = (DMatrix::zeros(effects, effects), DVector::zeros(effects));
        for group in groups {
            precision += &group.likeliest().precision;
            pull += &group.likeliest().pull;
        }
        let (mut found, mut logs, mut sds) = (Vec::new(), Vec::new(), Vec::new());
        for point in 0..STEPS.pow(factors as u32) {
            let of_factor: Vec<f64> = (0..factors)
                .map(|factor| sd_of(point / STEPS.pow(factor as u32) % STEPS))
                .collect();
            let of_effect: Vec<f64> = frame
                .factors
                .iter()
                .map(|&factor| of_factor[factor])
                .collect();
            if let Some((effects, log)) = Self::new(&precision, &pull, &of_effect) {
                // Steps are even in the logarithm.
                let prior: f64 = of_factor
                    .iter()
                    .map(|sd| sd.ln() - sd / MEAN_BETWEEN_OPERATORS)
                    .sum();
                found.push(effects);
                logs.push(log + prior);
                sds.push(of_factor);
            }
        }
        let weights = weights(&logs);
        let steps: Vec<f64> = (0..STEPS).map(sd_of).collect();
        let scatters = (0..factors).map(|factor| {
            let of_step = |&sd: &f64| {
                std::iter::zip(&sds, &weights)
                    .filter(|(sds, _)| sds[factor].total_cmp(&sd).is_eq())
                    .map(|(_, weight)| weight)
                    .sum()
            };
            of_weighted(&steps, &steps.iter().map(of_step).collect::<Vec<f64>>())
        });
        let scatters = scatters.collect();
        (relevant(weights.into_iter().zip(found)), scatters)
    }
}

/// A group over the scatters of its drops.
#[derive(Debug)]
pub(super) struct GroupFit {
    /// With their weights.
    given: Vec<(f64, Given)>,
    /// The scatter between drops, relative.
    pub(super) scatter: Estimate,
    /// Standard deviation of the level of a drop by its own errors, relative: root mean square.
    pub(super) own_sd: f64,
}

impl GroupFit {
    /// `None` if the readings are so odd that no curve can be fitted.
    pub(super) fn new(frame: &Frame, cells: &[Cell], inputs: &Inputs) -> Option<Self> {
        /// Steps between the scatters at which sums are kept.
        const FINE: usize = 64;
        let (given, logs): (Vec<Given>, Vec<f64>) = (0..SCATTERS)
            .map(|scatter| Given::new(frame, cells, scatter, inputs))
            .collect::<Option<Vec<_>>>()?
            .into_iter()
            .unzip();
        let steps = 1 + (SCATTERS - 2) * FINE;
        let values: Vec<f64> = (0..steps)
            .map(|step| scatter_at(1) * (SCATTER_STEP * step as f64 / FINE as f64).exp())
            .collect();
        let mut fine: Vec<f64> = (0..steps)
            .map(|step| {
                let prior = values[step].ln() - values[step] / MEAN_BETWEEN_DROPS;
                between(&logs[1..], step / FINE, (step % FINE) as f64 / FINE as f64) + prior
            })
            .collect();
        // Below the smallest scatter there is the rest: its width over that of a step.
        fine[0] = logs[0] + values[0].ln() - (SCATTER_STEP / FINE as f64).ln();
        let fine = weights(&fine);
        let mut coarse = vec![0.0; SCATTERS];
        for (step, weight) in fine.iter().enumerate() {
            let share = (step % FINE) as f64 / FINE as f64;
            coarse[1 + step / FINE] += (1.0 - share) * weight;
            if share > 0.0 {
                coarse[2 + step / FINE] += share * weight;
            }
        }
        let drops: usize = cells.iter().map(|cell| cell.sums.drops).sum();
        let own: f64 = cells.iter().map(|cell| cell.sums.own_variance()).sum();
        Some(Self {
            given: relevant(coarse.into_iter().zip(given)),
            scatter: of_weighted(&values, &fine),
            own_sd: (own / drops as f64).sqrt(),
        })
    }

    /// The group at the scatter of largest weight.
    pub(super) fn likeliest(&self) -> &Given {
        let mut best = &self.given[0];
        for given in &self.given {
            if given.0 > best.0 {
                best = given;
            }
        }
        &best.1
    }

    pub(super) fn linear(&self, of: &DVector<f64>) -> Vec<Linear> {
        self.given
            .iter()
            .map(|(weight, given)| given.linear(*weight, of))
            .collect()
    }

    /// A linear function at the scatter of largest weight.
    pub(super) fn likeliest_linear(&self, of: &DVector<f64>) -> Linear {
        self.likeliest().linear(1.0, of)
    }
}

/// The value between two of some points at equal distances, by the cubic through their neighbours (Catmull and Rom).
fn between(points: &[f64], index: usize, share: f64) -> f64 {
    let at = |offset: isize| points[index.saturating_add_signed(offset).min(points.len() - 1)];
    let (before, from, to, after) = (at(-1), at(0), at(1), at(2));
    let cubic = 3.0 * (from - to) + after - before;
    let square = 2.0 * before - 5.0 * from + 4.0 * to - after;
    from + 0.5 * share * (to - before + share * (square + share * cubic))
}

/// The distribution of a linear function of a group, or of a difference of two groups whose inputs are the same or not.
pub(super) fn distribution(
    of: &[Linear],
    less: Option<(&[Linear], bool)>,
    effects: &[(f64, Effects)],
    inputs: [&Inputs; 2],
) -> Mixture {
    let mut mixture = Mixture::default();
    let mut add = |one: &Linear, other: Option<(&Linear, bool)>| {
        let shared = |by: &Shared, inputs: &Inputs| by.dot(&(inputs.covariance * by));
        let (mut weight, mut mean, mut variance, mut by_effects) =
            (one.weight, one.mean, one.variance, one.by_effects.clone());
        variance += match other {
            None => shared(&one.by_inputs, inputs[0]),
            Some((other, true)) => shared(&(one.by_inputs - other.by_inputs), inputs[0]),
            Some((other, false)) => {
                shared(&one.by_inputs, inputs[0]) + shared(&other.by_inputs, inputs[1])
            }
        };
        if let Some((other, _)) = other {
            weight *= other.weight;
            mean -= other.mean;
            variance += other.variance;
            by_effects -= &other.by_effects;
        }
        for (of_effects, effects) in effects {
            let by = by_effects.dot(&(&effects.covariance * &by_effects));
            mixture.add(
                weight * of_effects,
                mean + by_effects.dot(&effects.mean),
                variance + by,
            );
        }
    };
    for one in of {
        match less {
            None => add(one, None),
            Some((less, same)) => less.iter().for_each(|other| add(one, Some((other, same)))),
        }
    }
    mixture
}
