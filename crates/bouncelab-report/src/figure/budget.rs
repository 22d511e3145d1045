//! The uncertainty budget.

use bouncelab::inference::{Posterior, Share};

use crate::chart::{Axis, Chart, Layer, Panel, Scale, Ticks, row_middle};
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::tables;
use crate::theme::Meaning;

/// Height of a row.
const ROW: f64 = 30.0;
/// Sources below this share are added up.
const SMALL: f64 = 0.005;
/// Smaller shares are not written.
const MIN_WRITTEN: f64 = 0.0005;

/// Bars for the share of each source in the variance of restitution and drop height, largest first.
pub(super) fn budget(posterior: &Posterior, translator: &Translator) -> Chart {
    let restitution = Quantity::of(&posterior.restitution, Unit::Number);
    let height = Quantity::of(&posterior.drop_height_m, Unit::Length);
    let title = |id: &str, value: Quantity| {
        translator.text_with(&format!("figure-budget-{id}"), &[("value", value.into())])
    };
    let shares = [
        (
            title("restitution", restitution),
            &posterior.budget.restitution,
        ),
        (
            title("drop-height", height),
            &posterior.budget.drop_height_m,
        ),
    ];
    let mut panels = Vec::new();
    for (title, shares) in shares {
        if let Some(panel) = bars(title, shares, translator) {
            let row = panels.len();
            panels.push(Panel { row, ..panel });
        }
    }
    if panels.is_empty() {
        return Chart::empty(translator, "budget");
    }
    let caption = translator.text("figure-budget-caption");
    Chart::new(translator, "budget", caption, panels)
}

fn bars(title: String, shares: &[Share], translator: &Translator) -> Option<Panel> {
    let sources = sources(shares, translator);
    let rows = sources.len();
    if rows == 0 {
        return None;
    }
    let (mut bars, mut ends, mut texts) = (Vec::new(), Vec::new(), Vec::new());
    for (row, (_, share)) in sources.iter().enumerate() {
        let middle = row_middle(rows, row);
        let percent = 100.0 * share;
        bars.push([0.0, percent, middle - 0.33, middle + 0.33]);
        ends.push([percent, middle]);
        let decimals = usize::from(percent < 9.95);
        texts.push(translator.number(&format!("{percent:.decimals$}\u{a0}%")));
    }
    let names = sources.into_iter().map(|(name, _)| name);
    // A margin for the share to the right of the longest bar.
    let scale = Scale::linear([0.0, 100.0]).padded(0.0, 0.15);
    let x = Axis::new(translator.text("figure-budget-axis"), "%", scale);
    let layers = vec![
        Layer::boxes(Meaning::Measured, bars),
        Layer::labels(ends, texts),
    ];
    let y = Axis::of_names(names.collect());
    let panel = Panel::new(ROW * rows as f64, x.with_ticks(Ticks::Hidden), y, layers);
    Some(Panel { title, ..panel })
}

/// Names and shares, the largest first as in the budget, with the small ones added up.
fn sources(shares: &[Share], translator: &Translator) -> Vec<(String, f64)> {
    let usable = shares
        .iter()
        .filter(|s| s.share.is_finite() && s.share > 0.0);
    let (large, small): (Vec<&Share>, Vec<&Share>) = usable.partition(|share| share.share >= SMALL);
    let rest: f64 = small.iter().map(|share| share.share).sum();
    let rest = (rest >= MIN_WRITTEN && !large.is_empty())
        .then(|| (translator.text("figure-budget-others"), rest));
    let named = |share: &Share| (tables::source(share, translator), share.share);
    large.into_iter().map(named).chain(rest).collect()
}
