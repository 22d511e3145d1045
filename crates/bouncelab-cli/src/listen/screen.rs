//! The live display on the terminal; nothing if stderr is not a terminal.

use std::time::{Duration, Instant};

use bouncelab::Impact;
use bouncelab::analysis::{self, Options};
use bouncelab_report::messages::Value;
use bouncelab_report::{Quantity, Unit};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::sketch;
use super::watch::{Going, Watch};
use crate::failure::Failure;
use crate::language::{text, text_with, translator};
use crate::terminal::{print, print_data, say};

/// A few lines at the bottom of the terminal that are always up to date.
pub(super) struct Screen {
    bar: ProgressBar,
    drawn: Option<Instant>,
    level: Level,
    /// The options without the inference, which takes too long.
    settings: Options,
}

/// How loud it is.
#[derive(Default)]
struct Level {
    /// The largest sample since the last drawing.
    peak: f32,
    /// Level that the meter shows, in dB relative to full scale.
    shown_db: f64,
    /// How long to go on warning of clipping.
    warn_until: Option<Instant>,
}

/// The state of the session besides the drop.
pub(super) struct Status<'a> {
    /// How many drops are over.
    pub(super) drops: usize,
    /// Where the sound is saved.
    pub(super) saving: Option<String>,
    /// How many frames were lost.
    pub(super) lost_frames: u64,
    pub(super) watch: &'a mut Watch,
}

impl Screen {
    /// How often it is drawn.
    const EVERY: Duration = Duration::from_millis(100);

    pub(super) fn new(settings: &Options) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{msg}") {
            bar.set_style(style);
        }
        Self {
            bar,
            drawn: None,
            level: Level::default(),
            settings: Options {
                inference: None,
                ..settings.clone()
            },
        }
    }

    /// Measures how loud these samples are.
    pub(super) fn measure(&mut self, channels: &[&[f32]]) {
        if self.bar.is_hidden() {
            return;
        }
        let samples = channels.iter().flat_map(|samples| samples.iter());
        self.level.peak = samples.fold(self.level.peak, |peak, sample| peak.max(sample.abs()));
    }

    /// Brings the lines up to date, unless that was done a moment ago.
    pub(super) fn draw(&mut self, status: &mut Status) {
        let now = Instant::now();
        let is_early = self.drawn.is_some_and(|drawn| now - drawn < Self::EVERY);
        if self.bar.is_hidden() || is_early {
            return;
        }
        let pause = self.drawn.map_or(Self::EVERY, |drawn| now - drawn);
        self.drawn = Some(now);
        let mut lines = vec![self.level.line(now, pause), status.line()];
        let number = status.drops + 1;
        if let Some(going) = status.watch.going() {
            lines.extend(self.drop_lines(&going, number));
        }
        self.bar.set_message(lines.join("\n"));
    }

    /// The drop in progress.
    fn drop_lines(&self, going: &Going, number: usize) -> Vec<String> {
        /// Narrow enough for any terminal.
        const WIDTH: usize = 60;
        let impacts: Vec<Impact> = going.impacts.iter().map(Impact::from).collect();
        let drop = analysis::analyze_impacts(impacts, &self.settings);
        let mut lines = Vec::new();
        if let (Some(impact), Some(flight)) = (drop.impacts.last(), drop.flights.last()) {
            let arguments = [
                ("drop", number.into()),
                ("impact", impact.number.into()),
                ("time", Value::fixed(impact.time_s, 2)),
                ("flight", Value::fixed(flight.flight_time_s * 1e3, 0)),
                ("rests", if going.rests { "yes" } else { "no" }.into()),
            ];
            lines.push(text_with("listen-impact", &arguments));
        }
        if let Ok(line) = &drop.log_linear_fit {
            let restitution = Quantity::of(&line.restitution, Unit::Number);
            let height = Quantity::of(&line.drop_height_m, Unit::Length);
            let line = [
                ("restitution", restitution.into()),
                ("height", height.into()),
            ];
            lines.push(format!("  {}", text_with("listen-line", &line)));
        }
        if let Some(restitution) = drop.per_impact_restitution() {
            let restitution = Quantity::of(&restitution, Unit::Number);
            let corrected = [("restitution", restitution.into())];
            lines.push(format!("  {}", text_with("listen-corrected", &corrected)));
        }
        let times: Vec<(usize, f64)> = drop
            .flights
            .iter()
            .map(|f| (f.number, f.flight_time_s))
            .collect();
        lines.extend(sketch::flights(&times, WIDTH));
        lines
    }

    /// Prints a message on stderr, above the lines.
    pub(super) fn say(&self, message: &str) {
        self.bar
            .suspend(|| say(format_args!("bouncelab: {message}")));
    }

    /// Prints a result on stdout, above the lines.
    pub(super) fn print(&self, text: &str) -> Result<(), Failure> {
        self.bar.suspend(|| print(text))
    }

    /// Prints a result for programs on stdout, above the lines.
    pub(super) fn print_data(&self, text: &str) -> Result<(), Failure> {
        self.bar.suspend(|| print_data(text))
    }

    /// Clears the lines.
    pub(super) fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

impl Level {
    fn line(&mut self, now: Instant, pause: Duration) -> String {
        /// The meter falls no faster than this, in dB each second, so that a click can be seen.
        const FALL_DB_S: f64 = 30.0;
        /// A sample this near to full scale is at the limit of the converter.
        const LIMIT: f32 = 0.999;
        const WARNING: Duration = Duration::from_secs(3);
        if self.peak >= LIMIT {
            self.warn_until = Some(now + WARNING);
        }
        let fallen_db = self.shown_db - FALL_DB_S * pause.as_secs_f64();
        let now_db = 20.0 * f64::from(self.peak).max(1e-6).log10();
        self.shown_db = now_db.max(fallen_db);
        self.peak = 0.0;
        let warning = if self.warn_until.is_some_and(|until| now < until) {
            format!("  {}", text("listen-too-loud"))
        } else {
            String::new()
        };
        let meter = sketch::meter(self.shown_db);
        let level = text("listen-level");
        format!("{level} ▕{meter}▏{:>4.0} dB{warning}", self.shown_db)
    }
}

impl Status<'_> {
    fn line(&self) -> String {
        let sounds = self.watch.drops.detector().onsets();
        let counted = |id, count: usize| text_with(id, &[("count", count.into())]);
        let seconds = Value::fixed(self.watch.drops.now_s().floor(), 0);
        let mut facts = vec![
            text_with("listen-seconds", &[("seconds", seconds)]),
            counted("listen-drops", self.drops),
            counted("listen-sounds", sounds),
        ];
        facts.extend(self.saving.clone());
        if self.lost_frames > 0 {
            let lost = [("count", self.lost_frames.into())];
            facts.push(text_with("listen-lost-so-far", &lost));
        }
        facts.push(text("listen-ends"));
        translator().in_one_line(facts)
    }
}
