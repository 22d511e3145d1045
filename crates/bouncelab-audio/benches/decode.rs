//! How fast recordings decode. The unit is samples: 44.1 Msample/s is 1,000 times real time for
//! one channel at 44.1 kHz.
//!
//! The fixtures are short, so opening is part of what is measured, as it is for users.

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use bouncelab_audio::{SampleFormat, SoundReader, encode_wav};
use divan::Bencher;
use divan::counter::ItemsCount;

fn main() {
    divan::main();
}

fn fixture(name: &str) -> Arc<[u8]> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    fs::read(folder.join(name))
        .expect("fixtures are part of the project")
        .into()
}

fn count_samples(bytes: &Arc<[u8]>) -> usize {
    let mut source =
        SoundReader::from_bytes(Arc::clone(bytes), "bench").expect("fixtures are sound");
    let mut samples = 0;
    while let Some(block) = source.next_block().expect("memory can be read") {
        samples += block.frames() * block.channels();
    }
    samples
}

#[divan::bench(args = ["lossless.flac", "lame-tag.mp3", "aac.m4a", "vorbis.ogg", "opus.webm"])]
fn fixture_of_600_ms(bencher: Bencher, name: &str) {
    let bytes = fixture(name);
    let samples = count_samples(&bytes);
    bencher
        .counter(ItemsCount::new(samples))
        .bench_local(|| count_samples(&bytes));
}

#[divan::bench]
fn wav_16_bit_of_10_s(bencher: Bencher) {
    let silence = vec![0.0; 441_000];
    let bytes: Arc<[u8]> = encode_wav(44_100, SampleFormat::Int16, &[&silence])
        .expect("silence fits")
        .into();
    let samples = count_samples(&bytes);
    bencher
        .counter(ItemsCount::new(samples))
        .bench_local(|| count_samples(&bytes));
}
