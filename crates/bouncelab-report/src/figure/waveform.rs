//! The sound with its impacts (paper, Fig. 4).

use super::{Figure, count};
use crate::canvas::{Anchor, Pen, Style, text_width};
use crate::error::{Error, Result};
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, MARK, Panel, Sheet, Swatch, mark};
use crate::theme::{self, Meaning};

const TITLE: &str = "The sound and its impacts";
const HEIGHT: f64 = 360.0;

/// No recording lasts longer, in seconds: thirty years.
const LONGEST_S: f64 = 1e9;

/// The lowest and highest sample in each of many short stretches of a sound: all that a
/// picture can show of it, however long it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Envelope {
    start_s: f64,
    step_s: f64,
    min: Vec<f32>,
    max: Vec<f32>,
}

impl Envelope {
    /// An envelope of bins that each last `step_s`, the first starting at `start_s`, with
    /// the lowest and highest sample of each, relative to full scale. A bin whose samples
    /// are not numbers is a gap.
    ///
    /// # Errors
    ///
    /// [`Error::Envelope`] if there are not as many lowest as highest samples, or `step_s` is
    /// not above zero, or the times are not numbers or beyond a billion seconds.
    pub fn new(start_s: f64, step_s: f64, min: Vec<f32>, max: Vec<f32>) -> Result<Self> {
        if min.len() != max.len() {
            let problem = format!(
                "{} lowest and {} highest samples; give one of each for every bin",
                min.len(),
                max.len()
            );
            return Err(Error::Envelope { problem });
        }
        let end_s = start_s + min.len() as f64 * step_s;
        let ends_in_time = start_s.abs() < LONGEST_S && end_s.abs() < LONGEST_S;
        // Negated, so that what is not a number is caught as well.
        if !(step_s > 0.0 && ends_in_time) {
            let problem = format!(
                "bins of {step_s} s from {start_s} s to {end_s} s; a bin must last longer than 0 s, and the times must lie within {LONGEST_S:e} s"
            );
            return Err(Error::Envelope { problem });
        }
        Ok(Self {
            start_s,
            step_s,
            min,
            max,
        })
    }

    /// The envelope of samples in memory, in at most `bins` bins, starting at time zero.
    /// For a sound in a long file, gather the bins while reading and use [`Envelope::new`].
    ///
    /// ```
    /// use bouncelab_report::figure::Envelope;
    /// let envelope = Envelope::from_samples(&[0.0, 0.5, -0.5, 0.1], 4.0, 2)?;
    /// assert_eq!(envelope, Envelope::new(0.0, 0.5, vec![0.0, -0.5], vec![0.5, 0.1])?);
    /// # Ok::<(), bouncelab_report::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Envelope`] if the sample rate is not a number above zero.
    pub fn from_samples(samples: &[f32], sample_rate_hz: f64, bins: usize) -> Result<Self> {
        let per_bin = samples.len().div_ceil(bins.max(1)).max(1);
        let step_s = per_bin as f64 / sample_rate_hz;
        let (min, max) = samples.chunks(per_bin).map(ends).unzip();
        Self::new(0.0, step_s, min, max)
    }

    fn end_s(&self) -> f64 {
        self.start_s + self.min.len() as f64 * self.step_s
    }

    /// Neighbouring bins joined until there are at most `bins`.
    fn joined(&self, bins: usize) -> Self {
        let per_bin = self.min.len().div_ceil(bins).max(1);
        Self {
            start_s: self.start_s,
            step_s: self.step_s * per_bin as f64,
            min: self.min.chunks(per_bin).map(|bin| ends(bin).0).collect(),
            max: self.max.chunks(per_bin).map(|bin| ends(bin).1).collect(),
        }
    }
}

/// Lowest and highest number; not a number if there is none.
fn ends(values: &[f32]) -> (f32, f32) {
    values.iter().fold((f32::NAN, f32::NAN), |(low, high), &v| {
        if v.is_finite() {
            (low.min(v), high.max(v))
        } else {
            (low, high)
        }
    })
}

/// An impact, marked on the sound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// When it begins, in seconds.
    pub time_s: f64,
    /// Whether it is surely an impact of its drop.
    pub sure: bool,
    /// Which drop it belongs to, counted from 1.
    pub drop: usize,
}

/// The sound against time, with a mark at each impact; uncertain ones are open and orange.
///
/// ```
/// use bouncelab_report::figure::{Envelope, Mark, waveform};
/// let sound = Envelope::from_samples(&[0.0, 0.9, -0.4, 0.1, 0.0, 0.5, -0.2, 0.0], 8.0, 8)?;
/// let marks = [0.125, 0.625].map(|time_s| Mark { time_s, sure: true, drop: 1 });
/// assert_eq!(waveform(&sound, &marks).caption(), "2 impacts of one drop.");
/// # Ok::<(), bouncelab_report::Error>(())
/// ```
pub fn waveform(sound: &Envelope, marks: &[Mark]) -> Figure {
    if sound.min.iter().chain(&sound.max).all(|v| !v.is_finite()) {
        return Figure::empty(HEIGHT, TITLE, "There is no sound to show.");
    }
    let mut marks: Vec<Mark> = marks
        .iter()
        .copied()
        .filter(|mark| mark.time_s.is_finite())
        .collect();
    marks.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
    let uncertain = marks.iter().filter(|mark| !mark.sure).count();
    let drops = drops(&marks);

    let mut sheet = Sheet::new(HEIGHT, TITLE);
    if uncertain > 0 {
        sheet.key(&key(marks.len() > uncertain));
    }
    let unit = TimeUnit::of(sound.end_s() - sound.start_s);
    let times = [sound.start_s, sound.end_s()].map(|t| t / unit.seconds);
    let x = Axis::new(Scale::linear(times), format!("time ({})", unit.symbol));
    let y = Axis::new(amplitudes(sound), "amplitude, relative to full scale");
    let rows = if drops.len() > 1 { 2.0 } else { 1.0 };
    let room = if marks.is_empty() {
        0.0
    } else {
        14.0 + 16.0 * rows
    };
    let panel = Panel::fill(&mut sheet, &x, &y, room);
    draw_marks(&mut sheet, &panel, &marks, unit);
    draw_sound(&mut sheet, &panel, sound, unit);
    draw_numbers(&mut sheet, &panel, &marks, unit, &drops);
    Figure::new(sheet, caption(marks.len(), uncertain, drops.len()))
}

fn meaning(mark: &Mark) -> Meaning {
    if mark.sure {
        Meaning::Measured
    } else {
        Meaning::Warning
    }
}

/// The numbers of the drops, in the order of their first impacts.
fn drops(marks: &[Mark]) -> Vec<usize> {
    let mut drops: Vec<usize> = Vec::new();
    for mark in marks {
        if !drops.contains(&mark.drop) {
            drops.push(mark.drop);
        }
    }
    drops
}

fn key(some_are_sure: bool) -> Vec<KeyEntry> {
    let sure = Swatch::Mark {
        colour: Meaning::Measured.colour(),
        filled: true,
    };
    let uncertain = Swatch::Mark {
        colour: Meaning::Warning.colour(),
        filled: false,
    };
    let mut key = vec![KeyEntry::new(uncertain, "uncertain impact")];
    if some_are_sure {
        key.insert(0, KeyEntry::new(sure, "impact"));
    }
    key
}

/// Symmetric about zero, and never so fine that the noise of silence looks loud.
fn amplitudes(sound: &Envelope) -> Scale {
    let peak = sound
        .min
        .iter()
        .chain(&sound.max)
        .filter(|v| v.is_finite())
        .fold(1e-5_f64, |peak, v| peak.max(f64::from(v.abs())));
    Scale::linear([-peak, peak]).padded(0.02, 0.02)
}

fn draw_sound(sheet: &mut Sheet, panel: &Panel, sound: &Envelope, unit: TimeUnit) {
    let sound = sound.joined(panel.frame.width() as usize);
    let mut upper = Vec::new();
    let mut lower = Vec::new();
    let mut shapes = Vec::new();
    let mut before = None;
    for (i, (&min, &max)) in sound.min.iter().zip(&sound.max).enumerate() {
        if !min.is_finite() || !max.is_finite() {
            shapes.push((std::mem::take(&mut upper), std::mem::take(&mut lower)));
            before = None;
            continue;
        }
        // A sound is continuous: between two bins it passes all values between them.
        let (low, high) = before.map_or((min, max), |(low, high)| (min.min(high), max.max(low)));
        before = Some((min, max));
        // A bin is a step, so that a single loud one has a width; and silence has a height.
        for edge in [i, i + 1] {
            let time = (sound.start_s + edge as f64 * sound.step_s) / unit.seconds;
            let (x, y) = panel.at((time, f64::from(high)));
            upper.push((x, y - 0.4));
            let (x, y) = panel.at((time, f64::from(low)));
            lower.push((x, y + 0.4));
        }
    }
    shapes.push((upper, lower));
    for (mut outline, lower) in shapes {
        outline.extend(lower.into_iter().rev());
        let colour = Meaning::Measured.colour();
        sheet.canvas.area(&outline, colour);
    }
}

/// A hairline through the sound and a triangle above it for each impact; narrower triangles
/// where the impacts are dense.
fn draw_marks(sheet: &mut Sheet, panel: &Panel, marks: &[Mark], unit: TimeUnit) {
    let frame = panel.frame;
    let places: Vec<f64> = marks
        .iter()
        .map(|mark| panel.at((mark.time_s / unit.seconds, 0.0)).0)
        .collect();
    let on_sheet = |&i: &usize| (frame.left..=frame.right).contains(&places[i]);
    // The uncertain ones last: a filled mark beside must not hide one.
    let (sure, uncertain): (Vec<usize>, Vec<usize>) = (0..marks.len())
        .filter(on_sheet)
        .partition(|&i| marks[i].sure);
    for i in sure.into_iter().chain(uncertain) {
        let x = places[i];
        let colour = meaning(&marks[i]).colour();
        let pen = Pen::solid(colour.tint(), 1.0);
        sheet.canvas.line((x, frame.top), (x, frame.bottom), pen);
        let before = i.checked_sub(1).map_or(f64::INFINITY, |j| x - places[j]);
        let after = places.get(i + 1).map_or(f64::INFINITY, |next| next - x);
        let half = (0.45 * before.min(after)).clamp(1.5, MARK);
        let tip = (x, frame.top - 2.0);
        mark(&mut sheet.canvas, tip, half, colour, marks[i].sure);
    }
}

/// Above the triangles: which impact it is, where there is room; above that, which drop.
fn draw_numbers(sheet: &mut Sheet, panel: &Panel, marks: &[Mark], unit: TimeUnit, drops: &[usize]) {
    let frame = panel.frame;
    let style = Style::new(theme::TICK_SIZE, theme::SOFT_INK, Anchor::Middle);
    let trains: Vec<(usize, Vec<f64>)> = drops
        .iter()
        .map(|&drop| {
            let train = marks
                .iter()
                .filter(|mark| mark.drop == drop)
                .map(|mark| panel.at((mark.time_s / unit.seconds, 0.0)).0)
                .filter(|x| (frame.left..=frame.right).contains(x));
            (drop, train.collect::<Vec<f64>>())
        })
        .filter(|(_, train)| !train.is_empty())
        .collect();
    let mut free = f64::NEG_INFINITY;
    for (index, (drop, train)) in trains.iter().enumerate() {
        let mut taken = free;
        for (number, x) in numbers(train) {
            let half = text_width(&number, style.size) / 2.0 + 2.0;
            if x - half > taken {
                sheet.canvas.text((x, frame.top - 16.0), number, style);
                taken = x + half;
            }
        }
        if drops.len() > 1 {
            let name = format!("drop {drop}");
            let half = text_width(&name, style.size) / 2.0 + 2.0;
            let middle = middle(train);
            if middle - half > free {
                // Longer words of another language end where those of the neighbours begin.
                let before = index
                    .checked_sub(1)
                    .map(|i| middle - self::middle(&trains[i].1));
                let after = trains
                    .get(index + 1)
                    .map(|next| self::middle(&next.1) - middle);
                let room = before
                    .into_iter()
                    .chain(after)
                    .fold(f64::INFINITY, f64::min);
                let place = (middle, frame.top - 34.0);
                sheet
                    .canvas
                    .text_within(room.max(2.0 * half), place, name, style);
                taken = taken.max(middle + half);
            }
        }
        free = taken;
    }
}

/// The middle between the first and the last impact of a drop.
fn middle(train: &[f64]) -> f64 {
    f64::midpoint(train[0], train[train.len() - 1])
}

/// The numbers worth showing, each with its place: the first, every fifth and the last, or
/// one label for all if they are too close.
fn numbers(train: &[f64]) -> Vec<(String, f64)> {
    const CLOSE: f64 = 24.0;
    let count = train.len();
    let (first, last) = (train[0], train[count - 1]);
    if count > 1 && last - first < CLOSE {
        return vec![(format!("1–{count}"), f64::midpoint(first, last))];
    }
    (1..=count)
        .filter(|number| *number == 1 || number % 5 == 0 || *number == count)
        .map(|number| (number.to_string(), train[number - 1]))
        .collect()
}

fn caption(impacts: usize, uncertain: usize, drops: usize) -> String {
    if impacts == 0 {
        return "The sound, in which no impacts were found.".to_owned();
    }
    let of = if drops == 1 {
        "one drop".to_owned()
    } else {
        count(drops, "drop")
    };
    let doubt = match uncertain {
        0 => String::new(),
        1 => " (1 uncertain, open and orange)".to_owned(),
        n => format!(" ({n} uncertain, open and orange)"),
    };
    // It takes three impacts to see a ratio.
    let pattern = if impacts > 2 * drops {
        ": their spacing shrinks by nearly the same ratio each time"
    } else {
        ""
    };
    let impacts = count(impacts, "impact");
    format!("{impacts} of {of}{doubt}{pattern}.")
}

/// The unit of the time axis.
#[derive(Debug, Clone, Copy, PartialEq)]
struct TimeUnit {
    seconds: f64,
    symbol: &'static str,
}

impl TimeUnit {
    fn of(duration_s: f64) -> Self {
        let (seconds, symbol) = match duration_s {
            d if d < 0.2 => (1e-3, "ms"),
            d if d < 600.0 => (1.0, "s"),
            _ => (60.0, "min"),
        };
        Self { seconds, symbol }
    }
}
