//! Which container a file is, from its first bytes, and its reader.

use std::io::{self, Read, Seek, SeekFrom};

use symphonia::core::errors::Result as SymphoniaResult;
use symphonia::core::formats::{FormatOptions, FormatReader};
use symphonia::core::io::{MediaSource, MediaSourceStream, MediaSourceStreamOptions};
use symphonia::default::formats::{
    AdtsReader, AiffReader, CafReader, FlacReader, IsoMp4Reader, MkvReader, MpaReader, OggReader,
    WavReader,
};

use super::wave;
use crate::problem::LooksLike;

/// The containers that can be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Container {
    Wav,
    Aiff,
    Caf,
    Flac,
    Mpeg,
    Adts,
    Ogg,
    WebM,
    Matroska,
    Mp4,
    M4a,
    Mov,
}

/// What the first bytes of a file say.
pub(super) enum Content {
    Sound(Container),
    Other(LooksLike),
    Nothing,
}

/// How many bytes decide. Text is told from binary by all of them.
const HEAD_LEN: usize = 512;

impl Container {
    /// The name people know it by.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Wav => "WAV",
            Self::Aiff => "AIFF",
            Self::Caf => "CAF",
            Self::Flac => "FLAC",
            Self::Mpeg => "MP3",
            Self::Adts => "AAC",
            Self::Ogg => "Ogg",
            Self::WebM => "WebM",
            Self::Matroska => "Matroska",
            Self::Mp4 => "MP4",
            Self::M4a => "M4A",
            Self::Mov => "MOV",
        }
    }

    /// Whether this is the ISO base media format, whose edit lists say what is heard.
    pub(super) fn has_edit_lists(self) -> bool {
        matches!(self, Self::Mp4 | Self::M4a | Self::Mov)
    }

    /// Whether packets carry times of their own, by which lost sound is noticed.
    pub(super) fn has_clock(self) -> bool {
        self.has_edit_lists() || matches!(self, Self::Flac | Self::WebM | Self::Matroska)
    }

    /// Whether the file is best read from front to back, as a stream of unknown length. These
    /// readers would look at its end first and give up on a file that was cut short.
    pub(super) fn is_stream(self) -> bool {
        matches!(self, Self::WebM | Self::Matroska | Self::Aiff)
    }

    /// The reader for this container. The source stands at the container's first byte.
    pub(super) fn reader(
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
            Self::Mpeg => Box::new(MpaReader::try_new(stream, options)?),
            Self::Adts => Box::new(AdtsReader::try_new(stream, options)?),
            Self::Ogg => Box::new(OggReader::try_new(stream, options)?),
            Self::WebM | Self::Matroska => Box::new(MkvReader::try_new(stream, options)?),
            Self::Mp4 | Self::M4a | Self::Mov => Box::new(IsoMp4Reader::try_new(stream, options)?),
        })
    }
}

/// Looks at the content and leaves the source at the first byte of the container, past any ID3
/// tag. The name of a file is never asked: people rename files, and recorders misname them.
pub(super) fn identify<S: Read + Seek + ?Sized>(source: &mut S) -> io::Result<Content> {
    let mut start = 0;
    loop {
        source.seek(SeekFrom::Start(start))?;
        let head = read_head(source)?;
        if let Some(len) = id3_len(&head) {
            start += len;
            continue;
        }
        source.seek(SeekFrom::Start(start))?;
        return Ok(match container(&head) {
            Some(container) => Content::Sound(container),
            // Taggers pad: a tag is followed by zeros as often as by the first frame.
            None if start > 0 => Content::Sound(Container::Mpeg),
            None if head.is_empty() => Content::Nothing,
            None => Content::Other(looks_like(&head)),
        });
    }
}

fn read_head<S: Read + ?Sized>(source: &mut S) -> io::Result<Vec<u8>> {
    let mut head = Vec::with_capacity(HEAD_LEN);
    source.take(HEAD_LEN as u64).read_to_end(&mut head)?;
    Ok(head)
}

/// The length of the ID3 tag that starts here, with its header and footer.
fn id3_len(head: &[u8]) -> Option<u64> {
    let tag = head
        .first_chunk::<10>()
        .filter(|tag| tag.starts_with(b"ID3"))?;
    let size = tag[6..]
        .iter()
        .fold(0, |size, byte| size << 7 | u64::from(byte & 0x7f));
    let footer = if tag[5] & 0x10 == 0 { 0 } else { 10 };
    Some(10 + size + footer)
}

fn container(head: &[u8]) -> Option<Container> {
    let form = head.get(8..12).unwrap_or_default();
    match head.get(..4)? {
        _ if wave::is_wave(head) => Some(Container::Wav),
        b"FORM" if form == b"AIFF" || form == b"AIFC" => Some(Container::Aiff),
        b"caff" => Some(Container::Caf),
        b"fLaC" => Some(Container::Flac),
        b"OggS" => Some(Container::Ogg),
        [0x1a, 0x45, 0xdf, 0xa3] => {
            let is_web = head.windows(4).any(|word| word == b"webm");
            Some(if is_web {
                Container::WebM
            } else {
                Container::Matroska
            })
        }
        _ if head.get(4..8) == Some(b"ftyp") => Some(match form {
            b"qt  " => Container::Mov,
            b"M4A " | b"M4B " => Container::M4a,
            _ => Container::Mp4,
        }),
        // The layer bits 00 mark ADTS; 01 is MPEG layer 3; versions and rates 01, 11 are reserved.
        [0xff, 0xf0 | 0xf1 | 0xf8 | 0xf9, ..] => Some(Container::Adts),
        [0xff, 0xe2 | 0xe3 | 0xf2 | 0xf3 | 0xfa | 0xfb, rate, _] if rate >> 4 != 0xf => {
            Some(Container::Mpeg)
        }
        _ => None,
    }
}

/// A guess at what a file is that is not sound, for the message.
fn looks_like(head: &[u8]) -> LooksLike {
    const KNOWN: [(&[u8], LooksLike); 7] = [
        (b"\x89PNG", LooksLike::Png),
        (b"\xff\xd8\xff", LooksLike::Jpeg),
        (b"GIF8", LooksLike::Gif),
        (b"%PDF", LooksLike::Pdf),
        (b"PK\x03\x04", LooksLike::Zip),
        (b"\x1f\x8b", LooksLike::Gzip),
        (b"RIFF", LooksLike::Riff),
    ];
    if let Some((_, what)) = KNOWN.iter().find(|(magic, _)| head.starts_with(magic)) {
        return *what;
    }
    if head.iter().all(|&byte| byte == 0) {
        return LooksLike::Zeros;
    }
    if is_text(head) {
        LooksLike::Text
    } else {
        LooksLike::Unknown
    }
}

/// Whether these bytes are text: no control characters, and UTF-8 up to a cut at the end.
fn is_text(head: &[u8]) -> bool {
    let printable = |byte: &u8| matches!(byte, b'\t' | b'\n' | b'\r') || *byte >= b' ';
    head.iter().all(printable)
        && match std::str::from_utf8(head) {
            Ok(_) => true,
            Err(fault) => fault.error_len().is_none(),
        }
}
