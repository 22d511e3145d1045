//! The likelihood of the times, in one pass over the impacts.
//!
//! Two kinds of noise make the data. The times carry errors, known up to a common factor. The
//! impacts carry scatter: ln e = ln e(v') + ε, and on a good recording that is the larger of the
//! two. So the residual of an impact is
//!
//! r = ln v(flight after) - ln v'(flight before) - ln e(v'),
//!
//! and residuals of neighbours are correlated, because they share times, and share the scatter of
//! missed impacts between them: their covariance has two bands beside the diagonal. Its Cholesky
//! factors turn them, in O(N), into innovations: what each impact adds to what the ones before it
//! foretold. The density of the *times* needs the Jacobian d ln v/dT too, since v depends on drag.
//!
//! The scatter of real impacts has heavier tails than a normal distribution (J.-Y. Montaine et al.,
//! arXiv 1104.0049), so an innovation follows Student's t, and what an odd one seems to say of the
//! times of its neighbours is taken back.

use nalgebra::{DMatrix, DVector};

use super::banded::{BEFORE_THE_FIRST, next_factor};
use super::model::{Height, LOG_SCATTER_SD, Model, Point, Slot};
use super::priors::Measured;
use super::residual::{End, InitialFall, Residual, covariance_by_time, variance_by_time};
use super::tail::{FREEDOM, Tail};
use crate::flight::table::FlightTable;

/// Beyond about so many standard deviations an innovation is odd, and says nothing of its
/// neighbours.
const ODD: f64 = 3.0;

/// Steps of Newton's method for a value that need not be exact.
const ROUGH: usize = 1;

/// An innovation: what one impact adds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Innovation {
    /// The impact it belongs to, by its place among those detected; the first is the drop itself.
    pub(super) impact: usize,
    /// In units of its standard deviation.
    pub(super) standardised: f64,
    /// Weight in the fit, 1 for an impact as good as any.
    pub(super) weight: f64,
}

/// Works out likelihoods for one model; keeps its room, so that thousands cost no allocation.
#[derive(Debug, Clone)]
pub(super) struct Evaluator<'a> {
    pub(super) model: &'a Model<'a>,
    ends: Vec<End>,
    residuals: Vec<Residual>,
    factors: Vec<Factor>,
    pub(super) innovations: Vec<Innovation>,
}

/// Derivatives by the unknowns.
pub(super) struct Differences {
    /// Of each residual, in a row.
    pub(super) residuals: DMatrix<f64>,
    /// Of the log posterior.
    posterior: DVector<f64>,
}

/// A row of the Cholesky factors L D L' of the covariance of the residuals.
#[derive(Debug, Clone, Copy)]
struct Factor {
    /// Entries of L one and two places before the diagonal.
    before: [f64; 2],
    /// Entry of D: the variance of the innovation.
    variance: f64,
    /// Which share of the variance of the residual is scatter.
    scatter_share: f64,
}

/// A drop as the times tell it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DropState {
    pub(super) drop_height_m: f64,
    /// From the release to the first impact detected, s.
    pub(super) release_to_first_s: f64,
    /// Speed at each impact detected, m/s.
    pub(super) impact_speeds: Vec<f64>,
    /// Launch speed after each impact detected but the last, m/s.
    pub(super) launch_speeds: Vec<f64>,
}

/// A product of many factors, as its logarithm: a logarithm for each of them would take longer.
#[derive(Debug, Clone, Copy)]
struct Product {
    /// What is not yet in the sum.
    factor: f64,
    log: f64,
}

impl Default for Product {
    fn default() -> Self {
        Self {
            factor: 1.0,
            log: 0.0,
        }
    }
}

impl Product {
    #[inline]
    fn multiply(&mut self, factor: f64) {
        self.factor *= factor;
        // One more factor, whatever it is, leaves this a normal number.
        if !(1e-100..1e100).contains(&self.factor) {
            self.log = self.ln();
            self.factor = 1.0;
        }
    }

    fn ln(self) -> f64 {
        self.log + self.factor.ln()
    }
}

impl<'a> Evaluator<'a> {
    pub(super) fn new(model: &'a Model<'a>) -> Self {
        Self {
            model,
            ends: Vec::new(),
            residuals: Vec::new(),
            factors: Vec::new(),
            innovations: Vec::new(),
        }
    }

    /// The values that a vector stands for; `None` where it makes no sense.
    pub(super) fn point(&self, vector: &[f64]) -> Option<Point> {
        let mut point = self.model.point(vector)?;
        let place = vector[self.model.place(Slot::Height)?];
        match self.model.height() {
            Height::Speed => point.fall_launch_m_s = place.exp(),
            Height::Measured(Measured { value, sd }) => {
                let gravity_height = point.gravity_m_s2 * (value + sd * place);
                point.fall_launch_m_s = self.table(&point)?.rising_to(gravity_height)?;
            }
            Height::FromFirstFlight => {
                let noise = self.first_noise(&point);
                point.fall_launch_m_s = self.suggested_launch(&point)? * (noise * place).exp();
                point.log_height_unit = noise.ln();
            }
        }
        Some(point)
    }

    /// About the launch that would rise to the drop height, by the first flight and the law. Any smooth
    /// function of the unknowns serves: one step of Newton's method is near enough.
    fn suggested_launch(&self, point: &Point) -> Option<f64> {
        let first = self.model.observed.intervals[0];
        let flight_s = first.duration_s / first.flights as f64 - point.contact_time_s;
        let table = self.table(point)?;
        let launch = table.lasting(point.gravity_m_s2 * flight_s)?.launch;
        table.launch_leading_to(point.impact_before(launch, ROUGH)?, ROUGH)
    }

    /// About the standard deviation of ln(launch speed) after the first impact detected, given the fall.
    fn first_noise(&self, point: &Point) -> f64 {
        let observed = self.model.observed;
        let sigma_s = observed.sigma_s[0].hypot(observed.sigma_s[1]);
        point
            .scatter
            .hypot(point.timing * sigma_s / observed.intervals[0].duration_s)
    }

    /// Logarithm of prior times likelihood, but for a constant that all models of the same data
    /// share; `None` where the vector makes no sense.
    pub(super) fn log_posterior(&mut self, vector: &[f64]) -> Option<f64> {
        let point = self.point(vector)?;
        let (opening, log_jacobian) = self.residuals_at(&point)?;
        let prior = self.model.log_prior(vector, opening.height_slope);
        let log_jacobian = log_jacobian + point.log_height_unit;
        let total = prior + log_jacobian + self.log_density(&point);
        total.is_finite().then_some(total)
    }

    /// The residuals at a point, for those who want to take them apart.
    pub(super) fn residuals(&mut self, point: &Point) -> Option<&[Residual]> {
        self.residuals_at(point)?;
        Some(&self.residuals)
    }

    /// The drop that the times tell, if the unknowns have these values.
    pub(super) fn state(&mut self, point: &Point) -> Option<DropState> {
        let (opening, _) = self.residuals_at(point)?;
        let mut impact_speeds = vec![opening.impact];
        impact_speeds.extend(self.ends.iter().map(|end| end.impact));
        Some(DropState {
            drop_height_m: opening.gravity_height / point.gravity_m_s2,
            release_to_first_s: opening.time_s,
            impact_speeds,
            launch_speeds: self.ends.iter().map(|end| end.launch).collect(),
        })
    }

    /// The flights under the drag of a point; `None` if it is absurd.
    pub(super) fn table(&self, point: &Point) -> Option<FlightTable<'a>> {
        self.model.media.flights.at(point.drag_strength)
    }

    /// Fills the residuals; the opening and the logarithm of the Jacobian.
    fn residuals_at(&mut self, point: &Point) -> Option<(InitialFall, f64)> {
        let table = self.table(point)?;
        let opening = InitialFall::new(&table, point, self.model.missed_first)?;
        self.ends.clear();
        for interval in &self.model.observed.intervals {
            let contact_s = interval.flights as f64 * point.contact_time_s;
            let gravity_time = point.gravity_m_s2 * (interval.duration_s - contact_s);
            let end = match interval.flights {
                1 => End::of_flight(&table.lasting(gravity_time)?, point.gravity_m_s2),
                flights => End::of_gap(&table, gravity_time, flights, point)?,
            };
            self.ends.push(end);
        }
        self.residuals.clear();
        if let Some(release_s) = self.model.release_s {
            let first_s = self.model.observed.impacts[0].time_s;
            let residual = Residual::of_release(first_s, release_s, &opening);
            self.residuals.push(residual);
        }
        let mut jacobian = Product::default();
        let mut before = opening.end();
        for (impact, after) in self.ends.iter().enumerate() {
            self.residuals
                .push(Residual::between(&before, after, impact, point));
            jacobian.multiply(after.launch_per_s);
            before = *after;
        }
        Some((opening, jacobian.ln()))
    }

    /// Student's t of every innovation; notes the innovations.
    fn log_density(&mut self, point: &Point) -> f64 {
        self.factorise(point);
        self.innovations.clear();
        let mut sum = 0.0;
        let mut widths = Product::default();
        // The innovations before, as far as they are believed.
        let mut before = [0.0; 2];
        for (residual, factor) in self.residuals.iter().zip(&self.factors) {
            let z = residual.value - factor.before[0] * before[0] - factor.before[1] * before[1];
            let square = z * z / factor.variance;
            let tail = Tail::of(factor.scatter_share);
            sum += tail.log_density(square);
            widths.multiply(factor.variance * tail.width());
            self.innovations.push(Innovation {
                impact: residual.impact,
                standardised: z / factor.variance.sqrt(),
                weight: tail.weight(square),
            });
            let odd = square / (ODD * ODD);
            before = [z / (1.0 + odd * odd), before[0]];
        }
        sum - 0.5 * widths.ln()
    }

    /// Cholesky factors of the covariance of the residuals.
    fn factorise(&mut self, point: &Point) {
        let observed = self.model.observed;
        let scatter = point.scatter * point.scatter;
        let variance = |impact: usize| point.time_variance_s2(observed, impact);
        self.factors.clear();
        let mut before = BEFORE_THE_FIRST;
        for (row, residual) in self.residuals.iter().enumerate() {
            let by_time = variance_by_time(residual, variance);
            let by_scatter = scatter * residual.scatter;
            let diagonal = residual.own_variance + by_scatter + by_time;
            let (mut first, mut second) = (0.0, 0.0);
            if row > 0 {
                first = covariance_by_time(&self.residuals[row - 1], residual, variance)
                    + scatter * residual.scatter_before;
            }
            if row > 1 {
                second = covariance_by_time(&self.residuals[row - 2], residual, variance);
            }
            let factor = next_factor([second, first, diagonal], before);
            before = [factor, before[0]];
            let [second, first, variance] = factor;
            self.factors.push(Factor {
                before: [first, second],
                variance,
                scatter_share: by_scatter / diagonal,
            });
        }
    }

    /// Slope and curvature of the log posterior at a vector.
    pub(super) fn slope_and_information(
        &mut self,
        vector: &[f64],
    ) -> Option<(DVector<f64>, DMatrix<f64>)> {
        let Differences {
            residuals,
            posterior,
        } = self.differences(vector)?;
        self.log_posterior(vector)?;
        Some((posterior, self.information(vector, residuals)))
    }

    /// The information about the unknowns at the vector of the last evaluation, by the derivatives of the
    /// residuals: how fast the log posterior falls off in each direction. Exact for a normal posterior,
    /// and near enough for a search.
    fn information(&self, vector: &[f64], mut slopes: DMatrix<f64>) -> DMatrix<f64> {
        self.whiten(&mut slopes);
        let model = self.model;
        let mut weighted = slopes.clone();
        for (mut row, innovation) in weighted.row_iter_mut().zip(&self.innovations) {
            row *= innovation.weight;
        }
        let mut information = slopes.transpose() * weighted;
        // The noise: the logarithm of a standard deviation is known to 1/2^1/2 from one residual,
        // less from one with tails.
        let tells = 2.0 * FREEDOM / (FREEDOM + 3.0);
        let shares = |slot: Slot, factor: &Factor| match slot {
            Slot::Scatter => LOG_SCATTER_SD * factor.scatter_share,
            Slot::Timing => model.timing_sd * (1.0 - factor.scatter_share),
            _ => 0.0,
        };
        for (i, &a) in model.slots().iter().enumerate() {
            for (j, &b) in model.slots().iter().enumerate() {
                let product = |factor: &Factor| shares(a, factor) * shares(b, factor);
                information[(i, j)] += tells * self.factors.iter().map(product).sum::<f64>();
            }
            information[(i, i)] += model.prior_information(a, vector[i]);
        }
        information
    }

    /// Turns derivatives of the residuals into those of independent residuals of unit variance.
    fn whiten(&self, slopes: &mut DMatrix<f64>) {
        for mut column in slopes.column_iter_mut() {
            for row in 0..self.factors.len() {
                let Factor { before, .. } = self.factors[row];
                let one = row.checked_sub(1).map_or(0.0, |r| column[r]);
                let two = row.checked_sub(2).map_or(0.0, |r| column[r]);
                column[row] -= before[0] * one + before[1] * two;
            }
            for (entry, factor) in column.iter_mut().zip(&self.factors) {
                *entry /= factor.variance.sqrt();
            }
        }
    }

    /// Derivatives by the unknowns, by central differences.
    pub(super) fn differences(&mut self, vector: &[f64]) -> Option<Differences> {
        const STEP: f64 = 1e-4;
        let mut moved = vector.to_vec();
        let mut differences = Differences {
            residuals: DMatrix::zeros(self.rows_of_data(), vector.len()),
            posterior: DVector::zeros(vector.len()),
        };
        for i in 0..vector.len() {
            for step in [STEP, -STEP] {
                moved[i] = vector[i] + step;
                let share = 0.5 / step;
                differences.posterior[i] += share * self.log_posterior(&moved)?;
                for (row, residual) in self.residuals.iter().enumerate() {
                    differences.residuals[(row, i)] += share * residual.value;
                }
            }
            moved[i] = vector[i];
        }
        Some(differences)
    }

    /// How many residuals the data make.
    fn rows_of_data(&self) -> usize {
        self.model.observed.intervals.len() + usize::from(self.model.release_s.is_some())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Options;
    use crate::drag::DragLaw;
    use crate::flight::Environment;
    use crate::impact::Impact;
    use crate::inference::model::{Medium, ReferenceSpeed};
    use crate::inference::observed::Observed;
    use crate::inference::priors::{LawKind, Measured, Priors};

    /// Times of a drop with two gaps, one of them two impacts wide, and a release.
    fn impacts() -> Vec<Impact> {
        let times = [
            (1, 0.3),
            (2, 0.8605),
            (3, 1.3877),
            (5, 2.3553),
            (6, 2.8035),
            (9, 3.9990),
            (10, 4.3544),
        ];
        times
            .map(|(number, time_s)| Impact::new(number, time_s).with_time_sd_s(2e-4))
            .to_vec()
    }

    /// Works with the likelihood of the times above, for a law that changes with speed.
    fn with_evaluator<T>(impacts: &[Impact], work: impl FnOnce(&mut Evaluator, &[f64]) -> T) -> T {
        let settings = Options::default();
        let environment = Environment {
            drag: DragLaw::Constant(0.4),
            ..settings.environment
        };
        let priors = Priors {
            release_s: Some(Measured {
                value: -0.02,
                sd: 0.003,
            }),
            ..Priors::default()
        };
        let observed = Observed::new(impacts, settings.contact_time_s).unwrap();
        let media = Medium::new(
            &settings.ball,
            &environment,
            environment.drag,
            &observed,
            &priors,
        )
        .unwrap();
        let middle = ReferenceSpeed::new(&observed, &media, settings.contact_time_s).unwrap();
        let model = Model::new(
            &observed,
            &media,
            &middle,
            LawKind::Linear,
            1,
            &priors,
            settings.contact_time_s,
        );
        let mut vector = model.start();
        vector[model.place(Slot::Shape(0)).unwrap()] = 0.6;
        work(&mut Evaluator::new(&model), &vector)
    }

    fn values(impacts: &[Impact]) -> Vec<f64> {
        with_evaluator(impacts, |evaluator, vector| {
            let point = evaluator.point(vector).unwrap();
            let residuals = evaluator.residuals(&point).unwrap();
            residuals.iter().map(|residual| residual.value).collect()
        })
    }

    /// The derivatives by the times, gaps included, against moving each time a little. The middle of
    /// the data, at which laws are pinned, moves with them, but by far less.
    #[test]
    fn derivatives_by_the_times() {
        const STEP_S: f64 = 1e-6;
        let impacts = impacts();
        let residuals = with_evaluator(&impacts, |evaluator, vector| {
            let point = evaluator.point(vector).unwrap();
            evaluator.residuals(&point).unwrap().to_vec()
        });
        let pinned = |moved: usize, by_s: f64| {
            let mut times = impacts.clone();
            times[moved].time_s += by_s;
            // The same law: the point of the unmoved times.
            let point = with_evaluator(&impacts, |evaluator, vector| {
                evaluator.point(vector).unwrap()
            });
            with_evaluator(&times, |evaluator, _| {
                let residuals = evaluator.residuals(&point).unwrap();
                residuals.iter().map(|r| r.value).collect::<Vec<f64>>()
            })
        };
        for moved in 0..impacts.len() {
            let (above, below) = (pinned(moved, STEP_S), pinned(moved, -STEP_S));
            for (row, residual) in residuals.iter().enumerate() {
                let expected = (above[row] - below[row]) / (2.0 * STEP_S);
                let place = (moved + 1).checked_sub(residual.impact);
                let stated = place
                    .and_then(|p| residual.timing.get(p))
                    .copied()
                    .unwrap_or(0.0);
                assert!(
                    (stated - expected).abs() < 2e-3,
                    "row {row} time {moved}: {stated} {expected}"
                );
            }
        }
    }

    /// The banded factors against the dense covariance of the same noise.
    #[test]
    fn factors_are_those_of_the_dense_covariance() {
        with_evaluator(&impacts(), |evaluator, vector| {
            let point = evaluator.point(vector).unwrap();
            evaluator.log_posterior(vector).unwrap();
            let residuals = evaluator.residuals(&point).unwrap().to_vec();
            let (count, times) = (residuals.len(), evaluator.model.observed.sigma_s.len());
            let mut by_time = DMatrix::zeros(count, times);
            for (row, residual) in residuals.iter().enumerate() {
                for (place, slope) in residual.timing.iter().enumerate() {
                    if let Some(time) = (residual.impact + place).checked_sub(1)
                        && time < times
                    {
                        by_time[(row, time)] =
                            slope * point.timing * evaluator.model.observed.sigma_s[time];
                    }
                }
            }
            let mut dense = &by_time * by_time.transpose();
            let scatter = point.scatter * point.scatter;
            for (row, residual) in residuals.iter().enumerate() {
                dense[(row, row)] += scatter * residual.scatter + residual.own_variance;
                if row > 0 {
                    dense[(row, row - 1)] += scatter * residual.scatter_before;
                    dense[(row - 1, row)] += scatter * residual.scatter_before;
                }
            }
            let expected = nalgebra::Cholesky::new(dense).unwrap().l();
            for (row, factor) in evaluator.factors.iter().enumerate() {
                let diagonal = expected[(row, row)];
                assert!(
                    (factor.variance / (diagonal * diagonal) - 1.0).abs() < 1e-9,
                    "row {row}"
                );
            }
        });
    }

    /// What the scatter of a missed impact does, against a drop in which one scatters.
    #[test]
    fn missed_impacts_scatter() {
        let residuals = with_evaluator(&impacts(), |evaluator, vector| {
            let point = evaluator.point(vector).unwrap();
            evaluator.residuals(&point).unwrap().to_vec()
        });
        // The residuals beside a gap carry more than their own scatter, and share it.
        assert!(residuals[1].scatter > 1.0, "a first impact was missed");
        assert!(residuals[4].scatter > 1.1 && residuals[4].scatter_before != 0.0);
        assert!((residuals[2].scatter - 1.0).abs() < 1e-12);
        assert_eq!(values(&impacts()).len(), residuals.len());
    }
}
