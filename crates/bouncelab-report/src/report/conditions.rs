//! What was known, what was assumed, and what it was heard with.

use bouncelab::analysis::Options;
use bouncelab::inference::Measured;

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
pub fn shared_conditions(settings: &Options, ball_label: &str, assumptions: &[String]) -> Section {
    of_all(Vec::new(), settings, ball_label, assumptions)
}

fn of_all(
    mut facts: Vec<(&'static str, String)>,
    settings: &Options,
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
    if settings.inference.is_some() {
        blocks.push(Block::text(
            "Before it saw the data, the inference knew this:",
        ));
        blocks.push(Block::List(sentences(&settings.priors.statements())));
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

fn known(settings: &Options, ball_label: &str) -> Vec<(&'static str, String)> {
    let (ball, environment) = (&settings.ball, &settings.environment);
    let priors = &settings.priors;
    let with_share =
        |value: f64, share: f64, unit| Quantity::measured(value, share * value, unit).to_string();
    let air = &environment.air;
    let mut facts = vec![
        ("Ball", ball_label.to_owned()),
        (
            "Mass",
            with_share(ball.mass_kg(), priors.mass_rel_sd, Unit::Mass),
        ),
        (
            "Diameter",
            with_share(ball.diameter_m(), priors.diameter_rel_sd, Unit::Length),
        ),
        (
            "Contact time",
            with_share(
                settings.contact_time_s,
                priors.contact_time_rel_sd,
                Unit::Time,
            ),
        ),
        (
            "Gravity",
            with_share(
                environment.gravity_m_s2,
                priors.gravity_rel_sd,
                Unit::Acceleration,
            ),
        ),
        (
            "Density of the air",
            with_share(
                air.density_kg_m3(),
                priors.air_density_rel_sd,
                Unit::Density,
            ),
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
    if let Some(Measured { value, sd }) = priors.drop_height_m {
        let height = Quantity::measured(value, sd, Unit::Length);
        facts.push(("Measured drop height", height.to_string()));
    }
    if let Some(Measured { value, sd }) = priors.release_s {
        let release = Quantity::measured(value, sd, Unit::Time);
        facts.push(("Release, in the recording", release.to_string()));
    }
    if let Some(inference) = &settings.inference {
        let sampler = &inference.sampler;
        facts.push((
            "Sampling",
            format!("{} draws, seed {}", sampler.draws, sampler.seed),
        ));
    }
    facts
}
