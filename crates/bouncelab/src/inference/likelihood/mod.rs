//! The likelihood of the times, in one pass over the impacts.
//!
//! Two kinds of noise make the data. The times carry errors, known up to a common factor. The
//! impacts carry scatter: ln e = ln e(v') + ε, and on a good recording that is the larger of the
//! two. So the residual of an impact is
//!
//! r = ln v(flight after) - ln v'(flight before) - ln e(v'),
//!
//! and residuals of neighbours are correlated, because they share times, and share the scatter of
//! missed impacts between them: their covariance C has two bands below the diagonal. Its factors
//! C = L D L' turn the residuals r, in O(N), into independent innovations L⁻¹ r: each is the residual
//! minus its prediction from the ones before it, and D holds their variances. The density of the
//! *times* needs the Jacobian d ln v/dT too, since v depends on drag.
//!
//! The scatter of real impacts has heavier tails than a normal distribution (J.-Y. Montaine et al.,
//! arXiv 1104.0049), so an innovation follows Student's t, and an outlier does not affect the
//! predictions of its neighbours.
//!
//! Every step depends on the one before, so several vectors are evaluated at once, in [`Lanes`].

use nalgebra::{DMatrix, DVector};

use super::banded::{FactorRow, next_factor};
use super::parameters::{DIFFERENCE_STEP, FACTORS_PER_LOGARITHM, OUTLIER_SDS, SCATTER_FREEDOM};
use super::residual::{End, InitialFall, Noise, Residual};
use super::tail::Tail;
use super::trials::Trials;
use super::unknowns::{Model, Point, Slot};
use crate::flight::table::FlightTable;
use crate::restitution::Restitutions;
use crate::simd::{LANES, Lanes, dispatch, one_for_each_lane};

/// An innovation: what one impact adds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Innovation {
    /// Index of its impact among those detected; 0 is the fall.
    pub(super) impact: usize,
    /// In units of its standard deviation.
    pub(super) standardised: f64,
    /// Weight in the fit, 1 for an impact as good as any.
    pub(super) weight: f64,
}

/// The steps of a likelihood, in order.
#[derive(Debug, Clone, Default)]
pub(super) struct Details {
    pub(super) residuals: Vec<Residual<1>>,
    pub(super) innovations: Vec<Innovation>,
    factors: Vec<Factor>,
}

/// The values at a vector, and their derivatives by the unknowns.
pub(super) struct Differences {
    pub(super) point: Point,
    pub(super) details: Details,
    /// Derivatives of each residual, in a row.
    pub(super) residuals: DMatrix<f64>,
    pub(super) log_posterior: f64,
    /// Derivatives of the log posterior.
    pub(super) slope: DVector<f64>,
}

/// Gets the column of each vector, and the row and the lane of each of its steps.
type Observer<'o> = &'o mut dyn FnMut(usize, usize, &Step<LANES>, usize);

/// A row of the Cholesky factors L D L' of the covariance of the residuals.
#[derive(Debug, Clone, Copy)]
struct Factor {
    /// Entries of L two and one columns before the diagonal, and that of D: the variance of the innovation.
    row: FactorRow<f64>,
    /// Share of the scatter in the variance of the residual.
    scatter_share: f64,
}

/// One step of the likelihood: a residual and its innovation.
struct Step<'r, const L: usize> {
    residual: &'r Residual<L>,
    factor: FactorRow<Lanes<L>>,
    scatter_share: Lanes<L>,
    tail: Tail<L>,
    /// Square of the innovation in units of its standard deviation, and the innovation itself.
    square: Lanes<L>,
    innovation: Lanes<L>,
}

/// The parts of the likelihood at points.
pub(super) struct Evaluation<'a, const L: usize> {
    pub(super) falls: [InitialFall; L],
    pub(super) tables: [FlightTable<'a>; L],
    /// The fall as the first impact detected sees it, and each interval.
    pub(super) ends: Vec<End<L>>,
    /// Each residual, and its weight in the fit.
    pub(super) residuals: Vec<Residual<L>>,
    pub(super) weights: Vec<Lanes<L>>,
}

impl<'a> Model<'a> {
    /// Logarithm of prior times likelihood of vectors, each in a column, but for a constant that all models of the same data
    /// share; `None` for one that is not valid. Several at once are faster than one after the other.
    pub(super) fn log_posteriors(&self, vectors: &DMatrix<f64>) -> Vec<Option<f64>> {
        self.log_posteriors_observed(vectors, None)
    }

    fn log_posteriors_observed(
        &self,
        vectors: &DMatrix<f64>,
        mut observer: Option<Observer>,
    ) -> Vec<Option<f64>> {
        let columns = vectors.as_slice().chunks_exact(vectors.nrows());
        let columns: Vec<&[f64]> = columns.collect();
        let mut logs = Vec::with_capacity(columns.len());
        for group in columns.chunks(LANES) {
            let first = logs.len();
            let lanes: [&[f64]; LANES] = one_for_each_lane(group);
            let mut row = 0;
            let found = self.log_posteriors_in_lanes(&lanes, &mut |step| {
                if let Some(observer) = &mut observer {
                    for lane in 0..group.len() {
                        observer(first + lane, row, step, lane);
                    }
                }
                row += 1;
            });
            logs.extend_from_slice(&found[..group.len()]);
        }
        logs
    }

    /// The steps of the likelihood at a vector; `None` if it is not valid.
    pub(super) fn details(&self, vector: &[f64]) -> Option<Details> {
        let mut details = Details::default();
        let vector = DMatrix::from_column_slice(vector.len(), 1, vector);
        let mut observe = |_, _, step: &Step<LANES>, lane: usize| details.add(step, lane);
        self.log_posteriors_observed(&vector, Some(&mut observe))[0]?;
        Some(details)
    }

    /// The parts of the likelihood at points; `None` if one of them is not valid.
    pub(super) fn evaluate<const L: usize>(
        &self,
        points: &[Point; L],
    ) -> Option<Evaluation<'a, L>> {
        let trials = self.trials_at(points)?;
        let mut evaluation = Evaluation {
            falls: trials.falls,
            tables: trials.tables,
            ends: Vec::with_capacity(self.rows_of_data() + 1),
            residuals: Vec::with_capacity(self.rows_of_data()),
            weights: Vec::with_capacity(self.rows_of_data()),
        };
        // A release is compared with the fall; without one the first step is that of the first interval.
        if self.release_s.is_none() {
            evaluation.ends.push(InitialFall::end(&evaluation.falls));
        }
        let logs = dispatch(
            #[inline(always)]
            || {
                self.log_likelihood(&trials, &mut |step, end| {
                    evaluation.ends.push(*end);
                    evaluation.residuals.push(*step.residual);
                    evaluation.weights.push(step.tail.weight(step.square));
                })
            },
        );
        let valid = trials
            .valid
            .iter()
            .zip(logs.0)
            .all(|(valid, log)| *valid && log.is_finite());
        valid.then_some(evaluation)
    }

    /// Logarithm of the density of each interval given those before it, in 1/s, at points; `None` if one of them is not
    /// valid.
    pub(super) fn log_densities<const L: usize>(
        &self,
        points: &[Point; L],
    ) -> Option<Vec<Lanes<L>>> {
        let trials = self.trials_at(points)?;
        let mut densities = Vec::with_capacity(self.rows_of_data());
        let mut report = |step: &Step<L>, end: &End<L>| {
            let width = step.tail.width() * step.factor[2] * std::f64::consts::TAU;
            let of_residual = step.tail.log_density(step.square) - width.ln() * 0.5;
            densities.push(of_residual + end.launch_per_s.ln());
        };
        dispatch(
            #[inline(always)]
            || self.log_likelihood(&trials, &mut report),
        );
        // A release is no interval.
        densities.drain(..densities.len() - self.observed.intervals.len());
        trials.valid.iter().all(|valid| *valid).then_some(densities)
    }

    /// Logarithm of prior times likelihood of each vector; every step is reported.
    fn log_posteriors_in_lanes<const L: usize>(
        &self,
        vectors: &[&[f64]; L],
        report: &mut dyn FnMut(&Step<L>),
    ) -> [Option<f64>; L] {
        dispatch(
            #[inline(always)]
            || {
                let Some(trials) = self.trials(vectors) else {
                    return [None; L];
                };
                let height_slope = Lanes::of(|lane| trials.falls[lane].height_slope);
                let log_density = Lanes::of(|lane| trials.points[lane].log_density);
                let log_likelihood = self.log_likelihood(&trials, &mut |step, _| report(step));
                let total = self.log_prior(vectors, height_slope) + log_density + log_likelihood;
                std::array::from_fn(|lane| {
                    let valid = trials.valid[lane] && total.0[lane].is_finite();
                    valid.then_some(total.0[lane])
                })
            },
        )
    }

    /// Student's t of every innovation, in order of time, as a density of the times.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn log_likelihood<const L: usize>(
        &self,
        trials: &Trials<L>,
        report: &mut dyn FnMut(&Step<L>, &End<L>),
    ) -> Lanes<L> {
        let observed = self.observed;
        let Trials { points, falls, .. } = trials;
        let laws = Restitutions::of(&points.map(|point| point.law));
        let mut likelihood = Likelihood::new(Noise::new(&observed.sigma_s, points));
        let mut before = InitialFall::end(falls);
        if let Some(release_s) = self.release_s {
            let first_s = observed.impacts[0].time_s;
            let residual = Residual::of_release(first_s, release_s, falls);
            report(&likelihood.add(&residual), &before);
        }
        let mut jacobian = Product::default();
        for interval in 0..observed.intervals.len() {
            let after = self.end(interval, trials);
            let residual = Residual::between(&before, &after, interval, &laws);
            report(&likelihood.add(&residual), &after);
            jacobian.multiply(after.launch_per_s);
            before = after;
        }
        likelihood.log() + jacobian.ln()
    }

    /// The ends of an interval for each of the trials.
    #[inline(always)]
    fn end<const L: usize>(&self, interval: usize, trials: &Trials<L>) -> End<L> {
        let observed = &self.observed.intervals[interval];
        let flights = observed.flights as f64;
        let gravity = Lanes::of(|lane| trials.points[lane].gravity_m_s2);
        let contact_s = Lanes::of(|lane| trials.points[lane].contact_time_s);
        let gravity_time = gravity * (-(contact_s * flights) + observed.duration_s);
        if observed.flights > 1 {
            return End::gather(std::array::from_fn(|lane| {
                let (table, point) = (&trials.tables[lane], &trials.points[lane]);
                End::of_gap(table, gravity_time.0[lane], observed.flights, point)
            }));
        }
        let curves = trials.flights.curves(interval);
        let per_nominal = self.timed_flights.per_nominal(interval);
        End::of_flight(&curves, gravity, gravity_time, per_nominal)
    }

    /// The information about the unknowns at a vector, J' W J with the derivatives J of the whitened residuals and their
    /// weights W, plus that of noise and priors: the expected curvature of the log posterior. Exact for a normal posterior,
    /// and accurate enough for a search.
    pub(super) fn information(
        &self,
        vector: &[f64],
        point: &Point,
        mut slopes: DMatrix<f64>,
        details: &Details,
    ) -> DMatrix<f64> {
        details.whiten(&mut slopes);
        let mut weighted = slopes.clone();
        for (mut row, innovation) in weighted.row_iter_mut().zip(&details.innovations) {
            row *= innovation.weight;
        }
        let mut information = slopes.transpose() * weighted;
        // Fisher information of ln sigma: 2 for each normal residual, 2 nu/(nu + 3) for Student's t. A residual of
        // variance a + b, with a by scatter and b by timing, has the shares of both as derivatives of ln sigma.
        let per_residual = 2.0 * SCATTER_FREEDOM / (SCATTER_FREEDOM + 3.0);
        let scatter = self.index(Slot::Scatter).map(|index| vector[index]);
        let scatter_slope = scatter.map_or(0.0, |normal| self.scatter.log_slope(normal));
        let shares = |slot: Slot, factor: &Factor| match slot {
            Slot::Scatter => scatter_slope * factor.scatter_share,
            Slot::Timing => self.timing_sd * (1.0 - factor.scatter_share),
            _ => 0.0,
        };
        for (i, &a) in self.slots().iter().enumerate() {
            for (j, &b) in self.slots().iter().enumerate() {
                let product = |factor: &Factor| shares(a, factor) * shares(b, factor);
                information[(i, j)] +=
                    per_residual * details.factors.iter().map(product).sum::<f64>();
            }
            information[(i, i)] += self.prior_information(a, point);
        }
        information
    }

    /// A vector and the derivatives there by the unknowns, by central differences.
    pub(super) fn differences(&self, vector: &[f64]) -> Option<Differences> {
        let unknowns = vector.len();
        // Steps up in the first columns, steps down in as many others, and the vector itself in the last.
        let sign = |column: usize| if column < unknowns { 1.0 } else { -1.0 };
        let mut tried = DMatrix::from_fn(unknowns, 2 * unknowns + 1, |unknown, _| vector[unknown]);
        for column in 0..2 * unknowns {
            tried[(column % unknowns, column)] += sign(column) * DIFFERENCE_STEP;
        }
        let mut residuals = DMatrix::zeros(self.rows_of_data(), unknowns);
        let mut details = Details::default();
        let mut observe = |column: usize, row: usize, step: &Step<LANES>, lane: usize| {
            if column < 2 * unknowns {
                residuals[(row, column % unknowns)] += sign(column) * step.residual.value.0[lane];
            } else {
                details.add(step, lane);
            }
        };
        let logs = self.log_posteriors_observed(&tried, Some(&mut observe));
        let logs = logs.into_iter().collect::<Option<Vec<f64>>>()?;
        residuals /= 2.0 * DIFFERENCE_STEP;
        let slope =
            |unknown: usize| (logs[unknown] - logs[unknowns + unknown]) / (2.0 * DIFFERENCE_STEP);
        Some(Differences {
            point: self.point(vector)?,
            details,
            residuals,
            slope: DVector::from_fn(unknowns, |unknown, _| slope(unknown)),
            log_posterior: logs[2 * unknowns],
        })
    }

    /// Number of residuals.
    fn rows_of_data(&self) -> usize {
        self.observed.intervals.len() + usize::from(self.release_s.is_some())
    }
}

impl Details {
    /// Adds a step in one of its lanes.
    fn add<const L: usize>(&mut self, step: &Step<L>, lane: usize) {
        let [second, first, variance] = step.factor.map(|entry| entry.0[lane]);
        self.residuals.push(step.residual.in_lane(lane));
        self.factors.push(Factor {
            row: [second, first, variance],
            scatter_share: step.scatter_share.0[lane],
        });
        self.innovations.push(Innovation {
            impact: step.residual.impact,
            standardised: step.innovation.0[lane] / variance.sqrt(),
            weight: step.tail.weight(step.square).0[lane],
        });
    }

    /// Turns derivatives of the residuals into those of independent residuals of unit variance: D^-1/2 L⁻¹ times each
    /// column, by forward substitution.
    fn whiten(&self, slopes: &mut DMatrix<f64>) {
        for mut column in slopes.column_iter_mut() {
            for (row, factor) in self.factors.iter().enumerate() {
                let [second, first, _] = factor.row;
                let one = row.checked_sub(1).map_or(0.0, |r| column[r]);
                let two = row.checked_sub(2).map_or(0.0, |r| column[r]);
                column[row] -= first * one + second * two;
            }
            for (entry, factor) in column.iter_mut().zip(&self.factors) {
                *entry /= factor.row[2].sqrt();
            }
        }
    }
}

/// A likelihood after some of its residuals.
struct Likelihood<'o, const L: usize> {
    noise: Noise<'o, L>,
    /// The last two residuals, with their factors and bounded innovations; the last first.
    before: [Option<Residual<L>>; 2],
    factors: [FactorRow<Lanes<L>>; 2],
    bounded: [Lanes<L>; 2],
    densities: Lanes<L>,
    widths: Product<L>,
}

impl<'o, const L: usize> Likelihood<'o, L> {
    #[inline(always)]
    fn new(noise: Noise<'o, L>) -> Self {
        let [zero, one] = [0.0, 1.0].map(Lanes::all);
        Self {
            noise,
            before: [None; 2],
            // The matrix is continued upwards by the unit matrix.
            factors: [[zero, zero, one]; 2],
            bounded: [zero; 2],
            densities: zero,
            widths: Product::default(),
        }
    }

    /// Adds a residual.
    #[inline(always)]
    fn add<'r>(&mut self, residual: &'r Residual<L>) -> Step<'r, L> {
        let noise = &self.noise;
        // The row of C: its diagonal entry, and those one and two columns before it.
        let by_scatter = noise.scatter * residual.scatter;
        let diagonal = by_scatter + noise.by_time(residual) + residual.own_variance;
        // Only neighbours share the scatter of the impacts missed between them.
        let first = match &self.before[0] {
            Some(it) => {
                noise.shared_by_time(it, residual) + noise.scatter * residual.scatter_before
            }
            None => Lanes::all(0.0),
        };
        let second = match &self.before[1] {
            Some(it) => noise.shared_by_time(it, residual),
            None => Lanes::all(0.0),
        };
        let scatter_share = by_scatter / diagonal;
        let factor = next_factor([second, first, diagonal], self.factors);
        let [second, first, variance] = factor;
        // Forward substitution: row of L times the innovations before, where an outlier z is bounded to z/(1 + (z/3)^4).
        let predicted = first * self.bounded[0] + second * self.bounded[1];
        let innovation = residual.value - predicted;
        let square = innovation * innovation / variance;
        let tail = Tail::of(scatter_share);
        self.densities = self.densities + tail.log_density(square);
        self.widths.multiply(variance * tail.width());
        let excess = square * (1.0 / (OUTLIER_SDS * OUTLIER_SDS));
        self.bounded = [innovation / (excess * excess + 1.0), self.bounded[0]];
        self.factors = [factor, self.factors[0]];
        self.before = [Some(*residual), self.before[0]];
        Step {
            residual,
            factor,
            scatter_share,
            tail,
            square,
            innovation,
        }
    }

    #[inline(always)]
    fn log(self) -> Lanes<L> {
        self.densities - self.widths.ln() * 0.5
    }
}

/// The logarithm of a product of many factors: a logarithm for each of them would take longer.
struct Product<const L: usize> {
    /// The product that is not yet in the sum, and the number of all factors so far.
    factors: Lanes<L>,
    count: usize,
    log: Lanes<L>,
}

impl<const L: usize> Default for Product<L> {
    #[inline(always)]
    fn default() -> Self {
        Self {
            factors: Lanes::all(1.0),
            count: 0,
            log: Lanes::all(0.0),
        }
    }
}

impl<const L: usize> Product<L> {
    #[inline(always)]
    fn multiply(&mut self, factor: Lanes<L>) {
        self.factors = self.factors * factor;
        self.count += 1;
        if self.count.is_multiple_of(FACTORS_PER_LOGARITHM) {
            self.log = self.log + self.factors.ln();
            self.factors = Lanes::all(1.0);
        }
    }

    #[inline(always)]
    fn ln(self) -> Lanes<L> {
        self.log + self.factors.ln()
    }
}

#[cfg(test)]
pub(super) mod tests;
