//! Restitution against impact speed, coloured by group.

use bouncelab::groups::CurvePoint;

use crate::chart::{Axis, Chart, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::theme::Meaning;

/// More groups cannot be distinguished by eye.
const MAX_GROUPS: usize = 12;

/// A group of drops: its impacts, and its restitution against speed.
#[derive(Debug, Clone, PartialEq)]
pub struct GroupCurve {
    /// Name, as in the legend.
    pub name: String,
    /// Impact speed in m/s and restitution of single impacts.
    pub impacts: Vec<Point>,
    /// Its restitution at increasing speeds.
    pub curve: Vec<CurvePoint>,
}

/// Restitution against impact speed for several groups: single impacts as specks, the curve of a group as a line
/// with its marks, and its 95 % interval as a band.
///
/// The first twelve groups are drawn.
pub fn groups(groups: &[GroupCurve], translator: &Translator) -> Chart {
    let shown = &groups[..groups.len().min(MAX_GROUPS)];
    let specks = specks(shown);
    let mut bands = Vec::new();
    let mut means = Vec::new();
    for (index, group) in shown.iter().enumerate() {
        let meaning = Meaning::Group(index);
        let band = group.curve.iter().map(|point| {
            let [low, high] = point.restitution.interval95;
            [point.speed_m_s, low, high]
        });
        bands.push(Layer::band(meaning, band.collect()).pale(0.2));
        let mean = group
            .curve
            .iter()
            .map(|p| [p.speed_m_s, p.restitution.value]);
        let mean: Vec<Point> = mean.collect();
        let marker = Marker::of_group(index);
        means.push(Layer::line(meaning, mean.clone()));
        means.push(Layer::points(meaning, marker, mean).named(&*group.name));
    }
    if ys(&specks).chain(ys(&means)).next().is_none() {
        return Chart::empty(translator, "groups");
    }
    let bulk = ys(&specks).next().map(|_| Scale::bulk(ys(&specks)));
    let bulk = bulk.into_iter().flat_map(|bulk| [bulk.low(), bulk.high()]);
    let y = Scale::linear(ys(&means).chain(bulk)).padded(0.06, 0.06);
    let speeds = xs(&specks).chain(xs(&means)).chain([0.0]);
    let x = Scale::linear(speeds).padded(0.0, 0.04);
    let mut caption = translator.text("figure-groups-caption");
    if groups.len() > MAX_GROUPS {
        caption.push(' ');
        let counts = [("shown", MAX_GROUPS.into()), ("all", groups.len().into())];
        caption.push_str(&translator.text_with("figure-groups-more", &counts));
    }
    let panel = Panel::new(
        270.0,
        Axis::new(translator.text("axis-impact-speed"), "m/s", x),
        Axis::new(translator.text("axis-restitution"), "", y),
        bands.into_iter().chain(specks).chain(means).collect(),
    );
    Chart::new(translator, "groups", caption, vec![panel])
}

/// The impacts of all groups in turns, so that none hides another.
fn specks(groups: &[GroupCurve]) -> Vec<Layer> {
    const TURNS: usize = 8;
    let turns = (0..TURNS).flat_map(|turn| {
        groups.iter().enumerate().map(move |(index, group)| {
            let impacts = group.impacts.iter().skip(turn).step_by(TURNS);
            let impacts = impacts.copied().collect();
            Layer::points(Meaning::Group(index), Marker::Speck, impacts).pale(0.5)
        })
    });
    turns.collect()
}
