//! No content makes the crate panic, loop for ever or ask for memory without end.
//!
//! The allocator of this test binary fails, and so ends the test, at a quarter of a gigabyte.

mod clicks;

use std::alloc::System;
use std::fs;
use std::path::PathBuf;

use bouncelab_audio::{SampleFormat, SoundReader, encode_wav, times};
use cap::Cap;

const MEMORY_LIMIT: usize = 256 << 20;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, MEMORY_LIMIT);

/// Longer than any fixture by far, and still soon reached.
const MAX_SECONDS: f64 = 60.0;

fn fixtures() -> Vec<(String, Vec<u8>)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    let mut fixtures: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|entry| {
            (
                entry.file_name().into_string().unwrap(),
                fs::read(entry.path()).unwrap(),
            )
        })
        .collect();
    fixtures.sort();
    fixtures
}

/// Reads all there is; the samples must be numbers, and few.
fn exhaust(bytes: Vec<u8>, what: &str) {
    let Ok(mut source) = SoundReader::from_bytes(bytes, what) else {
        return;
    };
    let limit = (MAX_SECONDS * f64::from(source.sample_rate_hz())) as u64;
    while let Ok(Some(block)) = source.next_block() {
        for channel in 0..block.channels() {
            assert!(
                block
                    .channel(channel)
                    .iter()
                    .all(|sample| sample.is_finite()),
                "{what}"
            );
        }
        assert!(
            block.start_frame() < limit,
            "{what}: more than {MAX_SECONDS} s"
        );
    }
}

/// Numbers without order, the same in every run (Knuth's MMIX generator).
struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit
    }
}

#[test]
fn truncated_files_do_not_panic() {
    for (name, bytes) in fixtures() {
        for part in 0..24 {
            let len = bytes.len() * part / 24;
            exhaust(bytes[..len].to_vec(), &format!("{name} cut to {len} bytes"));
        }
        // Headers break at every byte.
        for len in 0..bytes.len().min(64) {
            exhaust(bytes[..len].to_vec(), &format!("{name} cut to {len} bytes"));
        }
    }
}

#[test]
fn changed_bytes_do_not_panic() {
    let rounds = std::env::var("BOUNCELAB_FUZZ_ROUNDS")
        .ok()
        .and_then(|text| text.parse().ok());
    for (name, bytes) in fixtures() {
        let mut dice = Dice(bytes.len() as u64);
        for round in 0..rounds.unwrap_or(40) {
            let mut changed = bytes.clone();
            // Half of the hits go where the headers are.
            for hit in 0..=dice.below(8) {
                let reach = if hit % 2 == 0 {
                    bytes.len().min(1_000)
                } else {
                    bytes.len()
                };
                let value = [0x00, 0xff, 0x7f, 0x80, dice.below(256) as u8][dice.below(5)];
                changed[dice.below(reach)] = value;
            }
            exhaust(changed, &format!("{name} round {round}"));
        }
    }
}

#[test]
fn changed_bytes_in_lists_of_times_do_not_panic() {
    let mut dice = Dice(7);
    for (name, text) in [
        ("a.txt", "# times\n0.1\n0.45\n0.72\n"),
        ("a.csv", "n;time_s\n1;0,10\n2;0,45\n"),
        ("a.json", "[0.1, 0.45, 0.72]"),
    ] {
        for _ in 0..500 {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..=dice.below(3) {
                let place = dice.below(bytes.len());
                bytes[place] = dice.below(256) as u8;
            }
            if let Ok(list) = times::parse(&bytes, name) {
                let times_s = list.times_s;
                assert!(times_s.is_sorted() && times_s.iter().all(|time_s| time_s.is_finite()));
            }
        }
    }
}

#[test]
fn memory_does_not_grow_with_the_length() {
    // Five minutes of stereo: the samples alone would take 106 MB as f32.
    let second = clicks::signal(44_100);
    let sound = second.repeat(500);
    let wav = encode_wav(44_100, SampleFormat::Int16, &[&sound, &sound]).unwrap();
    drop((second, sound));
    let before = ALLOCATOR.allocated();
    let mut source = SoundReader::from_bytes(wav, "long.wav").unwrap();
    let mut most = 0;
    while source.next_block().unwrap().is_some() {
        most = most.max(ALLOCATOR.allocated());
    }
    // Opening copies the bytes into shared memory once; other tests run concurrently.
    let grown = most.saturating_sub(before);
    assert!(grown < 16 << 20, "{grown} bytes");
}
