//! The estimates, and the result of the inference, as text.

use bouncelab::Estimate;
use bouncelab::analysis::Drop;
use bouncelab::inference::{ApexTarget, Posterior, Prediction, UNKNOWN};
use bouncelab::setup::Setup;
use bouncelab_report::messages::Value;
use bouncelab_report::{Quantity, Unit, tables};
use unicode_width::UnicodeWidthStr;

use crate::language::{cannot_tell, text, text_with, translated, translator};

/// A quantity with its value: a line of a list.
pub(super) struct Answer {
    name: String,
    symbol: &'static str,
    value: String,
    note: Option<String>,
}

impl Answer {
    /// Without a note; the symbol may be empty.
    pub(super) fn new(name: String, symbol: &'static str, value: String) -> Self {
        Self {
            name,
            symbol,
            value,
            note: None,
        }
    }

    /// With a remark behind the value.
    pub(super) fn noted(self, note: String) -> Self {
        Self {
            note: Some(note),
            ..self
        }
    }

    /// A summary with its 95 % interval, and more that stands beside it.
    fn inferred(
        name: String,
        symbol: &'static str,
        summary: &Estimate,
        unit: Unit,
        more: &[String],
    ) -> Self {
        if summary.sd == 0.0 {
            let value = Quantity::rounded(summary.value, 4, unit).text(translator());
            return Self::new(name, symbol, value).noted(format!("({})", text("analyze-known")));
        }
        let value = Quantity::measured(summary.value, summary.sd, unit);
        let interval = value.interval_text(summary.interval95, translator());
        let interval = text_with("analyze-interval", &[("interval", interval.into())]);
        let notes = std::iter::once(interval).chain(more.iter().cloned());
        let notes = translator().in_one_line(notes);
        Self::new(name, symbol, value.text(translator())).noted(format!("({notes})"))
    }
}

/// A heading and the answers below it, their values in one column.
pub(super) fn listed(heading: String, answers: &[Answer]) -> Vec<String> {
    /// The longest name in English.
    const USUAL: usize = 18;
    let widths = answers.iter().map(|answer| answer.name.width());
    let width = widths.fold(USUAL, usize::max);
    let lines = answers.iter().map(|answer| {
        let space = " ".repeat(width - answer.name.width());
        let symbol = match answer.symbol {
            "" => String::new(),
            symbol => format!("{symbol} ="),
        };
        let note = answer.note.iter().map(|note| format!("   {note}"));
        let note: String = note.collect();
        format!("  {}{space}{symbol:>5} {}{note}", answer.name, answer.value)
    });
    std::iter::once(heading).chain(lines).collect()
}

/// What the inference answers, one line for each; nothing if it was not asked for.
pub(super) fn lines(drop: &Drop, physics: &Setup) -> Vec<String> {
    if physics.options.inference.is_none() {
        return Vec::new();
    }
    let found = match &drop.posterior {
        Ok(found) => found,
        Err(reason) => return vec![cannot_tell("analyze-inference", translated(reason))],
    };
    let answer = |name: &str, symbol, summary: &Estimate, unit, more: &[String]| {
        Answer::inferred(text(name), symbol, summary, unit, more)
    };
    let speed = Quantity::rounded(found.at_speed_m_s, 3, Unit::Speed);
    let speed = text_with("analyze-at-speed", &[("speed", speed.into())]);
    let (restitution, height) = (&found.restitution, &found.drop_height_m);
    let missed: Vec<String> = height_note(found).into_iter().collect();
    let mut answers = vec![
        answer(
            "quantity-restitution",
            "e ",
            restitution,
            Unit::Number,
            &[speed],
        ),
        answer("quantity-drop-height", "h0", height, Unit::Length, &missed),
    ];
    if let (Some(coefficient), Some(prior)) =
        (&found.drag_coefficient, found.drag_coefficient_prior)
    {
        let prior = match prior.sd {
            0.0 => text("analyze-known"),
            sd => {
                let value = Quantity::measured(prior.value, sd, Unit::Number);
                text_with("analyze-before-data", &[("value", value.into())])
            }
        };
        answers.push(answer(
            "quantity-drag-coefficient",
            "C_D",
            coefficient,
            Unit::Number,
            &[prior],
        ));
        let terminal = found.terminal_speed_m_s.iter();
        answers.extend(
            terminal.map(|speed| answer("quantity-terminal-speed", "", speed, Unit::Speed, &[])),
        );
    }
    if physics.options.priors.gravity_rel_sd >= UNKNOWN {
        let gravity = &found.gravity_m_s2;
        answers.push(answer(
            "quantity-gravity",
            "g ",
            gravity,
            Unit::Acceleration,
            &[],
        ));
    }
    if let Some(time) = &found.total_time_s {
        answers.push(answer(
            "quantity-release-until-rest",
            "",
            time,
            Unit::Time,
            &[],
        ));
    }
    if let Some(path) = &found.total_path_m {
        answers.push(answer(
            "quantity-path-until-rest",
            "",
            path,
            Unit::Length,
            &[],
        ));
    }
    answers.extend(found.predictions.iter().map(predicted));
    let ball = [("ball", translator().ball(&physics.ball).into())];
    listed(text_with("analyze-inference-heading", &ball), &answers)
}

fn height_note(found: &Posterior) -> Option<String> {
    match &found.missed_first_impacts {
        None if found.first_was_detected() => None,
        None => Some(text("analyze-first-fall")),
        Some(probabilities) => {
            let likely: Vec<String> = probabilities
                .iter()
                .enumerate()
                .filter(|(_, probability)| **probability >= 0.005)
                .map(|(missed, probability)| format!("{missed}: {:.0} %", probability * 100.0))
                .collect();
            Some(text_with(
                "analyze-missed",
                &[("list", likely.join(", ").into())],
            ))
        }
    }
}

fn predicted(prediction: &Prediction) -> Answer {
    let ApexTarget { bounce, apex_m } = prediction.target;
    let apex = Quantity::rounded(apex_m, 4, Unit::Length);
    let target = [("bounce", bounce.into()), ("apex", apex.into())];
    let name = text_with("analyze-reach", &target);
    match &prediction.drop_height_m {
        Some(height) => Answer::inferred(name, "", height, Unit::Length, &[]),
        None => Answer::new(name, "", text("unit-cannot-tell")),
    }
}

/// The tables behind the answers.
pub(super) fn details(drop: &Drop) -> Vec<String> {
    let Ok(found) = &drop.posterior else {
        return Vec::new();
    };
    let words = translator();
    let budget = &found.budget;
    let tables = [
        ("analyze-details-models", tables::models(found, words)),
        (
            "analyze-details-budget-restitution",
            tables::budget(&budget.restitution, Unit::Number, words),
        ),
        (
            "analyze-details-budget-height",
            tables::budget(&budget.drop_height_m, Unit::Length, words),
        ),
        (
            "analyze-details-contraction",
            tables::prior_contraction(found, words),
        ),
        (
            "analyze-details-correlations",
            tables::correlations(found, words),
        ),
        (
            "analyze-details-impacts",
            tables::fitted_impacts(found, words),
        ),
    ];
    let tables = tables.into_iter();
    let mut blocks: Vec<String> = tables
        .map(|(heading, table)| format!("{}\n{table}", text(heading)))
        .collect();
    let priors = found
        .priors
        .iter()
        .map(|known| words.diagnostic(known))
        .collect::<Vec<_>>()
        .join("\n  ");
    blocks.push(format!("{}\n  {priors}", text("analyze-details-priors")));
    let sampling = [
        ("draws", Value::fixed(found.sampling.effective_draws, 0)),
        ("shape", Value::fixed(found.sampling.pareto_shape, 2)),
    ];
    blocks.push(text_with("analyze-details-sampling", &sampling));
    blocks
}
