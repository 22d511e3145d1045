//! Writes samples to a WAV file during recording.

use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;

use bouncelab::Plain;
use bouncelab::analysis::Gap;

use crate::error::{Error, Result};
use crate::lost_chunk;
use crate::wav::{self, MAX_DATA_LEN, SampleFormat, TOO_LONG, WavLayout, chunk};

/// The length of the header in bytes: one page, which a disk writes as a whole or not at all. The part that the fields of
/// a WAV leave holds the places where sound was lost.
const HEADER_LEN: usize = 4096;

/// Maximum number of places that fit.
const MAX_GAPS: usize = (HEADER_LEN - wav::HEADER_LEN as usize - 2 * 8) / lost_chunk::GAP_LEN;

/// A WAV file that is written during a recording, and can be read at any time.
///
/// Each second of sound is written when it is complete; when it is on the disk, a header that counts it follows. So
/// after a crash of the program or a loss of power, or on a full disk, the file is a valid recording that lacks at most
/// the last two seconds, and its header never counts sound that is missing.
/// [`Recorder::finish`] writes the rest and waits for the disk. The header also states where sound was lost
/// ([`Recorder::note_gap`]), which [`SoundReader`](crate::SoundReader) reads back.
///
/// ```
/// use bouncelab_audio::{Recorder, SampleFormat, SoundReader};
///
/// let path = std::env::temp_dir().join(format!("bouncelab-{}.wav", std::process::id()));
/// let mut recorder = Recorder::create(&path, 44_100, 1, SampleFormat::Int16)?;
/// recorder.push(&[&[0.5; 1000]])?;
/// recorder.push(&[&[0.25; 1000]])?;
/// recorder.finish()?;
/// assert_eq!(SoundReader::open(&path)?.duration_s(), Some(2000.0 / 44_100.0));
/// # std::fs::remove_file(&path).unwrap();
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
#[derive(Debug)]
pub struct Recorder<W: Store = File> {
    name: String,
    layout: WavLayout,
    file: W,
    /// Encoded samples that were not written yet.
    waiting: Vec<u8>,
    /// Number of bytes of samples that the header counts.
    data_len: u32,
    /// Maximum number of bytes of samples.
    max_data_len: u32,
    /// The places where sound was lost.
    gaps: Vec<Gap>,
    /// Whether writing has failed: nothing more is written.
    is_closed: bool,
}

/// A file, or what takes its place, that a [`Recorder`] writes.
pub trait Store: Write + Seek {
    /// Waits until everything that was written would survive a loss of power.
    ///
    /// # Errors
    /// The error that the system reports.
    fn sync(&self) -> io::Result<()>;
}

impl Store for File {
    fn sync(&self) -> io::Result<()> {
        self.sync_data()
    }
}

impl Recorder {
    /// Creates the file; an existing file is not changed.
    ///
    /// # Errors
    ///
    /// [`Error::Exists`] if there is such a file, [`Error::Unwritable`] if the rate or the number
    /// of channels is zero or beyond what a WAV file can have, [`Error::NotFound`] or
    /// [`Error::Io`] if the system fails to create it.
    pub fn create(
        path: impl AsRef<Path>,
        sample_rate_hz: u32,
        channels: usize,
        format: SampleFormat,
    ) -> Result<Self> {
        let path = path.as_ref();
        let name = String::from(Plain::path(path));
        let layout = WavLayout::new(&name, sample_rate_hz, channels, format)?;
        let file = File::options().write(true).create_new(true).open(path);
        file.and_then(|file| Self::start(&name, layout, file))
            .map_err(|reason| Error::io(&name, reason))
    }

    /// Writes the rest, waits until it is on the disk, and closes the file.
    ///
    /// # Errors
    ///
    /// As for [`Recorder::push`].
    pub fn finish(mut self) -> Result<()> {
        if self.is_closed {
            return Ok(());
        }
        self.write_out()?;
        self.file
            .sync()
            .map_err(|reason| Error::io(&self.name, reason))
    }
}

impl<W: Store> Recorder<W> {
    fn start(name: &str, layout: WavLayout, file: W) -> io::Result<Self> {
        let mut recorder = Self {
            name: name.to_owned(),
            layout,
            file,
            waiting: Vec::new(),
            data_len: 0,
            max_data_len: MAX_DATA_LEN - HEADER_LEN as u32,
            gaps: Vec::new(),
            is_closed: false,
        };
        recorder.write_header(0)?;
        Ok(recorder)
    }

    /// The same file with a size limit of its samples, in bytes, below the 4 GB that a WAV can have.
    #[must_use]
    pub fn with_size_limit(mut self, bytes: u32) -> Self {
        self.max_data_len = self.max_data_len.min(bytes);
        self
    }

    /// The file as the caller named it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Seconds of sound that are in the file, counted by its header.
    pub fn saved_s(&self) -> f64 {
        let frames = self.data_len / u32::from(self.layout.frame_len());
        f64::from(frames) / f64::from(self.layout.sample_rate_hz)
    }

    /// Number of frames that still fit: a WAV file cannot hold more than 4 GB.
    pub fn room_frames(&self) -> u64 {
        let used = u64::from(self.data_len) + self.waiting.len() as u64;
        u64::from(self.max_data_len).saturating_sub(used) / u64::from(self.layout.frame_len())
    }

    /// Notes that sound was lost; the silence in its place is pushed as any other sound. The note is written with the
    /// next samples, or at the end. Gaps beyond the 168 that fit are joined with the last one, whose length is then
    /// uncertain.
    pub fn note_gap(&mut self, gap: Gap) {
        match self.gaps.get_mut(MAX_GAPS - 1) {
            Some(last) => {
                last.duration_s = gap.end_s() - last.start_s;
                last.certain = false;
            }
            None => self.gaps.push(gap),
        }
    }

    /// Takes the next samples of every channel, in `-1.0..1.0`. Samples that are not numbers become 0.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if the system fails to write, for example because the disk is full;
    /// [`Error::Unwritable`] if the file cannot grow further. The file then ends with the last whole
    /// frame that was written, its header counts it, and nothing more is written: later calls do
    /// nothing.
    ///
    /// # Panics
    ///
    /// If there are not as many slices as channels, or they differ in length.
    pub fn push(&mut self, channels: &[&[f32]]) -> Result<()> {
        assert_eq!(
            channels.len(),
            usize::from(self.layout.channels),
            "one slice for each channel"
        );
        assert!(
            channels.iter().all(|c| c.len() == channels[0].len()),
            "channels of equal length"
        );
        if self.is_closed {
            return Ok(());
        }
        let frames = channels[0].len();
        if frames as u64 > self.room_frames() {
            self.write_out()?;
            self.is_closed = true;
            return Err(Error::unwritable(&self.name, TOO_LONG));
        }
        let second_len = self.layout.sample_rate_hz as usize * usize::from(self.layout.frame_len());
        let block_len = frames * usize::from(self.layout.frame_len());
        // At most one second is written between two headers, unless a longer block comes at once.
        if !self.waiting.is_empty() && self.waiting.len() + block_len > second_len {
            self.write_out()?;
        }
        for frame in 0..frames {
            for channel in channels {
                let sample = Some(channel[frame]).filter(|sample| sample.is_finite());
                let format = self.layout.format;
                format.encode(sample.unwrap_or(0.0), &mut self.waiting);
            }
        }
        if self.waiting.len() >= second_len {
            self.write_out()?;
        }
        Ok(())
    }

    /// Writes the waiting samples and, when they are on the disk, a header that counts them.
    fn write_out(&mut self) -> Result<()> {
        let (taken, written) = self.write_waiting();
        // On a full disk the last frame may be incomplete.
        let whole = taken - taken % usize::from(self.layout.frame_len());
        self.waiting.clear();
        // The header comes last: it must never count samples that a loss of power may take.
        let synced = self.file.sync();
        let counted = synced.and_then(|()| self.write_header(self.data_len + whole as u32));
        written.and(counted).map_err(|reason| {
            self.is_closed = true;
            Error::io(&self.name, reason)
        })
    }

    /// Writes the waiting samples behind those that the header counts; returns the number of bytes that were written, too.
    fn write_waiting(&mut self) -> (usize, io::Result<()>) {
        let end = HEADER_LEN as u64 + u64::from(self.data_len);
        if let Err(reason) = self.file.seek(SeekFrom::Start(end)) {
            return (0, Err(reason));
        }
        let mut taken = 0;
        while taken < self.waiting.len() {
            match self.file.write(&self.waiting[taken..]) {
                Ok(0) => return (taken, Err(io::ErrorKind::WriteZero.into())),
                Ok(count) => taken += count,
                Err(reason) if reason.kind() == io::ErrorKind::Interrupted => {}
                Err(reason) => return (taken, Err(reason)),
            }
        }
        // In WAV files a chunk of odd length is padded by one byte.
        let padding = (self.data_len as usize + taken) % 2;
        (taken, self.file.write_all(&[0][..padding]))
    }

    /// Writes a header that counts `data_len` bytes of samples.
    fn write_header(&mut self, data_len: u32) -> io::Result<()> {
        let more = HEADER_LEN - wav::HEADER_LEN as usize;
        let plain = self.layout.header(data_len, more as u32);
        // Name and size of the samples come last.
        let (format, data) = plain.split_at(plain.len() - 8);
        let lost = lost_chunk::encode(&self.gaps, self.layout.sample_rate_hz);
        let unused = chunk(*b"JUNK", &vec![0; more - lost.len() - 8]);
        self.file.seek(SeekFrom::Start(0))?;
        self.file
            .write_all(&[format, &lost, &unused, data].concat())?;
        self.file.flush()?;
        self.data_len = data_len;
        Ok(())
    }
}

/// Waiting samples are written even if the recorder is dropped because of an error elsewhere.
impl<W: Store> Drop for Recorder<W> {
    fn drop(&mut self) {
        if !self.is_closed && !self.waiting.is_empty() {
            // The error cannot be returned here.
            let _ = self.write_out();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;
    use std::io::Cursor;

    use super::*;
    use crate::{SoundReader, Warning};

    /// A disk with a capacity in bytes, on which written bytes can be overwritten.
    struct Disk {
        content: Cursor<Vec<u8>>,
        capacity: usize,
    }

    impl Write for Disk {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let free = self
                .capacity
                .saturating_sub(self.content.position() as usize);
            match free.min(bytes.len()) {
                0 if !bytes.is_empty() => Err(io::ErrorKind::StorageFull.into()),
                count => self.content.write(&bytes[..count]),
            }
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Store for Disk {
        fn sync(&self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Seek for Disk {
        fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
            self.content.seek(to)
        }
    }

    const RATE_HZ: u32 = 8_000;

    fn recorder(capacity: usize, channels: usize, format: SampleFormat) -> Recorder<Disk> {
        let disk = Disk {
            content: Cursor::default(),
            capacity,
        };
        let layout = WavLayout::new("test", RATE_HZ, channels, format).unwrap();
        Recorder::start("test", layout, disk).unwrap()
    }

    /// The samples of the first channel that a reader gets now.
    fn read(recorder: &Recorder<Disk>) -> Vec<f32> {
        let bytes = recorder.file.content.get_ref().clone();
        let mut source = SoundReader::from_bytes(bytes, "test.wav").unwrap();
        let mut samples = Vec::new();
        while let Some(block) = source.next_block().unwrap() {
            samples.extend_from_slice(block.channel(0));
        }
        assert!(source.warnings().is_empty(), "{:?}", source.warnings());
        samples
    }

    fn ramp(count: usize) -> Vec<f32> {
        (0..count).map(|n| n as f32 / 32_768.0).collect()
    }

    #[test]
    fn all_but_the_last_second_can_be_read_at_any_time() {
        let mut recorder = recorder(usize::MAX, 1, SampleFormat::Int16);
        let ramp = ramp(20_000);
        let mut pushed = 0;
        for block in ramp.chunks(700) {
            recorder.push(&[block]).unwrap();
            pushed += block.len();
            if recorder.saved_s() > 0.0 {
                let seen = read(&recorder);
                assert!(pushed - seen.len() < RATE_HZ as usize);
                assert_eq!(seen, ramp[..seen.len()]);
            }
        }
    }

    #[test]
    fn a_full_disk_leaves_whole_frames_and_says_so_once() {
        for capacity in HEADER_LEN + 16_000..HEADER_LEN + 16_008 {
            let mut recorder = recorder(capacity, 2, SampleFormat::Int16);
            let (left, right) = (ramp(10_000), vec![0.0; 10_000]);
            let refusal = recorder.push(&[&left, &right]).unwrap_err();
            assert!(refusal.to_string().starts_with("test: "), "{refusal}");
            // Four bytes a frame.
            let frames = (capacity - HEADER_LEN) / 4;
            assert_eq!(read(&recorder), left[..frames]);
            assert!((recorder.saved_s() - frames as f64 / 8_000.0).abs() < 1e-12);
            assert!(recorder.push(&[&left, &right]).is_ok());
            assert_eq!(read(&recorder), left[..frames]);
        }
    }

    #[test]
    fn samples_of_odd_length_are_padded_and_the_pad_is_overwritten() {
        let mut recorder = recorder(usize::MAX, 1, SampleFormat::Int8);
        let second = vec![0.5; 8_001];
        for _ in 0..3 {
            recorder.push(&[&second]).unwrap();
            assert_eq!(recorder.file.content.get_ref().len() % 2, 0);
        }
        assert_eq!(read(&recorder), vec![0.5; 24_003]);
    }

    /// At any time, in files of even and odd length.
    #[test]
    fn where_sound_was_lost_is_in_the_file() {
        let known = Gap {
            start_s: 1.5,
            duration_s: 0.25,
            certain: true,
        };
        let unknown = Gap {
            start_s: 4.0,
            duration_s: 0.0,
            certain: false,
        };
        let mut recorder = recorder(usize::MAX, 1, SampleFormat::Int8);
        let second = vec![0.5; 8_001];
        for (gap, expected) in [
            (Some(known), &[known][..]),
            (None, &[known]),
            (Some(unknown), &[known, unknown]),
            (None, &[known, unknown]),
        ] {
            if let Some(gap) = gap {
                recorder.note_gap(gap);
            }
            recorder.push(&[&second]).unwrap();
            let bytes = recorder.file.content.get_ref().clone();
            let stated = u32::from_le_bytes(*bytes[4..].first_chunk().unwrap());
            assert_eq!(stated as usize + 8, bytes.len());
            let source = SoundReader::from_bytes(bytes, "test.wav").unwrap();
            assert_eq!(source.gaps(), expected);
            assert_eq!(source.warnings().len(), expected.len());
        }
    }

    /// Gaps beyond those that fit are joined into one that is uncertain.
    #[test]
    fn gaps_beyond_those_that_fit_are_of_unknown_length() {
        let mut recorder = recorder(usize::MAX, 1, SampleFormat::Int16);
        let gap = |number: usize| Gap {
            start_s: number as f64 / 8.0,
            duration_s: 0.0625,
            certain: true,
        };
        (0..=MAX_GAPS).for_each(|number| recorder.note_gap(gap(number)));
        recorder.push(&[&ramp(24 * 8_000)]).unwrap();
        let bytes = recorder.file.content.get_ref().clone();
        let source = SoundReader::from_bytes(bytes, "test.wav").unwrap();
        let (last, before) = source.gaps().split_last().unwrap();
        let expected: Vec<Gap> = (0..MAX_GAPS - 1).map(gap).collect();
        assert_eq!(before, expected);
        let joined = Gap {
            duration_s: 0.1875,
            certain: false,
            ..gap(MAX_GAPS - 1)
        };
        assert_eq!(*last, joined);
    }

    #[test]
    fn a_file_takes_no_more_than_it_may() {
        let mut recorder = recorder(usize::MAX, 1, SampleFormat::Int16).with_size_limit(2 * 10_000);
        recorder.push(&[&ramp(9_000)]).unwrap();
        assert_eq!(recorder.room_frames(), 1_000);
        recorder.push(&[&ramp(1_001)]).unwrap_err();
        assert_eq!(read(&recorder), ramp(9_000));
    }

    /// A call of a recorder to a disk.
    #[derive(Debug)]
    enum Asked {
        Write(usize, Vec<u8>),
        Sync,
    }

    /// A disk that records these calls.
    #[derive(Default)]
    struct Log {
        asked: RefCell<Vec<Asked>>,
        at: usize,
    }

    impl Write for Log {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.asked
                .get_mut()
                .push(Asked::Write(self.at, bytes.to_vec()));
            self.at += bytes.len();
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Seek for Log {
        fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
            let SeekFrom::Start(at) = to else {
                return Err(io::ErrorKind::Unsupported.into());
            };
            self.at = at as usize;
            Ok(at)
        }
    }

    impl Store for Log {
        fn sync(&self) -> io::Result<()> {
            self.asked.borrow_mut().push(Asked::Sync);
            Ok(())
        }
    }

    /// Each page that was written since the last sync may have its old or its new content, whatever the order in which
    /// the disk wrote them.
    #[test]
    fn a_loss_of_power_leaves_no_recording_that_looks_whole_and_is_not() {
        const PAGE: usize = 4096;
        let overwrite = |disk: &mut Vec<u8>, at: usize, bytes: &[u8]| {
            disk.resize(disk.len().max(at + bytes.len()), 0);
            disk[at..at + bytes.len()].copy_from_slice(bytes);
        };
        let lost = Gap {
            start_s: 1.5,
            duration_s: 0.25,
            certain: true,
        };
        // No sample is zero, so that a page that was never written, which has zeros, is recognised.
        let sound: Vec<f32> = ramp(36_001)[1..].iter().map(|it| it / 2.0).collect();
        let layout = WavLayout::new("test", RATE_HZ, 1, SampleFormat::Int24).unwrap();
        let mut recorder = Recorder::start("test", layout, Log::default()).unwrap();
        for (number, block) in sound.chunks(1_000).enumerate() {
            if number == 12 {
                recorder.note_gap(lost);
            }
            recorder.push(&[block]).unwrap();
        }
        recorder.write_out().unwrap();
        recorder.file.sync().unwrap();
        let asked = recorder.file.asked.take();

        let (mut disk, mut pages) = (Vec::new(), Vec::<(usize, &[u8])>::new());
        // Bytes of sound that were written, and how many of them at the last sync.
        let (mut written, mut synced, mut tried) = (0, 0, 0);
        for asked in &asked {
            match asked {
                Asked::Sync => {
                    for (at, page) in std::mem::take(&mut pages) {
                        overwrite(&mut disk, at, page);
                    }
                    let counted = disk[PAGE - 4..PAGE].first_chunk().unwrap();
                    assert_eq!(u32::from_le_bytes(*counted), synced);
                    synced = written;
                }
                Asked::Write(at, bytes) => {
                    written += if *at < PAGE { 0 } else { bytes.len() as u32 };
                    let mut rest = bytes.as_slice();
                    while !rest.is_empty() {
                        let at = at + bytes.len() - rest.len();
                        let page = rest.split_off(..rest.len().min(PAGE - at % PAGE));
                        pages.push((at, page.unwrap()));
                    }
                }
            }
            for kept in 0..1_u32 << pages.len() {
                let mut left = disk.clone();
                for (number, (at, page)) in pages.iter().enumerate() {
                    if kept >> number & 1 == 1 {
                        overwrite(&mut left, *at, page);
                    }
                }
                tried += 1;
                let certain = match disk.get(PAGE - 4..PAGE) {
                    Some(counted) => u32::from_le_bytes(*counted.first_chunk().unwrap()) / 3,
                    None => 0,
                };
                assert_is_beginning(left, certain as usize, &sound, lost);
            }
        }
        assert!(tried > 500, "{tried} disks");
    }

    /// The file is the beginning of the recording, at least its `certain` frames, with the place where sound was
    /// lost; or it is reported as cut short, or cannot be read.
    fn assert_is_beginning(left: Vec<u8>, certain: usize, sound: &[f32], lost: Gap) {
        let Ok(mut source) = SoundReader::from_bytes(left, "test.wav") else {
            assert_eq!(certain, 0);
            return;
        };
        let mut samples = Vec::new();
        while let Some(block) = source.next_block().unwrap() {
            samples.extend_from_slice(block.channel(0));
        }
        let alike = std::iter::zip(&samples, sound)
            .take_while(|(a, b)| (*a - *b).abs() < 1e-6)
            .count();
        assert!(alike >= certain, "{alike} of {certain}");
        let is_warned = source
            .warnings()
            .iter()
            .any(|it| matches!(it, Warning::Truncated { .. }));
        if !is_warned {
            assert_eq!(alike, samples.len());
            let has_gap = samples.len() as f64 / f64::from(RATE_HZ) > lost.start_s;
            assert_eq!(source.gaps(), &[lost][..usize::from(has_gap)]);
        }
    }

    #[test]
    fn samples_that_are_not_numbers_become_silence() {
        let mut recorder = recorder(usize::MAX, 1, SampleFormat::Float32);
        let samples = [f32::NAN, 0.5, f32::INFINITY].repeat(3_000);
        recorder.push(&[&samples]).unwrap();
        assert_eq!(read(&recorder)[..3], [0.0, 0.5, 0.0]);
    }
}
