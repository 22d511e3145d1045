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
    /// What is read in front of the parts.
    header: Vec<u8>,
    /// The only parts that are read, one after the other, each with its place among them.
    parts: Vec<(u64, Range<u64>)>,
}

impl<R: Read + Seek> Input<R> {
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

    /// From here on this header is there, and behind it only this part of the file.
    pub(super) fn read_behind(&mut self, header: Vec<u8>, part: Range<u64>) -> io::Result<()> {
        self.len = header.len() as u64 + (part.end - part.start);
        self.parts = vec![(header.len() as u64, part)];
        self.header = header;
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
}

impl<R: Read + Seek> Read for Input<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let place = usize::try_from(self.position).unwrap_or(usize::MAX);
        if let Some(header) = self.header.get(place..).filter(|it| !it.is_empty()) {
            let count = (&*header).read(buffer)?;
            self.position += count as u64;
            return Ok(count);
        }
        let mut most = buffer.len();
        if !self.parts.is_empty() {
            let (at, follow) = self.in_parts(self.position);
            self.reader.seek(SeekFrom::Start(at))?;
            most = most.min(usize::try_from(follow).unwrap_or(usize::MAX));
        }
        let count = self.reader.read(&mut buffer[..most])?;
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
