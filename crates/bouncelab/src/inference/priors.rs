//! Measurements and priors besides the impact times.

use super::parameters::UNKNOWN;
use super::possible_balls::PossibleBall;
use super::scatter_prior::ScatterPrior;
use crate::ball::{Ball, KnownBall};
use crate::diagnostic::{Code, Diagnostic};
use crate::error::{Quantity, Result, positive, within};
use crate::restitution::{LawKind, RestitutionPrior};
use crate::simd::Lanes;

/// A measured quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// Its standard uncertainty, in the same unit.
    pub sd: f64,
}

/// Measurements and prior knowledge besides the times.
///
/// The shares are relative standard uncertainties: 0.01 is one per cent, 0 is exact, and
/// [`UNKNOWN`] leaves it to the data. They are the priors of the inference; the defaults are those of a ball
/// and of ambient conditions that were not measured.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Priors {
    /// The balls that it may be, each as probable as the others before the data, if nobody stated which; if empty, it is
    /// the given one.
    pub possible_balls: Vec<PossibleBall>,
    /// Height of the lowest point of the ball above the surface at release, m.
    pub drop_height_m: Option<Measured>,
    /// When the ball was released, s, in the time of the impacts.
    pub release_s: Option<Measured>,
    /// Whether the first impact detected is the first there was. With gravity unknown it must be: a
    /// missed impact and a weaker gravity look alike.
    pub first_was_detected: bool,
    /// Restitution laws to consider; if empty, the smooth one alone, which can follow any other.
    pub restitution_laws: Vec<LawKind>,
    /// What is known of the restitution over the impact speed; if `None`, e* is flat from 0 to 1 and each law has its usual
    /// prior. It is one of the smooth law, which is then the only one.
    pub restitution: Option<RestitutionPrior>,
    /// Drag coefficient: how far a real ball may lie from the law. The laws of smooth spheres
    /// scatter by about 3 % at Reynolds numbers of 1,000 to 10,000; 4 % allows for a ball.
    pub drag_rel_sd: f64,
    /// Gravity.
    pub gravity_rel_sd: f64,
    /// Density of the air: temperature, pressure, humidity.
    pub air_density_rel_sd: f64,
    /// Mass of the ball.
    pub mass_rel_sd: f64,
    /// Diameter of the ball.
    pub diameter_rel_sd: f64,
    /// Added mass of the air: in potential flow it is half the volume, but a bouncing ball is no potential
    /// flow.
    pub added_mass_rel_sd: f64,
    /// Contact time.
    pub contact_time_rel_sd: f64,
    /// The stated standard errors of the impact times, as a common factor.
    pub timing_rel_sd: f64,
    /// Typical scatter of restitution from impact to impact. 0.2 to 0.5 % is published for good surfaces, and floors have
    /// one or more: 0.6 % lies between. That of a drop is half as much to 2.5 times as much with a probability of 68 %,
    /// and a fifth to seven times with 95 %; see [`Self::scatter_at`].
    pub restitution_scatter: f64,
    /// Factor on the width of the prior of the scatter, in its logarithm: 1 is the usual width, and with 0 the scatter is the
    /// typical one.
    pub scatter_spread: f64,
    /// Losses of speed below the slowest impact detected, on which only time and path until rest depend. Laws of contact
    /// let them shrink with the speed; what the laws leave out (adhesion, roughness, the weight during contact) takes the
    /// more, the slower the ball is. With a probability of one half the law goes on, else the ratio of speed lost to speed
    /// kept grows as v^-k besides, with k half-normal of this scale; nor does that of the law fall faster than v^(3/5), as
    /// losses to sound waves in the bodies. With 0 the law goes on until rest.
    pub slow_loss_exponent: f64,
}

impl Default for Priors {
    fn default() -> Self {
        Self {
            possible_balls: Vec::new(),
            drop_height_m: None,
            release_s: None,
            first_was_detected: false,
            restitution_laws: Vec::new(),
            restitution: None,
            drag_rel_sd: 0.04,
            // Half the range over the surface of the Earth, as a rectangle.
            gravity_rel_sd: 0.0015,
            // 5 K, 15 hPa and 25 % of humidity.
            air_density_rel_sd: 0.023,
            mass_rel_sd: 0.01,
            diameter_rel_sd: 0.006,
            added_mass_rel_sd: 0.3,
            contact_time_rel_sd: 0.5,
            timing_rel_sd: 0.3,
            restitution_scatter: 0.006,
            scatter_spread: 1.0,
            slow_loss_exponent: 0.5,
        }
    }
}

impl Priors {
    /// The same with what is known of a ball, in place of the usual.
    ///
    /// ```
    /// use bouncelab::ball;
    /// use bouncelab::inference::Priors;
    ///
    /// // The drag of felt is known less well than that of a smooth ball.
    /// let tennis = Priors::default().with_ball(&ball::preset("tennis")?.known);
    /// assert!(tennis.drag_rel_sd > Priors::default().drag_rel_sd);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    #[must_use]
    pub fn with_ball(self, known: &KnownBall) -> Self {
        Self {
            possible_balls: Vec::new(),
            mass_rel_sd: known.mass_rel_sd,
            diameter_rel_sd: known.diameter_rel_sd,
            contact_time_rel_sd: known.contact_time_rel_sd,
            drag_rel_sd: known.drag_rel_sd,
            ..self
        }
    }

    /// A ball with what these priors state of it.
    pub(crate) const fn known(&self, ball: Ball, contact_time_s: f64) -> KnownBall {
        KnownBall {
            ball,
            contact_time_s,
            mass_rel_sd: self.mass_rel_sd,
            diameter_rel_sd: self.diameter_rel_sd,
            contact_time_rel_sd: self.contact_time_rel_sd,
            drag_rel_sd: self.drag_rel_sd,
        }
    }

    /// The scatter of restitution at a standard normal: its prior mapped to a normal distribution.
    ///
    /// ```
    /// use bouncelab::inference::Priors;
    ///
    /// let [low, median, high] = [-2.0, 0.0, 2.0].map(|normal| Priors::default().scatter_at(normal));
    /// assert!((median - 0.006).abs() < 1e-5);
    /// assert!(low > 0.001 && high < 0.07);
    /// ```
    pub fn scatter_at(&self, normal: f64) -> f64 {
        self.scatter().scatters(Lanes([normal])).0[0]
    }

    pub(super) const fn scatter(&self) -> ScatterPrior {
        ScatterPrior {
            typical: self.restitution_scatter,
            spread: self.scatter_spread,
        }
    }

    /// What is assumed before the data, one diagnostic for each.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let input = |name: &str, relative_sd: f64| match relative_sd {
            0.0 => Diagnostic::new(Code::PriorExact).with("input", name),
            sd if sd >= UNKNOWN => Diagnostic::new(Code::PriorUnknown).with("input", name),
            sd => Diagnostic::new(Code::PriorInput)
                .with("input", name)
                .with("relative_sd", sd),
        };
        let scatter = Diagnostic::new(Code::PriorScatter)
            .with("relative_sd", self.restitution_scatter)
            .with("low_relative_sd", self.scatter_at(-1.0))
            .with("high_relative_sd", self.scatter_at(1.0));
        let mut diagnostics = vec![
            match &self.restitution {
                None => Diagnostic::new(Code::PriorRestitution),
                Some(prior) => {
                    Diagnostic::new(Code::PriorRestitutionStated).with("prior", prior.to_string())
                }
            },
            scatter,
            Diagnostic::new(Code::PriorSlowLosses).with("exponent", self.slow_loss_exponent),
            input("drag", self.drag_rel_sd),
            input("gravity", self.gravity_rel_sd),
            input("air-density", self.air_density_rel_sd),
            input("ball-mass", self.mass_rel_sd),
            input("ball-diameter", self.diameter_rel_sd),
            input("added-mass", self.added_mass_rel_sd),
            input("contact-time", self.contact_time_rel_sd),
            input("timing", self.timing_rel_sd),
        ];
        diagnostics.push(match self.drop_height_m {
            Some(Measured { value, sd }) => Diagnostic::new(Code::PriorHeight)
                .with("height_m", value)
                .with("sd_m", sd),
            None => Diagnostic::new(Code::PriorHeightFlat),
        });
        if let Some(Measured { value, sd }) = self.release_s {
            let release = Diagnostic::new(Code::PriorRelease);
            diagnostics.push(release.with("release_s", value).with("sd_s", sd));
        }
        if self.determine_missed() {
            diagnostics.push(Diagnostic::new(Code::PriorMissed));
        }
        diagnostics
    }

    /// The laws to consider, each once: a law requested twice is no more probable.
    pub(super) fn laws(&self) -> Vec<LawKind> {
        if self.restitution_laws.is_empty() || self.restitution.is_some() {
            return vec![LawKind::Smooth];
        }
        let mut laws = LawKind::ALL.to_vec();
        laws.retain(|law| self.restitution_laws.contains(law));
        laws
    }

    /// Whether the given quantities determine the number of impacts missed before the first one detected.
    pub(super) fn determine_missed(&self) -> bool {
        let state = self.drop_height_m.is_some() || self.release_s.is_some();
        state && !self.first_was_detected && self.gravity_rel_sd < UNKNOWN
    }

    /// Checks all values.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for a height or an uncertainty that is not
    /// above zero, a share below zero, or not-a-number.
    pub fn check(&self) -> Result<()> {
        if let Some(height) = self.drop_height_m {
            positive(Quantity::Height, height.value)?;
            positive(Quantity::HeightSd, height.sd)?;
        }
        if let Some(release) = self.release_s {
            within(Quantity::ReleaseTime, release.value, ..)?;
            positive(Quantity::ReleaseTimeSd, release.sd)?;
        }
        for share in [
            self.drag_rel_sd,
            self.gravity_rel_sd,
            self.air_density_rel_sd,
            self.mass_rel_sd,
            self.diameter_rel_sd,
            self.added_mass_rel_sd,
            self.contact_time_rel_sd,
            self.timing_rel_sd,
            self.scatter_spread,
        ] {
            within(Quantity::RelativeSd, share, 0.0..)?;
        }
        positive(Quantity::RestitutionScatter, self.restitution_scatter)?;
        within(Quantity::SlowLossExponent, self.slow_loss_exponent, 0.0..)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_asked_for_twice_is_considered_once() {
        let priors = Priors {
            restitution_laws: vec![LawKind::Knee, LawKind::Constant, LawKind::Knee],
            ..Priors::default()
        };
        assert_eq!(priors.laws(), [LawKind::Constant, LawKind::Knee]);
    }

    #[test]
    fn the_smooth_law_is_the_default() {
        assert_eq!(Priors::default().laws(), [LawKind::Smooth]);
    }
}
