//! WAV files of long recordings (RF64, BW64, W64), and of recorders that were stopped hard. The layouts are
//! those of EBU Tech 3306, ITU-R BS.2088 and Sonic Foundry's description of Wave64.

use bouncelab_audio::{SampleFormat, Source, Warning, encode_wav};

const RATE_HZ: u32 = 8_000;

fn ramp() -> Vec<f32> {
    (0..3_000).map(|n| n as f32 / 32_768.0).collect()
}

/// The description of the sound in a WAV file, and its samples.
fn parts() -> (Vec<u8>, Vec<u8>) {
    let wav = encode_wav(RATE_HZ, SampleFormat::Int16, &[&ramp()]).unwrap();
    (wav[20..36].to_vec(), wav[44..].to_vec())
}

/// A chunk with another size than its own.
fn chunk(name: &[u8], size: u32, content: &[u8]) -> Vec<u8> {
    [name, &size.to_le_bytes(), content].concat()
}

/// RF64 and its like, with the size of the sound that is announced in 64 bits.
fn rf64(marker: &[u8], announced: u64, tail: &[u8]) -> Vec<u8> {
    let (format, sound) = parts();
    let sizes = [0, announced, 0].map(u64::to_le_bytes).concat();
    let sizes = [sizes, vec![0; 4]].concat();
    let chunks = [
        b"WAVE".to_vec(),
        chunk(b"ds64", 28, &sizes),
        chunk(b"fmt ", 16, &format),
        chunk(b"data", u32::MAX, &sound),
        tail.to_vec(),
    ];
    chunk(marker, u32::MAX, &chunks.concat())
}

fn w64(announced: u64, tail: &[u8]) -> Vec<u8> {
    let (format, sound) = parts();
    let rest = b"\xf3\xac\xd3\x11\x8c\xd1\x00\xc0\x4f\x8e\xdb\x8a";
    let chunk = |name: &[u8], size: u64, content: &[u8]| {
        [name, rest, &size.to_le_bytes(), content].concat()
    };
    let file = b"riff\x2e\x91\xcf\x11\xa5\xd6\x28\xdb\x04\xc1\x00\x00";
    [
        file.to_vec(),
        0_u64.to_le_bytes().to_vec(),
        [b"wave", &rest[..]].concat(),
        // Of odd length: what follows begins at the next multiple of eight.
        chunk(b"note", 24 + 3, &[1; 8]),
        chunk(b"fmt ", 24 + 16, &format),
        chunk(b"data", announced, &sound),
        tail.to_vec(),
    ]
    .concat()
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
        rf64(b"RF64", 6_000, tail),
        rf64(b"BW64", 6_000, tail),
        rf64(b"RF64", 6_000, b""),
        w64(24 + 6_000, tail),
    ] {
        assert_eq!(read(bytes), (ramp(), Vec::new()));
    }
}

#[test]
fn without_a_size_all_that_follows_is_sound() {
    for bytes in [rf64(b"RF64", 0, b""), w64(0, b""), w64(24, b"")] {
        assert_eq!(read(bytes).0, ramp());
    }
    let mut crashed = encode_wav(RATE_HZ, SampleFormat::Int16, &[&ramp()]).unwrap();
    crashed[4..8].fill(0);
    crashed[40..44].fill(0);
    assert_eq!(read(crashed).0, ramp());
}

#[test]
fn a_size_beyond_the_file_is_a_shorter_recording_with_a_warning() {
    for bytes in [rf64(b"RF64", 9_000, b""), w64(24 + 9_000, b"")] {
        let (samples, warnings) = read(bytes);
        assert_eq!(samples, ramp());
        assert!(!warnings.is_empty());
    }
}

#[test]
fn absurd_sizes_are_survived() {
    for size in [1, 23, u64::MAX / 2, u64::MAX - 7, u64::MAX] {
        for bytes in [rf64(b"RF64", size, b""), w64(size, b"")] {
            // Whatever comes of it comes to an end.
            if let Ok(mut source) = Source::from_bytes(bytes, "long.wav") {
                while let Ok(Some(_)) = source.next_block() {}
            }
        }
    }
}
