//! The result as text.

use std::fmt::{Display, Write};

use bouncelab::Diagnostic;
use bouncelab::analysis::{CONFIDENT_PROBABILITY, Source, StrongestBand};
use bouncelab::diagnostic::Code;
use bouncelab::settings::Setup;
use bouncelab_report::messages::Value;
use bouncelab_report::quantities;
use bouncelab_report::report::ended;
use bouncelab_report::tables;

use super::answers;
use super::read::Analysed;
use crate::language::{text, text_with, translator};

/// The result of a file, as sentences and a table for each drop.
pub(crate) fn report(analysed: &Analysed, physics: &Setup, details: bool) -> String {
    let mut page = String::new();
    line(&mut page, &headline(analysed));
    if details && let Some(choice) = listening(analysed) {
        line(&mut page, &format!("  {choice}"));
    }
    for (index, drop) in analysed.result.drops.iter().enumerate() {
        line(&mut page, "");
        line(&mut page, &drop_headline(analysed, index));
        line(&mut page, "");
        if details {
            let impacts = tables::impacts(drop, true, translator());
            line(&mut page, &indented(&impacts.to_string()));
            for block in answers::details(drop) {
                line(&mut page, "");
                line(&mut page, &indented(&block));
            }
            line(&mut page, "");
        }
        // The answer last: what is above it may scroll away.
        for finding in answers::lines(drop, physics, details) {
            line(&mut page, &format!("  {finding}"));
        }
        if !drop.balls.is_empty() {
            line(&mut page, "");
            let balls = tables::balls(drop, translator());
            line(
                &mut page,
                &indented(&format!("{}\n{balls}", text("analyze-balls-heading"))),
            );
        }
        for diagnostic in quantities::notes(drop) {
            line(&mut page, &note(translator().diagnostic(diagnostic)));
        }
    }
    for diagnostic in &analysed.result.diagnostics {
        line(&mut page, &note(translator().diagnostic(diagnostic)));
    }
    // That the ball was not stated, the answer says.
    let mut assumptions = physics.assumptions.clone();
    assumptions.retain(|assumption| assumption.code != Code::BallNotStated);
    if !assumptions.is_empty() {
        line(&mut page, &assumed(&assumptions));
    }
    page
}

/// A warning, as a line.
pub(crate) fn note(remark: impl Display) -> String {
    let note = text_with("terminal-note", &[("text", ended(remark).into())]);
    format!("  {note}")
}

/// The assumptions, as a line.
pub(crate) fn assumed(assumptions: &[Diagnostic]) -> String {
    let assumptions = assumptions
        .iter()
        .map(|diagnostic| translator().diagnostic(diagnostic));
    let list = [("list", assumptions.collect::<Vec<_>>().join(" ").into())];
    format!("  {}", text_with("terminal-assumed", &list))
}

fn line(page: &mut String, content: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(page, "{}", content.trim_end());
}

fn indented(block: &str) -> String {
    let rows: Vec<String> = block.lines().map(|row| format!("  {row}")).collect();
    rows.join("\n")
}

fn headline(analysed: &Analysed) -> String {
    let name = ("name", analysed.name.as_str().into());
    match &analysed.result.source {
        Source::Times(origin) => {
            let origin = origin.description().unwrap_or_else(|| "none".to_owned());
            text_with("analyze-times", &[name, ("origin", origin.into())])
        }
        Source::Sound {
            format,
            sample_rate_hz,
            channels,
            channel,
            duration_s,
            ..
        } => {
            let rate_khz = f64::from(*sample_rate_hz) / 1000.0;
            let sound = [
                name,
                ("format", format.as_deref().unwrap_or_default().into()),
                ("rate", rate_khz.into()),
                ("channel", (*channel).into()),
                ("channels", (*channels).into()),
                ("duration", Value::fixed(*duration_s, 1)),
            ];
            text_with("analyze-sound", &sound)
        }
    }
}

/// The choices of the detection.
fn listening(analysed: &Analysed) -> Option<String> {
    let Source::Sound { onsets, .. } = &analysed.result.source else {
        return None;
    };
    let StrongestBand {
        low_hz,
        high_hz,
        above_background_db,
        ..
    } = analysed.result.strongest_band?;
    let impacts: usize = analysed
        .result
        .drops
        .iter()
        .map(|drop| drop.impacts.len())
        .sum();
    Some(text_with(
        "analyze-listening",
        &[
            ("onsets", (*onsets).into()),
            ("impacts", impacts.into()),
            ("low", Value::fixed(low_hz, 0)),
            ("high", Value::fixed(high_hz, 0)),
            ("above", Value::fixed(above_background_db, 0)),
        ],
    ))
}

fn drop_headline(analysed: &Analysed, index: usize) -> String {
    let impacts = &analysed.result.drops[index].impacts;
    let uncertain = impacts
        .iter()
        .filter(|impact| impact.probability < CONFIDENT_PROBABILITY)
        .count();
    let probability = match analysed.result.drops[index].probability {
        // Not where it would read 1.00.
        probability if probability < 0.995 => Value::fixed(probability, 2),
        _ => "none".into(),
    };
    let (first, last) = (&impacts[0], &impacts[impacts.len() - 1]);
    text_with(
        "analyze-drop",
        &[
            ("drops", analysed.result.drops.len().into()),
            ("number", (index + 1).into()),
            ("count", impacts.len().into()),
            ("first", Value::fixed(first.time_s, 3)),
            ("last", Value::fixed(last.time_s, 3)),
            ("uncertain", uncertain.into()),
            ("probability", probability),
        ],
    )
}
