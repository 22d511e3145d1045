//! All drops of a session in one table.

use bouncelab::Estimate;
use bouncelab::analysis::Drop;
use bouncelab_report::{Align, Quantity, Table, Unit};

use crate::language::{text, translator};

/// The columns of numbers: heading, unit, and value of a drop.
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

/// One row for each drop, then the mean and the scatter (standard deviation of a single drop).
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
            let estimate = (column.of)(drop);
            estimate.map_or_else(String::new, |estimate| {
                Quantity::of(&estimate, column.unit).text(translator())
            })
        }));
        table.row(row);
    }
    if drops.len() > 1 {
        let means = COLUMNS.map(|column| {
            let values = drops
                .iter()
                .filter_map(|drop| Some((column.of)(drop)?.value));
            Scattered::of(
                &values
                    .filter(|value| value.is_finite())
                    .collect::<Vec<f64>>(),
            )
        });
        let mut conclude = |id: &str, shown: fn(&Scattered, Unit) -> Quantity| {
            let mut row = vec![text(id), String::new(), String::new()];
            row.extend(std::iter::zip(&COLUMNS, &means).map(|(column, mean)| {
                let shown = |mean| shown(mean, column.unit).text(translator());
                mean.as_ref().map_or_else(String::new, shown)
            }));
            table.row(row);
        };
        conclude("listen-mean", |of, unit| {
            Quantity::measured(of.mean, of.sd / of.count.sqrt(), unit)
        });
        conclude("listen-scatter", |of, unit| {
            Quantity::rounded(of.sd, 2, unit)
        });
    }
    table
}

/// The mean and the standard deviation of two values or more.
struct Scattered {
    count: f64,
    mean: f64,
    sd: f64,
}

impl Scattered {
    fn of(values: &[f64]) -> Option<Self> {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        (values.len() > 1).then(|| Self {
            count,
            mean,
            sd: (squares / (count - 1.0)).sqrt(),
        })
    }
}
