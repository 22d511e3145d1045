//! The inference for people.

use bouncelab::analysis::Drop;
use bouncelab::inference::{ApexTarget, Posterior, Prediction, Summary, UNKNOWN};
use bouncelab_report::report::ended;
use bouncelab_report::{CANNOT_TELL, Quantity, Unit, tables};

use crate::physics::Physics;

/// The answers, one line for each; `None` if there is no inference to show.
pub(super) fn lines(drop: &Drop, physics: &Physics) -> Option<Vec<String>> {
    physics.settings.inference.as_ref()?;
    let found = match &drop.estimate {
        Ok(found) => found,
        Err(reason) => {
            return Some(vec![format!("Posterior: {CANNOT_TELL}: {}", ended(reason))]);
        }
    };
    let ball_label = &physics.ball_label;
    let infers_gravity = physics.settings.priors.gravity_rel_sd >= UNKNOWN;
    let mut lines = vec![format!("Posterior, with air ({ball_label}):")];
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
        let prior = match drag.prior.sd {
            0.0 => "taken as known".to_owned(),
            sd => format!(
                "{} before the data",
                Quantity::measured(drag.prior.value, sd, Unit::Number)
            ),
        };
        lines.push(entry(
            "drag coefficient  C_D = ",
            &drag.coefficient,
            Unit::Number,
            &prior,
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
pub(super) fn remarks(drop: &Drop) -> Vec<String> {
    drop.estimate.as_ref().map_or_else(
        |_| Vec::new(),
        |found| found.remarks.iter().map(ToString::to_string).collect(),
    )
}

fn height_note(found: &Posterior) -> String {
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
    let ApexTarget { bounce, apex_m } = prediction.reach;
    let apex = Quantity::rounded(apex_m, 4, Unit::Length);
    let inference = format!("bounce {bounce} reaches {apex} from");
    match &prediction.drop_height_m {
        Some(height) => entry(&format!("{inference} "), height, Unit::Length, ""),
        None => format!("  {inference}: {CANNOT_TELL}"),
    }
}

/// One answer, with its 95 % interval and a note.
fn entry(name: &str, summary: &Summary, unit: Unit, note: &str) -> String {
    if summary.sd == 0.0 {
        let value = Quantity::rounded(summary.value, 4, unit);
        return format!("  {name}{value}   (taken as known)");
    }
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
pub(super) fn details(drop: &Drop) -> Vec<String> {
    let Ok(found) = &drop.estimate else {
        return Vec::new();
    };
    let mut blocks = vec![
        format!(
            "Models, of equal probability before the data:\n{}",
            tables::models(found)
        ),
        format!(
            "Where the uncertainty of e comes from:\n{}",
            tables::budget(&found.budget.restitution, Unit::Number)
        ),
        format!(
            "Where the uncertainty of h0 comes from:\n{}",
            tables::budget(&found.budget.drop_height_m, Unit::Length)
        ),
        format!(
            "How much the data prior_contraction what was known:\n{}",
            tables::prior_contraction(found)
        ),
        format!(
            "Correlations of the answers:\n{}",
            tables::correlations(found)
        ),
        format!("Impacts in the fit:\n{}", tables::fitted_impacts(found)),
    ];
    let priors = found.priors();
    blocks.push(format!("Before the data:\n  {}", priors.join("\n  ")));
    blocks.push(format!(
        "Sampling: {:.0} independent draws, Pareto shape {:.2} (good below 0.7).",
        found.sampling.effective_draws, found.sampling.pareto_shape
    ));
    blocks
}
