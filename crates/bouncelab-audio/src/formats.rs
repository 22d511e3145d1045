//! The formats of sound files that are read: their only list.
//!
//! Errors, the help of the program, sessions, the page, fuzz tests and documents take names, endings and codecs from
//! here, and [`SoundReader`](crate::SoundReader) how a format is recognised and read.

use symphonia::core::errors::Result as SymphoniaResult;
use symphonia::core::formats::{FormatOptions, FormatReader};
use symphonia::core::io::{MediaSource, MediaSourceStream, MediaSourceStreamOptions};
use symphonia::default::formats::{
    AdtsReader, AiffReader, CafReader, FlacReader, IsoMp4Reader, MkvReader, MpaReader, OggReader,
    WavReader,
};

use crate::source::wave;

/// A format of sound files: the container, which holds sound in one of several codecs.
///
/// A file is recognised by its first bytes, whatever its name is.
///
/// ```
/// use bouncelab_audio::SoundFormat;
///
/// assert_eq!(SoundFormat::M4a.name(), "M4A");
/// assert!(SoundFormat::M4a.codecs().contains(&"AAC-LC"));
/// assert!(SoundFormat::endings_of_all().any(|ending| ending == "m4a"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SoundFormat {
    /// RIFF WAVE; for long recordings also RF64, BW64 and W64.
    Wav,
    /// Audio Interchange File Format, also AIFF-C.
    Aiff,
    /// Apple's Core Audio Format.
    Caf,
    /// Free Lossless Audio Codec.
    Flac,
    /// A stream of MPEG layer 3.
    Mp3,
    /// A stream of AAC in ADTS frames.
    Aac,
    /// Ogg.
    Ogg,
    /// The part of Matroska that browsers write, with or without video.
    WebM,
    /// Matroska, with or without video.
    Matroska,
    /// The ISO base media format, with or without video.
    Mp4,
    /// The ISO base media format with sound alone, as phones and iTunes write it.
    M4a,
    /// `QuickTime`, with or without video.
    Mov,
}

/// What people know of a format.
struct Facts {
    name: &'static str,
    /// Endings of file names, in small letters and without the dot.
    endings: &'static [&'static str],
    codecs: &'static [&'static str],
}

/// How a container announces the length of the sound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Length {
    /// By the number of decoded frames, exactly.
    Exact,
    /// By the number of decoded frames; some encoders count the last packet as a whole one.
    Packets,
    /// By the number of decoded frames, in packets or milliseconds.
    Coarse,
    /// By a duration in milliseconds.
    Duration,
    /// By the number of presented frames in a tag, else only by the size of the file.
    Tag,
    /// Only by the size of the file.
    Estimate,
}

/// What the chunks of WAV and AIFF hold.
const SAMPLES: [&str; 4] = [
    "integers of 8 to 32 bits",
    "floating point of 32 and 64 bits",
    "A-law",
    "mu-law",
];
/// What MP4 and its relatives hold.
const IN_MP4: &[&str] = &[
    "AAC-LC", "ALAC", "Opus", "MP3", "FLAC", SAMPLES[0], SAMPLES[1],
];

impl SoundFormat {
    /// All formats.
    pub const ALL: [Self; 12] = [
        Self::Wav,
        Self::Aiff,
        Self::Caf,
        Self::Flac,
        Self::Mp3,
        Self::Aac,
        Self::Ogg,
        Self::WebM,
        Self::Matroska,
        Self::Mp4,
        Self::M4a,
        Self::Mov,
    ];

    const fn facts(self) -> Facts {
        const fn facts(
            name: &'static str,
            endings: &'static [&'static str],
            codecs: &'static [&'static str],
        ) -> Facts {
            Facts {
                name,
                endings,
                codecs,
            }
        }
        match self {
            Self::Wav => facts("WAV", &["wav", "rf64", "w64"], &SAMPLES),
            Self::Aiff => facts("AIFF", &["aiff", "aif", "aifc"], &SAMPLES),
            Self::Caf => facts(
                "CAF",
                &["caf"],
                &[
                    "integers of 16 to 32 bits",
                    SAMPLES[1],
                    SAMPLES[2],
                    SAMPLES[3],
                    "ALAC",
                    "AAC-LC",
                ],
            ),
            Self::Flac => facts("FLAC", &["flac"], &["FLAC"]),
            Self::Mp3 => facts("MP3", &["mp3"], &["MP3"]),
            Self::Aac => facts("AAC", &["aac"], &["AAC-LC"]),
            Self::Ogg => facts("Ogg", &["ogg", "oga", "opus"], &["Vorbis", "Opus", "FLAC"]),
            Self::WebM => facts("WebM", &["webm"], &["Opus", "Vorbis"]),
            Self::Matroska => facts(
                "Matroska",
                &["mkv", "mka"],
                &["Opus", "Vorbis", "AAC-LC", "MP3", "FLAC"],
            ),
            Self::Mp4 => facts("MP4", &["mp4"], IN_MP4),
            Self::M4a => facts("M4A", &["m4a"], IN_MP4),
            Self::Mov => facts("MOV", &["mov"], IN_MP4),
        }
    }

    /// The name that people know it by, such as "MP4".
    pub const fn name(self) -> &'static str {
        self.facts().name
    }

    /// Endings of the names of such files, in small letters and without the dot.
    pub const fn endings(self) -> &'static [&'static str] {
        self.facts().endings
    }

    /// The codecs that are decoded in this format.
    pub const fn codecs(self) -> &'static [&'static str] {
        self.facts().codecs
    }

    /// The names of all formats, as a list in a sentence: "WAV, AIFF, ...".
    pub fn names() -> String {
        Self::ALL.map(Self::name).join(", ")
    }

    /// The endings of all formats.
    pub fn endings_of_all() -> impl Iterator<Item = &'static str> {
        Self::ALL.into_iter().flat_map(Self::endings).copied()
    }

    /// The format of a file that begins with these bytes.
    pub(crate) fn recognise(head: &[u8]) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|format| format.begins_with(head))
    }

    /// Whether a file of this format begins with these bytes.
    fn begins_with(self, head: &[u8]) -> bool {
        const MATROSKA: [u8; 4] = [0x1a, 0x45, 0xdf, 0xa3];
        // The brand of a file of MP4, and the form of one of AIFF.
        let brand = head.get(8..12).unwrap_or_default();
        let is_mp4 = head.get(4..8) == Some(b"ftyp");
        let is_matroska = head.starts_with(&MATROSKA);
        let is_web = || head.windows(4).any(|word| word == b"webm");
        match self {
            Self::Wav => wave::is_wave(head),
            Self::Aiff => head.starts_with(b"FORM") && matches!(brand, b"AIFF" | b"AIFC"),
            Self::Caf => head.starts_with(b"caff"),
            Self::Flac => head.starts_with(b"fLaC"),
            // The layer bits 01 mark layer 3, and 00 ADTS; the version 01 and the bit rate 15 are reserved.
            Self::Mp3 => match head {
                [0xff, 0xe2 | 0xe3 | 0xf2 | 0xf3 | 0xfa | 0xfb, rate, _, ..] => rate >> 4 != 0xf,
                _ => false,
            },
            Self::Aac => matches!(head, [0xff, 0xf0 | 0xf1 | 0xf8 | 0xf9, _, _, ..]),
            Self::Ogg => head.starts_with(b"OggS"),
            Self::WebM => is_matroska && is_web(),
            Self::Matroska => is_matroska && !is_web(),
            Self::Mov => is_mp4 && brand == b"qt  ",
            Self::M4a => is_mp4 && matches!(brand, b"M4A " | b"M4B "),
            Self::Mp4 => is_mp4 && !Self::Mov.begins_with(head) && !Self::M4a.begins_with(head),
        }
    }

    /// The demuxer. The source stands at the first byte of the container.
    pub(crate) fn reader(
        self,
        source: Box<dyn MediaSource>,
    ) -> SymphoniaResult<Box<dyn FormatReader>> {
        let stream = MediaSourceStream::new(source, MediaSourceStreamOptions::default());
        let options = FormatOptions::default();
        Ok(match self {
            Self::Wav => Box::new(WavReader::try_new(stream, options)?),
            Self::Aiff => Box::new(AiffReader::try_new(stream, options)?),
            Self::Caf => Box::new(CafReader::try_new(stream, options)?),
            Self::Flac => Box::new(FlacReader::try_new(stream, options)?),
            Self::Mp3 => Box::new(MpaReader::try_new(stream, options)?),
            Self::Aac => Box::new(AdtsReader::try_new(stream, options)?),
            Self::Ogg => Box::new(OggReader::try_new(stream, options)?),
            Self::WebM | Self::Matroska => Box::new(MkvReader::try_new(stream, options)?),
            Self::Mp4 | Self::M4a | Self::Mov => Box::new(IsoMp4Reader::try_new(stream, options)?),
        })
    }

    /// Whether edit lists state which part of the sound is presented: those of the ISO base media format.
    pub(crate) fn has_edit_lists(self) -> bool {
        matches!(self, Self::Mp4 | Self::M4a | Self::Mov)
    }

    /// Whether the file is a row of chunks, of which one describes the sound: samples of equal length, mostly.
    pub(crate) fn has_chunks(self) -> bool {
        matches!(self, Self::Wav | Self::Aiff | Self::Caf)
    }

    /// Whether each packet has a time of its own, by which lost sound is noticed.
    pub(crate) fn has_clock(self) -> bool {
        self.has_edit_lists() || matches!(self, Self::Flac | Self::WebM | Self::Matroska)
    }

    /// How the length of the sound is announced.
    pub(crate) fn length(self) -> Length {
        match self {
            Self::Wav | Self::Aiff | Self::Flac => Length::Exact,
            Self::Caf => Length::Packets,
            Self::Mp3 => Length::Tag,
            Self::Aac => Length::Estimate,
            Self::WebM | Self::Matroska => Length::Duration,
            Self::Ogg | Self::Mp4 | Self::M4a | Self::Mov => Length::Coarse,
        }
    }

    /// Whether the file is read from front to back, as a stream of unknown length: the demuxers of these formats
    /// would look at its end first, and refuse a file that was cut short.
    pub(crate) fn is_stream(self) -> bool {
        matches!(self, Self::WebM | Self::Matroska | Self::Aiff)
    }
}
