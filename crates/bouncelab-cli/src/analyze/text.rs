//! The result for people.

use std::fmt::Write;

use bouncelab::analysis::{CONFIDENT_PROBABILITY, Drop};
use bouncelab::regression::Estimate;
use bouncelab_report::document::Origin;
use bouncelab_report::report::ended;
use bouncelab_report::{CANNOT_TELL, Quantity, Unit, tables};

use super::hear::{Clearest, Hearing};
use super::inference;
use crate::physics::Physics;

/// What a file says, in words and a table for each drop.
pub(crate) fn report(hearing: &Hearing, physics: &Physics, details: bool) -> String {
    let mut text = String::new();
    line(&mut text, &headline(hearing));
    if details && let Some(choice) = listening(hearing) {
        line(&mut text, &format!("  {choice}"));
    }
    for (index, drop) in hearing.drops.iter().enumerate() {
        line(&mut text, "");
        line(&mut text, &drop_headline(hearing, index));
        line(&mut text, "");
        for finding in findings(drop, physics) {
            line(&mut text, &format!("  {finding}"));
        }
        line(&mut text, "");
        line(
            &mut text,
            &indented(&tables::impacts(drop, details).to_string()),
        );
        if details {
            for block in inference::details(drop) {
                line(&mut text, "");
                line(&mut text, &indented(&block));
            }
            line(&mut text, "");
        }
        for warning in &drop.warnings {
            line(&mut text, &format!("  Note: {}", ended(warning)));
        }
        for remark in inference::remarks(drop) {
            line(&mut text, &format!("  Note: {}", ended(remark)));
        }
    }
    for warning in &hearing.warnings {
        line(&mut text, &format!("  Note: {}", ended(warning)));
    }
    if !physics.assumptions.is_empty() {
        line(
            &mut text,
            &format!("  Assumed: {}.", physics.assumptions.join("; ")),
        );
    }
    text
}

fn line(text: &mut String, words: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", words.trim_end());
}

fn indented(block: &str) -> String {
    let rows: Vec<String> = block.lines().map(|row| format!("  {row}")).collect();
    rows.join("\n")
}

fn headline(hearing: &Hearing) -> String {
    match &hearing.origin {
        Origin::Times => format!("{}: impact times", hearing.name),
        Origin::Sound {
            format,
            sample_rate_hz,
            channels,
            channel,
            duration_s,
            ..
        } => {
            let heard = match channels {
                1 => String::new(),
                _ => format!(", channel {channel} of {channels}"),
            };
            let rate = f64::from(*sample_rate_hz) / 1000.0;
            format!(
                "{}: {format}, {rate} kHz{heard}, {duration_s:.1} s",
                hearing.name
            )
        }
    }
}

/// What was chosen in listening.
fn listening(hearing: &Hearing) -> Option<String> {
    let Origin::Sound { onsets, .. } = &hearing.origin else {
        return None;
    };
    let Clearest { band_hz, above_db } = hearing.clearest.as_ref()?;
    let impacts: usize = hearing.drops.iter().map(|drop| drop.impacts.len()).sum();
    Some(format!(
        "{onsets} sounds stand out of the background and {impacts} impacts were heard, clearest from \
         {:.0} to {:.0} Hz, {above_db:.0} dB above the sound before them (--channel, --band).",
        band_hz.start, band_hz.end,
    ))
}

fn drop_headline(hearing: &Hearing, index: usize) -> String {
    let impacts = &hearing.drops[index].impacts;
    let which = match hearing.drops.len() {
        1 => "Drop".to_owned(),
        count => format!("Drop {} of {count}", index + 1),
    };
    let (first, last) = (&impacts[0], &impacts[impacts.len() - 1]);
    let doubtful = impacts
        .iter()
        .filter(|impact| impact.probability < CONFIDENT_PROBABILITY)
        .count();
    let doubt = match doubtful {
        0 => String::new(),
        _ => format!(", {doubtful} uncertain (?)"),
    };
    let sure = match hearing.probabilities.get(index) {
        // Not where it would read 1.00.
        Some(probability) if *probability < 0.995 => {
            format!(" (a drop with probability {probability:.2})")
        }
        _ => String::new(),
    };
    let count = impacts.len();
    format!(
        "{which}: {count} impacts from {:.3} s to {:.3} s{doubt}{sure}",
        first.time_s, last.time_s
    )
}

/// The results, one line for each.
fn findings(drop: &Drop, physics: &Physics) -> Vec<String> {
    let mut lines = Vec::new();
    match &drop.line {
        Ok(fit) => {
            let flights = drop.flights.iter().filter(|flight| flight.in_line).count();
            lines
                .push("Straight line through log flight time, as if there were no air:".to_owned());
            lines.push(format!(
                "  restitution        e  = {}",
                shown(fit.restitution(), Unit::Number)
            ));
            lines.push(format!(
                "  drop height        h0 = {}   (before the first impact heard; {flights} flights)",
                shown(fit.drop_height_m(), Unit::Length)
            ));
            lines.push(format!(
                "  energy kept             {}",
                shown(fit.energy_kept(), Unit::Percent)
            ));
            if let (Some(time), Some(path)) = (fit.total_time_s(), fit.total_path_m()) {
                lines.push(format!(
                    "  until rest              {}",
                    shown(time, Unit::Time)
                ));
                lines.push(format!(
                    "  path until rest         {}",
                    shown(path, Unit::Length)
                ));
            }
        }
        Err(reason) => lines.push(format!("Straight line: {CANNOT_TELL}: {}", ended(reason))),
    }
    match inference::lines(drop, physics) {
        Some(inferred) if drop.estimate.is_ok() => lines.extend(inferred),
        Some(inferred) => {
            lines.extend(corrected_lines(drop, physics));
            lines.extend(inferred);
        }
        None => lines.extend(corrected_lines(drop, physics)),
    }
    lines
}

fn corrected_lines(drop: &Drop, physics: &Physics) -> Vec<String> {
    let found = match &drop.corrected {
        Ok(found) => found,
        Err(reason) => {
            return vec![format!(
                "Corrected for drag: {CANNOT_TELL}: {}",
                ended(reason)
            )];
        }
    };
    let count = found.impacts.len();
    let (Some(restitution), Some((slowest, fastest))) =
        (drop.corrected_restitution(), drop.speed_range_m_s())
    else {
        return vec![format!(
            "Corrected for drag: {CANNOT_TELL} a mean: {count} of the impacts lie between two \
             flights, and it takes 3."
        )];
    };
    vec![
        format!(
            "Corrected for drag ({}, {}):",
            physics.ball_label, physics.settings.environment.drag
        ),
        format!(
            "  restitution        e  = {}   (median of {count} impacts at {slowest:.2} to \
             {fastest:.2} m/s)",
            shown(restitution, Unit::Number)
        ),
    ]
}

/// A value with its standard error, or with four digits where there is none.
pub(crate) fn shown(estimate: Estimate, unit: Unit) -> String {
    match estimate.standard_error {
        Some(error) => Quantity::measured(estimate.value, error, unit).to_string(),
        None => Quantity::rounded(estimate.value, 4, unit).to_string(),
    }
}
