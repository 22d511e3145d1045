//! All drops of a session in one table.

use bouncelab::Estimate;
use bouncelab::analysis::Drop;
use bouncelab_report::{Align, Quantity, Table, Unit};

use crate::language::{text, translator};

/// The columns of numbers: heading, unit, and what of a drop stands in it.
const COLUMNS: [Column; 4] = [
    Column {
        heading: "listen-e-line",
        unit: Unit::Number,
        of: |drop| Some(drop.log_linear_fit.as_ref().ok()?.restitution),
    },
    Column {
        heading: "listen-h0-line",
        unit: Unit::Length,
        of: |drop| Some(drop.log_linear_fit.as_ref().ok()?.drop_height_m),
    },
    Column {
        heading: "column-e",
        unit: Unit::Number,
        of: restitution,
    },
    Column {
        heading: "column-h0",
        unit: Unit::Length,
        of: height,
    },
];

struct Column {
    heading: &'static str,
    unit: Unit,
    of: fn(&Drop) -> Option<Estimate>,
}

/// The restitution with air: that of the inference, else the median over the impacts.
fn restitution(drop: &Drop) -> Option<Estimate> {
    match &drop.posterior {
        Ok(found) => Some(found.restitution),
        Err(_) => drop.per_impact_restitution(),
    }
}

fn height(drop: &Drop) -> Option<Estimate> {
    Some(drop.posterior.as_ref().ok()?.drop_height_m)
}

/// One row for each drop, then mean and scatter (standard deviation).
pub(super) fn table(drops: &[&Drop]) -> Table {
    let mut headings = vec![
        ("column-drop", Align::Right),
        ("listen-at", Align::Right),
        ("column-impacts", Align::Right),
    ];
    headings.extend(COLUMNS.iter().map(|column| (column.heading, Align::Right)));
    let mut table = Table::with_headings(translator(), headings);
    for (drop, number) in drops.iter().zip(1..) {
        let start_s = drop.impacts.first().map(|impact| impact.time_s);
        let mut row = vec![
            number.to_string(),
            start_s.map_or_else(String::new, |start_s| translator().fixed(start_s, 2)),
            drop.impacts.len().to_string(),
        ];
        row.extend(COLUMNS.iter().map(|column| {
            let shown = |estimate| crate::analyze::shown(estimate, column.unit);
            (column.of)(drop).map_or_else(String::new, shown)
        }));
        table.row(row);
    }
    let spreads = COLUMNS.map(|column| {
        let values = drops
            .iter()
            .filter_map(|drop| Some((column.of)(drop)?.value));
        (column.unit, Spread::of(&values.collect::<Vec<f64>>()))
    });
    if drops.len() > 1 {
        let mut conclude = |id: &str, shown: fn(&Spread, Unit) -> Quantity| {
            let mut row = vec![text(id), String::new(), String::new()];
            row.extend(spreads.iter().map(|(unit, spread)| {
                let shown = |spread| shown(spread, *unit).text(translator());
                spread.as_ref().map_or_else(String::new, shown)
            }));
            table.row(row);
        };
        conclude("listen-mean", |spread, unit| {
            Quantity::measured(spread.mean, spread.standard_error, unit)
        });
        conclude("listen-scatter", |spread, unit| {
            Quantity::rounded(spread.deviation, 2, unit)
        });
    }
    table
}

/// How values of several drops lie.
struct Spread {
    mean: f64,
    /// Standard deviation of a single value.
    deviation: f64,
    /// Of the mean.
    standard_error: f64,
}

impl Spread {
    /// `None` with fewer than two values that are numbers.
    fn of(values: &[f64]) -> Option<Self> {
        let values: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
        let count = values.len() as f64;
        if values.len() < 2 {
            return None;
        }
        let mean = values.iter().sum::<f64>() / count;
        let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        let deviation = (squares / (count - 1.0)).sqrt();
        Some(Self {
            mean,
            deviation,
            standard_error: deviation / count.sqrt(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_and_scatter_of_two_heights() {
        // The standard deviation of two values is their distance over the root of 2.
        let spread = Spread::of(&[0.30, 0.32]).unwrap();
        assert!((spread.mean - 0.31).abs() < 1e-12);
        assert!((spread.deviation - 0.02 / 2.0_f64.sqrt()).abs() < 1e-12);
        assert!((spread.standard_error - 0.01).abs() < 1e-12);
        assert!(Spread::of(&[0.3, f64::NAN]).is_none());
    }
}
