//! An independent check of every flight: the equations of motion (paper Eqs. 9, 10, 18 and 19)
//! solved by an ODE library, over the variable whose end is known: the speed up to the apex, the way down to the ground.
//!
//! The equations are scaled by the launch speed v and gravity g, so that a flight of 0.1 ms and one
//! of a day are the same problem to the solver: speed in v, time in v/g, height in v²/g.

use bouncelab::air::Air;
use bouncelab::ball::Ball;
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, Flight, FlightModel};
use bouncelab_testkit::clift_gauvin;
use differential_equations::prelude::{ExplicitRungeKutta, IVP};

/// Agreement that is asked for, relative.
const AGREEMENT: f64 = 1e-9;

/// Tolerance of the solver, relative and absolute in the scaled problem.
const SOLVER_TOLERANCE: f64 = 1e-13;

/// Time, speed u and way y.
type State = [f64; 3];

/// Solves the equations over this range of the variable by which the rates of change are.
fn solve(range: [f64; 2], start: State, rates: impl Fn(State) -> State) -> State {
    let equations = |_: f64, state: &State, change: &mut State| *change = rates(*state);
    let method = ExplicitRungeKutta::dop853()
        .rtol(SOLVER_TOLERANCE)
        .atol(SOLVER_TOLERANCE)
        .max_steps(100_000);
    let solution = IVP::ode_from_fn(equations, range[0], range[1], start)
        .method(method)
        .solve()
        .unwrap();
    *solution.last().unwrap().1
}

/// From launch until the speed is zero, which is where an integration over the speed ends.
fn until_rest(acceleration: impl Fn(f64) -> f64) -> State {
    solve([1.0, 0.0], [0.0, 1.0, 0.0], |[_, u, _]| {
        let per_speed = acceleration(u).recip();
        [per_speed, 1.0, u * per_speed]
    })
}

/// From rest or launch until a way, which is where an integration over the way ends. Over the way, the rates at rest are
/// infinite: the start is integrated over time, for half the time that the way takes without drag.
fn until_way(way: f64, speed: f64, acceleration: impl Fn(f64) -> f64) -> State {
    let half = if speed > 0.0 {
        way / speed
    } else {
        (2.0 * way).sqrt()
    } / 2.0;
    let started = solve([0.0, half], [0.0, speed, 0.0], |[_, u, _]| {
        [1.0, acceleration(u), u]
    });
    solve([started[2], way], started, |[_, u, _]| {
        [u.recip(), acceleration(u) / u, 1.0]
    })
}

/// A flight by the ODE solver.
fn flight_by_ode(model: &FlightModel, speed: f64) -> Flight {
    let drag = |u: f64| model.drag_over_weight(speed * u.abs()).unwrap();
    let [rise_time, _, apex] = until_rest(|u| -1.0 - drag(u));
    let [fall_time, impact, _] = until_way(apex, 0.0, |u| 1.0 - drag(u));
    let time_unit = speed / model.gravity_m_s2();
    Flight {
        launch_speed_m_s: speed,
        impact_speed_m_s: impact * speed,
        apex_m: apex * speed * time_unit,
        rise_time_s: rise_time * time_unit,
        fall_time_s: fall_time * time_unit,
    }
}

/// The largest relative difference between the two flights.
fn disagreement(a: &Flight, b: &Flight) -> f64 {
    [
        (a.impact_speed_m_s, b.impact_speed_m_s),
        (a.apex_m, b.apex_m),
        (a.rise_time_s, b.rise_time_s),
        (a.fall_time_s, b.fall_time_s),
    ]
    .into_iter()
    .map(|(a, b)| ((a - b) / b).abs())
    .fold(0.0, f64::max)
}

#[track_caller]
fn assert_agrees(model: &FlightModel, speed: f64) {
    let apart = disagreement(&model.launch(speed).unwrap(), &flight_by_ode(model, speed));
    assert!(apart < AGREEMENT, "{model:?} at {speed} m/s: {apart:e}");
}

/// Launch speeds from 1e-3 m/s to 0.99 of the terminal speed.
fn speeds_up_to(terminal: f64) -> impl Iterator<Item = f64> {
    let top = 0.99 * terminal;
    (0..=6).map(move |i| 1e-3 * (top / 1e-3).powf(f64::from(i) / 6.0))
}

/// The closed form over terminal speeds from 1 to 1e6 m/s.
#[test]
fn closed_form_agrees_with_the_equations_of_motion() {
    for terminal in [1.0, 3.0, 9.385, 30.0, 1e3, 1e6] {
        let model = FlightModel::with_terminal_speed(9.81, terminal).unwrap();
        for speed in speeds_up_to(terminal) {
            assert_agrees(&model, speed);
        }
    }
}

/// The standard curve and a table, with balls whose terminal speed lies within the table.
#[test]
fn quadrature_agrees_with_the_equations_of_motion() {
    let small = (
        "table:1=27,10=4.1,100=1.09,800=0.5".parse().unwrap(),
        1e-6,
        5e-3,
    );
    let balls = [DragLaw::Standard, clift_gauvin()].map(|drag| (drag, 2.7e-3, 40e-3));
    for (drag, mass_kg, diameter_m) in balls.into_iter().chain([small]) {
        let environment = Environment {
            gravity_m_s2: 9.81,
            air: Air::new(1.2, 1.8e-5).unwrap(),
            drag,
            buoyancy: false,
            added_mass: true,
        };
        let model =
            FlightModel::new(&Ball::new(mass_kg, diameter_m).unwrap(), &environment).unwrap();
        let terminal = model.terminal_speed_m_s().unwrap();
        for speed in speeds_up_to(terminal) {
            assert_agrees(&model, speed);
        }
    }
}

/// The standard drag curve over terminal speeds from 1 to 1e6 m/s: balls of one size in ever thinner
/// and more viscous gas, so that all pieces of the curve but the drag crisis are passed.
#[test]
fn the_standard_curve_agrees_over_all_terminal_speeds() {
    for terminal in [1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6] {
        let ball = Ball::new(2.7e-3, 40e-3).unwrap();
        let density = ball.weight_n(9.81) / (0.5 * 0.4 * ball.area_m2() * f64::powi(terminal, 2));
        let viscosity = density * terminal * ball.diameter_m() / 1e4;
        let environment = Environment {
            gravity_m_s2: 9.81,
            air: Air::new(density, viscosity).unwrap(),
            drag: DragLaw::Standard,
            buoyancy: false,
            added_mass: false,
        };
        let model = FlightModel::new(&ball, &environment).unwrap();
        let found = model.terminal_speed_m_s().unwrap();
        assert!((found / terminal - 1.0).abs() < 0.05);
        for speed in speeds_up_to(found) {
            assert_agrees(&model, speed);
        }
    }
}

/// Launches above the terminal speed and the drag crisis: a light ball thrown hard.
#[test]
fn fast_launches_agree_too() {
    let environment = Environment {
        gravity_m_s2: 9.81,
        air: Air::new(1.2, 1.8e-5).unwrap(),
        drag: DragLaw::Standard,
        buoyancy: true,
        added_mass: true,
    };
    let football = Ball::new(0.43, 0.22).unwrap();
    let model = FlightModel::new(&football, &environment).unwrap();
    for speed in [20.0, 30.0, 45.0] {
        assert_agrees(&model, speed);
    }
    let constant = FlightModel::with_terminal_speed(9.81, 2.0).unwrap();
    for speed in [2.0, 6.0, 20.0] {
        assert_agrees(&constant, speed);
    }
}

/// Falls from rest (paper Eqs. 11 and 13 to 15).
#[test]
fn falls_agree_with_the_equations_of_motion() {
    for terminal in [1.0, 9.385, 1e3, 1e6] {
        let model = FlightModel::with_terminal_speed(9.81, terminal).unwrap();
        for height in [
            1e-3,
            0.305,
            0.1 * terminal * terminal,
            0.5 * terminal * terminal,
        ] {
            let fall = model.fall(height).unwrap();
            let unit = (9.81 * height).sqrt();
            let drag = |u: f64| model.drag_over_weight(unit * u.abs()).unwrap();
            let [time, speed, _] = until_way(1.0, 0.0, |u| 1.0 - drag(u));
            assert!((time * unit / 9.81 / fall.time_s - 1.0).abs() < AGREEMENT);
            assert!((speed * unit / fall.impact_speed_m_s - 1.0).abs() < AGREEMENT);
        }
    }
}

/// Height and velocity within a flight, on the way up and on the way down.
#[test]
fn states_agree_with_the_equations_of_motion() {
    let environment = Environment {
        gravity_m_s2: 9.81,
        air: Air::new(1.2, 1.8e-5).unwrap(),
        drag: clift_gauvin(),
        buoyancy: false,
        added_mass: false,
    };
    let general = FlightModel::new(&Ball::new(2.7e-3, 40e-3).unwrap(), &environment).unwrap();
    for model in [
        general,
        FlightModel::with_terminal_speed(9.81, 9.0).unwrap(),
    ] {
        let speed = 8.0;
        let flight = model.launch(speed).unwrap();
        let drag = |u: f64| model.drag_over_weight(speed * u.abs()).unwrap();
        let height_unit = speed * speed / 9.81;
        for part in [0.1, 0.5, 0.9] {
            let level = part * flight.apex_m / height_unit;
            let [time, u, _] = until_way(level, 1.0, |u| -1.0 - drag(u));
            let state = model.state(&flight, time * speed / 9.81);
            assert!((state.height_m / (level * height_unit) - 1.0).abs() < AGREEMENT);
            assert!((state.velocity_m_s / (u * speed) - 1.0).abs() < AGREEMENT);

            let [time, u, _] = until_way(level, 0.0, |u| 1.0 - drag(u));
            let state = model.state(&flight, flight.rise_time_s + time * speed / 9.81);
            let above = flight.apex_m - level * height_unit;
            assert!((state.height_m - above).abs() < AGREEMENT * flight.apex_m);
            assert!((state.velocity_m_s / (-u * speed) - 1.0).abs() < AGREEMENT);
        }
    }
}
