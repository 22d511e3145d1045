//! Lowers high sample rates while the samples come.
//!
//! There is no band above 24 kHz, and times are far more accurate than a sample, so samples beyond
//! 96 kHz would cost memory and time for nothing. The low-pass filter is of finite length and symmetric, so that
//! it delays all frequencies equally and its delay is subtracted exactly. It passes frequencies below a
//! third of the new rate; those that would fold back into them are attenuated by 70 dB (Blackman window).

use std::f64::consts::PI;

use super::parameters::{DECIMATOR_CUT, DECIMATOR_REACH, MAX_RATE_HZ};
use crate::simd::{dispatch, sum_of_products};

/// Keeps one of `factor` samples of a stream, without the frequencies above half their rate.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Decimator {
    factor: usize,
    taps: Vec<f32>,
    /// The latest samples, and the index in them of the first that the filter needs for the next kept one.
    latest: Vec<f32>,
    first: usize,
    kept: Vec<f32>,
}

impl Decimator {
    /// The decimator for a rate, `None` if the rate is low enough; and the lowered rate, in Hz.
    pub(super) fn of_rate(sample_rate_hz: u32) -> (Option<Self>, f64) {
        let factor = sample_rate_hz.div_ceil(MAX_RATE_HZ).max(1) as usize;
        let decimator = (factor > 1).then(|| Self {
            factor,
            taps: low_pass(factor),
            latest: Vec::new(),
            first: 0,
            kept: Vec::new(),
        });
        (decimator, f64::from(sample_rate_hz.max(1)) / factor as f64)
    }

    /// Takes the next samples; returns those that are kept. The first is at the time of the first sample.
    pub(super) fn push(&mut self, samples: &[f32]) -> &[f32] {
        if self.latest.is_empty()
            && let Some(&begin) = samples.first()
        {
            self.latest.resize(self.reach(), begin);
        }
        self.latest.extend_from_slice(samples);
        self.keep()
    }

    /// Ends the stream, as if its last value were repeated; returns the last kept samples.
    pub(super) fn finish(&mut self) -> &[f32] {
        let hold = self.latest.last().copied().unwrap_or(0.0);
        self.latest.resize(self.latest.len() + self.reach(), hold);
        self.keep()
    }

    fn keep(&mut self) -> &[f32] {
        self.kept.clear();
        dispatch(
            #[inline(always)]
            || {
                while let Some(around) = self.latest.get(self.first..self.first + self.taps.len()) {
                    self.kept.push(sum_of_products::<16, _>(around, &self.taps));
                    self.first += self.factor;
                }
            },
        );
        // Some always remain: the filter is longer than a step.
        self.latest.drain(..self.first);
        self.first = 0;
        &self.kept
    }

    fn reach(&self) -> usize {
        self.taps.len() / 2
    }
}

/// The weights of the samples around one that is kept; their sum is 1.
fn low_pass(factor: usize) -> Vec<f32> {
    let reach = (DECIMATOR_REACH * factor) as f64;
    let weight = |index: usize| {
        let at = index as f64 - reach;
        let turn = PI * at / (reach + 1.0);
        let window = 0.42 + 0.5 * turn.cos() + 0.08 * (2.0 * turn).cos();
        let phase = 2.0 * PI * DECIMATOR_CUT * at / factor as f64;
        let sinc = if at == 0.0 { 1.0 } else { phase.sin() / phase };
        window * sinc
    };
    let weights: Vec<f64> = (0..=2 * DECIMATOR_REACH * factor).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter().map(|weight| (weight / sum) as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The samples that are kept of a tone of amplitude 1 at 384 kHz, in blocks of this size.
    fn kept(tone_hz: f64, block: usize) -> Vec<f32> {
        let tone: Vec<f32> = (0..38_400)
            .map(|n| (2.0 * PI * tone_hz * f64::from(n) / 384e3).sin() as f32)
            .collect();
        let mut decimator = Decimator::of_rate(384_000).0.unwrap();
        let mut kept = Vec::new();
        for block in tone.chunks(block) {
            kept.extend_from_slice(decimator.push(block));
        }
        kept.extend_from_slice(decimator.finish());
        kept
    }

    #[test]
    fn low_tones_and_their_times_are_unchanged() {
        for tone_hz in [100.0, 10e3, 30e3] {
            let kept = kept(tone_hz, 1000);
            assert_eq!(kept.len(), 9600);
            // Away from the ends, where the tone is cut off.
            for (n, &sample) in kept.iter().enumerate().skip(20).take(9560) {
                let tone = (2.0 * PI * tone_hz * n as f64 / 96e3).sin();
                assert!((f64::from(sample) - tone).abs() < 1e-3, "{tone_hz} Hz, {n}");
            }
        }
    }

    /// 70 dB: the side lobes of Blackman's window.
    #[test]
    fn tones_that_would_fold_back_are_taken_out() {
        for tone_hz in [50e3, 66e3, 90e3, 150e3] {
            let kept = kept(tone_hz, 1000);
            let peak = kept[20..9580]
                .iter()
                .fold(0.0_f32, |peak, x| peak.max(x.abs()));
            assert!(peak < 10f32.powf(-70.0 / 20.0), "{tone_hz} Hz: {peak}");
        }
    }

    #[test]
    fn blocks_make_no_difference() {
        let whole = kept(20e3, 38_400);
        for block in [1, 3, 777] {
            assert_eq!(kept(20e3, block), whole);
        }
    }

    #[test]
    fn rates_are_lowered_to_96_khz_at_most() {
        let kept = |rate_hz| {
            let (decimator, left_hz) = Decimator::of_rate(rate_hz);
            (decimator.map_or(1, |it| it.factor), left_hz)
        };
        assert_eq!(kept(96_000), (1, 96e3));
        assert_eq!(kept(192_000), (2, 96e3));
        assert_eq!(kept(655_350), (7, 655_350.0 / 7.0));
        assert_eq!(kept(10_000_000), (105, 1e7 / 105.0));
    }
}
