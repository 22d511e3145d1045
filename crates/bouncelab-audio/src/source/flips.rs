//! Flipped bits: samples that jump by a power of two and are back with the next one. No converter records that: the filter
//! before it lets a sound rise and fall over several samples, and the jumps of a sound are no powers of two.

/// Minimum jump over full scale: a smaller one neither hides an impact nor looks like one.
const MIN_JUMP: f32 = 1.0 / 128.0;

/// Minimum jump over the largest difference between neighbouring samples around it.
const MIN_JUMP_OVER_ROUGHNESS: f32 = 64.0;

/// Minimum number of flipped samples. Of other jumps as large, one in twenty is by chance as near to a power of two.
const MIN_SAMPLES: u64 = 3;

/// Number of samples that are compared: one, and two on each side.
const WINDOW: usize = 5;

/// The samples of which a bit was flipped.
#[derive(Debug, Default)]
pub(super) struct Flips {
    samples: u64,
    /// Frame of the first one.
    first: u64,
    /// The frame behind those that were taken, and the last samples of each channel before it.
    next: u64,
    before: Vec<Vec<f32>>,
}

impl Flips {
    /// Takes the next frames, of which the first has the number `at`.
    pub(super) fn take(&mut self, at: u64, planes: &[Vec<f32>]) {
        if at != self.next {
            self.before.clear();
        }
        self.before.resize(planes.len(), Vec::new());
        for (before, plane) in self.before.iter_mut().zip(planes) {
            let known = before.len();
            before.extend(plane.iter().take(WINDOW - 1));
            let across = flipped(before).map(|index| at + index as u64 - known as u64);
            let within = flipped(plane).map(|index| at + index as u64);
            for frame in across.chain(within) {
                if self.samples == 0 || frame < self.first {
                    self.first = frame;
                }
                self.samples += 1;
            }
            if plane.len() >= WINDOW {
                before.clear();
                before.extend(&plane[plane.len() - (WINDOW - 1)..]);
            } else {
                before.drain(..before.len().saturating_sub(WINDOW - 1));
            }
        }
        self.next = at + planes.first().map_or(0, Vec::len) as u64;
    }

    /// Number of flipped samples in all channels, and the frame of the first one; `None` if they may be chance.
    pub(super) fn suspect(&self) -> Option<(u64, u64)> {
        (self.samples >= MIN_SAMPLES).then_some((self.samples, self.first))
    }
}

/// The indices of flipped samples.
fn flipped(samples: &[f32]) -> impl Iterator<Item = usize> {
    let windows = samples.array_windows::<WINDOW>().zip(WINDOW / 2..);
    windows.filter_map(|(window, index)| is_flipped(window).then_some(index))
}

fn is_flipped(&[a, b, sample, c, d]: &[f32; WINDOW]) -> bool {
    // Nearly all samples end here.
    if (sample - b).abs() < MIN_JUMP {
        return false;
    }
    // The cubic through the neighbours.
    let jump = (sample - (4.0 * (b + c) - (a + d)) / 6.0).abs();
    let roughness = (b - a).abs().max((c - b).abs()).max((d - c).abs());
    // Without noise the sound is a made one, which may jump as it likes.
    let is_alone = roughness > 0.0 && jump >= MIN_JUMP_OVER_ROUGHNESS * roughness;
    let power = jump.log2().round().exp2();
    is_alone && (jump - power).abs() <= roughness
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Noise of about three steps of 16 bits.
    fn noise() -> Vec<i16> {
        let mut state = 1_u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 29) as i16
        };
        (0..3_000).map(|_| next() + next()).collect()
    }

    fn found(samples: &[i16], block: usize) -> Option<(u64, u64)> {
        let plane: Vec<f32> = samples.iter().map(|&it| f32::from(it) / 32_768.0).collect();
        let mut flips = Flips::default();
        for (number, part) in plane.chunks(block).enumerate() {
            flips.take((number * block) as u64, &[part.to_vec(), part.to_vec()]);
        }
        flips.suspect()
    }

    #[test]
    fn flipped_bits_are_found_whatever_the_blocks() {
        let mut damaged = noise();
        for (index, bit) in [(200, 14), (640, 13), (641 + 400, 12), (2_000, 10)] {
            damaged[index] ^= 1 << bit;
        }
        let whole = found(&damaged, 3_000);
        assert!(
            whole.is_some_and(|(samples, first)| samples >= 6 && first == 200),
            "{whole:?}"
        );
        for block in [1, 3, 4, 5, 64, 641, 999] {
            assert_eq!(found(&damaged, block), whole, "{block}");
        }
    }

    #[test]
    fn clicks_of_other_sizes_and_shapes_are_sounds() {
        let mut clicks = noise();
        for index in (100..2_900).step_by(400) {
            clicks[index] += 11_600;
        }
        assert_eq!(found(&clicks, 3_000), None);
        let mut filtered = noise();
        for index in (100..2_900).step_by(400) {
            for (offset, part) in [(0, 4_096), (1, 16_384), (2, 4_096)] {
                filtered[index + offset] += part;
            }
        }
        assert_eq!(found(&filtered, 3_000), None);
        // Clicks that a program made, in digital silence.
        let mut made = vec![0; 3_000];
        (100..2_900)
            .step_by(400)
            .for_each(|index| made[index] = 16_384);
        assert_eq!(found(&made, 3_000), None);
    }
}
