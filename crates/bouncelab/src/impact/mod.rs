//! Impacts: restitution laws and contact time.

mod law;

pub use law::Restitution;
pub(crate) use law::Restitutions;

use crate::error::{Quantity, Result, within};

/// How a ball meets a surface: what it keeps of its speed and how long it stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    restitution: Restitution,
    contact_time_s: f64,
}

impl Contact {
    /// A contact with a restitution law and the same contact time at every speed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless the time is finite and not below zero.
    ///
    /// ```
    /// use bouncelab::impact::{Contact, Restitution};
    ///
    /// let contact = Contact::new(Restitution::constant(0.93)?, 1e-3)?;
    /// assert_eq!(contact.contact_time_s(), 1e-3);
    /// assert!(Contact::new(Restitution::constant(0.93)?, -1e-3).is_err());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn new(restitution: Restitution, contact_time_s: f64) -> Result<Self> {
        let contact_time_s = within(Quantity::ContactTime, contact_time_s, 0.0..)?;
        Ok(Self {
            restitution,
            contact_time_s,
        })
    }

    /// A contact without duration, as in the paper.
    ///
    /// ```
    /// use bouncelab::impact::{Contact, Restitution};
    ///
    /// let contact = Contact::instantaneous(Restitution::constant(0.9375)?);
    /// assert_eq!(contact.contact_time_s(), 0.0);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn instantaneous(restitution: Restitution) -> Self {
        Self {
            restitution,
            contact_time_s: 0.0,
        }
    }

    /// The restitution law.
    pub fn restitution(&self) -> Restitution {
        self.restitution
    }

    /// How long the ball touches the surface in each impact, s.
    pub fn contact_time_s(&self) -> f64 {
        self.contact_time_s
    }
}

/// An impact as known: of a recording, of a list of times, or set by hand.
///
/// ```
/// use bouncelab::Impact;
///
/// let impact = Impact::new(3, 1.2854).with_time_sd_s(5e-5);
/// assert_eq!(impact.probability, 1.0);
/// assert_eq!(impact.level_db, None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Impact {
    /// Number, 1 for the first impact known; a missed impact leaves a gap.
    pub number: usize,
    /// Time in seconds.
    pub time_s: f64,
    /// Standard uncertainty of the time in seconds, where it is known; the errors of different
    /// impacts are independent.
    pub time_sd_s: Option<f64>,
    /// Probability that this is an impact of the drop; 1 if it was set by hand.
    pub probability: f64,
    /// Level in dB relative to full scale, if it was detected in sound.
    pub level_db: Option<f64>,
}

impl Impact {
    /// An impact known by its number (1 for the first) and time alone.
    pub const fn new(number: usize, time_s: f64) -> Self {
        Self {
            number,
            time_s,
            time_sd_s: None,
            probability: 1.0,
            level_db: None,
        }
    }

    /// The same with a standard uncertainty of its time, in seconds.
    #[must_use]
    pub const fn with_time_sd_s(self, time_sd_s: f64) -> Self {
        Self {
            time_sd_s: Some(time_sd_s),
            ..self
        }
    }

    /// The same with its level, in dB relative to full scale.
    #[must_use]
    pub const fn with_level_db(self, level_db: f64) -> Self {
        Self {
            level_db: Some(level_db),
            ..self
        }
    }
}

/// One impact as a source of sound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strike {
    /// When the ball touches the surface, s after release.
    pub time_s: f64,
    /// How fast it arrives, m/s.
    pub speed_m_s: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn absurd_contacts_are_refused() {
        let restitution = Restitution::constant(0.9).unwrap();
        for contact_time_s in [-1e-3, f64::NAN, f64::INFINITY] {
            assert!(Contact::new(restitution, contact_time_s).is_err());
        }
    }
}
