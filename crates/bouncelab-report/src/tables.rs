//! The tables of an analysis, for terminal, reports and browser.

use bouncelab::Estimate;
use bouncelab::analysis::{CONFIDENT_PROBABILITY, Drop};
use bouncelab::drag::DragLaw;
use bouncelab::inference::{Posterior, Share, Unknown};
use bouncelab::restitution::{ImpactRestitution, LawKind};

use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::table::{Align, Table};

/// The impacts of a drop with the flight after each and its restitution, unless that is in doubt; with `details`, how
/// certain each is. The last column marks uncertain impacts.
pub fn impacts(drop: &Drop, details: bool, translator: &Translator) -> Table {
    let mut columns = vec![
        ("column-impact", Align::Right),
        ("column-time", Align::Right),
        ("column-flight", Align::Right),
        ("column-apex", Align::Right),
        ("column-speed", Align::Right),
        ("column-ratio", Align::Right),
        ("column-e", Align::Right),
    ];
    if details {
        columns.extend([
            ("column-e-error", Align::Right),
            ("column-time-error", Align::Right),
            ("column-level", Align::Right),
            ("column-probability", Align::Right),
            ("column-line", Align::Right),
        ]);
    }
    columns.push(("", Align::Left));
    let mut table = Table::with_headings(translator, columns);
    for index in 0..drop.impacts.len() {
        table.row(impact_row(drop, index, details, translator));
    }
    table
}

fn impact_row(drop: &Drop, index: usize, details: bool, translator: &Translator) -> Vec<String> {
    let impact = &drop.impacts[index];
    let flight = drop.flight(impact.number);
    let corrected = drop.impact_restitution(impact.number);
    let certain = corrected.filter(|corrected| !is_in_doubt(drop, corrected));
    let modelled = drop.modelled_flight(impact.number);
    let apex_m = modelled
        .map(|m| m.flight.apex_m)
        .or(flight.map(|f| f.drag_free_height_m));
    let fixed = |value: Option<f64>, decimals| {
        value.map_or_else(String::new, |value| translator.fixed(value, decimals))
    };
    let mut row = vec![
        impact.number.to_string(),
        translator.fixed(impact.time_s, 4),
        fixed(flight.map(|f| f.flight_time_s), 4),
        fixed(apex_m.map(|apex_m| apex_m * 100.0), 2),
        fixed(corrected.map(|c| c.impact_speed_m_s), 3),
        fixed(certain.map(|c| c.flight_time_ratio), 4),
        fixed(certain.map(|c| c.restitution.value), 4),
    ];
    if details {
        row.extend([
            fixed(corrected.and_then(|c| c.restitution.known_sd()), 4),
            fixed(impact.time_sd_s.map(|sigma_s| sigma_s * 1e6), 1),
            fixed(impact.level_db, 1),
            translator.fixed(impact.probability, 3),
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

/// Whether the restitution of an impact would mislead: an impact that it follows from is uncertain or an outlier, or its
/// standard error is large.
pub fn is_in_doubt(drop: &Drop, corrected: &ImpactRestitution) -> bool {
    /// Balls differ by this much, and impacts of one drop by far less.
    const MAX_SD: f64 = 0.05;
    let number = corrected.number;
    let mut impacts = drop.impacts.iter();
    let is_uncertain = impacts.any(|impact| {
        let is_one_of_three = impact.number.abs_diff(number) <= 1;
        is_one_of_three && impact.probability < CONFIDENT_PROBABILITY
    });
    let posterior = drop.posterior.as_ref().ok();
    is_uncertain
        || posterior.is_some_and(|it| it.is_outlier(number))
        || corrected
            .restitution
            .known_sd()
            .is_some_and(|sd| sd > MAX_SD)
}

/// How far the flight after an impact lies from the log-linear fit, in per cent of its time.
fn residual_percent(drop: &Drop, number: usize) -> Option<f64> {
    let fit = drop.log_linear_fit.as_ref().ok()?;
    let flight = drop.flight(number)?;
    Some((flight.flight_time_s / fit.flight_time_s(number).value - 1.0) * 100.0)
}

/// The name of a restitution law.
pub fn restitution_law(law: LawKind, translator: &Translator) -> String {
    translator.text(&format!("restitution-law-{}", law.name()))
}

/// The name of a drag law.
pub fn drag_law(law: &DragLaw, translator: &Translator) -> String {
    match *law {
        DragLaw::Constant(c) => translator.text_with("drag-constant", &[("coefficient", c.into())]),
        _ => translator.text(&format!("drag-{}", law.name())),
    }
}

/// The name of something that the data may determine.
pub fn unknown(unknown: Unknown, translator: &Translator) -> String {
    translator.text(&format!("quantity-{}", unknown.name()))
}

/// The name of a source of uncertainty.
pub fn source(share: &Share, translator: &Translator) -> String {
    translator.text(&format!("source-{}", share.source))
}

/// The comparison of the preset balls by the times.
pub fn balls(drop: &Drop, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("column-ball", Align::Left),
            ("column-bayes-factor", Align::Right),
            ("column-e", Align::Right),
            ("column-h0", Align::Right),
        ],
    );
    for compared in &drop.balls {
        let shown = |estimate: &Estimate, unit| Quantity::of(estimate, unit).text(translator);
        table.row([
            compared.ball.to_owned(),
            translator.fixed(compared.log_bayes_factor, 1),
            shown(&compared.restitution, Unit::Number),
            shown(&compared.drop_height_m, Unit::Length),
        ]);
    }
    table
}

/// The laws that were compared.
pub fn models(posterior: &Posterior, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("column-law", Align::Left),
            ("column-ball", Align::Left),
            ("column-probability", Align::Right),
            ("column-evidence", Align::Right),
            ("column-e", Align::Right),
            ("column-h0", Align::Right),
        ],
    );
    for model in &posterior.models {
        let shown = |summary: &Option<Estimate>, unit| {
            let text = |summary: &Estimate| Quantity::of(summary, unit).text(translator);
            summary.as_ref().map_or_else(String::new, text)
        };
        table.row(vec![
            restitution_law(model.restitution_law, translator),
            model
                .ball
                .map_or_else(String::new, |kind| translator.named("ball", kind)),
            translator.fixed(model.probability, 3),
            translator.fixed(model.log_odds, 1),
            shown(&model.restitution, Unit::Number),
            shown(&model.drop_height_m, Unit::Length),
        ]);
    }
    table
}

/// Where the uncertainty of a quantity with this unit comes from; what is below a twentieth of a per cent
/// is left out.
pub fn budget(shares: &[Share], unit: Unit, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("column-source", Align::Left),
            ("column-alone", Align::Right),
            ("column-variance", Align::Right),
        ],
    );
    for share in shares.iter().filter(|share| share.share >= 0.0005) {
        table.row(vec![
            source(share, translator),
            format!(
                "\u{b1} {}",
                Quantity::rounded(share.sd, 2, unit).text(translator)
            ),
            translator.fixed(share.share * 100.0, 1),
        ]);
    }
    table
}

/// How much the data narrowed each unknown.
pub fn prior_contraction(posterior: &Posterior, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("column-unknown", Align::Left),
            ("column-width-left", Align::Right),
        ],
    );
    for prior_contraction in &posterior.prior_contraction {
        table.row(vec![
            unknown(prior_contraction.unknown, translator),
            translator.fixed(prior_contraction.remaining * 100.0, 0),
        ]);
    }
    table
}

/// Correlations between the answers.
pub fn correlations(posterior: &Posterior, translator: &Translator) -> Table {
    let names = posterior.correlations.quantities.iter();
    let names: Vec<String> = names
        .map(|name| translator.text(&format!("quantity-{name}")))
        .collect();
    let mut columns = vec![(String::new(), Align::Left)];
    columns.extend(names.iter().map(|name| (name.clone(), Align::Right)));
    let mut table = Table::new(columns);
    for (name, row) in names.into_iter().zip(&posterior.correlations.matrix) {
        let mut cells = vec![name];
        cells.extend(row.iter().map(|value| translator.fixed(*value, 2)));
        table.row(cells);
    }
    table
}

/// The impacts as the inference has them, with energies and weights.
pub fn fitted_impacts(posterior: &Posterior, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("column-impact", Align::Right),
            ("column-speed", Align::Right),
            ("column-e", Align::Right),
            ("column-apex", Align::Right),
            ("column-to-surface", Align::Right),
            ("column-to-air", Align::Right),
            ("column-residual", Align::Right),
            ("column-weight", Align::Right),
        ],
    );
    let value = |summary: &Option<Estimate>, scale: f64, decimals: usize| {
        summary.map_or_else(String::new, |s| translator.fixed(s.value * scale, decimals))
    };
    for impact in &posterior.impacts {
        table.row(vec![
            impact.number.to_string(),
            translator.fixed(impact.impact_speed_m_s.value, 3),
            value(&impact.restitution, 1.0, 4),
            value(&impact.apex_m, 100.0, 2),
            value(&impact.lost_to_surface_j, 1e3, 3),
            value(&impact.lost_to_air_j, 1e3, 3),
            impact
                .standardised_residual
                .map_or_else(String::new, |z| translator.fixed(z, 2)),
            translator.fixed(impact.weight, 2),
        ]);
    }
    table
}
