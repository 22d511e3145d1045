//! What a person states, if it looks like a mistake of units.
//!
//! Arguments of any command and notes of a session are questioned alike: what is out of the ordinary
//! is not believed until it is corrected or insisted on (`--allow-implausible`). What is ordinary by itself,
//! but not for the recording, is only remarked on.

use std::fmt;

use bouncelab::analysis::Drop;
use bouncelab::ball::Ball;
use bouncelab_report::{Quantity, Unit};

use crate::failure::Failure;

/// How to go on where something was questioned.
const HOW_ON: &str = "Correct it, or insist by --allow-implausible";

/// A inference, without how to go on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Doubt(String);

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {HOW_ON}", self.0)
    }
}

/// Refuses to go on while there are questions, unless the person insists.
pub(crate) fn settle(doubts: &[Doubt], insisted: bool) -> Result<(), Failure> {
    if insisted || doubts.is_empty() {
        return Ok(());
    }
    let questions: Vec<&str> = doubts.iter().map(|doubt| doubt.0.as_str()).collect();
    Err(Failure::Usage(format!("{} {HOW_ON}", questions.join(" "))))
}

/// Questions about what was stated of some quantities.
pub(crate) fn of_quantities(stated: &[(&str, Option<f64>)]) -> Vec<Doubt> {
    let stated = stated.iter();
    stated
        .filter_map(|&(field, value)| of_quantity(field, value?))
        .collect()
}

/// A number in a unit: that of the value times this.
struct Written(f64, &'static str);

/// The number as it is, in another unit.
const fn number(unit: &'static str) -> Written {
    Written(1.0, unit)
}

/// What is ordinary of a quantity, and what another unit would make of it.
struct Ordinary {
    field: &'static str,
    low: f64,
    high: f64,
    /// Shows a value.
    shown: fn(f64) -> String,
    /// Other readings: by how much the value would change, and how it would be written.
    others: &'static [(f64, Written)],
}

const ORDINARY: [Ordinary; 9] = [
    Ordinary {
        field: "height",
        low: 0.01,
        high: 10.0,
        shown: |m| format!("a drop height of {m} m"),
        others: &[
            (0.01, number("cm")),
            (0.001, number("mm")),
            (0.0254, number("in")),
        ],
    },
    Ordinary {
        field: "height_sd",
        low: 1e-5,
        high: 0.1,
        shown: |m| format!("a height uncertain by {m} m"),
        others: &[(0.01, number("cm")), (0.001, number("mm"))],
    },
    Ordinary {
        field: "temperature",
        low: 233.15,
        high: 333.15,
        shown: |kelvin| format!("a temperature of {:.1} \u{b0}C", kelvin - 273.15),
        // Handled by themselves: these scales do not begin at zero.
        others: &[],
    },
    Ordinary {
        field: "pressure",
        low: 3e4,
        high: 1.2e5,
        shown: |pascal| format!("an air pressure of {pascal} Pa"),
        others: &[
            (100.0, number("hPa")),
            (1000.0, number("kPa")),
            (0.01, Written(0.01, "Pa")),
            (10.0, Written(0.01, "kPa")),
        ],
    },
    Ordinary {
        field: "humidity",
        low: 0.0,
        high: 1.0,
        shown: |share| format!("a humidity of {} %", share * 100.0),
        others: &[(0.01, number("%"))],
    },
    Ordinary {
        field: "contact_time",
        low: 0.0,
        high: 0.05,
        shown: |s| format!("a contact of {s} s"),
        others: &[(1e-3, number("ms")), (1e-6, number("us"))],
    },
    Ordinary {
        field: "gravity",
        // From a small moon to the largest planet.
        low: 0.1,
        high: 30.0,
        shown: |g| format!("a gravity of {g} m/s2"),
        others: &[(0.01, number("cm/s2"))],
    },
    Ordinary {
        field: "altitude",
        low: -500.0,
        high: 9000.0,
        shown: |m| format!("an altitude of {m} m"),
        others: &[(0.3048, number("ft"))],
    },
    Ordinary {
        field: "air density",
        low: 0.0,
        high: 20.0,
        shown: |density| format!("an air density of {density} kg/m3"),
        others: &[(1e-3, number("g/m3"))],
    },
];

/// A inference, if a value is out of the ordinary.
pub(crate) fn of_quantity(field: &str, value: f64) -> Option<Doubt> {
    let ordinary = ORDINARY.iter().find(|ordinary| ordinary.field == field)?;
    let fits = |value: f64| (ordinary.low..=ordinary.high).contains(&value);
    if fits(value) {
        return None;
    }
    let other = ordinary
        .others
        .iter()
        .find(|(factor, _)| fits(value * factor));
    let meant = match other {
        Some((_, Written(factor, unit))) => {
            format!(" Did you mean {} {unit}?", significant(value * factor))
        }
        None if field == "temperature" => other_scale(value, fits),
        None => String::new(),
    };
    Some(Doubt(format!(
        "{}?{meant}",
        (ordinary.shown)(significant(value))
    )))
}

/// The same number of degrees Celsius on another scale, where that would be ordinary.
fn other_scale(kelvin: f64, fits: impl Fn(f64) -> bool) -> String {
    let degrees = kelvin - 273.15;
    let fahrenheit_k = (degrees - 32.0) / 1.8 + 273.15;
    let scales = [(degrees, "K"), (fahrenheit_k, "F")];
    let other = scales.into_iter().find(|&(kelvin, _)| fits(kelvin));
    other.map_or_else(String::new, |(_, scale)| {
        format!(" Did you mean {} {scale}?", significant(degrees))
    })
}

/// What to remark if the height that was stated is far from that from which the ball was heard to
/// fall, but would fit in another unit or with its point elsewhere.
///
/// The inference would rather believe that many impacts were missed at the beginning.
pub(crate) fn of_height(stated_m: f64, drop: &Drop) -> Option<String> {
    /// Slips of a unit or a decimal point.
    const SLIPS: [f64; 6] = [10.0, 100.0, 1000.0, 0.1, 0.01, 0.001];
    /// So far a rough height may be off.
    const ROUGH: f64 = 1.15;
    let heard_m = fall_heard_m(drop)?;
    let off = |height_m: f64| (height_m / heard_m).ln().abs();
    let meant_m = SLIPS
        .into_iter()
        .map(|slip| stated_m / slip)
        .find(|&meant_m| off(meant_m) < ROUGH.ln())?;
    let shown = |height_m: f64| Quantity::rounded(height_m, 4, Unit::Length);
    Some(format!(
        "the height is stated as {}, but the ball was heard to fall from about {}, as if {} was meant",
        shown(stated_m),
        Quantity::rounded(heard_m, 2, Unit::Length),
        shown(meant_m),
    ))
}

/// Roughly the height before the first impact heard: the first apex over what an impact keeps.
fn fall_heard_m(drop: &Drop) -> Option<f64> {
    let first = drop.corrected.as_ref().ok()?.flights.first()?;
    let kept = drop.corrected_restitution()?.value.powi(2);
    Some(first.flight.apex_m / kept)
}

/// A inference, if no ball is made of such stuff.
pub(crate) fn of_ball(ball: &Ball) -> Option<Doubt> {
    /// From a beach ball to tungsten, kg/m3.
    const DENSITIES: std::ops::RangeInclusive<f64> = 3.0..=20_000.0;
    let fits = |mass_kg: f64, diameter_m: f64| {
        let volume = Ball::new(1.0, diameter_m).map_or(f64::NAN, |ball| ball.volume_m3());
        DENSITIES.contains(&(mass_kg / volume))
    };
    let (mass, diameter) = (ball.mass_kg(), ball.diameter_m());
    if fits(mass, diameter) {
        return None;
    }
    let meant = if fits(mass * 1e-3, diameter) {
        format!(" Did you mean {} g?", significant(mass))
    } else if fits(mass, diameter * 1e-2) {
        format!(" Did you mean {} cm?", significant(diameter))
    } else if fits(mass, diameter * 1e-3) {
        format!(" Did you mean {} mm?", significant(diameter))
    } else if fits(mass * 1e-3, diameter * 1e-3) {
        format!(
            " Did you mean {} g and {} mm?",
            significant(mass),
            significant(diameter)
        )
    } else {
        String::new()
    };
    Some(Doubt(format!(
        "a ball of {} kg and {} m in diameter?{meant}",
        significant(mass),
        significant(diameter)
    )))
}

/// Without the noise of binary fractions.
fn significant(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinary_notes_raise_no_doubt() {
        for (field, value) in [
            ("height", 0.305),
            ("height", 2.54),
            ("temperature", 293.15),
            ("pressure", 101_325.0),
            ("humidity", 0.5),
            ("contact_time", 0.001),
            ("mass", 1e9),
        ] {
            assert_eq!(of_quantity(field, value), None, "{field} {value}");
        }
        for preset in bouncelab::ball::presets() {
            assert_eq!(of_ball(&preset.ball), None, "{}", preset.name);
        }
    }

    #[test]
    fn mistakes_of_units_are_questioned_with_a_guess() {
        let asked = |field: &str, value: f64| of_quantity(field, value).unwrap().0;
        assert!(asked("height", 30.5).contains("30.5 m? Did you mean 30.5 cm?"));
        assert!(
            asked("height", 305.0).contains("305 mm") || asked("height", 305.0).contains("305 cm")
        );
        assert!(asked("pressure", 1013.0).contains("1013 hPa"));
        assert!(asked("pressure", 10_132_500.0).contains("101325 Pa"));
        assert!(asked("pressure", 10_130.0).contains("101.3 kPa"));
        assert!(asked("humidity", 45.0).contains("45 %?"));
        assert!(asked("temperature", 566.3).contains("293.1 \u{b0}C? Did you mean 293.15 K?"));
        assert!(asked("temperature", 343.15).contains("70.0 \u{b0}C? Did you mean 70 F?"));
        assert!(asked("gravity", 981.0).contains("981 cm/s2"));
        let ball = |mass, diameter| of_ball(&Ball::new(mass, diameter).unwrap()).unwrap().0;
        assert!(ball(2.5, 0.038).contains("2.5 kg") && ball(2.5, 0.038).contains("2.5 g"));
        assert!(ball(0.0025, 38.0).contains("38 mm"));
    }
}
