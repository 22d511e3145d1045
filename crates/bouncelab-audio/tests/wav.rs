//! What is written can be read back, and nothing half-written is left behind.

use std::fs;
use std::io::Cursor;
use std::path::PathBuf;

use bouncelab_audio::{
    Cue, Error, Recorder, SampleFormat, SoundReader, copy_with_cues, encode_wav,
};

/// A folder of its own for each test, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let name = format!("bouncelab-wav-{test}-{}", std::process::id());
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn read(mut source: SoundReader) -> Vec<Vec<f32>> {
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
        let wav = encode_wav(22_050, format, &[&left, &right]).unwrap();
        let source = SoundReader::from_bytes(wav, "sound.wav").unwrap();
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
    let channels = read(SoundReader::from_bytes(wav, "loud.wav").unwrap());
    let most = 32_767.0 / 32_768.0;
    assert_eq!(channels, [[most, -1.0, most]]);
}

#[test]
fn sounds_that_no_file_can_hold_are_refused() {
    let format = SampleFormat::Float32;
    for channels in [&[][..], &[&[0.0, 0.0][..], &[0.0]], &[&[0.0, f32::NAN]]] {
        let error = encode_wav(44_100, format, channels).unwrap_err();
        assert!(matches!(error, Error::Unwritable { .. }), "{error:?}");
    }
    assert!(encode_wav(0, format, &[&[0.0]]).is_err());
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
    let planes = read(SoundReader::open(&path).unwrap());
    assert_eq!(planes.len(), 2);
    assert!(planes[0].len() > 30_000 - 8_000);
}

/// Name and content of the chunks of a RIFF file or a list, from this byte on.
fn chunks(mut bytes: &[u8]) -> Vec<(&str, &[u8])> {
    let mut chunks = Vec::new();
    while let Some((head, rest)) = bytes.split_first_chunk::<8>() {
        let name = str::from_utf8(&head[..4]).unwrap();
        let len = u32::from_le_bytes(head[4..].try_into().unwrap()) as usize;
        chunks.push((name, &rest[..len]));
        bytes = &rest[len + len % 2..];
    }
    chunks
}

fn cue(time_s: f64, text: &str) -> Cue {
    let text = text.to_owned();
    Cue { time_s, text }
}

/// The copy of a mono sound with these markers.
fn copied(sound: &[f32], cues: &[Cue]) -> Result<Vec<u8>, Error> {
    let wav = encode_wav(8_000, SampleFormat::Float32, &[sound]).unwrap();
    let mut source = SoundReader::from_bytes(wav, "sound.wav").unwrap();
    let mut copy = Cursor::new(Vec::new());
    copy_with_cues(&mut source, &mut copy, cues)?;
    Ok(copy.into_inner())
}

#[test]
fn markers_stand_behind_the_samples_at_their_frames() {
    // Texts of odd and even length.
    let sound = [0.25; 801];
    let cues = [cue(0.01, "1"), cue(0.1, "2?")];
    let wav = copied(&sound, &cues).unwrap();
    let [("RIFF", riff)] = chunks(&wav)[..] else {
        panic!("one RIFF chunk is the whole file");
    };
    assert_eq!(&riff[..4], b"WAVE");
    let parts = chunks(&riff[4..]);
    let names: Vec<&str> = parts.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["fmt ", "data", "cue ", "LIST"]);
    let (points, _) = parts[2].1[4..].as_chunks::<24>();
    let frame = |point: &[u8; 24]| u32::from_le_bytes(point[20..].try_into().unwrap());
    assert_eq!(points.iter().map(frame).collect::<Vec<_>>(), [80, 800]);
    let texts = chunks(&parts[3].1[4..]);
    assert_eq!(
        texts,
        [
            ("labl", &b"\x01\0\0\x001\0"[..]),
            ("labl", b"\x02\0\0\x002?\0")
        ]
    );
    let source = SoundReader::from_bytes(wav, "marked.wav").unwrap();
    assert_eq!(source.warnings(), []);
    assert_eq!(read(source), [sound]);
}

#[test]
fn a_marker_outside_the_sound_is_refused() {
    for time_s in [-0.001, 0.1, f64::NAN] {
        let cues = [cue(time_s, "1")];
        let wav = copied(&[0.0; 800], &cues);
        assert!(matches!(wav, Err(Error::Unwritable { .. })), "{time_s}");
    }
}
