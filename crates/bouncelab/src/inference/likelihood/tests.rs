use super::*;
use crate::analysis::Options;
use crate::drag::DragLaw;
use crate::flight::Environment;
use crate::impact::Impact;
use crate::inference::medium::Medium;
use crate::inference::observed::Observed;
use crate::inference::possible_balls::PossibleBall;
use crate::inference::priors::{Measured, Priors};
use crate::inference::reference_speed::ReferenceSpeed;
use crate::inference::timed_flights::TimedFlights;
use crate::restitution::LawKind;

/// Times of a drop with two gaps, one of them two impacts wide, and a release.
pub(in super::super) fn impacts() -> Vec<Impact> {
    let times = [
        (1, 0.3),
        (2, 0.8605),
        (3, 1.3877),
        (5, 2.3553),
        (6, 2.8035),
        (9, 3.9990),
        (10, 4.3544),
    ];
    times
        .map(|(number, time_s)| Impact::new(number, time_s).with_time_sd_s(2e-4))
        .to_vec()
}

/// Works with the likelihood of such times, for a law that changes with speed, a release and a first impact missed.
pub(in super::super) fn with_model<T>(
    impacts: &[Impact],
    work: impl FnOnce(&Model, &[f64]) -> T,
) -> T {
    let settings = Options::default();
    let environment = Environment {
        drag: DragLaw::Constant(0.4),
        ..settings.environment
    };
    let priors = Priors {
        release_s: Some(Measured {
            value: -0.02,
            sd: 0.003,
        }),
        ..Priors::default()
    };
    let observed = Observed::new(impacts).unwrap();
    let ball = PossibleBall::stated(settings.ball, settings.contact_time_s, &priors);
    let media = Medium::new(&ball, &environment, &observed, &priors).unwrap();
    let middle = ReferenceSpeed::new(&observed, &media).unwrap();
    let timed_flights = TimedFlights::new(&observed, &media);
    let model = Model::new(
        &observed,
        &timed_flights,
        &media,
        &middle,
        LawKind::Linear,
        1,
        &priors,
    );
    let mut vector = model.start();
    vector[model.index(Slot::Shape(0)).unwrap()] = 0.6;
    work(&model, &vector)
}

fn values(impacts: &[Impact]) -> Vec<f64> {
    with_model(impacts, |model, vector| {
        let point = model.point(vector).unwrap();
        values_at(model, point)
    })
}

fn values_at(model: &Model, point: Point) -> Vec<f64> {
    let residuals = residuals_at(model, point);
    residuals
        .iter()
        .map(|residual| residual.value.0[0])
        .collect()
}

fn residuals_at(model: &Model, point: Point) -> Vec<Residual<1>> {
    model.evaluate(&[point]).unwrap().residuals
}

/// The derivatives by the times, gaps included, against moving each time a little. The middle of
/// the data, at which laws are pinned, moves with them, but by far less.
#[test]
fn derivatives_by_the_times() {
    const STEP_S: f64 = 1e-6;
    let impacts = impacts();
    let residuals = with_model(&impacts, |model, vector| {
        let point = model.point(vector).unwrap();
        residuals_at(model, point)
    });
    let pinned = |moved: usize, by_s: f64| {
        let mut times = impacts.clone();
        times[moved].time_s += by_s;
        // The same law: the point of the unmoved times.
        let point = with_model(&impacts, |model, vector| model.point(vector).unwrap());
        with_model(&times, |model, _| values_at(model, point))
    };
    for moved in 0..impacts.len() {
        let (above, below) = (pinned(moved, STEP_S), pinned(moved, -STEP_S));
        for (row, residual) in residuals.iter().enumerate() {
            let expected = (above[row] - below[row]) / (2.0 * STEP_S);
            let place = (moved + 1).checked_sub(residual.impact);
            let stated = place
                .and_then(|p| residual.timing.get(p))
                .map_or(0.0, |slope| slope.0[0]);
            assert!(
                (stated - expected).abs() < 2e-3,
                "row {row} time {moved}: {stated} {expected}"
            );
        }
    }
}

/// The banded factors against the dense covariance of the same noise.
#[test]
fn factors_are_those_of_the_dense_covariance() {
    with_model(&impacts(), |model, vector| {
        let point = model.point(vector).unwrap();
        let Details {
            residuals, factors, ..
        } = model.details(vector).unwrap();
        let (count, times) = (residuals.len(), model.observed.sigma_s.len());
        let mut by_time = DMatrix::zeros(count, times);
        for (row, residual) in residuals.iter().enumerate() {
            for (place, slope) in residual.timing.iter().enumerate() {
                if let Some(time) = (residual.impact + place).checked_sub(1)
                    && time < times
                {
                    by_time[(row, time)] = slope.0[0] * point.timing * model.observed.sigma_s[time];
                }
            }
        }
        let mut dense = &by_time * by_time.transpose();
        let scatter = point.scatter * point.scatter;
        for (row, residual) in residuals.iter().enumerate() {
            dense[(row, row)] += scatter * residual.scatter.0[0] + residual.own_variance;
            if row > 0 {
                dense[(row, row - 1)] += scatter * residual.scatter_before.0[0];
                dense[(row - 1, row)] += scatter * residual.scatter_before.0[0];
            }
        }
        let expected = nalgebra::Cholesky::new(dense).unwrap().l();
        for (row, factor) in factors.iter().enumerate() {
            let diagonal = expected[(row, row)];
            assert!(
                (factor.row[2] / (diagonal * diagonal) - 1.0).abs() < 1e-9,
                "row {row}"
            );
        }
    });
}

/// What the scatter of a missed impact does, against a drop in which one scatters.
#[test]
fn missed_impacts_scatter() {
    let residuals = with_model(&impacts(), |model, vector| {
        let point = model.point(vector).unwrap();
        residuals_at(model, point)
    });
    let [scatter, before] = [
        residuals
            .iter()
            .map(|r| r.scatter.0[0])
            .collect::<Vec<f64>>(),
        residuals.iter().map(|r| r.scatter_before.0[0]).collect(),
    ];
    // The residuals beside a gap carry more than their own scatter, and share it.
    assert!(scatter[1] > 1.0, "a first impact was missed");
    assert!(scatter[4] > 1.1 && before[4] != 0.0);
    assert!((scatter[2] - 1.0).abs() < 1e-12);
    assert_eq!(values(&impacts()).len(), residuals.len());
}

/// Several vectors side by side, against one after the other; one of them makes no sense.
#[test]
fn vectors_side_by_side_are_as_probable_as_alone() {
    with_model(&impacts(), |model, vector| {
        let mut vectors = DMatrix::from_fn(vector.len(), 11, |unknown, number| {
            vector[unknown] + 0.01 * number as f64
        });
        vectors[(0, 4)] = f64::NAN;
        let together = model.log_posteriors(&vectors);
        assert_eq!(together[4], None);
        for (number, together) in together.into_iter().enumerate() {
            let alone = model.log_posteriors(&vectors.columns(number, 1).into_owned());
            assert_eq!(alone, [together]);
        }
    });
}

/// What the release and each interval add is the likelihood, but for the constant that it leaves out.
#[test]
fn densities_of_intervals_add_up() {
    with_model(&impacts(), |model, vector| {
        let point = model.point(vector).unwrap();
        let trials = model.trials_at(&[point]).unwrap();
        let mut release = None;
        let mut report = |step: &Step<1>, _: &End<1>| {
            let width = step.tail.width() * step.factor[2];
            let density = step.tail.log_density(step.square) - width.ln() * 0.5;
            release.get_or_insert(density.0[0]);
        };
        let whole = model.log_likelihood(&trials, &mut report).0[0];
        let densities = model.log_densities(&[point]).unwrap();
        let sum: f64 = densities.iter().map(|density| density.0[0]).sum();
        let constant = 0.5 * std::f64::consts::TAU.ln() * densities.len() as f64;
        let all = release.unwrap() + sum + constant;
        assert!((all - whole).abs() < 1e-9, "{all} {whole}");
    });
}
