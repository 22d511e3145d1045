//! What each bounce reaches, and what it loses.

use super::Figure;
use crate::quantity::Unit;
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Measured, Panel, Sheet, Swatch};
use crate::theme::Meaning;

const HEIGHTS: &str = "How high is each bounce?";
const ENERGIES: &str = "Where does the energy go?";
const HEIGHT: f64 = 360.0;

/// The height of one bounce.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BounceHeight {
    /// Number of the impact before it.
    pub number: u32,
    /// Height of its top in metres.
    pub height_m: f64,
    /// Its standard error in metres, if known.
    pub standard_error_m: Option<f64>,
}

/// The height of each bounce against its number. The heights are logarithmic: whoever keeps the same
/// share of its speed at each impact makes a straight line.
pub fn bounce_heights(bounces: &[BounceHeight]) -> Figure {
    let usable: Vec<&BounceHeight> = bounces
        .iter()
        .filter(|bounce| bounce.height_m.is_finite() && bounce.height_m > 0.0)
        .collect();
    if usable.is_empty() {
        return Figure::empty(HEIGHT, HEIGHTS, "There are no heights to show.");
    }
    let centimetres = usable.iter().map(|bounce| 100.0 * bounce.height_m);
    let y = Scale::log(centimetres).padded(0.05, 0.05);
    let mut sheet = Sheet::new(HEIGHT, HEIGHTS);
    let panel = Panel::fill(
        &mut sheet,
        &bounce_axis(usable.iter().map(|bounce| bounce.number)),
        &Axis::new(y, "height (cm)"),
        0.0,
    );
    let blue = Meaning::Measured.colour();
    let points = usable.iter().map(|bounce| Measured {
        place: (f64::from(bounce.number), 100.0 * bounce.height_m),
        standard_error: bounce.standard_error_m.map(|error_m| 100.0 * error_m),
    });
    for point in points {
        panel.uncertainty(&mut sheet.canvas, point, blue);
        panel.point(&mut sheet.canvas, point.place, Swatch::Dot(blue));
    }
    Figure::new(
        sheet,
        "Every bounce keeps about the same share of the height before it, so that the points lie near a \
         straight line.",
    )
}

/// What one bounce loses, in joules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BounceLoss {
    /// Number of the impact.
    pub number: u32,
    /// Taken by the surface and the ball itself.
    pub to_surface_j: f64,
    /// Taken by the air in the flight after it.
    pub to_air_j: f64,
}

/// The energy that each impact takes, and the flight after it, one on top of the other. A loss below
/// zero, which noise may make, shows as none.
pub fn bounce_energies(losses: &[BounceLoss]) -> Figure {
    let usable: Vec<&BounceLoss> = losses
        .iter()
        .filter(|loss| loss.to_surface_j.is_finite() && loss.to_air_j.is_finite())
        .collect();
    let most = usable
        .iter()
        .map(|loss| loss.to_surface_j.max(0.0) + loss.to_air_j.max(0.0))
        .fold(0.0, f64::max);
    if most <= 0.0 {
        return Figure::empty(HEIGHT, ENERGIES, "There are no energies to show.");
    }
    let (joules, unit) = Unit::Energy.step_for(most);
    let (surface, air) = (Meaning::Measured.colour(), Meaning::Drag.colour());
    let mut sheet = Sheet::new(HEIGHT, ENERGIES);
    sheet.key(&[
        KeyEntry::new(Swatch::Dot(air), "the air, in the flight after it"),
        KeyEntry::new(Swatch::Dot(surface), "the bounce"),
    ]);
    let panel = Panel::fill(
        &mut sheet,
        &bounce_axis(usable.iter().map(|loss| loss.number)),
        &Axis::new(
            Scale::linear([0.0, most / joules]).padded(0.0, 0.04),
            format!("energy lost ({unit})"),
        ),
        0.0,
    );
    for loss in usable {
        let middle = f64::from(loss.number);
        let across = [middle - 0.36, middle + 0.36];
        let below = loss.to_surface_j.max(0.0) / joules;
        let above = below + loss.to_air_j.max(0.0) / joules;
        panel.block(&mut sheet.canvas, across, [0.0, below], surface);
        panel.block(&mut sheet.canvas, across, [below, above], air);
    }
    Figure::new(
        sheet,
        "What each impact takes, and on top of it what the air takes in the flight after it: the faster \
         the ball, the larger the share of the air.",
    )
}

fn bounce_axis(numbers: impl Iterator<Item = u32>) -> Axis {
    Axis::new(Scale::counting(numbers).padded(0.04, 0.04), "bounce")
}
