//! The mean of each group with its interval, over its drops.

use bouncelab::Estimate;

use crate::chart::{Axis, Chart, Layer, Marker, Panel, Point, Scale, row_middle, xs};
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::theme::Meaning;

const ROW: f64 = 34.0;

/// A group of drops and its mean.
#[derive(Debug, Clone, PartialEq)]
pub struct GroupInterval {
    /// Name in a few words.
    pub name: String,
    /// Its restitution.
    pub restitution: Estimate,
    /// The 95 % prediction interval of the next drop, if it is known.
    pub next95: Option<[f64; 2]>,
    /// The values of the drops, and whether each is an outlier.
    pub drops: Vec<(f64, bool)>,
}

/// One row for each group, for restitution at a speed in m/s: its drops as specks, the range in which
/// the next drop is expected as a pale bar, the interval of the mean as a strong one, the mean as a dot.
pub fn intervals(groups: &[GroupInterval], at_speed_m_s: f64, translator: &Translator) -> Chart {
    let text = |id: &str| translator.text(&format!("figure-intervals-{id}"));
    let usable: Vec<&GroupInterval> = groups
        .iter()
        .filter(|group| group.restitution.value.is_finite())
        .collect();
    let rows = usable.len();
    if rows == 0 {
        return Chart::empty(translator, "intervals");
    }
    let (mut next, mut interval, mut means) = (Vec::new(), Vec::new(), Vec::new());
    let (mut drops, mut outliers) = (Vec::new(), Vec::new());
    for (row, group) in usable.iter().enumerate() {
        let middle = row_middle(rows, row);
        if let Some([low, high]) = group.next95 {
            next.push([low, high, middle - 0.3, middle + 0.3]);
        }
        let [low, high] = group.restitution.interval95;
        interval.extend([[low, middle], [high, middle], [f64::NAN; 2]]);
        for (index, &(value, is_outlier)) in group.drops.iter().enumerate() {
            // Spread over the row, so that equal values are seen.
            let point: Point = [value, middle + 0.26 * spread(index)];
            if is_outlier {
                outliers.push(point);
            } else {
                drops.push(point);
            }
        }
        means.push([group.restitution.value, middle]);
    }
    let interval = Layer::line(Meaning::Measured, interval).with_width(7.0);
    let mut layers = vec![
        interval.pale(0.45).named(text("mean")),
        Layer::points(Meaning::Soft, Marker::Speck, drops).named(text("drops")),
        Layer::points(Meaning::Measured, Marker::Dot, means),
    ];
    if !outliers.is_empty() {
        let outliers = Layer::points(Meaning::Warning, Marker::Ring, outliers);
        layers.push(outliers.named(text("outliers")));
    }
    let scale = Scale::linear(xs(&layers)).padded(0.05, 0.05);
    let next = Layer::boxes(Meaning::Measured, next).pale(0.12);
    layers.insert(0, next.named(text("next")));
    let names = usable.iter().map(|group| {
        let count = [("count", group.drops.len().into())];
        let below = translator.text_with("figure-intervals-count", &count);
        format!("{}\n{below}", group.name.replace('\n', " "))
    });
    let speed = Quantity::rounded(at_speed_m_s, 3, Unit::Speed);
    let quantity = translator.text_with("axis-restitution-at", &[("speed", speed.into())]);
    let x = Axis::new(quantity, "", scale);
    let y = Axis::of_names(names.collect());
    let panel = Panel::new(ROW * rows as f64, x, y, layers);
    Chart::new(translator, "intervals", text("caption"), vec![panel])
}

/// From -1 to 1, evenly for any number of indices: multiples of the golden section.
fn spread(index: usize) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    2.0 * (index as f64 * GOLDEN).fract() - 1.0
}
