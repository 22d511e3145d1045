//! The errors of this crate.

mod refused;

use std::ops::Bound::{Excluded, Included, Unbounded};
use std::ops::{Range, RangeBounds};

pub use refused::{Bounds, Quantity};

use crate::diagnostic::{Argument, Code, Diagnostic};
use crate::impact::Impact;

/// The result of a calculation that can refuse its input.
pub type Result<T> = std::result::Result<T, Error>;

/// Why a calculation was refused.
///
/// Every message states the fault and its remedy, and can be shown to users as it is. Kinds and fields may be added: match
/// with `..`, and with a last arm for other kinds.
///
/// ```
/// use bouncelab::{Error, ball};
///
/// match ball::preset("table-tenis") {
///     Err(Error::UnknownName { nearest, .. }) => assert!(nearest.starts_with("table-tennis")),
///     other => panic!("{other:?}"),
/// }
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A number is outside the range of the calculation (this includes NaN).
    #[error("{quantity} is {}; it must be {allowed}", quantity.written(*value))]
    #[non_exhaustive]
    OutOfRange {
        /// The quantity.
        quantity: Quantity,
        /// The value that was given, in the unit of the quantity.
        value: f64,
        /// The values that are accepted.
        allowed: Bounds,
    },

    /// A name that is not in one of the crate's lists.
    #[error("no {kind} is called \"{name}\"; the nearest is \"{nearest}\" (known: {known})")]
    #[non_exhaustive]
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

    /// The Reynolds number of the ball is above the last point of a drag table.
    #[error(
        "the drag table ends at Reynolds number {max_reynolds:.3e}, but the ball reaches {reynolds:.3e}; add a point \
         there or choose the standard curve"
    )]
    #[non_exhaustive]
    ReynoldsTooHigh {
        /// The Reynolds number that was asked for.
        reynolds: f64,
        /// The last of the table.
        max_reynolds: f64,
    },

    /// The air that the ball displaces weighs as much as the ball, so it never comes down.
    #[error(
        "the ball weighs {mass_kg} kg and displaces {displaced_kg} kg of air, so it floats; check \
         mass and diameter, or neglect buoyancy"
    )]
    #[non_exhaustive]
    Floats {
        /// Mass of the ball.
        mass_kg: f64,
        /// Mass of the air it displaces.
        displaced_kg: f64,
    },

    /// A drop with more bounces than the simulation allows.
    #[error(
        "the ball still rises {apex_m:.3e} m after {bounces} bounces; lower the restitution, stop at \
         a greater height, or ask for at most {bounces} bounces"
    )]
    #[non_exhaustive]
    EndlessDrop {
        /// How many bounces were simulated before giving up.
        bounces: usize,
        /// The height it still reaches.
        apex_m: f64,
    },

    /// A log-linear fit needs two flights.
    #[error(
        "a log-linear fit of the flight times needs at least 2 flights, but there are {flights}; \
         use a recording with at least 3 impacts, or a wider range of flights"
    )]
    #[non_exhaustive]
    TooFewFlights {
        /// How many flights were given.
        flights: usize,
    },

    /// A mean of no drops, or more means than the drops determine.
    #[error("this needs {needed} drops or more, and there are {drops}")]
    #[non_exhaustive]
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
    #[non_exhaustive]
    NoBand {
        /// The range, as in "between 400 and 500".
        range: String,
        /// The bands that there are, as in "80 to 400, 400 to 1500".
        bands: String,
    },

    /// The data do not suffice for an inference, or it failed.
    #[error(transparent)]
    CannotInfer(InferenceFailure),

    /// The recording has no channel of this number.
    #[error("there is no channel {channel}: the recording has {channels}, the first being 1")]
    #[non_exhaustive]
    NoChannel {
        /// The channel that was asked for, the first being 1.
        channel: usize,
        /// How many there are.
        channels: usize,
    },

    /// More channels than can be analysed together.
    #[error(
        "{channels} channels are more than can be analysed together: at this sample rate at most {most}; \
         choose one of them"
    )]
    #[non_exhaustive]
    TooManyChannels {
        /// How many there are.
        channels: usize,
        /// How many can be analysed together.
        most: usize,
    },

    /// A rule that evaluates each drop cannot compare with a reference.
    #[error("a share of a reference compares means: single drops have no share")]
    EachOfReference,

    /// Two settings of which only one can hold.
    #[error("{first} and {second} contradict each other; leave out one")]
    #[non_exhaustive]
    Contradiction {
        /// One of them: "infer drag".
        first: String,
        /// The other.
        second: String,
    },

    /// Two flights carry the same number, or impacts are not in order.
    #[error(
        "{what} number {number} is not above the number before it; number them in order, once each"
    )]
    #[non_exhaustive]
    NotInOrder {
        /// What is numbered: "flight" or "impact".
        what: &'static str,
        /// The number that does not follow.
        number: usize,
    },
}

/// Why nothing can be inferred.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InferenceFailure {
    /// No inference was asked for.
    #[error("no inference was requested")]
    NotRequested,
    /// There is no flight.
    #[error("an inference needs at least one flight, that is two impacts; there are {impacts}")]
    TooFewImpacts {
        /// How many impacts there are.
        impacts: usize,
    },
    /// Too many impacts in a row were missed.
    #[error("{missed} impacts in a row were missed after impact {after}")]
    MissedInARow {
        /// How many.
        missed: usize,
        /// The number of the impact before them.
        after: usize,
    },
    /// Two impacts are so close to each other that the ball cannot have flown in between.
    #[error(
        "impacts {first} and {second}, at {time_s} s, are {interval_s} s apart, and the ball touches the surface \
         for {contact_time_s} s; exclude one of them, or correct ball or contact time"
    )]
    ContactOverlaps {
        /// The number of the earlier one.
        first: usize,
        /// The number of the later one.
        second: usize,
        /// The time of the earlier one, s.
        time_s: f64,
        /// The time between them, s.
        interval_s: f64,
        /// The contact time, s.
        contact_time_s: f64,
    },
    /// The impacts do not determine the restitution: it is that of its prior.
    #[error(
        "{impacts} impacts leave the restitution anywhere from {low:.2} to {high:.2}; record at least three \
         impacts, or state the drop height"
    )]
    RestitutionUndetermined {
        /// How many impacts there are.
        impacts: usize,
        /// Lower end of the 95 % interval.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// The sampling did not converge, so that its intervals could not be trusted.
    #[error(
        "the sampling did not converge (Pareto shape {pareto_shape:.2}); are all impacts of one drop, and is the \
         ball right?"
    )]
    NotConverged {
        /// Shape of the tail of the weights; infinite if a candidate has no sample.
        pareto_shape: f64,
    },
    /// No ball with so much drag flies so long.
    #[error(
        "air drag makes a flight of {duration_s} s, after impact {after}, impossible for this ball; check mass, \
         diameter and the unit of the times"
    )]
    FlightTooLong {
        /// The number of the impact before the flight.
        after: usize,
        /// How long it lasts, s.
        duration_s: f64,
    },
    /// The ball would gain speed in most impacts.
    #[error(
        "the ball would gain speed at most impacts, which is impossible on a surface at rest; are the times in \
         order, in seconds, and of one drop?"
    )]
    GainsSpeed,
    /// No physical model explains the times.
    #[error(
        "no physical model fits these times; are they of one drop, in seconds, and is the ball \
         right?"
    )]
    NoModelFits,
    /// No draw of the posterior explains the times.
    #[error("the posterior could not be sampled: no draw fits the times; are they of one drop?")]
    SamplingFailed,
    /// All drops are in one group, or the groups cannot be separated.
    #[error("the variances of these groups cannot be separated")]
    Confounded,
}

impl Error {
    /// The error as data, from which messages in other languages are made.
    ///
    /// ```
    /// use bouncelab::ball::Ball;
    ///
    /// let refused = Ball::new(-1.0, 0.04).unwrap_err().diagnostic();
    /// assert_eq!(refused.code.name(), "out-of-range");
    /// assert_eq!(refused.number("value"), Some(-1.0));
    /// ```
    pub fn diagnostic(&self) -> Diagnostic {
        use Argument::Text;
        match self {
            Self::OutOfRange {
                quantity,
                value,
                allowed,
            } => {
                let optional = [
                    ("unit", quantity.unit().map(Argument::from)),
                    ("low", allowed.low().map(Argument::from)),
                    ("high", allowed.high().map(Argument::from)),
                ];
                let mut refused = Diagnostic::new(Code::OutOfRange)
                    .with("quantity", quantity.key())
                    .with("value", *value)
                    .with("range", allowed.key());
                for (name, argument) in optional {
                    refused
                        .arguments
                        .extend(argument.map(|argument| (name.to_owned(), argument)));
                }
                refused
            }
            Self::UnknownName {
                kind,
                name,
                nearest,
                known,
            } => Diagnostic::new(Code::UnknownName)
                .with("kind", *kind)
                .with("name", Text(name.clone()))
                .with("nearest", Text(nearest.clone()))
                .with("known", Text(known.clone())),
            Self::ReynoldsTooHigh {
                reynolds,
                max_reynolds,
            } => Diagnostic::new(Code::ReynoldsTooHigh)
                .with("reynolds", *reynolds)
                .with("max_reynolds", *max_reynolds),
            Self::Floats {
                mass_kg,
                displaced_kg,
            } => Diagnostic::new(Code::BallFloats)
                .with("mass_kg", *mass_kg)
                .with("displaced_kg", *displaced_kg),
            Self::EndlessDrop { bounces, apex_m } => Diagnostic::new(Code::EndlessDrop)
                .with("bounces", *bounces)
                .with("apex_m", *apex_m),
            Self::TooFewFlights { flights } => {
                Diagnostic::new(Code::TooFewFlights).with("flights", *flights)
            }
            Self::TooFewDrops { needed, drops } => Diagnostic::new(Code::TooFewDrops)
                .with("needed", *needed)
                .with("drops", *drops),
            Self::NoBand { range, bands } => Diagnostic::new(Code::NoBand)
                .with("range", Text(range.clone()))
                .with("bands", Text(bands.clone())),
            Self::NoChannel { channel, channels } => Diagnostic::new(Code::NoChannel)
                .with("channel", *channel)
                .with("channels", *channels),
            Self::TooManyChannels { channels, most } => Diagnostic::new(Code::TooManyChannels)
                .with("channels", *channels)
                .with("most", *most),
            Self::EachOfReference => Diagnostic::new(Code::EachOfReference),
            Self::CannotInfer(reason) => reason.diagnostic(),
            Self::Contradiction { first, second } => Diagnostic::new(Code::SettingsContradict)
                .with("first", Text(first.clone()))
                .with("second", Text(second.clone())),
            Self::NotInOrder { what, number } => Diagnostic::new(Code::NotInOrder)
                .with("what", *what)
                .with("number", *number),
        }
    }

    /// An [`Error::OutOfRange`] for a value that is not in the range.
    pub(crate) fn out_of_range(
        quantity: Quantity,
        value: f64,
        range: impl RangeBounds<f64>,
    ) -> Self {
        let allowed = Bounds::from(&range);
        Self::OutOfRange {
            quantity,
            value,
            allowed,
        }
    }

    /// An [`Error::Contradiction`] of two settings.
    pub(crate) fn contradiction(first: &str, second: &str) -> Self {
        Self::Contradiction {
            first: first.to_owned(),
            second: second.to_owned(),
        }
    }

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

    /// An [`Error::UnknownName`] that suggests the known name most similar to `name`, the first of equally similar ones.
    pub fn unknown_name(kind: &'static str, name: &str, known: &[&str]) -> Self {
        Self::UnknownName {
            kind,
            name: name.to_owned(),
            nearest: nearest(name, known.iter().copied()).to_owned(),
            known: known.join(", "),
        }
    }
}

/// The known name that is most similar to this one, the first of equally similar ones; empty if no name is known.
pub(crate) fn nearest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> &'a str {
    let likeness = |candidate: &str| strsim::jaro_winkler(name, candidate);
    let better = |best: &'a str, other: &'a str| {
        if likeness(other) > likeness(best) {
            other
        } else {
            best
        }
    };
    known.reduce(better).unwrap_or_default()
}

impl InferenceFailure {
    /// A [`Self::ContactOverlaps`] of these impacts.
    pub(crate) fn of_contact(first: &Impact, second: &Impact, contact_time_s: f64) -> Self {
        Self::ContactOverlaps {
            first: first.number,
            second: second.number,
            time_s: first.time_s,
            interval_s: second.time_s - first.time_s,
            contact_time_s,
        }
    }

    fn diagnostic(&self) -> Diagnostic {
        match self {
            Self::NotRequested => Diagnostic::new(Code::InferenceOff),
            Self::TooFewImpacts { impacts } => {
                Diagnostic::new(Code::InferenceNeedsImpacts).with("count", *impacts)
            }
            Self::MissedInARow { missed, after } => Diagnostic::new(Code::MissedInARow)
                .with("missed", *missed)
                .with("after", *after),
            Self::FlightTooLong { after, duration_s } => Diagnostic::new(Code::FlightTooLong)
                .with("after", *after)
                .with("duration_s", *duration_s),
            Self::ContactOverlaps {
                first,
                second,
                time_s,
                interval_s,
                contact_time_s,
            } => Diagnostic::new(Code::ContactOverlaps)
                .with("first", *first)
                .with("second", *second)
                .with("time_s", *time_s)
                .with("interval_s", *interval_s)
                .with("contact_time_s", *contact_time_s),
            Self::RestitutionUndetermined { impacts, low, high } => {
                Diagnostic::new(Code::RestitutionUndetermined)
                    .with("count", *impacts)
                    .with("least", *low)
                    .with("greatest", *high)
            }
            Self::NotConverged { pareto_shape } => {
                let unconverged = Diagnostic::new(Code::SamplingNotConverged);
                if pareto_shape.is_finite() {
                    unconverged.with("pareto_shape", *pareto_shape)
                } else {
                    unconverged
                }
            }
            Self::GainsSpeed => Diagnostic::new(Code::GainsSpeed),
            Self::NoModelFits => Diagnostic::new(Code::NoModelFits),
            Self::SamplingFailed => Diagnostic::new(Code::SamplingFailed),
            Self::Confounded => Diagnostic::new(Code::VariancesConfounded),
        }
    }
}

/// The value back if it is in the range, otherwise an [`Error::OutOfRange`]. Infinite values and
/// not-a-number are in no range.
pub(crate) fn within(quantity: Quantity, value: f64, range: impl RangeBounds<f64>) -> Result<f64> {
    if range.contains(&value) && value.is_finite() {
        Ok(value)
    } else {
        Err(Error::out_of_range(quantity, value, range))
    }
}

/// The value back if it is finite and above zero.
pub(crate) fn positive(quantity: Quantity, value: f64) -> Result<f64> {
    within(quantity, value, (Excluded(0.0), Unbounded))
}

/// The value back if it is above zero and at most `highest`.
pub(crate) fn positive_up_to(quantity: Quantity, value: f64, highest: f64) -> Result<f64> {
    within(quantity, value, (Excluded(0.0), Included(highest)))
}

/// The value back if it is from 1e-20 to 1e20 in SI: the physics of larger and smaller values exceeds the range of
/// floating-point numbers.
pub(crate) fn of_a_size(quantity: Quantity, value: f64) -> Result<f64> {
    within(quantity, value, 1e-20..=1e20)
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
    use super::*;

    #[test]
    fn numbers_are_written_without_rows_of_zeros() {
        let refusal = |value: f64| positive(Quantity::Height, value).unwrap_err().to_string();
        for (value, start) in [
            (-1.5, "height is -1.5 m;"),
            (0.2 - 0.3, "height is -0.1 m;"),
            (-1e300, "height is -1e300 m;"),
            (-1e-300, "height is -1e-300 m;"),
            (f64::NAN, "height is NaN m;"),
        ] {
            assert!(refusal(value).starts_with(start), "{value}");
        }
    }

    #[test]
    fn ranges_are_written_with_their_ends() {
        let refusal = |range: (std::ops::Bound<f64>, std::ops::Bound<f64>)| {
            let refused = within(Quantity::Restitution, f64::NAN, range).unwrap_err();
            refused
                .to_string()
                .replace("restitution is NaN; it must be ", "")
        };
        for (range, text) in [
            ((Unbounded, Unbounded), "finite"),
            ((Excluded(0.0), Unbounded), "finite and above 0"),
            ((Included(-1.0), Excluded(0.5)), "at least -1 and below 0.5"),
            ((Unbounded, Included(1e20)), "finite and at most 1e20"),
        ] {
            assert_eq!(refusal(range), text);
        }
    }
}
