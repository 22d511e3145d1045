//! The mean of a group of drops, each with its own standard error.

use super::quantile::{chi_squared, student};
use crate::error::{Error, Quantity, Result, within};
use crate::inference::Measured;

/// The mean of a group under a random-effects model.
///
/// A value is m + b + r: the mean, a scatter between drops with variance tau², and an error with
/// the stated standard deviation. tau² is the restricted maximum-likelihood estimate (Viechtbauer
/// 2005). The standard error is that of Hartung and Knapp (2001), never below the one that tau and
/// the errors alone give (Röver, Knapp and Friede 2015), and the interval is of Student's t: that
/// holds what it promises also for few drops.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Mean {
    /// How many drops.
    pub drops: usize,
    /// The mean, each drop weighed by how well it is known and how much drops scatter.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Degrees of freedom of the standard error; `None` for a single drop.
    pub degrees: Option<f64>,
    /// Where the mean lies with 95 % confidence; one drop cannot tell.
    pub interval95: Option<[f64; 2]>,
    /// Where the next drop of the same kind lies with 95 % confidence, its own error left out
    /// (Higgins, Thompson and Spiegelhalter 2009); it takes three drops. With five drops that
    /// scatter no more than their errors it holds 91 % instead.
    pub next95: Option<[f64; 2]>,
    /// tau, the standard deviation between drops beyond their errors; one drop cannot tell.
    pub between: Option<f64>,
    /// Its 95 % interval by the Q-profile (Viechtbauer 2007).
    pub between95: Option<[f64; 2]>,
    /// Root mean square of the drops' own standard errors.
    pub own: f64,
}

impl Mean {
    /// The mean of drops, in any order.
    ///
    /// # Errors
    /// [`Error::TooFewDrops`] without any, [`Error::OutOfRange`] if a value is not finite or a
    /// standard error is below zero.
    ///
    /// ```
    /// use bouncelab::groups::Mean;
    /// use bouncelab::inference::Measured;
    ///
    /// let drops = [0.931, 0.934, 0.929, 0.933].map(|value| Measured { value, sd: 0.001 });
    /// let mean = Mean::of(&drops)?;
    /// assert_eq!(format!("{:.3}", mean.value), "0.932");
    /// let [low, high] = mean.interval95.unwrap();
    /// assert!(low < 0.9318 && 0.9318 < high);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn of(drops: &[Measured]) -> Result<Self> {
        if drops.is_empty() {
            return Err(Error::TooFewDrops {
                needed: 1,
                drops: 0,
            });
        }
        drops.iter().try_for_each(check)?;
        let own = (drops.iter().map(|d| d.sd * d.sd).sum::<f64>() / drops.len() as f64).sqrt();
        let [first, _, ..] = drops else {
            return Ok(Self {
                drops: 1,
                value: drops[0].value,
                standard_error: drops[0].sd,
                degrees: None,
                interval95: None,
                next95: None,
                between: None,
                between95: None,
                own,
            });
        };
        let degrees = drops.len() as f64 - 1.0;
        let scale = spread(drops, first.value);
        let tau2 = between_variance(drops, scale);
        let pooled = Pooled::new(drops, tau2);
        // Values that all agree beyond their stated errors do not make the errors smaller.
        let inflation = (pooled.q / degrees).max(1.0);
        let standard_error = (inflation / pooled.weight).sqrt();
        let about = |half: f64| [pooled.mean - half, pooled.mean + half];
        let next = (drops.len() > 2).then(|| {
            let half = student(0.975, degrees - 1.0) * (tau2 + standard_error.powi(2)).sqrt();
            about(half)
        });
        Ok(Self {
            drops: drops.len(),
            value: pooled.mean,
            standard_error,
            degrees: Some(degrees),
            interval95: Some(about(student(0.975, degrees) * standard_error)),
            next95: next,
            between: Some(tau2.sqrt()),
            between95: Some(q_profile(drops, scale).map(f64::sqrt)),
            own,
        })
    }

    /// The standard deviation of a single drop about the mean, its own error included.
    ///
    /// ```
    /// use bouncelab::groups::Mean;
    /// use bouncelab::inference::Measured;
    ///
    /// let drops = [1.0, 2.0, 3.0, 4.0, 5.0].map(|value| Measured { value, sd: 0.0 });
    /// assert!((Mean::of(&drops)?.of_one_drop() - 2.5_f64.sqrt()).abs() < 1e-3);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn of_one_drop(&self) -> f64 {
        self.between.unwrap_or(0.0).hypot(self.own)
    }
}

/// Refuses a drop that has no value or no standard error.
pub(super) fn check(drop: &Measured) -> Result<()> {
    within(Quantity::DropValue, drop.value, ..)?;
    within(Quantity::DropSd, drop.sd, 0.0..)?;
    Ok(())
}

/// A variance that surely exceeds that between drops by less than an order of magnitude or two.
fn spread(drops: &[Measured], about: f64) -> f64 {
    let squares: f64 = drops.iter().map(|d| (d.value - about).powi(2)).sum();
    squares.max(f64::MIN_POSITIVE)
}

/// The weighted mean for one variance between drops.
struct Pooled {
    mean: f64,
    /// Sum of the weights.
    weight: f64,
    /// Weighted sum of squares about the mean (Cochran's Q with these weights).
    q: f64,
}

impl Pooled {
    fn new(drops: &[Measured], tau2: f64) -> Self {
        // Drops known exactly that agree exactly: any tiny variance weighs them equally.
        let weigh = |d: &Measured| 1.0 / (d.sd * d.sd + tau2).max(f64::MIN_POSITIVE);
        let weight: f64 = drops.iter().map(weigh).sum();
        let mean = drops.iter().map(|d| weigh(d) * d.value).sum::<f64>() / weight;
        let q = drops
            .iter()
            .map(|d| weigh(d) * (d.value - mean).powi(2))
            .sum();
        Self { mean, weight, q }
    }

    /// The restricted log-likelihood, up to a constant (Viechtbauer 2005, Eq. 6).
    fn restricted_log_likelihood(&self, drops: &[Measured], tau2: f64) -> f64 {
        let log: f64 = drops
            .iter()
            .map(|d| (d.sd * d.sd + tau2).max(f64::MIN_POSITIVE).ln())
            .sum();
        -0.5 * (log + self.weight.ln() + self.q)
    }
}

/// The variance between drops of greatest restricted likelihood.
///
/// The likelihood may have two hills, so it is looked at over nine decades before the best is
/// climbed.
fn between_variance(drops: &[Measured], scale: f64) -> f64 {
    const DECADES: f64 = 9.0;
    const STEPS: i32 = 90;
    let log_likelihood =
        |tau2: f64| Pooled::new(drops, tau2).restricted_log_likelihood(drops, tau2);
    let at = |step: f64| 2.0 * scale * 10_f64.powf(-DECADES * step / f64::from(STEPS));
    let best = (0..=STEPS)
        .map(|step| (f64::from(step), log_likelihood(at(step.into()))))
        .max_by(|(_, one), (_, other)| one.total_cmp(other))
        .map_or(0.0, |(step, _)| step);
    let tau2 = at(climb([best - 1.0, best + 1.0], |step| {
        log_likelihood(at(step))
    }));
    // With errors stated as zero the likelihood has no maximum at zero but a pole.
    let zero = drops.iter().all(|d| d.sd > 0.0) && log_likelihood(0.0) >= log_likelihood(tau2);
    if zero { 0.0 } else { tau2 }
}

/// The place of the maximum in an interval with one hill, by golden section.
fn climb([mut low, mut high]: [f64; 2], height: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    const STEPS: usize = 60;
    let (mut left, mut right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_left, mut at_right) = (height(left), height(right));
    for _ in 0..STEPS {
        if at_left > at_right {
            high = right;
            (right, at_right) = (left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = height(left);
        } else {
            low = left;
            (left, at_left) = (right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = height(right);
        }
        if high - low <= 1e-9 * (low.abs() + high.abs()) {
            break;
        }
    }
    f64::midpoint(low, high)
}

/// Bounds of the variance between drops: Cochran's Q with the right weights is chi-squared, and it
/// falls as the variance grows.
fn q_profile(drops: &[Measured], scale: f64) -> [f64; 2] {
    let degrees = drops.len() as f64 - 1.0;
    let bound = |share: f64| {
        let target = chi_squared(share, degrees);
        let q = |tau2: f64| Pooled::new(drops, tau2).q;
        if q(0.0) <= target {
            return 0.0;
        }
        let (mut low, mut high) = (0.0, scale);
        while q(high) > target && high < f64::MAX / 4.0 {
            high *= 4.0;
        }
        while high - low > 1e-12 * high {
            let middle = f64::midpoint(low, high);
            if q(middle) > target {
                low = middle;
            } else {
                high = middle;
            }
        }
        high
    };
    [bound(0.975), bound(0.025)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The 13 trials of the BCG vaccine: log relative risk and its variance (Colditz et al. 1994,
    /// as computed by the R package metafor).
    const BCG: [(f64, f64); 13] = [
        (-0.8893, 0.3256),
        (-1.5854, 0.1946),
        (-1.3481, 0.4154),
        (-1.4416, 0.0200),
        (-0.2175, 0.0512),
        (-0.7861, 0.0069),
        (-1.6209, 0.2230),
        (0.0120, 0.0040),
        (-0.4694, 0.0564),
        (-1.3713, 0.0730),
        (-0.3394, 0.0124),
        (0.4459, 0.5325),
        (-0.0173, 0.0714),
    ];

    fn bcg() -> Vec<Measured> {
        BCG.iter()
            .map(|&(value, variance)| Measured {
                value,
                sd: f64::sqrt(variance),
            })
            .collect()
    }

    /// metafor 4.6, `rma(yi, vi)` and `confint`: mean -0.7145, tau² 0.3132 with interval 0.1197 to
    /// 1.1115; the data above are rounded to four digits.
    #[test]
    fn published_trials_give_the_published_numbers() {
        let mean = Mean::of(&bcg()).unwrap();
        let close = |value: f64, published: f64, digits: f64| {
            assert!((value - published).abs() < digits, "{value} {published}");
        };
        close(mean.value, -0.7145, 2e-4);
        close(mean.between.unwrap().powi(2), 0.3132, 3e-4);
        let [low, high] = mean.between95.unwrap();
        close(low * low, 0.1197, 2e-4);
        close(high * high, 1.1115, 2e-3);
        // Hartung and Knapp: 0.1807, t with 12 degrees of freedom.
        close(mean.standard_error, 0.1807, 4e-4);
        let [low, high] = mean.interval95.unwrap();
        close(low, -1.1084, 2e-3);
        close(high, -0.3206, 2e-3);
    }

    /// With equal errors the model is the textbook's: mean, s over root n, t.
    #[test]
    fn equal_errors_are_the_textbook_mean() {
        let values = [3.0, 4.5, 2.5, 6.0, 4.0];
        let drops = values.map(|value| Measured { value, sd: 0.1 });
        let mean = Mean::of(&drops).unwrap();
        // Mean 4, standard deviation sqrt(7.5 / 4).
        assert!((mean.value - 4.0).abs() < 1e-12);
        let standard_error = (7.5_f64 / 4.0 / 5.0).sqrt();
        assert!((mean.standard_error - standard_error).abs() < 1e-6);
        assert!((mean.between.unwrap().powi(2) - (7.5 / 4.0 - 0.01)).abs() < 1e-6);
        let half = 2.776_445 * standard_error;
        assert!((mean.interval95.unwrap()[1] - 4.0 - half).abs() < 1e-4);
    }

    #[test]
    fn agreement_beyond_the_errors_does_not_shrink_them() {
        let drops = [Measured {
            value: 1.0,
            sd: 0.2,
        }; 4];
        let mean = Mean::of(&drops).unwrap();
        assert_eq!(mean.between, Some(0.0));
        assert!((mean.standard_error - 0.1).abs() < 1e-12);
        assert_eq!(mean.between95.map(|[low, _]| low), Some(0.0));
    }

    #[test]
    fn one_drop_has_no_scatter_and_none_has_no_mean() {
        let one = Mean::of(&[Measured {
            value: 0.9,
            sd: 0.01,
        }])
        .unwrap();
        assert_eq!((one.value, one.standard_error), (0.9, 0.01));
        assert_eq!((one.interval95, one.between), (None, None));
        assert!(matches!(
            Mean::of(&[]),
            Err(Error::TooFewDrops {
                needed: 1,
                drops: 0
            })
        ));
        let bad = Measured {
            value: f64::NAN,
            sd: 0.01,
        };
        assert!(Mean::of(&[bad]).is_err());
    }

    #[test]
    fn exact_values_are_no_trouble() {
        let exact = [1.0, 1.0, 1.0].map(|value| Measured { value, sd: 0.0 });
        let mean = Mean::of(&exact).unwrap();
        assert!((mean.value - 1.0).abs() < 1e-12 && mean.standard_error < 1e-100);
        let apart = [1.0, 3.0].map(|value| Measured { value, sd: 0.0 });
        let mean = Mean::of(&apart).unwrap();
        assert!((mean.between.unwrap() - 2.0_f64.sqrt()).abs() < 1e-6);
    }
}
