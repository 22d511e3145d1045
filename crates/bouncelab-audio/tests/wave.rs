//! WAV files of long recordings (RF64, BW64, W64), and of recorders that were stopped hard.

use bouncelab_audio::{SampleFormat, Source, Warning, encode_wav};
use bouncelab_testkit::containers;

const RATE_HZ: u32 = 8_000;

fn ramp() -> Vec<f32> {
    (0..3_000).map(|n| n as f32 / 32_768.0).collect()
}

fn wav() -> Vec<u8> {
    encode_wav(RATE_HZ, SampleFormat::Int16, &[&ramp()]).unwrap()
}

fn rf64(marker: [u8; 4], announced: u64, tail: &[u8]) -> Vec<u8> {
    containers::rf64(marker, &wav(), announced, tail)
}

fn w64(announced: u64, tail: &[u8]) -> Vec<u8> {
    containers::w64(&wav(), announced, tail)
}

fn read(bytes: Vec<u8>) -> (Vec<f32>, Vec<Warning>) {
    let mut source = Source::from_bytes(bytes, "long.wav").unwrap();
    assert_eq!((source.sample_rate_hz(), source.channels()), (RATE_HZ, 1));
    let mut samples = Vec::new();
    while let Some(block) = source.next_block().unwrap() {
        samples.extend_from_slice(block.channel(0));
    }
    (samples, source.warnings().to_vec())
}

#[test]
fn long_recordings_are_read_up_to_their_end_and_no_farther() {
    let tail = b"LIST\x04\x00\x00\x00INFO";
    for bytes in [
        rf64(*b"RF64", 6_000, tail),
        rf64(*b"BW64", 6_000, tail),
        rf64(*b"RF64", 6_000, b""),
        w64(24 + 6_000, tail),
    ] {
        assert_eq!(read(bytes), (ramp(), Vec::new()));
    }
}

#[test]
fn without_a_size_all_that_follows_is_sound() {
    let mut crashed = wav();
    crashed[4..8].fill(0);
    crashed[40..44].fill(0);
    let unfinished = Warning::Truncated {
        read_s: 3_000.0 / f64::from(RATE_HZ),
        expected_s: None,
    };
    for bytes in [rf64(*b"RF64", 0, b""), w64(0, b""), w64(24, b""), crashed] {
        assert_eq!(read(bytes), (ramp(), vec![unfinished.clone()]));
    }
}

#[test]
fn a_size_beyond_the_file_is_a_shorter_recording_with_a_warning() {
    for bytes in [rf64(*b"RF64", 9_000, b""), w64(24 + 9_000, b"")] {
        let (samples, warnings) = read(bytes);
        assert_eq!(samples, ramp());
        assert!(!warnings.is_empty());
    }
}

#[test]
fn absurd_sizes_are_survived() {
    for size in [1, 23, u64::MAX / 2, u64::MAX - 7, u64::MAX] {
        for bytes in [rf64(*b"RF64", size, b""), w64(size, b"")] {
            // Whatever comes of it comes to an end.
            if let Ok(mut source) = Source::from_bytes(bytes, "long.wav") {
                while let Ok(Some(_)) = source.next_block() {}
            }
        }
    }
}
