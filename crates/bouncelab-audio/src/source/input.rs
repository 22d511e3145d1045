//! The bytes that a demuxer reads.

use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;

use symphonia::core::io::MediaSource;

/// The position in a source of `len` bytes after a seek from `position`.
///
/// # Errors
///
/// [`io::ErrorKind::InvalidInput`] before the start.
pub fn position_after(to: SeekFrom, position: u64, len: u64) -> io::Result<u64> {
    let (from, by) = match to {
        SeekFrom::Start(start) => (start, 0),
        SeekFrom::Current(by) => (position, by),
        SeekFrom::End(by) => (len, by),
    };
    let before_start = || io::Error::from(io::ErrorKind::InvalidInput);
    from.checked_add_signed(by).ok_or_else(before_start)
}

/// A file, or parts of it, as a source of the demuxers.
pub(super) struct MediaInput<R> {
    reader: R,
    len: u64,
    position: u64,
    is_stream: bool,
    /// Bytes that are read in front of the parts.
    header: Vec<u8>,
    /// The ranges of the file that are read one after the other, each with its position in what is read; empty if the
    /// whole file is read.
    parts: Vec<(u64, Range<u64>)>,
}

impl<R: Read + Seek> MediaInput<R> {
    pub(super) fn new(mut reader: R) -> io::Result<Self> {
        let len = reader.seek(SeekFrom::End(0))?;
        reader.rewind()?;
        Ok(Self {
            reader,
            len,
            position: 0,
            is_stream: false,
            header: Vec::new(),
            parts: Vec::new(),
        })
    }

    /// Restricts the source to these ranges of the file, and goes to the first of them.
    pub(super) fn read_only(&mut self, parts: Vec<Range<u64>>) -> io::Result<()> {
        self.len = 0;
        for part in parts {
            let len = part.end - part.start;
            self.parts.push((self.len, part));
            self.len += len;
        }
        self.rewind()
    }

    /// Restricts the source to a header and this range of the file, and goes to the header.
    pub(super) fn read_behind(&mut self, header: Vec<u8>, part: Range<u64>) -> io::Result<()> {
        self.len = header.len() as u64 + (part.end - part.start);
        self.parts = vec![(header.len() as u64, part)];
        self.header = header;
        self.rewind()
    }

    /// The position in the file that belongs to a position in the parts, and the number of bytes of the part behind it.
    fn in_parts(&self, position: u64) -> (u64, u64) {
        let next = self.parts.partition_point(|(start, _)| *start <= position);
        let (start, part) = &self.parts[next.saturating_sub(1)];
        let at = (part.start + (position - start)).min(part.end);
        (at, part.end - at)
    }

    /// Whether demuxers read the source from the beginning to the end only.
    pub(super) fn set_stream(&mut self, is_stream: bool) {
        self.is_stream = is_stream;
    }
}

impl<R: Read + Seek> Read for MediaInput<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let offset = usize::try_from(self.position).unwrap_or(usize::MAX);
        if let Some(header) = self.header.get(offset..).filter(|it| !it.is_empty()) {
            let count = (&*header).read(buffer)?;
            self.position += count as u64;
            return Ok(count);
        }
        let mut max_len = buffer.len();
        if !self.parts.is_empty() {
            let (at, follow) = self.in_parts(self.position);
            self.reader.seek(SeekFrom::Start(at))?;
            max_len = max_len.min(usize::try_from(follow).unwrap_or(usize::MAX));
        }
        let count = self.reader.read(&mut buffer[..max_len])?;
        self.position += count as u64;
        Ok(count)
    }
}

impl<R: Seek> Seek for MediaInput<R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        if self.parts.is_empty() {
            self.position = self.reader.seek(to)?;
            return Ok(self.position);
        }
        self.position = position_after(to, self.position, self.len)?;
        Ok(self.position)
    }
}

impl<R: Read + Seek + Send + Sync> MediaSource for MediaInput<R> {
    fn is_seekable(&self) -> bool {
        !self.is_stream
    }

    fn byte_len(&self) -> Option<u64> {
        (!self.is_stream).then_some(self.len)
    }
}
