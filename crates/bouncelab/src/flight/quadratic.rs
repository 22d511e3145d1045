//! Flights with a constant drag coefficient, in closed form.
//!
//! With κ = 1/vₜ and x = κ v the textbook forms (vₜ²/2g) ln(1 + x²), (vₜ/g) atan x and so on are
//! infinity times zero in the drag-free limit. Here each is its drag-free value times a ratio such
//! as ln(1 + x²)/x² that is 1 at zero: no drag is simply κ = 0, with no digit lost on the way.

use super::{Fall, Flight, State};

/// Quadratic drag: drag over weight is (κ v)².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct QuadraticDrag {
    gravity: f64,
    /// κ, the reciprocal of the terminal speed; zero without drag.
    slowness: f64,
}

impl QuadraticDrag {
    pub(super) fn new(gravity: f64, slowness: f64) -> Self {
        Self { gravity, slowness }
    }

    pub(super) fn gravity(&self) -> f64 {
        self.gravity
    }

    pub(super) fn terminal_speed(&self) -> Option<f64> {
        (self.slowness > 0.0).then(|| self.slowness.recip())
    }

    pub(super) fn over_weight(&self, speed: f64) -> f64 {
        (self.slowness * speed).powi(2)
    }

    /// Paper Eqs. 16 and 17 for the rise; the same energy and Eq. 11 for the fall.
    pub(super) fn launch(&self, speed: f64) -> Flight {
        let x = self.slowness * speed;
        let time = speed / self.gravity;
        Flight {
            launch_speed_m_s: speed,
            impact_speed_m_s: speed / (1.0 + x * x).sqrt(),
            apex_m: 0.5 * speed * time * ratio(x * x, f64::ln_1p),
            rise_time_s: time * ratio(x, f64::atan),
            fall_time_s: time * ratio(x, f64::asinh),
        }
    }

    /// Solves atan x + asinh x = θ, θ = κ g T, by Newton; infinite if x exceeds all numbers.
    ///
    /// The left side is concave and the start is below the root, so the steps rise to it without
    /// ever passing it.
    pub(super) fn launch_speed_of_time(&self, time: f64) -> f64 {
        /// Newton's steps square the relative error, so the one after a step this small would be rounding.
        const SMALL_STEP: f64 = 1e-8;
        const MAX_STEPS: usize = 50;
        let drag_free = 0.5 * self.gravity * time;
        let theta = 2.0 * self.slowness * drag_free;
        if theta < SMALL {
            return drag_free;
        }
        // x > θ/2 because both functions are below x; x > sinh(θ - π/2) because atan x < π/2.
        let mut x = (0.5 * theta).max((theta - std::f64::consts::FRAC_PI_2).sinh());
        for _ in 0..MAX_STEPS {
            let slope = 1.0 / (1.0 + x * x) + 1.0 / 1.0_f64.hypot(x);
            let step = (theta - x.atan() - x.asinh()) / slope;
            x += step;
            if step.abs() <= SMALL_STEP * x {
                break;
            }
        }
        x / self.slowness
    }

    /// Eq. 16 solved for the speed.
    pub(super) fn launch_speed_of_apex(&self, apex: f64) -> f64 {
        let twice_energy = 2.0 * self.gravity * apex;
        let zeta = twice_energy * self.slowness * self.slowness;
        (twice_energy * ratio(zeta, f64::exp_m1)).sqrt()
    }

    /// Eq. 15, and the time (vₜ/g) atanh(v'/vₜ).
    pub(super) fn fall(&self, height: f64) -> Fall {
        let twice_energy = 2.0 * self.gravity * height;
        let zeta = twice_energy * self.slowness * self.slowness;
        let speed = (twice_energy * ratio(-zeta, f64::exp_m1)).sqrt();
        let u = self.slowness * speed;
        // atanh u = ln(1 + u) + ζ/2, which holds when u rounds to 1.
        let atanh = |u: f64| u.ln_1p() + 0.5 * zeta;
        Fall {
            height_m: height,
            time_s: speed / self.gravity * ratio(u, atanh),
            impact_speed_m_s: speed,
        }
    }

    /// Eq. 12 and its integral (vₜ²/g) ln(cos τ + x sin τ), τ = κ g t.
    pub(super) fn rising(&self, launch_speed: f64, time: f64) -> State {
        let fallen_speed = self.gravity * time;
        let tau = self.slowness * fallen_speed;
        let x = self.slowness * launch_speed;
        // Twice the energy spent, were ln(1 + w) = w: v g t sin(τ)/τ less (g t)²/2 (sin(τ/2)/(τ/2))².
        let half_sine = fallen_speed * ratio(0.5 * tau, f64::sin);
        let spent = launch_speed * fallen_speed * ratio(tau, f64::sin) - 0.5 * half_sine.powi(2);
        let w = self.slowness * self.slowness * spent;
        State {
            height_m: spent / self.gravity * ratio(w, f64::ln_1p),
            velocity_m_s: (launch_speed - fallen_speed * ratio(tau, f64::tan))
                / (1.0 + x * tau.tan()),
        }
    }

    /// Depth and speed at a time after release: Eqs. 14 and 11.
    pub(super) fn falling(&self, time: f64) -> (f64, f64) {
        /// From here on ln cosh τ = τ - ln 2 to all digits.
        const LARGE: f64 = 20.0;
        let drag_free_speed = self.gravity * time;
        let tau = self.slowness * drag_free_speed;
        let speed = drag_free_speed * ratio(tau, f64::tanh);
        if tau > LARGE {
            let terminal = self.slowness.recip();
            return (
                terminal * (time - terminal / self.gravity * std::f64::consts::LN_2),
                speed,
            );
        }
        // ln cosh τ = ln(1 + w), w = 2 sinh²(τ/2).
        let half_sinh = drag_free_speed * ratio(0.5 * tau, f64::sinh);
        let twice_energy = 0.5 * half_sinh.powi(2);
        let w = self.slowness * self.slowness * twice_energy;
        (twice_energy / self.gravity * ratio(w, f64::ln_1p), speed)
    }
}

/// Below this a function with unit slope at zero equals its argument to half a last digit.
const SMALL: f64 = 1e-16;

/// f(x)/x for a function with f(0) = 0 and f'(0) = 1, at zero too.
#[inline]
fn ratio(x: f64, f: impl Fn(f64) -> f64) -> f64 {
    if x.abs() < SMALL { 1.0 } else { f(x) / x }
}
