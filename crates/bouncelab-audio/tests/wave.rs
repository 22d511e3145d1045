//! WAV files of long recordings (RF64, BW64, W64), and of recorders that were stopped hard.

use bouncelab_audio::{SampleFormat, SoundReader, Warning, encode_wav};
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
    let mut source = SoundReader::from_bytes(bytes, "long.wav").unwrap();
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
            if let Ok(mut source) = SoundReader::from_bytes(bytes, "long.wav") {
                while let Ok(Some(_)) = source.next_block() {}
            }
        }
    }
}

/// A WAV with these sizes of the whole and of its sound.
fn sized(whole: u32, sound: u32) -> Vec<u8> {
    let mut bytes = wav();
    bytes[4..8].copy_from_slice(&whole.to_le_bytes());
    bytes[40..44].copy_from_slice(&sound.to_le_bytes());
    bytes
}

#[test]
fn sizes_that_contradict_each_other_lose_no_sound() {
    for whole in [0, 4, 6_000, 6_035] {
        assert_eq!(read(sized(whole, 6_000)), (ramp(), Vec::new()), "{whole}");
    }
    for whole in [0, 6_036, 9_000] {
        let (samples, warnings) = read(sized(whole, 9_100));
        assert_eq!(samples, ramp(), "{whole}");
        assert!(!warnings.is_empty(), "{whole}");
    }
}

/// As of a recorder that was stopped since it last wrote the sizes, and of two recordings joined.
#[test]
fn sound_behind_what_the_header_counts_is_mentioned() {
    let whole = encode_wav(RATE_HZ, SampleFormat::Int16, &[&vec![-0.5; 24_000]]).unwrap();
    let mut stale = whole.clone();
    stale[4..8].copy_from_slice(&(36 + 6_000_u32).to_le_bytes());
    stale[40..44].copy_from_slice(&6_000_u32.to_le_bytes());
    let joined = [wav(), whole[36..].to_vec()].concat();
    let whole_joined = [wav(), whole].concat();
    for bytes in [stale, joined, whole_joined] {
        let (samples, warnings) = read(bytes);
        assert_eq!(samples.len(), 3_000);
        let unfinished = Warning::Truncated {
            read_s: 3_000.0 / f64::from(RATE_HZ),
            expected_s: None,
        };
        assert_eq!(warnings, [unfinished]);
    }
    // A tag behind the sound is no sound.
    let tagged = [wav(), b"id3 \x00\x50\x00\x00".to_vec(), vec![0; 0x5000]].concat();
    assert_eq!(read(tagged), (ramp(), Vec::new()));
}
