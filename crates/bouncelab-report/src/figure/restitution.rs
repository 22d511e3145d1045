//! Restitution against impact speed.

use super::{Figure, LINE, robust_scale};
use crate::canvas::Pen;
use crate::quantity::{Quantity, Unit};
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Measured, Panel, Sheet, Swatch};
use crate::theme::Meaning;

const TITLE: &str = "Bounciness of each impact";
const HEIGHT: f64 = 400.0;

/// The restitution of one impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restitution {
    /// Speed before the impact, in m/s.
    pub speed_m_s: f64,
    /// Speed after the impact divided by the speed before it.
    pub value: f64,
    /// Standard error of the value, if known.
    pub standard_error: Option<f64>,
    /// Whether it is odd and counts less in the fit.
    pub odd: bool,
}

/// The fitted restitution at a speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandPoint {
    /// Speed before the impact, in m/s.
    pub speed_m_s: f64,
    /// Median.
    pub value: f64,
    /// Where it lies with a probability of 68 %.
    pub interval68: [f64; 2],
    /// Where it lies with a probability of 95 %.
    pub interval95: [f64; 2],
}

impl Restitution {
    fn place(self) -> (f64, f64) {
        (self.speed_m_s, self.value)
    }
}

/// Restitution against impact speed: `raw` as if there were no air (the ratio of neighbouring
/// flight times), `corrected` for air drag, the fitted law as a `band`, and the one value of
/// the straight line. The vertical axis shows the bulk of the values; those far off are arrow
/// heads at its edge.
pub fn restitution(
    raw: &[Restitution],
    corrected: &[Restitution],
    band: &[BandPoint],
    line: Option<f64>,
) -> Figure {
    let raw = usable(raw);
    let corrected = usable(corrected);
    let all = || raw.iter().chain(&corrected);
    if all().next().is_none() {
        return Figure::empty(
            HEIGHT,
            TITLE,
            "There are no impacts with a known restitution.",
        );
    }
    let line = line.filter(|value| value.is_finite());
    let shown: Vec<_> = all().map(|r| (r.value, r.standard_error)).collect();
    let bulk = robust_scale(&shown);
    let fitted = band.iter().flat_map(|point| point.interval68);
    let ends = [bulk.low(), bulk.high()]
        .into_iter()
        .chain(line)
        .chain(fitted);
    let y = Axis::new(
        Scale::linear(ends).padded(0.08, 0.08),
        "restitution: speed after / before",
    );
    let fitted = band.iter().map(|point| point.speed_m_s);
    let speeds = all().map(|r| r.speed_m_s).chain(fitted).chain([0.0]);
    let x = Axis::new(
        Scale::linear(speeds).padded(0.0, 0.04),
        "speed at the impact (m/s)",
    );

    let mut sheet = Sheet::new(HEIGHT, TITLE);
    let grey = Meaning::NoDrag.colour();
    let blue = Meaning::Measured.colour();
    let orange = Meaning::Drag.colour();
    let pen = Pen::solid(grey, LINE);
    let odd = Swatch::Mark {
        colour: orange,
        filled: false,
    };
    let mut key = Vec::new();
    if !corrected.is_empty() {
        key.push(KeyEntry::new(Swatch::Dot(blue), "corrected for drag"));
    }
    if !raw.is_empty() {
        key.push(KeyEntry::new(Swatch::Ring(grey), "as if there were no air"));
    }
    if corrected.iter().any(|impact| impact.odd) {
        key.push(KeyEntry::new(odd, "odd, counts less"));
    }
    let fit = Pen::solid(orange, LINE);
    if !band.is_empty() {
        key.push(KeyEntry::new(Swatch::Line(fit), "fitted law, 68 and 95 %"));
    }
    if let Some(value) = line {
        let value = Quantity::rounded(value, 4, Unit::Number);
        let name = format!("straight line: {value}");
        key.push(KeyEntry::new(Swatch::Line(pen), name));
    }
    sheet.key(&key);
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    draw_band(&panel, &mut sheet, band, fit);
    let groups = [
        (&raw, Swatch::Ring(grey), grey),
        (&corrected, Swatch::Dot(blue), blue),
    ];
    for (impacts, _, colour) in groups {
        for &impact in impacts {
            let point = Measured {
                place: impact.place(),
                standard_error: impact.standard_error,
            };
            panel.uncertainty(&mut sheet.canvas, point, colour);
        }
    }
    if let Some(value) = line {
        panel.level(&mut sheet.canvas, value, pen);
    }
    for (impacts, swatch, _) in groups {
        for &impact in impacts {
            panel.point(&mut sheet.canvas, impact.place(), swatch);
        }
    }
    for &impact in corrected.iter().filter(|impact| impact.odd) {
        panel.point(&mut sheet.canvas, impact.place(), odd);
    }
    Figure::new(sheet, caption(!raw.is_empty() && !corrected.is_empty()))
}

fn draw_band(panel: &Panel, sheet: &mut Sheet, band: &[BandPoint], pen: Pen) {
    let wide: Vec<_> = band.iter().map(|p| (p.speed_m_s, p.interval95)).collect();
    let narrow: Vec<_> = band.iter().map(|p| (p.speed_m_s, p.interval68)).collect();
    for (region, share) in [(wide, 0.13), (narrow, 0.3)] {
        let ends = |end: usize| -> Vec<(f64, f64)> {
            region
                .iter()
                .map(|(speed, ends)| (*speed, ends[end]))
                .collect()
        };
        let colour = pen.colour.mixed(share);
        panel.band(&mut sheet.canvas, &ends(0), &ends(1), colour);
    }
    let middle: Vec<(f64, f64)> = band.iter().map(|p| (p.speed_m_s, p.value)).collect();
    panel.curve(&mut sheet.canvas, &middle, pen);
}

fn usable(impacts: &[Restitution]) -> Vec<Restitution> {
    impacts
        .iter()
        .copied()
        .filter(|impact| impact.speed_m_s.is_finite() && impact.value.is_finite())
        .collect()
}

fn caption(both: bool) -> String {
    if both {
        "What the ball keeps of its speed at each impact; the gap between grey and blue is what the air takes, which a straight line counts as lost in the bounce."
    } else {
        "What the ball keeps of its speed at each impact."
    }
    .to_owned()
}
