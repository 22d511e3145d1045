//! The upper bands: a tree of half-band filters.
//!
//! Each level splits a sound at a quarter of its rate: the upper half is measured, the lower half
//! goes to the next level at half the rate. The filter is the maximally flat half-band filter of
//! eleven taps (Lagrange interpolation between six samples): its upper half has six zeros at
//! frequency 0, so that rumble stays out of it. It needs three multiplications for each sample,
//! has no recursion, and reaches a fraction of a millisecond to both sides; the levels are delayed
//! so that the energies of all of them are those of the same moment.

/// Weights of the neighbours at distance 1, 3 and 5.
const WEIGHTS: [f32; 3] = [150.0 / 512.0, -25.0 / 512.0, 3.0 / 512.0];
/// Weight of the sample itself.
const MIDDLE: f32 = 0.5;
/// Samples of the filter to each side.
const REACH: usize = 5;
/// Power of white noise that the upper half of the filter lets through.
pub(super) const WHITE_SHARE: f64 = 0.4265;

/// Splits a sound into octaves, one frame of samples after the other.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Octaves {
    levels: Vec<Level>,
    last: LastLevel,
}

/// One level but the last: even and odd samples apart, the latest of the past in front.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Level {
    even: Vec<f32>,
    odd: Vec<f32>,
    /// Squares of the upper half, summed in pairs; the first `delay` are those of the past.
    pairs: Vec<f32>,
    delay: usize,
    /// The lower half at half the rate.
    low: Vec<f32>,
}

/// The last level has an upper half only.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct LastLevel {
    samples: Vec<f32>,
    squares: Vec<f32>,
}

impl Octaves {
    /// A tree of `halvings` levels and a last one, for frames of `frame` samples, a multiple of
    /// 2^halvings.
    pub(super) fn new(halvings: usize, frame: usize) -> Self {
        let levels = (0..halvings)
            .map(|level| {
                let pairs = (frame >> level) / 2;
                let delay = REACH * ((1 << (halvings - level)) - 1);
                Level {
                    even: vec![0.0; REACH + pairs],
                    odd: vec![0.0; REACH + pairs],
                    pairs: vec![0.0; delay + pairs],
                    delay,
                    low: vec![0.0; pairs],
                }
            })
            .collect();
        let length = frame >> halvings;
        Self {
            levels,
            last: LastLevel {
                samples: vec![0.0; 2 * REACH + length],
                squares: vec![0.0; length],
            },
        }
    }

    /// Delay of the squares, in samples.
    pub(super) fn delay(&self) -> usize {
        REACH * ((2 << self.levels.len()) - 1)
    }

    /// Fills the past with this value.
    pub(super) fn begin(&mut self, value: f32) {
        for level in &mut self.levels {
            level.even.fill(value);
            level.odd.fill(value);
        }
        self.last.samples.fill(value);
    }

    /// Takes the next frame; returns its low frequencies at the lowest rate, which are delayed less than the
    /// squares.
    pub(super) fn push(&mut self, frame: &[f32]) -> &[f32] {
        let mut sound = frame;
        for level in &mut self.levels {
            level.split(sound);
            sound = &level.low;
        }
        self.last.take(sound);
        self.last.square();
        &self.last.samples[2 * REACH..]
    }

    /// Adds the mean squares of each hop in the upper half of a level to `energies`.
    pub(super) fn add_energies(&self, level: usize, energies: &mut [f32]) {
        let (squares, delay, scale) = if let Some(level) = self.levels.get(level) {
            (&level.pairs, level.delay, 0.5)
        } else {
            (&self.last.squares, 0, 1.0)
        };
        match (squares.len() - delay) / energies.len() {
            // At 44.1 and 48 kHz: loops of constant length unroll.
            3 => add_means(squares.as_chunks::<3>().0, scale, energies),
            6 => add_means(squares.as_chunks::<6>().0, scale, energies),
            12 => add_means(squares.as_chunks::<12>().0, scale, energies),
            length => {
                let scale = scale / length as f32;
                for (mean, values) in energies.iter_mut().zip(squares.chunks_exact(length)) {
                    *mean += scale * sum(values);
                }
            }
        }
    }
}

/// Adds the mean of each chunk of values, times `scale`.
fn add_means<const LENGTH: usize>(chunks: &[[f32; LENGTH]], scale: f32, means: &mut [f32]) {
    let scale = scale / LENGTH as f32;
    for (mean, values) in means.iter_mut().zip(chunks) {
        *mean += scale * sum(values);
    }
}

fn sum(values: &[f32]) -> f32 {
    let quads = values.chunks_exact(4);
    let rest: f32 = quads.remainder().iter().sum();
    let lanes = quads.fold([0.0_f32; 4], |sums, quad| {
        std::array::from_fn(|lane| sums[lane] + quad[lane])
    });
    (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]) + rest
}

impl Level {
    /// Takes the next samples, squares their upper half and keeps the lower half.
    fn split(&mut self, samples: &[f32]) {
        let length = self.low.len();
        self.even.copy_within(length.., 0);
        self.odd.copy_within(length.., 0);
        self.pairs.copy_within(length.., 0);
        let pairs = self.even[REACH..].iter_mut().zip(&mut self.odd[REACH..]);
        for ((even, odd), pair) in pairs.zip(samples.as_chunks::<2>().0) {
            [*even, *odd] = *pair;
        }
        let (even, odd) = (Taps::new(&self.even), Taps::new(&self.odd));
        let pairs = &mut self.pairs[self.delay..][..length];
        let low = &mut self.low[..length];
        for j in 0..length {
            // The middle of an even sample's neighbours is an odd sample, and the reverse.
            let around_odd = even.around(j);
            let odd_middle = MIDDLE * odd.at[2][j];
            let first = odd_middle - around_odd;
            let second = MIDDLE * even.at[3][j] - odd.around(j);
            pairs[j] = first * first + second * second;
            low[j] = odd_middle + around_odd;
        }
    }
}

/// The same values from six successive indices on.
struct Taps<'a> {
    at: [&'a [f32]; 2 * WEIGHTS.len()],
}

impl<'a> Taps<'a> {
    fn new(values: &'a [f32]) -> Self {
        let length = values.len() - REACH;
        Self {
            at: std::array::from_fn(|first| &values[first..][..length]),
        }
    }

    /// The weighted sum of the six neighbours.
    fn around(&self, j: usize) -> f32 {
        WEIGHTS[0] * (self.at[2][j] + self.at[3][j])
            + WEIGHTS[1] * (self.at[1][j] + self.at[4][j])
            + WEIGHTS[2] * (self.at[0][j] + self.at[5][j])
    }
}

impl LastLevel {
    fn take(&mut self, samples: &[f32]) {
        let length = samples.len();
        self.samples.copy_within(length.., 0);
        self.samples[2 * REACH..].copy_from_slice(samples);
    }

    fn square(&mut self) {
        let length = self.squares.len();
        let at = |first: usize| &self.samples[first..][..length];
        let (a, b, c) = ((at(4), at(6)), (at(2), at(8)), (at(0), at(10)));
        let middle = at(5);
        for (j, square) in self.squares.iter_mut().enumerate() {
            let around = WEIGHTS[0] * (a.0[j] + a.1[j])
                + WEIGHTS[1] * (b.0[j] + b.1[j])
                + WEIGHTS[2] * (c.0[j] + c.1[j]);
            let high = MIDDLE * middle[j] - around;
            *square = high * high;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    const FRAME: usize = 1536;

    /// Mean square in each level of a tone of mean square 1 at this share of the sample rate.
    fn response(frequency: f64) -> [f32; 4] {
        let mut octaves = Octaves::new(3, FRAME);
        let tone: Vec<f32> = (0..2 * FRAME)
            .map(|n| ((2.0 * PI * frequency * n as f64).sin() * 2f64.sqrt()) as f32)
            .collect();
        octaves.push(&tone[..FRAME]);
        octaves.push(&tone[FRAME..]);
        std::array::from_fn(|level| {
            let mut energy = [0.0];
            octaves.add_energies(level, &mut energy);
            energy[0]
        })
    }

    #[test]
    fn a_tone_in_an_octave_keeps_its_power_there_and_loses_it_elsewhere() {
        for level in 0..4 {
            let middle = 0.375 * 0.5_f64.powi(level);
            let there = response(middle)[level as usize];
            assert!((0.6..1.1).contains(&there), "{level}: {there}");
            // An octave lower -15 dB are left, two octaves lower -45 dB (the polynomial of the
            // filter at these frequencies).
            let below = [middle / 2.0, middle / 4.0].map(|f| response(f)[level as usize]);
            assert!(below[0] < 0.035 && below[1] < 4e-5, "{level}: {below:?}");
        }
    }

    #[test]
    fn a_click_is_at_the_same_moment_in_all_levels() {
        let mut octaves = Octaves::new(3, FRAME);
        let mut click = vec![0.0; FRAME];
        click[800] = 1.0;
        octaves.push(&click);
        for level in 0..4 {
            let mut energies = [0.0; FRAME / 8];
            octaves.add_energies(level, &mut energies);
            let moment: f32 = energies
                .iter()
                .zip(0_u8..)
                .map(|(e, n)| e * f32::from(n))
                .sum();
            let middle = 8.0 * (moment / energies.iter().sum::<f32>() + 0.5);
            let expected = 800.5 + octaves.delay() as f32;
            assert!(
                (middle - expected).abs() < 5.0,
                "{level}: {middle} {expected}"
            );
        }
    }

    #[test]
    fn white_share_is_the_power_of_the_filter() {
        let neighbours: f32 = WEIGHTS.iter().map(|w| 2.0 * w * w).sum();
        assert!((f64::from(MIDDLE * MIDDLE + neighbours) - WHITE_SHARE).abs() < 1e-3);
    }
}
