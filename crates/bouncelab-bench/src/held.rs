//! Whether intervals hold the truth.

use bouncelab::Estimate;

/// The standard normal at the ends of the middle 68 and 95 %.
const ENDS: [f64; 2] = [1.0, 1.96];

/// Whether the intervals of an estimate hold the truth.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    /// Whether the interval of 68 % does.
    pub in68: bool,
    /// Whether the interval of 95 % does.
    pub in95: bool,
    /// The relative standard uncertainty.
    pub relative_sd: f64,
    /// Deviation from the truth, in standard uncertainties.
    pub z: f64,
    /// Relative deviation from the truth.
    pub deviation: f64,
}

impl Held {
    /// By a truth that is exact.
    pub(crate) fn of(estimate: &Estimate, truth: f64) -> Self {
        Self::within(estimate, truth, 0.0)
    }

    /// By a truth that has a standard uncertainty itself, with which each interval is widened.
    pub(crate) fn within(estimate: &Estimate, truth: f64, truth_sd: f64) -> Self {
        let off = truth - estimate.value;
        let is_in = |interval: [f64; 2], end: f64| {
            let side = interval[usize::from(off > 0.0)] - estimate.value;
            off.abs() <= side.hypot(end * truth_sd)
        };
        Self {
            in68: is_in(estimate.interval68, ENDS[0]),
            in95: is_in(estimate.interval95, ENDS[1]),
            relative_sd: estimate.sd / truth,
            z: -off / estimate.sd.hypot(truth_sd),
            deviation: -off / truth,
        }
    }
}

/// The root of the mean square.
pub(crate) fn rms(values: impl Iterator<Item = f64> + Clone) -> f64 {
    mean(values.map(|value| value * value)).sqrt()
}

pub(crate) fn mean(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().count() as f64;
    values.sum::<f64>() / count
}

/// % of those of which this holds.
pub(crate) fn percent(held: &[Held], is: fn(&Held) -> bool) -> f64 {
    100.0 * held.iter().filter(|held| is(held)).count() as f64 / held.len() as f64
}

/// The middle value, the upper one of two; `None` without values.
pub(crate) fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

/// Number, % in the intervals of 68 and 95 %, rms of z, mean and rms of the deviation in %: cells of a table.
pub(crate) fn cells(held: &[Held]) -> String {
    let deviations = held.iter().map(|held| 100.0 * held.deviation);
    format!(
        "{} | {:.0} | {:.0} | {:.2} | {:+.1} | {:.1}",
        held.len(),
        percent(held, |held| held.in68),
        percent(held, |held| held.in95),
        rms(held.iter().map(|held| held.z)),
        mean(deviations.clone()),
        rms(deviations),
    )
}
