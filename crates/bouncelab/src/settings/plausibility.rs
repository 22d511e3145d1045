//! Finds given values that look like wrong units.
//!
//! A value outside the ordinary range is questioned by a [`Diagnostic`] before anything is computed from it.
//!
//! ```
//! use bouncelab::diagnostic::Argument;
//! use bouncelab::settings::plausibility;
//!
//! let question = plausibility::of_quantity("height", 30.5).unwrap();
//! assert_eq!(question.number("meant"), Some(30.5));
//! assert_eq!(question.arguments["meant_unit"], Argument::from("cm"));
//! assert!(plausibility::of_quantity("height", 0.305).is_none());
//! ```

use std::ops::RangeInclusive;

use super::{Settings, air, ball, drop, gravity, inference};
use crate::ball::Ball;
use crate::diagnostic::{Code, Diagnostic};

/// How a value is shown: `factor * value + offset` in this unit.
pub(super) struct Shown {
    pub(super) factor: f64,
    pub(super) offset: f64,
    pub(super) unit: &'static str,
}

/// The value as it is, in its SI unit.
pub(super) const fn shown(unit: &'static str) -> Shown {
    Shown {
        factor: 1.0,
        offset: 0.0,
        unit,
    }
}

/// Another reading of a value: the factor that another unit makes of it, and how it would be written.
pub(super) struct Reading {
    pub(super) factor: f64,
    pub(super) written: f64,
    pub(super) unit: &'static str,
}

/// The same number in another unit.
pub(super) const fn reading(factor: f64, unit: &'static str) -> Reading {
    Reading {
        factor,
        written: 1.0,
        unit,
    }
}

/// The ordinary range of a setting, and what another unit would make of it.
pub(super) struct Ordinary {
    pub(super) quantity: &'static str,
    pub(super) given: fn(&Settings) -> Option<f64>,
    pub(super) range: RangeInclusive<f64>,
    pub(super) shown: Shown,
    pub(super) readings: &'static [Reading],
}

/// All of them: each stands with its setting.
fn ordinary() -> impl Iterator<Item = &'static Ordinary> {
    [
        ball::ORDINARY,
        air::ORDINARY,
        gravity::ORDINARY,
        drop::ORDINARY,
        inference::ORDINARY,
    ]
    .into_iter()
    .flatten()
}

/// A question for each setting that another unit would explain better.
pub(super) fn of_settings(settings: &Settings) -> Vec<Diagnostic> {
    let quantities = ordinary().filter_map(|it| it.question((it.given)(settings)?));
    // A ball that there cannot be is refused later, by `Settings::resolve`.
    let ball = settings.ball.known().ok();
    let ball = ball.and_then(|(_, known)| of_ball(&known.ball));
    quantities.chain(ball).collect()
}

/// A question, if a value in SI units is out of the ordinary. Quantities are `height`, `height-sd`,
/// `temperature`, `pressure`, `humidity`, `contact-time`, `gravity`, `altitude`, `air-density`, `impact-speed` and
/// `apex`; of any other nothing is asked.
///
/// ```
/// use bouncelab::settings::plausibility::of_quantity;
///
/// assert_eq!(of_quantity("height", 0.305), None);
/// // The height was in centimetres.
/// let question = of_quantity("height", 30.5).unwrap();
/// assert_eq!(question.number("meant"), Some(30.5));
/// ```
pub fn of_quantity(quantity: &str, value: f64) -> Option<Diagnostic> {
    ordinary()
        .find(|known| known.quantity == quantity)?
        .question(value)
}

impl Ordinary {
    fn question(&self, value: f64) -> Option<Diagnostic> {
        let fits = |value: f64| self.range.contains(&value);
        if fits(value) {
            return None;
        }
        let Shown {
            factor,
            offset,
            unit,
        } = self.shown;
        let question = Diagnostic::new(Code::ImplausibleQuantity)
            .with("quantity", self.quantity)
            .with("value", significant(factor * value + offset))
            .with("unit", unit);
        let mut readings = self.readings.iter();
        let meant = match readings.find(|reading| fits(value * reading.factor)) {
            Some(reading) => Some((value * reading.written, reading.unit)),
            None if self.quantity == "temperature" => other_scale(value, fits),
            None => None,
        };
        Some(match meant {
            Some((meant, unit)) => question
                .with("meant", significant(meant))
                .with("meant_unit", unit),
            None => question,
        })
    }
}

/// The same number of degrees Celsius on another scale, where that would be ordinary.
fn other_scale(kelvin: f64, fits: impl Fn(f64) -> bool) -> Option<(f64, &'static str)> {
    let degrees = kelvin - 273.15;
    let fahrenheit_k = (degrees - 32.0) / 1.8 + 273.15;
    let scales = [(degrees, "K"), (fahrenheit_k, "F")];
    let other = scales.into_iter().find(|&(kelvin, _)| fits(kelvin));
    other.map(|(_, scale)| (degrees, scale))
}

/// The diameter of a ball: from the smallest bearing balls to a gymnastics ball.
const DIAMETER: Ordinary = Ordinary {
    quantity: "ball-diameter",
    given: |_| None,
    range: 5e-4..=1.0,
    shown: shown("m"),
    readings: &[
        reading(0.001, "mm"),
        reading(0.01, "cm"),
        reading(0.0254, "in"),
    ],
};

/// A question, if no ball has this mass and diameter.
///
/// ```
/// use bouncelab::ball::Ball;
/// use bouncelab::settings::plausibility::of_ball;
///
/// assert_eq!(of_ball(&Ball::new(2.5e-3, 0.038)?), None);
/// // The mass was in grams.
/// assert!(of_ball(&Ball::new(2.5, 0.038)?).is_some());
/// // A steel ball of 10 m.
/// assert!(of_ball(&Ball::new(4.09e6, 10.0)?).is_some());
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn of_ball(ball: &Ball) -> Option<Diagnostic> {
    /// From a beach ball to tungsten, kg/m3.
    const DENSITIES: RangeInclusive<f64> = 3.0..=20_000.0;
    let fits = |mass_kg: f64, diameter_m: f64| {
        let volume = Ball::new(1.0, diameter_m).map_or(f64::NAN, |ball| ball.volume_m3());
        DENSITIES.contains(&(mass_kg / volume))
    };
    let (mass, diameter) = (ball.mass_kg(), ball.diameter_m());
    if fits(mass, diameter) {
        return DIAMETER.question(diameter);
    }
    let question = Diagnostic::new(Code::ImplausibleBall)
        .with("mass_kg", significant(mass))
        .with("diameter_m", significant(diameter));
    let grams = |question: Diagnostic| question.with("meant_g", significant(mass));
    let other = |question: Diagnostic, name| question.with(name, significant(diameter));
    Some(if fits(mass * 1e-3, diameter) {
        grams(question)
    } else if fits(mass, diameter * 1e-2) {
        other(question, "meant_cm")
    } else if fits(mass, diameter * 1e-3) {
        other(question, "meant_mm")
    } else if fits(mass * 1e-3, diameter * 1e-3) {
        other(grams(question), "meant_mm")
    } else {
        question
    })
}

/// Without the noise of binary fractions.
fn significant(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ball;
    use crate::diagnostic::Argument;

    #[test]
    fn ordinary_values_raise_no_question() {
        for (quantity, value) in [
            ("height", 0.305),
            ("height", 2.54),
            ("temperature", 293.15),
            ("pressure", 101_325.0),
            ("humidity", 0.5),
            ("contact-time", 0.001),
            ("impact-speed", 2.4),
            ("apex", 0.28),
            ("mass", 1e9),
        ] {
            assert_eq!(of_quantity(quantity, value), None, "{quantity} {value}");
        }
        for preset in ball::presets() {
            assert_eq!(of_ball(&preset.known.ball), None, "{}", preset.name);
        }
    }

    #[test]
    fn mistakes_of_units_are_questioned_with_a_guess() {
        for (quantity, value, meant, unit) in [
            ("height", 30.5, 30.5, "cm"),
            ("height", 305.0, 305.0, "cm"),
            ("pressure", 1013.0, 1013.0, "hPa"),
            ("pressure", 10_132_500.0, 101_325.0, "Pa"),
            ("pressure", 10_130.0, 101.3, "kPa"),
            ("humidity", 45.0, 45.0, "%"),
            ("temperature", 566.3, 293.15, "K"),
            ("temperature", 343.15, 70.0, "F"),
            ("gravity", 981.0, 981.0, "cm/s2"),
            ("impact-speed", 240.0, 240.0, "cm/s"),
            ("apex", 28.0, 28.0, "cm"),
        ] {
            let question = of_quantity(quantity, value).unwrap();
            assert_eq!(question.number("meant"), Some(meant), "{quantity} {value}");
            let expected = Some(&Argument::from(unit));
            assert_eq!(question.arguments.get("meant_unit"), expected, "{quantity}");
        }
        let ball = |mass, diameter| of_ball(&Ball::new(mass, diameter).unwrap()).unwrap();
        assert_eq!(ball(2.5, 0.038).number("meant_g"), Some(2.5));
        assert_eq!(ball(0.0025, 38.0).number("meant_mm"), Some(38.0));
    }

    /// As stated, not as resolved: the ball is questioned by what its kind and its numbers make together.
    #[test]
    fn absurd_settings_are_questioned() {
        let of = |change: fn(&mut Settings)| {
            let mut settings = Settings::default();
            change(&mut settings);
            let questions = settings.questions();
            assert_eq!(questions.len(), 1, "{questions:?}");
            questions[0].clone()
        };
        assert!(Settings::of_ball("steel:0.01").questions().is_empty());
        let steel = Settings::of_ball("steel:10").questions();
        assert_eq!(steel[0].number("meant"), Some(10.0));
        assert_eq!(steel[0].arguments["meant_unit"], Argument::from("mm"));
        let tennis = of(|settings| {
            settings.ball.kind = Some("tennis".to_owned());
            settings.ball.mass_kg = Some(58.0);
        });
        assert_eq!(tennis.number("meant_g"), Some(58.0));
        let fast = of(|settings| settings.inference.at_speed_m_s = Some(1e6));
        assert_eq!(fast.arguments["quantity"], Argument::from("impact-speed"));
        assert_eq!(fast.number("meant"), None);
    }
}
