//! Arithmetic on waves: products, smoothing, values and slopes between samples.

use crate::simd::{add_weighted, dispatch, sum_of_products};
use crate::train::parameters::KERNEL_REACH;
use std::borrow::Cow;
use std::f64::consts::PI;

/// A Hann window of `2 * reach + 1` weights, whose sum is 1.
pub(super) fn smoothing(reach: usize) -> Vec<f32> {
    let window: Vec<f64> = (0..=2 * reach)
        .map(|n| 1.0 - (PI * (n + 1) as f64 / (reach + 1) as f64).cos())
        .collect();
    let sum: f64 = window.iter().sum();
    window.iter().map(|weight| (weight / sum) as f32).collect()
}

/// The samples, each replaced by the weighted mean of those around it.
pub(super) fn convolve(samples: &[f32], kernel: &[f32]) -> Vec<f32> {
    let reach = kernel.len() / 2;
    let first = -reach.cast_signed();
    cross_correlation(&padded(samples, first, samples.len() + 2 * reach), kernel)
}

/// The cross-correlation of a template with samples, for each index at which it lies within them.
pub(super) fn cross_correlation(samples: &[f32], template: &[f32]) -> Vec<f32> {
    let mut sums = vec![0.0; samples.len() + 1 - template.len()];
    dispatch(
        #[inline(always)]
        || add_weighted(&mut sums, samples, template),
    );
    sums
}

/// `length` samples from an index on; before the first and after the last they are 0.
fn padded(samples: &[f32], first: isize, length: usize) -> Cow<'_, [f32]> {
    let inside = usize::try_from(first).ok();
    if let Some(all) = inside.and_then(|first| samples.get(first..first + length)) {
        return all.into();
    }
    let silent = first.min(0).unsigned_abs().min(length);
    let existing = samples.get(first.max(0).unsigned_abs()..);
    let mut padded = vec![0.0; length];
    for (padded, sample) in padded[silent..]
        .iter_mut()
        .zip(existing.unwrap_or_default())
    {
        *padded = *sample;
    }
    padded.into()
}

/// The derivative of a band-limited signal for each sample, which is 0 outside of the samples: the convolution with the
/// derivative of the sinc, (-1)^k/k, in a Hann window.
pub(super) fn derivative(samples: &[f32]) -> Vec<f32> {
    let weight = |index: usize| {
        if index == KERNEL_REACH {
            return 0.0;
        }
        let k = index as f64 - KERNEL_REACH as f64;
        let window = 0.5 + 0.5 * (PI * k / (KERNEL_REACH + 1) as f64).cos();
        let sign = if index % 2 == 1 { 1.0 } else { -1.0 };
        (sign * window / k) as f32
    };
    let weights: [f32; 2 * KERNEL_REACH + 1] = std::array::from_fn(weight);
    convolve(samples, &weights)
}

pub(super) fn dot(a: &[f32], b: &[f32]) -> f32 {
    dispatch(
        #[inline(always)]
        || sum_of_products::<16, _>(a, b),
    )
}

pub(super) fn norm(a: &[f32]) -> f32 {
    dot(a, a).sqrt()
}

/// The energy before each of these samples, and of all.
pub(super) fn running_energy(samples: &[f32]) -> Vec<f64> {
    let mut sum = 0.0;
    let sums = samples.iter().map(|&sample| {
        sum += f64::from(sample).powi(2);
        sum
    });
    std::iter::once(0.0).chain(sums).collect()
}

/// `length` values from a position between samples on, by a windowed sinc; the signal is 0 before
/// the first sample and after the last.
pub(super) fn resample(samples: &[f32], position: f64, length: usize) -> Vec<f32> {
    let whole = position.floor();
    let kernel = kernel(position - whole);
    let first = whole as isize + 1 - KERNEL_REACH.cast_signed();
    cross_correlation(&padded(samples, first, length + kernel.len() - 1), &kernel)
}

/// The weights of the samples around a position this fraction after one of them.
fn kernel(fraction: f64) -> [f32; 2 * KERNEL_REACH] {
    // sin(πx)/(πx) times a Hann window. From tap to tap the sine changes its sign and the angle of the window grows by an
    // equal step, so three calls of sine and cosine suffice for all taps.
    let mut sin = (PI * (fraction + KERNEL_REACH as f64 - 1.0)).sin() / PI;
    let (turn_sin, turn_cos) = (PI / KERNEL_REACH as f64).sin_cos();
    let (mut window_sin, mut window_cos) =
        (PI * (1.0 - fraction) / KERNEL_REACH as f64 - PI).sin_cos();
    std::array::from_fn(|tap| {
        let x = (tap + 1) as f64 - KERNEL_REACH as f64 - fraction;
        let weight = if x.abs() < 1e-9 {
            1.0
        } else {
            -(0.5 + 0.5 * window_cos) * sin / x
        };
        sin = -sin;
        (window_sin, window_cos) = (
            window_sin * turn_cos + window_cos * turn_sin,
            window_cos * turn_cos - window_sin * turn_sin,
        );
        weight as f32
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolation_is_that_of_a_band_limited_signal() {
        let tone: Vec<f32> = (0..200)
            .map(|n| (0.9 * f64::from(n)).sin() as f32)
            .collect();
        for position in [100.0, 100.25, 100.5, 101.9] {
            let error = f64::from(resample(&tone, position, 1)[0]) - (0.9 * position).sin();
            assert!(error.abs() < 2e-3, "{position}: {error}");
        }
    }

    #[test]
    fn the_signal_is_zero_outside_of_the_samples() {
        let samples = [1.0, 2.0, 3.0];
        let around = resample(&samples, -2.0, 7);
        let expected = [0.0, 0.0, 1.0, 2.0, 3.0, 0.0, 0.0];
        for (value, expected) in around.iter().zip(expected) {
            assert!((value - expected).abs() < 1e-6, "{around:?}");
        }
        assert_eq!(resample(&samples, -40.0, 2), [0.0; 2]);
        assert_eq!(resample(&samples, 40.0, 2), [0.0; 2]);
        assert_eq!(convolve(&samples, &[0.0, 1.0, 0.0]), samples);
    }

    #[test]
    fn the_derivative_is_that_of_a_band_limited_signal() {
        let tone: Vec<f32> = (0..200).map(|n| (0.7 * n as f32).sin()).collect();
        let slope = derivative(&tone);
        for (index, slope) in slope.iter().enumerate().take(150).skip(50) {
            let expected = 0.7 * (0.7 * index as f32).cos();
            assert!((slope - expected).abs() < 5e-3, "{index}");
        }
    }
}
