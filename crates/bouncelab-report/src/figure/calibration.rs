//! Whether stated uncertainties hold: ranks of the truth among the draws.

use super::Figure;
use crate::canvas::{Anchor, Style};
use crate::scale::Scale;
use crate::shape::Rect;
use crate::sheet::{KeyEntry, Panel, Sheet, Swatch};
use crate::theme::{self, Meaning};

const TITLE: &str = "Where the truth lies among the draws";

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
pub fn calibration(histograms: &[RankHistogram]) -> Figure {
    const LEFT: f64 = 70.0;
    const TOP: f64 = 110.0;
    const ROW: f64 = 104.0;
    let mut scenarios: Vec<&str> = Vec::new();
    let mut quantities: Vec<&str> = Vec::new();
    for histogram in histograms.iter().filter(|h| !h.bins.is_empty()) {
        if !scenarios.contains(&histogram.scenario.as_str()) {
            scenarios.push(&histogram.scenario);
        }
        if !quantities.contains(&histogram.quantity.as_str()) {
            quantities.push(&histogram.quantity);
        }
    }
    if scenarios.is_empty() {
        return Figure::empty(200.0, TITLE, "There are no ranks to show.");
    }
    let mut sheet = Sheet::new(TOP + ROW * scenarios.len() as f64 + 40.0, TITLE);
    sheet.key(&[
        KeyEntry::new(Swatch::Dot(Meaning::Measured.colour()), "simulated drops"),
        KeyEntry::new(
            Swatch::Dot(theme::BASE_LINE.mixed(0.45)),
            "99 % of bars end here if calibrated",
        ),
    ]);
    let width = (theme::WIDTH - LEFT - 20.0) / quantities.len() as f64;
    for histogram in histograms.iter().filter(|h| !h.bins.is_empty()) {
        let row = scenarios.iter().position(|s| *s == histogram.scenario);
        let column = quantities.iter().position(|q| *q == histogram.quantity);
        let (Some(row), Some(column)) = (row, column) else {
            continue;
        };
        let left = LEFT + width * column as f64;
        let top = TOP + ROW * row as f64;
        let frame = Rect {
            left,
            top: top + 20.0,
            right: left + width - 16.0,
            bottom: top + ROW - 12.0,
        };
        draw(&mut sheet, frame, histogram, row + 1 == scenarios.len());
        if column == 0 {
            let style = Style::new(theme::LABEL_SIZE, theme::INK, Anchor::Start);
            sheet
                .canvas
                .text((16.0, top + 10.0), &histogram.scenario, style);
        }
        if row == 0 {
            let style = Style::new(theme::LABEL_SIZE, theme::SOFT_INK, Anchor::Middle);
            let middle = f64::midpoint(frame.left, frame.right);
            sheet
                .canvas
                .text((middle, TOP - 12.0), &histogram.quantity, style);
        }
    }
    Figure::new(
        sheet,
        "Flat bars: intervals hold as often as they say. A hill would mean intervals too wide, a \
         valley too narrow, a slope a bias.",
    )
}

fn draw(sheet: &mut Sheet, frame: Rect, histogram: &RankHistogram, last_row: bool) {
    let count: u32 = histogram.bins.iter().sum();
    let expected = f64::from(count) / histogram.bins.len() as f64;
    // A bin is nearly normal, with the variance of its mean.
    let spread = 2.576 * expected.sqrt();
    let highest = histogram.bins.iter().copied().max().unwrap_or(0);
    let highest = f64::from(highest).max(expected + spread);
    let x = Scale::linear([0.0, 1.0]);
    let y = Scale::linear([0.0, 1.15 * highest]);
    let name = last_row.then_some("rank of the truth");
    let panel = Panel::inset(&mut sheet.canvas, frame, [x, y], [name, None]);
    let band = [expected - spread, expected + spread];
    panel.block(
        &mut sheet.canvas,
        [0.0, 1.0],
        band,
        theme::BASE_LINE.mixed(0.45),
    );
    let step = 1.0 / histogram.bins.len() as f64;
    for (bin, &bars) in histogram.bins.iter().enumerate() {
        let from = step * bin as f64;
        let across = [from + 0.15 * step, from + 0.85 * step];
        let colour = Meaning::Measured.colour().mixed(0.8);
        panel.block(&mut sheet.canvas, across, [0.0, f64::from(bars)], colour);
    }
}
