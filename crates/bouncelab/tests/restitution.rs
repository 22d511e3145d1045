//! The inverse undoes the forward: a simulated drop gives back the restitution it was made with.

use bouncelab::Error;
use bouncelab::Impact;
use bouncelab::drag::DragLaw;
use bouncelab::drop::{self, History, Start, Stop};
use bouncelab::flight::FlightModel;
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::restitution::{PerImpact, of_impacts};
use bouncelab_testkit::table_tennis;
use proptest::prelude::*;

fn history(model: &FlightModel, restitution: Restitution, contact_time_s: f64) -> History {
    let contact = Contact::new(restitution, contact_time_s).unwrap();
    drop::simulate(model, &contact, Start::Height(0.5), Stop::after(12)).unwrap()
}

fn detected(history: &History, time_sd_s: Option<f64>) -> Vec<Impact> {
    let events = history.impact_events().zip(1..);
    events
        .map(|(event, number)| {
            let mut impact = Impact::new(number, event.time_s);
            impact.time_sd_s = time_sd_s;
            impact
        })
        .collect()
}

proptest! {
    #[test]
    fn restitution_comes_back(
        at_rest in 0.6..1.0_f64,
        loss in 0.0..0.03_f64,
        contact_time_s in 0.0..2e-3_f64,
        pick in 0..3_usize,
    ) {
        let law = [DragLaw::None, DragLaw::Constant(0.45), DragLaw::Standard][pick].clone();
        let model = table_tennis(law);
        let made = history(&model, Restitution::linear(at_rest, loss).unwrap(), contact_time_s);
        let found = of_impacts(&detected(&made, None), contact_time_s, &model).unwrap();
        prop_assert_eq!(found.flights.len(), 12);
        prop_assert_eq!(found.impacts.len(), 11);
        for (bounce, flight) in made.bounces().iter().zip(&found.flights) {
            prop_assert!((flight.flight.apex_m / bounce.flight.apex_m - 1.0).abs() < 1e-8);
        }
        for (bounce, impact) in made.bounces()[1..].iter().zip(&found.impacts) {
            prop_assert!((impact.restitution.value / bounce.restitution - 1.0).abs() < 1e-8);
            prop_assert!((impact.impact_speed_m_s / bounce.impact_speed_m_s - 1.0).abs() < 1e-8);
        }
    }
}

/// Without drag the correction has nothing to do.
#[test]
fn without_drag_the_ratio_is_the_restitution() {
    let model = FlightModel::drag_free(9.81).unwrap();
    let made = history(&model, Restitution::constant(0.9).unwrap(), 0.0);
    for impact in of_impacts(&detected(&made, None), 0.0, &model)
        .unwrap()
        .impacts
    {
        assert!((impact.flight_time_ratio - impact.restitution.value).abs() < 1e-14);
    }
}

/// Drag hides in the ratio of flight times: some one and a half points for a table-tennis ball from
/// 30 cm over ten flights, more in the first.
#[test]
fn the_bare_ratio_is_biased_by_drag() {
    let model = FlightModel::with_terminal_speed(9.81, 9.385).unwrap();
    let contact = Contact::instantaneous(Restitution::constant(0.95).unwrap());
    let made = drop::simulate(&model, &contact, Start::Height(0.30), Stop::after(10)).unwrap();
    let found = of_impacts(&detected(&made, None), 0.0, &model).unwrap();
    let bias = |i: usize| {
        100.0 * (found.impacts[i].flight_time_ratio - found.impacts[i].restitution.value)
    };
    assert!((-2.5..-1.5).contains(&bias(0)), "{}", bias(0));
    let mean = (0..9).map(bias).sum::<f64>() / 9.0;
    assert!((-1.7..-1.4).contains(&mean), "{mean}");
}

/// The gradient and the standard error against finite differences in each of the three times.
#[test]
fn errors_follow_the_times() {
    for law in [DragLaw::Constant(0.45), DragLaw::Standard] {
        let model = table_tennis(law.clone());
        let sigma = 1e-4;
        let made = history(&model, Restitution::constant(0.93).unwrap(), 1e-3);
        let impacts = detected(&made, Some(sigma));
        let found = of_impacts(&impacts, 1e-3, &model).unwrap();
        for (i, impact) in found.impacts.iter().enumerate() {
            let mut variance = 0.0;
            for (k, derivative) in impact.log_gradient_per_s.iter().enumerate() {
                let log_of = |nudge_s: f64| {
                    let mut nudged = impacts.clone();
                    nudged[i + k].time_s += nudge_s;
                    of_impacts(&nudged, 1e-3, &model).unwrap().impacts[i]
                        .restitution
                        .value
                        .ln()
                };
                let slope = (log_of(1e-6) - log_of(-1e-6)) / 2e-6;
                assert!((slope / derivative - 1.0).abs() < 1e-4, "{law} {i} {k}");
                variance += (slope * sigma * impact.restitution.value).powi(2);
            }
            let error = impact.restitution.sd;
            assert!((error / variance.sqrt() - 1.0).abs() < 1e-4);
        }
        // h = g T²/8, so the error of an apex is near g T/4 times that of T.
        let first = &found.flights[0];
        let expected = model.gravity_m_s2() * first.flight.time_s() / 4.0 * sigma * 2_f64.sqrt();
        assert!((first.apex_sd_m.unwrap() / expected - 1.0).abs() < 1e-3);
    }
}

/// A missed impact leaves a gap: no flight across it, no restitution beside it, the rest as before.
#[test]
fn gaps_are_skipped() {
    let model = table_tennis(DragLaw::Standard);
    let made = history(&model, Restitution::constant(0.93).unwrap(), 0.0);
    let all = detected(&made, Some(1e-4));
    let whole = of_impacts(&all, 0.0, &model).unwrap();
    let missing: Vec<_> = all
        .iter()
        .copied()
        .filter(|impact| impact.number != 6)
        .collect();
    let found = of_impacts(&missing, 0.0, &model).unwrap();
    let flights: Vec<_> = found.flights.iter().map(|flight| flight.number).collect();
    assert_eq!(flights, [1, 2, 3, 4, 7, 8, 9, 10, 11, 12]);
    let impacts: Vec<_> = found.impacts.iter().map(|impact| impact.number).collect();
    assert_eq!(impacts, [2, 3, 4, 8, 9, 10, 11, 12]);
    assert_eq!(found.impacts[3], whole.impacts[6]);
}

#[test]
fn an_unknown_time_error_gives_no_standard_error() {
    let model = FlightModel::drag_free(9.81).unwrap();
    let made = history(&model, Restitution::constant(0.9).unwrap(), 0.0);
    let mut impacts = detected(&made, Some(1e-4));
    impacts[2].time_sd_s = None;
    let found = of_impacts(&impacts, 0.0, &model).unwrap();
    let known: Vec<_> = found
        .impacts
        .iter()
        .map(|impact| impact.restitution.known_sd().is_some())
        .collect();
    assert_eq!(known[..4], [false, false, false, true]);
}

#[test]
fn absurd_times_are_refused() {
    let model = FlightModel::drag_free(9.81).unwrap();
    let at = |number, time_s| Impact::new(number, time_s);
    assert_eq!(of_impacts(&[], 0.0, &model), Ok(PerImpact::default()));
    assert_eq!(
        of_impacts(&[at(1, 0.0)], 0.0, &model),
        Ok(PerImpact::default())
    );
    assert!(matches!(
        of_impacts(&[at(1, 0.0), at(1, 0.4)], 0.0, &model),
        Err(Error::NotInOrder { .. })
    ));
    for impacts in [[at(1, 0.4), at(2, 0.4)], [at(1, 0.0), at(2, f64::NAN)]] {
        assert!(matches!(
            of_impacts(&impacts, 1e-3, &model),
            Err(Error::OutOfRange { .. })
        ));
    }
    let no_flight = of_impacts(&[at(1, 0.0), at(2, 1e-3)], 1e-3, &model);
    assert!(matches!(no_flight, Err(Error::CannotInfer(_))));
    let negative = at(2, 0.4).with_time_sd_s(-1.0);
    assert!(of_impacts(&[at(1, 0.0), negative], 0.0, &model).is_err());
}
