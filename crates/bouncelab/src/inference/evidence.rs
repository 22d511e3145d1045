//! What a drop says of its restitution curve to a study of many drops: its likelihood, from the draws of its posterior.
//!
//! In the coordinates of the law, ln e* and standard normals n, and the shared inputs z, the posterior is nearly Gaussian with
//! the precision Λ of its draws. The prior of the normals has the precision D = 1, that of ln e* is flat or stated, so the
//! likelihood of the law given z has the precision `Λ_cc` - D. With the Cholesky root L of `Λ_cc` and L⁻¹ D L⁻ᵀ = Q μ Q', the rows of
//! (1 - μ)^½ Q' L' are independent readings; μ is the share of the prior in each.

use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use super::candidates::SampledPosterior;
use super::posterior::Posterior;
use super::unknowns::Slot;
use crate::groups::{CurveEvidence, HeightEvidence, Reading, SHARED_INPUTS};

/// A direction in which the prior has a larger share of the information than this has no reading.
const MAX_SHARE_OF_PRIOR: f64 = 0.9;

/// Speeds at which a curve is compared with the law, for each coordinate of the law.
const POINTS: usize = 3;

/// Impacts whose speeds differ by a smaller factor say nothing of a slope.
const MIN_RANGE: f64 = 1.05;

/// Coordinates of the law that move the curve by less than the root of this, compared with ln e*, do not move it.
const MIN_EFFECT: f64 = 1e-10;

/// An input that varies less than this has no uncertainty.
const MIN_VARIANCE: f64 = 1e-6;

/// The shared inputs that are unknowns; after them comes the choice of the medium.
const SHARED: [Slot; SHARED_INPUTS - 1] = [Slot::Drag, Slot::Gravity, Slot::Inputs, Slot::Contact];

impl Posterior {
    /// What this drop says of the restitution curve of its ball and surface, for a [study](crate::groups::Study) of many
    /// drops. `None` if the draws are too few or too odd to be described by their covariance.
    pub fn evidence(&self) -> Option<CurveEvidence> {
        let draws = Drawn::new(
            &self.sampled,
            &self.draws.drop_height_m,
            self.fitted_speeds_m_s,
        )?;
        let effective = self.sampling.effective_draws.min(draws.draws as f64);
        let readings = draws.readings(effective)?;
        let mut inputs = [0.0; SHARED_INPUTS];
        let mut inputs_covariance = [[0.0; SHARED_INPUTS]; SHARED_INPUTS];
        for (input, row) in inputs_covariance.iter_mut().enumerate() {
            inputs[input] = draws.mean[draws.coordinates + input];
            for (other, covariance) in row.iter_mut().enumerate() {
                *covariance =
                    draws.covariance[(draws.coordinates + input, draws.coordinates + other)];
            }
        }
        Some(CurveEvidence {
            range_m_s: self.fitted_speeds_m_s,
            height: draws.height().map(|height| HeightEvidence {
                stated_m: self.sampled.priors.drop_height_m,
                ..height
            }),
            speeds_m_s: draws.speeds_m_s,
            readings,
            inputs,
            inputs_covariance,
        })
    }
}

/// The draws under the most probable law: its coordinates, the shared inputs, ln e at some speeds, and ln of the height.
struct Drawn {
    /// How many coordinates the law has.
    coordinates: usize,
    speeds_m_s: Vec<f64>,
    /// Which shared inputs have an uncertainty.
    inputs: Vec<usize>,
    draws: usize,
    /// Mean and standard deviation of ln e* before the data, if they were stated.
    stated_level: Option<[f64; 2]>,
    mean: DVector<f64>,
    covariance: DMatrix<f64>,
}

impl Drawn {
    fn new(posterior: &SampledPosterior, heights_m: &[f64], range_m_s: [f64; 2]) -> Option<Self> {
        let law = posterior.candidates.first()?.law;
        let [slowest, fastest] = range_m_s;
        let models = posterior.models();
        let of_law = |slot: &&Slot| matches!(slot, Slot::Shape(_));
        let shapes = if fastest > MIN_RANGE * slowest {
            models.first()?.slots().iter().filter(of_law).count()
        } else {
            0
        };
        let coordinates = 1 + shapes;
        // In the middle of equal parts of the range of ln v, over which impacts are spread evenly.
        let speeds_m_s: Vec<f64> = (0..POINTS * coordinates)
            .map(|part| {
                let share = (part as f64 + 0.5) / (POINTS * coordinates) as f64;
                slowest * (fastest / slowest).powf(share)
            })
            .collect();
        let mut media = Vec::new();
        let rows = posterior
            .draws
            .iter()
            .zip(heights_m)
            .filter_map(|(draw, height_m)| {
                let model = &models[draw.candidate];
                let [point] = model.values(&[draw.vector]);
                let point = point.filter(|_| model.law == law)?;
                let at = |slot: Slot| model.index(slot).map_or(0.0, |index| draw.vector[index]);
                let mut row = vec![point.law.at(posterior.reference.speeds.reference_m_s).ln()];
                row.extend((0..shapes).map(|shape| at(Slot::Shape(shape))));
                row.extend(SHARED.map(at));
                row.push(0.0);
                media.push(posterior.candidates[draw.candidate].medium);
                row.extend(
                    speeds_m_s
                        .iter()
                        .map(|&speed_m_s| point.law.at(speed_m_s).ln()),
                );
                row.push(height_m.ln());
                Some(row)
            });
        let mut rows: Vec<Vec<f64>> = rows.collect();
        let choices = between_media(&media, rows.iter().map(|row| row[0]));
        for (row, choice) in rows.iter_mut().zip(choices) {
            row[coordinates + SHARED_INPUTS - 1] = choice;
        }
        rows.retain(|row| row.iter().all(|value| value.is_finite()));
        let columns = rows.first()?.len();
        let mut table = DMatrix::from_fn(rows.len(), columns, |row, column| rows[row][column]);
        let mean = table.row_mean().transpose();
        for (mut column, mean) in table.column_iter_mut().zip(mean.iter()) {
            column.add_scalar_mut(-mean);
        }
        let covariance = table.tr_mul(&table) / (rows.len() as f64 - 1.0);
        let is_uncertain = |input: &usize| {
            let column = coordinates + input;
            covariance[(column, column)] > MIN_VARIANCE
        };
        let inputs = (0..SHARED_INPUTS).filter(is_uncertain).collect();
        Some(Self {
            coordinates,
            speeds_m_s,
            inputs,
            draws: table.nrows(),
            stated_level: models.first()?.stated_level(),
            mean,
            covariance,
        })
    }

    /// The first column of ln e.
    fn curve(&self) -> usize {
        self.coordinates + SHARED_INPUTS
    }

    /// The coordinates of the law that fits a curve best at the speeds, by least squares: with ln e = A x, (A' A)⁺ A'. Where
    /// few impacts have nearly the speed v*, a coordinate may not move the curve; then it is zero.
    fn to_law(&self) -> Option<DMatrix<f64>> {
        let of_law: Vec<usize> = (0..self.coordinates).collect();
        let of_curve: Vec<usize> = (self.curve()..self.curve() + self.speeds_m_s.len()).collect();
        let law = Cholesky::new(self.covariances(&of_law, &of_law))?;
        let by_law = law.solve(&self.covariances(&of_law, &of_curve)).transpose();
        let squares = SymmetricEigen::new(by_law.tr_mul(&by_law));
        let negligible = MIN_EFFECT * squares.eigenvalues.max();
        let inverse = squares.eigenvalues.map(|square| {
            if square > negligible {
                1.0 / square
            } else {
                0.0
            }
        });
        let directions = squares.eigenvectors;
        Some(
            &directions
                * DMatrix::from_diagonal(&inverse)
                * directions.transpose()
                * by_law.transpose(),
        )
    }

    fn readings(&self, effective_draws: f64) -> Option<Vec<Reading>> {
        let (points, inputs) = (self.coordinates, self.inputs.len());
        let unknowns: Vec<usize> = (0..points).chain(self.of_inputs()).collect();
        let curve = self.curve();
        // The inverse of a covariance of so many draws is too large by this (Hartlap, Simon and Schneider 2007, Eq. 17).
        let unbiased = (effective_draws - unknowns.len() as f64 - 2.0) / (effective_draws - 1.0);
        if unbiased.is_nan() || unbiased <= 0.0 {
            return None;
        }
        let precision = Cholesky::new(self.covariances(&unknowns, &unknowns))?.inverse() * unbiased;
        let mut information = &precision * self.mean.select_rows(&unknowns);
        let of_law = precision.view((0, 0), (points, points)).into_owned();
        let root = Cholesky::new(of_law)?.l();
        let mut prior = DMatrix::identity(points, points);
        prior[(0, 0)] = 0.0;
        if let Some([mean, sd]) = self.stated_level {
            prior[(0, 0)] = 1.0 / (sd * sd);
            information[0] -= mean / (sd * sd);
        }
        let whitened = root.solve_lower_triangular(&prior)?;
        let whitened = root.solve_lower_triangular(&whitened.transpose())?;
        let SymmetricEigen {
            eigenvalues: of_prior,
            eigenvectors: directions,
        } = SymmetricEigen::new(whitened);
        let values = root.solve_lower_triangular(&information.rows(0, points).into_owned())?;
        let shared = precision.view((0, points), (points, inputs)).into_owned();
        let shared = root.solve_lower_triangular(&shared)?;
        let to_law = self.to_law()?;
        let of_law = self.mean.rows(0, points);
        let of_curve = self.mean.rows(curve, self.speeds_m_s.len());
        let kept = (0..points).filter(|&index| of_prior[index] < MAX_SHARE_OF_PRIOR);
        let reading = |index: usize| {
            let direction = directions.column(index);
            let scale = (1.0 - of_prior[index].max(0.0)).sqrt();
            let by_law = (&root * direction).transpose() * scale;
            let weights = &by_law * &to_law;
            let loads = shared.tr_mul(&direction) / scale;
            let mut of_inputs = [0.0; SHARED_INPUTS];
            for (&input, &load) in self.inputs.iter().zip(loads.iter()) {
                of_inputs[input] = load;
            }
            let from_law = direction.dot(&values) / scale;
            Reading {
                value: from_law - (&by_law * of_law)[0] + (&weights * of_curve)[0],
                weights: weights.iter().copied().collect(),
                shared: of_inputs,
            }
        };
        Some(kept.map(reading).collect())
    }

    /// The columns of the inputs that have an uncertainty.
    fn of_inputs(&self) -> impl Iterator<Item = usize> {
        self.inputs.iter().map(|input| self.coordinates + input)
    }

    fn covariances(&self, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
        self.covariance.select_rows(rows).select_columns(columns)
    }

    /// The regression of ln of the height on the law and the shared inputs.
    fn height(&self) -> Option<HeightEvidence> {
        let points = self.speeds_m_s.len();
        let height = self.curve() + points;
        let by: Vec<usize> = (0..self.coordinates).chain(self.of_inputs()).collect();
        let with = self.covariances(&by, &[height]);
        let factors = Cholesky::new(self.covariances(&by, &by))?.solve(&with);
        let variance = self.covariance[(height, height)];
        let explained = with.tr_mul(&factors)[0];
        let curve = self.to_law()?.tr_mul(&factors.rows(0, self.coordinates));
        let mut shared = [0.0; SHARED_INPUTS];
        let mut constant =
            self.mean[height] - self.mean.rows(self.curve(), points).dot(&curve.column(0));
        for (&input, &factor) in self
            .inputs
            .iter()
            .zip(factors.iter().skip(self.coordinates))
        {
            shared[input] = factor;
            constant -= factor * self.mean[self.coordinates + input];
        }
        Some(HeightEvidence {
            constant,
            curve: curve.iter().copied().collect(),
            shared,
            // Of the draws' digits some are lost.
            rel_sd: (variance - explained)
                .max(1e-12 * variance)
                .max(f64::MIN_POSITIVE)
                .sqrt(),
            stated_m: None,
        })
    }
}

/// For each draw, how far ln e* of its medium lies from that of all, in units of its standard deviation between media: the
/// drag law, or the ball if it is open, is the same for all drops, whichever it is.
fn between_media(media: &[usize], levels: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sums = vec![[0.0; 2]; media.iter().max().map_or(0, |last| last + 1)];
    for (&medium, level) in media.iter().zip(levels) {
        sums[medium][0] += 1.0;
        sums[medium][1] += level;
    }
    let draws = media.len() as f64;
    let mean = sums.iter().map(|[_, sum]| sum).sum::<f64>() / draws;
    let off = |[count, sum]: [f64; 2]| if count > 0.0 { sum / count - mean } else { 0.0 };
    let square = |&it: &[f64; 2]| it[0] * off(it).powi(2);
    let sd = (sums.iter().map(square).sum::<f64>() / draws).sqrt();
    let unit = if sd > 1e-9 { sd } else { f64::INFINITY };
    media
        .iter()
        .map(|&medium| off(sums[medium]) / unit)
        .collect()
}
