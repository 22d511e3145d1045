//! Bytes as sound.
//!
//! The first byte chooses the kind of sound, the second the sample rate, the third the number of
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
///
/// # Panics
///
/// If the blocks make a difference, or if impacts are not in order.
pub fn detect(bytes: &[u8]) {
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
    let mut state = 1_u32;
    let mut samples = Vec::new();
    let mut loud = 0.0;
    for &[low, high, level] in clicks {
        let gap_s = f64::from(u16::from_le_bytes([low, high])) / 16_384.0;
        for n in 0..(gap_s * rate) as usize {
            if samples.len() >= ENOUGH {
                return samples;
            }
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let noise = f64::from(state >> 8) / f64::from(1 << 24) - 0.5;
            let time_s = n as f64 / rate;
            let click = loud * (-time_s / 0.003).exp() * (20_000.0 * time_s).sin();
            samples.push((click + 1e-3 * noise) as f32);
        }
        loud = f64::from(level) / 256.0;
    }
    samples
}
