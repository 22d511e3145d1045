//! One drop in words, numbers and figures.

use bouncelab::analysis::{CONFIDENT_PROBABILITY, Drop, Options};
use bouncelab::inference::{
    ApexTarget, Posterior, PriorContraction, Summary, UNINFORMATIVE, UNKNOWN,
};
use bouncelab::regression::{Estimate, Regression};

use super::page::{Block, Section, ended, sentence};
use crate::figure::{self, Subject};
use crate::messages::Translator;
use crate::quantity::{CANNOT_TELL, Quantity, Unit};
use crate::table::{Align, Table};
use crate::tables;

/// The answer of a drop in plain words: one sentence to remember, and what it rests on.
pub fn in_words(drop: &Drop) -> Vec<Block> {
    let mut words = vec![Block::Lead(kept(drop)), Block::text(heard(drop))];
    if let (Ok(found), Ok(line)) = (&drop.estimate, &drop.line) {
        words.push(Block::text(against_the_line(found, line)));
    }
    words
}

/// "The ball kept 94.6 ± 0.2 % of its speed at each bounce and fell from 30.4 ± 0.6 cm."
fn kept(drop: &Drop) -> String {
    match (&drop.estimate, drop.corrected_restitution(), &drop.line) {
        (Ok(found), ..) => {
            let e = unbroken(&measured(&found.restitution, Unit::Percent));
            let height = unbroken(&measured(&found.drop_height_m, Unit::Length));
            let which = if found.first_was_heard() || found.missed_first.is_some() {
                ""
            } else {
                " before the first impact heard"
            };
            format!("The ball kept {e} of its speed at each bounce and fell from {height}{which}.")
        }
        (_, Some(corrected), _) => format!(
            "The ball kept {} of its speed at each bounce.",
            unbroken(&estimated(corrected, Unit::Percent))
        ),
        (.., Ok(line)) => format!(
            "If there were no air, the ball kept {} of its speed at each bounce and fell from {}.",
            unbroken(&estimated(line.restitution(), Unit::Percent)),
            unbroken(&estimated(line.drop_height_m(), Unit::Length))
        ),
        (.., Err(reason)) => format!("How much the ball kept {CANNOT_TELL}: {}", ended(reason)),
    }
}

fn heard(drop: &Drop) -> String {
    let impacts = &drop.impacts;
    let span = match (impacts.first(), impacts.last()) {
        (Some(first), Some(last)) => {
            format!(" from {:.2} s to {:.2} s", first.time_s, last.time_s)
        }
        _ => String::new(),
    };
    let unsure = impacts
        .iter()
        .filter(|i| i.probability < CONFIDENT_PROBABILITY)
        .count();
    let unsure = match unsure {
        0 => "none of them uncertain".to_owned(),
        1 => "one of them uncertain".to_owned(),
        count => format!("{count} of them uncertain"),
    };
    let words = format!("{} impacts were heard{span}, {unsure}.", impacts.len());
    if let Ok(found) = &drop.estimate {
        let speed = unbroken(&Quantity::rounded(found.at_speed_m_s, 3, Unit::Speed));
        let e = unbroken(&measured(&found.restitution, Unit::Number));
        words
            + &format!(
                " The restitution, speed after an impact over speed before it, is {e} at {speed}, \
                 with the air accounted for."
            )
    } else {
        words
    }
}

/// What drag does to the straight line of the paper.
fn against_the_line(found: &Posterior, line: &Regression) -> String {
    let points = 100.0 * (found.restitution.value - line.restitution().value);
    let verdict = if points.abs() < 0.05 {
        "the same".to_owned()
    } else {
        let side = if points > 0.0 { "less" } else { "more" };
        format!("{:.1} points {side}", points.abs())
    };
    format!(
        "A straight line through the logarithms of the flight times, which knows no air, says {} \
         ({verdict}) and {}.",
        unbroken(&estimated(line.restitution(), Unit::Percent)),
        unbroken(&estimated(line.drop_height_m(), Unit::Length))
    )
}

/// Everything about one drop; `with_words` puts the answer in words first.
pub fn drop(heading: &str, drop: &Drop, settings: &Options, with_words: bool) -> Section {
    let mut blocks = if with_words {
        in_words(drop)
    } else {
        Vec::new()
    };
    blocks.extend(
        drop.warnings
            .iter()
            .map(|warning| Block::Note(sentence(&warning.to_string()))),
    );
    blocks.push(Block::table(
        "What the silences say, and what a straight line makes of them",
        answers(drop, settings),
    ));
    let subject = Subject::new(drop, settings);
    let mut parts = vec![impacts(drop, &subject), straight_line(drop, &subject)];
    match &drop.estimate {
        Ok(found) => {
            blocks.extend(
                found
                    .remarks
                    .iter()
                    .map(|remark| Block::Note(sentence(&remark.to_string()))),
            );
            parts.push(uncertainty(found, &subject));
            parts.push(laws(found, &subject));
            parts.push(told(found, &subject));
            parts.push(fit(found, &subject));
        }
        Err(reason) if settings.inference.is_some() => {
            let words = format!("there is no inference: {reason}");
            blocks.push(Block::Note(sentence(&words)));
        }
        Err(_) => {}
    }
    Section {
        heading: heading.to_owned(),
        blocks,
        parts,
    }
}

/// Posterior and straight line side by side.
fn answers(drop: &Drop, settings: &Options) -> Table {
    let mut table = Table::new([
        ("", Align::Left),
        ("inference, with air", Align::Right),
        ("95 %", Align::Right),
        ("straight line, no air", Align::Right),
    ]);
    let line = drop.line.as_ref().ok();
    let found = drop.estimate.as_ref().ok();
    let mut row = |name: &str, inferred: Option<(&Summary, Unit)>, lined: Option<String>| {
        if inferred.is_none() && lined.is_none() {
            return;
        }
        let (value, interval) = inferred.map_or_else(Default::default, |(summary, unit)| {
            let value = Quantity::measured(summary.value, summary.sd, unit);
            (value.to_string(), value.interval(summary.interval95))
        });
        table.row([name.to_owned(), value, interval, lined.unwrap_or_default()]);
    };
    let of_line = |value: fn(&Regression) -> Option<Estimate>, unit: Unit| {
        line.and_then(value).map(|value| estimated(value, unit))
    };
    row(
        "restitution e",
        found.map(|f| (&f.restitution, Unit::Number)),
        of_line(|line| Some(line.restitution()), Unit::Number),
    );
    row(
        "drop height",
        found.map(|f| (&f.drop_height_m, Unit::Length)),
        of_line(|line| Some(line.drop_height_m()), Unit::Length),
    );
    row(
        "energy kept",
        None,
        of_line(|line| Some(line.energy_kept()), Unit::Percent),
    );
    let drag = found.and_then(|f| f.drag.as_ref());
    row(
        "drag coefficient",
        drag.map(|d| (&d.coefficient, Unit::Number)),
        None,
    );
    let terminal = drag.and_then(|d| d.terminal_speed_m_s.as_ref());
    row("terminal speed", terminal.map(|t| (t, Unit::Speed)), None);
    if settings.priors.gravity_rel_sd >= UNKNOWN {
        row(
            "gravity",
            found.map(|f| (&f.gravity_m_s2, Unit::Acceleration)),
            None,
        );
    }
    row(
        "scatter from impact to impact",
        found.map(|f| (&f.scatter, Unit::Percent)),
        None,
    );
    row(
        "release until rest",
        found
            .and_then(|f| f.total_time_s.as_ref())
            .map(|t| (t, Unit::Time)),
        of_line(Regression::total_time_s, Unit::Time),
    );
    row(
        "path until rest",
        found
            .and_then(|f| f.total_path_m.as_ref())
            .map(|p| (p, Unit::Length)),
        of_line(Regression::total_path_m, Unit::Length),
    );
    for prediction in found.iter().flat_map(|f| &f.predictions) {
        let ApexTarget { bounce, apex_m } = prediction.reach;
        let apex = Quantity::rounded(apex_m, 4, Unit::Length);
        let cannot_tell = || Some(CANNOT_TELL.to_owned());
        row(
            &format!("height from which bounce {bounce} reaches {apex}"),
            prediction.drop_height_m.as_ref().map(|h| (h, Unit::Length)),
            prediction.drop_height_m.map_or_else(cannot_tell, |_| None),
        );
    }
    table
}

/// A figure of the drop, if there is one of this name.
fn drawn(name: &'static str, subject: &Subject<'_>) -> Option<Block> {
    let chart = figure::chart(name, subject, &Translator::default())?;
    Some(Block::figure(name, chart))
}

fn impacts(drop: &Drop, subject: &Subject<'_>) -> Section {
    let names = ["height", "restitution", "bounce-heights", "bounce-energies"];
    let mut blocks: Vec<Block> = names
        .iter()
        .filter_map(|name| drawn(name, subject))
        .collect();
    blocks.push(Block::table(
        "Impacts, each with the flight after it and its restitution, without and with \
         correction for drag (? marks uncertain ones)",
        tables::impacts(drop, true),
    ));
    Section::new("The impacts", blocks)
}

fn straight_line(drop: &Drop, subject: &Subject<'_>) -> Section {
    let mut blocks = Vec::new();
    match &drop.line {
        Ok(line) => {
            let flights = drop.flights.iter().filter(|flight| flight.in_line).count();
            let fits = line.r_squared().map_or_else(String::new, |r| {
                format!(", with a coefficient of determination of {r:.5}")
            });
            blocks.push(Block::text(format!(
                "It goes through {flights} flights{fits}."
            )));
            blocks.extend(drawn("flight-times", subject));
        }
        Err(reason) => blocks.push(Block::text(format!("There is none: {}", ended(reason)))),
    }
    Section::new("The straight line", blocks)
}

fn uncertainty(found: &Posterior, subject: &Subject<'_>) -> Section {
    Section::new(
        "Where the uncertainty comes from",
        vec![
            Block::table(
                "Budget of the restitution",
                tables::budget(&found.budget.restitution, Unit::Number),
            ),
            Block::table(
                "Budget of the drop height",
                tables::budget(&found.budget.drop_height_m, Unit::Length),
            ),
        ]
        .into_iter()
        .chain(drawn("budget", subject))
        .collect(),
    )
}

fn laws(found: &Posterior, subject: &Subject<'_>) -> Section {
    let mut blocks = vec![Block::table(
        "Laws of equal probability before the data",
        tables::models(found),
    )];
    blocks.extend(drawn("models", subject));
    Section::new("Which laws may be true", blocks)
}

/// What the data told, and what only the priors did.
fn told(found: &Posterior, subject: &Subject<'_>) -> Section {
    let sentences = found
        .prior_contraction
        .iter()
        .map(prior_contraction)
        .collect();
    Section::new(
        "What this recording can tell",
        std::iter::once(Block::List(sentences))
            .chain(drawn("posterior", subject))
            .chain([Block::table(
                "Correlations of the answers",
                tables::correlations(found),
            )])
            .collect(),
    )
}

fn prior_contraction(prior_contraction: &PriorContraction) -> String {
    let unknown = sentence(&prior_contraction.unknown.to_string());
    let unknown = unknown.trim_end_matches('.');
    let left = 100.0 * prior_contraction.remaining;
    if prior_contraction.remaining > UNINFORMATIVE {
        format!("{unknown}: these data say next to nothing; it is what was known before.")
    } else if prior_contraction.remaining > 0.5 {
        format!("{unknown}: the data help a little; {left:.0} % of the prior uncertainty is left.")
    } else {
        format!("{unknown}: told by the data; {left:.0} % of the prior uncertainty is left.")
    }
}

fn fit(found: &Posterior, subject: &Subject<'_>) -> Section {
    let sampling = &found.sampling;
    let mut blocks: Vec<Block> = drawn("residuals", subject).into_iter().collect();
    blocks.extend([
        Block::table(
            "The impacts as the inference has them, with the energy each took and its weight in \
             the fit",
            tables::fitted_impacts(found),
        ),
        Block::text(format!(
            "The sampling is worth {:.0} independent draws; its Pareto shape is {:.2} (good below \
             0.7).",
            sampling.effective_draws, sampling.pareto_shape
        )),
    ]);
    if let Some(drawn) = drawn("truncation", subject) {
        blocks.push(Block::text(
            "A method that is right does not change its answer with the number of flights it uses:",
        ));
        blocks.push(drawn);
    }
    Section::new("How well it fits", blocks)
}

/// A quantity in a sentence: no line ends within it.
fn unbroken(quantity: &impl ToString) -> String {
    quantity.to_string().replace(' ', "\u{a0}")
}

pub(super) fn measured(summary: &Summary, unit: Unit) -> Quantity {
    Quantity::measured(summary.value, summary.sd, unit)
}

/// A value with its standard error, or with four digits where there is none.
fn estimated(estimate: Estimate, unit: Unit) -> String {
    match estimate.standard_error {
        Some(error) => Quantity::measured(estimate.value, error, unit).to_string(),
        None => Quantity::rounded(estimate.value, 4, unit).to_string(),
    }
}
