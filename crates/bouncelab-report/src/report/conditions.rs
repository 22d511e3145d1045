//! Conditions, assumptions and priors.

use bouncelab::analysis::Source;
use bouncelab::inference::Measured;
use bouncelab::settings::Setup;
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
        Source::Times(listed) => {
            let origin = listed.description().unwrap_or_else(|| "none".to_owned());
            let listed = translator.text_with("report-source-times", &[("origin", origin.into())]);
            vec![(source, listed)]
        }
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

/// Ball, gravity, air and drag, then what was measured of the drop, and how the inference samples.
fn known(settings: &Options, ball_name: String, translator: &Translator) -> Vec<Fact> {
    let mut facts = vec![(translator.text("report-ball"), ball_name)];
    facts.extend(inputs(settings, translator));
    facts.extend(laws(settings, translator));
    facts.extend(measurements(settings, translator));
    facts.extend(sampler(settings, translator));
    facts
}

/// The inputs of the physics with their standard uncertainties.
fn inputs(settings: &Options, translator: &Translator) -> impl Iterator<Item = Fact> {
    let (ball, environment) = (&settings.ball, &settings.environment);
    let priors = &settings.priors;
    let density_kg_m3 = environment.air.density_kg_m3();
    let inputs = [
        (
            "report-mass",
            ball.mass_kg(),
            priors.mass_rel_sd,
            Unit::Mass,
        ),
        (
            "report-diameter",
            ball.diameter_m(),
            priors.diameter_rel_sd,
            Unit::Length,
        ),
        (
            "report-contact-time",
            settings.contact_time_s,
            priors.contact_time_rel_sd,
            Unit::Time,
        ),
        (
            "report-gravity",
            environment.gravity_m_s2,
            priors.gravity_rel_sd,
            Unit::Acceleration,
        ),
        (
            "report-air-density",
            density_kg_m3,
            priors.air_density_rel_sd,
            Unit::Density,
        ),
    ];
    inputs.into_iter().map(|(id, value, rel_sd, unit)| {
        let quantity = Quantity::measured(value, rel_sd * value, unit);
        (translator.text(id), quantity.text(translator))
    })
}

/// The drag law, and which effects of the displaced air are taken into account.
fn laws(settings: &Options, translator: &Translator) -> [Fact; 2] {
    let environment = &settings.environment;
    let displaced_air = match (environment.buoyancy, environment.added_mass) {
        (true, true) => "report-displaced-air-both",
        (true, false) => "report-displaced-air-buoyancy",
        (false, true) => "report-displaced-air-added-mass",
        (false, false) => "report-displaced-air-none",
    };
    [
        (
            translator.text("report-drag-law"),
            drag_law(&environment.drag, translator),
        ),
        (
            translator.text("report-displaced-air"),
            translator.text(displaced_air),
        ),
    ]
}

/// The measured drop height and release time, if they were given.
fn measurements(settings: &Options, translator: &Translator) -> impl Iterator<Item = Fact> {
    let priors = &settings.priors;
    let measurements = [
        ("report-measured-height", priors.drop_height_m, Unit::Length),
        ("report-release", priors.release_s, Unit::Time),
    ];
    measurements.into_iter().filter_map(|(id, measured, unit)| {
        let Measured { value, sd } = measured?;
        let quantity = Quantity::measured(value, sd, unit);
        Some((translator.text(id), quantity.text(translator)))
    })
}

fn sampler(settings: &Options, translator: &Translator) -> Option<Fact> {
    let sampler = &settings.inference.as_ref()?.sampler;
    let draws = [
        ("draws", sampler.draws.into()),
        ("seed", sampler.seed.into()),
    ];
    let draws = translator.text_with("report-sampler-draws", &draws);
    Some((translator.text("report-sampler"), draws))
}
