//! What a file is, from its first bytes.

use std::io::{self, Read, Seek, SeekFrom};

use super::codec;
use crate::formats::SoundFormat;
use crate::problem::LooksLike;

/// What a file is according to its first bytes.
pub(super) enum Content {
    Sound(SoundFormat),
    /// Sound in a container that is not read, and its codec.
    Foreign(&'static str, String),
    Other(LooksLike),
    Nothing,
}

/// How many bytes are looked at. If all of them are printable, the file is text.
const HEAD_LEN: usize = 512;

/// Recognises the content and leaves the source at the first byte of the container, after any ID3
/// tag. The name of the file is not used: people rename files, and recorders misname them.
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
        return Ok(match SoundFormat::recognise(&head) {
            Some(SoundFormat::Ogg) if head.get(28..36) == Some(b"Speex   ") => {
                Content::Foreign(SoundFormat::Ogg.name(), "Speex".to_owned())
            }
            Some(format) => Content::Sound(format),
            // Programs that write tags pad them: zeros follow a tag as often as the first frame does.
            None if start > 0 => Content::Sound(SoundFormat::Mp3),
            None if head.is_empty() => Content::Nothing,
            None if head.starts_with(b"RIFF") && head.get(8..12) == Some(b"AVI ") => {
                avi(&mut *source)?
            }
            None => foreign(&head).unwrap_or_else(|| Content::Other(looks_like(&head))),
        });
    }
}

/// An AVI with the codec of its sound, whose description follows the header of the stream with the name `auds`.
fn avi<S: Read + ?Sized>(source: &mut S) -> io::Result<Content> {
    /// Number of bytes that contain the headers of all streams.
    const HEADERS: u64 = 1 << 16;
    let mut bytes = Vec::new();
    source.take(HEADERS).read_to_end(&mut bytes)?;
    let after = |bytes: &[u8], name: &[u8], skip: usize| {
        let at = bytes.windows(name.len()).position(|it| it == name)?;
        bytes.get(at + name.len() + skip..).map(<[u8]>::to_vec)
    };
    let description = after(&bytes, b"auds", 0).and_then(|stream| after(&stream, b"strf", 4));
    let number = description.and_then(|it| it.first_chunk().copied());
    Ok(match number {
        Some(number) => {
            let number = u16::from_le_bytes(number);
            Content::Foreign("AVI", codec::name_of_number(number))
        }
        None => Content::Other(LooksLike::Riff),
    })
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

/// Sound in a container that is not read, by how it begins: container and codec.
fn foreign(head: &[u8]) -> Option<Content> {
    const ANY: &str = "this container is not read";
    const KNOWN: [(&[u8], &str, &str); 19] = [
        (b"\x30\x26\xb2\x75\x8e\x66\xcf\x11", "ASF", "WMA"),
        (b"#!AMR-WB", "AMR", "AMR-WB"),
        (b"#!AMR", "AMR", "AMR"),
        (b".snd", "AU", "PCM"),
        (b"wvpk", "WavPack", "WavPack"),
        (b"MAC ", "APE", "Monkey's Audio"),
        (b"TTA1", "TTA", "True Audio"),
        (b"MPCK", "Musepack", "Musepack"),
        (b"MP+", "Musepack", "Musepack"),
        (b"DSD ", "DSF", "DSD"),
        (b"FRM8", "DSDIFF", "DSD"),
        (b"\x0b\x77", "AC-3", "AC-3"),
        (b"\x7f\xfe\x80\x01", "DTS", "DTS"),
        (b"\xff\xfc", "MP2", "MP2"),
        (b"\xff\xfd", "MP2", "MP2"),
        (b"Creative Voice File", "VOC", "PCM"),
        (b"FLV\x01", "FLV", ANY),
        (b".RMF", "RealMedia", ANY),
        (b"\x00\x00\x01\xba", "MPEG", ANY),
    ];
    /// Length in bytes of the packets of a transport stream, each of which begins with the same byte.
    const TRANSPORT: usize = 188;
    if is_text(head) {
        return None;
    }
    let known = KNOWN.iter().find(|(magic, ..)| head.starts_with(magic));
    let is_transport =
        head.len() > 2 * TRANSPORT && head.iter().step_by(TRANSPORT).all(|&it| it == b'G');
    let found = known.map(|&(_, container, codec)| (container, codec));
    let (container, codec) = found.or(is_transport.then_some(("MPEG transport stream", ANY)))?;
    Some(Content::Foreign(container, codec.to_owned()))
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
