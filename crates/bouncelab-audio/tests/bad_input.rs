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

/// Containers that are not read are sound all the same, and a WAV may hold codecs that the demuxer does not know.
#[test]
fn sound_of_other_programs_is_named() {
    let mut mp3_in_wav = fixture("pcm16.wav");
    mp3_in_wav[20] = 0x55;
    let mut caf_of_8_bits = fixture("pcm16.caf");
    (caf_of_8_bits[39], caf_of_8_bits[51]) = (1, 8);
    let mut speex = vec![0; 600];
    speex[..4].copy_from_slice(b"OggS");
    speex[28..36].copy_from_slice(b"Speex   ");
    let mut stream = vec![0; 600];
    (0..600).step_by(188).for_each(|at| stream[at] = b'G');
    for (bytes, said) in [
        (mp3_in_wav, "this WAV file: MP3"),
        (
            caf_of_8_bits,
            "this CAF file: caf: unsupported bits per channel",
        ),
        (speex, "this Ogg file: Speex"),
        (stream, "this MPEG transport stream file"),
        (b"#!AMR\n\x04\0\0".to_vec(), "this AMR file: AMR"),
        (
            b"\x30\x26\xb2\x75\x8e\x66\xcf\x11".to_vec(),
            "this ASF file: WMA",
        ),
        (b".snd\0\0\0\x18".to_vec(), "this AU file: PCM"),
    ] {
        let refused = refusal(bytes, "phone").to_string();
        assert!(
            refused.contains(said) && refused.contains("ffmpeg -i"),
            "{refused}"
        );
    }
    // A table is no sound of Monkey's Audio, whatever its first heading is.
    let table = refusal(&b"MAC address, time\n"[..], "table.csv");
    assert!(matches!(table, Error::NotSound { .. }), "{table}");
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
        let (seconds, mut warnings) = salvage(bytes, name);
        // Of the AIFF, whose rate is no usual one.
        warnings.retain(|it| !matches!(it, Warning::RateInDoubt { .. }));
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

/// Whatever bit of a header is another one: the file is refused, or has a warning, or is read with as many frames and
/// channels at the same rate.
#[test]
fn no_bit_of_a_header_changes_the_layout_without_a_word() {
    for (name, header) in [
        ("pcm16.wav", 44),
        ("pcm16.aiff", 54),
        ("pcm16.caf", 72),
        ("alaw.wav", 58),
        ("alaw.aiff", 72),
        ("mulaw.caf", 92),
    ] {
        let layout = |file: Vec<u8>| {
            let mut source = SoundReader::from_bytes(file, name).ok()?;
            let mut frames = 0;
            while let Some(block) = source.next_block().unwrap() {
                frames += block.frames();
            }
            let warnings = source.warnings().to_vec();
            Some((source.sample_rate_hz(), source.channels(), frames, warnings))
        };
        let whole = layout(fixture(name)).unwrap();
        for bit in 0..8 * header {
            let mut file = fixture(name);
            file[bit / 8] ^= 1 << (bit % 8);
            let Some(read) = layout(file) else {
                continue;
            };
            let is_known = (read.0, read.1, read.2) == (whole.0, whole.1, whole.2);
            let is_warned = read.3.iter().any(|warning| match warning {
                Warning::RateInDoubt { stated_hz, .. } => read.0 == *stated_hz,
                Warning::Truncated { .. } => true,
                _ => false,
            });
            assert!(is_known || is_warned, "{name}, bit {bit}: {read:?}");
        }
    }
}

/// As arecord writes `S24_LE`: three bytes of sound in each four.
#[test]
fn samples_of_24_bits_in_four_bytes_are_read() {
    let wide: Vec<f32> = (0..4_000)
        .map(|n| (n % 200) as f32 / 256.0 / 256.0)
        .collect();
    let mut wav = encode_wav(8_000, SampleFormat::Int24, &[&wide]).unwrap();
    let sound: Vec<u8> = wav[44..]
        .as_chunks::<3>()
        .0
        .iter()
        .flat_map(|&[low, middle, high]| {
            let sign = if high & 0x80 == 0 { 0 } else { 0xff };
            [low, middle, high, sign]
        })
        .collect();
    wav.truncate(44);
    wav[28..32].copy_from_slice(&32_000_u32.to_le_bytes());
    wav[32] = 4;
    wav[4..8].copy_from_slice(&(36 + sound.len() as u32).to_le_bytes());
    wav[40..44].copy_from_slice(&(sound.len() as u32).to_le_bytes());
    wav.extend(sound);
    let mut source = SoundReader::from_bytes(wav, "arecord.wav").unwrap();
    let mut samples = Vec::new();
    while let Some(block) = source.next_block().unwrap() {
        samples.extend_from_slice(block.channel(0));
    }
    assert_eq!(source.warnings(), []);
    assert_eq!(samples.len(), wide.len());
    for (sample, expected) in samples.iter().zip(&wide) {
        // The high byte is empty: full scale is 256 times as far.
        assert!((256.0 * sample - expected).abs() < 1e-6, "{sample}");
    }
}

/// The size of the file counts the sound.
#[test]
fn a_wav_without_the_size_of_its_sound_is_read_by_the_size_of_the_file() {
    let whole = salvage(fixture("pcm16.wav"), "pcm16.wav");
    let size = (fixture("pcm16.wav").len() - 8) as u32;
    assert_eq!(salvage(unfinished(size), "no-size.wav"), whole);
}

/// Bytes of sound that are in the file twice.
#[test]
fn bytes_inserted_into_the_sound_are_noticed() {
    for (name, place) in [
        ("pcm16.wav", 3_000),
        ("pcm8.wav", 1_001),
        ("pcm16.aiff", 3_000),
    ] {
        let mut file = fixture(name);
        let piece = file[place - 600..place].to_vec();
        file.splice(place..place, piece);
        let is_noticed = |warning: &Warning| matches!(warning, Warning::Truncated { .. });
        let (_, warnings) = salvage(file, name);
        assert!(warnings.iter().any(is_noticed), "{name}: {warnings:?}");
    }
}

/// A box of MP4 with this content.
fn enclose(kind: &[u8], content: &[u8]) -> Vec<u8> {
    let size = (content.len() + 8) as u32;
    [&size.to_be_bytes(), kind, content].concat()
}

/// The children of a movie down to the description of the sound, with this one in its place.
fn redescribed(boxes: &[u8], path: &[&[u8]], entry: &[u8]) -> Vec<u8> {
    let (mut at, mut rebuilt) = (0, Vec::new());
    while at < boxes.len() {
        let size = u32::from_be_bytes(*boxes[at..].first_chunk().unwrap()) as usize;
        let (kind, content) = (&boxes[at + 4..at + 8], &boxes[at + 8..at + size]);
        rebuilt.extend(match path.split_first() {
            Some((first, [])) if *first == kind => enclose(kind, &[&content[..8], entry].concat()),
            Some((first, inner)) if *first == kind => {
                enclose(kind, &redescribed(content, inner, entry))
            }
            _ => boxes[at..at + size].to_vec(),
        });
        at += size;
    }
    rebuilt
}

/// The fixture of ALAC with another description; the boxes behind the sound may change their length.
fn movie(brand: &[u8], entry: &[u8]) -> Vec<u8> {
    let mut file = fixture("alac.m4a");
    file[8..12].copy_from_slice(brand);
    let path: [&[u8]; 6] = [b"moov", b"trak", b"mdia", b"minf", b"stbl", b"stsd"];
    redescribed(&file, &path, entry)
}

/// `QuickTime` has the set-up of ALAC in a box `wave`, behind a longer description.
#[test]
fn alac_in_quicktime_is_read() {
    let file = fixture("alac.m4a");
    let setup = file
        .windows(8)
        .position(|it| it == b"\0\0\0\x24alac")
        .unwrap();
    let setup = &file[setup..setup + 36];
    let head = &file[file
        .windows(8)
        .position(|it| it == b"stsd\0\0\0\0")
        .unwrap()
        + 20..][..28];
    let format = enclose(b"frma", b"alac");
    let wave = enclose(b"wave", &[&format, setup, b"\0\0\0\x08\0\0\0\0"].concat());
    // Version 1: samples in a packet, bytes of a packet, of a frame and of a sample.
    let mut head = head.to_vec();
    head[9] = 1;
    let entry = enclose(b"alac", &[&head, &[0; 16][..], &wave].concat());
    let (seconds, warnings) = salvage(movie(b"qt  ", &entry), "alac.mov");
    assert!((seconds - 0.6).abs() < 1e-9, "{seconds} s");
    assert_eq!(warnings, []);
}

#[test]
fn a_refusal_names_container_and_codec() {
    let amr = enclose(
        b"samr",
        &[&[0; 28][..], &enclose(b"damr", &[0; 9])].concat(),
    );
    let refused = refusal(movie(b"3gp4", &amr), "phone.3gp");
    assert!(
        matches!(&refused, Error::UnsupportedCodec { codec, .. } if codec == "AMR"),
        "{refused}"
    );
    // The header of an AVI: list of headers, header of a stream of sound, its description.
    let chunk = |name: &[u8], content: &[u8]| {
        [name, &(content.len() as u32).to_le_bytes(), content].concat()
    };
    let stream = [
        b"strl".to_vec(),
        chunk(b"strh", &[b"auds", &[0; 52][..]].concat()),
        chunk(
            b"strf",
            &[0x55, 0, 1, 0, 0x44, 0xac, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0],
        ),
    ];
    let list = chunk(
        b"LIST",
        &[b"hdrl".to_vec(), chunk(b"LIST", &stream.concat())].concat(),
    );
    let avi = chunk(b"RIFF", &[b"AVI ".to_vec(), list].concat());
    let refused = refusal(avi, "camera.avi");
    let said = refused.to_string();
    assert!(
        said.contains("AVI file: MP3") && said.contains("ffmpeg"),
        "{said}"
    );
}
