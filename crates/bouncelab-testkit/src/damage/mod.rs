//! A known drop in every format, and the ways in which files of recordings are damaged.

mod judge;

use std::io::Read;
use std::path::PathBuf;

use bouncelab::Options;
use bouncelab::synth::{Noise, Rendered, Scene, render};
use bouncelab_audio::{SampleFormat, encode_wav};
use flate2::read::GzDecoder;

use crate::containers::{caf, rf64, w64};

pub use judge::{Verdict, analyse, is_warned, judge, words};

/// What happens to a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Damage {
    /// One bit of one byte is another.
    Bit,
    /// 300 bytes are zero.
    Zeros,
    /// 2,000 bytes are missing.
    Removed,
    /// All that follows is missing.
    Truncated,
}

impl Damage {
    /// Every way.
    pub const ALL: [Self; 4] = [Self::Bit, Self::Zeros, Self::Removed, Self::Truncated];

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Bit => "one bit",
            Self::Zeros => "300 zeros",
            Self::Removed => "2,000 bytes missing",
            Self::Truncated => "cut",
        }
    }

    /// The file after it, `percent` of its length from its beginning.
    pub fn at(self, percent: usize, file: &[u8]) -> Vec<u8> {
        let place = file.len() * percent / 100;
        let (front, back) = file.split_at(place);
        let mut damaged = front.to_vec();
        match self {
            Self::Bit => {
                damaged.extend_from_slice(back);
                damaged[place] ^= 1 << (percent % 8);
            }
            Self::Zeros => {
                let zeros = back.len().min(300);
                damaged.resize(place + zeros, 0);
                damaged.extend_from_slice(&back[zeros..]);
            }
            Self::Removed => damaged.extend_from_slice(&back[back.len().min(2_000)..]),
            Self::Truncated => {}
        }
        damaged
    }
}

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
    let strikes = crate::bouncing(model, options.contact_time_s, 2.6, restitution);
    let strikes: Vec<_> = strikes.take(16).collect();
    let scene = Scene {
        sample_rate_hz,
        lead_in_s: 0.7,
        noise: Some(Noise::white(40.0)),
        ..Scene::default()
    };
    render(&strikes, &scene, 11).expect("a scene that can be rendered")
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
    let drop = drop(16_000);
    let wav = |format| {
        encode_wav(drop.sample_rate_hz, format, &[&drop.samples]).expect("a sound of seconds")
    };
    let wav_16 = wav(SampleFormat::Int16);
    let bytes = 2 * drop.samples.len() as u64;
    let files = [
        ("rf64.wav", rf64(*b"RF64", &wav_16, bytes, b"")),
        ("bw64.wav", rf64(*b"BW64", &wav_16, bytes, b"")),
        ("wave64.w64", w64(&wav_16, 24 + bytes, b"")),
        ("pcm.caf", caf(&wav_16, drop.sample_rate_hz)),
        ("wav-24.wav", wav(SampleFormat::Int24)),
        ("wav-float.wav", wav(SampleFormat::Float32)),
        ("wav-16.wav", wav_16),
    ];
    files.map(|(name, file)| (name.to_owned(), file)).into()
}
