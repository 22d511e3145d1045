//! Flights whose drag coefficient follows the Reynolds number, by quadrature.
//!
//! With η drag over weight, the rise is dt = dv/(g (1 + η)) and the fall dt = dv/(g (1 - η)); dh =
//! v dt. Both are integrated not over the speed but over the parameter p of the closed solution for
//! constant drag, v = vₛ tan p in the rise and v = vₛ tanh p in the fall:
//!
//! dt = (vₛ/g) w dp,   dh = (vₛ²/g) u w dp,   u = v/vₛ,   w = (1 ± u²)/(1 ± η).
//!
//! With vₛ the terminal speed, the weight w is 1 for constant drag and a smooth function near 1
//! for every law, at launches far above the terminal speed and in falls that all but reach it.

use super::quadrature::{self, Pair};
use super::{Fall, Flight, LaunchDerivatives, State};
use crate::air::Air;
use crate::ball::Ball;
use crate::drag::DragLaw;
use crate::error::{Quantity, Result, within};

/// Tolerance of each integral relative to its value.
const TOLERANCE: f64 = 1e-12;

/// Newton stops after a relative step this small: the next would be lost in rounding.
const SMALL_STEP: f64 = 1e-8;

/// Newton's method with brackets needs less than ten steps; the others are for bisection in a drag crisis.
const MAX_STEPS: usize = 200;

/// Launches above this many terminal speeds are refused: tan p has no digits left there.
const MAX_LAUNCH: f64 = 1e4;

/// The two halves of a flight.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Leg {
    Rise,
    Fall,
}

impl Leg {
    /// The parameter p of a relative speed u.
    fn parameter(self, u: f64) -> f64 {
        match self {
            Self::Rise => u.atan(),
            Self::Fall => u.atanh(),
        }
    }

    /// The relative speed at a parameter.
    fn speed(self, p: f64) -> f64 {
        match self {
            Self::Rise => p.tan(),
            Self::Fall => p.tanh(),
        }
    }
}

/// Which of the two integrals of a leg is given.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Known {
    Time = 0,
    Height = 1,
}

/// A part of a leg from or to rest: its parameter, and time and height in units of vₛ/g and vₛ²/g.
#[derive(Debug, Clone, Copy)]
struct Arc {
    parameter: f64,
    time: f64,
    height: f64,
}

/// A ball whose drag follows a law of the Reynolds number.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ReynoldsDrag {
    law: DragLaw,
    gravity: f64,
    reynolds_per_speed: f64,
    /// Stokes drag over weight at unit speed.
    stokes_over_weight: f64,
    /// The speed vₛ by which speeds are measured: the terminal speed, or if the law ends before
    /// it, the terminal speed of the coefficient at that end.
    scale: f64,
    /// The law near the terminal speed; `None` if it ends before.
    near_terminal: Option<NearTerminal>,
}

/// The excess (u² - η)/(1 - u²) of constant drag over the law where both are nearly 1 and the
/// difference would be rounding: a straight line in 1 - u².
#[derive(Debug, Clone, Copy, PartialEq)]
struct NearTerminal {
    at_terminal: f64,
    slope: f64,
}

impl NearTerminal {
    /// The straight line is used for 1 - u² below this. Its error is the square of this, the
    /// rounding it avoids the reciprocal of it times 1e-16.
    const LIMIT: f64 = 1e-5;

    fn excess(&self, gap: f64) -> f64 {
        self.at_terminal + self.slope * gap
    }
}

impl ReynoldsDrag {
    /// A ball of a buoyant weight that obeys an effective gravity. The air is no vacuum.
    pub(super) fn new(ball: &Ball, air: &Air, law: DragLaw, weight: f64, gravity: f64) -> Self {
        use std::f64::consts::PI;
        let mut drag = Self {
            law,
            gravity,
            reynolds_per_speed: air.reynolds(ball, 1.0),
            stokes_over_weight: 3.0 * PI * air.viscosity_pa_s() * ball.diameter_m() / weight,
            scale: 1.0,
            near_terminal: None,
        };
        if let Some(terminal) = drag.find_terminal_speed() {
            drag.scale = terminal;
            drag.near_terminal = Some(drag.fit_near_terminal());
        } else {
            let fastest = drag.max_speed();
            drag.scale = fastest / drag.over_weight(fastest).sqrt();
        }
        drag
    }

    pub(super) fn gravity(&self) -> f64 {
        self.gravity
    }

    pub(super) fn terminal_speed(&self) -> Option<f64> {
        self.near_terminal.map(|_| self.scale)
    }

    /// η, without a check of the range of the law.
    pub(super) fn over_weight(&self, speed: f64) -> f64 {
        self.stokes_over_weight * speed * self.law.over_stokes(self.reynolds_per_speed * speed)
    }

    pub(super) fn check_speed(&self, speed: f64) -> Result<()> {
        self.law.check_reynolds(self.reynolds_per_speed * speed)
    }

    fn max_speed(&self) -> f64 {
        self.law.max_reynolds() / self.reynolds_per_speed
    }

    /// The lowest speed at which drag equals weight, if the law reaches it.
    ///
    /// In the drag crisis the drag falls with speed, so the first crossing is searched in small
    /// steps, and at the joints where it may peak, before it is bisected.
    fn find_terminal_speed(&self) -> Option<f64> {
        const STEP: f64 = 1.02;
        /// Below this Reynolds number all laws are Stokes' within a factor of two.
        const CREEPING: f64 = 0.01;
        let slow = (CREEPING / self.reynolds_per_speed).min(0.5 / self.stokes_over_weight);
        let fastest = self.max_speed();
        let mut below = slow;
        while self.over_weight(below * STEP) < 1.0 {
            below *= STEP;
            if below >= fastest {
                return None;
            }
        }
        let mut above = below * STEP;
        let ends_of_pieces = self
            .law
            .joints()
            .iter()
            .map(|joint| joint * (1.0 - f64::EPSILON));
        let mut peaks = ends_of_pieces.map(|reynolds| reynolds / self.reynolds_per_speed);
        if let Some(peak) = peaks.find(|&peak| peak < below && self.over_weight(peak) >= 1.0) {
            (below, above) = (slow, peak);
        }
        let terminal = self.bisect_terminal_speed(below, above);
        (terminal <= fastest).then_some(terminal)
    }

    fn bisect_terminal_speed(&self, mut below: f64, mut above: f64) -> f64 {
        loop {
            let middle = 0.5 * (below + above);
            if middle <= below || middle >= above {
                return above;
            }
            if self.over_weight(middle) < 1.0 {
                below = middle;
            } else {
                above = middle;
            }
        }
    }

    fn fit_near_terminal(&self) -> NearTerminal {
        let excess = |gap: f64| {
            let square = 1.0 - gap;
            (square - self.over_weight(self.scale * square.sqrt())) / gap
        };
        let near = excess(NearTerminal::LIMIT);
        let slope = (excess(2.0 * NearTerminal::LIMIT) - near) / NearTerminal::LIMIT;
        NearTerminal {
            at_terminal: near - slope * NearTerminal::LIMIT,
            slope,
        }
    }

    /// The integrands [w, u w] of time and height.
    fn rates(&self, leg: Leg, p: f64) -> Pair {
        let u = leg.speed(p);
        let weight = match leg {
            Leg::Rise => (1.0 + u * u) / (1.0 + self.over_weight(self.scale * u)),
            Leg::Fall => {
                let gap = p.cosh().recip().powi(2);
                let excess = match self.near_terminal {
                    Some(near) if gap < NearTerminal::LIMIT => near.excess(gap),
                    _ => (u * u - self.over_weight(self.scale * u)) / gap,
                };
                1.0 / (1.0 + excess)
            }
        };
        [weight, u * weight]
    }

    /// Time and height between two parameters of a leg, split where the law changes its formula.
    fn integrate(&self, leg: Leg, from: f64, to: f64) -> Pair {
        if to < from {
            return self.integrate(leg, to, from).map(|integral| -integral);
        }
        // For constant drag the integrals from rest are p and about p²/2 or p.
        let tolerance = [TOLERANCE * to, TOLERANCE * to * to.min(1.0) / 2.0];
        let rates = |p: f64| self.rates(leg, p);
        let mut sum = [0.0; 2];
        let mut start = from;
        let mut add = |end: f64| {
            let part = quadrature::integrate(&rates, start, end, tolerance);
            sum = [sum[0] + part[0], sum[1] + part[1]];
            start = end;
        };
        for joint in self.law.joints() {
            let p = leg.parameter(joint / (self.reynolds_per_speed * self.scale));
            if p > from && p < to {
                add(p);
            }
        }
        add(to);
        sum
    }

    /// The arc from rest on which the given integral has a value, by Newton on the parameter.
    ///
    /// Each step adds the integral over the step to that before, so that the whole is integrated
    /// once.
    fn solve(&self, leg: Leg, known: Known, value: f64, guess: f64) -> Arc {
        let limit = self.parameter_limit(leg);
        let mut arc = Arc {
            parameter: 0.0,
            time: 0.0,
            height: 0.0,
        };
        if value <= 0.0 {
            return arc;
        }
        let mut next = guess.min(limit);
        for _ in 0..MAX_STEPS {
            let [time, height] = self.integrate(leg, arc.parameter, next);
            arc = Arc {
                parameter: next,
                time: arc.time + time,
                height: arc.height + height,
            };
            let rates = self.rates(leg, arc.parameter);
            let reached = if known == Known::Time {
                arc.time
            } else {
                arc.height
            };
            let step = (value - reached) / rates[known as usize];
            if step.abs() <= SMALL_STEP * arc.parameter {
                arc.parameter += step;
                arc.time += rates[0] * step;
                arc.height += rates[1] * step;
                break;
            }
            next = (arc.parameter + step).clamp(0.5 * arc.parameter, limit);
        }
        arc
    }

    /// The maximum parameter of a solution: a right angle in the rise, in the fall the end of a
    /// law that ends before the terminal speed.
    fn parameter_limit(&self, leg: Leg) -> f64 {
        match leg {
            Leg::Rise => std::f64::consts::FRAC_PI_2,
            Leg::Fall if self.near_terminal.is_some() => f64::INFINITY,
            Leg::Fall => leg.parameter(self.max_speed() / self.scale),
        }
    }

    fn time_unit(&self) -> f64 {
        self.scale / self.gravity
    }

    fn height_unit(&self) -> f64 {
        self.scale * self.scale / self.gravity
    }

    pub(super) fn launch(&self, speed: f64) -> Result<Flight> {
        self.check_speed(speed)?;
        let u = speed / self.scale;
        within(Quantity::SpeedRatio, u, ..=MAX_LAUNCH)?;
        let [rise_time, apex] = self.integrate(Leg::Rise, 0.0, u.atan());
        let fall = self.solve(Leg::Fall, Known::Height, apex, u.asinh());
        Ok(Flight {
            launch_speed_m_s: speed,
            impact_speed_m_s: self.scale * Leg::Fall.speed(fall.parameter),
            apex_m: apex * self.height_unit(),
            rise_time_s: rise_time * self.time_unit(),
            fall_time_s: fall.time * self.time_unit(),
        })
    }

    pub(super) fn launch_lasting(&self, time: f64) -> Result<Flight> {
        let drag_free = 0.5 * self.gravity * time;
        self.launch_to(time, drag_free, |flight, slopes| {
            (flight.time_s(), slopes.time)
        })
    }

    pub(super) fn launch_rising_to(&self, apex: f64) -> Result<Flight> {
        let drag_free = (2.0 * self.gravity * apex).sqrt();
        self.launch_to(apex, drag_free, |flight, slopes| {
            (flight.apex_m, slopes.apex)
        })
    }

    /// The flight on which a quantity that grows with the launch speed has a value, by Newton within
    /// brackets; `measure` returns the quantity and its derivative.
    fn launch_to(
        &self,
        value: f64,
        guess: f64,
        measure: impl Fn(&Flight, &LaunchDerivatives) -> (f64, f64),
    ) -> Result<Flight> {
        let fastest = self.max_speed();
        let (mut below, mut above) = (0.0, f64::INFINITY);
        let mut speed = guess.min(fastest);
        for _ in 0..MAX_STEPS {
            let flight = self.launch(speed)?;
            let (reached, slope) = measure(&flight, &self.launch_derivatives(&flight));
            let next = speed + (value - reached) / slope;
            if (next - speed).abs() <= SMALL_STEP * speed {
                return self.launch(next);
            }
            if reached < value {
                below = speed;
            } else {
                above = speed;
            }
            if below >= fastest {
                self.check_speed(next)?;
            }
            let inside = next > below && next < above;
            speed = if inside {
                next.min(fastest)
            } else {
                0.5 * (below + above)
            };
        }
        self.launch(speed)
    }

    pub(super) fn launch_derivatives(&self, flight: &Flight) -> LaunchDerivatives {
        LaunchDerivatives::of(
            flight,
            self.gravity,
            self.over_weight(flight.launch_speed_m_s),
            self.over_weight(flight.impact_speed_m_s),
        )
    }

    pub(super) fn fall(&self, height: f64) -> Result<Fall> {
        let value = height / self.height_unit();
        let constant_drag_speed = (-(-2.0 * value).exp_m1()).sqrt();
        if self.near_terminal.is_none() {
            let [_, reach] = self.integrate(Leg::Fall, 0.0, self.parameter_limit(Leg::Fall));
            if value > reach {
                self.check_speed(self.scale * constant_drag_speed)?;
            }
        }
        let guess = constant_drag_speed.ln_1p() + value;
        let fall = self.solve(Leg::Fall, Known::Height, value, guess);
        Ok(Fall {
            height_m: height,
            time_s: fall.time * self.time_unit(),
            impact_speed_m_s: self.scale * Leg::Fall.speed(fall.parameter),
        })
    }

    /// The state at a time on the way up, by the arc from there to the apex.
    pub(super) fn rising(&self, flight: &Flight, time: f64) -> State {
        let remaining = (flight.rise_time_s - time) / self.time_unit();
        let arc = self.solve(Leg::Rise, Known::Time, remaining, remaining);
        State {
            height_m: flight.apex_m - arc.height * self.height_unit(),
            velocity_m_s: self.scale * Leg::Rise.speed(arc.parameter),
        }
    }

    /// Depth and speed at a time after coming to rest.
    pub(super) fn falling(&self, time: f64) -> (f64, f64) {
        let fallen = time / self.time_unit();
        let arc = self.solve(Leg::Fall, Known::Time, fallen, fallen);
        (
            arc.height * self.height_unit(),
            self.scale * Leg::Fall.speed(arc.parameter),
        )
    }
}
