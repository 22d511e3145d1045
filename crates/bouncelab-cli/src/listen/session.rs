//! A session: sound comes, is saved and heard, and drops are analysed one after the other.

use std::thread;
use std::time::Duration;

use bouncelab::analysis::{Drop, Options};
use bouncelab::detection::Detection;
use bouncelab::train::{Train, TrainSearch};

use super::gaps::Gaps;
use super::save::Saver;
use super::screen::{Screen, Status};
use super::sound::{Arrival, Sound};
use super::stop::Stop;
use super::watch::{self, Watch};
use super::{Arguments, Format, summary};
use crate::analyze::{self, Hearing, Recording, Unanalysed};
use crate::failure::Failure;
use crate::physics::Physics;
use crate::report::quoted;

/// A pause while nothing comes.
const PAUSE: Duration = Duration::from_millis(20);

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let priors = &arguments.priors;
    let physics = analyze::physics(&arguments.physics, priors, arguments.flights)?;
    let mut sound = Sound::open(arguments)?;
    let recording = sound.recording(arguments.channel.map(usize::from));
    check_channel(&recording)?;
    let saver = Saver::create(arguments, &recording, sound.sample_format())?;
    let stop = Stop::on_request()?;
    let mut session = Session::new(arguments, physics, recording, saver);
    session.begin();
    let broken = session.listen(&mut sound, &stop);
    session.conclude(sound.warnings())?;
    broken
}

fn check_channel(recording: &Recording) -> Result<(), Failure> {
    let Some(channel) = recording.channel.filter(|&it| it > recording.channels) else {
        return Ok(());
    };
    Err(Failure::Usage(format!(
        "{} has {} channel{}, so there is no channel {channel}",
        recording.name,
        recording.channels,
        if recording.channels == 1 { "" } else { "s" }
    )))
}

struct Session<'a> {
    arguments: &'a Arguments,
    physics: Physics,
    recording: Recording,
    saver: Saver,
    watch: Watch,
    gaps: Gaps,
    screen: Screen,
    /// How many frames were heard, and after how many to end.
    frames: u64,
    last_frame: u64,
    drops: Vec<Told>,
    sameness: Sameness,
}

/// A drop that was told of.
struct Told {
    train: Train,
    analysis: Drop,
}

impl<'a> Session<'a> {
    fn new(
        arguments: &'a Arguments,
        physics: Physics,
        mut recording: Recording,
        saver: Saver,
    ) -> Self {
        let rate_hz = recording.sample_rate_hz;
        let heard_channels = recording.channel.map_or(recording.channels, |_| 1);
        if let (None, Some(file)) = (&arguments.from, saver.files().first()) {
            recording.name = file.display().to_string();
        }
        let last_frame = arguments.seconds.map_or(u64::MAX, |seconds| {
            (seconds * f64::from(rate_hz)).round() as u64
        });
        Self {
            arguments,
            saver,
            watch: Watch::new(rate_hz, heard_channels),
            gaps: Gaps::default(),
            screen: Screen::new(&physics.settings),
            frames: 0,
            last_frame,
            drops: Vec::new(),
            sameness: Sameness::default(),
            physics,
            recording,
        }
    }

    /// Says what is listened to.
    fn begin(&self) {
        let Recording {
            format,
            sample_rate_hz,
            channels,
            ..
        } = &self.recording;
        let rate_khz = f64::from(*sample_rate_hz) / 1000.0;
        let source = match &self.arguments.from {
            Some(file) => file.display().to_string(),
            None => format.clone(),
        };
        let plural = if *channels == 1 { "" } else { "s" };
        let saving = self.saving().map_or_else(
            || "nothing is saved".to_owned(),
            |saving| format!("{saving} as it comes"),
        );
        self.screen.say(&format!(
            "listening to {source}, {rate_khz} kHz, {channels} channel{plural}; {saving}"
        ));
    }

    fn saving(&self) -> Option<String> {
        if self.saver.has_failed() {
            return Some("NOT SAVED".to_owned());
        }
        let file = self.saver.files().last()?;
        Some(format!("saved in {}", file.display()))
    }

    /// Listens until the sound ends, somebody wants it to end, or enough was heard.
    fn listen(&mut self, sound: &mut Sound, stop: &Stop) -> Result<(), Failure> {
        let mut planes = Vec::new();
        while !stop.requested() && !self.has_enough() {
            match sound.next(&mut planes)? {
                Arrival::Sound => self.hear(&planes)?,
                Arrival::Lost(frames) => self.lose(frames)?,
                Arrival::Nothing => thread::sleep(PAUSE),
                Arrival::End => break,
            }
            let saving = self.saving();
            self.screen.draw(&mut Status {
                drops: self.drops.len(),
                saving,
                lost_frames: self.gaps.frames(),
                watch: &mut self.watch,
            });
        }
        Ok(())
    }

    fn has_enough(&self) -> bool {
        let enough = |drops| self.drops.len() as u64 >= drops;
        self.frames >= self.last_frame || self.arguments.drops.is_some_and(enough)
    }

    /// Takes samples of every channel, from one look of the watch to the next.
    fn hear(&mut self, planes: &[Vec<f32>]) -> Result<(), Failure> {
        let frames = planes.first().map_or(0, Vec::len);
        let mut from = 0;
        while from < frames && !self.has_enough() {
            let left = usize::try_from(self.last_frame - self.frames).unwrap_or(usize::MAX);
            let to = frames.min(from + self.watch.frames_until_look().min(left));
            let piece: Vec<&[f32]> = planes.iter().map(|plane| &plane[from..to]).collect();
            self.hear_piece(&piece)?;
            from = to;
        }
        Ok(())
    }

    fn hear_piece(&mut self, channels: &[&[f32]]) -> Result<(), Failure> {
        if let Some(trouble) = self.saver.push(channels) {
            self.screen.say(&trouble);
        }
        let heard = match self.recording.channel {
            Some(channel) => &channels[channel - 1..channel],
            None => channels,
        };
        self.screen.hear(heard);
        let rate_hz = self.recording.sample_rate_hz;
        if self.arguments.from.is_none() && self.sameness.shows(heard, rate_hz) {
            self.screen.say(
                "the microphone gives nothing but silence: is it muted, or the wrong one \
                 (--devices)?",
            );
        }
        self.frames += channels.first().map_or(0, |samples| samples.len()) as u64;
        for heard in self.watch.push(heard) {
            self.tell(heard, Vec::new())?;
        }
        Ok(())
    }

    /// Puts silence in the place of sound that was lost, so that later times hold.
    fn lose(&mut self, frames: u64) -> Result<(), Failure> {
        /// No more than this: no drop goes on after it, in seconds.
        const LONGEST_S: u64 = 10;
        if self.gaps.count() == 0 {
            self.screen.say(
                "sound was lost: the computer was too slow, or the microphone had a fault; \
                 flights across the gap are left out",
            );
        }
        let rate_hz = u64::from(self.recording.sample_rate_hz);
        let from_s = self.watch.now_s();
        let silence = vec![0.0; frames.min(LONGEST_S * rate_hz) as usize];
        self.hear(&vec![silence; self.recording.channels])?;
        self.gaps.note(from_s, self.watch.now_s(), frames);
        Ok(())
    }

    /// Analyses a drop that is over, and tells of it.
    fn tell(&mut self, heard: Detection, warnings: Vec<String>) -> Result<(), Failure> {
        let train = heard.found.trains[0].clone();
        let gaps = &self.gaps;
        let cut = |drops: &mut Vec<Unanalysed>| {
            let cut = drops.iter_mut().map(|drop| gaps.cut(&mut drop.impacts));
            cut.flatten().collect()
        };
        let settings = self.settings_for(&train);
        let mut hearing = self.recording.hearing(heard, warnings, cut, &settings);
        let Some(analysis) = hearing.drops.first().cloned() else {
            for warning in &hearing.warnings {
                self.screen
                    .say(&format!("a drop cannot be analysed: {warning}"));
            }
            return Ok(());
        };
        let known = self
            .drops
            .iter()
            .position(|told| watch::overlap(&told.train, &train));
        let told = Told { train, analysis };
        let index = known.unwrap_or(self.drops.len());
        if known.is_some() {
            let again = format!("drop {} once more, now that all is heard", index + 1);
            hearing.warnings.push(again);
            self.drops[index] = told;
        } else {
            self.drops.push(told);
        }
        self.print(&hearing, index + 1)
    }

    /// What is stated of a drop among those that were told of.
    fn settings_for(&self, train: &Train) -> Options {
        let others = self.drops.iter().map(|told| &told.train);
        let others = others.filter(|other| !watch::overlap(other, train));
        let starts_s: Vec<f64> = others.map(Train::start_s).collect();
        analyze::settings_of_drop(&self.physics.settings, train.start_s(), &starts_s)
    }

    fn print(&self, hearing: &Hearing, number: usize) -> Result<(), Failure> {
        let text = match self.arguments.format {
            Format::Text => {
                let report = analyze::report(hearing, &self.physics, self.arguments.details);
                let space = if number == 1 { "" } else { "\n" };
                format!("{space}── drop {number} ──\n{report}")
            }
            Format::Json => self.json_line(hearing)?,
        };
        Ok(self.screen.print(&text)?)
    }

    fn json_line(&self, hearing: &Hearing) -> Result<String, Failure> {
        let document = hearing.document(&self.physics);
        let line = serde_json::to_string(&document).map_err(std::io::Error::from)?;
        Ok(format!("{line}\n"))
    }

    /// Tells of what was not over when the sound ended, judges all of it once more as a whole,
    /// and sums up.
    fn conclude(mut self, warnings: Vec<String>) -> Result<(), Failure> {
        self.screen.clear();
        if let Some(trouble) = self.saver.finish() {
            self.screen.say(&trouble);
        }
        // The drops that were told of before the file ended do not have them.
        for warning in &warnings {
            self.screen
                .say(&format!("{}: {warning}", self.recording.name));
        }
        let whole = self.watch.whole();
        self.judge_again(&whole, &warnings)?;
        self.tell_losses();
        self.tell_nothing_released();
        self.tell_saved();
        if self.drops.is_empty() {
            return self.tell_nothing(whole, warnings);
        }
        if self.drops.len() > 1 && self.arguments.format == Format::Text {
            let analyses: Vec<&Drop> = self.drops.iter().map(|told| &told.analysis).collect();
            let table = summary::table(&analyses);
            self.screen.print(&format!("\nAll drops:\n\n{table}"))?;
        }
        Ok(())
    }

    fn tell_saved(&self) {
        if self.saver.has_failed() {
            return;
        }
        for file in self.saver.files() {
            self.screen.say(&format!(
                "the sound is in {}; to hear it again: bouncelab analyze {}",
                file.display(),
                quoted(&file.to_string_lossy())
            ));
        }
    }

    fn judge_again(&mut self, whole: &Detection, warnings: &[String]) -> Result<(), Failure> {
        let most = self.arguments.drops.map_or(usize::MAX, |n| n as usize);
        for train in whole.found.trains.iter().take(most) {
            let is_told = self.drops.iter().any(|told| same(&told.train, train));
            if !is_told {
                let only = TrainSearch {
                    trains: vec![train.clone()],
                    ..whole.found.clone()
                };
                let heard = Detection {
                    found: only,
                    ..whole.clone()
                };
                self.tell(heard, warnings.to_vec())?;
            }
        }
        let (drops, screen) = (&mut self.drops, &self.screen);
        drops.retain(|told| {
            let is_in = |trains: &[Train]| trains.iter().any(|it| watch::overlap(it, &told.train));
            let remains = is_in(&whole.found.trains);
            let reason = if is_in(&whole.found.distant) {
                "is a ball far fainter than the others"
            } else {
                "is not believed any more"
            };
            if !remains {
                let start_s = told.train.start_s();
                screen.say(&format!(
                    "the drop at {start_s:.2} s {reason}, now that all is heard, and left out"
                ));
            }
            remains
        });
        drops.sort_by(|a, b| a.train.start_s().total_cmp(&b.train.start_s()));
        Ok(())
    }

    fn tell_losses(&self) {
        let (count, frames) = (self.gaps.count(), self.gaps.frames());
        if count > 0 {
            let lost_s = frames as f64 / f64::from(self.recording.sample_rate_hz);
            self.screen.say(&format!(
                "{frames} samples of each channel ({lost_s:.2} s) were lost in {count} place{}",
                if count == 1 { "" } else { "s" }
            ));
        }
    }

    fn tell_nothing_released(&self) {
        let starts = self.drops.iter().map(|told| told.train.start_s());
        let starts_s: Vec<f64> = starts.collect();
        if let Some(trouble) = analyze::nothing_released(&self.physics.settings, &starts_s) {
            self.screen.say(&trouble);
        }
    }

    /// There was no drop: says why.
    fn tell_nothing(&self, whole: Detection, warnings: Vec<String>) -> Result<(), Failure> {
        let settings = &self.physics.settings;
        let hearing = self
            .recording
            .hearing(whole, warnings, |_| Vec::new(), settings);
        let reason = hearing.no_drop.as_deref().unwrap_or("too much was lost");
        self.screen
            .say(&format!("{}: no drop found: {reason}", hearing.name));
        if self.arguments.format == Format::Json {
            self.screen.print(&self.json_line(&hearing)?)?;
        }
        Err(Failure::Input(String::new()))
    }
}

/// Whether the same impacts are in both, at the same times for all that physics can tell.
fn same(a: &Train, b: &Train) -> bool {
    const SAME_S: f64 = 1e-6;
    a.impacts().len() == b.impacts().len()
        && a.impacts()
            .iter()
            .zip(b.impacts())
            .all(|(a, b)| a.number == b.number && (a.onset.time_s - b.onset.time_s).abs() < SAME_S)
}

/// Notices a microphone that gives the same value all the time.
#[derive(Default)]
struct Sameness {
    value: Option<f32>,
    samples: usize,
    is_over: bool,
}

impl Sameness {
    /// Takes the next samples; whether they show, for the first time, that it does.
    fn shows(&mut self, channels: &[&[f32]], sample_rate_hz: u32) -> bool {
        /// Some take a moment to wake up.
        const PATIENCE_S: usize = 3;
        if self.is_over {
            return false;
        }
        for &sample in channels.iter().copied().flatten() {
            let value = *self.value.get_or_insert(sample);
            self.is_over |= value.to_bits() != sample.to_bits();
        }
        self.samples += channels.first().map_or(0, |samples| samples.len());
        let shows = !self.is_over && self.samples >= PATIENCE_S * sample_rate_hz as usize;
        self.is_over |= shows;
        shows
    }
}

#[cfg(test)]
mod tests {
    use std::ops::Range;

    use bouncelab::impact::Strike;
    use bouncelab::synth::{self, Scene};
    use bouncelab_audio::SampleFormat;
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Only {
        #[command(flatten)]
        arguments: Arguments,
    }

    const RATE_HZ: u32 = 44_100;

    /// What a session says of a sound of which the frames in `lost` never came, though the
    /// microphone reports, if anything, that so many are missing.
    fn session_of(samples: &[f32], lost: Range<usize>, reported: Option<u64>) -> Drop {
        let words = ["listen", "--no-save", "--no-inference", "--drag", "none"];
        let Only { arguments } = Only::parse_from(words);
        let physics = analyze::physics(&arguments.physics, &arguments.priors, None).unwrap();
        let recording = Recording {
            name: "test".to_owned(),
            format: "test".to_owned(),
            sample_rate_hz: RATE_HZ,
            channels: 1,
            channel: None,
        };
        let saver = Saver::create(&arguments, &recording, SampleFormat::Int16).unwrap();
        let mut session = Session::new(&arguments, physics, recording, saver);
        session.hear(&[samples[..lost.start].to_vec()]).unwrap();
        if let Some(frames) = reported {
            session.lose(frames).unwrap();
        }
        session.hear(&[samples[lost.end..].to_vec()]).unwrap();
        assert_eq!(session.drops.len(), 1);
        session.drops.remove(0).analysis
    }

    /// Restitution 0.9, 2.4 m/s at first, 0.5 s before the first impact.
    fn drop_sound() -> Vec<f32> {
        let mut time_s = 0.0;
        let strikes: Vec<Strike> = (0..20)
            .map(|n| {
                let speed_m_s = 2.4 * 0.9_f64.powi(n);
                let strike = Strike { time_s, speed_m_s };
                time_s += 2.0 * 0.9 * speed_m_s / 9.806_65;
                strike
            })
            .collect();
        let scene = Scene {
            tail_s: 5.0,
            ..Scene::default()
        };
        synth::render(&strikes, &scene, 3).unwrap().samples
    }

    fn restitution(drop: &Drop) -> f64 {
        drop.line.as_ref().unwrap().restitution().value
    }

    #[test]
    fn flights_across_lost_sound_are_left_out() {
        let samples = drop_sound();
        let whole = session_of(&samples, 0..0, None);
        assert_eq!(whole.impacts.len(), 20);
        // 30 ms are lost in the fourth flight, at 1.95 s, and are reported right, as of unknown
        // length, or as 20 ms more than they were: it never disturbs the physics.
        let lost = 85_995..87_318;
        for reported in [1323, 0, 1323 + 882] {
            let drop = session_of(&samples, lost.clone(), Some(reported));
            assert!(
                (14..=16).contains(&drop.impacts.len()),
                "{}",
                drop.impacts.len()
            );
            assert!(drop.impacts[0].time_s > 1.95);
            assert_eq!(drop.impacts[0].number, 1);
            assert!(
                (restitution(&drop) - 0.9).abs() < 5e-4,
                "{}",
                restitution(&drop)
            );
        }
    }
}
