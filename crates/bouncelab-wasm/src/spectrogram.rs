//! Computes spectrograms.

use rustfft::algorithm::Radix4;
use rustfft::algorithm::butterflies::Butterfly8;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftDirection};
use std::sync::Arc;

/// Steps of the transform, each of which makes it four times as long.
const RADIX_4_STEPS: u32 = 3;
/// Samples in a window: 12 ms at 44.1 kHz, about as long as an impact sounds.
const WINDOW: usize = 8 << (2 * RADIX_4_STEPS);
/// What is fainter than this is not shown, in dB relative to full scale.
pub const FLOOR_DB: f64 = -120.0;
/// Steps of a cell for each dB.
const STEPS_PER_DB: f64 = 2.0;
/// What is shown ends here, in Hz: no impact sounds above it.
const TOP_HZ: f64 = 20_000.0;

/// A spectrogram.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrogram {
    /// Frequency at the top in Hz.
    pub top_hz: f64,
    /// Level in half decibels above [`FLOOR_DB`], column after column, each from low to high
    /// frequency.
    pub cells: Vec<u8>,
}

/// The spectrogram of samples in `columns` and `rows`. A column has the greatest level
/// of the windows in it, so that no impact falls between two. The first and the last `margin` samples are only in windows
/// of others.
pub fn spectrogram(
    samples: &[f32],
    margin: usize,
    sample_rate_hz: f64,
    columns: usize,
    rows: usize,
) -> Spectrogram {
    let top_hz = TOP_HZ.min(sample_rate_hz / 2.0);
    // `Radix4::new` would bring the bases of all other lengths into the page: see docs/decisions/006-page-size.md.
    let base = Arc::new(Butterfly8::new(FftDirection::Forward));
    let fft = Radix4::new_with_base(RADIX_4_STEPS, base);
    let window: Vec<f32> = (0..WINDOW)
        .map(|n| {
            let phase = std::f64::consts::TAU * (n as f64 + 0.5) / WINDOW as f64;
            (0.5 - 0.5 * phase.cos()) as f32
        })
        .collect();
    let mut spectrum = vec![Complex::new(0.0, 0.0); WINDOW];
    let mut powers = vec![0.0_f32; WINDOW / 2 + 1];
    let mut cells = Vec::with_capacity(columns * rows);
    let shown = samples.len().saturating_sub(2 * margin);
    let bins_per_row = top_hz / (sample_rate_hz / WINDOW as f64) / rows.max(1) as f64;
    for column in 0..columns {
        powers.fill(0.0);
        for start in starts(shown, columns, column) {
            for (n, value) in spectrum.iter_mut().enumerate() {
                let sample = (margin + start + n).checked_sub(WINDOW / 2);
                let sample = sample.and_then(|n| samples.get(n)).unwrap_or(&0.0);
                *value = Complex::new(sample * window[n], 0.0);
            }
            fft.process(&mut spectrum);
            for (power, value) in powers.iter_mut().zip(&spectrum) {
                *power = power.max(value.norm_sqr());
            }
        }
        cells.extend((0..rows).map(|row| {
            let from = (row as f64 * bins_per_row) as usize;
            let to = (((row + 1) as f64 * bins_per_row).ceil() as usize).max(from + 1);
            let power = powers[from.min(powers.len() - 1)..to.min(powers.len())]
                .iter()
                .copied()
                .fold(0.0, f32::max);
            cell(power)
        }));
    }
    Spectrogram { top_hz, cells }
}

/// The centres of the windows of a column: at least one, and no more than overlap by half.
fn starts(samples: usize, columns: usize, column: usize) -> impl Iterator<Item = usize> {
    let at = |column: usize| samples * column / columns.max(1);
    let (from, to) = (at(column), at(column + 1));
    (from..to.max(from + 1)).step_by(WINDOW / 2)
}

/// A sine at full scale has 0 dB.
fn cell(power: f32) -> u8 {
    const FULL_SCALE: f64 = (WINDOW as f64 / 4.0) * (WINDOW as f64 / 4.0);
    let level_db = 10.0 * (f64::from(power) / FULL_SCALE).log10();
    ((level_db - FLOOR_DB) * STEPS_PER_DB).clamp(0.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sine shows in the row of its frequency, at its level, and only there.
    #[test]
    fn a_sine_is_a_line() {
        let samples: Vec<f32> = (0..44_100)
            .map(|n| 0.1 * (std::f32::consts::TAU * 5000.0 * n as f32 / 44_100.0).sin())
            .collect();
        let (columns, rows) = (50, 40);
        let result = spectrogram(&samples, 0, 44_100.0, columns, rows);
        assert_eq!(result.cells.len(), columns * rows);
        let middle = &result.cells[25 * rows..26 * rows];
        let loudest = (0..rows).max_by_key(|&row| middle[row]).unwrap();
        assert_eq!(loudest, 10);
        // -20 dB is 100 dB above the floor; a window between two bins shows up to 1.5 dB less.
        assert!(
            (197..=200).contains(&middle[loudest]),
            "{}",
            middle[loudest]
        );
        assert!(middle[20] < 80, "{}", middle[20]);
    }

    /// A part with its margins has the columns that it has in the whole.
    #[test]
    fn parts_make_the_whole() {
        let samples: Vec<f32> = (0..40_000)
            .map(|n| (n as f32 * 0.11).sin() * (n % 4001) as f32 / 4001.0)
            .collect();
        let (margin, rows) = (WINDOW / 2, 16);
        let mut padded = vec![0.0; margin];
        padded.extend(&samples);
        padded.extend(vec![0.0; margin]);
        let whole = spectrogram(&samples, 0, 44_100.0, 40, rows);
        let part = |from: usize| {
            let within = from..from + 20_000 + 2 * margin;
            spectrogram(&padded[within], margin, 44_100.0, 20, rows).cells
        };
        assert_eq!([part(0), part(20_000)].concat(), whole.cells);
    }

    #[test]
    fn silence_and_nothing_are_black() {
        assert_eq!(spectrogram(&[0.0; 100], 0, 48_000.0, 3, 2).cells, [0; 6]);
        assert_eq!(spectrogram(&[], 0, 48_000.0, 3, 2).cells, [0; 6]);
        assert!(spectrogram(&[0.0; 100], 0, 48_000.0, 0, 0).cells.is_empty());
    }
}
