//! A file to the drops in it.

use std::ops::Range;
use std::path::Path;
use std::time::Duration;

use bouncelab::analysis::{self, Drop, Options};
use bouncelab::detection::{Detection, Detector, Envelope};
use bouncelab::onset;
use bouncelab_audio::{Input, Source};
use bouncelab_report::document::{Document, Origin};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use super::edit::{Unanalysed, edit};
use crate::doubt;
use crate::failure::Failure;
use crate::physics::Physics;

/// What the person says of the recording.
#[derive(Default)]
pub(crate) struct Heeded {
    /// The channel to listen to, the first being 1.
    pub(crate) channel: Option<usize>,
    /// The frequencies to listen to, in Hz.
    pub(crate) band_hz: Option<Range<f64>>,
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
    pub(crate) drops: Vec<Drop>,
    /// How sure it is that each is a drop.
    pub(crate) probabilities: Vec<f64>,
    /// Why there is none.
    pub(crate) no_drop: Option<String>,
    /// What is odd about the file.
    pub(crate) warnings: Vec<String>,
    /// Loudness over time, if it is a recording.
    pub(crate) envelope: Option<Envelope>,
    /// Where the impacts stand out most, if it is a recording with a drop.
    pub(crate) clearest: Option<Clearest>,
}

/// A band in which impacts stand out of what went before.
pub(crate) struct Clearest {
    /// Its frequencies in Hz.
    pub(crate) band_hz: Range<f64>,
    /// By how much they do so, in dB.
    pub(crate) above_db: f64,
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
pub(crate) fn hear(file: &Path, heeded: &Heeded, settings: &Options) -> Result<Hearing, Failure> {
    let name = file.display().to_string();
    match Input::open(file)? {
        Input::Times(times_s) => Ok(hear_times(name, &times_s, heeded, settings)),
        Input::Sound(source) => hear_sound(name, *source, heeded, settings),
    }
}

/// A list of times is one drop: whoever made it has chosen.
fn hear_times(name: String, times_s: &[f64], heeded: &Heeded, settings: &Options) -> Hearing {
    let mut drops = vec![Unanalysed::by_hand(times_s)];
    let mut warnings = edit(&mut drops, &heeded.exclude_s, &heeded.include_s);
    drops.retain(Unanalysed::has_a_flight);
    let no_drop = drops.is_empty().then(|| analysis::TOO_FEW_TIMES.to_owned());
    Hearing {
        name,
        origin: Origin::Times,
        probabilities: drops.iter().map(|drop| drop.probability).collect(),
        drops: analyze(drops, settings, &mut warnings),
        no_drop,
        warnings,
        envelope: None,
        clearest: None,
    }
}

fn hear_sound(
    name: String,
    source: Source,
    heeded: &Heeded,
    settings: &Options,
) -> Result<Hearing, Failure> {
    let recording = Recording {
        name,
        format: source.format(),
        sample_rate_hz: source.sample_rate_hz(),
        channels: source.channels(),
        channel: heeded.channel,
    };
    let (heard, warnings) = listen(source, heeded)?;
    let edit = |drops: &mut Vec<_>| edit(drops, &heeded.exclude_s, &heeded.include_s);
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
        heard: Detection,
        mut warnings: Vec<String>,
        edit: impl FnOnce(&mut Vec<Unanalysed>) -> Vec<String>,
        settings: &Options,
    ) -> Hearing {
        warnings.extend(heard.remarks());
        let trains = heard.found.trains.iter();
        let mut drops: Vec<Unanalysed> = trains.map(Unanalysed::from).collect();
        warnings.extend(edit(&mut drops));
        drops.retain(Unanalysed::has_a_flight);
        let no_drop = drops.is_empty().then(|| {
            let reason = heard.no_drop().map(|reason| reason.to_string());
            reason.unwrap_or_else(|| NOTHING_LEFT.to_owned())
        });
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
            probabilities: drops.iter().map(|drop| drop.probability).collect(),
            drops: analyze(drops, settings, &mut warnings),
            no_drop,
            warnings,
            clearest: self.clearest(&heard),
            envelope: Some(heard.envelope),
        }
    }

    fn clearest(&self, heard: &Detection) -> Option<Clearest> {
        let (band, above_db) = heard.clearest_band()?;
        let band_hz = onset::bands_hz(self.sample_rate_hz).get(band)?.clone();
        Some(Clearest { band_hz, above_db })
    }
}

/// Why there is no drop where one was heard.
const NOTHING_LEFT: &str = "so many impacts of what was heard were left out that no flight is left";

/// Analyses drops, side by side unless somebody hears recordings side by side already; doubts about
/// what was stated go to the warnings.
fn analyze(drops: Vec<Unanalysed>, settings: &Options, warnings: &mut Vec<String>) -> Vec<Drop> {
    let starts_s: Vec<f64> = drops.iter().map(Unanalysed::start_s).collect();
    let one = |drop: Unanalysed| {
        let settings = settings_of_drop(settings, drop.start_s(), &starts_s);
        analysis::analyze(drop.impacts, &settings)
    };
    let drops: Vec<Drop> = if rayon::current_thread_index().is_some() {
        drops.into_iter().map(one).collect()
    } else {
        let waiting = inferring(&drops, settings);
        let analysed = drops.into_par_iter().map(one).collect();
        waiting.finish_and_clear();
        analysed
    };
    warnings.extend(doubts(&drops, settings));
    warnings.extend(nothing_released(settings, &starts_s));
    drops
}

/// What is stated of the drop that begins at a time, given when all begin: a release is of the drop
/// that begins next after it.
pub(crate) fn settings_of_drop(settings: &Options, start_s: f64, starts_s: &[f64]) -> Options {
    let mut settings = settings.clone();
    let is_its_own = |released_s: f64| {
        let is_between = |&start: &f64| released_s < start && start < start_s;
        released_s < start_s && !starts_s.iter().any(is_between)
    };
    let release = settings.priors.release_s;
    settings.priors.release_s = release.filter(|it| is_its_own(it.value));
    settings
}

/// What to say if a release was stated and no drop begins after it.
pub(crate) fn nothing_released(settings: &Options, starts_s: &[f64]) -> Option<String> {
    let released_s = settings.priors.release_s?.value;
    let is_told = starts_s.iter().any(|&start_s| released_s < start_s);
    (!is_told && !starts_s.is_empty())
        .then(|| format!("the release at {released_s} s is left out: no drop begins after it"))
}

/// What was stated that does not go with what was heard, once for each.
fn doubts(drops: &[Drop], settings: &Options) -> Option<String> {
    let stated_m = settings.priors.drop_height_m?.value;
    drops
        .iter()
        .find_map(|drop| doubt::of_height(stated_m, drop))
}

/// Listens to the whole recording; returns also what was wrong with the file.
fn listen(mut source: Source, heeded: &Heeded) -> Result<(Detection, Vec<String>), Failure> {
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
    let mut listener = match &heeded.band_hz {
        None => Detector::new(source.sample_rate_hz(), ears.len()),
        Some(band_hz) => Detector::within(source.sample_rate_hz(), ears.len(), band_hz)
            .map_err(|reason| Failure::Usage(format!("{}: {reason}", source.name())))?,
    };
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
    bar.enable_steady_tick(TICK);
    bar
}

/// A sign of life while so many impacts are inferred from that it takes seconds; it hides itself as
/// the bar does.
fn inferring(drops: &[Unanalysed], settings: &Options) -> ProgressBar {
    /// About two milliseconds each.
    const MANY: usize = 1000;
    let impacts: usize = drops.iter().map(|drop| drop.impacts.len()).sum();
    if settings.inference.is_none() || impacts < MANY {
        return ProgressBar::hidden();
    }
    let spinner = ProgressBar::new_spinner();
    spinner.set_message(format!(
        "inferring from {impacts} impacts (--no-inference leaves it out)"
    ));
    spinner.enable_steady_tick(TICK);
    spinner
}

/// How often what shows progress moves.
const TICK: Duration = Duration::from_millis(200);

#[cfg(test)]
mod tests {
    use bouncelab::inference::{InferenceOptions, Measured, SamplerConfig};

    use super::*;

    /// Of drops that begin at 0 s and 10 s, whether what is told uses a release at this time (it
    /// shows whether impacts were missed before the first one heard), and the warnings.
    fn released_at(release_s: f64) -> (Vec<bool>, Vec<String>) {
        let drop = |start_s: f64| {
            let times = [0.0, 0.45, 0.86, 1.23, 1.57].map(|time_s| start_s + time_s);
            Unanalysed::by_hand(&times)
        };
        let mut settings = Options::default();
        settings.priors.release_s = Some(Measured {
            value: release_s,
            sd: 0.005,
        });
        let sampler = SamplerConfig {
            draws: 100,
            seed: 1,
        };
        settings.inference = Some(InferenceOptions {
            sampler,
            ..InferenceOptions::default()
        });
        let mut warnings = Vec::new();
        let drops = analyze(vec![drop(0.0), drop(10.0)], &settings, &mut warnings);
        let told = drops.iter().map(|drop| drop.estimate.as_ref().unwrap());
        let uses = told.map(|found| found.missed_first.is_some()).collect();
        (uses, warnings)
    }

    #[test]
    fn a_release_is_of_the_drop_that_begins_next() {
        assert_eq!(released_at(9.75), (vec![false, true], Vec::new()));
        assert_eq!(released_at(-0.25), (vec![true, false], Vec::new()));
    }

    #[test]
    fn a_release_after_every_drop_is_of_none_and_that_is_said() {
        let (uses, warnings) = released_at(20.0);
        assert_eq!(uses, [false, false]);
        assert!(
            warnings[0].contains("no drop begins after it"),
            "{warnings:?}"
        );
    }
}
