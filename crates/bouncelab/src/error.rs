//! What can go wrong in the science.

use std::ops::Range;

/// The result of a calculation that can refuse its input.
pub type Result<T> = std::result::Result<T, Error>;

/// Why a calculation was refused.
///
/// Every message says what was wrong and what to do about it, so it can be shown to a person as it
/// is. The enum grows with the rooms of the crate.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A number lies outside the values for which the calculation makes sense (this includes NaN).
    #[error("{quantity} is {}; it must be {allowed}", written(*value))]
    OutOfRange {
        /// The quantity with its unit, as in "mass in kg".
        quantity: &'static str,
        /// The value that was given.
        value: f64,
        /// The values that are accepted, in words.
        allowed: &'static str,
    },

    /// A name that is not in one of the crate's lists.
    #[error("no {kind} is called \"{name}\"; the nearest is \"{nearest}\" (known: {known})")]
    UnknownName {
        /// What was looked up: "ball", "drag law".
        kind: &'static str,
        /// The name that was given.
        name: String,
        /// The known name most like it.
        nearest: String,
        /// All known names, separated by commas.
        known: String,
    },

    /// The ball is faster than the chosen drag law knows.
    #[error(
        "the drag law {law} is known up to Reynolds number {max_reynolds:.3e}, but the ball reaches \
         {reynolds:.3e}; choose a law with a wider range (clift-grace-weber has no upper end) or a \
         slower ball"
    )]
    ReynoldsTooHigh {
        /// Name of the law.
        law: &'static str,
        /// The Reynolds number that was asked for.
        reynolds: f64,
        /// The upper end of the law.
        max_reynolds: f64,
    },

    /// The air that the ball displaces weighs as much as the ball, so it never comes down.
    #[error(
        "the ball weighs {mass_kg} kg and displaces {displaced_kg} kg of air, so it floats; check \
         mass and diameter, or switch buoyancy off"
    )]
    Floats {
        /// Mass of the ball.
        mass_kg: f64,
        /// Mass of the air it displaces.
        displaced_kg: f64,
    },

    /// A drop that would go on for more bounces than anyone can use.
    #[error(
        "the ball still rises {apex_m:.3e} m after {bounces} bounces; lower the restitution, stop at \
         a greater height, or ask for at most {bounces} bounces"
    )]
    EndlessDrop {
        /// How many bounces were simulated before giving up.
        bounces: usize,
        /// The height it still reaches.
        apex_m: f64,
    },

    /// A straight line needs two points.
    #[error(
        "a straight line through log flight time needs at least 2 flights, but there are {flights}; \
         use a recording with at least 3 impacts, or a wider range of flights"
    )]
    TooFewFlights {
        /// How many flights were given.
        flights: usize,
    },

    /// A mean of no drops, or more means than drops can tell.
    #[error("this takes {needed} drops or more, and there are {drops}")]
    TooFewDrops {
        /// How many it takes.
        needed: usize,
        /// How many there are.
        drops: usize,
    },

    /// No frequency band that a detector watches lies in this range.
    #[error(
        "no band lies {range} Hz, at least by half; at this sample rate the bands are {bands} Hz"
    )]
    NoBand {
        /// The range, as in "between 400 and 500".
        range: String,
        /// The bands that there are, as in "80 to 400, 400 to 1500".
        bands: String,
    },

    /// The data do not suffice for an inference, or it did not come to an end.
    #[error("{0}")]
    CannotInfer(String),

    /// Two flights carry the same number, or impacts are not in order.
    #[error(
        "{what} number {number} is not above the number before it; number them in order, once each"
    )]
    NotInOrder {
        /// What is numbered: "flight" or "impact".
        what: &'static str,
        /// The number that does not follow.
        number: usize,
    },
}

impl Error {
    /// An [`Error::NoBand`] that lists the bands there are.
    pub(crate) fn no_band(range_hz: &Range<f64>, bands_hz: &[Range<f64>]) -> Self {
        let bands = bands_hz
            .iter()
            .map(|band| format!("{:.0} to {:.0}", band.start, band.end));
        Self::NoBand {
            range: if range_hz.end.is_finite() {
                format!("between {} and {}", range_hz.start, range_hz.end)
            } else {
                format!("above {}", range_hz.start)
            },
            bands: bands.collect::<Vec<_>>().join(", "),
        }
    }

    /// An [`Error::UnknownName`] that offers the known name most like `name`.
    pub(crate) fn unknown_name(kind: &'static str, name: &str, known: &[&str]) -> Self {
        let likeness = |candidate: &&&str| strsim::jaro_winkler(name, candidate);
        let nearest = known
            .iter()
            .max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
        Self::UnknownName {
            kind,
            name: name.to_owned(),
            nearest: nearest.map_or_else(String::new, ToString::to_string),
            known: known.join(", "),
        }
    }
}

/// A number without the noise of binary fractions, in powers of ten where there would be a row of
/// zeros.
fn written(value: f64) -> String {
    let value = if value.fract() == 0.0 {
        value
    } else {
        format!("{value:.8e}").parse().unwrap_or(value)
    };
    let ordinary = value == 0.0 || !value.is_finite() || (1e-9..1e15).contains(&value.abs());
    if ordinary {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// `Ok` if `holds`, otherwise an [`Error::OutOfRange`] for the quantity.
///
/// Conditions are written so that NaN makes them false.
pub(crate) fn require(
    holds: bool,
    quantity: &'static str,
    value: f64,
    allowed: &'static str,
) -> Result<()> {
    if holds {
        Ok(())
    } else {
        Err(Error::OutOfRange {
            quantity,
            value,
            allowed,
        })
    }
}

/// The value back if it is finite.
pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<f64> {
    require(value.is_finite(), quantity, value, "finite")?;
    Ok(value)
}

/// The value back if it is finite and above zero.
pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<f64> {
    require(
        value > 0.0 && value.is_finite(),
        quantity,
        value,
        "finite and above 0",
    )?;
    Ok(value)
}

/// The value back if it is of a size that things have, in SI: far beyond it the physics drowns in
/// the range of floating-point numbers.
pub(crate) fn of_a_size(quantity: &'static str, value: f64) -> Result<f64> {
    let sizes = 1e-20..=1e20;
    require(
        sizes.contains(&value),
        quantity,
        value,
        "from 1e-20 to 1e20",
    )?;
    Ok(value)
}

/// The value back if it is finite and not negative.
pub(crate) fn not_negative(quantity: &'static str, value: f64) -> Result<f64> {
    require(
        value >= 0.0 && value.is_finite(),
        quantity,
        value,
        "finite and not below 0",
    )?;
    Ok(value)
}

/// `Ok` if each number exceeds the one before, otherwise an [`Error::NotInOrder`].
pub(crate) fn in_order(what: &'static str, numbers: impl IntoIterator<Item = usize>) -> Result<()> {
    let mut before = None;
    for number in numbers {
        if before.is_some_and(|before| number <= before) {
            return Err(Error::NotInOrder { what, number });
        }
        before = Some(number);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::positive;

    #[test]
    fn numbers_are_written_without_rows_of_zeros() {
        let said = |value: f64| positive("height in m", value).unwrap_err().to_string();
        assert!(said(-1.5).starts_with("height in m is -1.5;"));
        assert!(said(0.2 - 0.3).starts_with("height in m is -0.1;"));
        assert!(said(-1e300).starts_with("height in m is -1e300;"));
        assert!(said(-1e-300).starts_with("height in m is -1e-300;"));
        assert!(said(f64::NAN).starts_with("height in m is NaN;"));
    }
}
