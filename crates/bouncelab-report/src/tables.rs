//! Which tables an analysis has: the same numbers in the terminal, in reports and in the browser.

use bouncelab::analysis::{CONFIDENT_PROBABILITY, Drop};
use bouncelab::inference::{Posterior, Share, Summary};

use crate::quantity::{Quantity, Unit};
use crate::table::{Align, Table};

/// The impacts of a drop with the flight after each and its restitution; with `details`, how surely each is
/// known. The last column marks uncertain impacts.
pub fn impacts(drop: &Drop, details: bool) -> Table {
    let mut columns = vec![
        ("impact", Align::Right),
        ("time s", Align::Right),
        ("flight s", Align::Right),
        ("apex cm", Align::Right),
        ("speed m/s", Align::Right),
        ("e no drag", Align::Right),
        ("e", Align::Right),
    ];
    if details {
        columns.extend([
            ("\u{b1} e", Align::Right),
            ("\u{b1} time \u{b5}s", Align::Right),
            ("level dB", Align::Right),
            ("probability", Align::Right),
            ("line %", Align::Right),
        ]);
    }
    columns.push(("", Align::Left));
    let mut table = Table::new(columns);
    for index in 0..drop.impacts.len() {
        table.row(impact_row(drop, index, details));
    }
    table
}

fn impact_row(drop: &Drop, index: usize, details: bool) -> Vec<String> {
    let impact = &drop.impacts[index];
    let flight = drop.flight(impact.number);
    let corrected = drop.corrected_impact(impact.number);
    let modelled = drop.modelled_flight(impact.number);
    let apex_m = modelled
        .map(|m| m.flight.apex_m)
        .or(flight.map(|f| f.plain_height_m));
    let mut row = vec![
        impact.number.to_string(),
        format!("{:.4}", impact.time_s),
        fixed(flight.map(|f| f.time_s), 4),
        fixed(apex_m.map(|apex_m| apex_m * 100.0), 2),
        fixed(corrected.map(|c| c.impact_speed_m_s), 3),
        fixed(corrected.map(|c| c.raw_ratio), 4),
        fixed(corrected.map(|c| c.restitution.value), 4),
    ];
    if details {
        row.extend([
            fixed(corrected.and_then(|c| c.restitution.standard_error), 4),
            fixed(impact.sigma_s.map(|sigma_s| sigma_s * 1e6), 1),
            fixed(impact.level_db, 1),
            format!("{:.3}", impact.probability),
            fixed(residual_percent(drop, impact.number), 2),
        ]);
    }
    row.push(
        if impact.probability < CONFIDENT_PROBABILITY {
            "?"
        } else {
            ""
        }
        .to_owned(),
    );
    row
}

/// How far the flight after an impact lies from the straight line, in per cent of its time.
fn residual_percent(drop: &Drop, number: usize) -> Option<f64> {
    let fit = drop.line.as_ref().ok()?;
    let flight = drop.flight(number)?;
    Some((flight.time_s / fit.flight_time_s(number).value - 1.0) * 100.0)
}

fn fixed(value: Option<f64>, digits: usize) -> String {
    value
        .filter(|v| v.is_finite())
        .map_or_else(String::new, |value| format!("{value:.digits$}"))
}

/// The laws that were weighed.
pub fn models(found: &Posterior) -> Table {
    let mut table = Table::new(vec![
        ("restitution law", Align::Left),
        ("drag", Align::Left),
        ("probability", Align::Right),
        ("ln evidence", Align::Right),
        ("e", Align::Right),
        ("h0", Align::Right),
    ]);
    for model in &found.models {
        let shown = |summary: &Option<Summary>, unit| {
            summary.map_or_else(String::new, |s| {
                Quantity::measured(s.value, s.sd, unit).to_string()
            })
        };
        table.row(vec![
            model.law.to_string(),
            model.drag.to_string(),
            format!("{:.3}", model.weight),
            format!("{:.1}", model.log_evidence),
            shown(&model.restitution, Unit::Number),
            shown(&model.drop_height_m, Unit::Length),
        ]);
    }
    table
}

/// Where the uncertainty of a quantity with this unit comes from; what is below a twentieth of a per cent
/// is left out.
pub fn budget(shares: &[Share], unit: Unit) -> Table {
    let mut table = Table::new(vec![
        ("source", Align::Left),
        ("alone", Align::Right),
        ("% of variance", Align::Right),
    ]);
    for share in shares.iter().filter(|share| share.share >= 0.0005) {
        table.row(vec![
            share.source.to_owned(),
            format!("\u{b1} {}", Quantity::rounded(share.sd, 2, unit)),
            format!("{:.1}", share.share * 100.0),
        ]);
    }
    table
}

/// How much the data prior_contraction each unknown.
pub fn prior_contraction(found: &Posterior) -> Table {
    let mut table = Table::new(vec![
        ("unknown", Align::Left),
        ("% of prior width left", Align::Right),
    ]);
    for prior_contraction in &found.prior_contraction {
        table.row(vec![
            prior_contraction.unknown.to_string(),
            format!("{:.0}", prior_contraction.remaining * 100.0),
        ]);
    }
    table
}

/// Correlations between the answers.
pub fn correlations(found: &Posterior) -> Table {
    let names = &found.correlations.quantities;
    let mut columns = vec![("", Align::Left)];
    columns.extend(names.iter().map(|&name| (name, Align::Right)));
    let mut table = Table::new(columns);
    for (name, row) in names.iter().zip(&found.correlations.matrix) {
        let mut cells = vec![(*name).to_owned()];
        cells.extend(row.iter().map(|value| format!("{value:.2}")));
        table.row(cells);
    }
    table
}

/// The impacts as the inference has them, with energies and weights.
pub fn fitted_impacts(found: &Posterior) -> Table {
    let mut table = Table::new(vec![
        ("impact", Align::Right),
        ("speed m/s", Align::Right),
        ("e", Align::Right),
        ("apex cm", Align::Right),
        ("to surface mJ", Align::Right),
        ("to air mJ", Align::Right),
        ("residual", Align::Right),
        ("weight", Align::Right),
    ]);
    let value = |summary: &Option<Summary>, scale: f64, digits: usize| {
        summary.map_or_else(String::new, |s| format!("{:.digits$}", s.value * scale))
    };
    for impact in &found.impacts {
        table.row(vec![
            impact.number.to_string(),
            format!("{:.3}", impact.impact_speed_m_s.value),
            value(&impact.restitution, 1.0, 4),
            value(&impact.apex_m, 100.0, 2),
            value(&impact.lost_to_surface_j, 1e3, 3),
            value(&impact.lost_to_air_j, 1e3, 3),
            impact
                .standardised_residual
                .map_or_else(String::new, |z| format!("{z:.2}")),
            format!("{:.2}", impact.weight),
        ]);
    }
    table
}
