//! How long an impact lasts, where nobody measured it: an estimate from mass and diameter.
//!
//! The mean density tells what kind of ball it is. A light ball is hollow, and its contact is a spring made of its gas;
//! a heavy one is solid, and Hertz's law of contact holds, with the stiffness of its class of materials.

use std::f64::consts::PI;

use super::Ball;

/// Impact speed of the estimates, m/s: a fall of 20 cm. By Hertz's law contact times go as v^(-1/5), so
/// that a speed of a tenth makes them 1.6 times as long; the uncertainties include it.
const SPEED_M_S: f64 = 2.0;

/// Mean density above which a ball is not hollow with a thin wall, kg/m³: tennis and racquetball have 380 to 410.
const HOLLOW_MAX_KG_M3: f64 = 500.0;
/// Mean density above which a ball is of glass, stone or metal, kg/m³: rubber, plastics and wood are below.
const SOFT_MAX_KG_M3: f64 = 2000.0;

/// Pressure that holds up a hollow ball, Pa: about that of the air. Of the presets of balls with a thin wall, from their
/// contact times, it is 35 to 260 kPa, with a scatter of the contact time of a third.
const HOLLOW_PRESSURE_PA: f64 = 1.0e5;
const HOLLOW_REL_SD: f64 = 0.5;

/// Modulus E* of solid balls of rubber, plastics and wood, Pa: the geometric mean of a rubber ball (5 `MPa`) and of a hard
/// plastic on a wooden floor (1 `GPa`), both within one standard uncertainty.
const SOFT_MODULUS_PA: f64 = 7.0e7;
const SOFT_REL_SD: f64 = 1.1;

/// Modulus E* of glass and metal on a floor, Pa: the geometric mean of wood (1 `GPa`) and stone (60 `GPa`), both within 1.2
/// standard uncertainties.
const HARD_MODULUS_PA: f64 = 8.0e9;
const HARD_REL_SD: f64 = 0.7;

/// A contact time and its relative standard uncertainty.
pub(super) struct ContactEstimate {
    pub(super) time_s: f64,
    pub(super) rel_sd: f64,
}

/// The contact time of a ball of which only mass and diameter are known.
pub(super) fn of_density(ball: &Ball) -> ContactEstimate {
    let density = ball.density_kg_m3();
    let (time_s, rel_sd) = if density < HOLLOW_MAX_KG_M3 {
        (hollow_s(ball, HOLLOW_PRESSURE_PA), HOLLOW_REL_SD)
    } else if density < SOFT_MAX_KG_M3 {
        (solid_s(ball, SOFT_MODULUS_PA), SOFT_REL_SD)
    } else {
        (solid_s(ball, HARD_MODULUS_PA), HARD_REL_SD)
    };
    ContactEstimate { time_s, rel_sd }
}

/// Contact time of a thin ball that its gas holds up.
///
/// Pressed flat by x, a sphere of radius R touches the surface in a circle of area 2 π R x, on which the gas presses with
/// its excess pressure p: a spring of stiffness k = 2 π R p. The contact is half an oscillation, π √(m/k).
fn hollow_s(ball: &Ball, pressure_pa: f64) -> f64 {
    let radius_m = 0.5 * ball.diameter_m();
    PI * (ball.mass_kg() / (2.0 * PI * radius_m * pressure_pa)).sqrt()
}

/// Contact time of a solid elastic ball on a flat surface: T = 2.87 (m²/(R E*² v))^(1/5).
///
/// H. Hertz, J. reine angew. Math. 92, 156 (1882), in the form of K. L. Johnson, Contact Mechanics (1985), Eq. 11.24.
/// Balls of one material have contact times in proportion to their diameters.
fn solid_s(ball: &Ball, modulus_pa: f64) -> f64 {
    let radius_m = 0.5 * ball.diameter_m();
    let stiffness = radius_m * modulus_pa.powi(2) * SPEED_M_S;
    2.87 * (ball.mass_kg().powi(2) / stiffness).powf(0.2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ball::presets;

    /// By numbers of its own: the equation of motion of the contact, m x'' = -F(x) from x = 0 at speed v until x = 0
    /// again, in small steps.
    fn integrated_s(mass_kg: f64, speed_m_s: f64, force_n: impl Fn(f64) -> f64) -> f64 {
        let step_s = 1e-8;
        let (mut x, mut v, mut time_s) = (0.0, speed_m_s, 0.0);
        while x >= 0.0 {
            v -= force_n(x) / mass_kg * step_s;
            x += v * step_s;
            time_s += step_s;
        }
        time_s
    }

    #[test]
    fn contact_times_solve_the_equation_of_motion() {
        let basketball = Ball::new(0.6, 0.243).unwrap();
        let spring = |x: f64| 2.0 * PI * 0.1215 * 5e4 * x;
        let expected = integrated_s(0.6, SPEED_M_S, spring);
        assert!((hollow_s(&basketball, 5e4) / expected - 1.0).abs() < 1e-3);
        let steel = Ball::new(4.09e-3, 0.01).unwrap();
        // Hertz: F = 4/3 E* √R x^(3/2).
        let hertz = |x: f64| 4.0 / 3.0 * 5e10 * 0.005_f64.sqrt() * x.max(0.0).powf(1.5);
        let expected = integrated_s(4.09e-3, SPEED_M_S, hertz);
        assert!((solid_s(&steel, 5e10) / expected - 1.0).abs() < 5e-3);
    }

    /// Mass and diameter alone give the contact time of every preset, with an honest uncertainty.
    #[test]
    fn the_contact_times_of_the_presets_are_found_from_mass_and_diameter() {
        for preset in presets() {
            let known = preset.known;
            let found = of_density(&known.ball);
            let off = (known.contact_time_s / found.time_s).ln() / found.rel_sd;
            assert!(off.abs() < 2.0, "{}: {off}", preset.name);
        }
    }

    #[test]
    fn a_basketball_takes_longer_than_a_table_tennis_ball_and_steel_the_least() {
        let time_s =
            |mass_kg, diameter_m| of_density(&Ball::new(mass_kg, diameter_m).unwrap()).time_s;
        let [basketball, table_tennis, steel] = [
            time_s(0.6, 0.243),
            time_s(2.7e-3, 0.04),
            time_s(4.09e-3, 0.01),
        ];
        assert!(basketball > 5.0 * table_tennis && table_tennis > 5.0 * steel);
    }
}
