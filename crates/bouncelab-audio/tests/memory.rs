//! No recording, however it is made, takes more than a quarter of a gigabyte, from the file to its drops.
//!
//! The allocator of this test binary fails, and so ends the test, at that limit.

use std::alloc::System;
use std::io::{self, Read, Seek, SeekFrom};
use std::iter;

use bouncelab::analysis::{Plan, analyze_impacts, impacts_of_times};
use bouncelab::restitution::LawKind;
use bouncelab::{Detector, Options};
use bouncelab_audio::{Error, Input, SoundReader, TimesProblem};
use bouncelab_testkit::hostile;
use cap::Cap;

const MEMORY_LIMIT: usize = 256 << 20;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, MEMORY_LIMIT);

/// A file of this length that is made while it is read: a beginning, and then the same over and over.
struct Repeated {
    header: Vec<u8>,
    content: Vec<u8>,
    length: u64,
    at: u64,
}

impl Repeated {
    fn new(header: Vec<u8>, content: &[u8], length: u64) -> Self {
        Self {
            header,
            content: content.to_vec(),
            length,
            at: 0,
        }
    }

    /// A WAV of bursts of noise, different in all channels.
    fn noise(sample_rate_hz: u32, channels: u16, seconds: u32) -> Self {
        let frame = 2 * channels;
        let length = u64::from(seconds) * u64::from(sample_rate_hz) * u64::from(frame);
        let size = u32::try_from(length).unwrap();
        let mut header = b"RIFF".to_vec();
        header.extend((36 + size).to_le_bytes());
        header.extend(b"WAVEfmt \x10\0\0\0\x01\0");
        header.extend(channels.to_le_bytes());
        header.extend(sample_rate_hz.to_le_bytes());
        header.extend((sample_rate_hz * u32::from(frame)).to_le_bytes());
        header.extend(frame.to_le_bytes());
        header.extend(b"\x10\0data");
        header.extend(size.to_le_bytes());
        let mut dice = 1_u64;
        // A burst and quiet, over and over; a prime number, so that no channel has the samples of another.
        let samples = (0..499_979).map(|n| {
            dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let loud = (dice >> 48) as u16;
            if n < 8_000 { loud } else { loud % 64 }
        });
        let samples: Vec<u8> = samples.flat_map(u16::to_le_bytes).collect();
        let length = header.len() as u64 + length;
        Self::new(header, &samples, length)
    }
}

impl Read for Repeated {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let content = match self.header.get(self.at as usize..) {
            Some(rest) if !rest.is_empty() => rest,
            _ => &self.content[(self.at % self.content.len() as u64) as usize..],
        };
        let left = (self.length - self.at) as usize;
        let length = content.len().min(buffer.len()).min(left);
        buffer[..length].copy_from_slice(&content[..length]);
        self.at += length as u64;
        Ok(length)
    }
}

impl Seek for Repeated {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let at = match to {
            SeekFrom::Start(at) => i128::from(at),
            SeekFrom::Current(by) => i128::from(self.at) + i128::from(by),
            SeekFrom::End(by) => i128::from(self.length) + i128::from(by),
        };
        let at = u64::try_from(at).map_err(io::Error::other)?;
        self.at = at.min(self.length);
        Ok(self.at)
    }
}

fn plan(source: SoundReader) -> Result<Plan, Box<dyn std::error::Error>> {
    let input = Input::Sound(Box::new(source));
    input.plan(&Options::default(), |_| Ok(()))
}

/// All of it is remembered, because sounds that stand out follow each other without a break.
#[test]
fn sound_of_any_rate_and_number_of_channels_fits() {
    // Long enough to fill what is remembered.
    for (sample_rate_hz, channels, seconds) in [(48_000, 8, 100), (192_000, 2, 190)] {
        let noise = Repeated::noise(sample_rate_hz, channels, seconds);
        let source = SoundReader::from_reader(noise, "noise.wav").unwrap();
        assert_eq!(source.channels(), usize::from(channels));
        assert!(plan(source).is_ok());
    }
}

/// Steps of eight channels at 655 kHz for 20 s, in 8 kB: 420 MB of samples.
#[test]
fn a_small_file_that_claims_much_fits() {
    let flac = hostile::flac(655_350, 8, 0..200);
    assert!(flac.len() < 1 << 13);
    let source = SoundReader::from_bytes(flac, "small.flac").unwrap();
    assert_eq!((source.sample_rate_hz(), source.channels()), (655_350, 8));
    assert!(plan(source).is_ok());
}

#[test]
fn more_channels_than_fit_are_refused_by_name() {
    let source = SoundReader::from_reader(Repeated::noise(10_000_000, 16, 1), "many.wav").unwrap();
    let refused = plan(source).unwrap_err();
    let refused = refused.downcast_ref::<bouncelab::Error>();
    let expected = bouncelab::diagnostic::Code::TooManyChannels;
    assert_eq!(
        refused.map(|refused| refused.diagnostic().code),
        Some(expected)
    );
}

/// The result so far is evaluated repeatedly during a drop.
#[test]
fn listening_takes_no_second_memory() {
    let noise = Repeated::noise(96_000, 2, 180);
    let mut source = SoundReader::from_reader(noise, "noise.wav").unwrap();
    let mut detector = Detector::new(96_000, 2);
    while let Some(block) = source.next_block().unwrap() {
        detector.push(&[block.channel(0), block.channel(1)]);
    }
    let copies = [detector.clone(), detector.clone(), detector.clone()];
    assert!(copies.iter().all(|copy| copy.onsets() == detector.onsets()));
}

#[test]
fn no_recording_is_read_for_more_than_a_day() {
    // Frames of 16 s of silence at 4 kHz, 25 hours in 66 kB.
    let flac = hostile::flac(4_000, 1, 0..5_500);
    assert!(flac.len() < 1 << 17);
    assert_eq!(most_minutes(flac), 1_440);
}

/// Most of it is missing, and silence stands in its place, which is not decoded: two hours of eight channels.
#[test]
fn no_more_samples_are_read_than_a_day_of_a_recorder_has() {
    // Frames of 0.1 s, each 500 s behind the one before.
    let flac = hostile::flac(655_350, 8, (0..80_000).step_by(5_000));
    // 24 hours of two channels at 192 kHz.
    assert_eq!(most_minutes(flac), 105);
}

/// The maximum duration in minutes, by the refusal of a recording.
fn most_minutes(flac: Vec<u8>) -> u32 {
    let mut source = SoundReader::from_bytes(flac, "long.flac").unwrap();
    loop {
        match source.next_block() {
            Ok(block) => assert!(block.is_some(), "it has an end"),
            Err(Error::TooLong { max_h, .. }) => return (max_h * 60.0).round() as u32,
            Err(other) => panic!("{other}"),
        }
    }
}

/// As many numbers as fit into the most text that is read.
#[test]
fn lists_of_any_length_are_refused() {
    for (name, line) in [
        ("list.txt", "1\n"),
        ("list.csv", ",,,,,,,,"),
        ("list.json", "1,"),
        ("list.TextGrid", "0 "),
    ] {
        let text = Repeated::new(Vec::new(), line.repeat(1_000).as_bytes(), 1 << 26);
        let refused = Input::from_reader(text, name).err().unwrap();
        let problem = match refused {
            Error::Times { problem, .. } => problem,
            other => panic!("{other}"),
        };
        assert_eq!(problem, TimesProblem::TooLong { max_mb: 4 }, "{name}");
    }
}

/// Short rows, so that there are as many as fit.
#[test]
fn a_waveform_in_text_fits() {
    let rows = (0..6_000_000).map(|row| format!("{row}\t{}\n", row % 7));
    let text: String = iter::once("time (us)\tV\n".to_owned())
        .chain(rows)
        .collect();
    assert!(text.len() < 1 << 26 && text.len() > 1 << 25);
    let length = text.len() as u64;
    let input = Input::from_reader(Repeated::new(text.into_bytes(), b" ", length), "wave.txt");
    let Ok(Input::Sound(source)) = input else {
        panic!("{input:?}");
    };
    assert_eq!(source.sample_rate_hz(), 1_000_000);
    assert!(plan(*source).is_ok());
}

/// As many drops as are analysed of one recording, with the inference, its draws and all. One law makes as many draws as
/// all do, and sooner.
#[test]
fn a_thousand_inferred_drops_fit() {
    let times_s = [
        0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984,
    ];
    let mut options = Options::default();
    options.priors.restitution_laws = vec![LawKind::Constant];
    let drops = iter::repeat_with(|| analyze_impacts(impacts_of_times(&times_s), &options));
    let drops: Vec<_> = drops.take(1_000).collect();
    assert!(drops.iter().all(|drop| drop.posterior.is_ok()));
}
