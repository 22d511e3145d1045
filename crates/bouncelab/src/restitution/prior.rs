//! What is known of the restitution before the data, over the impact speed.

use std::f64::consts::{SQRT_2, TAU};
use std::fmt::{self, Display, Formatter};
use std::ops::Bound::{Excluded, Unbounded};
use std::str::FromStr;

use nalgebra::{DMatrix, SymmetricEigen};
use rand::RngExt;
use rand_distr::{Distribution, StandardNormal};
use statrs::function::erf::erfc;

use super::Restitution;
use super::law::{MAX_SHAPES, SpeedRange, lively};
use super::smooth::KNOTS;
use crate::error::{Error, Quantity, Result, positive, within};
use crate::simd::Lanes;

/// Minimum standard deviation of ln e at a speed, as much as the best surface scatters: no prior is exact.
const MIN_SD: f64 = 2e-4;

/// Change of ln v over which deviations with stated standard deviations are alike: a factor e in speed.
const ALIKE: f64 = 1.0;

/// Place of v* among the knots of the smooth law.
const REFERENCE: usize = KNOTS / 2;

const EXAMPLES: [&str; 2] = [
    "normal:0.5=0.93:0.01,3=0.86:0.02",
    "functions:0.5=0.93:0.01:0.01,3=0.86:0.01:-0.02",
];

/// A normal distribution of ln e as a function of the impact speed, in place of the usual prior of the
/// [smooth law](Restitution::smooth), with the means of e and its standard deviations, or the functions that it is made of, at
/// some speeds. Between them all are linear in ln v, beyond them they stay.
///
/// As text it is `normal:SPEED=MEAN:SD,...`, whose deviations have these standard deviations and the correlation
/// exp(-(ln v - ln v')²/2) at two speeds, or `functions:SPEED=MEAN:F:G...,...`: the mean plus the sum of the functions F, G, ...,
/// each times a standard normal of its own. Deviations are those of e; as they enter, those of ln e are the same over the mean.
///
/// ```
/// use bouncelab::restitution::RestitutionPrior;
///
/// let prior: RestitutionPrior = "normal:0.5=0.93:0.01,3=0.86:0.02".parse()?;
/// assert_eq!(prior.to_string(), "normal:0.5=0.93:0.01,3=0.86:0.02");
/// assert!("normal:3=0.86:0.02,0.5=0.93:0.01".parse::<RestitutionPrior>().is_err()); // speeds increase
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RestitutionPrior {
    /// Whether the deviations are functions; else they are standard deviations.
    are_functions: bool,
    points: Vec<Stated>,
}

/// What is stated at a speed.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
struct Stated {
    speed_m_s: f64,
    mean: f64,
    deviations: Vec<f64>,
}

impl RestitutionPrior {
    fn checked(self) -> Result<Self> {
        let mut slower_m_s = 0.0;
        for point in &self.points {
            let faster = (Excluded(slower_m_s), Unbounded);
            slower_m_s = within(Quantity::ReferenceSpeed, point.speed_m_s, faster)?;
            lively(point.mean)?;
            for &deviation in &point.deviations {
                if self.are_functions {
                    within(Quantity::RestitutionSd, deviation, ..)?;
                } else {
                    positive(Quantity::RestitutionSd, deviation)?;
                }
            }
        }
        Ok(self)
    }

    /// ln of the mean, and the deviations of ln e, at a speed.
    fn at(&self, speed_m_s: f64) -> (f64, Vec<f64>) {
        let next = self
            .points
            .partition_point(|point| point.speed_m_s < speed_m_s);
        let slower = &self.points[next.saturating_sub(1)];
        let faster = &self.points[next.min(self.points.len() - 1)];
        let range = (faster.speed_m_s / slower.speed_m_s).ln();
        let share = (speed_m_s / slower.speed_m_s).ln() / range;
        // Beyond the ends both are the same point, and the range is zero.
        let share = if range > 0.0 { share } else { 0.0 };
        let between = |slower: f64, faster: f64| slower + share * (faster - slower);
        let mean = between(slower.mean, faster.mean);
        let deviations = slower.deviations.iter().zip(&faster.deviations);
        let deviations = deviations.map(|(&slower, &faster)| between(slower, faster) / mean);
        (mean.ln(), deviations.collect())
    }

    /// The same for the impacts of a drop.
    pub(crate) fn over(&self, speeds: &SpeedRange) -> PriorOver {
        let ends = [speeds.slowest_m_s, speeds.reference_m_s, speeds.fastest_m_s];
        let [slow, middle, fast] = ends;
        let knots = [
            slow,
            (slow * middle).sqrt(),
            middle,
            (middle * fast).sqrt(),
            fast,
        ];
        let stated = knots.map(|speed_m_s| self.at(speed_m_s));
        let covariance = |one: usize, other: usize| {
            let pairs = stated[one].1.iter().zip(&stated[other].1);
            let sum: f64 = pairs.map(|(one, other)| one * other).sum();
            let apart = (knots[one] / knots[other]).ln() / ALIKE;
            let alike = if self.are_functions {
                1.0
            } else {
                (-0.5 * apart * apart).exp()
            };
            sum * alike + MIN_SD * MIN_SD
        };
        let variance = covariance(REFERENCE, REFERENCE);
        let by_level: [f64; KNOTS] =
            std::array::from_fn(|knot| covariance(knot, REFERENCE) / variance);
        let given_level = DMatrix::from_fn(KNOTS, KNOTS, |one, other| {
            covariance(one, other) - by_level[one] * by_level[other] * variance
        });
        let parts = SymmetricEigen::new(given_level);
        // The level is given, so one of the variances is zero: that of the least.
        let mut order: Vec<usize> = (0..KNOTS).collect();
        order.sort_by(|&one, &other| parts.eigenvalues[other].total_cmp(&parts.eigenvalues[one]));
        let by_normals = std::array::from_fn(|number| {
            let sd = parts.eigenvalues[order[number]].max(0.0).sqrt();
            let part = parts.eigenvectors.column(order[number]);
            slopes(&knots, &std::array::from_fn(|knot| sd * part[knot]))
        });
        let (mean, sd) = (stated[REFERENCE].0, variance.sqrt());
        let below_one = 0.5 * erfc(mean / (sd * SQRT_2));
        PriorOver {
            speeds_m_s: ends,
            mean,
            sd,
            log_norm: (below_one * sd * TAU.sqrt()).ln(),
            slopes: slopes(&knots, &std::array::from_fn(|knot| stated[knot].0)),
            by_level: slopes(&knots, &by_level),
            by_normals,
        }
    }
}

impl FromStr for RestitutionPrior {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let point = |text: &str| {
            let (speed, numbers) = text.split_once('=')?;
            let numbers: Option<Vec<f64>> = numbers
                .split(':')
                .map(|number| number.trim().parse().ok())
                .collect();
            let numbers = numbers?;
            let (mean, deviations) = numbers.split_first()?;
            Some(Stated {
                speed_m_s: speed.trim().parse().ok()?,
                mean: *mean,
                deviations: deviations.to_vec(),
            })
        };
        let read = |text: &str| {
            let (kind, points) = text.split_once(':')?;
            let points: Vec<Stated> = points.split(',').map(point).collect::<Option<_>>()?;
            let numbers = points.first()?.deviations.len();
            let are_functions = kind == "functions";
            let fits = numbers > 0 && (are_functions || kind == "normal" && numbers == 1);
            let alike = points.iter().all(|point| point.deviations.len() == numbers);
            (fits && alike).then_some(Self {
                are_functions,
                points,
            })
        };
        read(text)
            .ok_or_else(|| Error::unknown_name("restitution prior", text, &EXAMPLES))?
            .checked()
    }
}

impl Display for RestitutionPrior {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(if self.are_functions {
            "functions"
        } else {
            "normal"
        })?;
        for (number, point) in self.points.iter().enumerate() {
            let separator = if number == 0 { ':' } else { ',' };
            write!(f, "{separator}{}={}", point.speed_m_s, point.mean)?;
            for deviation in &point.deviations {
                write!(f, ":{deviation}")?;
            }
        }
        Ok(())
    }
}

/// Such a prior for the impacts of a drop: of ln e* a normal distribution, and with each ln e* the slopes of the smooth law at its
/// knots by standard normals.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PriorOver {
    speeds_m_s: [f64; 3],
    /// Mean and standard deviation of ln e*, if e* could be above 1.
    pub(crate) mean: f64,
    pub(crate) sd: f64,
    /// Logarithm of the integral of exp(-z²/2), with z the deviation in standard deviations, over ln e* up to zero.
    log_norm: f64,
    /// The slopes if all is as expected.
    slopes: [f64; KNOTS],
    /// Their derivatives by ln e*, and by each standard normal.
    by_level: [f64; KNOTS],
    by_normals: [[f64; KNOTS]; PriorOver::SHAPES],
}

impl PriorOver {
    /// Number of standard normals besides e*.
    pub(crate) const SHAPES: usize = KNOTS - 1;

    /// Logarithm of the density of ln e*, which is not above zero.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(crate) fn log_density<const L: usize>(&self, ln_restitution: Lanes<L>) -> Lanes<L> {
        let off = (ln_restitution - self.mean) * (1.0 / self.sd);
        off * off * -0.5 - self.log_norm
    }

    /// A restitution at v*.
    pub(crate) fn draw_restitution(&self, random: &mut impl RngExt) -> f64 {
        loop {
            let normal: f64 = StandardNormal.sample(random);
            let restitution = (self.mean + self.sd * normal).exp();
            // The mean is at most 1, so at least every other is below 1.
            if restitution < 1.0 {
                return restitution;
            }
        }
    }

    /// The law with this restitution at v* and these standard normals.
    pub(crate) fn law(&self, restitution: f64, normals: [f64; MAX_SHAPES]) -> Result<Restitution> {
        let level = restitution.ln() - self.mean;
        let slopes = std::array::from_fn(|knot| {
            let shapes = self.by_normals.iter().zip(normals);
            let shape: f64 = shapes.map(|(by, normal)| by[knot] * normal).sum();
            self.slopes[knot] + self.by_level[knot] * level + shape
        });
        Restitution::smooth(restitution, self.speeds_m_s, slopes)
    }
}

/// The slopes at the knots whose integral, linear in between, has these values there. One number is free, the slope at v*: that
/// with the least sum of the squared differences of neighbours. With the mean slopes d of the pieces, counted from v*, it is
/// (3 d1 - d2 + 3 d3 - d4)/4.
fn slopes(knots_m_s: &[f64; KNOTS], values: &[f64; KNOTS]) -> [f64; KNOTS] {
    let mean = |slower: usize| {
        (values[slower + 1] - values[slower]) / (knots_m_s[slower + 1] / knots_m_s[slower]).ln()
    };
    let [far_slow, near_slow, near_fast, far_fast] = std::array::from_fn(mean);
    let middle = 0.25 * (3.0 * (near_slow + near_fast) - far_slow - far_fast);
    let (half_slow, half_fast) = (2.0 * near_slow - middle, 2.0 * near_fast - middle);
    [
        2.0 * far_slow - half_slow,
        half_slow,
        middle,
        half_fast,
        2.0 * far_fast - half_fast,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEEDS: SpeedRange = SpeedRange {
        reference_m_s: 1.0,
        slowest_m_s: 0.4,
        fastest_m_s: 2.2,
    };

    /// Mean and standard deviation of ln e at a speed: it is linear in the normals, so the squares of its coefficients add up.
    fn moments(prior: &str, speed_m_s: f64) -> (f64, f64) {
        let over = prior.parse::<RestitutionPrior>().unwrap().over(&SPEEDS);
        let ln_e = |level: f64, normals: [f64; MAX_SHAPES]| {
            let law = over
                .law((over.mean + over.sd * level).exp(), normals)
                .unwrap();
            law.at(speed_m_s).ln()
        };
        let mean = ln_e(0.0, [0.0; MAX_SHAPES]);
        let mut variance = (ln_e(1.0, [0.0; MAX_SHAPES]) - mean).powi(2);
        for number in 0..MAX_SHAPES {
            let mut normals = [0.0; MAX_SHAPES];
            normals[number] = 1.0;
            variance += (ln_e(0.0, normals) - mean).powi(2);
        }
        (mean, variance.sqrt())
    }

    #[test]
    fn at_the_knots_the_law_has_the_stated_mean_and_standard_deviation() {
        let prior = "normal:0.4=0.9:0.009,2.2=0.8:0.02";
        for speed_m_s in [0.4, 0.4_f64.sqrt(), 1.0, 2.2_f64.sqrt(), 2.2] {
            let share = (speed_m_s / 0.4).ln() / (2.2 / 0.4_f64).ln();
            let (mean, sd) = (0.9 - 0.1 * share, 0.009 + 0.011 * share);
            let (found, found_sd) = moments(prior, speed_m_s);
            assert!((found - mean.ln()).abs() < 1e-12, "{speed_m_s}");
            let floor = MIN_SD.hypot(sd / mean);
            assert!(
                (found_sd / floor - 1.0).abs() < 1e-9,
                "{speed_m_s}: {found_sd}"
            );
        }
    }

    /// e = 0.9 + 0.01 z + 0.02 w ln v, as functions: at the knots the root of the sum of squares.
    #[test]
    fn functions_add_up_in_quadrature() {
        let tilt = |speed_m_s: f64| 0.02 * speed_m_s.ln();
        let prior = format!(
            "functions:0.4=0.9:0.01:{},2.2=0.9:0.01:{}",
            tilt(0.4),
            tilt(2.2)
        );
        for speed_m_s in [0.4, 1.0, 2.2] {
            let sd = 0.01_f64.hypot(tilt(speed_m_s)) / 0.9;
            let (_, found) = moments(&prior, speed_m_s);
            assert!((found - MIN_SD.hypot(sd)).abs() < 1e-12, "{speed_m_s}");
        }
    }

    /// The density of ln e* integrates to one over the restitutions that there are, also where it is cut off at 1.
    #[test]
    fn the_density_is_normalised() {
        for prior in ["normal:1=0.9:0.01", "normal:1=0.98:0.05", "normal:1=0.5:2"] {
            let over = prior.parse::<RestitutionPrior>().unwrap().over(&SPEEDS);
            let step = 0.001 * over.sd;
            let lowest = (over.mean - 10.0 * over.sd).min(-0.001);
            let steps = (-lowest / step).ceil();
            let step = -lowest / steps;
            let sum: f64 = (0..steps as usize)
                .map(|number| lowest + (number as f64 + 0.5) * step)
                .map(|ln_e| over.log_density(Lanes([ln_e])).0[0].exp() * step)
                .sum();
            assert!((sum - 1.0).abs() < 1e-5, "{prior}: {sum}");
        }
    }

    #[test]
    fn what_is_no_prior_is_refused() {
        let refused = [
            "",
            "normal:",
            "normal:1=0.9",
            "normal:1=0.9:0.01:0.01",
            "normal:1=0.9:0",
            "normal:1=1.1:0.01",
            "normal:2=0.9:0.01,1=0.9:0.01",
            "functions:1=0.9:0.1,2=0.9:0.1:0.1",
            "functions:1=0.9:inf",
            "law:1=0.9:0.01",
        ];
        for text in refused {
            assert!(text.parse::<RestitutionPrior>().is_err(), "{text}");
        }
    }
}
