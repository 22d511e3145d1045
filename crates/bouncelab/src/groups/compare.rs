//! Differences between groups.

use super::mean::Mean;
use super::mixed::{Drop, Factor, Mixed};
use super::quantile::{interval95, student_beyond};
use crate::error::Result;
use crate::inference::Measured;
use crate::stats::sort_by_number;

/// The difference of two groups.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Difference {
    /// The group from which it is counted, by its place.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub of: usize,
    /// The group that is subtracted.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub less: usize,
    /// Mean of the one less mean of the other, with its standard error.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub value: Measured,
    /// Degrees of freedom of the standard error.
    pub degrees: f64,
    /// Where the difference lies with 95 % confidence, looked at alone.
    pub interval95: [f64; 2],
    /// Probability of so large a difference between equal groups, raised for the number of
    /// differences looked at together (Holm 1979).
    pub p_value: f64,
}

impl Difference {
    fn new(of: usize, less: usize, value: Measured, degrees: f64) -> Self {
        Self {
            of,
            less,
            value,
            degrees,
            interval95: interval95(value, degrees),
            p_value: student_beyond(value.value / value.sd, degrees),
        }
    }
}

/// All differences between the levels of a factor, what else varies taken out.
///
/// The levels get a mean each; the factors in `others` vary at random, so that an unbalanced design
/// compares like with like as far as it can, and knows less where it cannot.
///
/// # Errors
/// Those of [`Mixed::fit`].
///
/// ```
/// use bouncelab::groups::{Drop, Factor, compare};
/// use bouncelab::inference::Measured;
///
/// let factor = Factor { name: "surface".to_owned(), levels: vec!["steel".to_owned(), "wood".to_owned()] };
/// let drops: Vec<Drop> = [(0, 0.930), (0, 0.934), (0, 0.931), (1, 0.880), (1, 0.884), (1, 0.879)]
///     .map(|(level, value)| Drop { measured: Measured { value, sd: 0.001 }, levels: vec![Some(level)] })
///     .into();
/// let difference = compare(&drops, &[factor], 0, &[])?[0];
/// assert!((difference.value.value.abs() - 0.0507).abs() < 1e-3);
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn compare(
    drops: &[Drop],
    factors: &[Factor],
    factor: usize,
    others: &[usize],
) -> Result<Vec<Difference>> {
    let fit = Mixed::fit(drops, factors, Some(factor), others)?;
    let differences = pairs(factors[factor].levels.len())
        .map(|(of, less)| {
            let (value, degrees) = fit.difference(of, less);
            Difference::new(of, less, value, degrees)
        })
        .collect();
    Ok(holm(differences))
}

/// All differences between groups that scatter differently, each with its own scatter (Welch 1947).
///
/// Groups of a single drop are left out: their scatter is not known.
///
/// ```
/// use bouncelab::groups::{Mean, compare_means};
/// use bouncelab::inference::Measured;
///
/// let [steel, wood] = [[0.93, 0.932, 0.929], [0.88, 0.884, 0.879]]
///     .map(|values| Mean::of(&values.map(|value| Measured { value, sd: 0.001 })));
/// let difference = compare_means(&[steel?, wood?])[0];
/// assert!(difference.p_value < 0.01);
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn compare_means(means: &[Mean]) -> Vec<Difference> {
    let differences = pairs(means.len()).filter_map(|(of, less)| {
        let (a, b) = (&means[of], &means[less]);
        let (va, vb) = (a.standard_error.powi(2), b.standard_error.powi(2));
        let value = Measured {
            value: a.value - b.value,
            sd: (va + vb).sqrt(),
        };
        let degrees = (va + vb).powi(2) / (va * va / a.degrees? + vb * vb / b.degrees?);
        Some(Difference::new(of, less, value, degrees))
    });
    holm(differences.collect())
}

fn pairs(groups: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..groups).flat_map(move |less| (less + 1..groups).map(move |of| (of, less)))
}

/// Holm's step-down: the smallest of n probabilities counts n times, the next n - 1 times, and none
/// is below the one before it.
fn holm(mut differences: Vec<Difference>) -> Vec<Difference> {
    let mut order: Vec<usize> = (0..differences.len()).collect();
    sort_by_number(&mut order, |&place| differences[place].p_value);
    let mut least: f64 = 0.0;
    for (rank, &place) in order.iter().enumerate() {
        let times = (differences.len() - rank) as f64;
        least = least.max((times * differences[place].p_value).min(1.0));
        differences[place].p_value = least;
    }
    differences
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mean(values: &[f64]) -> Mean {
        let drops: Vec<Measured> = values
            .iter()
            .map(|&value| Measured { value, sd: 0.0 })
            .collect();
        Mean::of(&drops).unwrap()
    }

    /// Student's sleep data (1908), as the Welch test of R has them: difference 1.58, t = 1.8608,
    /// 17.776 degrees of freedom, p = 0.07939, interval -0.2055 to 3.3655.
    #[test]
    fn students_sleep_by_welch() {
        let first = mean(&[0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0]);
        let second = mean(&[1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4]);
        let difference = compare_means(&[first, second])[0];
        let close = |value: f64, published: f64, off: f64| {
            assert!((value - published).abs() < off, "{value} {published}");
        };
        close(difference.value.value, 1.58, 1e-6);
        close(difference.value.value / difference.value.sd, 1.8608, 1e-3);
        close(difference.degrees, 17.776, 1e-2);
        close(difference.p_value, 0.07939, 1e-4);
        close(difference.interval95[0], -0.2055, 1e-3);
        close(difference.interval95[1], 3.3655, 1e-3);
    }

    /// R: p.adjust(c(0.01, 0.02, 0.03, 0.04), "holm") is 0.04 0.06 0.06 0.06.
    #[test]
    fn holm_as_in_r() {
        let zero = Measured {
            value: 0.0,
            sd: 1.0,
        };
        let raw = [0.04, 0.01, 0.03, 0.02].map(|p_value| Difference {
            p_value,
            ..Difference::new(0, 1, zero, 10.0)
        });
        let adjusted: Vec<f64> = holm(raw.to_vec()).iter().map(|d| d.p_value).collect();
        for (value, expected) in adjusted.iter().zip([0.06, 0.04, 0.06, 0.06]) {
            assert!((value - expected).abs() < 1e-12, "{adjusted:?}");
        }
    }

    /// Ball B bounces 0.01 better, but was dropped mostly on the dull surface.
    #[test]
    fn an_unbalanced_design_compares_like_with_like() {
        let factor = |name: &str| Factor {
            name: name.to_owned(),
            levels: vec!["first".to_owned(), "second".to_owned()],
        };
        let cells = [(0, 0, 6), (0, 1, 2), (1, 0, 2), (1, 1, 6)];
        let drops: Vec<Drop> = cells
            .into_iter()
            .flat_map(|(ball, surface, times)| {
                (0..times).map(move |time| Drop {
                    measured: Measured {
                        value: 0.9 + 0.01 * ball as f64 - 0.1 * surface as f64
                            + 0.001 * f64::from(time % 2),
                        sd: 0.0005,
                    },
                    levels: vec![Some(ball), Some(surface)],
                })
            })
            .collect();
        let factors = [factor("ball"), factor("surface")];
        let plain = compare(&drops, &factors, 0, &[]).unwrap()[0];
        let fair = compare(&drops, &factors, 0, &[1]).unwrap()[0];
        assert!(plain.value.value < -0.03);
        assert!((fair.value.value - 0.01).abs() < 0.001, "{fair:?}");
        assert!(fair.interval95[0] > 0.008 && fair.interval95[1] < 0.012);
    }
}
