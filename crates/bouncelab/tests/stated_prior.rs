//! A stated prior of the restitution: calibration by simulation of draws from it, its limits, and what a study takes from it.

use bouncelab::Impact;
use bouncelab::analysis::Options;
use bouncelab::flight::FlightModel;
use bouncelab::groups::{Asked, Study, StudyDrop};
use bouncelab::inference::{InferenceOptions, Posterior, Priors, SamplerConfig, infer};
use bouncelab_testkit::bouncing;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

const TIME_SD_S: f64 = 5e-5;

/// Inputs are exact, so that only the drop, its scatter and the law are drawn.
fn priors(restitution: Option<&str>) -> Priors {
    Priors {
        restitution: restitution.map(|prior| prior.parse().unwrap()),
        first_was_detected: true,
        drag_rel_sd: 0.0,
        gravity_rel_sd: 0.0,
        air_density_rel_sd: 0.0,
        mass_rel_sd: 0.0,
        diameter_rel_sd: 0.0,
        added_mass_rel_sd: 0.0,
        contact_time_rel_sd: 0.0,
        timing_rel_sd: 0.0,
        ..Priors::default()
    }
}

/// The first impacts of a drop whose restitution is this function of the speed, with the tails of the inference (Student's t
/// of 6 degrees with variance one).
fn impacts(
    restitution: impl Fn(f64) -> f64,
    height_m: f64,
    scatter: f64,
    count: usize,
    rng: &mut ChaCha8Rng,
) -> Vec<Impact> {
    let Options {
        ball,
        environment,
        contact_time_s,
        ..
    } = Options::default();
    let model = FlightModel::new(&ball, &environment).unwrap();
    let fall = model.fall(height_m).unwrap();
    let mut of_scatter = rng.clone();
    let kept = |speed: f64| {
        let mut normal = || of_scatter.sample::<f64, _>(StandardNormal);
        let chi_squared: f64 = (0..6).map(|_| normal().powi(2)).sum();
        restitution(speed) * (scatter * normal() * (4.0 / chi_squared).sqrt()).exp()
    };
    let events = bouncing(model, contact_time_s, fall.impact_speed_m_s, kept);
    let times_s: Vec<f64> = events.take(count).map(|impact| impact.time_s).collect();
    let mut of_times = ChaCha8Rng::seed_from_u64(rng.random());
    let impacts = times_s.iter().zip(1..).map(|(time_s, number)| {
        let off = of_times.sample::<f64, _>(StandardNormal);
        Impact::new(number, time_s + TIME_SD_S * off).with_time_sd_s(TIME_SD_S)
    });
    impacts.collect()
}

fn inferred(impacts: &[Impact], priors: &Priors, draws: usize) -> Posterior {
    let options = Options::default();
    let inference = InferenceOptions {
        sampler: SamplerConfig { draws, seed: 1 },
        each_impact: false,
        ..InferenceOptions::default()
    };
    infer(
        impacts,
        &options.ball,
        &options.environment,
        options.contact_time_s,
        priors,
        &inference,
    )
    .unwrap()
}

const DROPS: usize = 200;
const BINS: usize = 10;

/// The bin of the rank of a truth among draws.
fn bin(draws: &[f64], truth: f64) -> usize {
    let below = draws.iter().filter(|&&draw| draw < truth).count();
    (below * BINS / draws.len()).min(BINS - 1)
}

fn assert_uniform(bins: &[usize; BINS]) {
    // Exceeded once in a thousand times by chance, of 9 degrees of freedom.
    const CHI_SQUARE_LIMIT: f64 = 27.88;
    let expected = (DROPS / BINS) as f64;
    let squares = bins.iter().map(|&bin| (bin as f64 - expected).powi(2));
    let chi_square = squares.sum::<f64>() / expected;
    assert!(chi_square < CHI_SQUARE_LIMIT, "{chi_square}: {bins:?}");
}

/// Laws are drawn as functions of the speed, not by the knots of the inference: their ranks among the draws at the slowest, a
/// middle and the fastest speed are uniform (Talts et al., arXiv 1804.06788), and the central 68 % of the draws contain that
/// many. Four impacts leave much to the prior.
#[test]
fn draws_from_the_prior_are_found_as_often_as_stated() {
    let prior = priors(Some("functions:0.5=0.86:0.03:0.03,4=0.78:0.03:-0.04"));
    let mut ranks = [[0_usize; BINS]; 3];
    let mut inside = [0_usize; 3];
    for seed in 0..DROPS as u64 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut normal = || rng.sample::<f64, _>(StandardNormal);
        let (level, tilt, scatter) = (normal(), normal(), prior.scatter_at(normal()));
        let restitution = |speed: f64| {
            let share = ((speed / 0.5).ln() / 8.0_f64.ln()).clamp(0.0, 1.0);
            let mean = 0.86 - 0.08 * share;
            mean * ((0.03 * level + (0.03 - 0.07 * share) * tilt) / mean).exp()
        };
        let height_m = 0.3 * 3.0_f64.powf(rng.random());
        let impacts = impacts(restitution, height_m, scatter, 4, &mut rng);
        let found = inferred(&impacts, &prior, 400).drawn_unknowns(1).unwrap();
        let curve = &found
            .posterior
            .iter()
            .find(|it| it.name == "restitution_curve")
            .unwrap()
            .values;
        for (place, knot) in [0, 2, 4].into_iter().enumerate() {
            let truth = restitution(found.speeds_m_s[knot]);
            let draws: Vec<f64> = curve.chunks_exact(5).map(|draw| draw[knot]).collect();
            let below = draws.iter().filter(|&&draw| draw < truth).count();
            let share = below as f64 / draws.len() as f64;
            ranks[place][bin(&draws, truth)] += 1;
            inside[place] += usize::from((0.158_655..0.841_345).contains(&share));
        }
    }
    for (bins, inside) in ranks.iter().zip(inside) {
        assert_uniform(bins);
        // Three standard errors of 200 drops.
        let covered = inside as f64 / DROPS as f64;
        assert!((covered - 0.683).abs() < 0.1, "{covered}");
    }
}

/// Scatters are drawn from a prior narrower than the usual one around another typical scatter: their ranks among the draws
/// are uniform.
#[test]
fn a_stated_spread_of_the_scatter_is_the_width_of_its_prior() {
    let prior = Priors {
        restitution_scatter: 0.01,
        scatter_spread: 0.4,
        ..priors(Some("normal:1=0.85:0.01"))
    };
    let mut ranks = [0; BINS];
    for seed in 0..DROPS as u64 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let scatter = prior.scatter_at(rng.sample(StandardNormal));
        let level = 0.85 * (0.01 / 0.85 * rng.sample::<f64, _>(StandardNormal)).exp();
        let impacts = impacts(|_| level, 0.5, scatter, 12, &mut rng);
        let found = inferred(&impacts, &prior, 400).drawn_unknowns(1).unwrap();
        let drawn = found.posterior.iter();
        let mut drawn = drawn.filter(|it| it.name == "restitution_scatter");
        ranks[bin(&drawn.next().unwrap().values, scatter)] += 1;
    }
    assert_uniform(&ranks);
    let exact = Priors {
        scatter_spread: 0.0,
        ..prior
    };
    let impacts = impacts(|_| 0.85, 0.5, 0.03, 12, &mut ChaCha8Rng::seed_from_u64(1));
    let scatter = inferred(&impacts, &exact, 400).restitution_scatter;
    assert!((scatter.value - 0.01).abs() < 1e-5 && scatter.sd < 1e-12);
}

/// The time of one flight says nothing of the restitution: what remains is the prior.
#[test]
fn without_data_the_posterior_is_the_prior() {
    let prior = priors(Some("normal:1=0.8:0.02"));
    let times = [0.0, 0.5].map(|time_s| Impact::new(1 + usize::from(time_s > 0.0), time_s));
    let found = inferred(&times, &prior, 4000).restitution;
    assert!((found.value - 0.8).abs() < 0.002, "{found:?}");
    assert!((found.sd / 0.02 - 1.0).abs() < 0.05, "{found:?}");
}

/// Each drop enters a study without the prior, which would else count once for each: a narrow one that is wrong by two of its
/// standard deviations moves single drops, and the study less, by what it says of the shape: a prior of each of the drops would move it as much.
#[test]
fn a_study_counts_no_prior() {
    let stated = priors(Some("normal:1=0.892:0.004"));
    let drops = 8;
    let study = |priors: &Priors| {
        let found: Vec<Posterior> = (0..drops)
            .map(|seed| {
                let mut rng = ChaCha8Rng::seed_from_u64(seed);
                inferred(&impacts(|_| 0.9, 0.5, 0.004, 9, &mut rng), priors, 2000)
            })
            .collect();
        let mean = found.iter().map(|it| it.restitution.value).sum::<f64>() / drops as f64;
        let drop = |posterior: &Posterior| StudyDrop {
            evidence: posterior.evidence().unwrap(),
            scatter: None,
            levels: Vec::new(),
        };
        let drops: Vec<StudyDrop> = found.iter().map(drop).collect();
        let asked = Asked {
            at_speed_m_s: Some(1.5),
            ..Asked::default()
        };
        let study = Study::of(&drops, &asked).unwrap();
        (mean, study.groups[0].restitution.unwrap().value)
    };
    let (usual, of_usual) = study(&priors(None));
    let (moved, of_stated) = study(&stated);
    assert!(usual - moved > 5e-4, "{usual} {moved}");
    assert!(
        (of_usual - of_stated).abs() < 0.5 * (usual - moved),
        "{of_usual} {of_stated}, single {usual} {moved}"
    );
}
