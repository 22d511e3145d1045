//! Drops simulated by code of their own: no formula is shared with the library that is to be judged.
//!
//! Flights are integrated step by step, the drag of a sphere is that of another author than the library's default, and
//! balls, laws of restitution and sounds are written down here.

use std::f64::consts::{PI, TAU};

use bouncelab::impact::ImpactEvent;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

/// Air of 20 °C and 1013 hPa: density, kg/m³, and kinematic viscosity, m²/s.
const AIR_KG_M3: f64 = 1.20;
const AIR_M2_S: f64 = 1.51e-5;
/// Middle latitudes, m/s²; the library assumes 9.80665.
pub(crate) const GRAVITY_M_S2: f64 = 9.81;

pub(crate) fn normal(rng: &mut ChaCha8Rng) -> f64 {
    rng.sample(StandardNormal)
}

/// Anything in between, evenly.
pub(crate) fn between((low, high): (f64, f64), rng: &mut ChaCha8Rng) -> f64 {
    low + (high - low) * rng.random::<f64>()
}

/// Anything in between, evenly in the logarithm.
pub(crate) fn log_between((low, high): (f64, f64), rng: &mut ChaCha8Rng) -> f64 {
    between((low.ln(), high.ln()), rng).exp()
}

/// A sphere in air.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sphere {
    pub(crate) mass_kg: f64,
    pub(crate) diameter_m: f64,
    /// Its drag over that of a smooth sphere; 0 for a fall without air.
    pub(crate) drag: f64,
    pub(crate) gravity_m_s2: f64,
}

/// Height above the surface, m, and speed upwards, m/s.
type State = [f64; 2];

impl Sphere {
    /// (m + ρV/2) dv/dt = -(m - ρV) g - ρ A c |v| v/2: weight, buoyancy, added mass of potential flow, drag.
    fn acceleration_m_s2(&self, speed_m_s: f64) -> f64 {
        if self.drag == 0.0 {
            return -self.gravity_m_s2;
        }
        let displaced_kg = AIR_KG_M3 * PI / 6.0 * self.diameter_m.powi(3);
        let area_m2 = PI / 4.0 * self.diameter_m.powi(2);
        let reynolds = speed_m_s.abs() * self.diameter_m / AIR_M2_S;
        let drag_n = 0.5
            * AIR_KG_M3
            * area_m2
            * self.drag
            * coefficient(reynolds)
            * speed_m_s.abs()
            * speed_m_s;
        let weight_n = (self.mass_kg - displaced_kg) * self.gravity_m_s2;
        -(weight_n + drag_n) / (self.mass_kg + 0.5 * displaced_kg)
    }

    /// A step of the classical Runge-Kutta method.
    fn stepped(&self, [height, speed]: State, step_s: f64) -> State {
        let k1 = self.acceleration_m_s2(speed);
        let k2 = self.acceleration_m_s2(speed + 0.5 * step_s * k1);
        let k3 = self.acceleration_m_s2(speed + 0.5 * step_s * k2);
        let k4 = self.acceleration_m_s2(speed + step_s * k3);
        [
            height + step_s * speed + step_s * step_s / 6.0 * (k1 + k2 + k3),
            speed + step_s / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4),
        ]
    }

    /// Time, s, and speed, m/s, when it reaches the surface.
    fn landing(&self, mut state: State, step_s: f64) -> (f64, f64) {
        let mut time_s = 0.0;
        loop {
            let next = self.stepped(state, step_s);
            if next[0] < 0.0 {
                break;
            }
            (state, time_s) = (next, time_s + step_s);
        }
        // Newton's method on the last, shorter step; the ball is fast there.
        let mut last_s = 0.5 * step_s;
        for _ in 0..20 {
            let [height, speed] = self.stepped(state, last_s);
            last_s -= height / speed;
        }
        (time_s + last_s, -self.stepped(state, last_s)[1])
    }

    /// Time and impact speed of a fall from rest.
    pub(crate) fn fall(&self, height_m: f64) -> (f64, f64) {
        let without_air_s = (2.0 * height_m / self.gravity_m_s2).sqrt();
        self.landing([height_m, 0.0], without_air_s / STEPS)
    }

    /// Time and impact speed of a flight that begins upwards at this speed.
    pub(crate) fn flight(&self, launch_m_s: f64) -> (f64, f64) {
        let without_air_s = 2.0 * launch_m_s / self.gravity_m_s2;
        self.landing([0.0, launch_m_s], without_air_s / STEPS)
    }
}

/// Steps of a flight, which then is exact to 0.1 µs.
const STEPS: f64 = 100.0;

/// The drag coefficient of a smooth sphere (P. P. Brown, D. F. Lawler, J. Environ. Eng. 129, 222, 2003, Eq. 19).
fn coefficient(reynolds: f64) -> f64 {
    if reynolds == 0.0 {
        return 0.0;
    }
    24.0 / reynolds * (1.0 + 0.150 * reynolds.powf(0.681)) + 0.407 / (1.0 + 8710.0 / reynolds)
}

/// What a ball has of matter.
#[derive(Debug)]
enum Matter {
    /// Its mass, kg.
    Mass((f64, f64)),
    /// The density of a ball of one material, kg/m³.
    Density((f64, f64)),
}

/// A kind of ball, as balls differ.
#[derive(Debug)]
pub(crate) struct Kind {
    /// Its name, and how it is stated with its diameter in metres.
    pub(crate) name: &'static str,
    pub(crate) stated: fn(f64) -> String,
    diameter_m: (f64, f64),
    matter: Matter,
    drag: (f64, f64),
    /// Contact time at 1 m/s, s. That of a solid ball goes with v^(-1/5) (H. Hertz, 1881).
    contact_s: (f64, f64),
    /// Restitution at the middle speed.
    restitution: (f64, f64),
    scatter: f64,
}

/// Mass and size by the rules of the sport, or as sold. Felt has up to 1.6 times the drag of a smooth sphere (R. D. Mehta,
/// J. M. Pallis, Sports Eng. 4, 177, 2001). Contact times and restitution: R. Cross, Am. J. Phys. 67, 222, 1999, and 82, 2014.
pub(crate) const KINDS: [Kind; 6] = [
    Kind {
        name: "table-tennis",
        stated: |_| "table-tennis-40".to_owned(),
        diameter_m: (40.0e-3, 40.6e-3),
        matter: Matter::Mass((2.67e-3, 2.77e-3)),
        drag: (0.95, 1.06),
        contact_s: (0.7e-3, 1.4e-3),
        restitution: (0.80, 0.95),
        scatter: 0.003,
    },
    Kind {
        name: "tennis",
        stated: |_| "tennis".to_owned(),
        diameter_m: (65.4e-3, 68.6e-3),
        matter: Matter::Mass((56.0e-3, 59.4e-3)),
        drag: (1.1, 1.6),
        contact_s: (4e-3, 7e-3),
        restitution: (0.68, 0.82),
        scatter: 0.006,
    },
    Kind {
        name: "basketball",
        stated: |_| "basketball".to_owned(),
        diameter_m: (238.7e-3, 245.1e-3),
        matter: Matter::Mass((0.580, 0.620)),
        drag: (0.95, 1.25),
        contact_s: (10e-3, 20e-3),
        restitution: (0.74, 0.88),
        scatter: 0.004,
    },
    Kind {
        name: "golf",
        stated: |_| "golf".to_owned(),
        diameter_m: (42.67e-3, 42.80e-3),
        matter: Matter::Mass((45.2e-3, 45.93e-3)),
        drag: (0.9, 1.2),
        contact_s: (0.4e-3, 0.7e-3),
        restitution: (0.78, 0.93),
        scatter: 0.004,
    },
    Kind {
        name: "marble",
        stated: |diameter_m| format!("marble:{diameter_m}"),
        diameter_m: (14e-3, 25e-3),
        matter: Matter::Density((2450.0, 2550.0)),
        drag: (0.95, 1.06),
        contact_s: (0.05e-3, 0.15e-3),
        restitution: (0.60, 0.95),
        scatter: 0.005,
    },
    Kind {
        name: "steel",
        stated: |diameter_m| format!("steel:{diameter_m}"),
        diameter_m: (8e-3, 30e-3),
        matter: Matter::Density((7750.0, 7850.0)),
        drag: (0.95, 1.06),
        contact_s: (0.04e-3, 0.15e-3),
        restitution: (0.60, 0.96),
        scatter: 0.004,
    },
];

/// How restitution depends on the impact speed v, m/s.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Law {
    /// The same at each.
    Constant(f64),
    /// e at the middle speed, times (v/middle)^-p.
    Power(f64, f64),
    /// e at the middle speed, less this share of it for each m/s more.
    Linear(f64, f64),
    /// 1 - c v^(1/5): the first term of a viscoelastic sphere, of any strength.
    FifthPower(f64),
    /// e, but up to 15 % lower below about 0.3 m/s: e (1 - 0.15 exp(-v/0.3)).
    WorseWhenSlow(f64),
}

/// About the middle of the impact speeds of drops from a table, m/s.
const MIDDLE_M_S: f64 = 1.5;

impl Law {
    /// One of the first four, with restitution that does not rise with the speed.
    fn ordinary(restitution: f64, rng: &mut ChaCha8Rng) -> Self {
        let falling = rng.random::<f64>();
        match rng.random_range(0..4) {
            0 => Self::Constant(restitution),
            1 => Self::Power(restitution, 0.1 * falling),
            2 => Self::Linear(restitution, 0.03 * falling),
            _ => Self::FifthPower((1.0 - restitution) / MIDDLE_M_S.powf(0.2)),
        }
    }

    pub(crate) fn at(self, speed_m_s: f64) -> f64 {
        match self {
            Self::Constant(e) => e,
            Self::Power(e, p) => e * (speed_m_s / MIDDLE_M_S).powf(-p),
            Self::Linear(e, share) => e * (1.0 - share * (speed_m_s - MIDDLE_M_S)),
            Self::FifthPower(c) => 1.0 - c * speed_m_s.powf(0.2),
            Self::WorseWhenSlow(e) => e * (1.0 - 0.15 * (-speed_m_s / 0.3).exp()),
        }
    }
}

/// A ball and a surface.
#[derive(Clone, Debug)]
pub(crate) struct BallOnSurface {
    pub(crate) kind: &'static Kind,
    pub(crate) sphere: Sphere,
    pub(crate) law: Law,
    contact_s: f64,
    scatter: f64,
}

impl BallOnSurface {
    /// A ball of this kind with one of the ordinary laws.
    pub(crate) fn of(kind: &'static Kind, rng: &mut ChaCha8Rng) -> Self {
        let diameter_m = between(kind.diameter_m, rng);
        let mass_kg = match kind.matter {
            Matter::Density(density) => between(density, rng) * PI / 6.0 * diameter_m.powi(3),
            Matter::Mass(mass) => between(mass, rng),
        };
        let drag = between(kind.drag, rng);
        Self {
            kind,
            sphere: Sphere {
                mass_kg,
                diameter_m,
                drag,
                gravity_m_s2: GRAVITY_M_S2,
            },
            law: Law::ordinary(between(kind.restitution, rng), rng),
            contact_s: log_between(kind.contact_s, rng),
            scatter: kind.scatter * (0.5 * normal(rng)).exp(),
        }
    }

    fn contact_s(&self, speed_m_s: f64) -> f64 {
        match self.kind.matter {
            Matter::Density(_) => self.contact_s * speed_m_s.powf(-0.2),
            Matter::Mass(_) => self.contact_s,
        }
    }

    /// The impacts of a drop from a height, the first at time 0, up to a number and a shortest flight in seconds.
    pub(crate) fn impact_events(
        &self,
        height_m: f64,
        (most, shortest_s): (usize, f64),
        rng: &mut ChaCha8Rng,
    ) -> Vec<ImpactEvent> {
        let (_, mut speed_m_s) = self.sphere.fall(height_m);
        let mut time_s = 0.0;
        let mut events = Vec::new();
        for _ in 0..most {
            events.push(ImpactEvent { time_s, speed_m_s });
            let kept = self.law.at(speed_m_s) * (self.scatter * normal(rng)).exp();
            let flight = self.sphere.flight(speed_m_s * kept.min(1.0));
            if flight.0 < shortest_s {
                break;
            }
            time_s += flight.0 + self.contact_s(speed_m_s);
            speed_m_s = flight.1;
        }
        events
    }
}

pub(crate) const SAMPLE_RATE_HZ: u32 = 44_100;

/// How impacts sound: decaying tones at once, as the ball and the surface ring.
#[derive(Clone, Debug)]
pub(crate) struct Ring {
    /// Frequency, Hz, and decay, 1/s, of each tone.
    tones: Vec<(f64, f64)>,
}

impl Ring {
    /// Of tones between two frequencies, Hz.
    pub(crate) fn of(hz: (f64, f64), rng: &mut ChaCha8Rng) -> Self {
        let mut tone = || (log_between(hz, rng), log_between((150.0, 600.0), rng));
        Self {
            tones: (0..4).map(|_| tone()).collect(),
        }
    }

    /// Adds a sound of this amplitude that begins at a time.
    pub(crate) fn sound(&self, at_s: f64, amplitude: f64, samples: &mut [f32]) {
        let rate = f64::from(SAMPLE_RATE_HZ);
        let first = (at_s * rate).ceil();
        let after = samples.iter_mut().skip(first as usize);
        for (place, sample) in after.take(SAMPLE_RATE_HZ as usize / 25).enumerate() {
            let since_s = (first + place as f64) / rate - at_s;
            let tones = self.tones.iter();
            let ring =
                tones.map(|(hz, decay)| (TAU * hz * since_s).sin() * (-decay * since_s).exp());
            *sample += (amplitude * ring.sum::<f64>()) as f32;
        }
    }
}

/// A quiet room: white noise of this amplitude.
pub(crate) fn quiet(duration_s: f64, noise: f64, rng: &mut ChaCha8Rng) -> Vec<f32> {
    let count = (duration_s * f64::from(SAMPLE_RATE_HZ)) as usize;
    (0..count).map(|_| (noise * normal(rng)) as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: Sphere = Sphere {
        mass_kg: 2.7e-3,
        diameter_m: 0.04,
        drag: 1.0,
        gravity_m_s2: GRAVITY_M_S2,
    };

    #[test]
    fn flights_without_air_are_those_of_the_closed_forms() {
        let ball = Sphere { drag: 0.0, ..BALL };
        let (time_s, speed_m_s) = ball.flight(2.0);
        assert!((time_s - 4.0 / GRAVITY_M_S2).abs() < 1e-12);
        assert!((speed_m_s - 2.0).abs() < 1e-12);
        let (time_s, speed_m_s) = ball.fall(0.3);
        assert!((time_s - (0.6 / GRAVITY_M_S2).sqrt()).abs() < 1e-12);
        assert!((speed_m_s - (0.6 * GRAVITY_M_S2).sqrt()).abs() < 1e-12);
    }

    /// Time and height in which the speed changes from 0 to this one, by the integrals of dv/a and v dv/a over the speed;
    /// `up` is 1 while it rises and -1 while it falls.
    fn integrals(up: f64, to_m_s: f64) -> [f64; 2] {
        let steps = 200_000;
        let step = to_m_s / f64::from(steps);
        let middles = (0..steps).map(|number| (f64::from(number) + 0.5) * step);
        middles.fold([0.0, 0.0], |[time_s, height_m], speed| {
            let share = step / BALL.acceleration_m_s2(up * speed).abs();
            [time_s + share, height_m + speed * share]
        })
    }

    #[test]
    fn flights_in_air_are_those_of_the_integrals_over_the_speed() {
        for launch_m_s in [0.3, 2.0, 5.0] {
            let (time_s, impact_m_s) = BALL.flight(launch_m_s);
            let [rise_s, apex_m] = integrals(1.0, launch_m_s);
            let [fall_s, fallen_m] = integrals(-1.0, impact_m_s);
            assert!(
                (rise_s + fall_s - time_s).abs() < 1e-7,
                "{launch_m_s}: {time_s}"
            );
            assert!((apex_m - fallen_m).abs() < 1e-7, "{launch_m_s}: {apex_m}");
            let fall = BALL.fall(apex_m);
            assert!((fall.0 - fall_s).abs() < 1e-7 && (fall.1 - impact_m_s).abs() < 1e-7);
        }
    }
}
