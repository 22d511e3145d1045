//! What a recording is read from.

use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;

use symphonia::core::io::MediaSource;

/// Something to read from, as the demuxers want it.
pub(super) struct Input<R> {
    reader: R,
    len: u64,
    position: u64,
    is_stream: bool,
    /// Where sizes stand that were never written.
    unwritten: Vec<u64>,
    /// The only parts that are read, one after the other, each with its place among them.
    parts: Vec<(u64, Range<u64>)>,
}

/// Bytes of a size in a WAV.
const SIZE: usize = 4;

impl<R: Read + Seek> Input<R> {
    pub(super) fn new(mut reader: R) -> io::Result<Self> {
        let len = reader.seek(SeekFrom::End(0))?;
        reader.rewind()?;
        Ok(Self {
            reader,
            len,
            position: 0,
            is_stream: false,
            unwritten: Vec::new(),
            parts: Vec::new(),
        })
    }

    /// From here on only these parts of the file are there, and the first of them comes next.
    pub(super) fn read_only(&mut self, parts: Vec<Range<u64>>) -> io::Result<()> {
        self.len = 0;
        for part in parts {
            let len = part.end - part.start;
            self.parts.push((self.len, part));
            self.len += len;
        }
        self.rewind()
    }

    /// Where in the file a place in its parts is, and how many bytes follow there.
    fn in_parts(&self, place: u64) -> (u64, u64) {
        let next = self.parts.partition_point(|(start, _)| *start <= place);
        let (start, part) = &self.parts[next.saturating_sub(1)];
        let at = (part.start + (place - start)).min(part.end);
        (at, part.end - at)
    }

    /// A stream is read from the beginning to the end.
    pub(super) fn set_stream(&mut self, is_stream: bool) {
        self.is_stream = is_stream;
    }

    /// A recorder that was stopped hard has not said in its WAV how much sound there is: it says
    /// none, and much follows. From here on its sizes read as unknown, up to the end of the file.
    pub(super) fn mend_wav(&mut self) -> io::Result<()> {
        let start = self.position;
        self.unwritten = self.unwritten_sizes(start)?;
        self.seek(SeekFrom::Start(start)).map(drop)
    }

    fn unwritten_sizes(&mut self, start: u64) -> io::Result<Vec<u64>> {
        /// No recorder writes so many chunks in front of the sound.
        const MOST_CHUNKS: usize = 64;
        let (_, riff_size) = self.chunk(start)?;
        let mut at = start + 12;
        for _ in 0..MOST_CHUNKS {
            let sound = at + 8;
            if sound >= self.len {
                break;
            }
            let (name, size) = self.chunk(at)?;
            if &name == b"data" {
                let says_nothing = size == 0 && start + 8 + riff_size <= sound;
                let sizes = [start + 4, at + 4];
                return Ok(if says_nothing {
                    sizes.into()
                } else {
                    Vec::new()
                });
            }
            at = sound + size + size % 2;
        }
        Ok(Vec::new())
    }

    /// Name and size of the chunk that begins here.
    fn chunk(&mut self, at: u64) -> io::Result<([u8; 4], u64)> {
        let (mut name, mut size) = ([0; 4], [0; SIZE]);
        self.seek(SeekFrom::Start(at))?;
        self.read_exact(&mut name)?;
        self.read_exact(&mut size)?;
        Ok((name, u32::from_le_bytes(size).into()))
    }
}

impl<R: Read + Seek> Read for Input<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut most = buffer.len();
        if !self.parts.is_empty() {
            let (at, follow) = self.in_parts(self.position);
            self.reader.seek(SeekFrom::Start(at))?;
            most = most.min(usize::try_from(follow).unwrap_or(usize::MAX));
        }
        let count = self.reader.read(&mut buffer[..most])?;
        for byte in self.unwritten.iter().flat_map(|&at| at..at + SIZE as u64) {
            if let Some(index) = byte.checked_sub(self.position)
                && index < count as u64
            {
                buffer[index as usize] = 0xff;
            }
        }
        self.position += count as u64;
        Ok(count)
    }
}

impl<R: Seek> Seek for Input<R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        if self.parts.is_empty() {
            self.position = self.reader.seek(to)?;
            return Ok(self.position);
        }
        let (from, by) = match to {
            SeekFrom::Start(place) => (place, 0),
            SeekFrom::Current(by) => (self.position, by),
            SeekFrom::End(by) => (self.len, by),
        };
        let before_start = || io::Error::from(io::ErrorKind::InvalidInput);
        self.position = from.checked_add_signed(by).ok_or_else(before_start)?;
        Ok(self.position)
    }
}

impl<R: Read + Seek + Send + Sync> MediaSource for Input<R> {
    fn is_seekable(&self) -> bool {
        !self.is_stream
    }

    fn byte_len(&self) -> Option<u64> {
        (!self.is_stream).then_some(self.len)
    }
}
