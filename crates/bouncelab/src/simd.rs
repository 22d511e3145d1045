//! Hot loops with the widest registers that the processor has.

use std::array;
use std::f64::consts::{LOG2_E, SQRT_2};
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Does this work, compiled for the registers that this processor has: eight numbers at a time where
/// every x86-64 processor has four. What the work calls takes part only if it is inlined, and so must
/// the closure itself be: `dispatch(#[inline(always)] || ...)`.
///
/// The operations and their order stay the same, and so does the result, to the last bit.
#[cfg(target_arch = "x86_64")]
#[inline]
pub(crate) fn dispatch<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}

/// Does this work: the registers are as wide as the compiler knows.
#[cfg(not(target_arch = "x86_64"))]
#[inline]
pub(crate) fn dispatch<R>(work: impl FnOnce() -> R) -> R {
    work()
}

/// The sum of the products of numbers at the same places, so many side by side; what the longer slice has more is
/// left out.
#[inline(always)]
pub(crate) fn sum_of_products<const LANES: usize, T>(a: &[T], b: &[T]) -> T
where
    T: Copy + Default + AddAssign + Mul<Output = T> + Sum,
{
    let length = a.len().min(b.len());
    let (a, rest_a) = a[..length].as_chunks::<LANES>();
    let (b, rest_b) = b[..length].as_chunks::<LANES>();
    let mut lanes = [T::default(); LANES];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            lanes[lane] += a[lane] * b[lane];
        }
    }
    let rest: T = rest_a.iter().zip(rest_b).map(|(&x, &y)| x * y).sum();
    let mut sum: T = lanes.into_iter().sum();
    sum += rest;
    sum
}

/// Adds to each sum the samples from its place on, each times its weight, one after the other. There are as many
/// samples as sums and weights, less one.
#[cfg_attr(not(target_family = "wasm"), inline(always))]
pub(crate) fn add_weighted(sums: &mut [f32], samples: &[f32], weights: &[f32]) {
    // So many sums stay in registers; in a browser see below.
    let mut done = 0;
    if cfg!(not(target_family = "wasm")) {
        done += add_weighted_blocks::<64>(sums, samples, weights);
        done += add_weighted_blocks::<16>(&mut sums[done..], &samples[done..], weights);
    }
    add_weighted_blocks::<1>(&mut sums[done..], &samples[done..], weights);
}

/// The same, so many sums at a time; how many were done.
#[inline(always)]
fn add_weighted_blocks<const SUMS: usize>(
    sums: &mut [f32],
    samples: &[f32],
    weights: &[f32],
) -> usize {
    let (blocks, _) = sums.as_chunks_mut::<SUMS>();
    for (number, block) in blocks.iter_mut().enumerate() {
        let mut lanes = *block;
        let places = samples[number * SUMS..].windows(SUMS);
        for (weight, samples) in weights.iter().zip(places) {
            for (lane, sample) in lanes.iter_mut().zip(samples) {
                *lane += weight * sample;
            }
        }
        *block = lanes;
    }
    blocks.len() * SUMS
}

/// So many problems are worked on side by side where each step of one waits for the step before. In a browser, where
/// there are no wide registers, one: eight would make the page a twentieth larger.
pub(crate) const LANES: usize = if cfg!(target_family = "wasm") { 1 } else { 8 };

/// As many numbers as there are lanes, each of a problem of its own, worked on side by side. Inside
/// [`dispatch`] an operation on all of them is a few instructions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lanes<const L: usize>(pub(crate) [f64; L]);

impl<const L: usize> Lanes<L> {
    /// The same in every lane.
    #[inline(always)]
    pub(crate) const fn all(value: f64) -> Self {
        Self([value; L])
    }

    /// What a function of the number of the lane says.
    #[inline(always)]
    pub(crate) fn of(value: impl FnMut(usize) -> f64) -> Self {
        Self(array::from_fn(value))
    }

    #[inline(always)]
    pub(crate) fn map(self, value: impl Fn(f64) -> f64) -> Self {
        Self::of(|lane| value(self.0[lane]))
    }

    /// In each lane the first number where this one is above zero, otherwise the second.
    #[inline(always)]
    pub(crate) fn if_positive(self, then: Self, otherwise: Self) -> Self {
        Self::of(|lane| {
            if self.0[lane] > 0.0 {
                then.0[lane]
            } else {
                otherwise.0[lane]
            }
        })
    }

    #[inline(always)]
    pub(crate) fn abs(self) -> Self {
        self.map(f64::abs)
    }

    #[inline(always)]
    pub(crate) fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    #[inline(always)]
    pub(crate) fn min(self, greatest: f64) -> Self {
        self.map(|x| if x < greatest { x } else { greatest })
    }

    #[inline(always)]
    pub(crate) fn max(self, least: f64) -> Self {
        self.map(|x| if x > least { x } else { least })
    }

    /// The natural logarithm, as [`f64::ln`] but for the last bits and for subnormal numbers, which
    /// count as zero: that function works on one number at a time.
    #[inline(always)]
    pub(crate) fn ln(self) -> Self {
        self.map(ln)
    }

    /// The exponential function, as [`f64::exp`] but for the last bits, and with infinity from exp 709 and
    /// zero from exp -708 on.
    #[inline(always)]
    pub(crate) fn exp(self) -> Self {
        self.map(exp)
    }
}

/// One for each lane, of at least one and at most as many as there are lanes: the lanes that are left over do the work of the
/// last one again.
pub(crate) fn one_for_each_lane<T: Copy, const L: usize>(items: &[T]) -> [T; L] {
    array::from_fn(|lane| items[lane.min(items.len() - 1)])
}

/// The sum of the exponentials of numbers.
pub(crate) fn sum_of_exp(numbers: &[f64]) -> f64 {
    dispatch(
        #[inline(always)]
        || {
            let (lanes, rest) = numbers.as_chunks::<LANES>();
            let lanes = lanes.iter().map(|&numbers| Lanes(numbers).exp());
            let sum = lanes.fold(Lanes::<LANES>::all(0.0), Add::add);
            let rest = rest.iter().map(|&number| exp(number));
            sum.0.into_iter().chain(rest).sum()
        },
    )
}

macro_rules! lane_by_lane {
    ($($operation:ident, $method:ident;)*) => {$(
        impl<const L: usize> $operation for Lanes<L> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::of(|lane| $operation::$method(self.0[lane], other.0[lane]))
            }
        }

        impl<const L: usize> $operation<f64> for Lanes<L> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.map(|own| $operation::$method(own, other))
            }
        }
    )*};
}

lane_by_lane! { Add, add; Sub, sub; Mul, mul; Div, div; }

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|own| -own)
    }
}

/// ln 2 in two parts, of which the first times a whole number of a thousand is exact.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// Added to a number below it, the last bits of the sum are the bits of the nearest whole number.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Without a branch or a table, so that the compiler can do several at once: x = m 2^k with m around one, and
/// ln m = 2 artanh s with s = (m - 1)/(m + 1), by its series.
#[cfg_attr(not(target_family = "wasm"), inline(always))]
fn ln(x: f64) -> f64 {
    const HALF_ROOT: u64 = (0.5 * SQRT_2).to_bits();
    const ONE: u64 = 1.0_f64.to_bits();
    const MANTISSA: u64 = (1 << 52) - 1;
    // 2^52, whose last bits count from zero.
    const COUNT: u64 = 0x4330_0000_0000_0000;
    let shifted = x.to_bits().wrapping_add(ONE - HALF_ROOT);
    let k = f64::from_bits((shifted >> 52) | COUNT) - (f64::from_bits(COUNT) + 1023.0);
    let m = f64::from_bits((shifted & MANTISSA) + HALF_ROOT);
    let s = (m - 1.0) / (m + 1.0);
    let z = s * s;
    let z2 = z * z;
    let z4 = z2 * z2;
    let low = (1.0 / 3.0 + z * (1.0 / 5.0)) + z2 * (1.0 / 7.0 + z * (1.0 / 9.0));
    let high = (1.0 / 11.0 + z * (1.0 / 13.0)) + z2 * (1.0 / 15.0 + z * (1.0 / 17.0));
    let series = z * (low + z4 * (high + z4 * (1.0 / 19.0)));
    let ln = k * LN_2_HIGH + (2.0 * s + (2.0 * s * series + k * LN_2_LOW));
    let finite = if x <= f64::MAX { ln } else { x };
    if x >= f64::MIN_POSITIVE {
        finite
    } else if x >= 0.0 {
        f64::NEG_INFINITY
    } else {
        f64::NAN
    }
}

/// Without a branch or a table: exp x = 2^n exp r with n whole and r around zero, by its series.
#[cfg_attr(not(target_family = "wasm"), inline(always))]
fn exp(x: f64) -> f64 {
    const LEAST: f64 = -708.0;
    const GREATEST: f64 = 709.0;
    let bounded = if x > GREATEST { GREATEST } else { x };
    let bounded = if bounded < LEAST { LEAST } else { bounded };
    let whole = bounded * LOG2_E + WHOLE;
    let n = whole - WHOLE;
    let r = (bounded - n * LN_2_HIGH) - n * LN_2_LOW;
    let r2 = r * r;
    let r4 = r2 * r2;
    let a = (1.0 / 2.0 + r * (1.0 / 6.0)) + r2 * (1.0 / 24.0 + r * (1.0 / 120.0));
    let b = (1.0 / 720.0 + r * (1.0 / 5040.0)) + r2 * (1.0 / 40_320.0 + r * (1.0 / 362_880.0));
    let c = (1.0 / 3_628_800.0 + r * (1.0 / 39_916_800.0))
        + r2 * (1.0 / 479_001_600.0 + r * (1.0 / 6_227_020_800.0));
    let series = 1.0 + (r + r2 * (a + r4 * (b + r4 * c)));
    let power = f64::from_bits(whole.to_bits().wrapping_add(1023) << 52);
    let exp = series * power;
    let not_huge = if x > GREATEST { f64::INFINITY } else { exp };
    if x < LEAST { 0.0 } else { not_huge }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the functions of the platform, from the smallest normal numbers to the greatest.
    #[test]
    fn logarithms_and_powers_are_those_of_one_number() {
        let mut x = f64::MIN_POSITIVE;
        while x < f64::MAX / 1.7 {
            let (found, expected) = (ln(x), x.ln());
            assert!(
                (found - expected).abs() <= 3e-16 * expected.abs(),
                "ln {x}: {found} {expected}"
            );
            x *= 1.618;
        }
        for step in -7000..=7080 {
            let x = 0.1 * f64::from(step) + 0.01;
            let (found, expected) = (exp(x), x.exp());
            assert!(
                (found / expected - 1.0).abs() < 1e-15,
                "exp {x}: {found} {expected}"
            );
        }
    }

    /// The terms are added in their order, however many sums are worked on at a time.
    #[test]
    fn weighted_sums_are_those_of_one_after_the_other() {
        let wave = |n: usize| (0.37 * n as f32).sin();
        for (count, terms) in [
            (0, 3),
            (1, 1),
            (15, 4),
            (16, 5),
            (63, 2),
            (64, 7),
            (203, 30),
        ] {
            let samples: Vec<f32> = (0..count + terms - 1).map(wave).collect();
            let weights: Vec<f32> = (0..terms).map(|term| wave(term * term + 1)).collect();
            let mut sums: Vec<f32> = (0..count).map(|sum| 0.1 * sum as f32).collect();
            let expected = sums.iter().enumerate().map(|(place, sum)| {
                let terms = weights.iter().zip(&samples[place..]);
                terms.fold(*sum, |sum, (weight, sample)| sum + weight * sample)
            });
            let expected: Vec<f32> = expected.collect();
            add_weighted(&mut sums, &samples, &weights);
            assert_eq!(sums, expected, "{count} sums of {terms} terms");
        }
    }

    #[test]
    fn exponentials_of_any_number_are_added() {
        for count in [0, 1, 8, 29] {
            let numbers: Vec<f64> = (0..count).map(|n| 0.3 * f64::from(n) - 5.0).collect();
            let expected: f64 = numbers.iter().map(|number| number.exp()).sum();
            assert!((sum_of_exp(&numbers) - expected).abs() <= 1e-14 * expected);
        }
    }

    #[test]
    fn logarithms_near_one_lose_no_digits() {
        for step in -50..=50 {
            let x = 1.0 + 1e-9 * f64::from(step);
            assert!((ln(x) - x.ln()).abs() <= 3e-16 * x.ln().abs(), "{x}");
        }
    }

    #[test]
    fn what_is_no_number_stays_none() {
        let lanes = Lanes([0.0, -1.0, f64::NAN, f64::INFINITY]).ln().0;
        assert!(lanes[0] == f64::NEG_INFINITY && lanes[3] == f64::INFINITY);
        assert!(lanes[1].is_nan() && lanes[2].is_nan());
        let lanes = Lanes([f64::NEG_INFINITY, 1e4, f64::NAN, 0.0]).exp().0;
        assert!(lanes[0] == 0.0 && lanes[1] == f64::INFINITY && lanes[2].is_nan());
        assert!((lanes[3] - 1.0).abs() < 1e-15);
    }
}
