//! Notes that look like a mistake of units.

use bouncelab::ball::Ball;

/// What is ordinary of a quantity, and what another unit would make of it.
struct Ordinary {
    field: &'static str,
    low: f64,
    high: f64,
    /// Shows a value.
    shown: fn(f64) -> String,
    /// Other readings of the same number: factor and how it would be written.
    others: &'static [(f64, &'static str)],
}

const ORDINARY: [Ordinary; 6] = [
    Ordinary {
        field: "height",
        low: 0.01,
        high: 10.0,
        shown: |m| format!("a drop height of {m} m"),
        others: &[(0.01, "cm"), (0.001, "mm"), (0.0254, "in")],
    },
    Ordinary {
        field: "height_sd",
        low: 1e-5,
        high: 0.1,
        shown: |m| format!("a height uncertain by {m} m"),
        others: &[(0.01, "cm"), (0.001, "mm")],
    },
    Ordinary {
        field: "temperature",
        low: 233.15,
        high: 333.15,
        shown: |kelvin| format!("a temperature of {:.1} \u{b0}C", kelvin - 273.15),
        others: &[],
    },
    Ordinary {
        field: "pressure",
        low: 3e4,
        high: 1.2e5,
        shown: |pascal| format!("an air pressure of {pascal} Pa"),
        others: &[(100.0, "hPa"), (1000.0, "kPa")],
    },
    Ordinary {
        field: "humidity",
        low: 0.0,
        high: 1.0,
        shown: |share| format!("a humidity of {} %", share * 100.0),
        others: &[(0.01, "%")],
    },
    Ordinary {
        field: "contact_time",
        low: 0.0,
        high: 0.05,
        shown: |s| format!("a contact of {s} s"),
        others: &[(1e-3, "ms"), (1e-6, "us")],
    },
];

/// A question, if a value is out of the ordinary.
pub(super) fn of_quantity(field: &str, value: f64) -> Option<String> {
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
        Some((_, unit)) => format!(" Did you mean {} {unit}?", significant(value)),
        None => String::new(),
    };
    Some(format!(
        "{}?{meant} Correct it, or insist by --as-noted",
        (ordinary.shown)(value)
    ))
}

/// A question, if no ball is made of such stuff.
pub(super) fn of_ball(ball: &Ball) -> Option<String> {
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
    Some(format!(
        "a ball of {} kg and {} m in diameter?{meant} Correct it, or insist by --as-noted",
        significant(mass),
        significant(diameter)
    ))
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
        let asked = |field: &str, value: f64| of_quantity(field, value).unwrap();
        assert!(asked("height", 30.5).contains("30.5 m? Did you mean 30.5 cm?"));
        assert!(
            asked("height", 305.0).contains("305 mm") || asked("height", 305.0).contains("305 cm")
        );
        assert!(asked("pressure", 1013.0).contains("1013 hPa"));
        assert!(asked("humidity", 45.0).contains("45 %?"));
        assert!(asked("temperature", 566.3).contains("293.1"));
        let ball = |mass, diameter| of_ball(&Ball::new(mass, diameter).unwrap()).unwrap();
        assert!(ball(2.5, 0.038).contains("2.5 kg") && ball(2.5, 0.038).contains("2.5 g"));
        assert!(ball(0.0025, 38.0).contains("38 mm"));
    }
}
