//! What is written can be read back, and nothing half-written is left behind.

use std::fs;
use std::path::PathBuf;

use bouncelab_audio::{Error, Recorder, SampleFormat, Source, encode_wav, write_wav};

/// A folder of its own for each test, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let name = format!("bouncelab-wav-{test}-{}", std::process::id());
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn is_empty(&self) -> bool {
        fs::read_dir(&self.0).unwrap().next().is_none()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn read(mut source: Source) -> Vec<Vec<f32>> {
    let mut channels = vec![Vec::new(); source.channels()];
    while let Some(block) = source.next_block().unwrap() {
        for (number, samples) in channels.iter_mut().enumerate() {
            samples.extend_from_slice(block.channel(number));
        }
    }
    channels
}

#[test]
fn every_format_returns_what_was_written_to_half_a_step() {
    let folder = Folder::new("formats");
    // An odd number of samples: 8-bit files need padding.
    let left: Vec<f32> = (0..10_001_u16)
        .map(|i| (f32::from(i) * 0.01).sin() * 0.9)
        .collect();
    let right: Vec<f32> = left.iter().map(|sample| -0.5 * sample).collect();
    for (format, name, half_step) in [
        (SampleFormat::Int8, "8-bit WAV", 1.0 / 256.0),
        (SampleFormat::Int16, "16-bit WAV", 1.0 / 65_536.0),
        (SampleFormat::Int24, "24-bit WAV", 1.0 / 16_777_216.0),
        (SampleFormat::Int32, "32-bit WAV", 1.0 / 4_294_967_296.0),
        (SampleFormat::Float32, "32-bit float WAV", 0.0),
    ] {
        let path = folder.0.join("sound.wav");
        write_wav(&path, 22_050, format, &[&left, &right]).unwrap();
        let source = Source::open(&path).unwrap();
        assert_eq!(source.format(), name);
        assert_eq!(source.sample_rate_hz(), 22_050);
        let channels = read(source);
        for (written, read) in [&left, &right].into_iter().zip(&channels) {
            assert_eq!(written.len(), read.len());
            let worst = written
                .iter()
                .zip(read)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f32::max);
            assert!(worst <= half_step, "{name}: {worst}");
        }
    }
}

#[test]
fn integers_clip_at_full_scale() {
    let wav = encode_wav(8_000, SampleFormat::Int16, &[&[2.0, -2.0, 1.0]]).unwrap();
    let channels = read(Source::from_bytes(wav, "loud.wav").unwrap());
    let most = 32_767.0 / 32_768.0;
    assert_eq!(channels, [[most, -1.0, most]]);
}

#[test]
fn sounds_that_no_file_can_hold_are_refused() {
    let format = SampleFormat::Float32;
    let folder = Folder::new("refused");
    let path = folder.0.join("sound.wav");
    for channels in [&[][..], &[&[0.0, 0.0][..], &[0.0]], &[&[0.0, f32::NAN]]] {
        let error = write_wav(&path, 44_100, format, channels).unwrap_err();
        assert!(matches!(error, Error::Unwritable { .. }), "{error:?}");
    }
    assert!(write_wav(&path, 0, format, &[&[0.0]]).is_err());
    assert!(folder.is_empty());
}

#[test]
fn a_failure_leaves_no_file() {
    let folder = Folder::new("failure");
    let nowhere = folder.0.join("no/such/folder/sound.wav");
    let error = write_wav(nowhere, 44_100, SampleFormat::Int16, &[&[0.0]]).unwrap_err();
    assert!(matches!(error, Error::NotFound { .. }), "{error:?}");
    let error = write_wav(&folder.0, 44_100, SampleFormat::Int16, &[&[0.0]]).unwrap_err();
    assert!(matches!(error, Error::Directory { .. }), "{error:?}");
    assert!(folder.is_empty());
}

#[test]
fn a_recording_never_overwrites_anything() {
    let folder = Folder::new("exists");
    let path = folder.0.join("precious.wav");
    fs::write(&path, "precious").unwrap();
    let refusal = Recorder::create(&path, 8_000, 1, SampleFormat::Int16).unwrap_err();
    assert!(matches!(refusal, Error::Exists { .. }), "{refusal}");
    assert_eq!(fs::read(&path).unwrap(), b"precious");
}

#[test]
fn an_unfinished_recording_can_be_read_up_to_its_last_second() {
    let folder = Folder::new("unfinished");
    let path = folder.0.join("going-on.wav");
    let mut recorder = Recorder::create(&path, 8_000, 2, SampleFormat::Float32).unwrap();
    let block = [0.25; 3_000];
    for _ in 0..10 {
        recorder.push(&[&block, &block]).unwrap();
    }
    // As if the program were killed: nothing of it runs any more.
    std::mem::forget(recorder);
    let planes = read(Source::open(&path).unwrap());
    assert_eq!(planes.len(), 2);
    assert!(planes[0].len() > 30_000 - 8_000);
}
