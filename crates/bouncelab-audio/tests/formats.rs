//! Every format decodes to the sound that went in, at the time at which it went in.
//!
//! Truth is the formula in `clicks`, not another decoder. That these times are also those of other
//! players was checked by hand: ffmpeg 5.1 decodes all fixtures with a lag of 0 samples to ours
//! (Opus: libopus does; ffmpeg's own Opus decoder differs from libopus by 2 samples in some modes).

mod clicks;

use std::fs;
use std::path::PathBuf;

use bouncelab_audio::{SoundFormat, SoundReader, Warning};
use clicks::{TIMES_S, click, signal};

fn fixture(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/fixtures")
        .join(name)
}

/// All samples of all channels, and the source at its end.
fn decode(name: &str) -> (Vec<Vec<f32>>, SoundReader) {
    let mut source = SoundReader::open(fixture(name)).unwrap();
    let mut channels = vec![Vec::new(); source.channels()];
    while let Some(block) = source.next_block().unwrap() {
        assert_eq!(block.channels(), channels.len(), "{name}");
        assert_eq!(
            block.start_frame(),
            channels[0].len() as u64,
            "{name}: a gap between blocks"
        );
        for (number, samples) in channels.iter_mut().enumerate() {
            samples.extend_from_slice(block.channel(number));
        }
    }
    (channels, source)
}

/// How late each click is, in seconds: where the correlation with the true click peaks, refined by
/// a parabola through the three highest values.
fn lateness_s(sound: &[f32], sample_rate_hz: u32, expected_s: &[f64]) -> Vec<f64> {
    let rate = f64::from(sample_rate_hz);
    let correlation = |start_s: f64| {
        let first = (start_s * rate).ceil() as usize;
        let frames = first..(first + (0.02 * rate) as usize).min(sound.len());
        frames
            .map(|i| f64::from(sound[i]) * click(i as f64 / rate - start_s))
            .sum::<f64>()
    };
    let step_s = 1.0 / rate / 4.0;
    let late = |expected_s: &f64| {
        let at = |shift: i32| correlation(expected_s + f64::from(shift) * step_s);
        // A third of a period either way; further lie the side lobes.
        let reach = (0.000_2 / step_s) as i32;
        let best = (-reach..=reach)
            .max_by(|a, b| at(*a).total_cmp(&at(*b)))
            .unwrap();
        let (before, peak, after) = (at(best - 1), at(best), at(best + 1));
        (f64::from(best) + 0.5 * (before - after) / (before - 2.0 * peak + after)) * step_s
    };
    expected_s.iter().map(late).collect()
}

fn worst(values: &[f64]) -> f64 {
    values
        .iter()
        .fold(0.0, |worst, value| f64::max(worst, value.abs()))
}

#[test]
fn lossless_formats_return_every_sample() {
    for (name, format, rate, step) in [
        ("pcm8.wav", "8-bit WAV", 8_000, 1.0 / 128.0),
        ("pcm16.wav", "16-bit WAV", 8_000, 1.0 / 32_768.0),
        ("pcm24.wav", "24-bit WAV", 8_000, 1.0 / 8_388_608.0),
        ("pcm32.wav", "32-bit WAV", 8_000, 1.0 / 16_777_216.0),
        ("float32.wav", "32-bit float WAV", 8_000, 0.0),
        ("rate4000.wav", "16-bit WAV", 4_000, 1.0 / 32_768.0),
        ("pcm16.aiff", "16-bit AIFF", 8_000, 1.0 / 32_768.0),
        ("pcm16.caf", "16-bit CAF", 8_000, 1.0 / 32_768.0),
        ("pcm24.mov", "24-bit MOV", 8_000, 1.0 / 8_388_608.0),
        ("float32.mov", "32-bit float MOV", 8_000, 0.0),
        // Steps of the loudest of eight ranges, each half as wide as the one above.
        ("alaw.wav", "A-law in WAV", 8_000, 1.0 / 32.0),
        ("alaw.aiff", "A-law in AIFF", 8_000, 1.0 / 32.0),
        ("mulaw.caf", "mu-law in CAF", 8_000, 1.0 / 32.0),
        ("lossless.flac", "FLAC", 8_000, 1.0 / 32_768.0),
        ("alac.m4a", "ALAC in M4A", 8_000, 1.0 / 32_768.0),
    ] {
        let (channels, source) = decode(name);
        assert_eq!(source.format(), format);
        assert_eq!(source.sample_rate_hz(), rate, "{name}");
        assert_eq!(source.duration_s(), Some(0.6), "{name}");
        // AIFF and CAF state the rate only once, and this is no usual one.
        let is_doubted = [".aiff", ".caf"].iter().any(|it| name.ends_with(it));
        let doubt = is_doubted.then_some(Warning::RateInDoubt {
            stated_hz: rate,
            implied_hz: None,
        });
        assert_eq!(source.warnings(), doubt.as_slice(), "{name}");
        let truth = signal(rate);
        assert_eq!(channels[0].len(), truth.len(), "{name}");
        for (frame, (sample, true_sample)) in channels[0].iter().zip(&truth).enumerate() {
            assert!(
                (sample - true_sample).abs() <= step,
                "{name}: frame {frame}"
            );
        }
    }
}

#[test]
fn every_channel_is_kept_apart() {
    let (channels, _) = decode("three-channels.wav");
    assert_eq!(channels.len(), 3);
    let truth = signal(4_000);
    for (channel, gain) in channels.iter().zip([1.0, 0.5, -0.25]) {
        for (sample, true_sample) in channel.iter().zip(&truth) {
            assert!((sample - gain * true_sample).abs() <= 1.0 / 32_768.0);
        }
    }
}

#[test]
fn lossy_formats_keep_the_times_of_clicks_within_a_tenth_of_a_millisecond() {
    for (name, format, rate) in [
        ("aac.m4a", "AAC in M4A", 44_100),
        ("video.mov", "AAC in MOV", 44_100),
        ("lame-tag.mp3", "MP3", 44_100),
        ("id3.mp3", "MP3", 44_100),
        ("vorbis.ogg", "Vorbis in Ogg", 44_100),
        ("opus.ogg", "Opus in Ogg", 48_000),
        ("opus.webm", "Opus in WebM", 48_000),
        ("browser.webm", "Opus in WebM", 48_000),
        ("opus.mp4", "Opus in MP4", 48_000),
    ] {
        let (channels, source) = decode(name);
        assert_eq!(source.format(), format, "{name}");
        assert_eq!(source.sample_rate_hz(), rate, "{name}");
        assert_eq!(source.warnings(), [], "{name}");
        let late = lateness_s(&channels[0], rate, &TIMES_S);
        assert!(worst(&late) < 1e-4, "{name}: late by {late:?} s");
        // Matroska names the padding at the end in a way that is not read.
        let frames = (0.6 * f64::from(rate)) as usize;
        let padding = if name.ends_with("webm") { 960 } else { 0 };
        assert!(
            (frames..=frames + padding).contains(&channels[0].len()),
            "{name}"
        );
    }
}

#[test]
fn an_edit_list_that_starts_within_a_packet_is_followed_to_the_frame() {
    let (channels, source) = decode("trimmed.m4a");
    assert_eq!(source.duration_s(), Some(0.4));
    assert_eq!(channels[0].len(), 17_640);
    let expected: Vec<f64> = TIMES_S[1..].iter().map(|time_s| time_s - 0.2).collect();
    let late = lateness_s(&channels[0], 44_100, &expected);
    assert!(worst(&late) < 1e-4, "late by {late:?} s");
}

/// As encoders of AAC write it, which the encoder of the fixtures cannot: here in a table of ALAC, whose number of
/// frames that encoder rounds up to whole packets.
#[test]
fn the_priming_that_a_caf_file_names_is_left_out() {
    let mut caf = std::fs::read(fixture("alac.caf")).unwrap();
    let table = caf.windows(4).position(|word| word == b"pakt").unwrap() + 12;
    let presented = table + 8;
    caf[presented..presented + 8].copy_from_slice(&4_700_i64.to_be_bytes());
    caf[presented + 8..presented + 12].copy_from_slice(&100_i32.to_be_bytes());
    let mut source = SoundReader::from_bytes(caf, "primed.caf").unwrap();
    assert_eq!(source.format(), "ALAC in CAF");
    let mut samples = Vec::new();
    while let Some(block) = source.next_block().unwrap() {
        samples.extend_from_slice(block.channel(0));
    }
    let truth = signal(8_000);
    assert_eq!(samples.len(), 4_700);
    assert_eq!(source.warnings(), []);
    for (sample, true_sample) in samples.iter().zip(&truth[100..]) {
        assert!((sample - true_sample).abs() <= 1.0 / 32_768.0);
    }
}

#[test]
fn formats_that_do_not_name_their_priming_are_late_by_all_of_it() {
    // 1024 frames of AAC priming; 576 of LAME and 529 of any MP3 decoder. ffmpeg keeps them too.
    for (name, priming) in [("aac.aac", 1_024.0), ("no-tag.mp3", 1_105.0)] {
        let (channels, _) = decode(name);
        let expected = TIMES_S.map(|time_s| time_s + priming / 44_100.0);
        let late = lateness_s(&channels[0], 44_100, &expected);
        assert!(worst(&late) < 1e-4, "{name}: late by {late:?} s");
    }
}

#[test]
fn a_source_can_move_to_another_thread() {
    fn sendable<T: Send + Sync>() {}
    sendable::<SoundReader>();
}

#[test]
fn a_stream_without_lengths_has_no_duration_and_is_not_called_truncated() {
    let (_, source) = decode("browser.webm");
    assert_eq!(source.duration_s(), None);
    assert_eq!(source.warnings(), []);
}

#[test]
fn what_is_not_a_number_becomes_zero_and_is_counted() {
    let mut wav = std::fs::read(fixture("float32.wav")).unwrap();
    let data = wav.windows(4).position(|word| word == b"data").unwrap() + 8;
    for (frame, bad) in [
        (1_000, f32::NAN),
        (1_001, f32::INFINITY),
        (4_000, f32::NEG_INFINITY),
    ] {
        wav[data + 4 * frame..][..4].copy_from_slice(&bad.to_le_bytes());
    }
    let mut source = SoundReader::from_bytes(wav, "holes.wav").unwrap();
    while let Some(block) = source.next_block().unwrap() {
        assert!(block.channel(0).iter().all(|sample| sample.is_finite()));
    }
    assert_eq!(
        source.warnings(),
        [Warning::NonFinite {
            samples: 3,
            first_s: 0.125
        }]
    );
}

/// Codecs as `SoundReader::format` names them, and as the list of formats does.
const CODECS: [(&str, &str); 3] = [
    ("-bit float", "floating point"),
    ("-bit", "integers"),
    ("AAC", "AAC-LC"),
];

/// A file of `WebM` with the header of Matroska (RFC 9559), where nothing but the type of the document differs.
fn matroska(webm: &[u8]) -> Vec<u8> {
    let doc_type = [0x42, 0x82, 0x80 | 4, b'w', b'e', b'b', b'm'];
    let place = webm.windows(7).position(|bytes| bytes == doc_type).unwrap();
    let (before, after) = (&webm[..place], &webm[place + doc_type.len()..]);
    let mut file = [before, &[0x42, 0x82, 0x80 | 8], b"matroska", after].concat();
    // The length of the header, in one byte behind its name of four.
    assert_eq!(file[4] & 0x80, 0x80);
    file[4] += 4;
    file
}

/// Every fixture that can be decoded is in a codec that is listed for its format, and every format has a fixture.
#[test]
fn the_list_of_formats_is_what_is_decoded() {
    let files = fs::read_dir(fixture("")).unwrap();
    let mut sources: Vec<SoundReader> = files
        .filter_map(|file| SoundReader::open(file.unwrap().path()).ok())
        .collect();
    let matroska = matroska(&fs::read(fixture("opus.webm")).unwrap());
    sources.push(SoundReader::from_bytes(matroska, "opus.mkv").unwrap());
    for format in SoundFormat::ALL {
        let name = format.name();
        let descriptions = sources.iter().map(SoundReader::format);
        let own: Vec<String> = descriptions
            .filter(|description| description.ends_with(name))
            .collect();
        assert!(!own.is_empty(), "no fixture is {name}");
        for description in own {
            let named = CODECS.iter().find(|(part, _)| description.contains(part));
            let codec = named.map_or(&*description, |(_, listed)| listed);
            let is_decoded = |listed: &&str| listed.starts_with(codec) || codec.starts_with(listed);
            assert!(format.codecs().iter().any(is_decoded), "{description}");
        }
    }
}

#[test]
fn the_documents_have_the_list_of_formats() {
    let page = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs/formats.md");
    let page = fs::read_to_string(page).unwrap();
    let row = |format: SoundFormat| {
        let endings = format.endings().iter().map(|ending| format!("`.{ending}`"));
        let endings: Vec<String> = endings.collect();
        let codecs = format.codecs().join(", ");
        format!(
            "| {} | {} | {codecs} |\n",
            format.name(),
            endings.join(", ")
        )
    };
    let table: String = SoundFormat::ALL.into_iter().map(row).collect();
    assert!(
        page.contains(&table),
        "docs/formats.md lacks this table:\n{table}"
    );
}
