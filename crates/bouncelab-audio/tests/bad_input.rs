//! Errors of files state what to do, and the readable part of damaged files is read.

mod clicks;

use std::fs;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::PathBuf;
#[cfg(unix)]
use std::process::Command;

use bouncelab_audio::{Error, Input, SampleFormat, SoundReader, Warning, encode_wav};

fn fixture(name: &str) -> Vec<u8> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    fs::read(folder.join(name)).unwrap()
}

fn refusal(bytes: impl Into<Vec<u8>>, name: &str) -> Error {
    SoundReader::from_bytes(bytes.into(), name).expect_err(name)
}

/// Seconds that can be read, and the warnings.
fn salvage(bytes: Vec<u8>, name: &str) -> (f64, Vec<Warning>) {
    let mut source = SoundReader::from_bytes(bytes, name).unwrap();
    let mut frames = 0;
    while let Some(block) = source.next_block().unwrap() {
        frames += block.frames();
    }
    (
        frames as f64 / f64::from(source.sample_rate_hz()),
        source.warnings().to_vec(),
    )
}

#[test]
fn a_missing_file_and_a_folder_are_distinguished() {
    let missing = Input::open("no/such/file.wav").err().unwrap();
    assert!(matches!(missing, Error::NotFound { .. }));
    assert!(
        missing
            .to_string()
            .starts_with("no/such/file.wav: no such file")
    );
    let folder = Input::open(env!("CARGO_MANIFEST_DIR")).err().unwrap();
    assert!(matches!(folder, Error::Directory { .. }));
}

/// A pipe as far as programs can tell.
struct Pipe;

impl Read for Pipe {
    fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
        Ok(0)
    }
}

impl Seek for Pipe {
    fn seek(&mut self, _: SeekFrom) -> io::Result<u64> {
        Err(io::ErrorKind::NotSeekable.into())
    }
}

#[test]
fn the_refusal_of_a_pipe_states_what_to_do() {
    let refusal = SoundReader::from_reader(Pipe, "/dev/stdin").unwrap_err();
    let message = refusal.to_string();
    assert!(message.contains("save it as a file first"), "{message}");
}

#[test]
fn empty_files_and_files_without_samples_are_called_empty() {
    assert!(matches!(refusal([], "a.wav"), Error::Empty { .. }));
    let header = encode_wav(44_100, SampleFormat::Int16, &[&[]]).unwrap();
    assert!(matches!(refusal(header, "b.wav"), Error::Empty { .. }));
}

#[test]
fn one_sample_is_a_recording() {
    let wav = encode_wav(44_100, SampleFormat::Int16, &[&[0.5]]).unwrap();
    let (seconds, warnings) = salvage(wav, "one.wav");
    assert!((seconds - 1.0 / 44_100.0).abs() < 1e-12);
    assert_eq!(warnings, []);
}

#[test]
fn content_that_is_not_sound_is_named() {
    for (content, what) in [
        (&b"time_s\n0.1\n0.4\n"[..], "text"),
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "a PNG picture"),
        (b"PK\x03\x04 and so on", "ZIP"),
        (&[0; 600], "nothing but zeros"),
        (b"\x01\x02\x03\x04\x05", "unknown kind"),
    ] {
        let error = refusal(content, "renamed.wav");
        assert!(matches!(error, Error::NotSound { .. }), "{error:?}");
        assert!(error.to_string().contains(what), "{error}");
    }
}

#[test]
fn pictures_without_sound_are_refused_as_such() {
    let error = refusal(fixture("silent.mp4"), "silent.mp4");
    assert!(
        matches!(error, Error::NoAudioTrack { format: "MP4", .. }),
        "{error:?}"
    );
}

#[test]
fn a_codec_that_cannot_be_decoded_is_named_with_a_way_out() {
    let error = refusal(fixture("adpcm.wav"), "phone.wav");
    assert!(matches!(&error, Error::UnsupportedCodec { codec, .. } if codec == "ADPCM"));
    assert!(error.to_string().contains("ffmpeg -i"), "{error}");
}

#[test]
fn rates_too_low_for_timing_are_refused() {
    let sound = [0.0; 100];
    let wav = encode_wav(3_999, SampleFormat::Int16, &[&sound]).unwrap();
    let error = refusal(wav, "slow.wav");
    assert!(matches!(error, Error::UnsupportedLayout { .. }));
    assert!(error.to_string().contains("at least 4000"), "{error}");
}

#[test]
fn rates_that_no_recorder_has_are_refused() {
    let wav = encode_wav(u32::MAX, SampleFormat::Int16, &[&[0.0; 100]]).unwrap();
    let error = refusal(wav, "lie.wav");
    assert!(
        matches!(error, Error::UnsupportedLayout { .. }),
        "{error:?}"
    );
}

#[test]
fn too_many_channels_are_refused() {
    let channels = vec![&[0.0; 10][..]; 65];
    let wav = encode_wav(8_000, SampleFormat::Int16, &channels).unwrap();
    let error = refusal(wav, "array.wav");
    assert!(error.to_string().contains("channel count"), "{error}");
}

#[test]
fn of_a_truncated_file_the_beginning_is_read_with_a_warning() {
    for name in [
        "pcm8.wav",
        "pcm16.wav",
        "pcm24.wav",
        "float32.wav",
        "pcm16.aiff",
        "lossless.flac",
        "lame-tag.mp3",
        "opus.webm",
    ] {
        let mut bytes = fixture(name);
        bytes.truncate(bytes.len() * 7 / 10);
        let (seconds, warnings) = salvage(bytes, name);
        assert!((0.05..0.55).contains(&seconds), "{name}: {seconds} s");
        let [
            Warning::Truncated {
                read_s,
                expected_s: Some(expected_s),
            },
        ] = warnings[..]
        else {
            panic!("{name}: {warnings:?}");
        };
        assert!((read_s - seconds).abs() < 1e-9, "{name}");
        assert!((expected_s - 0.6).abs() < 0.01, "{name}");
    }
}

#[test]
fn a_movie_without_its_table_of_contents_is_called_damaged() {
    // Its last box is the table of contents.
    let mut bytes = fixture("aac.m4a");
    bytes.truncate(bytes.len() / 2);
    let error = refusal(bytes, "cut.m4a");
    assert!(
        matches!(error, Error::Malformed { format: "M4A", .. }),
        "{error:?}"
    );
}

#[test]
fn damage_in_the_middle_leaves_the_times_behind_it() {
    // 27648 frames of MP3 in packets of about 208 bytes; three of them are wiped out.
    let intact = salvage(fixture("lame-tag.mp3"), "intact.mp3").0;
    let mut bytes = fixture("lame-tag.mp3");
    let middle = bytes.len() / 2;
    for byte in &mut bytes[middle + 8..middle + 200] {
        *byte ^= 0x55;
    }
    let (seconds, _) = salvage(bytes, "hit.mp3");
    assert!((seconds - intact).abs() < 0.03, "{seconds} s of {intact} s");
}

/// Opening a pipe would wait until another program writes into it.
#[cfg(unix)]
#[test]
fn a_pipe_is_refused_before_anybody_writes() {
    let pipe = std::env::temp_dir().join(format!("bouncelab-pipe-{}.wav", std::process::id()));
    let made = Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    let refused = SoundReader::open(&pipe).map(drop).unwrap_err();
    fs::remove_file(&pipe).unwrap();
    assert!(matches!(refused, Error::Pipe { .. }), "{refused}");
    let refused = SoundReader::open("/dev/zero").map(drop).unwrap_err();
    assert!(matches!(refused, Error::Pipe { .. }), "{refused}");
}

/// A WAV as a recorder leaves it that was stopped before it could write the sizes.
fn unfinished(riff_size: u32) -> Vec<u8> {
    let mut wav = fixture("pcm16.wav");
    let data = wav.windows(4).position(|word| word == b"data").unwrap();
    wav[4..8].copy_from_slice(&riff_size.to_le_bytes());
    wav[data + 4..data + 8].fill(0);
    wav
}

#[test]
fn a_wav_that_was_never_finished_is_read_to_its_end() {
    let (whole_s, _) = salvage(fixture("pcm16.wav"), "pcm16.wav");
    for riff_size in [0, 36] {
        let (read_s, _) = salvage(unfinished(riff_size), "unfinished.wav");
        assert!((read_s - whole_s).abs() < 1e-9, "{riff_size}: {read_s} s");
    }
    // With nothing after its header it is empty.
    let mut empty = unfinished(0);
    let data = empty.windows(4).position(|word| word == b"data").unwrap();
    empty.truncate(data + 8);
    refusal(empty, "empty.wav");
}

/// One flipped bit in the rate makes every time wrong by the same factor; only the bytes a second tell.
#[test]
fn a_wav_whose_rate_contradicts_its_bytes_a_second_is_doubted() {
    let mut wav = fixture("pcm16.wav");
    let (_, before) = salvage(wav.clone(), "pcm16.wav");
    assert!(before.is_empty(), "{before:?}");
    let format = wav.windows(4).position(|word| word == b"fmt ").unwrap();
    wav[format + 8 + 5] ^= 0x08;
    let (_, after) = salvage(wav, "flipped.wav");
    let doubted = |warning: &Warning| matches!(warning, Warning::RateInDoubt { .. });
    assert!(after.iter().any(doubted), "{after:?}");
}
