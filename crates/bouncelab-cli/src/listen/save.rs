//! Saves the sound while it is recorded.

use std::path::{Path, PathBuf};

use bouncelab::analysis::Gap;
use bouncelab_audio::{Error, Recorder, SampleFormat};
use bouncelab_report::file::sync_name;
use bouncelab_report::messages::Value;
use jiff::Zoned;

use super::sound::SoundInfo;
use super::{Save, Task};
use crate::failure::Failure;
use crate::language::text_with;

/// Saves the sound in a WAV file, and in further ones when that is full.
pub(super) struct Saver {
    /// Where the sound goes; `None` once that failed, or if it is not requested.
    recorder: Option<Recorder>,
    has_failed: bool,
    /// The files so far.
    files: Vec<PathBuf>,
    /// Where sound was lost.
    gaps: Vec<Gap>,
    /// How many frames came before the file, and how many so far.
    before: u64,
    frames: u64,
    sample_rate_hz: u32,
    channels: usize,
    format: SampleFormat,
    /// The size limit of the samples of a file, in bytes; the sound goes on in the next.
    size_limit: u32,
}

impl Saver {
    /// Creates the file of a task, if it saves the sound.
    pub(super) fn create(
        task: &Task,
        recording: &SoundInfo,
        format: SampleFormat,
    ) -> Result<Self, Failure> {
        let mut saver = Self {
            recorder: None,
            has_failed: false,
            files: Vec::new(),
            gaps: Vec::new(),
            before: 0,
            frames: 0,
            sample_rate_hz: recording.sample_rate_hz,
            channels: recording.channels,
            format,
            size_limit: u32::MAX,
        };
        match &task.save {
            Save::Named(file) => saver.open(file.clone())?,
            Save::Nowhere => {}
            Save::Dated => {
                let date = Zoned::now().strftime("bouncelab-%Y-%m-%d-%H%M%S.wav");
                saver
                    .open(unused(Path::new(&date.to_string())))
                    .map_err(|fault| {
                        Failure::Input(format!(
                            "{fault}\n  The sound cannot be saved in the current folder: name a \
                             file in another with --save, or use --no-save."
                        ))
                    })?;
            }
        }
        Ok(saver)
    }

    fn open(&mut self, file: PathBuf) -> Result<(), Error> {
        let recorder = Recorder::create(&file, self.sample_rate_hz, self.channels, self.format)?
            .with_size_limit(self.size_limit);
        // Else the name may be lost with the power; some network drives cannot promise more.
        let _ = sync_name(&file);
        self.recorder = Some(recorder);
        self.files.push(file);
        Ok(())
    }

    /// The files, if the sound is saved at all.
    pub(super) fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// How many gaps were noted.
    pub(super) fn gaps(&self) -> usize {
        self.gaps.len()
    }

    /// Whether saving was requested but failed.
    pub(super) fn has_failed(&self) -> bool {
        self.has_failed
    }

    /// Saves the next samples. If that fails, says why; nothing is saved from then on.
    pub(super) fn push(&mut self, channels: &[&[f32]]) -> Option<String> {
        let frames = channels.first().map_or(0, |samples| samples.len()) as u64;
        let is_full = |recorder: &Recorder| recorder.room_frames() < frames;
        let saved = if self.recorder.as_ref().is_some_and(is_full) {
            self.continue_in_next().and_then(|()| self.write(channels))
        } else {
            self.write(channels)
        };
        self.frames += frames;
        self.heed(saved)
    }

    /// Notes where sound was lost, at a time of the whole recording; the silence in its place is saved as sound.
    pub(super) fn note_gap(&mut self, gap: Gap) {
        self.gaps.push(gap);
        let before_s = self.before as f64 / f64::from(self.sample_rate_hz);
        if let Some(recorder) = &mut self.recorder
            && let Some(gap) = behind(gap, before_s)
        {
            recorder.note_gap(gap);
        }
    }

    fn write(&mut self, channels: &[&[f32]]) -> Result<(), Error> {
        self.recorder
            .as_mut()
            .map_or(Ok(()), |recorder| recorder.push(channels))
    }

    fn continue_in_next(&mut self) -> Result<(), Error> {
        self.recorder.take().map_or(Ok(()), Recorder::finish)?;
        let next = self.files.first().map(|first| unused(first));
        next.map_or(Ok(()), |next| self.open(next))?;
        self.before = self.frames;
        for gap in std::mem::take(&mut self.gaps) {
            self.note_gap(gap);
        }
        Ok(())
    }

    /// Ends the file. If that fails, says why.
    pub(super) fn finish(&mut self) -> Option<String> {
        let finished = self.recorder.take().map_or(Ok(()), Recorder::finish);
        self.has_failed |= finished.is_err();
        finished.err().map(|fault| {
            text_with(
                "listen-end-not-saved",
                &[("fault", fault.to_string().into())],
            )
        })
    }

    fn heed(&mut self, saved: Result<(), Error>) -> Option<String> {
        let fault = saved.err()?;
        self.has_failed = true;
        let saved_s = self.recorder.take().map_or(0.0, |it| it.saved_s());
        let failed = [
            ("fault", fault.to_string().into()),
            ("seconds", Value::fixed(saved_s, 1)),
        ];
        Some(text_with("listen-save-failed", &failed))
    }
}

/// The part of a gap after a time, counted from there.
fn behind(gap: Gap, time_s: f64) -> Option<Gap> {
    let (start_s, end_s) = (gap.start_s - time_s, gap.start_s + gap.duration_s - time_s);
    (end_s >= 0.0).then(|| Gap {
        start_s: start_s.max(0.0),
        duration_s: end_s - start_s.max(0.0),
        ..gap
    })
}

/// This name, or if there is such a file the first of `name-2`, `name-3`, ... that is free.
fn unused(file: &Path) -> PathBuf {
    let numbered = |number: u64| {
        let mut name = file.file_stem().unwrap_or_default().to_owned();
        name.push(format!("-{number}"));
        if let Some(ending) = file.extension() {
            name.push(".");
            name.push(ending);
        }
        file.with_file_name(name)
    };
    let mut candidate = file.to_owned();
    let mut numbers = 2..;
    while candidate.exists()
        && let Some(number) = numbers.next()
    {
        candidate = numbered(number);
    }
    candidate
}

#[cfg(test)]
mod tests {
    use std::fs;

    use bouncelab_audio::SoundReader;
    use tempfile::TempDir;

    use super::*;

    #[test]
    fn when_a_file_is_full_another_goes_on() {
        let folder = TempDir::new().unwrap();
        let mut saver = Saver {
            recorder: None,
            has_failed: false,
            files: Vec::new(),
            gaps: Vec::new(),
            before: 0,
            frames: 0,
            sample_rate_hz: 8000,
            channels: 1,
            format: SampleFormat::Int16,
            // 101 frames: the second block does not fit.
            size_limit: 202,
        };
        // A hundred frames are an eightieth of a second; what is lost reaches into the second file.
        let gap = |start_s, duration_s| Gap {
            start_s,
            duration_s,
            certain: true,
        };
        saver.open(folder.path().join("a.wav")).unwrap();
        assert!(saver.push(&[&[0.25; 100]]).is_none());
        saver.note_gap(gap(0.01, 0.005));
        assert!(saver.push(&[&[0.5; 50]]).is_none());
        assert!(saver.finish().is_none());
        assert!(!saver.has_failed());
        let saved = ["a.wav", "a-2.wav"].map(|name| {
            let source = SoundReader::open(folder.path().join(name)).unwrap();
            (
                source.duration_s().unwrap() * 8000.0,
                source.gaps().to_vec(),
            )
        });
        let expected = [
            (100.0, vec![gap(0.01, 0.005)]),
            (50.0, vec![gap(0.0, 0.0025)]),
        ];
        assert_eq!(saved, expected);
    }

    #[test]
    fn names_that_are_taken_get_a_number() {
        let folder = TempDir::new().unwrap();
        let file = folder.path().join("drop.2.wav");
        assert_eq!(unused(&file), file);
        fs::write(&file, "").unwrap();
        assert_eq!(unused(&file), folder.path().join("drop.2-2.wav"));
        fs::write(unused(&file), "").unwrap();
        assert_eq!(unused(&file), folder.path().join("drop.2-3.wav"));
    }
}
