//! Samples cut off at the limit of the recorder.

use super::parameters::{MIN_CLIPPED_LEVEL, MIN_CLIPPED_RUN};

/// Counts samples cut off at the limit of the recorder: runs of the same extreme value.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Clipping {
    /// The largest size of a sample so far.
    extreme: f32,
    last: f32,
    /// Number of equal samples in a row at the extreme.
    run: u64,
    count: u64,
}

impl Clipping {
    /// Takes the next samples, of which the largest has the size `loudest`.
    pub(super) fn push(&mut self, samples: &[f32], loudest: f32) {
        // Most blocks are far from the limit.
        if loudest < self.extreme.max(MIN_CLIPPED_LEVEL) {
            self.run = 0;
            self.last = 0.0;
            return;
        }
        for &sample in samples {
            let size = sample.abs();
            if size > self.extreme {
                self.extreme = size;
                self.count = 0;
            }
            self.run = if size >= self.extreme && sample.to_bits() == self.last.to_bits() {
                self.run + 1
            } else {
                1
            };
            if size >= self.extreme && size > MIN_CLIPPED_LEVEL {
                match self.run {
                    MIN_CLIPPED_RUN => self.count += MIN_CLIPPED_RUN,
                    n if n > MIN_CLIPPED_RUN => self.count += 1,
                    _ => {}
                }
            }
            self.last = sample;
        }
    }

    /// Number of clipped samples.
    pub(super) fn count(&self) -> u64 {
        self.count
    }
}
