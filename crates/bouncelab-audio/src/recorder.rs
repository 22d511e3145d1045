//! Writes samples to a WAV file during recording.

use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use bouncelab::Plain;
use bouncelab::analysis::Gap;

use crate::error::{Error, Result};
use crate::lost_chunk;
use crate::wav::{HEADER_LEN, Layout, MOST_DATA, SampleFormat, TOO_LONG};

/// How long sound may be handed over without being on the disk.
const SYNC_EVERY: Duration = Duration::from_secs(1);

/// A WAV file that is written while the sound comes, and can be read at any time.
///
/// Every second of sound is handed to the system together with a header that counts it, sound
/// first, and once a second it waits for the disk. So after a crash of the program or a loss of power,
/// or on a full disk, the file is a whole recording that lacks at most the last two seconds.
/// [`Recorder::finish`] hands over the rest and waits for the disk. Behind the sound stands where some was lost
/// ([`Recorder::note_gap`]), which [`Source`](crate::Source) reads back.
///
/// ```
/// use bouncelab_audio::{Recorder, SampleFormat, Source};
///
/// let path = std::env::temp_dir().join(format!("bouncelab-{}.wav", std::process::id()));
/// let mut recorder = Recorder::create(&path, 44_100, 1, SampleFormat::Int16)?;
/// recorder.push(&[&[0.5; 1000]])?;
/// recorder.push(&[&[0.25; 1000]])?;
/// recorder.finish()?;
/// assert_eq!(Source::open(&path)?.duration_s(), Some(2000.0 / 44_100.0));
/// # std::fs::remove_file(&path).unwrap();
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
#[derive(Debug)]
pub struct Recorder<W: Store = File> {
    name: String,
    layout: Layout,
    file: W,
    /// Encoded samples that were not handed over yet.
    waiting: Vec<u8>,
    /// How many bytes of samples the header counts.
    data_len: u32,
    /// Where sound was lost.
    gaps: Vec<Gap>,
    /// When all that was handed over was last on the disk.
    synced: Instant,
    /// The file took no more.
    is_closed: bool,
}

/// Where a recording is kept.
pub trait Store: Write + Seek {
    /// Waits until all that was written is where it outlives a loss of power.
    ///
    /// # Errors
    /// What the system reports.
    fn sync(&self) -> io::Result<()>;
}

impl Store for File {
    fn sync(&self) -> io::Result<()> {
        self.sync_data()
    }
}

impl Recorder {
    /// Creates the file; one that exists is left alone.
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
        let layout = Layout::new(&name, sample_rate_hz, channels, format)?;
        let file = File::options().write(true).create_new(true).open(path);
        file.and_then(|file| Self::start(&name, layout, file))
            .map_err(|reason| Error::io(&name, reason))
    }

    /// Hands over everything, waits until it is on the disk, and closes the file.
    ///
    /// # Errors
    ///
    /// As for [`Recorder::push`].
    pub fn finish(mut self) -> Result<()> {
        if self.is_closed {
            return Ok(());
        }
        self.hand_over()?;
        self.sync()
    }
}

impl<W: Store> Recorder<W> {
    fn start(name: &str, layout: Layout, mut file: W) -> io::Result<Self> {
        file.write_all(&layout.header(0, 0))?;
        Ok(Self {
            name: name.to_owned(),
            layout,
            file,
            waiting: Vec::new(),
            data_len: 0,
            gaps: Vec::new(),
            synced: Instant::now(),
            is_closed: false,
        })
    }

    /// The file as the caller named it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// How many seconds of sound the file holds for certain.
    pub fn saved_s(&self) -> f64 {
        let frames = self.data_len / u32::from(self.layout.frame_len());
        f64::from(frames) / f64::from(self.layout.sample_rate_hz)
    }

    /// How many frames still fit: a WAV file cannot hold more than 4 GB.
    pub fn room_frames(&self) -> u64 {
        let gaps_len = self.gaps.len() * lost_chunk::GAP_LEN;
        let taken = u64::from(self.data_len) + (self.waiting.len() + gaps_len) as u64;
        u64::from(MOST_DATA).saturating_sub(taken) / u64::from(self.layout.frame_len())
    }

    /// Notes that sound was lost; the silence in its place is pushed as any other sound. It is in the file with the
    /// samples that come next, or at the end.
    pub fn note_gap(&mut self, gap: Gap) {
        if self.room_frames() > lost_chunk::GAP_LEN as u64 {
            self.gaps.push(gap);
        }
    }

    /// Takes the next samples of every channel, in `-1.0..1.0`. What is not a number becomes 0.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if the system fails to write, for example because the disk is full;
    /// [`Error::Unwritable`] if the file cannot grow further. The file then ends with the last whole
    /// frame that it took, its header says so, and nothing more is written: later calls do
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
            self.hand_over()?;
            self.is_closed = true;
            return Err(Error::unwritable(&self.name, TOO_LONG));
        }
        for frame in 0..frames {
            for channel in channels {
                let sample = Some(channel[frame]).filter(|sample| sample.is_finite());
                let format = self.layout.format;
                format.encode(sample.unwrap_or(0.0), &mut self.waiting);
            }
        }
        let second = self.layout.sample_rate_hz as usize * usize::from(self.layout.frame_len());
        if self.waiting.len() >= second {
            self.hand_over()?;
            if self.synced.elapsed() >= SYNC_EVERY {
                self.sync()?;
            }
        }
        Ok(())
    }

    fn sync(&mut self) -> Result<()> {
        self.synced = Instant::now();
        self.file.sync().map_err(|reason| {
            self.is_closed = true;
            Error::io(&self.name, reason)
        })
    }

    /// Hands over what waits, then a header that counts it.
    fn hand_over(&mut self) -> Result<()> {
        let gaps = lost_chunk::encode(&self.gaps, self.layout.sample_rate_hz);
        let (taken, written) = self.write_waiting(&gaps);
        let whole = taken - taken % usize::from(self.layout.frame_len());
        self.data_len += whole as u32;
        self.waiting.clear();
        let behind = if written.is_ok() { gaps.len() } else { 0 };
        let counted = self.write_header(behind as u32);
        written.and(counted).map_err(|reason| {
            self.is_closed = true;
            Error::io(&self.name, reason)
        })
    }

    /// Writes what waits behind what the header counts, and the gaps behind that, which the next samples replace;
    /// also tells how many bytes of samples the file took.
    fn write_waiting(&mut self, gaps: &[u8]) -> (usize, io::Result<()>) {
        let end = u64::from(HEADER_LEN) + u64::from(self.data_len);
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
        // By the rules of the format a chunk of odd length is followed by one more byte.
        let padding = (self.data_len as usize + taken) % 2;
        let padded = self.file.write_all(&[0][..padding]);
        (taken, padded.and_then(|()| self.file.write_all(gaps)))
    }

    /// Writes the header of a file with so many bytes behind the samples.
    fn write_header(&mut self, behind: u32) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(0))?;
        self.file
            .write_all(&self.layout.header(self.data_len, behind))?;
        self.file.flush()
    }
}

/// What waits is handed over even if the recorder is dropped on the way out of a failure.
impl<W: Store> Drop for Recorder<W> {
    fn drop(&mut self) {
        if !self.is_closed && !self.waiting.is_empty() {
            // Nobody is left to be told.
            let _ = self.hand_over();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;
    use crate::Source;

    /// A disk with a capacity of so many bytes, on which what is there can be overwritten.
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
        let layout = Layout::new("test", RATE_HZ, channels, format).unwrap();
        Recorder::start("test", layout, disk).unwrap()
    }

    /// What a reader sees now: the samples of the first channel.
    fn read(recorder: &Recorder<Disk>) -> Vec<f32> {
        let bytes = recorder.file.content.get_ref().clone();
        let mut source = Source::from_bytes(bytes, "test.wav").unwrap();
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
        for capacity in 16_044..16_052 {
            let mut recorder = recorder(capacity, 2, SampleFormat::Int16);
            let (left, right) = (ramp(10_000), vec![0.0; 10_000]);
            let refusal = recorder.push(&[&left, &right]).unwrap_err();
            assert!(refusal.to_string().starts_with("test: "), "{refusal}");
            // Four bytes a frame behind a header of 44.
            let frames = (capacity - 44) / 4;
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
            let said = u32::from_le_bytes(*bytes[4..].first_chunk().unwrap());
            assert_eq!(said as usize + 8, bytes.len());
            let source = Source::from_bytes(bytes, "test.wav").unwrap();
            assert_eq!(source.gaps(), expected);
            assert_eq!(source.warnings().len(), expected.len());
        }
    }

    #[test]
    fn what_is_no_number_becomes_silence() {
        let mut recorder = recorder(usize::MAX, 1, SampleFormat::Float32);
        let samples = [f32::NAN, 0.5, f32::INFINITY].repeat(3_000);
        recorder.push(&[&samples]).unwrap();
        assert_eq!(read(&recorder)[..3], [0.0, 0.5, 0.0]);
    }
}
