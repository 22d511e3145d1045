//! A known drop in every format, and the ways in which files of recordings are damaged.

mod judge;
mod kinds;

use std::io::Read;
use std::path::PathBuf;

use bouncelab::Options;
use bouncelab::synth::{Noise, Rendered, Scene, render};
use bouncelab_audio::{SampleFormat, encode_wav};
use flate2::read::GzDecoder;

use crate::containers::{aiff, caf, rf64, w64};

pub use judge::{Verdict, analyse, is_warned, judge, words};
pub use kinds::Damage;

/// The drop of the files: a table-tennis ball from 0.35 m, with restitution 0.86 that scatters by half a
/// percent, over soft noise.
///
/// # Panics
///
/// Never: the scene can be rendered.
pub fn drop(sample_rate_hz: u32) -> Rendered {
    let options = Options::default();
    let model = options.model().expect("an ordinary ball in ordinary air");
    let mut number = 0.0;
    let restitution = |_| {
        number += 1.0;
        // Without order from one impact to the next.
        0.86 * (1.0 + 0.007 * f64::sin(2.4 * number * number))
    };
    let events = crate::bouncing(model, options.contact_time_s, 2.6, restitution);
    let events: Vec<_> = events.take(16).collect();
    let scene = Scene {
        sample_rate_hz,
        lead_in_s: 0.7,
        noise: Some(Noise::white(40.0)),
        ..Scene::default()
    };
    render(&events, &scene, 11).expect("a scene that can be rendered")
}

/// The drop in every format: names and files. Compressed ones are in an archive that
/// `damage/make.sh` writes; those without compression are made here.
///
/// # Panics
///
/// If the archive is not there.
pub fn files() -> Vec<(String, Vec<u8>)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("damage/drops.tar.gz");
    let archive = std::fs::File::open(folder).expect("the archive of drops");
    let mut archive = tar::Archive::new(GzDecoder::new(archive));
    let mut files: Vec<(String, Vec<u8>)> = uncompressed();
    for entry in archive.entries().expect("an archive") {
        let mut entry = entry.expect("an entry");
        let name = entry.path().expect("a name").to_string_lossy().into_owned();
        let mut file = Vec::new();
        entry.read_to_end(&mut file).expect("its content");
        files.push((name, file));
    }
    files
}

fn uncompressed() -> Vec<(String, Vec<u8>)> {
    let encode = |drop: &Rendered, format| {
        encode_wav(drop.sample_rate_hz, format, &[&drop.samples]).expect("a sound of seconds")
    };
    let drop_16 = drop(16_000);
    let wav = |format| encode(&drop_16, format);
    let wav_16 = wav(SampleFormat::Int16);
    let bytes = 2 * drop_16.samples.len() as u64;
    // Other rates are unusual in these formats, and named.
    let usual = drop(48_000);
    let wav_usual = encode(&usual, SampleFormat::Int16);
    let files = [
        ("rf64.wav", rf64(*b"RF64", &wav_16, bytes, b"")),
        ("bw64.wav", rf64(*b"BW64", &wav_16, bytes, b"")),
        ("wave64.w64", w64(&wav_16, 24 + bytes, b"")),
        ("pcm.caf", caf(&wav_usual, usual.sample_rate_hz)),
        ("sound.aiff", aiff(&wav_usual, usual.sample_rate_hz)),
        ("wav-24.wav", wav(SampleFormat::Int24)),
        ("wav-float.wav", wav(SampleFormat::Float32)),
        ("wav-16.wav", wav_16),
    ];
    files.map(|(name, file)| (name.to_owned(), file)).into()
}
