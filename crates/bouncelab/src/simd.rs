//! Hot loops with the widest registers that the processor has.

use std::array;
use std::f64::consts::{LOG2_E, SQRT_2};
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Runs `work` compiled for the registers of this processor: 256 bits with AVX2 where every x86-64 processor has 128.
/// Only code that is inlined into `work` is compiled so, and the closure itself must be inlined too:
/// `dispatch(#[inline(always)] || ...)`.
///
/// The operations and their order stay the same, and so does the result, to the last bit.
#[cfg(target_arch = "x86_64")]
#[inline]
pub(crate) fn dispatch<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}

/// Runs `work`: the compiler knows the width of the registers.
#[cfg(not(target_arch = "x86_64"))]
#[inline]
pub(crate) fn dispatch<R>(work: impl FnOnce() -> R) -> R {
    work()
}

/// The sum of the products of numbers at equal indices, with `LANES` partial sums; the longer slice is truncated.
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

/// Adds to each sum the samples from its index on, each times its weight, in this order. The number of
/// samples is that of sums and weights together, less one.
#[cfg_attr(not(target_family = "wasm"), inline(always))]
pub(crate) fn add_weighted(sums: &mut [f32], samples: &[f32], weights: &[f32]) {
    // 64 sums stay in registers while the weights pass. For the browser see `LANES`.
    let mut done = 0;
    if cfg!(not(target_family = "wasm")) {
        done += add_weighted_blocks::<64>(sums, samples, weights);
        done += add_weighted_blocks::<16>(&mut sums[done..], &samples[done..], weights);
    }
    add_weighted_blocks::<1>(&mut sums[done..], &samples[done..], weights);
}

/// The same for `SUMS` sums at a time; returns the number of sums done.
#[inline(always)]
fn add_weighted_blocks<const SUMS: usize>(
    sums: &mut [f32],
    samples: &[f32],
    weights: &[f32],
) -> usize {
    let (blocks, _) = sums.as_chunks_mut::<SUMS>();
    for (number, block) in blocks.iter_mut().enumerate() {
        let mut lanes = *block;
        let windows = samples[number * SUMS..].windows(SUMS);
        for (weight, samples) in weights.iter().zip(windows) {
            for (lane, sample) in lanes.iter_mut().zip(samples) {
                *lane += weight * sample;
            }
        }
        *block = lanes;
    }
    blocks.len() * SUMS
}

/// Number of problems that are computed side by side where each step of one waits for the step before. In a browser, which
/// has no wide registers, one: eight would make the page larger by a twentieth.
pub(crate) const LANES: usize = if cfg!(target_family = "wasm") { 1 } else { 8 };

/// One number for each of `L` problems that are computed side by side. Inside
/// [`dispatch`] an operation on all of them is a few instructions. `wide` has such types too, of the width that is known
/// when the program is compiled (docs/decisions/009).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lanes<const L: usize>(pub(crate) [f64; L]);

impl<const L: usize> Lanes<L> {
    /// The same number in every lane.
    #[inline(always)]
    pub(crate) const fn all(value: f64) -> Self {
        Self([value; L])
    }

    /// The values of a function of the index of the lane.
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
    pub(crate) fn min(self, max: f64) -> Self {
        self.map(|x| if x < max { x } else { max })
    }

    #[inline(always)]
    pub(crate) fn max(self, min: f64) -> Self {
        self.map(|x| if x > min { x } else { min })
    }

    /// The natural logarithm: [`f64::ln`], which takes one number at a time, except for the last bits and for subnormal
    /// numbers, which count as zero.
    #[inline(always)]
    pub(crate) fn ln(self) -> Self {
        self.map(ln)
    }

    /// The exponential function: [`f64::exp`] except for the last bits, and with infinity above 709 and
    /// zero below -708.
    #[inline(always)]
    pub(crate) fn exp(self) -> Self {
        self.map(exp)
    }
}

/// One item for each lane, of at least one and at most `L` items: the remaining lanes repeat the last one.
pub(crate) fn one_for_each_lane<T: Copy, const L: usize>(items: &[T]) -> [T; L] {
    array::from_fn(|lane| items[lane.min(items.len() - 1)])
}

/// The sum of the exponentials of numbers.
pub(crate) fn sum_of_exp(numbers: &[f64]) -> f64 {
    dispatch(
        #[inline(always)]
        || {
            let (chunks, rest) = numbers.as_chunks::<LANES>();
            let exponentials = chunks.iter().map(|&numbers| Lanes(numbers).exp());
            let sums = exponentials.fold(Lanes::<LANES>::all(0.0), Add::add);
            let of_rest = rest.iter().map(|&number| exp(number));
            sums.0.into_iter().chain(of_rest).sum()
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

/// ln 2 as a sum of two numbers; the product of the first with a whole number up to a thousand is exact.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// 1.5 2^52. The last bits of its sum with a number are the bits of the nearest whole number.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Without a branch or a table, so that the compiler can compute several at once: x = m 2^k with m between the square roots
/// of 1/2 and 2, and ln m = 2 artanh s with s = (m - 1)/(m + 1), by its series.
#[cfg_attr(not(target_family = "wasm"), inline(always))]
fn ln(x: f64) -> f64 {
    const HALF_ROOT: u64 = (0.5 * SQRT_2).to_bits();
    const ONE: u64 = 1.0_f64.to_bits();
    const MANTISSA: u64 = (1 << 52) - 1;
    // The bits of 2^52: a whole number in its last bits is added to it.
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

/// Without a branch or a table: exp x = 2^n exp r with n whole and |r| at most ln 2 / 2, by its series.
#[cfg_attr(not(target_family = "wasm"), inline(always))]
fn exp(x: f64) -> f64 {
    const MIN: f64 = -708.0;
    const MAX: f64 = 709.0;
    let below_max = if x > MAX { MAX } else { x };
    let bounded = if below_max < MIN { MIN } else { below_max };
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
    let upper = if x > MAX { f64::INFINITY } else { exp };
    if x < MIN { 0.0 } else { upper }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the functions of the platform, from the smallest normal numbers to the largest.
    #[test]
    fn logarithms_and_powers_are_those_of_one_number() {
        let mut x = f64::MIN_POSITIVE;
        while x < f64::MAX / 1.7 {
            let (own, expected) = (ln(x), x.ln());
            assert!(
                (own - expected).abs() <= 3e-16 * expected.abs(),
                "ln {x}: {own} {expected}"
            );
            x *= 1.618;
        }
        for step in -7000..=7080 {
            let x = 0.1 * f64::from(step) + 0.01;
            let (own, expected) = (exp(x), x.exp());
            assert!(
                (own / expected - 1.0).abs() < 1e-15,
                "exp {x}: {own} {expected}"
            );
        }
    }

    /// The terms are added in their order, however many sums are computed at a time.
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
            let one_by_one = sums.iter().enumerate().map(|(index, sum)| {
                let terms = weights.iter().zip(&samples[index..]);
                terms.fold(*sum, |sum, (weight, sample)| sum + weight * sample)
            });
            let expected: Vec<f32> = one_by_one.collect();
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
    fn infinities_and_nan_are_those_of_the_functions() {
        let lanes = Lanes([0.0, -1.0, f64::NAN, f64::INFINITY]).ln().0;
        assert!(lanes[0] == f64::NEG_INFINITY && lanes[3] == f64::INFINITY);
        assert!(lanes[1].is_nan() && lanes[2].is_nan());
        let lanes = Lanes([f64::NEG_INFINITY, 1e4, f64::NAN, 0.0]).exp().0;
        assert!(lanes[0] == 0.0 && lanes[1] == f64::INFINITY && lanes[2].is_nan());
        assert!((lanes[3] - 1.0).abs() < 1e-15);
    }
}
