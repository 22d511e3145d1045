use std::io::{Read, Seek};
use std::path::Path;
use std::sync::Arc;

use bouncelab::analysis::Plan;
use bouncelab::{Detector, Options, Plain};

use crate::error::{Error, Result};
use crate::source::SoundReader;
use crate::times::{self, Listed, TimeList};
use crate::warning::Warning;
use crate::waveform::Samples;

/// The content of a file: a recording, or impact times that another program or a person measured.
#[derive(Debug)]
pub enum Input {
    /// A recording, opened.
    Sound(Box<SoundReader>),
    /// A list of impact times.
    Times(TimeList),
    /// Samples without times, which are a recording at the rate of
    /// [`DetectionOptions::rate_hz`](bouncelab::detection::DetectionOptions::rate_hz).
    Samples(Samples),
}

impl Input {
    /// Opens a file: as a list of times if its name has one of the [`times::endings`], otherwise
    /// as sound, whose format is recognised by its content. A table of a sampled waveform (times at equal distances, and
    /// one column for each channel) is sound too.
    ///
    /// # Errors
    ///
    /// Those of [`times::read`] and [`SoundReader::open`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        if times::is_list(&path.to_string_lossy()) {
            let name = String::from(Plain::path(path));
            return Self::of_list(&times::bytes(path)?, &name);
        }
        SoundReader::open(path).map(|source| Self::Sound(Box::new(source)))
    }

    /// As [`Input::open`], for content in memory.
    ///
    /// # Errors
    ///
    /// Those of [`times::parse`] and [`SoundReader::from_bytes`].
    pub fn from_bytes(bytes: impl Into<Arc<[u8]>>, name: &str) -> Result<Self> {
        let bytes = bytes.into();
        if times::is_list(name) {
            return Self::of_list(&bytes, name);
        }
        SoundReader::from_bytes(bytes, name).map(|source| Self::Sound(Box::new(source)))
    }

    /// As [`Input::open`], for anything that can be read and searched; its end is the end of the content.
    ///
    /// # Errors
    ///
    /// Those of [`times::parse`] and [`SoundReader::from_reader`].
    pub fn from_reader<R>(reader: R, name: &str) -> Result<Self>
    where
        R: Read + Seek + Send + Sync + 'static,
    {
        if times::is_list(name) {
            return Self::of_list(&times::bytes_of(reader, name)?, name);
        }
        SoundReader::from_reader(reader, name).map(|source| Self::Sound(Box::new(source)))
    }

    /// Reads a file with the name of a list as a list, or as a sampled waveform.
    fn of_list(bytes: &[u8], name: &str) -> Result<Self> {
        match times::listed(bytes, name)? {
            Listed::Times(list) => Ok(Self::Times(list)),
            Listed::Waveform(waveform) => Ok(Self::Sound(Box::new(waveform.source(name)?))),
            Listed::Samples(samples) => Ok(Self::Samples(samples)),
        }
    }

    /// The sound, if it is no list; `rate_hz` is the rate of samples whose file does not state it.
    ///
    /// # Errors
    ///
    /// Those of [`Samples::at`].
    pub fn sound(self, rate_hz: Option<u32>) -> Result<std::result::Result<SoundReader, TimeList>> {
        Ok(match self {
            Self::Sound(source) => Ok(*source),
            Self::Samples(samples) => Ok(samples.at(rate_hz)?),
            Self::Times(list) => Err(list),
        })
    }

    /// Detects the drops; the tasks of the plan analyse them, in threads of the caller.
    ///
    /// After each block of sound `watch` is called with the seconds that were read, and may end the work with
    /// an error of its own.
    ///
    /// # Errors
    ///
    /// Those of [`Samples::at`], [`SoundReader::next_block`] and [`Detector::with_options`], and those of `watch`.
    ///
    /// ```
    /// use bouncelab::Options;
    /// use bouncelab_audio::Input;
    ///
    /// let input = Input::from_bytes(&b"0\n0.4605\n0.8877\n"[..], "drop.txt")?;
    /// let plan = input.plan::<Box<dyn std::error::Error>>(&Options::default(), |_| Ok(()))?;
    /// assert_eq!(plan.tasks().len(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn plan<E: From<Error> + From<bouncelab::Error>>(
        self,
        options: &Options,
        mut watch: impl FnMut(f64) -> std::result::Result<(), E>,
    ) -> std::result::Result<Plan, E> {
        let mut source = match self.sound(options.detection.rate_hz)? {
            Ok(source) => source,
            Err(list) => return Ok(Plan::of_list(&list.times_s, list.origin, options)),
        };
        let (rate_hz, channels) = (source.sample_rate_hz(), source.channels());
        let mut detector = Detector::with_options(rate_hz, channels, &options.detection)?;
        let mut frames = 0;
        while let Some(block) = source.next_block()? {
            let slices: Vec<&[f32]> = (0..channels).map(|number| block.channel(number)).collect();
            detector.push(&slices);
            frames += block.frames();
            watch(frames as f64 / f64::from(rate_hz))?;
        }
        let warnings = source.warnings().iter().map(Warning::diagnostic);
        let mut options = options.clone();
        options.edits.gaps.extend_from_slice(source.gaps());
        let plan = Plan::of_detection(detector.finish(), &options);
        Ok(plan.of_file(&source.format(), warnings))
    }

    /// Duration of the sound in seconds, if the file is sound and states it.
    pub fn duration_s(&self) -> Option<f64> {
        match self {
            Self::Sound(source) => source.duration_s(),
            Self::Times(_) | Self::Samples(_) => None,
        }
    }
}
