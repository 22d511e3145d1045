//! What was known, what was assumed, and what it was heard with.

use bouncelab::analysis::Settings;
use bouncelab::estimate::Measured;

use super::page::{Block, Section, sentence};
use super::subject::Recording;
use crate::document::Origin;
use crate::quantity::{Quantity, Unit};

/// Recording, ball, air and gravity, what of it nobody stated, and the priors.
pub fn conditions(recording: &Recording) -> Section {
    let heard_with = heard_with(recording.origin);
    let Recording {
        settings,
        ball_label,
        assumptions,
        ..
    } = recording;
    of_all(heard_with, settings, ball_label, assumptions)
}

/// Ball, air and gravity of several recordings, what of it nobody stated, and the priors.
pub fn shared_conditions(settings: &Settings, ball_label: &str, assumptions: &[String]) -> Section {
    of_all(Vec::new(), settings, ball_label, assumptions)
}

fn of_all(
    mut facts: Vec<(&'static str, String)>,
    settings: &Settings,
    ball_label: &str,
    assumptions: &[String],
) -> Section {
    facts.extend(known(settings, ball_label));
    let facts = facts
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect();
    let mut blocks = vec![Block::Facts(facts)];
    if !assumptions.is_empty() {
        blocks.push(Block::text("Nobody stated these, so they were assumed:"));
        blocks.push(Block::List(sentences(assumptions)));
    }
    if settings.question.is_some() {
        blocks.push(Block::text(
            "Before it saw the data, the inference knew this:",
        ));
        blocks.push(Block::List(sentences(&settings.knowledge.statements())));
    }
    Section::new("Conditions and assumptions", blocks)
}

fn sentences(phrases: &[String]) -> Vec<String> {
    phrases.iter().map(|phrase| sentence(phrase)).collect()
}

fn heard_with(origin: &Origin) -> Vec<(&'static str, String)> {
    match origin {
        Origin::Times => vec![("Source", "a list of impact times".to_owned())],
        Origin::Sound {
            format,
            sample_rate_hz,
            channels,
            channel,
            duration_s,
            onsets,
        } => {
            let rate = f64::from(*sample_rate_hz) / 1000.0;
            let mut facts = vec![("Source", format!("{format}, {rate} kHz, {duration_s:.2} s"))];
            if *channels > 1 {
                facts.push(("Channel", format!("{channel} of {channels}")));
            }
            facts.push(("Sounds above the noise", onsets.to_string()));
            facts
        }
    }
}

fn known(settings: &Settings, ball_label: &str) -> Vec<(&'static str, String)> {
    let (ball, environment) = (&settings.ball, &settings.environment);
    let knowledge = &settings.knowledge;
    let with_share =
        |value: f64, share: f64, unit| Quantity::measured(value, share * value, unit).to_string();
    let air = &environment.air;
    let mut facts = vec![
        ("Ball", ball_label.to_owned()),
        (
            "Mass",
            with_share(ball.mass_kg(), knowledge.mass, Unit::Mass),
        ),
        (
            "Diameter",
            with_share(ball.diameter_m(), knowledge.diameter, Unit::Length),
        ),
        (
            "Contact time",
            with_share(settings.contact_time_s, knowledge.contact_time, Unit::Time),
        ),
        (
            "Gravity",
            with_share(
                environment.gravity_m_s2,
                knowledge.gravity,
                Unit::Acceleration,
            ),
        ),
        (
            "Density of the air",
            with_share(air.density_kg_m3(), knowledge.air_density, Unit::Density),
        ),
        ("Drag law", environment.drag.to_string()),
        (
            "Buoyancy and added mass",
            match (environment.buoyancy, environment.added_mass) {
                (true, true) => "both taken into account",
                (true, false) => "buoyancy only",
                (false, true) => "added mass only",
                (false, false) => "left out",
            }
            .to_owned(),
        ),
    ];
    if let Some(Measured { value, sd }) = knowledge.drop_height_m {
        let height = Quantity::measured(value, sd, Unit::Length);
        facts.push(("Measured drop height", height.to_string()));
    }
    if let Some(Measured { value, sd }) = knowledge.release_s {
        let release = Quantity::measured(value, sd, Unit::Time);
        facts.push(("Release, in the recording", release.to_string()));
    }
    if let Some(question) = &settings.question {
        let effort = &question.effort;
        facts.push((
            "Sampling",
            format!("{} draws, seed {}", effort.draws, effort.seed),
        ));
    }
    facts
}
