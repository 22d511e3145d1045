//! Reads quantities with units: `30.5cm`, `2.7 g`, `1013 hPa`, `-5C`.
//!
//! A number without a unit is in SI. In arguments, files and forms alike; errors
//! are sentences that can be shown as they are.
//!
//! ```
//! use bouncelab_report::units;
//!
//! assert_eq!(units::length("10 in"), Ok(0.254));
//! assert!(units::length("3 kg").unwrap_err().contains("cm"));
//! ```

/// The units of one quantity: name and factor to SI.
type Units = &'static [(&'static str, f64)];

const LENGTHS: Units = &[
    ("m", 1.0),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("\u{b5}m", 1e-6),
    ("km", 1e3),
    ("in", 0.0254),
    ("ft", 0.3048),
];
const MASSES: Units = &[
    ("kg", 1.0),
    ("g", 1e-3),
    ("mg", 1e-6),
    ("oz", 0.028_349_523_125),
    ("lb", 0.453_592_37),
];
const TIMES: Units = &[
    ("s", 1.0),
    ("ms", 1e-3),
    ("us", 1e-6),
    ("\u{b5}s", 1e-6),
    ("min", 60.0),
];
const SPEEDS: Units = &[
    ("m/s", 1.0),
    ("cm/s", 1e-2),
    ("km/h", 1.0 / 3.6),
    ("mph", 0.447_04),
];
const PRESSURES: Units = &[
    ("Pa", 1.0),
    ("hPa", 100.0),
    ("mbar", 100.0),
    ("kPa", 1e3),
    ("bar", 1e5),
    ("mmHg", 133.322),
    ("atm", 101_325.0),
];
const ACCELERATIONS: Units = &[("m/s2", 1.0), ("m/s^2", 1.0), ("gal", 0.01)];
const DENSITIES: Units = &[
    ("kg/m3", 1.0),
    ("kg/m^3", 1.0),
    ("g/l", 1.0),
    ("g/cm3", 1e3),
];
const VISCOSITIES: Units = &[("Pa.s", 1.0), ("Pas", 1.0), ("uPa.s", 1e-6)];
const SHARES: Units = &[("", 1.0), ("%", 0.01)];
const ANGLES: Units = &[("deg", 1.0), ("\u{b0}", 1.0), ("N", 1.0), ("S", -1.0)];

/// A length in metres.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn length(text: &str) -> Result<f64, String> {
    quantity(text, LENGTHS)
}

/// A ball as settings have it: a name, or what it is made of with the diameter in metres. `steel:10mm` is
/// `steel:0.01`.
///
/// # Errors
/// What is wrong with the diameter, and what would be right.
pub fn ball(text: &str) -> Result<String, String> {
    Ok(match text.split_once(':') {
        Some((material, diameter)) => format!("{material}:{}", length(diameter)?),
        None => text.to_owned(),
    })
}

/// A mass in kilograms.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn mass(text: &str) -> Result<f64, String> {
    quantity(text, MASSES)
}

/// A time in seconds.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn time(text: &str) -> Result<f64, String> {
    quantity(text, TIMES)
}

/// A speed in metres per second.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn speed(text: &str) -> Result<f64, String> {
    quantity(text, SPEEDS)
}

/// A pressure in pascal.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn pressure(text: &str) -> Result<f64, String> {
    quantity(text, PRESSURES)
}

/// An acceleration in metres per second squared.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn acceleration(text: &str) -> Result<f64, String> {
    quantity(text, ACCELERATIONS)
}

/// A density in kilograms per cubic metre.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn density(text: &str) -> Result<f64, String> {
    quantity(text, DENSITIES)
}

/// A dynamic viscosity in pascal seconds.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn viscosity(text: &str) -> Result<f64, String> {
    quantity(text, VISCOSITIES)
}

/// A share of one: `0.5` or `50%`.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn share(text: &str) -> Result<f64, String> {
    quantity(text, SHARES)
}

/// A latitude in degrees, north positive: `47.5`, `33.9S`.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn latitude(text: &str) -> Result<f64, String> {
    quantity(text, ANGLES)
}

/// A temperature in kelvin, from degrees Celsius unless it has the unit `K` or `F`.
///
/// This is the one quantity whose bare number is not SI: 20 does not mean 20 K.
///
/// # Errors
/// What is wrong with the text, and what would be right.
pub fn temperature(text: &str) -> Result<f64, String> {
    let (number, unit) = split(text)?;
    let kelvin = match unit {
        "" | "C" | "\u{b0}C" => number + 273.15,
        "K" => number,
        "F" | "\u{b0}F" => (number - 32.0) / 1.8 + 273.15,
        _ => {
            return Err(format!(
                "no temperature is measured in \"{unit}\"; use C, K or F, as in 20C"
            ));
        }
    };
    finite(kelvin, text)
}

fn quantity(text: &str, units: Units) -> Result<f64, String> {
    let (number, unit) = split(text)?;
    if unit.is_empty() {
        return finite(number, text);
    }
    let Some((_, factor)) = units.iter().find(|(name, _)| *name == unit) else {
        let known: Vec<&str> = units
            .iter()
            .map(|(name, _)| *name)
            .filter(|name| !name.is_empty())
            .collect();
        return Err(format!(
            "\"{unit}\" is not a unit for this; use one of {}",
            known.join(", ")
        ));
    };
    finite(number * factor, text)
}

/// The value in SI, unless it is beyond all numbers.
fn finite(value: f64, text: &str) -> Result<f64, String> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(format!("{} is too large a number", text.trim()))
    }
}

/// A number and what follows it.
fn split(text: &str) -> Result<(f64, &str), String> {
    let text = text.trim();
    let goes_on = |next: char| next.is_ascii_digit() || matches!(next, '+' | '-');
    let is_number = |(index, c): (usize, char)| {
        c.is_ascii_digit()
            || matches!(c, '.' | '+' | '-')
            // An exponent is part of the number if a digit or sign follows it.
            || (matches!(c, 'e' | 'E') && text[index + 1..].starts_with(goes_on))
    };
    let end = text
        .char_indices()
        .find(|&at| !is_number(at))
        .map_or(text.len(), |(index, _)| index);
    let (number, unit) = text.split_at(end);
    if number.is_empty() && text.contains(',') {
        return Err("write the decimal point as a point, as in 30.5cm".to_owned());
    }
    let value: f64 = number
        .parse()
        .map_err(|_| format!("\"{text}\" does not begin with a number; write it as in 30.5cm"))?;
    if unit.starts_with(',') {
        return Err("write the decimal point as a point, as in 30.5cm".to_owned());
    }
    Ok((value, unit.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn close(result: Result<f64, String>, expected: f64) {
        let value = result.unwrap();
        assert!(
            (value - expected).abs() <= 1e-12 * expected.abs(),
            "{value} is not {expected}"
        );
    }

    #[test]
    fn units_are_read_with_and_without_a_space() {
        close(length("30.5cm"), 0.305);
        close(length("30.5 cm"), 0.305);
        close(length("12 in"), 0.3048);
        close(mass("2.7g"), 0.0027);
        close(time("1e-3 s"), 0.001);
        close(length("1.5e+2 \u{b5}m"), 1.5e-4);
        close(pressure("1013.25hPa"), 101_325.0);
        close(share("50%"), 0.5);
        close(latitude("33.9S"), -33.9);
    }

    #[test]
    fn a_bare_number_is_in_si_but_for_temperatures() {
        close(length("0.305"), 0.305);
        close(temperature("20"), 293.15);
        close(temperature("293.15K"), 293.15);
        close(temperature("68F"), 293.15);
        close(temperature("-5C"), 268.15);
    }

    #[test]
    fn a_wrong_unit_names_the_right_ones() {
        assert!(length("3kg").unwrap_err().contains("cm"));
        assert!(length("abc").unwrap_err().contains("30.5cm"));
        assert!(length("30,5cm").unwrap_err().contains("point"));
        assert!(temperature("20X").unwrap_err().contains("20C"));
    }

    #[test]
    fn no_number_is_infinite_with_its_unit_or_without() {
        for text in ["1e999", "1e999m", "1e308km"] {
            assert!(length(text).unwrap_err().contains("too large"), "{text}");
        }
        assert!(temperature("1e999F").unwrap_err().contains("too large"));
    }
}
