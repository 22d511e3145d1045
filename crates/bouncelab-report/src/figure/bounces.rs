//! Height and energy loss of each bounce.

use super::FigureInput;
use crate::chart::{Axis, Chart, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::quantity::Unit;
use crate::theme::Meaning;

/// The height of each bounce against its number: with the air taken into account where that can be
/// done, else as if there were none. The heights are logarithmic: a ball that keeps the same share of its
/// speed at each impact makes a straight line.
pub(super) fn heights(input: &FigureInput<'_>, translator: &Translator) -> Chart {
    let id = "bounce-heights";
    let (mut points, mut errors): (Vec<Point>, Vec<f64>) = (Vec::new(), Vec::new());
    for flight in &input.drop.flights {
        let modelled = input.drop.modelled_flight(flight.number);
        let height_m = modelled.map_or(flight.drag_free_height_m, |it| it.flight.apex_m);
        let error_m = modelled.and_then(|it| it.apex_sd_m);
        points.push([flight.number as f64, 100.0 * height_m]);
        errors.push(100.0 * error_m.unwrap_or(f64::NAN));
    }
    let layers = vec![Layer::points(Meaning::Measured, Marker::Dot, points).with_errors(errors)];
    if ys(&layers).next().is_none() {
        return Chart::empty(translator, id);
    }
    let scale = Scale::log(ys(&layers)).padded(0.05, 0.05);
    let y = Axis::new(translator.text("axis-height"), "cm", scale);
    let panel = Panel::new(245.0, axis(&layers, translator), y, layers);
    let caption = translator.text("figure-bounce-heights-caption");
    Chart::new(translator, id, caption, vec![panel])
}

/// The energy that each impact takes, and the flight after it, one on top of the other. A loss below
/// zero, which noise may make, shows as none.
pub(super) fn energies(input: &FigureInput<'_>, translator: &Translator) -> Chart {
    let id = "bounce-energies";
    let losses = input.drop.energies(input.settings);
    let tops = losses
        .iter()
        .map(|loss| loss.lost_to_surface_j.max(0.0) + loss.lost_to_air_j.max(0.0));
    let most = tops.fold(0.0, f64::max);
    if most <= 0.0 {
        return Chart::empty(translator, id);
    }
    let (joules, unit) = Unit::Energy.step_for(most);
    let mut surface = Vec::new();
    let mut air = Vec::new();
    for loss in &losses {
        let (left, right) = (loss.number as f64 - 0.36, loss.number as f64 + 0.36);
        let below = loss.lost_to_surface_j.max(0.0) / joules;
        surface.push([left, right, 0.0, below]);
        air.push([
            left,
            right,
            below,
            below + loss.lost_to_air_j.max(0.0) / joules,
        ]);
    }
    let text = |name: &str| translator.text(&format!("figure-bounce-energies-{name}"));
    let layers = vec![
        Layer::boxes(Meaning::Drag, air).named(text("air")),
        Layer::boxes(Meaning::Measured, surface).named(text("surface")),
    ];
    let scale = Scale::linear(ys(&layers)).padded(0.0, 0.04);
    let y = Axis::new(translator.text("axis-energy-lost"), unit, scale);
    let panel = Panel::new(220.0, axis(&layers, translator), y, layers);
    Chart::new(translator, id, text("caption"), vec![panel])
}

fn axis(layers: &[Layer], translator: &Translator) -> Axis {
    let scale = Scale::counting(xs(layers)).padded(0.03, 0.03);
    Axis::new(translator.text("axis-bounce"), "", scale)
}
