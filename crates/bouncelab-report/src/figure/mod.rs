//! The figures, one file each.
//!
//! Each takes plain data and gives a [`Figure`]. Points that are not numbers are left out;
//! a figure without any usable point says so instead of showing empty axes.

mod bounces;
mod budget;
mod calibration;
mod corner;
mod cut;
mod drag;
mod flight_times;
mod groups;
mod height;
mod intervals;
mod limits;
mod listening;
mod models;
mod residuals;
mod restitution;
mod rows;
mod run_chart;
mod waveform;

pub use bounces::{BounceHeight, BounceLoss, bounce_energies, bounce_heights};
pub use budget::{Budget, Source, budget};
pub use calibration::{RankHistogram, calibration};
pub use corner::{CornerParameter, corner};
pub use cut::{CutPoint, CutSeries, cut};
pub use drag::{DragAxes, drag};
pub use flight_times::{Line, TimedFlight, flight_times};
pub use groups::{GroupLaw, GroupPoint, groups};
pub use height::height;
pub use intervals::{GroupInterval, intervals};
pub use limits::{Judged, limits};
pub use listening::{Hearing, listening};
pub use models::{ModelWeight, models};
pub use residuals::{Residual, residuals};
pub use restitution::{BandPoint, Restitution, restitution};
pub use run_chart::{RunPoint, run_chart};
pub use waveform::{Envelope, Mark, waveform};

use crate::canvas::Pen;
use crate::language::{Say, said};
use crate::scale::Scale;
use crate::shape::{Dash, is_finite};
use crate::sheet::{KeyEntry, Sheet, Swatch};
use crate::theme::Meaning;

/// The narrowest picture, in pixels: below it nothing can be read.
pub const MIN_WIDTH_PX: u32 = 120;
/// The widest picture, in pixels.
pub const MAX_WIDTH_PX: u32 = 8000;

/// A drawn figure.
#[derive(Debug)]
pub struct Figure {
    sheet: Sheet,
    caption: String,
}

impl Figure {
    fn new(sheet: Sheet, caption: impl Into<String>) -> Self {
        Self {
            sheet,
            caption: caption.into(),
        }
    }

    /// A figure that says why it shows nothing.
    fn empty(height: f64, title: &str, reason: &str) -> Self {
        let mut sheet = Sheet::new(height, title);
        sheet.message(reason);
        Self::new(sheet, reason)
    }

    /// The title, which also stands on the figure.
    pub fn title(&self) -> &str {
        self.sheet.title()
    }

    /// One sentence that says what to see in it.
    pub fn caption(&self) -> &str {
        &self.caption
    }

    /// Says every word of it in another language. Where the words need more room, the figure grows.
    pub fn translate(&mut self, say: &mut Say<'_>) {
        said(&mut self.caption, say);
        self.sheet.translate(say);
    }

    /// Width and height of the drawing in figure pixels: its natural size on a page.
    pub fn size(&self) -> (f64, f64) {
        self.sheet.size()
    }

    /// The figure as SVG, which scales to any size; the caption is its description for those
    /// who cannot see it.
    pub fn svg(&self) -> String {
        self.sheet.drawn().svg(self.title(), &self.caption)
    }

    /// The figure as a PNG picture of the given width in pixels.
    ///
    /// # Errors
    ///
    /// [`Error::PictureWidth`](crate::Error::PictureWidth) if the width is not from
    /// [`MIN_WIDTH_PX`] to [`MAX_WIDTH_PX`], [`Error::Picture`](crate::Error::Picture) if the
    /// drawing library fails.
    #[cfg(feature = "png")]
    pub fn png(&self, width_px: u32) -> crate::Result<Vec<u8>> {
        if !(MIN_WIDTH_PX..=MAX_WIDTH_PX).contains(&width_px) {
            return Err(crate::Error::PictureWidth { width_px });
        }
        let drawn = self.sheet.drawn().png(width_px);
        drawn.map_err(|problem| crate::Error::Picture {
            title: self.title().to_owned(),
            problem,
        })
    }
}

/// A named curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Name, as in the key: short, plain text.
    pub name: String,
    /// What it shows, which decides its colour. Curves with the same meaning differ by their
    /// dashes.
    pub meaning: Meaning,
    /// The points in the order of drawing; the figure says in which units. A point that is
    /// not a number interrupts the curve.
    pub points: Vec<(f64, f64)>,
}

/// Width of a line that shows data, in figure pixels.
const LINE: f64 = 2.25;

/// A pen for each curve: the colour by its meaning, dashes by how many of the same meaning
/// came before.
fn pens(curves: &[Curve]) -> Vec<Pen> {
    const DASHES: [Option<Dash>; 4] = [
        None,
        Some(Dash {
            stroke: 9.0,
            gap: 5.0,
        }),
        Some(Dash {
            stroke: 2.5,
            gap: 4.0,
        }),
        Some(Dash {
            stroke: 18.0,
            gap: 5.0,
        }),
    ];
    curves
        .iter()
        .enumerate()
        .map(|(i, curve)| {
            let before = &curves[..i];
            let same = before.iter().filter(|c| c.meaning == curve.meaning).count();
            Pen {
                colour: curve.meaning.colour(),
                width: LINE,
                dash: DASHES[same % DASHES.len()],
            }
        })
        .collect()
}

/// The curves' entries in the key.
fn curve_key(curves: &[Curve], pens: &[Pen]) -> Vec<KeyEntry> {
    curves
        .iter()
        .zip(pens)
        .map(|(curve, &pen)| KeyEntry::new(Swatch::Line(pen), curve.name.clone()))
        .collect()
}

/// A scale that shows the bulk of the values and leaves outliers out: those further from the
/// quartiles than three times the distance between the quartiles (Tukey's "far out").
///
/// Each value comes with its standard error, which is given room up to the same bound.
fn robust_scale(values: &[(f64, Option<f64>)]) -> Scale {
    let mut sorted: Vec<f64> = values
        .iter()
        .map(|(value, _)| *value)
        .filter(|value| value.is_finite())
        .collect();
    if sorted.is_empty() {
        return Scale::linear([]);
    }
    sorted.sort_unstable_by(f64::total_cmp);
    let quartile = |share: f64| sorted[(share * (sorted.len() - 1) as f64).round() as usize];
    let (lower, upper) = (quartile(0.25), quartile(0.75));
    let far = 3.0 * (upper - lower);
    let near = |value: &f64| (lower - far..=upper + far).contains(value);
    let ends = values
        .iter()
        .filter(|(value, _)| near(value))
        .flat_map(|(value, error)| {
            let error = error.filter(|e| e.is_finite()).unwrap_or(0.0);
            [value - error, value + error]
        })
        .map(|end| end.clamp(lower - far.max(f64::MIN_POSITIVE), upper + far))
        .chain(sorted.iter().copied().filter(near));
    Scale::linear(ends)
}

/// "1 impact", "2 impacts".
fn count(n: usize, thing: &str) -> String {
    if n == 1 {
        format!("1 {thing}")
    } else {
        format!("{n} {thing}s")
    }
}
