//! Where an uncertainty comes from.

use super::Figure;
use crate::canvas::{Anchor, Style};
use crate::shape::Rect;
use crate::sheet::Sheet;
use crate::theme::{self, Meaning};

const TITLE: &str = "Where the uncertainty comes from";
/// Two lines of a name have room.
const ROW: f64 = 30.0;
const HEADING: f64 = 30.0;
/// Sources below this share are added up.
const SMALL: f64 = 0.005;

/// One source of uncertainty.
#[derive(Debug, Clone, PartialEq)]
pub struct Source {
    /// What it is, in a few words.
    pub name: String,
    /// Share of the variance, 0 to 1.
    pub share: f64,
}

/// The budget of one quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Budget {
    /// The quantity with its uncertainty, as in "drop height: 30.4 ± 0.6 cm".
    pub quantity: String,
    /// The sources, in any order.
    pub sources: Vec<Source>,
}

/// Bars for the share of each source in the variance of each quantity, largest first.
pub fn budget(budgets: &[Budget]) -> Figure {
    let groups: Vec<(&str, Vec<Source>)> = budgets
        .iter()
        .map(|budget| (budget.quantity.as_str(), shown(&budget.sources)))
        .filter(|(_, sources)| !sources.is_empty())
        .collect();
    if groups.is_empty() {
        return Figure::empty(200.0, TITLE, "There is no uncertainty to take apart.");
    }
    let rows: usize = groups.iter().map(|(_, sources)| sources.len()).sum();
    let height = 58.0 + HEADING * groups.len() as f64 + ROW * rows as f64;
    let mut sheet = Sheet::new(height, TITLE);
    let mut y = 50.0;
    for (quantity, sources) in &groups {
        let mut style = Style::new(theme::LABEL_SIZE, theme::INK, Anchor::Start);
        style.bold = true;
        sheet.canvas.text((16.0, y + 18.0), *quantity, style);
        y += HEADING;
        for source in sources {
            bar(&mut sheet, y, source);
            y += ROW;
        }
    }
    Figure::new(
        sheet,
        "Each bar is a source's share of the variance: to know the ball better, improve what is on \
         top.",
    )
}

/// Sorted, with the small ones added up.
fn shown(sources: &[Source]) -> Vec<Source> {
    let usable = sources
        .iter()
        .filter(|s| s.share.is_finite() && s.share > 0.0);
    let (mut large, small): (Vec<Source>, Vec<Source>) =
        usable.cloned().partition(|source| source.share >= SMALL);
    large.sort_by(|a, b| b.share.total_cmp(&a.share));
    let rest: f64 = small.iter().map(|source| source.share).sum();
    if rest >= 0.0005 && !large.is_empty() {
        large.push(Source {
            name: "all others".to_owned(),
            share: rest,
        });
    }
    large
}

fn bar(sheet: &mut Sheet, y: f64, source: &Source) {
    const LEFT: f64 = 200.0;
    const RIGHT: f64 = 560.0;
    let name = Style::new(theme::TICK_SIZE, theme::SOFT_INK, Anchor::End);
    let place = (LEFT - 10.0, y + 19.0);
    sheet
        .canvas
        .text_wrapped(LEFT - 30.0, place, source.name.as_str(), name);
    let bar = Rect {
        left: LEFT,
        top: y + 5.0,
        right: LEFT + (RIGHT - LEFT) * source.share.min(1.0),
        bottom: y + ROW - 5.0,
    };
    sheet.canvas.block(bar, Meaning::Measured.colour());
    let number = Style::new(theme::TICK_SIZE, theme::INK, Anchor::Start);
    let percent = source.share * 100.0;
    let text = if percent < 9.95 {
        format!("{percent:.1} %")
    } else {
        format!("{percent:.0} %")
    };
    sheet.canvas.text((bar.right + 8.0, y + 19.0), text, number);
}
