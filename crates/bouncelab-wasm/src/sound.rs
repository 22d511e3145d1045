//! What is heard in sound, and what does it look like?

use bouncelab::analysis::{self, Impact};
use bouncelab::detection::{Detection, Detector};
use bouncelab::onset::OnsetDetector;
use bouncelab::regression::{self, NumberedFlight};
use bouncelab::train::{self, Train};
use bouncelab_audio::times;
use bouncelab_report::document::Origin;

use crate::pyramid::{Level, Pyramid};
use crate::refusal::Result;
use crate::settings::setting;
use crate::wire::{self, HeardDrop, Mark, OnsetFound, SoFar};

/// Hears sound as it comes.
pub struct Ear {
    listener: Detector,
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

/// What is known of a recording besides its sound.
pub struct Label {
    /// Its name.
    pub name: String,
    /// Its format in words.
    pub format: String,
    /// What is odd about the file.
    pub warnings: Vec<String>,
}

impl Ear {
    /// An ear for so many channels, which listens to one of them (counted from 1) or to all.
    ///
    /// # Errors
    ///
    /// If there is no channel of this number.
    pub fn new(sample_rate_hz: u32, channels: usize, channel: Option<usize>) -> Result<Self> {
        if let Some(number) = channel.filter(|number| !(1..=channels).contains(number)) {
            return Err(setting(&format!(
                "the recording has {channels} channels, so there is no channel {number}"
            )));
        }
        let channel = channel.map(|number| number - 1);
        let heard = if channel.is_some() { 1 } else { channels };
        Ok(Self {
            listener: Detector::new(sample_rate_hz, heard),
            pyramids: vec![Pyramid::default(); channels],
            channel,
            sample_rate_hz,
            frames: 0,
            judged_onsets: 0,
            trains: Vec::new(),
        })
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
    pub fn finish(mut self, label: Label) -> (wire::Heard, Vec<Level>) {
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
        (told(label.name, origin, &heard, label.warnings), levels)
    }
}

fn told(name: String, source: Origin, heard: &Detection, mut warnings: Vec<String>) -> wire::Heard {
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

/// Reads a list of times; the ending of its name says how.
///
/// # Errors
///
/// If it is none.
pub fn times(content: &[u8], name: &str) -> Result<wire::Heard> {
    Ok(of_times(name, &times::parse(content, name)?))
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

/// The onset nearest to a time in samples that begin at `start_s`.
pub fn onset_near(
    samples: &[f32],
    sample_rate_hz: u32,
    start_s: f64,
    time_s: f64,
) -> Option<OnsetFound> {
    let mut onsets = Vec::new();
    let mut detector = OnsetDetector::new(sample_rate_hz);
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
