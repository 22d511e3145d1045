//! Calibration of stated uncertainties: ranks of the truth among the draws.

use crate::chart::{Axis, Chart, Layer, Panel, Scale, Ticks};
use crate::messages::Translator;
use crate::theme::Meaning;

/// Counts of ranks of one quantity in one scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct RankHistogram {
    /// The scenario, the same text for a whole row.
    pub scenario: String,
    /// The quantity.
    pub quantity: String,
    /// How many ranks fell into each of equally wide bins from 0 to 1.
    pub bins: Vec<u32>,
}

/// Small histograms, one row for each scenario, with the band in which 99 % of the bars should end
/// if the inference is calibrated.
pub fn calibration(histograms: &[RankHistogram], translator: &Translator) -> Chart {
    let mut scenarios: Vec<&str> = Vec::new();
    let mut quantities: Vec<&str> = Vec::new();
    let mut panels = Vec::new();
    for histogram in histograms.iter().filter(|h| !h.bins.is_empty()) {
        let panel = panel(histogram, translator);
        panels.push(Panel {
            row: index_of(&mut scenarios, &histogram.scenario),
            column: index_of(&mut quantities, &histogram.quantity),
            ..panel
        });
    }
    if panels.is_empty() {
        return Chart::empty(translator, "calibration");
    }
    for panel in &mut panels {
        if panel.row == 0 {
            quantities[panel.column].clone_into(&mut panel.title);
        }
        if panel.column == 0 {
            scenarios[panel.row].clone_into(&mut panel.y.quantity);
        }
        if panel.row + 1 == scenarios.len() {
            panel.x.ticks = Ticks::Labelled;
        }
    }
    let caption = translator.text("figure-calibration-caption");
    let mut chart = Chart::new(translator, "calibration", caption, panels);
    chart.columns = vec![1.0; quantities.len()];
    chart
}

/// The index of a name in a list, to which a new name is added.
fn index_of<'a>(names: &mut Vec<&'a str>, name: &'a str) -> usize {
    names
        .iter()
        .position(|known| *known == name)
        .unwrap_or_else(|| {
            names.push(name);
            names.len() - 1
        })
}

fn panel(histogram: &RankHistogram, translator: &Translator) -> Panel {
    let text = |id: &str| translator.text(&format!("figure-calibration-{id}"));
    let count: u32 = histogram.bins.iter().sum();
    let expected = f64::from(count) / histogram.bins.len() as f64;
    // A bin is nearly normal, with the variance of its mean.
    let spread = 2.576 * expected.sqrt();
    let highest = histogram.bins.iter().copied().max().unwrap_or(0);
    let highest = f64::from(highest).max(expected + spread);
    let step = 1.0 / histogram.bins.len() as f64;
    let bars = histogram.bins.iter().enumerate().map(|(bin, &bars)| {
        let from = step * bin as f64;
        [from + 0.15 * step, from + 0.85 * step, 0.0, f64::from(bars)]
    });
    let band = vec![[0.0, 1.0, expected - spread, expected + spread]];
    let layers = vec![
        Layer::boxes(Meaning::Expected, band)
            .pale(0.45)
            .named(text("expected")),
        Layer::boxes(Meaning::Measured, bars.collect())
            .pale(0.8)
            .named(text("drops")),
    ];
    let x = Axis::new(text("rank"), "", Scale::linear([0.0, 1.0])).with_ticks(Ticks::Grid);
    let y = Axis::new(String::new(), "", Scale::linear([0.0, 1.15 * highest]));
    Panel::new(72.0, x, y.with_ticks(Ticks::Grid), layers)
}
