//! The noise floor: a low quantile of the latest energies, and the noise of rounding.

/// Bits of a number that its bin leaves out. A bin is the exponent and the first three bits after it, as single precision
/// stores them: an eighth of an octave in power, without a logarithm.
const SHIFT: u32 = 20;
const BINS: usize = 1 << (31 - SHIFT);

/// A quantile of the latest values, which must not be negative.
///
/// The values are counted in bins, and the search for the bin of the quantile starts where it was last: a new
/// value costs the same, however many are remembered.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Quantile {
    share: f64,
    capacity: usize,
    /// The bins of the latest values, a ring whose oldest is at `oldest`.
    recent: Vec<u16>,
    oldest: usize,
    counts: Vec<u16>,
    /// The bin in which the quantile was last, and how many values lie below it.
    bin: usize,
    below: usize,
}

impl Quantile {
    pub(super) fn new(share: f64, capacity: usize) -> Self {
        let capacity = capacity.clamp(1, usize::from(u16::MAX));
        Self {
            share,
            capacity,
            recent: Vec::with_capacity(capacity),
            oldest: 0,
            counts: vec![0; BINS],
            bin: 0,
            below: 0,
        }
    }

    pub(super) fn push(&mut self, value: f32) {
        // The sign bit is masked: minus zero is zero.
        let code = (value.to_bits() >> SHIFT) as u16 & (BINS - 1) as u16;
        if self.recent.len() < self.capacity {
            self.recent.push(code);
        } else {
            // The new value replaces the oldest one, in the ring and in the counts.
            let old = usize::from(std::mem::replace(&mut self.recent[self.oldest], code));
            self.counts[old] -= 1;
            self.below -= usize::from(old < self.bin);
            self.oldest += 1;
            if self.oldest == self.capacity {
                self.oldest = 0;
            }
        }
        let bin = usize::from(code);
        self.counts[bin] += 1;
        self.below += usize::from(bin < self.bin);
    }

    /// How many values are less than the quantile.
    fn rank(&self) -> usize {
        (self.recent.len() as f64 * self.share) as usize
    }

    /// The quantile, within an eighth of an octave at worst; 0 without values.
    pub(super) fn value(&mut self) -> f32 {
        if self.recent.is_empty() {
            return 0.0;
        }
        // From the bin of last time to that in which the value of this rank lies: down, then up.
        let rank = self.rank();
        while self.below > rank {
            self.bin -= 1;
            self.below -= usize::from(self.counts[self.bin]);
        }
        while self.below + usize::from(self.counts[self.bin]) <= rank {
            self.below += usize::from(self.counts[self.bin]);
            self.bin += 1;
        }
        // Between the edges of the bin by the rank, as if its values lay evenly in it.
        let edge = |bin: usize| f32::from_bits((bin as u32) << SHIFT);
        let (low, high) = (edge(self.bin), edge(self.bin + 1));
        let inside = (rank - self.below) as f32 + 0.5;
        low + (high - low) * inside / f32::from(self.counts[self.bin])
    }
}

/// The smallest step between samples. The format resolves no less, so at least the noise of rounding to this step is
/// assumed, even where a recording is digitally silent.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct QuantisationStep {
    last: f32,
    smallest: f32,
}

impl QuantisationStep {
    pub(super) fn new() -> Self {
        Self {
            last: 0.0,
            smallest: f32::INFINITY,
        }
    }

    /// Takes samples that follow each other, for the smallest step between them.
    pub(super) fn measure(&mut self, samples: &[f32]) {
        const LANES: usize = 16;
        let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
            return;
        };
        let step = |a: f32, b: f32| {
            let size = (b - a).abs();
            // Equal samples say nothing of the step.
            if size > 0.0 { size } else { f32::INFINITY }
        };
        // A comparison in place of `min`, which takes care of NaN: one instruction for all lanes.
        let min = |a: f32, b: f32| if b < a { b } else { a };
        let mut lanes = [self.smallest; LANES];
        let (before, rest_before) = samples[..samples.len() - 1].as_chunks::<LANES>();
        let (after, rest_after) = samples[1..].as_chunks::<LANES>();
        for (a, b) in rest_before.iter().zip(rest_after) {
            lanes[0] = min(lanes[0], step(*a, *b));
        }
        for (a, b) in before.iter().zip(after) {
            for (lane, (a, b)) in lanes.iter_mut().zip(a.iter().zip(b)) {
                *lane = min(*lane, step(*a, *b));
            }
        }
        let smallest = lanes.into_iter().fold(f32::INFINITY, min);
        self.smallest = min(smallest, step(self.last, *first));
        self.last = *last;
    }

    /// The largest power that rounding to such steps makes, that of half a step: a sound smaller than a step, or the tail
    /// of one, toggles the last bit as it comes and goes.
    pub(super) fn power(&self) -> f64 {
        if self.smallest.is_finite() {
            f64::from(self.smallest).powi(2) / 4.0
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantile_is_that_of_the_latest_values() {
        let mut quantile = Quantile::new(0.3, 100);
        // Values over twelve decades, each larger or smaller than the one before.
        let values: Vec<f32> = (0..1000)
            .map(|n| 10f32.powf(((n * 37) % 100) as f32 / 8.0 - 9.0))
            .collect();
        for end in 1..values.len() {
            quantile.push(values[end - 1]);
            let mut latest = values[end.saturating_sub(100)..end].to_vec();
            latest.sort_unstable_by(f32::total_cmp);
            let expected = latest[(latest.len() as f64 * 0.3) as usize];
            let ratio = quantile.value() / expected;
            assert!((0.88..1.13).contains(&ratio), "{end}: {ratio}");
        }
    }

    #[test]
    fn quantile_of_silence_is_silence() {
        let mut quantile = Quantile::new(0.3, 10);
        assert!(quantile.value() < f32::MIN_POSITIVE);
        quantile.push(0.0);
        assert!(quantile.value() < f32::MIN_POSITIVE);
    }

    #[test]
    fn quantisation_step_is_the_smallest_change() {
        let mut step = QuantisationStep::new();
        assert!(step.power() < f64::MIN_POSITIVE);
        step.measure(&[0.5, 0.5, 0.25, 0.375, 0.375]);
        assert!((step.power() - 0.125f64.powi(2) / 4.0).abs() < f64::EPSILON);
        let mut long = vec![0.5; 100];
        long[63] += 0.01;
        step.measure(&long);
        assert!((step.power() - 1e-4 / 4.0).abs() < 1e-8);
    }
}
