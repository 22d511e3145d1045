//! A file to the drops in it.

use std::path::Path;
use std::time::Duration;

use bouncelab::analysis::{self, Analysis, Impact, Settings};
use bouncelab::listen::{Envelope, Heard, Listener};
use bouncelab::train::FEWEST_IMPACTS;
use bouncelab_audio::{Input, Source};
use bouncelab_report::document::{Document, Origin};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::doubt;
use crate::failure::Failure;
use crate::physics::Physics;

/// What the person says of the recording.
#[derive(Default)]
pub(crate) struct Heeded {
    /// The channel to listen to, the first being 1.
    pub(crate) channel: Option<usize>,
    /// Times of impacts to leave out.
    pub(crate) exclude_s: Vec<f64>,
    /// Times of impacts to add.
    pub(crate) include_s: Vec<f64>,
    /// Whether to show no progress: somebody else does.
    pub(crate) quiet: bool,
}

/// What a file says.
pub(crate) struct Hearing {
    /// The name of the file as given.
    pub(crate) name: String,
    /// Where the times come from.
    pub(crate) origin: Origin,
    /// The drops, in order of time.
    pub(crate) drops: Vec<Analysis>,
    /// How sure it is that each is a drop.
    pub(crate) probabilities: Vec<f64>,
    /// Why there is none.
    pub(crate) no_drop: Option<String>,
    /// What is odd about the file.
    pub(crate) warnings: Vec<String>,
    /// Loudness over time, if it is a recording.
    pub(crate) envelope: Option<Envelope>,
}

impl Hearing {
    /// The result for other programs.
    pub(crate) fn document(&self, physics: &Physics) -> Document {
        let document = Document::new(
            &self.name,
            self.origin.clone(),
            &physics.settings,
            physics.assumptions.clone(),
            &self.drops,
            self.warnings.clone(),
        );
        match &self.no_drop {
            Some(reason) => document.without_drop(reason),
            None => document,
        }
    }
}

/// Reads a file and analyses every drop in it.
pub(crate) fn hear(file: &Path, heeded: &Heeded, settings: &Settings) -> Result<Hearing, Failure> {
    let name = file.display().to_string();
    match Input::open(file)? {
        Input::Times(times_s) => Ok(hear_times(name, &times_s, heeded, settings)),
        Input::Sound(source) => hear_sound(name, *source, heeded, settings),
    }
}

/// A list of times is one drop: whoever made it has chosen.
fn hear_times(name: String, times_s: &[f64], heeded: &Heeded, settings: &Settings) -> Hearing {
    let mut drops = vec![analysis::impacts_of_times(times_s)];
    let mut warnings = edit(&mut drops, heeded);
    let no_drop = (drops.concat().len() < 2).then(|| analysis::TOO_FEW_TIMES.to_owned());
    if no_drop.is_some() {
        drops.clear();
    }
    let probabilities = vec![1.0; drops.len()];
    let drops = analyze(drops, settings);
    warnings.extend(doubts(&drops, settings));
    Hearing {
        name,
        origin: Origin::Times,
        probabilities,
        drops,
        no_drop,
        warnings,
        envelope: None,
    }
}

fn hear_sound(
    name: String,
    source: Source,
    heeded: &Heeded,
    settings: &Settings,
) -> Result<Hearing, Failure> {
    let recording = Recording {
        name,
        format: source.format(),
        sample_rate_hz: source.sample_rate_hz(),
        channels: source.channels(),
        channel: heeded.channel,
    };
    let (heard, warnings) = listen(source, heeded)?;
    let edit = |drops: &mut Vec<Vec<Impact>>| edit(drops, heeded);
    Ok(recording.hearing(heard, warnings, edit, settings))
}

/// What is known of a recording before anything is heard in it.
#[derive(Clone)]
pub(crate) struct Recording {
    /// What it is called in results.
    pub(crate) name: String,
    /// Its format in words.
    pub(crate) format: String,
    /// Samples a second.
    pub(crate) sample_rate_hz: u32,
    /// How many channels it has.
    pub(crate) channels: usize,
    /// The only channel that is listened to, the first being 1.
    pub(crate) channel: Option<usize>,
}

impl Recording {
    /// Analyses every drop that was heard in it, after `edit`, which may change the impacts and
    /// returns what it has to say.
    pub(crate) fn hearing(
        &self,
        heard: Heard,
        mut warnings: Vec<String>,
        edit: impl FnOnce(&mut Vec<Vec<Impact>>) -> Vec<String>,
        settings: &Settings,
    ) -> Hearing {
        warnings.extend(heard.remarks());
        let trains = &heard.found.trains;
        let mut drops: Vec<Vec<Impact>> = trains
            .iter()
            .map(|train| train.impacts().iter().map(Impact::from).collect())
            .collect();
        let mut probabilities: Vec<f64> = trains
            .iter()
            .map(bouncelab::train::Train::probability)
            .collect();
        warnings.extend(edit(&mut drops));
        // A drop added by hand is as sure as the hand.
        probabilities.resize(drops.len(), 1.0);
        let no_drop = heard
            .no_drop()
            .filter(|_| drops.is_empty())
            .map(|reason| reason.to_string());
        let drops = analyze(drops, settings);
        warnings.extend(doubts(&drops, settings));
        Hearing {
            name: self.name.clone(),
            origin: Origin::Sound {
                format: self.format.clone(),
                sample_rate_hz: self.sample_rate_hz,
                channels: self.channels,
                channel: self.channel.unwrap_or(heard.channel + 1),
                duration_s: heard.duration_s,
                onsets: heard.onsets,
            },
            probabilities,
            drops,
            no_drop,
            warnings,
            envelope: Some(heard.envelope),
        }
    }
}

/// Analyses drops, side by side unless somebody hears recordings side by side already.
fn analyze(drops: Vec<Vec<Impact>>, settings: &Settings) -> Vec<Analysis> {
    let one = |impacts| analysis::analyze(impacts, settings);
    if rayon::current_thread_index().is_some() {
        return drops.into_iter().map(one).collect();
    }
    drops.into_par_iter().map(one).collect()
}

/// What was stated that does not go with what was heard, once for each.
fn doubts(drops: &[Analysis], settings: &Settings) -> Option<String> {
    let stated_m = settings.knowledge.drop_height_m?.value;
    drops
        .iter()
        .find_map(|drop| doubt::of_height(stated_m, drop))
}

/// Listens to the whole recording; returns also what was wrong with the file.
fn listen(mut source: Source, heeded: &Heeded) -> Result<(Heard, Vec<String>), Failure> {
    let channel = heeded.channel;
    if let Some(channel) = channel.filter(|&channel| channel > source.channels()) {
        return Err(Failure::Usage(format!(
            "{} has {} channel{}, so there is no channel {channel}",
            source.name(),
            source.channels(),
            if source.channels() == 1 { "" } else { "s" }
        )));
    }
    let ears = channel.map_or(0..source.channels(), |channel| channel - 1..channel);
    let rate = f64::from(source.sample_rate_hz());
    let mut listener = Listener::new(source.sample_rate_hz(), ears.len());
    let progress = progress(source.duration_s().filter(|_| !heeded.quiet));
    let mut frames = 0;
    while let Some(block) = source.next_block()? {
        let slices: Vec<&[f32]> = ears.clone().map(|ear| block.channel(ear)).collect();
        listener.push(&slices);
        frames += block.frames();
        progress.set_position((frames as f64 / rate) as u64);
    }
    progress.finish_and_clear();
    let warnings = source.warnings().iter().map(ToString::to_string).collect();
    Ok((listener.finish(), warnings))
}

/// A bar for recordings long enough to wait for; it hides itself when stderr is no terminal.
fn progress(duration_s: Option<f64>) -> ProgressBar {
    const LONG_S: f64 = 300.0;
    let Some(duration_s) = duration_s.filter(|&duration_s| duration_s > LONG_S) else {
        return ProgressBar::hidden();
    };
    let bar = ProgressBar::new(duration_s as u64);
    if let Ok(style) =
        ProgressStyle::with_template("listening {wide_bar} {pos}/{len} s, {eta} left")
    {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// Leaves out and adds impacts by hand: each in the drop in which, or nearest to which, it lies.
fn edit(drops: &mut Vec<Vec<Impact>>, heeded: &Heeded) -> Vec<String> {
    /// An impact farther than this from a drop, in seconds, does not belong to it.
    const REACH_S: f64 = 2.0;
    let mut include_s = heeded.include_s.clone();
    let mut exclude_s = heeded.exclude_s.clone();
    if include_s.is_empty() && exclude_s.is_empty() {
        return Vec::new();
    }
    for impacts in drops.iter_mut().filter(|impacts| !impacts.is_empty()) {
        let (start_s, end_s) = (impacts[0].time_s, impacts[impacts.len() - 1].time_s);
        let near = start_s - REACH_S..=end_s + REACH_S;
        let (own, others) = include_s
            .iter()
            .copied()
            .partition::<Vec<f64>, _>(|t| near.contains(t));
        include_s = others;
        let (edited, unmatched) = analysis::edit(impacts, &exclude_s, &own);
        *impacts = edited;
        exclude_s = unmatched;
    }
    let mut warnings: Vec<String> = exclude_s
        .iter()
        .map(|time_s| format!("there is no impact within 20 ms of {time_s} s to leave out"))
        .collect();
    if include_s.len() >= FEWEST_IMPACTS - 2 {
        include_s.sort_by(f64::total_cmp);
        drops.push(analysis::impacts_of_times(&include_s));
        drops.sort_by(|a, b| a[0].time_s.total_cmp(&b[0].time_s));
    } else {
        warnings.extend(include_s.iter().map(|time_s| {
            format!("{time_s} s lies more than {REACH_S} s from any drop and was not added")
        }));
    }
    drops.retain(|impacts| impacts.len() >= 2);
    warnings
}
