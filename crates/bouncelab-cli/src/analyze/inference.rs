//! The inference for people.

use bouncelab::analysis::Analysis;
use bouncelab::estimate::{Inference, Prediction, Reach, Share, Summary, UNKNOWN};
use bouncelab_report::{Align, CANNOT_TELL, Quantity, Table, Unit};

use crate::physics::Physics;

/// The answers, one line for each; `None` if there is no inference to show.
pub(super) fn lines(drop: &Analysis, physics: &Physics) -> Option<Vec<String>> {
    physics.settings.question.as_ref()?;
    let found = match &drop.estimate {
        Ok(found) => found,
        Err(reason) => return Some(vec![format!("Inference: {CANNOT_TELL}: {reason}.")]),
    };
    let ball_label = &physics.ball_label;
    let infers_gravity = physics.settings.knowledge.gravity >= UNKNOWN;
    let mut lines = vec![format!("Inference, with air ({ball_label}):")];
    let speed = Quantity::rounded(found.at_speed_m_s, 3, Unit::Speed);
    lines.push(entry(
        "restitution        e  = ",
        &found.restitution,
        Unit::Number,
        &format!("at {speed}"),
    ));
    lines.push(entry(
        "drop height        h0 = ",
        &found.drop_height_m,
        Unit::Length,
        &height_note(found),
    ));
    if let Some(drag) = &found.drag {
        let prior = Quantity::measured(drag.prior.value, drag.prior.sd, Unit::Number);
        lines.push(entry(
            "drag coefficient  C_D = ",
            &drag.coefficient,
            Unit::Number,
            &format!("{prior} before the data"),
        ));
        if let Some(terminal) = &drag.terminal_speed_m_s {
            lines.push(entry("terminal speed          ", terminal, Unit::Speed, ""));
        }
    }
    if infers_gravity {
        let note = "in m/s2";
        lines.push(entry(
            "gravity            g  = ",
            &found.gravity_m_s2,
            Unit::Number,
            note,
        ));
    }
    if let Some(time) = &found.total_time_s {
        lines.push(entry("release until rest      ", time, Unit::Time, ""));
    }
    if let Some(path) = &found.total_path_m {
        lines.push(entry("path until rest         ", path, Unit::Length, ""));
    }
    lines.extend(found.predictions.iter().map(predicted));
    Some(lines)
}

/// What to know before believing it.
pub(super) fn remarks(drop: &Analysis) -> Vec<String> {
    drop.estimate.as_ref().map_or_else(
        |_| Vec::new(),
        |found| found.remarks.iter().map(ToString::to_string).collect(),
    )
}

fn height_note(found: &Inference) -> String {
    match &found.missed_first {
        None if found.first_was_heard() => String::new(),
        None => "before the first impact heard".to_owned(),
        Some(probabilities) => {
            let likely: Vec<String> = probabilities
                .iter()
                .enumerate()
                .filter(|(_, probability)| **probability >= 0.005)
                .map(|(missed, probability)| format!("{missed}: {:.0} %", probability * 100.0))
                .collect();
            format!("impacts missed before: {}", likely.join(", "))
        }
    }
}

fn predicted(prediction: &Prediction) -> String {
    let Reach { bounce, apex_m } = prediction.reach;
    let apex = Quantity::rounded(apex_m, 4, Unit::Length);
    let question = format!("bounce {bounce} reaches {apex} from");
    match &prediction.drop_height_m {
        Some(height) => entry(&format!("{question} "), height, Unit::Length, ""),
        None => format!("  {question}: {CANNOT_TELL}"),
    }
}

/// One answer, with its 95 % interval and a note.
fn entry(name: &str, summary: &Summary, unit: Unit, note: &str) -> String {
    let value = Quantity::measured(summary.value, summary.sd, unit);
    let interval = value.interval(summary.interval95);
    let note = if note.is_empty() {
        String::new()
    } else {
        format!("; {note}")
    };
    format!("  {name}{value}   (95 %: {interval}{note})")
}

/// The tables behind the answers.
pub(super) fn details(drop: &Analysis) -> Vec<String> {
    let Ok(found) = &drop.estimate else {
        return Vec::new();
    };
    let mut blocks = vec![
        format!(
            "Models, of equal probability before the data:\n{}",
            models(found)
        ),
        format!(
            "Where the uncertainty of e comes from:\n{}",
            budget(&found.budget.restitution, Unit::Number)
        ),
        format!(
            "Where the uncertainty of h0 comes from:\n{}",
            budget(&found.budget.drop_height_m, Unit::Length)
        ),
        format!(
            "How much the data narrowed what was known:\n{}",
            narrowed(found)
        ),
        format!("Correlations of the answers:\n{}", correlations(found)),
        format!("Impacts in the fit:\n{}", impacts(found)),
    ];
    let priors = found.priors();
    blocks.push(format!("Before the data:\n  {}", priors.join("\n  ")));
    blocks.push(format!(
        "Sampling: {:.0} independent draws, Pareto shape {:.2} (good below 0.7).",
        found.sampling.effective_draws, found.sampling.pareto_shape
    ));
    blocks
}

fn models(found: &Inference) -> Table {
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

fn budget(shares: &[Share], unit: Unit) -> Table {
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

fn narrowed(found: &Inference) -> Table {
    let mut table = Table::new(vec![
        ("unknown", Align::Left),
        ("% of prior width left", Align::Right),
    ]);
    for narrowed in &found.narrowed {
        table.row(vec![
            narrowed.unknown.to_string(),
            format!("{:.0}", narrowed.remaining * 100.0),
        ]);
    }
    table
}

fn correlations(found: &Inference) -> Table {
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

fn impacts(found: &Inference) -> Table {
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
