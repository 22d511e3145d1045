//! Bytes as recordings and as lists of times.

use bouncelab::diagnostic::Argument;
use bouncelab_audio::{Input, MAX_BLOCK_FRAMES, SoundReader, times};

use super::mend;

/// Enough of one recording, in frames: a few bytes can stand for hours of silence.
const ENOUGH: u64 = 1 << 20;

/// Decodes FLAC as it is, and with the right checksums.
pub(super) fn flac(bytes: &[u8]) {
    decode_all(bytes);
    decode_all(&mend::flac(bytes));
}

/// Decodes Ogg as it is, and with the right checksums.
pub(super) fn ogg(bytes: &[u8]) {
    decode_all(bytes);
    decode_all(&mend::ogg(bytes));
}

/// Decodes all of it and checks what every recording must keep to.
pub(super) fn decode_all(bytes: &[u8]) {
    match SoundReader::from_bytes(bytes.to_vec(), "fuzz") {
        Ok(source) => decode(source),
        Err(error) => assert!(!error.to_string().is_empty(), "an error says what is wrong"),
    }
}

/// Reads a waveform in a text whose last line stands for so many rows that it can be one: `#` in it is the number of
/// the row.
pub(super) fn read_waveform(bytes: &[u8]) {
    const ROWS: usize = 1_200;
    let text = String::from_utf8_lossy(bytes);
    let (headings, row) = text.rsplit_once('\n').unwrap_or(("", &text));
    let rows = (0..ROWS).map(|number| row.replace('#', &number.to_string()) + "\n");
    let text = format!("{headings}\n{}", rows.collect::<String>());
    for name in ["fuzz.txt", "fuzz.csv"] {
        if let Ok(Input::Sound(source)) = Input::from_bytes(text.as_bytes(), name) {
            decode(*source);
        }
    }
}

fn decode(mut source: SoundReader) {
    let mut at = 0;
    while let Ok(Some(block)) = source.next_block() {
        assert_eq!(block.start_frame(), at, "blocks follow each other");
        assert!((1..=MAX_BLOCK_FRAMES).contains(&block.frames()));
        for channel in 0..block.channels() {
            let samples = block.channel(channel);
            assert_eq!(samples.len(), block.frames());
            assert!(samples.iter().all(|sample| sample.is_finite()));
        }
        at += block.frames() as u64;
        if at > ENOUGH {
            break;
        }
    }
    for warning in source.warnings() {
        let diagnostic = warning.diagnostic();
        for argument in diagnostic.arguments.values() {
            assert!(!matches!(argument, Argument::Number(number) if !number.is_finite()));
        }
    }
}

/// Reads a list of times in each of the formats.
pub(super) fn read_times(bytes: &[u8]) {
    for name in [
        "fuzz.txt",
        "fuzz.csv",
        "fuzz.xls",
        "fuzz.json",
        "fuzz.TextGrid",
        "fuzz.svl",
    ] {
        if let Ok(list) = times::parse(bytes, name) {
            assert!(list.times_s.iter().all(|time_s| time_s.is_finite()));
            assert!(list.times_s.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }
}
