//! Conditions, assumptions and priors.

use bouncelab::analysis::Source;
use bouncelab::inference::Measured;
use bouncelab::setup::Setup;
use bouncelab::{Diagnostic, Options};

use super::input::ReportInput;
use super::page::{Block, Section, sentence};
use crate::messages::{Translator, Value};
use crate::quantity::{Quantity, Unit};
use crate::tables::drag_law;

/// A name and a value.
type Fact = (String, String);

/// Recording, ball, air and gravity, and what of it was assumed.
pub fn conditions(input: &ReportInput, translator: &Translator) -> Section {
    let source = source(&input.result.source, translator);
    of_all(source, input.setup, translator)
}

/// Ball, air and gravity of several recordings, and what of it was assumed.
pub fn shared_conditions(setup: &Setup, translator: &Translator) -> Section {
    of_all(Vec::new(), setup, translator)
}

fn of_all(mut facts: Vec<Fact>, setup: &Setup, translator: &Translator) -> Section {
    let (settings, assumptions) = (&setup.options, &setup.assumptions);
    facts.extend(known(settings, translator.ball(&setup.ball), translator));
    let mut blocks = vec![Block::Facts(facts)];
    if !assumptions.is_empty() {
        blocks.push(Block::text(translator.text("report-assumed")));
        blocks.push(Block::List(sentences(assumptions, translator)));
    }
    Section::new(translator.text("report-conditions"), blocks)
}

/// The priors of the inference; empty without inference.
pub fn priors(settings: &Options, translator: &Translator) -> Section {
    let known = settings.inference.as_ref().map(|_| {
        let known = sentences(&settings.priors.diagnostics(), translator);
        Block::List(known)
    });
    Section::new(
        translator.text("report-priors"),
        known.into_iter().collect(),
    )
}

fn sentences(diagnostics: &[Diagnostic], translator: &Translator) -> Vec<String> {
    let sentences = diagnostics.iter().map(|known| translator.diagnostic(known));
    sentences.map(|known| sentence(&known)).collect()
}

fn source(origin: &Source, translator: &Translator) -> Vec<Fact> {
    let source = translator.text("report-source");
    match origin {
        Source::Times => vec![(source, translator.text("report-source-times"))],
        Source::Sound {
            format,
            sample_rate_hz,
            channels,
            channel,
            duration_s,
            onsets,
        } => {
            let format = match format.as_deref() {
                Some("microphone") => translator.text("report-microphone"),
                Some(format) => format.to_owned(),
                None => translator.text("report-samples"),
            };
            let sound = [
                ("format", format.into()),
                ("rate", (f64::from(*sample_rate_hz) / 1000.0).into()),
                ("duration", Value::fixed(*duration_s, 2)),
            ];
            let mut facts = vec![(source, translator.text_with("report-source-sound", &sound))];
            if *channels > 1 {
                let of = [
                    ("channel", (*channel).into()),
                    ("count", (*channels).into()),
                ];
                let channel = translator.text_with("report-channel-of", &of);
                facts.push((translator.text("report-channel"), channel));
            }
            facts.push((translator.text("report-onsets"), onsets.to_string()));
            facts
        }
    }
}

fn known(settings: &Options, ball_name: String, translator: &Translator) -> Vec<Fact> {
    let (ball, environment) = (&settings.ball, &settings.environment);
    let (air, priors) = (&environment.air, &settings.priors);
    let measured = |id: &str, value: f64, sd: f64, unit| {
        (
            translator.text(id),
            Quantity::measured(value, sd, unit).text(translator),
        )
    };
    let known = |id: &str, value: f64, rel_sd: f64, unit| measured(id, value, rel_sd * value, unit);
    let displaced_air = match (environment.buoyancy, environment.added_mass) {
        (true, true) => "report-displaced-air-both",
        (true, false) => "report-displaced-air-buoyancy",
        (false, true) => "report-displaced-air-added-mass",
        (false, false) => "report-displaced-air-none",
    };
    let (contact_s, gravity_m_s2) = (settings.contact_time_s, environment.gravity_m_s2);
    let density_kg_m3 = air.density_kg_m3();
    let mut facts = vec![
        (translator.text("report-ball"), ball_name),
        known(
            "report-mass",
            ball.mass_kg(),
            priors.mass_rel_sd,
            Unit::Mass,
        ),
        known(
            "report-diameter",
            ball.diameter_m(),
            priors.diameter_rel_sd,
            Unit::Length,
        ),
        known(
            "report-contact-time",
            contact_s,
            priors.contact_time_rel_sd,
            Unit::Time,
        ),
        known(
            "report-gravity",
            gravity_m_s2,
            priors.gravity_rel_sd,
            Unit::Acceleration,
        ),
        known(
            "report-air-density",
            density_kg_m3,
            priors.air_density_rel_sd,
            Unit::Density,
        ),
        (
            translator.text("report-drag-law"),
            drag_law(environment.drag, translator),
        ),
        (
            translator.text("report-displaced-air"),
            translator.text(displaced_air),
        ),
    ];
    if let Some(Measured { value, sd }) = priors.drop_height_m {
        facts.push(measured("report-measured-height", value, sd, Unit::Length));
    }
    if let Some(Measured { value, sd }) = priors.release_s {
        facts.push(measured("report-release", value, sd, Unit::Time));
    }
    if let Some(inference) = &settings.inference {
        let sampler = &inference.sampler;
        let draws = [
            ("draws", sampler.draws.into()),
            ("seed", sampler.seed.into()),
        ];
        let sampler = translator.text_with("report-sampler-draws", &draws);
        facts.push((translator.text("report-sampler"), sampler));
    }
    facts
}
