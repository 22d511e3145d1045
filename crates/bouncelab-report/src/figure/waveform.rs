//! The sound with its impacts (paper, Fig. 4).

use bouncelab::analysis::{CONFIDENT_PROBABILITY, Drop};
use bouncelab::detection::Envelope;

use crate::chart::{Axis, Chart, Layer, Panel, Scale, Shape};
use crate::messages::Translator;
use crate::theme::Meaning;

/// A picture has no more columns.
const STEPS: usize = 570;
/// Half the height of silence, as a share of the axis: no sound is invisible.
const SILENCE: f64 = 0.0018;

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

impl Mark {
    /// The impacts of drops.
    pub fn of_drops(drops: &[Drop]) -> Vec<Self> {
        let numbered = drops.iter().zip(1..);
        let marks = numbered.flat_map(|(result, drop)| {
            result.impacts.iter().map(move |impact| Self {
                time_s: impact.time_s,
                sure: impact.probability >= CONFIDENT_PROBABILITY,
                drop,
            })
        });
        marks.collect()
    }
}

/// The sound against time, with a mark at each impact; uncertain ones are open and orange.
pub fn waveform(sound: &Envelope, marks: &[Mark], translator: &Translator) -> Chart {
    let peak = peak(sound);
    let duration_s = sound.min().len() as f64 * sound.step_s();
    let (Some(peak), true) = (peak, duration_s > 0.0 && duration_s.is_finite()) else {
        return Chart::empty(translator, "waveform");
    };
    let mut marks: Vec<Mark> = marks.to_vec();
    marks.retain(|mark| mark.time_s.is_finite());
    marks.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
    let (seconds, unit) = match duration_s {
        d if d < 0.2 => (1e-3, "ms"),
        d if d < 600.0 => (1.0, "s"),
        _ => (60.0, "min"),
    };
    // Symmetric about zero, and never so fine that the noise of silence looks loud.
    let amplitudes = Scale::linear([-peak, peak]).padded(0.02, 0.02);
    let times = Scale::linear([0.0, duration_s / seconds]);
    let x = Axis::new(translator.text("axis-time"), unit, times);
    let y = Axis::new(translator.text("axis-amplitude"), "", amplitudes);
    let band = Layer::band(Meaning::Measured, outline(sound, peak, seconds));
    let layers = mark_layers(&marks, seconds, translator);
    let uncertain = marks.iter().filter(|mark| !mark.sure).count();
    let caption = caption(marks.len(), uncertain, drops(&marks).len(), translator);
    let layers = layers.into_iter().chain([band]).collect();
    let panel = Panel::new(210.0, x, y, layers);
    Chart::new(translator, "waveform", caption, vec![panel])
}

/// The loudest sample, or that of silence; `None` without samples.
fn peak(sound: &Envelope) -> Option<f64> {
    let samples = sound.min().iter().chain(sound.max());
    let finite = samples.filter(|sample| sample.is_finite());
    let levels = finite.map(|sample| f64::from(sample.abs()));
    levels.reduce(f64::max).map(|peak| peak.max(1e-5))
}

/// Least and greatest sample of each step, as two edges of the step each, so that a single loud one
/// has a width. What is not a number is a gap.
fn outline(sound: &Envelope, peak: f64, seconds: f64) -> Vec<[f64; 3]> {
    let per_step = sound.min().len().div_ceil(STEPS).max(1);
    let step_s = sound.step_s() * per_step as f64;
    let steps = std::iter::zip(sound.min().chunks(per_step), sound.max().chunks(per_step));
    let mut outline = Vec::new();
    let mut before: Option<(f64, f64)> = None;
    for (step, (least, greatest)) in steps.enumerate() {
        let low = extreme(least, f64::min);
        let high = extreme(greatest, f64::max);
        // A sound is continuous: between two steps it passes all values between them.
        let (shown_low, shown_high) = before.map_or((low, high), |(was_low, was_high)| {
            (low.min(was_high), high.max(was_low))
        });
        before = (low.is_finite() && high.is_finite()).then_some((low, high));
        if before.is_none() {
            outline.push([f64::NAN; 3]);
            continue;
        }
        let silence = 2.0 * SILENCE * peak;
        for edge in [step, step + 1] {
            let time = edge as f64 * step_s / seconds;
            outline.push([time, shown_low - silence, shown_high + silence]);
        }
    }
    outline
}

/// The least or greatest number; NaN without numbers.
fn extreme(values: &[f32], pick: fn(f64, f64) -> f64) -> f64 {
    let finite = values.iter().filter(|value| value.is_finite());
    finite
        .map(|value| f64::from(*value))
        .reduce(pick)
        .unwrap_or(f64::NAN)
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

/// A layer for the sure and one for the uncertain impacts of each drop. The legend names them if there
/// are uncertain ones, and with several drops each is named above its marks.
fn mark_layers(marks: &[Mark], seconds: f64, translator: &Translator) -> Vec<Layer> {
    let any_uncertain = marks.iter().any(|mark| !mark.sure);
    let drops = drops(marks);
    let mut layers = Vec::new();
    for &drop in &drops {
        let group = if drops.len() > 1 {
            translator.text_with("figure-waveform-drop", &[("number", drop.into())])
        } else {
            String::new()
        };
        let of_drop = || (1..).zip(marks.iter().filter(|mark| mark.drop == drop));
        for (sure, meaning, name) in [
            (true, Meaning::Measured, "impact"),
            (false, Meaning::Warning, "uncertain"),
        ] {
            let shown = of_drop().filter(|(_, mark)| mark.sure == sure);
            let (numbers, positions): (Vec<u32>, Vec<f64>) = shown
                .map(|(number, mark)| (number, mark.time_s / seconds))
                .unzip();
            if positions.is_empty() {
                continue;
            }
            let shape = Shape::Marks {
                positions,
                numbers,
                group: group.clone(),
                filled: sure,
            };
            let layer = Layer::new(meaning, shape);
            let name = translator.text(&format!("figure-waveform-{name}"));
            layers.push(if any_uncertain {
                layer.named(name)
            } else {
                layer
            });
        }
    }
    layers
}

fn caption(impacts: usize, uncertain: usize, drops: usize, translator: &Translator) -> String {
    if impacts == 0 {
        return translator.text("figure-waveform-no-impacts");
    }
    // It takes three impacts to see a ratio.
    let is_pattern = impacts > 2 * drops;
    let arguments = [
        ("impacts", impacts.into()),
        ("uncertain", uncertain.into()),
        ("drops", drops.into()),
        ("pattern", if is_pattern { "yes" } else { "no" }.into()),
    ];
    translator.text_with("figure-waveform-caption", &arguments)
}
