//! What the inference costs: `cargo bench -p bouncelab --bench inference`.

use bouncelab::Impact;
use bouncelab::analysis::Options;
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::inference::{self, InferenceOptions, Priors, SamplerConfig};
use bouncelab::restitution::LawKind;
use divan::Bencher;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

fn main() {
    divan::main();
}

const LAWS: [DragLaw; 2] = [DragLaw::Constant(0.4), DragLaw::Standard];

fn environment(drag: DragLaw) -> Environment {
    Environment {
        drag,
        ..Options::default().environment
    }
}

/// Forty impacts of a table-tennis ball from half a metre, with scatter and errors.
fn impacts() -> Vec<Impact> {
    const SIGMA_S: f64 = 5e-5;
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut normal = || rng.sample::<f64, _>(StandardNormal);
    let settings = Options::default();
    let model = FlightModel::new(&settings.ball, &environment(DragLaw::Constant(0.4))).unwrap();
    let mut speed = model.fall(0.5).unwrap().impact_speed_m_s;
    let mut time_s = 0.0;
    (1..=40)
        .map(|number| {
            let impact = Impact::new(number, time_s + SIGMA_S * normal()).with_time_sd_s(SIGMA_S);
            let launch = speed * 0.945 * (0.003 * normal()).exp();
            let flight = model.launch(launch).unwrap();
            time_s += flight.time_s() + settings.contact_time_s;
            speed = flight.impact_speed_m_s;
            impact
        })
        .collect()
}

fn one_law() -> Priors {
    Priors {
        restitution_laws: vec![LawKind::Constant],
        ..Options::default().priors
    }
}

#[divan::bench(args = LAWS)]
fn best_fit(bencher: Bencher, drag: &DragLaw) {
    let (impacts, settings) = (impacts(), Options::default());
    let (environment, priors) = (environment(drag.clone()), one_law());
    bencher.bench_local(|| {
        inference::best_fit(
            &impacts,
            &settings.ball,
            &environment,
            settings.contact_time_s,
            &priors,
        )
    });
}

/// One law with the default draws, and every answer.
#[divan::bench(args = LAWS, sample_count = 10)]
fn posterior(bencher: Bencher, drag: &DragLaw) {
    let (impacts, settings) = (impacts(), Options::default());
    let (environment, priors) = (environment(drag.clone()), one_law());
    bencher.bench_local(|| {
        inference::infer(
            &impacts,
            &settings.ball,
            &environment,
            settings.contact_time_s,
            &priors,
            &InferenceOptions::default(),
        )
    });
}

/// As `analyze` does it: all laws, with the law of drag and a constant coefficient.
#[divan::bench(args = [1000, 2000, 4000], sample_count = 10)]
fn all_models(bencher: Bencher, draws: usize) {
    let (impacts, settings) = (impacts(), Options::default());
    let environment = environment(DragLaw::Standard);
    let inference = InferenceOptions {
        sampler: SamplerConfig { draws, seed: 1 },
        ..InferenceOptions::default()
    };
    bencher.bench_local(|| {
        inference::infer(
            &impacts,
            &settings.ball,
            &environment,
            settings.contact_time_s,
            &settings.priors,
            &inference,
        )
    });
}
