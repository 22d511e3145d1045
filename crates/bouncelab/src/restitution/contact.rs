//! The contact of ball and surface.

use super::Restitution;
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
    /// use bouncelab::restitution::{Contact, Restitution};
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
    /// use bouncelab::restitution::{Contact, Restitution};
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
