//! Values with their intervals, and the limits of a rule.

use bouncelab::Estimate;
use bouncelab::rulebook::{Limits, Rebound, Rule, Verdict};

use crate::chart::{Axis, Chart, Layer, Marker, Panel, Scale, row_middle, xs};
use crate::messages::Translator;
use crate::theme::Meaning;

const ROW: f64 = 30.0;
/// More rows than this are no figure any more.
const MAX_ROWS: usize = 40;
/// Beyond any axis.
const ENDLESS: f64 = 1e30;

/// A value to be held against limits.
#[derive(Debug, Clone, PartialEq)]
pub struct EvaluatedValue {
    /// Name in a few words.
    pub name: String,
    /// The value.
    pub value: f64,
    /// Its 95 % credible interval, if it is known.
    pub interval95: Option<[f64; 2]>,
    /// Whether the decision is about this value; the others lead to it.
    pub decides: bool,
}

/// One row for each value, over the range between the limits and, darker, the range in which a value
/// of this uncertainty is accepted.
pub fn limits(
    evaluated: &[EvaluatedValue],
    limits: [Option<f64>; 2],
    accepted: [Option<f64>; 2],
    (quantity, unit): (String, &str),
    translator: &Translator,
) -> Chart {
    let text = |id: &str| translator.text(&format!("figure-limits-{id}"));
    let usable = evaluated
        .iter()
        .filter(|evaluated| evaluated.value.is_finite());
    let usable: Vec<&EvaluatedValue> = usable.take(MAX_ROWS).collect();
    let rows = usable.len();
    if rows == 0 {
        return Chart::empty(translator, "limits");
    }
    let lines = limits.into_iter().flatten().map(|limit| {
        let line = vec![[limit, 0.0], [limit, rows as f64]];
        Layer::line(Meaning::Accepted, line).with_width(1.5)
    });
    let mut layers: Vec<Layer> = lines.collect();
    layers.extend(values(&usable, true, translator));
    layers.extend(values(&usable, false, translator));
    let scale = Scale::linear(xs(&layers)).padded(0.08, 0.08);
    let shades = [
        shade(limits, rows, 0.12, text("within")),
        shade(accepted, rows, 0.25, text("accepted")),
    ];
    let names = usable
        .iter()
        .map(|evaluated| evaluated.name.replace('\n', " "));
    let x = Axis::new(quantity, unit, scale);
    let y = Axis::of_names(names.collect());
    let layers = shades.into_iter().flatten().chain(layers).collect();
    let panel = Panel::new(ROW * rows as f64, x, y, layers);
    Chart::new(translator, "limits", text("caption"), vec![panel])
}

/// The values that decide, or those that lead to them, with their intervals: each in its row.
fn values(usable: &[&EvaluatedValue], decides: bool, translator: &Translator) -> [Layer; 2] {
    let (meaning, width) = if decides {
        (Meaning::Measured, 8.0)
    } else {
        (Meaning::Soft, 4.0)
    };
    let (mut intervals, mut values) = (Vec::new(), Vec::new());
    for (row, evaluated) in usable.iter().enumerate() {
        if evaluated.decides == decides {
            let middle = row_middle(usable.len(), row);
            if let Some([low, high]) = evaluated.interval95 {
                intervals.extend([[low, middle], [high, middle], [f64::NAN; 2]]);
            }
            values.push([evaluated.value, middle]);
        }
    }
    let name = if intervals.is_empty() {
        String::new()
    } else {
        translator.text("figure-limits-interval")
    };
    let intervals = Layer::line(meaning, intervals).with_width(width).pale(0.45);
    [
        intervals.named(name),
        Layer::points(meaning, Marker::Dot, values),
    ]
}

/// The range between two ends over all rows; nothing without an end.
fn shade(
    [least, greatest]: [Option<f64>; 2],
    rows: usize,
    strength: f64,
    name: String,
) -> Option<Layer> {
    let ends = [least.unwrap_or(-ENDLESS), greatest.unwrap_or(ENDLESS)];
    let some = least.is_some() || greatest.is_some();
    let boxes = vec![[ends[0], ends[1], 0.0, rows as f64]];
    some.then(|| {
        Layer::boxes(Meaning::Accepted, boxes)
            .pale(strength)
            .named(name)
    })
}

/// What a verdict is about, and every drop that led to it, against the limits of the rule. `files` names
/// the places in order.
pub fn verdict(rule: &Rule, verdict: &Verdict, files: &[String], translator: &Translator) -> Chart {
    /// Metres to centimetres, shares to percent.
    const SHOWN: f64 = 100.0;
    let decides = verdict.value();
    let (wanted, quantity, unit) = if rule.needs_reference() {
        (rule.limits(), "axis-share-of-reference", "%")
    } else {
        (rule.limits(), "axis-rebound", "cm")
    };
    let scaled = |limits: Limits| [limits.least, limits.greatest].map(|end| Some(end? * SHOWN));
    let evaluated = |name: String, estimate: &Estimate, decides: bool| EvaluatedValue {
        name,
        value: estimate.value * SHOWN,
        interval95: Some(estimate.interval95.map(|end| end * SHOWN)),
        decides,
    };
    let named = [
        ("verdict-all-drops", decides, true),
        ("verdict-model", verdict.model, false),
    ];
    let mut rows: Vec<EvaluatedValue> = named
        .iter()
        .filter_map(|(id, estimate, decides)| {
            Some(evaluated(translator.text(id), estimate.as_ref()?, *decides))
        })
        .collect();
    if !rule.needs_reference() {
        let name = |drop: &Rebound| files.get(drop.place).cloned().unwrap_or_default();
        let drops = verdict.drops.iter();
        rows.extend(drops.filter_map(|drop| {
            Some(EvaluatedValue {
                name: name(drop),
                value: drop.height_m? * SHOWN,
                interval95: None,
                decides: false,
            })
        }));
    }
    let accepted = verdict.accepted.map_or([None; 2], scaled);
    limits(
        &rows,
        scaled(wanted),
        accepted,
        (translator.text(quantity), unit),
        translator,
    )
}
