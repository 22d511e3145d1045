//! Closed form against quadrature, the paper's numbers, limits and inverses.

use proptest::prelude::*;

use super::*;
use crate::air::Conditions;
use crate::ball;

const GRAVITY: f64 = 9.81;

/// Relative difference, for values that are not zero.
fn apart(a: f64, b: f64) -> f64 {
    ((a - b) / b).abs()
}

#[track_caller]
fn assert_flights_agree(a: &Flight, b: &Flight, tolerance: f64) {
    for (name, a, b) in [
        ("launch speed", a.launch_speed_m_s, b.launch_speed_m_s),
        ("impact speed", a.impact_speed_m_s, b.impact_speed_m_s),
        ("apex", a.apex_m, b.apex_m),
        ("rise time", a.rise_time_s, b.rise_time_s),
        ("fall time", a.fall_time_s, b.fall_time_s),
    ] {
        assert!(
            apart(a, b) <= tolerance,
            "{name}: {a:e} and {b:e} differ by {:e}",
            apart(a, b)
        );
    }
}

/// A constant drag coefficient sent through the quadrature, with the same terminal speed as
/// `FlightModel::with_terminal_speed`.
fn quadrature_of_constant_drag(terminal_speed: f64) -> ReynoldsDrag {
    let ball = Ball::new(2.5e-3, 38e-3).unwrap();
    let air = Air::new(1.2, 1.8e-5).unwrap();
    let weight = ball.weight_n(GRAVITY);
    let coefficient = weight / (0.5 * 1.2 * ball.area_m2() * terminal_speed.powi(2));
    ReynoldsDrag::new(&ball, &air, DragLaw::Constant(coefficient), weight, GRAVITY)
}

/// The paper's ball and air: the density is the one that its buoyancy of 3.46e-4 N implies.
fn paper_model(drag: DragLaw) -> FlightModel {
    let ball = ball::preset("table-tennis-38").unwrap().known.ball;
    let density = 3.46e-4 / (GRAVITY * ball.volume_m3());
    let environment = Environment {
        gravity_m_s2: GRAVITY,
        air: Air::new(density, 1.5e-5 * density).unwrap(),
        drag,
        buoyancy: false,
        added_mass: false,
    };
    FlightModel::new(&ball, &environment).unwrap()
}

/// One law of each kind that drags.
fn laws() -> [DragLaw; 3] {
    [
        "standard",
        "constant:0.4",
        "table:100=1.1,1000=0.47,6000=0.39,100000=0.5",
    ]
    .map(|law| law.parse().unwrap())
}

#[test]
fn quadrature_agrees_with_the_closed_form() {
    for terminal_speed in [1.0, 3.0, 9.385, 1e2, 1e4, 1e6] {
        let exact = FlightModel::with_terminal_speed(GRAVITY, terminal_speed).unwrap();
        let quadrature = quadrature_of_constant_drag(terminal_speed);
        assert!(apart(quadrature.terminal_speed().unwrap(), terminal_speed) < 1e-14);
        for speed in [1e-3, 0.1, 1.0, 0.5 * terminal_speed, 0.99 * terminal_speed] {
            let expected = exact.launch(speed).unwrap();
            assert_flights_agree(&quadrature.launch(speed).unwrap(), &expected, 1e-12);
            let inverse = quadrature.launch_lasting(expected.time_s()).unwrap();
            assert_flights_agree(&inverse, &expected, 1e-12);
            let inverse = quadrature.launch_rising_to(expected.apex_m).unwrap();
            assert_flights_agree(&inverse, &expected, 1e-12);
        }
        for height in [1e-6, 0.305, 10.0 * terminal_speed] {
            let (a, b) = (
                quadrature.fall(height).unwrap(),
                exact.fall(height).unwrap(),
            );
            assert!(apart(a.time_s, b.time_s) < 1e-12);
            assert!(apart(a.impact_speed_m_s, b.impact_speed_m_s) < 1e-12);
        }
    }
}

#[test]
fn states_by_quadrature_agree_with_the_closed_form() {
    let exact = FlightModel::with_terminal_speed(GRAVITY, 9.385).unwrap();
    let resistance = Resistance::Reynolds(quadrature_of_constant_drag(9.385));
    let quadrature = FlightModel {
        resistance,
        moving_mass_kg: None,
    };
    let flight = exact.launch(8.0).unwrap();
    for step in 0..=50 {
        let time = flight.time_s() * f64::from(step) / 50.0;
        let (a, b) = (quadrature.state(&flight, time), exact.state(&flight, time));
        assert!(
            (a.height_m - b.height_m).abs() < 1e-11,
            "at {time}: {a:?} {b:?}"
        );
        assert!(
            (a.velocity_m_s - b.velocity_m_s).abs() < 1e-11,
            "at {time}: {a:?} {b:?}"
        );
    }
}

/// g T²/8 = h (1 + x⁴/240 + ...): the height that a flight time gives is free of drag to fourth
/// order.
#[test]
fn height_from_time_is_free_of_drag_to_fourth_order() {
    let model = FlightModel::with_terminal_speed(GRAVITY, 1.0).unwrap();
    for x in [0.05, 0.1, 0.2] {
        let flight = model.launch(x).unwrap();
        let excess = GRAVITY * flight.time_s().powi(2) / 8.0 / flight.apex_m - 1.0;
        assert!(apart(excess, x.powi(4) / 240.0) < x, "x = {x}: {excess:e}");
    }
}

/// Factors on g from buoyancy and added mass, at an air density of 1.2 kg/m³.
#[test]
fn buoyancy_and_added_mass_reduce_gravity() {
    for (name, factor) in [
        ("table-tennis-38", "0.97946"),
        ("table-tennis-40", "0.97782"),
        ("tennis", "0.99531"),
        ("football", "0.97684"),
        ("basketball", "0.97763"),
    ] {
        let environment = Environment {
            gravity_m_s2: 1.0,
            air: Air::new(1.2, 1.8e-5).unwrap(),
            drag: DragLaw::Constant(0.4),
            buoyancy: true,
            added_mass: true,
        };
        let ball = ball::preset(name).unwrap().known.ball;
        let model = FlightModel::new(&ball, &environment).unwrap();
        assert_eq!(format!("{:.5}", model.gravity_m_s2()), factor, "{name}");
        let buoyant =
            (ball.mass_kg() - 1.2 * ball.volume_m3()) / (0.5 * 1.2 * ball.area_m2() * 0.4);
        assert!(apart(model.terminal_speed_m_s().unwrap(), buoyant.sqrt()) < 1e-14);
        let moving = ball.mass_kg() + 0.6 * ball.volume_m3();
        assert!(apart(model.moving_mass_kg().unwrap(), moving) < 1e-14);
    }
}

/// The closed forms reach the drag-free limit: at vₜ = 1e6 and far beyond they equal their series
/// to the last digits.
#[test]
fn the_drag_free_limit_is_reached_without_cancellation() {
    let free = FlightModel::drag_free(GRAVITY).unwrap();
    assert_eq!(free.terminal_speed_m_s(), None);
    for terminal_speed in [1e6, 1e8, 1e12, 1e100, 1e300] {
        let model = FlightModel::with_terminal_speed(GRAVITY, terminal_speed).unwrap();
        let second_order = (2.0 / terminal_speed).powi(2);
        for speed in [1e-3, 0.1, 2.0] {
            let expected = free.launch(speed).unwrap();
            let tolerance = second_order + 4.0 * f64::EPSILON;
            let flight = model.launch(speed).unwrap();
            assert_flights_agree(&flight, &expected, tolerance);
            let inverse = model.from_flight_time(expected.time_s()).unwrap();
            assert_flights_agree(&inverse, &expected, tolerance);
            assert_flights_agree(
                &model.from_apex(expected.apex_m).unwrap(),
                &expected,
                tolerance,
            );
            let fall = model.fall(expected.apex_m).unwrap();
            assert!(apart(fall.impact_speed_m_s, speed) <= tolerance);
            assert!(apart(fall.time_s, expected.fall_time_s) <= tolerance);
            let (third, expected_third) = (flight.time_s() / 3.0, expected.time_s() / 3.0);
            let (a, b) = (
                model.state(&flight, third),
                free.state(&expected, expected_third),
            );
            assert!(apart(a.height_m, b.height_m) <= 4.0 * tolerance);
            assert!(apart(a.velocity_m_s, b.velocity_m_s) <= 4.0 * tolerance);
        }
    }
}

#[test]
fn a_long_fall_ends_at_terminal_speed() {
    for law in laws() {
        let model = paper_model(law.clone());
        let terminal = model.terminal_speed_m_s().unwrap();
        let far = model.fall(1000.0).unwrap();
        let farther = model.fall(1001.0).unwrap();
        assert!(apart(far.impact_speed_m_s, terminal) < 1e-12, "{law}");
        assert!(
            apart(farther.time_s - far.time_s, 1.0 / terminal) < 1e-9,
            "{law}"
        );
    }
}

/// The last part of a fall, where drag all but balances weight, against the exact exponential
/// approach: the gap to the terminal speed shrinks by the same factor on every metre.
#[test]
fn the_approach_to_terminal_speed_is_exponential() {
    for law in laws() {
        let model = paper_model(law.clone());
        let terminal = model.terminal_speed_m_s().unwrap();
        let gap = |height: f64| terminal - model.fall(height).unwrap().impact_speed_m_s;
        let (first, second) = (gap(60.0) / gap(55.0), gap(65.0) / gap(60.0));
        assert!(apart(first, second) < 1e-3, "{law}: {first} {second}");
    }
}

#[test]
fn a_table_that_ends_below_the_terminal_speed_still_flies() {
    let model = paper_model("table:100=1.1,800=0.5".parse().unwrap());
    assert_eq!(model.terminal_speed_m_s(), None);
    let top = 800.0 * 1.5e-5 / 38e-3;
    assert!(model.launch(0.999 * top).is_ok());
    for error in [
        model.launch(1.001 * top).unwrap_err(),
        model.from_flight_time(0.5).unwrap_err(),
        model.from_apex(0.3).unwrap_err(),
        model.fall(0.3).unwrap_err(),
        model.drag_over_weight(1.0).unwrap_err(),
    ] {
        assert!(matches!(error, Error::ReynoldsTooHigh { .. }), "{error}");
    }
    let flight = model.launch(top).unwrap();
    let inverse = model.from_flight_time(flight.time_s()).unwrap();
    assert!(apart(inverse.launch_speed_m_s, top) < 1e-11);
}

#[test]
fn absurd_flights_are_refused() {
    for model in [
        paper_model(DragLaw::Constant(0.4)),
        paper_model(DragLaw::Standard),
    ] {
        for absurd in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(model.launch(absurd).is_err());
            assert!(model.fall(absurd).is_err());
            assert!(model.from_flight_time(absurd).is_err());
            assert!(model.from_apex(absurd).is_err());
        }
        assert!(model.launch(1e200).is_err());
        assert!(model.from_flight_time(1e6).is_err());
        assert!(model.from_apex(1e6).is_err());
        let nothing = model.launch(0.0).unwrap();
        assert!(nothing.time_s() == 0.0 && nothing.apex_m == 0.0);
        assert_eq!(model.from_flight_time(0.0), Ok(nothing));
    }
    let constant = paper_model(DragLaw::Constant(0.4));
    let refusal = constant.from_flight_time(1e6).unwrap_err().to_string();
    assert!(
        refusal.starts_with("flight time is 1000000 s;"),
        "{refusal}"
    );
    assert!(FlightModel::with_terminal_speed(9.81, 0.0).is_err());
    assert!(FlightModel::drag_free(-9.81).is_err());
}

#[test]
fn a_balloon_floats() {
    let environment = Environment {
        gravity_m_s2: GRAVITY,
        air: Air::moist(&Conditions::default()).unwrap(),
        drag: DragLaw::Standard,
        buoyancy: true,
        added_mass: true,
    };
    let balloon = Ball::new(1e-3, 0.3).unwrap();
    assert!(matches!(
        FlightModel::new(&balloon, &environment),
        Err(Error::Floats { .. })
    ));
    let heavy = Environment {
        buoyancy: false,
        ..environment
    };
    assert!(FlightModel::new(&balloon, &heavy).is_ok());
}

#[test]
fn a_vacuum_has_no_drag_under_any_law() {
    for drag in laws() {
        let environment = Environment {
            gravity_m_s2: GRAVITY,
            air: Air::vacuum(),
            drag,
            buoyancy: true,
            added_mass: true,
        };
        let ball = Ball::new(2.7e-3, 0.04).unwrap();
        let flight = FlightModel::new(&ball, &environment)
            .unwrap()
            .launch(2.0)
            .unwrap();
        assert_eq!(
            flight,
            FlightModel::drag_free(GRAVITY)
                .unwrap()
                .launch(2.0)
                .unwrap()
        );
    }
}

/// From dust to a cannon ball the lowest terminal speed is found and balances the weight.
#[test]
fn terminal_speeds_balance_the_weight() {
    let environment = Environment {
        gravity_m_s2: GRAVITY,
        air: Air::moist(&Conditions::default()).unwrap(),
        drag: DragLaw::Standard,
        buoyancy: true,
        added_mass: false,
    };
    for diameter in [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.0] {
        let ball = ball::preset("steel")
            .unwrap()
            .measured(None, Some(diameter))
            .unwrap()
            .ball;
        let model = FlightModel::new(&ball, &environment).unwrap();
        let terminal = model.terminal_speed_m_s().unwrap();
        let balance = model.drag_over_weight(terminal).unwrap();
        assert!(apart(balance, 1.0) < 1e-12, "{diameter} m: {balance}");
        assert!(model.drag_over_weight(0.98 * terminal).unwrap() < 1.0);
        let flight = model.launch(terminal).unwrap();
        assert!(flight.impact_speed_m_s < terminal && flight.apex_m > 0.0);
    }
}

proptest! {
    /// Flight time to launch speed and back, closed form, vₜ from 1 to 1e6 and speeds up to vₜ.
    #[test]
    fn time_and_speed_are_inverse(log_terminal in 0.0..6.0_f64, log_speed in -3.0..0.0_f64) {
        let terminal = 10_f64.powf(log_terminal);
        let speed = 0.99 * terminal * 10_f64.powf(log_speed);
        let model = FlightModel::with_terminal_speed(GRAVITY, terminal).unwrap();
        let flight = model.launch(speed).unwrap();
        let inverse = model.from_flight_time(flight.time_s()).unwrap();
        prop_assert!(apart(inverse.launch_speed_m_s, speed) < 1e-12);
        prop_assert!(apart(inverse.time_s(), flight.time_s()) < 1e-12);
        let inverse = model.from_apex(flight.apex_m).unwrap();
        prop_assert!(apart(inverse.launch_speed_m_s, speed) < 1e-14);
    }

    /// The same far above the terminal speed, where the logarithm leaves fewer digits.
    #[test]
    fn fast_launches_are_inverted(log_x in 0.0..6.0_f64) {
        let model = FlightModel::with_terminal_speed(GRAVITY, 9.0).unwrap();
        let speed = 9.0 * 10_f64.powf(log_x);
        let time = model.launch(speed).unwrap().time_s();
        let inverse = model.from_flight_time(time).unwrap();
        prop_assert!(apart(inverse.launch_speed_m_s, speed) < 1e-12);
    }

    /// The same for every law of the Reynolds number.
    #[test]
    fn quadratures_are_inverted(log_speed in -3.0..1.2_f64, pick in 0..3_usize) {
        let law = laws()[pick].clone();
        let model = paper_model(law.clone());
        let speed = 10_f64.powf(log_speed);
        let flight = model.launch(speed).unwrap();
        let inverse = model.from_flight_time(flight.time_s()).unwrap();
        prop_assert!(apart(inverse.launch_speed_m_s, speed) < 1e-12, "{}", law);
        prop_assert!(apart(inverse.time_s(), flight.time_s()) < 1e-12, "{}", law);
        let inverse = model.from_apex(flight.apex_m).unwrap();
        prop_assert!(apart(inverse.launch_speed_m_s, speed) < 1e-12, "{}", law);
    }

    /// The exact derivatives against central differences.
    #[test]
    fn derivatives_are_slopes(log_speed in -1.0..1.0_f64, pick in 0..3_usize) {
        let law = laws()[pick].clone();
        let model = paper_model(law.clone());
        let speed = 10_f64.powf(log_speed);
        let slopes = model.launch_derivatives(&model.launch(speed).unwrap()).unwrap();
        let step = 1e-4 * speed;
        let (above, below) = (model.launch(speed + step).unwrap(), model.launch(speed - step).unwrap());
        let slope = |of: fn(&Flight) -> f64| (of(&above) - of(&below)) / (2.0 * step);
        // The jumps of the standard curve at its joints make its slopes differ by their size.
        let tolerance = if law == DragLaw::Standard { 1e-4 } else { 1e-7 };
        prop_assert!(apart(slope(Flight::time_s), slopes.time) < tolerance, "{}", law);
        prop_assert!(apart(slope(|f| f.impact_speed_m_s), slopes.impact_speed) < tolerance, "{}", law);
        prop_assert!(apart(slope(|f| f.apex_m), slopes.apex) < tolerance, "{}", law);
    }

    /// States begin at the launch, peak at the apex, end at the impact, and their velocity is the
    /// slope of their height.
    #[test]
    fn states_follow_the_flight(speed in 0.1..15.0_f64, part in 0.01..0.99_f64, pick in 0..3_usize) {
        let law = laws()[pick].clone();
        let model = paper_model(law.clone());
        let flight = model.launch(speed).unwrap();
        let start = model.state(&flight, -1.0);
        prop_assert!(start.height_m.abs() < 1e-11 * flight.apex_m && apart(start.velocity_m_s, speed) < 1e-11);
        let top = model.state(&flight, flight.rise_time_s);
        prop_assert!(apart(top.height_m, flight.apex_m) < 1e-12 && top.velocity_m_s.abs() < 1e-9);
        let end = model.state(&flight, flight.time_s() + 1.0);
        prop_assert!(end.height_m < 1e-11 * flight.apex_m);
        prop_assert!(apart(-end.velocity_m_s, flight.impact_speed_m_s) < 1e-10);
        let (time, step) = (part * flight.time_s(), 1e-5);
        let height = |time| model.state(&flight, time).height_m;
        let slope = (height(time + step) - height(time - step)) / (2.0 * step);
        prop_assert!((slope - model.state(&flight, time).velocity_m_s).abs() < 1e-5);
    }
}
