//! Bytes as sound: short ones, and hours of it.
//!
//! Of a short one, the first byte chooses the kind of sound, the second the sample rate, the third the number of
//! channels, the fourth the size of the blocks; the rest is the sound.

use bouncelab::detection::{Detection, Detector};
use bouncelab::train::Train;

/// Enough of one sound, in samples.
const ENOUGH: usize = 1 << 16;
/// Usual rates, and what a broken header may claim.
const RATES_HZ: [u32; 12] = [
    44_100, 48_000, 8_000, 16_000, 22_050, 96_000, 192_000, 4_000, 1_000, 1, 1_000_000, 10_000_000,
];

/// Searches the bytes for drops at once and in blocks, and compares.
pub(super) fn detect(bytes: &[u8]) {
    let Some((&[kind, rate, channels, block], sound)) = bytes.split_first_chunk() else {
        return;
    };
    let rate_hz = RATES_HZ[usize::from(rate) % RATES_HZ.len()];
    let samples = match kind % 3 {
        0 => floats(sound),
        1 => integers(sound),
        _ => clicks(sound, rate_hz),
    };
    // The second channel, if any, differs from some place on.
    let mut other = samples.clone();
    if channels & 2 != 0 {
        let half = other.len() / 2;
        other[half..].iter_mut().for_each(|sample| *sample *= 0.5);
    }
    let channels = 1 + usize::from(channels & 1);
    let whole = detections(&samples, &other, rate_hz, channels, usize::MAX);
    // Never more blocks than a machine of today can take in a moment.
    let block = (1 + usize::from(block) * 7).max(samples.len() / 300);
    let parts = detections(&samples, &other, rate_hz, channels, block);
    check(&whole);
    assert_eq!(times(&whole), times(&parts), "the blocks make a difference");
    assert_eq!(whole.onsets, parts.onsets);
}

/// Enough of a long sound, in samples: 70 minutes at 1 kHz.
const ENOUGH_LONG: usize = 1 << 22;

/// Searches hours of sound, of which the bytes are the pieces, in blocks of a second and of another length. The
/// first byte chooses the sample rate, the second the length; each four that follow are a piece, and all pieces come
/// again until it is long enough.
pub(super) fn detect_long(bytes: &[u8]) {
    let Some((&[rate, block], pieces)) = bytes.split_first_chunk() else {
        return;
    };
    let (pieces, _) = pieces.as_chunks();
    if pieces.is_empty() {
        return;
    }
    let rate_hz = [1_000, 2_000, 4_000, 8_000][usize::from(rate) % 4];
    let block = 100 + usize::from(block) * 20;
    let mut whole = Detector::new(rate_hz, 1);
    let mut parts = Detector::new(rate_hz, 1);
    let seconds = pieces
        .iter()
        .cycle()
        .flat_map(|piece| Piece::of(*piece).seconds(rate_hz));
    let most = ENOUGH_LONG / rate_hz as usize;
    for (number, second) in seconds.take(most).enumerate() {
        whole.push(&[&second]);
        second.chunks(block).for_each(|part| parts.push(&[part]));
        if number == most / 2 {
            check(&whole.so_far());
        }
    }
    let (whole, parts) = (whole.finish(), parts.finish());
    check(&whole);
    assert_eq!(times(&whole), times(&parts), "the blocks make a difference");
}

/// Impacts that repeat after a period, in noise.
struct Piece {
    impacts_s: Vec<f64>,
    period_s: f64,
    level: f64,
    noise: f64,
    seconds: usize,
}

impl Piece {
    fn of([kind, level, rate, length]: [u8; 4]) -> Self {
        let (impacts_s, period_s) = match kind % 3 {
            0 => (Vec::new(), 1.0),
            // From 0.1 to 1,000 a second.
            1 => (vec![0.0], 10_f64.powf(1.0 - f64::from(rate) / 63.75)),
            _ => {
                let drop = crate::impact_events(2.4, 0.5 + f64::from(rate) / 520.0);
                let times = drop.take(40).map(|event| event.time_s);
                (times.take_while(|&time_s| time_s < 18.0).collect(), 20.0)
            }
        };
        Self {
            impacts_s,
            period_s,
            level: f64::from(level) / 256.0,
            noise: 10_f64.powi(-i32::from(kind / 3 % 8)),
            seconds: 1 + usize::from(length) * usize::from(length) / 16,
        }
    }

    fn seconds(self, rate_hz: u32) -> impl Iterator<Item = Vec<f32>> {
        let rate = rate_hz as usize;
        let mut noise = Noise(1);
        (0..self.seconds).map(move |second| {
            let samples = second * rate..(second + 1) * rate;
            samples
                .map(|n| self.sample(n as f64 / f64::from(rate_hz), noise.next()))
                .collect()
        })
    }

    fn sample(&self, time_s: f64, noise: f64) -> f32 {
        let phase_s = time_s % self.period_s;
        let before = self
            .impacts_s
            .partition_point(|&impact_s| impact_s <= phase_s);
        let impact_s = before.checked_sub(1).map(|last| self.impacts_s[last]);
        let click = impact_s.map_or(0.0, |impact_s| ring(phase_s - impact_s));
        (self.level * (click + self.noise * noise)) as f32
    }
}

/// The sound of an impact after a time.
fn ring(time_s: f64) -> f64 {
    (-time_s / 0.003).exp() * (20_000.0 * time_s).sin()
}

/// Noise between -0.5 and 0.5.
struct Noise(u32);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(self.0 >> 8) / f64::from(1 << 24) - 0.5
    }
}

fn detections(a: &[f32], b: &[f32], rate_hz: u32, channels: usize, block: usize) -> Detection {
    let mut listener = Detector::new(rate_hz, channels);
    let block = block.min(a.len()).max(1);
    for (number, (a, b)) in a.chunks(block).zip(b.chunks(block)).enumerate() {
        listener.push(&[a, b][..channels]);
        if number == 3 {
            check(&listener.so_far());
        }
    }
    listener.finish()
}

fn check(detection: &Detection) {
    for train in &detection.found.trains {
        let impacts = train.impacts();
        assert!(
            impacts
                .windows(2)
                .all(|pair| pair[0].number < pair[1].number)
        );
        for impact in impacts {
            assert!(impact.onset.time_s.is_finite() && impact.onset.sigma_s > 0.0);
            assert!((0.0..=1.0).contains(&impact.probability));
        }
    }
}

fn times(detection: &Detection) -> Vec<f64> {
    let impacts = detection.found.trains.iter().flat_map(Train::impacts);
    impacts.map(|impact| impact.onset.time_s).collect()
}

/// Any bits, also those of infinity and of what is not a number.
fn floats(bytes: &[u8]) -> Vec<f32> {
    let (words, _) = bytes.as_chunks();
    words.iter().map(|&word| f32::from_le_bytes(word)).collect()
}

/// Samples of eight bits.
fn integers(bytes: &[u8]) -> Vec<f32> {
    bytes
        .iter()
        .map(|&byte| (f32::from(byte) - 128.0) / 128.0)
        .collect()
}

/// Clicks in faint noise: two bytes for the time from one to the next, one for how loud it is.
fn clicks(bytes: &[u8], rate_hz: u32) -> Vec<f32> {
    let rate = f64::from(rate_hz);
    let (clicks, _) = bytes.as_chunks();
    let mut noise = Noise(1);
    let mut samples = Vec::new();
    let mut loud = 0.0;
    for &[low, high, level] in clicks {
        let gap_s = f64::from(u16::from_le_bytes([low, high])) / 16_384.0;
        for n in 0..(gap_s * rate) as usize {
            if samples.len() >= ENOUGH {
                return samples;
            }
            let click = loud * ring(n as f64 / rate);
            samples.push((click + 1e-3 * noise.next()) as f32);
        }
        loud = f64::from(level) / 256.0;
    }
    samples
}
