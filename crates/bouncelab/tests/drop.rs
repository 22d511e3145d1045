//! Whole histories: energy, time, path, states and ends.

use bouncelab::air::Air;
use bouncelab::ball::{self, Ball};
use bouncelab::drag::DragLaw;
use bouncelab::drop::{self, History, InitialFall, MAX_BOUNCES, Start, Stop};
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::{Error, Options};
use bouncelab_testkit::{clift_gauvin, table_tennis};
use proptest::prelude::*;

fn environment(law: DragLaw) -> Environment {
    Environment {
        gravity_m_s2: 9.81,
        drag: law,
        ..Options::default().environment
    }
}

fn any_law() -> impl Strategy<Value = DragLaw> {
    prop_oneof![
        Just(DragLaw::None),
        (0.0..2.0_f64).prop_map(DragLaw::Constant),
        Just(DragLaw::Standard),
        Just(clift_gauvin()),
    ]
}

fn any_start() -> impl Strategy<Value = Start> {
    prop_oneof![
        (0.01..3.0_f64).prop_map(Start::Height),
        (0.1..6.0_f64).prop_map(Start::Launch)
    ]
}

fn bouncing(restitution: f64) -> Contact {
    Contact::instantaneous(Restitution::constant(restitution).unwrap())
}

/// A football reaches the end of a table before drag balances its weight. That it has no terminal speed does not mean
/// that it has no drag: the fall loses as much as with a constant coefficient like that of the table (0.48 at
/// Re = 5e4), within a tenth.
#[test]
fn a_table_that_ends_below_the_terminal_speed_drags_in_the_fall_too() {
    let lost_in_fall = |drag: DragLaw| {
        let football = ball::preset("football").unwrap().known.ball;
        let model = FlightModel::new(&football, &environment(drag)).unwrap();
        let stop = Stop::after(1);
        let history = drop::simulate(&model, &bouncing(0.7), Start::Height(2.0), stop).unwrap();
        (
            model.terminal_speed_m_s(),
            history.opening_lost_to_air_j_kg(),
        )
    };
    let (terminal, lost) = lost_in_fall(clift_gauvin());
    let (_, expected) = lost_in_fall(DragLaw::Constant(0.48));
    assert_eq!(terminal, None);
    assert!((lost / expected - 1.0).abs() < 0.1, "{lost} {expected}");
    assert_eq!(lost_in_fall(DragLaw::None), (None, 0.0));
}

proptest! {
    /// What the surface and the air take, and what is left at the landing, is what was there.
    #[test]
    fn energy_is_conserved(
        law in any_law(),
        start in any_start(),
        at_rest in 0.3..1.0_f64,
        loss in -0.02..0.05_f64,
    ) {
        let contact = Contact::new(Restitution::linear(at_rest, loss).unwrap(), 1e-3).unwrap();
        let model = table_tennis(law);
        let history = drop::simulate(&model, &contact, start, Stop::below(1e-4).or_after(40)).unwrap();
        let taken: f64 = history
            .bounces()
            .iter()
            .map(|bounce| bounce.lost_to_surface_j_kg + bounce.lost_to_air_j_kg)
            .sum();
        let left = 0.5 * history.landing().speed_m_s.powi(2);
        let before = history.initial_energy_j_kg();
        let after = history.opening_lost_to_air_j_kg() + taken + left;
        prop_assert!((after / before - 1.0).abs() < 1e-12);
        for bounce in history.bounces() {
            let at_apex = model.gravity_m_s2() * bounce.flight.apex_m;
            let launch = 0.5 * bounce.flight.launch_speed_m_s.powi(2);
            let impact = 0.5 * bounce.flight.impact_speed_m_s.powi(2);
            prop_assert!(bounce.lost_to_surface_j_kg >= 0.0);
            // The air takes a part on the way up and a part on the way down, none negative.
            prop_assert!(launch >= at_apex * (1.0 - 1e-12) && at_apex >= impact * (1.0 - 1e-12));
        }
    }

    /// The energy that the air takes is the work of the drag along the way, added up in small steps.
    #[test]
    fn the_air_takes_the_work_of_the_drag(law in any_law(), speed in 0.5..6.0_f64) {
        let model = table_tennis(law);
        let history =
            drop::simulate(&model, &bouncing(1.0), Start::Launch(speed), Stop::after(1)).unwrap();
        let bounce = history.bounces()[0];
        let steps = 400;
        let step = bounce.flight.time_s() / f64::from(steps);
        let work: f64 = (0..steps)
            .map(|i| {
                let state = model.state(&bounce.flight, (f64::from(i) + 0.5) * step);
                let speed = state.velocity_m_s.abs();
                model.gravity_m_s2() * model.drag_over_weight(speed).unwrap() * speed * step
            })
            .sum();
        prop_assert!((work - bounce.lost_to_air_j_kg).abs() <= 1e-4 * bounce.lost_to_air_j_kg + 1e-12);
    }

    /// Times add up: contact and flight, contact and flight; heights touch zero at each impact and
    /// the apex in each flight.
    #[test]
    fn the_height_follows_the_bounces(
        law in any_law(),
        start in any_start(),
        contact_time_s in 0.0..5e-3_f64,
    ) {
        let contact = Contact::new(Restitution::constant(0.9).unwrap(), contact_time_s).unwrap();
        let history = drop::simulate(&table_tennis(law), &contact, start, Stop::after(10)).unwrap();
        let events: Vec<_> = history.impact_events().collect();
        prop_assert_eq!(events.len(), 11);
        prop_assert_eq!(events[10], history.landing());
        for (i, bounce) in history.bounces().iter().enumerate() {
            let launch_s = bounce.time_s + contact_time_s;
            prop_assert!((launch_s + bounce.flight.time_s() - events[i + 1].time_s).abs() < 1e-12);
            prop_assert!(history.height_at(bounce.time_s - 1e-12).abs() < 1e-9);
            prop_assert!(history.height_at(bounce.time_s + 0.5 * contact_time_s) < 1e-12);
            prop_assert!(history.height_at(launch_s + 1e-12) < 1e-9);
            let apex = history.state_at(launch_s + bounce.flight.rise_time_s);
            prop_assert!((apex.height_m / bounce.flight.apex_m - 1.0).abs() < 1e-12);
            prop_assert!(apex.velocity_m_s.abs() < 1e-9);
        }
        prop_assert!(history.height_at(history.total_time_s() + 1.0).abs() < 1e-300);
    }

    /// Without drag a drop to the end takes the time and the way of Eqs. 7 and 8.
    #[test]
    fn the_drag_free_series_are_reached(e in 0.1..0.97_f64, h0 in 0.01..3.0_f64, g in 1.0..20.0_f64) {
        let model = FlightModel::drag_free(g).unwrap();
        let history =
            drop::simulate(&model, &bouncing(e), Start::Height(h0), Stop::below(1e-26)).unwrap();
        let time = drop::total_time_s(e, h0, g).unwrap();
        let path = drop::total_path_m(e, h0).unwrap();
        prop_assert!((history.total_time_s() / time - 1.0).abs() < 1e-9);
        prop_assert!((history.total_path_m() / path - 1.0).abs() < 1e-9);
        let inverse = drop::restitution_of_total_time(time, h0, g).unwrap();
        prop_assert!((inverse - e).abs() < 1e-13);
    }
}

#[test]
fn a_drop_opens_with_a_fall_or_a_flight() {
    let model = table_tennis(DragLaw::Constant(0.45));
    let history = |start| drop::simulate(&model, &bouncing(0.9), start, Stop::after(3)).unwrap();
    let dropped = history(Start::Height(0.3));
    assert_eq!(
        dropped.opening(),
        InitialFall::Fall(model.fall(0.3).unwrap())
    );
    assert!((dropped.height_at(0.0) - 0.3).abs() < 1e-15);
    assert!((dropped.height_at(-1.0) - 0.3).abs() < 1e-15);
    let launched = history(Start::Launch(2.0));
    assert_eq!(
        launched.opening(),
        InitialFall::Flight(model.launch(2.0).unwrap())
    );
    assert!(launched.height_at(0.0).abs() < 1e-15);
    assert!((launched.state_at(0.0).velocity_m_s - 2.0).abs() < 1e-12);
}

fn stopped(restitution: f64, stop: Stop) -> Result<History, Error> {
    let model = FlightModel::drag_free(9.81).unwrap();
    drop::simulate(&model, &bouncing(restitution), Start::Height(1.0), stop)
}

#[test]
fn a_drop_stops_at_what_comes_first() {
    // Apexes without drag at e = 1/2 are 1/4, 1/16, 1/64 ... of the drop height.
    assert_eq!(stopped(0.5, Stop::below(0.02)).unwrap().bounces().len(), 2);
    assert_eq!(
        stopped(0.5, Stop::below(0.02).or_after(1))
            .unwrap()
            .bounces()
            .len(),
        1
    );
    assert_eq!(
        stopped(0.5, Stop::below(0.02).or_after(9))
            .unwrap()
            .bounces()
            .len(),
        2
    );
    assert_eq!(stopped(0.5, Stop::after(7)).unwrap().bounces().len(), 7);
    let dead = stopped(0.0, Stop::after(7)).unwrap();
    assert!(dead.bounces().is_empty());
    assert_eq!(dead.impact_events().count(), 1);
}

#[test]
fn an_endless_drop_is_an_error_that_helps() {
    let error = stopped(1.0, Stop::below(0.01)).unwrap_err();
    assert!(matches!(
        error,
        Error::EndlessDrop {
            bounces: MAX_BOUNCES,
            ..
        }
    ));
    let message = error.to_string();
    assert!(
        message.contains("ask for at most 100000 bounces"),
        "{message}"
    );
    assert_eq!(
        stopped(1.0, Stop::after(1000)).unwrap().bounces().len(),
        1000
    );
}

#[test]
fn absurd_drops_are_refused() {
    let model = FlightModel::drag_free(9.81).unwrap();
    for absurd in [-1.0, 0.0, f64::NAN, f64::INFINITY] {
        for start in [Start::Height(absurd), Start::Launch(absurd)] {
            let result = drop::simulate(&model, &bouncing(0.9), start, Stop::after(3));
            assert!(matches!(result, Err(Error::OutOfRange { .. })), "{start:?}");
        }
    }
    assert!(stopped(0.9, Stop::below(-1.0)).is_err());
    assert!(stopped(0.9, Stop::below(f64::NAN)).is_err());
    assert!(drop::total_time_s(1.0, 0.3, 9.81).is_err());
    assert!(drop::total_path_m(-0.1, 0.3).is_err());
    assert!(drop::restitution_of_total_time(0.1, 0.3, 9.81).is_err());
}

/// At the ends of what is accepted a drop is simulated or refused, and in no time; beyond them the
/// scales of the flight would be no numbers any more, and the search for them would not end.
#[test]
fn every_size_is_simulated_or_refused() {
    let ends = [1e-20, 1.0, 1e20];
    for (mass_kg, diameter_m) in pairs(ends) {
        let ball = Ball::new(mass_kg, diameter_m).unwrap();
        for (density_kg_m3, viscosity_pa_s) in pairs(ends) {
            let air = Air::new(density_kg_m3, viscosity_pa_s).unwrap();
            for (gravity_m_s2, height_m) in pairs(ends) {
                let environment = Environment {
                    gravity_m_s2,
                    air,
                    ..environment(DragLaw::Standard)
                };
                let Ok(model) = FlightModel::new(&ball, &environment) else {
                    continue;
                };
                let (start, stop) = (Start::Height(height_m), Stop::after(3));
                if let Ok(history) = drop::simulate(&model, &bouncing(0.9), start, stop) {
                    let told = format!("{ball:?} {environment:?} {height_m} m");
                    assert!(history.total_time_s().is_finite(), "{told}");
                    assert!(history.total_path_m().is_finite(), "{told}");
                }
            }
        }
    }
    let environment = Environment {
        gravity_m_s2: 1e-300,
        ..environment(DragLaw::Standard)
    };
    let ball = Ball::new(2.7e-3, 0.04).unwrap();
    assert!(FlightModel::new(&ball, &environment).is_err());
}

fn pairs(values: [f64; 3]) -> impl Iterator<Item = (f64, f64)> {
    values.into_iter().flat_map(move |a| values.map(|b| (a, b)))
}

/// A table that ends below the speeds of the drop says so instead of extrapolating.
#[test]
fn a_drop_beyond_the_table_is_refused() {
    let model = table_tennis("table:100=1.1,800=0.5".parse().unwrap());
    let result = drop::simulate(&model, &bouncing(0.9), Start::Height(0.3), Stop::after(3));
    assert!(matches!(result, Err(Error::ReynoldsTooHigh { .. })));
}
