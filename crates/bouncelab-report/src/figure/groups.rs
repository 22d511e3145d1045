//! Restitution against impact speed, coloured by group.

use super::{Figure, LINE, is_finite, robust_scale};
use crate::canvas::Pen;
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Panel, Sheet, Swatch};
use crate::theme;

const TITLE: &str = "Bounciness of each group";
const HEIGHT: f64 = 440.0;
/// More groups than this cannot be told apart by eye.
const MOST: usize = 12;

/// The mean restitution of a group at a speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupPoint {
    /// Impact speed, in m/s.
    pub speed_m_s: f64,
    /// Mean restitution.
    pub value: f64,
    /// Where the mean lies with 95 % confidence, if that can be told.
    pub interval95: Option<[f64; 2]>,
}

/// A group of drops: its impacts, and its mean against speed.
#[derive(Debug, Clone, PartialEq)]
pub struct GroupLaw {
    /// Name, as in the key.
    pub name: String,
    /// Impact speed in m/s and restitution of single impacts.
    pub impacts: Vec<(f64, f64)>,
    /// The mean at increasing speeds.
    pub law: Vec<GroupPoint>,
}

/// Restitution against impact speed for several groups: single impacts as specks, the mean over the
/// drops of a group as a line with its marks, and the 95 % interval of the mean around it.
///
/// The first twelve groups are drawn.
pub fn groups(groups: &[GroupLaw]) -> Figure {
    let shown = &groups[..groups.len().min(MOST)];
    let impacts = || {
        shown
            .iter()
            .flat_map(|group| &group.impacts)
            .filter(|p| is_finite(**p))
    };
    let means = || shown.iter().flat_map(|group| &group.law);
    if impacts().next().is_none() && means().next().is_none() {
        return Figure::empty(
            HEIGHT,
            TITLE,
            "There are no impacts with a known restitution.",
        );
    }
    let values: Vec<_> = impacts().map(|(_, value)| (*value, None)).collect();
    let bulk = robust_scale(&values);
    let of_bulk = if values.is_empty() {
        Vec::new()
    } else {
        vec![bulk.low(), bulk.high()]
    };
    let ends = of_bulk.into_iter().chain(means().map(|point| point.value));
    let y = Axis::new(
        Scale::linear(ends).padded(0.06, 0.06),
        "restitution: speed after / before",
    );
    let speeds = impacts().map(|(speed, _)| *speed);
    let speeds = speeds.chain(means().map(|point| point.speed_m_s));
    let x = Axis::new(
        Scale::linear(speeds.chain([0.0])).padded(0.0, 0.04),
        "speed at the impact (m/s)",
    );
    let mut sheet = Sheet::new(HEIGHT, TITLE);
    let key: Vec<KeyEntry> = shown
        .iter()
        .enumerate()
        .map(|(place, group)| KeyEntry::new(Swatch::of_group(place), group.name.clone()))
        .collect();
    sheet.key(&key);
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    for (place, group) in shown.iter().enumerate() {
        band(&panel, &mut sheet, place, group);
    }
    specks(&panel, &mut sheet, shown);
    for (place, group) in shown.iter().enumerate() {
        mean(&panel, &mut sheet, place, group);
    }
    Figure::new(sheet, caption(groups.len()))
}

fn band(panel: &Panel, sheet: &mut Sheet, place: usize, group: &GroupLaw) {
    let known = group
        .law
        .iter()
        .filter_map(|point| Some((point.speed_m_s, point.interval95?)));
    let (lower, upper): (Vec<_>, Vec<_>) = known
        .map(|(speed, [low, high])| ((speed, low), (speed, high)))
        .unzip();
    let colour = theme::group(place).tint();
    panel.band(&mut sheet.canvas, &lower, &upper, colour);
}

/// The impacts of all groups in turn, so that none hides another.
fn specks(panel: &Panel, sheet: &mut Sheet, groups: &[GroupLaw]) {
    let longest = groups
        .iter()
        .map(|group| group.impacts.len())
        .max()
        .unwrap_or(0);
    for impact in 0..longest {
        for (place, group) in groups.iter().enumerate() {
            if let Some(&point) = group.impacts.get(impact) {
                let colour = theme::group(place).mixed(0.5);
                panel.speck(&mut sheet.canvas, point, colour);
            }
        }
    }
}

fn mean(panel: &Panel, sheet: &mut Sheet, place: usize, group: &GroupLaw) {
    let points: Vec<(f64, f64)> = group.law.iter().map(|p| (p.speed_m_s, p.value)).collect();
    let pen = Pen::solid(theme::group(place), LINE);
    panel.curve(&mut sheet.canvas, &points, pen);
    for point in points {
        panel.point(&mut sheet.canvas, point, Swatch::of_group(place));
    }
}

fn caption(groups: usize) -> String {
    let all = "Every speck is an impact; the lines are the means over the drops of each group, with \
               their 95 % intervals.";
    if groups > MOST {
        format!("{all} The first {MOST} of {groups} groups are shown.")
    } else {
        all.to_owned()
    }
}
