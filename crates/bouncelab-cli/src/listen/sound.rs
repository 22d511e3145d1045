//! The source of the sound: a microphone, or a file that is played.

use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use bouncelab::Diagnostic;
use bouncelab::Plain;
use bouncelab::analysis::Gap;
#[cfg(feature = "microphone")]
use bouncelab_audio::microphone::{self, Microphone};
use bouncelab_audio::{Input, SampleFormat, SoundReader, Warning};

use super::Source;
use crate::failure::Failure;

/// Description of a sound before it is analysed.
pub(super) struct SoundInfo {
    /// Its name in results.
    pub(super) name: String,
    /// Its format, or the microphone.
    pub(super) format: String,
    /// Samples a second.
    pub(super) sample_rate_hz: u32,
    /// How many channels it has.
    pub(super) channels: usize,
}

/// Samples as they come.
pub(super) enum Sound {
    File(Box<Player>),
    #[cfg(feature = "microphone")]
    Microphone(Box<Microphone>),
    /// The arrivals of a test: samples, or how many were lost.
    #[cfg(test)]
    Script(u32, std::collections::VecDeque<Result<Vec<f32>, u64>>),
}

/// An arrival.
pub(super) enum Arrival {
    /// Samples.
    Sound,
    /// The number of frames that were lost here, or 0 if it is not known.
    #[cfg_attr(
        not(any(feature = "microphone", test)),
        expect(dead_code, reason = "of a file nothing is lost")
    )]
    Lost(u64),
    /// Nothing yet.
    #[cfg_attr(
        not(feature = "microphone"),
        expect(dead_code, reason = "a file is always there")
    )]
    Nothing,
    /// Nothing more will come.
    End,
}

impl Sound {
    #[cfg(test)]
    pub(super) fn script(rate_hz: u32, comes: Vec<Result<Vec<f32>, u64>>) -> Self {
        Self::Script(rate_hz, comes.into())
    }

    /// Opens a source.
    pub(super) fn open(source: &Source) -> Result<Self, Failure> {
        match &source.from {
            Some(file) => Player::open(file, source.fast),
            None => Self::open_microphone(source),
        }
    }

    #[cfg(feature = "microphone")]
    fn open_microphone(source: &Source) -> Result<Self, Failure> {
        let opened = Microphone::open(source.device.as_deref());
        let microphone = opened.map_err(|fault| {
            Failure::Input(format!(
                "{fault}\n  `bouncelab listen --devices` lists the microphones, `bouncelab listen \
                 --from FILE` plays a recording instead."
            ))
        })?;
        Ok(Self::Microphone(Box::new(microphone)))
    }

    #[cfg(not(feature = "microphone"))]
    fn open_microphone(_: &Source) -> Result<Self, Failure> {
        Err(no_microphone())
    }

    /// Description of the sound before it is analysed.
    pub(super) fn info(&self) -> SoundInfo {
        match self {
            Self::File(player) => SoundInfo {
                name: player.source.name().to_owned(),
                format: player.source.format(),
                sample_rate_hz: player.source.sample_rate_hz(),
                channels: player.source.channels(),
            },
            #[cfg(feature = "microphone")]
            Self::Microphone(microphone) => SoundInfo {
                name: "microphone".to_owned(),
                format: microphone.name().to_owned(),
                sample_rate_hz: microphone.sample_rate_hz(),
                channels: microphone.channels(),
            },
            #[cfg(test)]
            Self::Script(rate_hz, _) => SoundInfo {
                name: "script".to_owned(),
                format: "script".to_owned(),
                sample_rate_hz: *rate_hz,
                channels: 1,
            },
        }
    }

    /// The format of a WAV file that keeps the samples exactly.
    pub(super) fn sample_format(&self) -> SampleFormat {
        match self {
            Self::File(_) => SampleFormat::Float32,
            #[cfg(feature = "microphone")]
            Self::Microphone(microphone) => microphone.format(),
            #[cfg(test)]
            Self::Script(..) => SampleFormat::Float32,
        }
    }

    /// Takes the next arrival, without waiting longer than a moment; samples replace those in
    /// `planes`, one plane for each channel.
    pub(super) fn next(&mut self, planes: &mut Vec<Vec<f32>>) -> Result<Arrival, Failure> {
        match self {
            Self::File(player) => player.next(planes),
            #[cfg(feature = "microphone")]
            Self::Microphone(microphone) => Ok(match microphone.read(planes)? {
                microphone::Arrival::Sound => Arrival::Sound,
                microphone::Arrival::Lost { frames } => Arrival::Lost(frames),
                microphone::Arrival::Nothing => Arrival::Nothing,
            }),
            #[cfg(test)]
            Self::Script(_, comes) => Ok(match comes.pop_front() {
                Some(Ok(samples)) => {
                    *planes = vec![samples];
                    Arrival::Sound
                }
                Some(Err(frames)) => Arrival::Lost(frames),
                None => Arrival::End,
            }),
        }
    }

    /// Whether it arrives in real time: samples that are not taken in time are lost.
    pub(super) fn is_live(&self) -> bool {
        !matches!(self, Self::File(_))
    }

    /// Where a file lacks sound, as far as it was read; the losses of a microphone are arrivals.
    #[cfg_attr(
        not(any(feature = "microphone", test)),
        expect(clippy::unnecessary_wraps, reason = "a microphone has none")
    )]
    pub(super) fn gaps(&self) -> Option<&[Gap]> {
        match self {
            Self::File(player) => Some(player.source.gaps()),
            #[cfg(feature = "microphone")]
            Self::Microphone(_) => None,
            #[cfg(test)]
            Self::Script(..) => None,
        }
    }

    /// The faults of a file, once it has ended.
    pub(super) fn warnings(&self) -> Vec<Diagnostic> {
        match self {
            Self::File(player) => {
                let warnings = player.source.warnings().iter();
                warnings.map(Warning::diagnostic).collect()
            }
            #[cfg(feature = "microphone")]
            Self::Microphone(_) => Vec::new(),
            #[cfg(test)]
            Self::Script(..) => Vec::new(),
        }
    }
}

/// A file that is played, at the pace at which it sounded or as fast as it goes.
pub(super) struct Player {
    source: SoundReader,
    pace: Option<Instant>,
    frames: u64,
}

impl Player {
    fn open(file: &Path, fast: bool) -> Result<Sound, Failure> {
        let source = match Input::open(file)? {
            Input::Sound(source) => *source,
            Input::Times(_) | Input::Samples(_) => {
                return Err(Failure::Usage(format!(
                    "{} is a list of numbers and no recording; use analyze",
                    Plain::path(file)
                )));
            }
        };
        Ok(Sound::File(Box::new(Self {
            source,
            pace: (!fast).then(Instant::now),
            frames: 0,
        })))
    }

    fn next(&mut self, planes: &mut Vec<Vec<f32>>) -> Result<Arrival, Failure> {
        let rate_hz = self.source.sample_rate_hz();
        let Some(block) = self.source.next_block()? else {
            return Ok(Arrival::End);
        };
        planes.resize_with(block.channels(), Vec::new);
        for (channel, plane) in planes.iter_mut().enumerate() {
            plane.clear();
            plane.extend_from_slice(block.channel(channel));
        }
        self.frames += block.frames() as u64;
        if let Some(start) = self.pace {
            thread::sleep(left_to_play(self.frames, rate_hz, start.elapsed()));
        }
        Ok(Arrival::Sound)
    }
}

/// How long `frames` frames play: until the last of them has been played.
fn left_to_play(frames: u64, sample_rate_hz: u32, since_start: Duration) -> Duration {
    let lasts = Duration::from_secs_f64(frames as f64 / f64::from(sample_rate_hz));
    lasts.saturating_sub(since_start)
}

/// Prints the microphones.
#[cfg(feature = "microphone")]
pub(super) fn list_devices() -> Result<(), Failure> {
    use crate::language::{text, translator};
    use bouncelab_report::{Align, Table};

    let devices = microphone::devices()?;
    if devices.is_empty() {
        return Err(Failure::Input(
            "the system lists no microphone; is one plugged in and switched on?".to_owned(),
        ));
    }
    let mut table = Table::with_headings(
        translator(),
        [
            ("listen-device", Align::Left),
            ("listen-device-kind", Align::Left),
            ("", Align::Left),
        ],
    );
    for device in devices {
        let mark = if device.is_default {
            text("listen-device-default")
        } else {
            String::new()
        };
        table.row([device.id, device.description, mark]);
    }
    crate::terminal::print(table)
}

#[cfg(not(feature = "microphone"))]
pub(super) fn list_devices() -> Result<(), Failure> {
    Err(no_microphone())
}

#[cfg(not(feature = "microphone"))]
fn no_microphone() -> Failure {
    let headers = if cfg!(target_os = "linux") {
        "\n  sudo apt install libasound2-dev pkg-config   (Debian, Ubuntu; Fedora: alsa-lib-devel)"
    } else {
        ""
    };
    Failure::Usage(format!(
        "this bouncelab was built without the microphone. Play a recording with --from FILE, or \
         rebuild it:{headers}\n  cargo xtask install"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_played_as_long_as_it_sounded() {
        let left_ms = |since_ms| {
            let left = left_to_play(72_000, 48_000, Duration::from_millis(since_ms));
            left.as_millis()
        };
        assert_eq!([0, 500, 1_500, 9_000].map(left_ms), [1_500, 1_000, 0, 0]);
    }
}
