//! What is heard in sound, and what did it look like?

use bouncelab::analysis::{self, Impact};
use bouncelab::listen::{Heard, Listener};
use bouncelab::onset::Detector;
use bouncelab::regression::{self, NumberedFlight};
use bouncelab::train::{self, Train};
use bouncelab_audio::{Input, Source};
use bouncelab_report::document::Origin;

use crate::pyramid::{Level, Pyramid};
use crate::refusal::Result;
use crate::wire::{self, HeardDrop, Mark, OnsetFound, Refusal, RefusalKind, SoFar};

/// Hears sound as it comes.
pub struct Ear {
    listener: Listener,
    /// One for each channel of the recording.
    pyramids: Vec<Pyramid>,
    /// The only channel that is listened to.
    channel: Option<usize>,
    sample_rate_hz: u32,
    frames: u64,
    /// How many sounds there were when all was last judged, and what was heard then.
    judged_onsets: usize,
    trains: Vec<Train>,
}

/// What a recording is called, and of what format it is.
pub struct Label {
    /// Its name.
    pub name: String,
    /// Its format in words.
    pub format: String,
}

impl Ear {
    /// An ear for so many channels, which listens to one of them (counted from 0) or to all.
    pub fn new(sample_rate_hz: u32, channels: usize, channel: Option<usize>) -> Self {
        let heard = if channel.is_some() { 1 } else { channels };
        Self {
            listener: Listener::new(sample_rate_hz, heard),
            pyramids: vec![Pyramid::default(); channels],
            channel,
            sample_rate_hz,
            frames: 0,
            judged_onsets: 0,
            trains: Vec::new(),
        }
    }

    /// Takes the next samples of each channel.
    pub fn push(&mut self, channels: &[&[f32]]) {
        for (pyramid, samples) in self.pyramids.iter_mut().zip(channels) {
            pyramid.push(samples);
        }
        match self.channel.and_then(|channel| channels.get(channel)) {
            Some(samples) => self.listener.push(&[samples]),
            None => self.listener.push(channels),
        }
        self.frames += channels.first().map_or(0, |samples| samples.len()) as u64;
    }

    fn now_s(&self) -> f64 {
        self.frames as f64 / f64::from(self.sample_rate_hz)
    }

    /// What has been heard so far. It judges all sounds anew only if there are new ones.
    pub fn so_far(&mut self) -> SoFar {
        if self.listener.onsets() != self.judged_onsets {
            self.judged_onsets = self.listener.onsets();
            self.trains = self.listener.so_far().found.trains;
        }
        let last = self.trains.last();
        let rests_at_s = last.map(|train| train::latest_next_s(train.impacts()));
        SoFar {
            duration_s: self.now_s(),
            drop: last.map(heard_drop),
            drops: self.trains.len() as u32,
            restitution: last.and_then(plain_restitution),
            rests_at_s,
            at_rest: rests_at_s.is_some_and(|at_s| self.now_s() > at_s),
        }
    }

    /// Ends the recording: what was heard, and the picture of the channel that is believed.
    pub fn finish(mut self, label: Label, warnings: Vec<String>) -> (wire::Heard, Vec<Level>) {
        let channels = self.pyramids.len();
        let heard = self.listener.finish();
        let believed = self.channel.unwrap_or(heard.channel);
        let levels = self.pyramids.swap_remove(believed).levels();
        let origin = Origin::Sound {
            format: label.format,
            sample_rate_hz: self.sample_rate_hz,
            channels,
            channel: believed + 1,
            duration_s: heard.duration_s,
            onsets: heard.onsets,
        };
        (told(label.name, origin, &heard, warnings), levels)
    }
}

fn told(name: String, source: Origin, heard: &Heard, mut warnings: Vec<String>) -> wire::Heard {
    warnings.extend(heard.remarks());
    wire::Heard {
        name,
        source,
        drops: heard.found.trains.iter().map(heard_drop).collect(),
        no_drop: heard.no_drop().map(|reason| reason.to_string()),
        warnings,
    }
}

fn heard_drop(train: &Train) -> HeardDrop {
    HeardDrop {
        probability: train.probability(),
        impacts: train
            .impacts()
            .iter()
            .map(|impact| Mark::from(Impact::from(impact)))
            .collect(),
    }
}

/// The restitution by the straight line, which takes no time to speak of.
fn plain_restitution(train: &Train) -> Option<f64> {
    let flights: Vec<NumberedFlight> = train
        .impacts()
        .windows(2)
        .filter(|pair| pair[1].number == pair[0].number + 1)
        .map(|pair| NumberedFlight {
            number: pair[0].number as usize + 1,
            time_s: pair[1].onset.time_s - pair[0].onset.time_s,
        })
        .collect();
    let line = regression::fit(&flights, bouncelab::gravity::STANDARD_M_S2).ok()?;
    Some(line.restitution().value)
}

/// A file that is being read.
pub struct Opening {
    source: Source,
    ear: Ear,
    label: Label,
}

/// What a file turned out to be.
pub enum Opened {
    /// A list of times: nothing more to do.
    Times(wire::Heard),
    /// Sound, which is to be read block by block.
    Sound(Box<Opening>),
}

/// Opens the content of a file; listens to the channel of this number, the first being 1, or to
/// all.
///
/// # Errors
///
/// If it is neither sound nor a list of times, and if it has no channel of this number.
pub fn open(bytes: Vec<u8>, name: &str, channel: Option<usize>) -> Result<Opened> {
    let source = match Input::from_bytes(bytes, name)? {
        Input::Times(times_s) => return Ok(Opened::Times(of_times(name, &times_s))),
        Input::Sound(source) => *source,
    };
    let channels = source.channels();
    if let Some(number) = channel.filter(|number| !(1..=channels).contains(number)) {
        return Err(Refusal {
            kind: RefusalKind::Setting,
            message: format!("{name} has {channels} channels, so there is no channel {number}"),
        });
    }
    let channel = channel.map(|number| number - 1);
    Ok(Opened::Sound(Box::new(Opening {
        ear: Ear::new(source.sample_rate_hz(), channels, channel),
        label: Label {
            name: name.to_owned(),
            format: source.format(),
        },
        source,
    })))
}

/// A list of times is one drop: whoever made it has chosen.
fn of_times(name: &str, times_s: &[f64]) -> wire::Heard {
    let impacts = analysis::impacts_of_times(times_s);
    let too_few = impacts.len() < 2;
    let drop = HeardDrop {
        probability: 1.0,
        impacts: impacts.into_iter().map(Mark::from).collect(),
    };
    wire::Heard {
        name: name.to_owned(),
        source: Origin::Times,
        drops: if too_few { Vec::new() } else { vec![drop] },
        no_drop: too_few.then(|| analysis::TOO_FEW_TIMES.to_owned()),
        warnings: Vec::new(),
    }
}

impl Opening {
    /// Samples a second.
    pub fn sample_rate_hz(&self) -> u32 {
        self.source.sample_rate_hz()
    }

    /// How many channels it has.
    pub fn channels(&self) -> usize {
        self.source.channels()
    }

    /// Its length in seconds, as far as the file says.
    pub fn duration_s(&self) -> Option<f64> {
        self.source.duration_s()
    }

    /// Hears the next block and adds its samples to those of each channel; `false` at the end.
    ///
    /// # Errors
    ///
    /// If the file cannot be read any further.
    pub fn hear_block(&mut self, samples: &mut [Vec<f32>]) -> Result<bool> {
        let channels = self.source.channels();
        let Some(block) = self.source.next_block()? else {
            return Ok(false);
        };
        let slices: Vec<&[f32]> = (0..channels)
            .map(|channel| block.channel(channel))
            .collect();
        self.ear.push(&slices);
        for (all, slice) in samples.iter_mut().zip(slices) {
            all.extend_from_slice(slice);
        }
        Ok(true)
    }

    /// Ends the reading.
    pub fn finish(self) -> (wire::Heard, Vec<Level>) {
        let warnings = self.source.warnings();
        let warnings = warnings.iter().map(ToString::to_string).collect();
        self.ear.finish(self.label, warnings)
    }
}

/// The onset nearest to a time in samples that begin at `start_s`.
pub fn onset_near(
    samples: &[f32],
    sample_rate_hz: u32,
    start_s: f64,
    time_s: f64,
) -> Option<OnsetFound> {
    let mut onsets = Vec::new();
    let mut detector = Detector::new(sample_rate_hz);
    detector.push(samples, &mut onsets);
    detector.finish(&mut onsets);
    let distance = |onset: &OnsetFound| (onset.time_s - time_s).abs();
    onsets
        .iter()
        .map(|onset| OnsetFound {
            time_s: start_s + onset.time_s,
            sigma_s: onset.sigma_s,
            level_db: onset.level_db,
        })
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
}
