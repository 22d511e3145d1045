//! The envelope of a sound, at any zoom.

/// Samples in a bin of the finest level.
const FINEST: usize = 64;
/// Bins of a level that make one of the next.
const STEP: usize = 4;
/// No level has fewer bins than this: it would fit on any screen.
const MIN_BINS: usize = 512;

/// Least and greatest sample of bins of equal length, as sound comes in.
#[derive(Clone, Debug, Default)]
pub struct Pyramid {
    /// Least and greatest of each bin, one after the other.
    finest: Vec<f32>,
    in_bin: usize,
}

/// One level of a pyramid.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Samples in a bin.
    pub samples_per_bin: usize,
    /// Least and greatest of each bin, one after the other.
    pub extremes: Vec<f32>,
}

impl Pyramid {
    /// Takes the next samples.
    pub fn push(&mut self, samples: &[f32]) {
        let mut rest = samples;
        while !rest.is_empty() {
            if self.in_bin == 0 {
                self.finest.extend([f32::INFINITY, f32::NEG_INFINITY]);
            }
            let (now, later) = rest.split_at(rest.len().min(FINEST - self.in_bin));
            if let [.., least, greatest] = self.finest.as_mut_slice() {
                *least = now.iter().copied().fold(*least, f32::min);
                *greatest = now.iter().copied().fold(*greatest, f32::max);
            }
            self.in_bin = (self.in_bin + now.len()) % FINEST;
            rest = later;
        }
    }

    /// All levels, fine to coarse.
    pub fn levels(self) -> Vec<Level> {
        let mut levels = vec![Level {
            samples_per_bin: FINEST,
            extremes: self.finest,
        }];
        while let Some(level) = levels.last()
            && level.extremes.len() > 2 * MIN_BINS * STEP
        {
            levels.push(Level {
                samples_per_bin: level.samples_per_bin * STEP,
                extremes: coarser(&level.extremes),
            });
        }
        levels
    }
}

fn coarser(extremes: &[f32]) -> Vec<f32> {
    let bins = extremes.chunks(2 * STEP);
    bins.flat_map(|bins| {
        let least = bins.iter().step_by(2).copied();
        let greatest = bins.iter().skip(1).step_by(2).copied();
        [
            least.fold(f32::INFINITY, f32::min),
            greatest.fold(f32::NEG_INFINITY, f32::max),
        ]
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every level has the extremes of the samples of each of its bins.
    #[test]
    fn levels_agree_with_the_samples_whatever_the_blocks() {
        let samples: Vec<f32> = (0..300_000)
            .map(|n| (n as f32 * 0.37).sin() * (n % 997) as f32)
            .collect();
        let mut pyramid = Pyramid::default();
        for block in samples.chunks(1013) {
            pyramid.push(block);
        }
        let levels = pyramid.levels();
        assert_eq!(
            levels.iter().map(|l| l.samples_per_bin).collect::<Vec<_>>(),
            [64, 256]
        );
        for level in levels {
            let bins = samples.chunks(level.samples_per_bin);
            assert_eq!(bins.len(), level.extremes.len() / 2);
            for (bin, extremes) in bins.zip(level.extremes.chunks(2)) {
                let least = bin.iter().copied().fold(f32::INFINITY, f32::min);
                let greatest = bin.iter().copied().fold(f32::NEG_INFINITY, f32::max);
                assert_eq!(extremes, [least, greatest]);
            }
        }
    }
}
