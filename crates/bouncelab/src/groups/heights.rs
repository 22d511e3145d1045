//! Drop heights by the curve of the group, and the zero of the ruler.

use nalgebra::DVector;

use super::evidence::{CurveEvidence, SHARED_INPUTS};
use super::fit::{Effects, Frame, GroupFit, Inputs, Shared};
use super::sums::Rows;
use crate::estimate::Estimate;
use crate::inference::Measured;

/// Of the variance of a stated height this part is that of the zero of the ruler, which all share; the rest is of the reading.
const OF_ZERO: f64 = 0.5;

/// A sound that tells a height with a larger share of the information of the statement tells something of the ruler.
const TELLING: f64 = 0.02;

/// A height, and what of its variance it shares with the others.
#[expect(clippy::struct_field_names, reason = "units stand in names")]
#[derive(Debug, Clone, Copy)]
pub(super) struct Height {
    height_m: f64,
    variance: f64,
    shared_variance: f64,
    stated_m: Option<Measured>,
}

impl Height {
    /// The height of a drop given all drops: its level u given the coefficients β is k a'(v - L z - X β - a o) with
    /// [`Rows::shrinkage`] k, and ln h a linear function of ln e at its speeds, that is of β, u and o.
    pub(super) fn new(
        frame: &Frame,
        evidence: &CurveEvidence,
        effects_of_drop: &[usize],
        group: &GroupFit,
        effects: &Effects,
        inputs: &Inputs,
    ) -> Option<Self> {
        let (rows, height) = (Rows::new(frame.basis, evidence), evidence.height.as_ref()?);
        let len = frame.basis.len();
        let k = rows.shrinkage(group.likeliest().scatter);
        let along = rows.table.tr_mul(&rows.level);
        let sum: f64 = height.curve.iter().sum();
        let functions = std::iter::zip(&evidence.speeds_m_s, &height.curve);
        let of_curve = functions.fold(DVector::zeros(len), |sum, (&speed, factor)| {
            sum + frame.basis.at(speed) * *factor
        });
        let linear = group.likeliest_linear(&(of_curve - along.rows(0, len) * (k * sum)));
        let mut by_effects = linear.by_effects.clone();
        for &effect in effects_of_drop {
            by_effects[effect] += sum * (1.0 - k * rows.precision());
        }
        let loads = along.fixed_rows::<SHARED_INPUTS>(len).into_owned();
        let by_inputs = Shared::from(height.shared);
        let level = k * sum * (along[len + SHARED_INPUTS] - loads.dot(&inputs.mean));
        let log = height.constant
            + linear.mean
            + by_effects.dot(&effects.mean)
            + level
            + by_inputs.dot(&inputs.mean);
        let by_inputs = by_inputs + linear.by_inputs - loads * (k * sum);
        let shared = linear.variance
            + by_effects.dot(&(&effects.covariance * &by_effects))
            + by_inputs.dot(&(inputs.covariance * by_inputs));
        let height_m = log.exp();
        let square = height_m * height_m;
        Some(Self {
            height_m,
            variance: square * (shared + k * sum * sum + height.rel_sd.powi(2)),
            shared_variance: square * shared,
            stated_m: height.stated_m,
        })
    }

    /// The height by the sound alone, the statement divided out, if it tells anything; and its shared variance.
    fn by_sound(&self) -> Option<(Measured, f64)> {
        let Some(stated) = self.stated_m else {
            let measured = Measured {
                value: self.height_m,
                sd: self.variance.sqrt(),
            };
            return Some((measured, self.shared_variance));
        };
        let of_stated = stated.sd.powi(-2);
        let precision = 1.0 / self.variance - of_stated;
        if precision.is_nan() || precision < TELLING * of_stated {
            return None;
        }
        let value = (self.height_m / self.variance - stated.value * of_stated) / precision;
        let measured = Measured {
            value,
            sd: precision.sqrt().recip(),
        };
        Some((
            measured,
            self.shared_variance / (self.variance * precision).powi(2),
        ))
    }
}

/// By how much stated heights are too large, if two or more are; and the heights, each by its sound and its statement.
pub(super) fn with_zero(heights: &[Option<Height>]) -> (Option<Estimate>, Vec<Option<Estimate>>) {
    let stated = heights
        .iter()
        .flatten()
        .filter(|height| height.stated_m.is_some());
    let (mut precision, mut sum, mut prior, mut shared, mut count) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for height in stated {
        let Some((stated, (measured, of_shared))) = height.stated_m.zip(height.by_sound()) else {
            continue;
        };
        let own =
            (measured.sd * measured.sd - of_shared).max(0.0) + (1.0 - OF_ZERO) * stated.sd.powi(2);
        precision += 1.0 / own;
        sum += (stated.value - measured.value) / own;
        prior += OF_ZERO * stated.sd.powi(2);
        shared += of_shared;
        count += 1.0;
    }
    let zero = (count > 1.0).then(|| {
        // The mean of the differences has the variance 1/precision and the part that they share.
        let (off, variance) = (sum / precision, 1.0 / precision + shared / count);
        let weight = 1.0 / (1.0 + variance * count / prior);
        Estimate::normal(off * weight, (variance * weight).sqrt())
    });
    let of_one = |height: &Height| {
        let Some(stated) = height.stated_m else {
            return Estimate::normal(height.height_m, height.variance.sqrt());
        };
        let (off, of_zero) = zero.map_or((0.0, OF_ZERO * stated.sd.powi(2)), |zero| {
            (zero.value, zero.sd * zero.sd)
        });
        let read = (
            stated.value - off,
            (1.0 - OF_ZERO) * stated.sd.powi(2) + of_zero,
        );
        let (value, variance) = match height.by_sound() {
            None => read,
            Some((measured, _)) => {
                let weights = [1.0 / read.1, measured.sd.powi(-2)];
                let sum = weights[0] + weights[1];
                (
                    (read.0 * weights[0] + measured.value * weights[1]) / sum,
                    1.0 / sum,
                )
            }
        };
        Estimate::normal(value, variance.sqrt())
    };
    (
        zero,
        heights
            .iter()
            .map(|height| height.as_ref().map(of_one))
            .collect(),
    )
}
