//! Rounds numbers according to their uncertainty, and chooses the prefix of their unit.
//!
//! The rule for an uncertainty: one significant digit, or two when it begins with 1 or 2
//! (there one digit would change it by up to half); the value ends at the same place. So a
//! reader can take every printed digit seriously.

use std::fmt;

use bouncelab::Estimate;

use crate::digits::{superscript, with_minus};
use crate::messages::{Translator, Value};

/// What is shown in place of an unknown value.
pub const CANNOT_TELL: &str = "cannot tell";

/// Digits of a double-precision number that carry information.
const MAX_DIGITS: u8 = 12;

/// What a quantity is, and so its SI unit and the prefixes that suit it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Unit {
    /// A plain number.
    Number,
    /// A share of one, shown in per cent.
    Percent,
    /// Metres, shown as µm, mm, cm or m.
    Length,
    /// Seconds, shown as µs, ms or s.
    Time,
    /// Metres per second.
    Speed,
    /// Kilograms, shown as mg, g or kg.
    Mass,
    /// Joules, shown as µJ, mJ or J.
    Energy,
    /// Metres per second squared.
    Acceleration,
    /// Kilograms per cubic metre.
    Density,
}

impl Unit {
    /// The units to choose from: the size of each in SI, and its symbol, the smallest first.
    const fn steps(self) -> &'static [(f64, &'static str)] {
        match self {
            Self::Number => &[(1.0, "")],
            Self::Percent => &[(1e-2, "%")],
            Self::Length => &[(1e-6, "µm"), (1e-3, "mm"), (1e-2, "cm"), (1.0, "m")],
            Self::Time => &[(1e-6, "µs"), (1e-3, "ms"), (1.0, "s")],
            Self::Speed => &[(1.0, "m/s")],
            Self::Mass => &[(1e-6, "mg"), (1e-3, "g"), (1.0, "kg")],
            Self::Energy => &[(1e-6, "µJ"), (1e-3, "mJ"), (1.0, "J")],
            Self::Acceleration => &[(1.0, "m/s²")],
            Self::Density => &[(1.0, "kg/m³")],
        }
    }

    /// What the name of a column ends with, and the SI symbol of its unit.
    pub(crate) const fn in_columns(self) -> (&'static str, &'static str) {
        match self {
            Self::Number | Self::Percent => ("", ""),
            Self::Length => ("_m", "m"),
            Self::Time => ("_s", "s"),
            Self::Speed => ("_m_s", "m/s"),
            Self::Mass => ("_kg", "kg"),
            Self::Energy => ("_j", "J"),
            Self::Acceleration => ("_m_s2", "m/s2"),
            Self::Density => ("_kg_m3", "kg/m3"),
        }
    }

    /// The largest unit that is not larger than the quantity.
    pub(crate) fn step_for(self, size: f64) -> (f64, &'static str) {
        let steps = self.steps();
        let fitting = steps.iter().rev().find(|(step, _)| size >= *step);
        // Zero is shown in the largest, which is the SI unit itself.
        let otherwise = if size > 0.0 { 0 } else { steps.len() - 1 };
        *fitting.unwrap_or(&steps[otherwise])
    }
}

/// The precision of a value.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Precision {
    StandardError(f64),
    Digits(u8),
}

/// A value with its unit, displayed with as many digits as it deserves.
///
/// ```
/// use bouncelab_report::{Quantity, Unit};
///
/// let restitution = Quantity::measured(0.937_512, 0.001_23, Unit::Number);
/// assert_eq!(restitution.to_string(), "0.9375 ± 0.0012");
///
/// let height = Quantity::measured(0.3042, 0.0061, Unit::Length);
/// assert_eq!(height.to_string(), "30.4 ± 0.6 cm");
///
/// let contact = Quantity::rounded(0.000_812, 2, Unit::Time);
/// assert_eq!(contact.to_string(), "810 µs");
///
/// let unknown = Quantity::measured(f64::NAN, 0.1, Unit::Length);
/// assert_eq!(unknown.to_string(), "cannot tell");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    value: f64,
    precision: Precision,
    unit: Unit,
}

impl Quantity {
    /// A value with its standard error, both in SI units (a share of one for
    /// [`Unit::Percent`]).
    ///
    /// A standard error of zero, or one below the twelfth digit of the value, is shown as
    /// none. If the value or the standard error is not a finite number, or the standard
    /// error is negative, the display is [`CANNOT_TELL`].
    pub const fn measured(value: f64, standard_error: f64, unit: Unit) -> Self {
        Self {
            value,
            precision: Precision::StandardError(standard_error),
            unit,
        }
    }

    /// An estimate: with its standard uncertainty, or with four digits if it has none or is exact.
    ///
    /// ```
    /// use bouncelab::Estimate;
    /// use bouncelab_report::{Quantity, Unit};
    ///
    /// let height = Quantity::of(&Estimate::normal(0.3042, 0.0061), Unit::Length);
    /// assert_eq!(height.to_string(), "30.4 ± 0.6 cm");
    /// let exact = Quantity::of(&Estimate::normal(1.0 / 3.0, 0.0), Unit::Number);
    /// assert_eq!(exact.to_string(), "0.3333");
    /// ```
    pub fn of(estimate: &Estimate, unit: Unit) -> Self {
        match estimate.known_sd() {
            Some(sd) if sd != 0.0 => Self::measured(estimate.value, sd, unit),
            _ => Self::rounded(estimate.value, 4, unit),
        }
    }

    /// A value in SI units, rounded to a number of significant digits, 1 to 12.
    pub const fn rounded(value: f64, significant_digits: u8, unit: Unit) -> Self {
        Self {
            value,
            precision: Precision::Digits(significant_digits),
            unit,
        }
    }

    /// An interval in the unit and with the digits of this quantity: `"29.8 to 31.0 cm"`.
    ///
    /// ```
    /// use bouncelab_report::{Quantity, Unit};
    ///
    /// let height = Quantity::measured(0.3042, 0.0061, Unit::Length);
    /// assert_eq!(height.interval([0.2981, 0.3103]), "29.8 to 31.0 cm");
    /// ```
    pub fn interval(&self, interval: [f64; 2]) -> String {
        let (low, high, symbol) = self.ends(interval);
        format!("{low} to {high}{symbol}")
    }

    /// An interval as a language writes it: `"29,8 bis 31,0 cm"`.
    pub fn interval_text(&self, interval: [f64; 2], translator: &Translator) -> String {
        let (low, high, symbol) = self.ends(interval);
        let ends = [("low", Value::Number(low)), ("high", Value::Number(high))];
        translator.text_with("interval-ends", &ends) + &symbol
    }

    /// Both ends of an interval, and the symbol of the unit with a space before it.
    fn ends(&self, [low, high]: [f64; 2]) -> (String, String, String) {
        let (error, digits) = match self.precision {
            Precision::StandardError(error) => (error, 4),
            Precision::Digits(digits) => (0.0, digits),
        };
        let (step, symbol) = self.unit.step_for(self.value.abs().max(error));
        let end = |value: f64| {
            let (value, error) = (value / step, error / step);
            if !value.is_finite() || !error.is_finite() {
                CANNOT_TELL.to_owned()
            } else if is_visible(error, value) && is_plain(leading_place(value.abs().max(error))) {
                at_place(value, error_place(error))
            } else {
                with_digits(value, digits)
            }
        };
        let space = if symbol.is_empty() { "" } else { " " };
        (end(low), end(high), format!("{space}{symbol}"))
    }

    /// The value as a language writes it: `"30,4 ± 0,6 cm"`.
    pub fn text(&self, translator: &Translator) -> String {
        match self.parts() {
            (number, _) if number == CANNOT_TELL => translator.text("unit-cannot-tell"),
            (number, "") => translator.number(&number),
            (number, symbol) => format!("{} {symbol}", translator.number(&number)),
        }
    }

    /// The number and the symbol of its unit apart: `("30.4 ± 0.6", "cm")`. The symbol is
    /// empty for a plain number and for an unknown value.
    pub fn parts(&self) -> (String, &'static str) {
        let (value, error) = match self.precision {
            Precision::StandardError(error) => (self.value, error),
            Precision::Digits(_) => (self.value, 0.0),
        };
        let (step, symbol) = self.unit.step_for(value.abs().max(error));
        let (value, error) = (value / step, error / step);
        if !value.is_finite() || !error.is_finite() || error < 0.0 {
            return (CANNOT_TELL.to_owned(), "");
        }
        let number = match self.precision {
            Precision::Digits(digits) => with_digits(value, digits),
            Precision::StandardError(_) if is_visible(error, value) => with_error(value, error),
            Precision::StandardError(_) => exact(value),
        };
        (number, symbol)
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (number, symbol) = self.parts();
        if symbol.is_empty() {
            f.pad(&number)
        } else {
            f.pad(&format!("{number} {symbol}"))
        }
    }
}

/// The value at the place of its rounded error; both as multiples of a power of ten when they
/// would otherwise need many zeros.
fn with_error(value: f64, error: f64) -> String {
    let place = error_place(error);
    let power = leading_place(value.abs().max(error));
    if is_plain(power) {
        return format!("{} ± {}", at_place(value, place), at_place(error, place));
    }
    let (value, error) = (shifted(value, power), shifted(error, power));
    let place = place - power;
    let raised = superscript(power);
    format!(
        "({} ± {})×10{raised}",
        at_place(value, place),
        at_place(error, place)
    )
}

/// The value with a number of significant digits.
fn with_digits(value: f64, digits: u8) -> String {
    let decimals = digits.clamp(1, MAX_DIGITS) - 1;
    let rounded = format!("{value:.*e}", usize::from(decimals));
    let (mantissa, power) = split(&rounded);
    if is_plain(power) {
        at_place(value, power - i32::from(decimals))
    } else {
        with_power(mantissa, power)
    }
}

/// The value with the digits it has, up to the last that means something.
fn exact(value: f64) -> String {
    let decimals = usize::from(MAX_DIGITS - 1);
    let rounded: f64 = format!("{value:.decimals$e}").parse().unwrap_or(value);
    let shortest = format!("{rounded:e}");
    let (mantissa, power) = split(&shortest);
    if is_plain(power) {
        with_minus(&rounded.to_string())
    } else {
        with_power(mantissa, power)
    }
}

/// Whether an error reaches the digits of the value that mean something.
fn is_visible(error: f64, value: f64) -> bool {
    let last = leading_place(value) - i32::from(MAX_DIGITS);
    error > 0.0 && (value == 0.0 || error_place(error) > last)
}

/// The decimal place (a power of ten) to which an error above zero is rounded.
fn error_place(error: f64) -> i32 {
    let decimal = format!("{error:e}");
    let place = split(&decimal).1;
    if decimal.starts_with(['1', '2']) {
        place - 1
    } else {
        place
    }
}

/// The power of ten of the first significant digit; 0 for zero. From the decimal form, not
/// from the logarithm, which can be off by one at powers of ten.
fn leading_place(value: f64) -> i32 {
    split(&format!("{value:e}")).1
}

/// `"-1.5e-7"` as `("-1.5", -7)`.
fn split(scientific: &str) -> (&str, i32) {
    let (mantissa, power) = scientific.split_once('e').unwrap_or((scientific, "0"));
    (mantissa, power.parse().unwrap_or(0))
}

/// The value divided by a power of ten, however large or small both are.
fn shifted(value: f64, power: i32) -> f64 {
    let decimal = format!("{value:e}");
    let (mantissa, own) = split(&decimal);
    format!("{mantissa}e{}", own - power)
        .parse()
        .unwrap_or(value)
}

/// Whether a number whose first digit is at this power of ten is written out.
fn is_plain(power: i32) -> bool {
    (-5..=8).contains(&power)
}

fn with_power(mantissa: &str, power: i32) -> String {
    format!("{}×10{}", with_minus(mantissa), superscript(power))
}

/// The value with digits down to a decimal place. Minus zero becomes zero.
fn at_place(value: f64, place: i32) -> String {
    let number = if place < 0 {
        format!("{value:.*}", place.unsigned_abs() as usize)
    } else {
        let unit = 10_f64.powi(place);
        format!("{:.0}", (value / unit).round() * unit)
    };
    with_minus(&number)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn measured(value: f64, error: f64, unit: Unit) -> String {
        Quantity::measured(value, error, unit).to_string()
    }

    fn rounded(value: f64, digits: u8, unit: Unit) -> String {
        Quantity::rounded(value, digits, unit).to_string()
    }

    /// Worked by hand with the rule in the head of this file; the page passes the same table.
    #[test]
    fn the_table_of_cases() {
        #[derive(serde::Deserialize)]
        struct Case {
            value: f64,
            sd: Option<f64>,
            digits: Option<u8>,
            unit: String,
            text: String,
        }
        let cases: Vec<Case> =
            serde_json::from_str(include_str!("../tests/quantity.json")).unwrap();
        for case in cases {
            let unit = match case.unit.as_str() {
                "number" => Unit::Number,
                "percent" => Unit::Percent,
                "length" => Unit::Length,
                "time" => Unit::Time,
                "speed" => Unit::Speed,
                other => panic!("no case has the unit {other}"),
            };
            let estimate = Estimate::normal(case.value, case.sd.unwrap_or(f64::INFINITY));
            let quantity = match case.digits {
                Some(digits) => Quantity::rounded(case.value, digits, unit),
                None => Quantity::of(&estimate, unit),
            };
            assert_eq!(quantity.to_string(), case.text);
        }
    }

    #[test]
    fn the_prefix_suits_the_size() {
        for (value, error, unit, text) in [
            (0.00734, 0.0001, Unit::Energy, "7.34 ± 0.10 mJ"),
            (0.0025, 0.000_005, Unit::Mass, "2.500 ± 0.005 g"),
        ] {
            assert_eq!(measured(value, error, unit), text);
        }
    }

    #[test]
    fn what_is_not_known_is_said_to_be_unknown() {
        for (value, error) in [
            (f64::NAN, 0.1),
            (f64::INFINITY, 0.1),
            (0.9, f64::NAN),
            (0.9, f64::INFINITY),
            (0.9, -0.1),
        ] {
            assert_eq!(measured(value, error, Unit::Length), CANNOT_TELL);
        }
        assert_eq!(rounded(f64::NAN, 3, Unit::Time), CANNOT_TELL);
    }

    #[test]
    fn an_error_of_zero_or_below_the_digits_of_the_number_is_not_shown() {
        assert_eq!(measured(0.3, 0.0, Unit::Length), "30 cm");
        assert_eq!(measured(0.3, 1e-18, Unit::Length), "30 cm");
        assert_eq!(measured(1.0 / 3.0, 0.0, Unit::Number), "0.333333333333");
        assert_eq!(measured(0.0, 0.0, Unit::Number), "0");
    }

    #[test]
    fn the_width_of_the_format_is_kept() {
        let number = Quantity::rounded(0.94, 2, Unit::Number);
        assert_eq!(format!("[{number:>6}]"), "[  0.94]");
    }

    proptest! {
        /// Read back, the printed numbers are the given ones to half of their last place, and
        /// the printed error is within a sixth of the given one (0.35 printed as 0.3 or 0.4).
        #[test]
        fn what_is_printed_can_be_read_back(value in -1e7..1e7_f64, exponent in -4..6_i32, digits in 1.0..9.99_f64) {
            let error = digits * 10_f64.powi(exponent);
            let text = measured(value, error, Unit::Number).replace('−', "-");
            let (read, read_error) = text.split_once(" ± ").unwrap();
            let (read, read_error): (f64, f64) = (read.parse().unwrap(), read_error.parse().unwrap());
            prop_assert!((read_error / error - 1.0).abs() <= 1.0 / 6.0 + 1e-9, "{text}");
            prop_assert!((read - value).abs() <= 0.5 * error + 1e-9, "{text}");
        }

        /// No number of any size makes it panic or become long.
        #[test]
        fn every_number_has_a_short_text(value: f64, error: f64, digits: u8) {
            for unit in [Unit::Number, Unit::Percent, Unit::Length, Unit::Energy] {
                for text in [measured(value, error, unit), rounded(value, digits, unit)] {
                    prop_assert!(text.chars().count() <= 48, "{text}");
                    prop_assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
                }
            }
        }
    }
}
