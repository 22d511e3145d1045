//! Recordings from the wild, kept outside the project. `BOUNCELAB_RECORDINGS` names their folder.

use bouncelab_audio::SoundReader;
use bouncelab_testkit::recordings;

/// File, what it is, rate, channels, and frames as ffmpeg 5.1 decodes them. ffmpeg does not cut
/// the padding that the edit list of the MOV file takes off its end (502 frames).
const RECORDINGS: [(&str, &str, u32, usize, u64); 6] = [
    ("two-runs.mp3", "MP3", 24_000, 2, 224_640),
    (
        "pingpong-under-music.mov",
        "AAC in MOV",
        44_100,
        2,
        138_462 - 502,
    ),
    ("few-hits.webm", "Opus in WebM", 48_000, 1, 342_720),
    ("contact-mic-8bit.wav", "8-bit WAV", 8_820, 1, 678_390),
    ("not-speech.wav", "16-bit WAV", 8_000, 1, 4_548),
    ("not-clock.wav", "16-bit WAV", 44_100, 2, 280_478),
];

#[test]
#[ignore = "reads the recordings in BOUNCELAB_RECORDINGS"]
fn recordings_have_the_length_that_other_players_give() {
    for (name, format, rate, channels, frames) in RECORDINGS {
        let mut source = SoundReader::open(recordings().join(name)).unwrap();
        let mut count = 0;
        while let Some(block) = source.next_block().unwrap() {
            count += block.frames() as u64;
        }
        assert_eq!(source.format(), format, "{name}");
        assert_eq!(source.sample_rate_hz(), rate, "{name}");
        assert_eq!(source.channels(), channels, "{name}");
        assert_eq!(count, frames, "{name}");
        assert_eq!(source.warnings(), [], "{name}");
    }
}
