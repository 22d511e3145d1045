//! What a bounce keeps: restitution laws and contact time.

use crate::error::{Result, not_negative, require};

/// The coefficient of restitution e as a function of the impact speed.
///
/// ```
/// use bouncelab::impact::Restitution;
///
/// let stiff = Restitution::constant(0.95)?;
/// assert_eq!(stiff.at(3.0), 0.95);
///
/// let softening = Restitution::linear(0.96, 0.01)?;
/// assert_eq!(format!("{:.2}", softening.at(3.0)), "0.93");
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restitution(Law);

#[derive(Debug, Clone, Copy, PartialEq)]
enum Law {
    Constant(f64),
    Linear { at_rest: f64, loss_per_speed: f64 },
}

impl Restitution {
    /// The same e at every speed, as in the paper.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless it is from 0 to 1.
    pub fn constant(restitution: f64) -> Result<Self> {
        Ok(Self(Law::Constant(fraction(
            "coefficient of restitution",
            restitution,
        )?)))
    }

    /// e(v) = e0 - k v: falling with the impact speed if k is above zero. Where the line leaves the
    /// range from 0 to 1, e stays at its end.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e0 is from 0 to 1 and k (in s/m) is
    /// finite.
    pub fn linear(at_rest: f64, loss_per_speed_s_m: f64) -> Result<Self> {
        let at_rest = fraction("coefficient of restitution at rest", at_rest)?;
        require(
            loss_per_speed_s_m.is_finite(),
            "loss of restitution with speed in s/m",
            loss_per_speed_s_m,
            "finite",
        )?;
        Ok(Self(Law::Linear {
            at_rest,
            loss_per_speed: loss_per_speed_s_m,
        }))
    }

    /// The coefficient of restitution of an impact at a speed, from 0 to 1.
    pub fn at(&self, impact_speed_m_s: f64) -> f64 {
        match self.0 {
            Law::Constant(restitution) => restitution,
            Law::Linear {
                at_rest,
                loss_per_speed,
            } => (at_rest - loss_per_speed * impact_speed_m_s).clamp(0.0, 1.0),
        }
    }
}

fn fraction(quantity: &'static str, value: f64) -> Result<f64> {
    require(
        (0.0..=1.0).contains(&value),
        quantity,
        value,
        "from 0 (dead) to 1 (lossless)",
    )?;
    Ok(value)
}

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
    pub fn new(restitution: Restitution, contact_time_s: f64) -> Result<Self> {
        let contact_time_s = not_negative("contact time in s", contact_time_s)?;
        Ok(Self {
            restitution,
            contact_time_s,
        })
    }

    /// A contact without duration, as in the paper.
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
    #[expect(clippy::float_cmp, reason = "the ends of the range are exact")]
    fn restitution_stays_a_fraction() {
        let line = Restitution::linear(0.9, 0.1).unwrap();
        assert_eq!(line.at(0.0), 0.9);
        assert_eq!(line.at(100.0), 0.0);
        assert_eq!(Restitution::linear(0.9, -0.1).unwrap().at(100.0), 1.0);
    }

    #[test]
    fn absurd_contacts_are_refused() {
        for restitution in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
            assert!(Restitution::constant(restitution).is_err());
            assert!(Restitution::linear(restitution, 0.0).is_err());
        }
        assert!(Restitution::linear(0.9, f64::NAN).is_err());
        let restitution = Restitution::constant(0.9).unwrap();
        assert!(Contact::new(restitution, -1e-3).is_err());
    }
}
