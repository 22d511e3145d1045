//! Restitution: the laws that it may obey, the contact of ball and surface, and the restitution of each impact,
//! corrected for drag.
//!
//! A law is one file of this folder and one line in the list below: the simulation, the inference and all front ends
//! offer what the list has.

mod contact;
mod law;
mod per_impact;
mod prior;

pub use contact::Contact;
pub use law::Restitution;
pub(crate) use law::{MAX_SHAPES, Restitutions, SpeedRange};
pub use per_impact::{ImpactRestitution, PerImpact, TimedFlight, of_impacts};
pub(crate) use prior::PriorOver;
pub use prior::RestitutionPrior;
pub(crate) use smooth::WALK;

use crate::simd::Lanes;

macro_rules! laws {
    ($($(#[$doc:meta])* $kind:ident, $file:ident;)+) => {
        $(mod $file;)+

        /// A kind of restitution law, with numbers that the inference determines or [`Restitution`] gives.
        ///
        /// v* is a speed in the middle of those detected. Before the data e* = e(v*) of every law is flat from 0 to 1;
        /// the constructors of [`Restitution`] state the priors of the other numbers.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
        #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
        #[non_exhaustive]
        pub enum LawKind {
            $($(#[$doc])* $kind,)+
        }

        impl LawKind {
            /// Every law.
            pub const ALL: [Self; [$(stringify!($kind)),+].len()] = [$(Self::$kind),+];

            const fn law(self) -> &'static law::Law {
                match self {
                    $(Self::$kind => &$file::LAW,)+
                }
            }

            /// e and d ln e/d ln v at an impact speed in each lane, if e had no bounds.
            #[cfg_attr(not(target_family = "wasm"), inline(always))]
            fn curve<const L: usize>(
                self,
                numbers: &[Lanes<L>; law::NUMBERS],
                speed: Lanes<L>,
            ) -> (Lanes<L>, Lanes<L>) {
                match self {
                    $(Self::$kind => $file::curve(numbers, speed),)+
                }
            }

            /// ln e and d ln e/d ln v by the logarithm of the impact speed in each lane, if e had no bounds.
            #[inline(always)]
            fn log_curve<const L: usize>(
                self,
                numbers: &[Lanes<L>; law::NUMBERS],
                ln_speed: Lanes<L>,
            ) -> (Lanes<L>, Lanes<L>) {
                match self {
                    $(Self::$kind => $file::log_curve(numbers, ln_speed),)+
                }
            }
        }
    };
}

laws! {
    /// The same at every speed: e, as in the paper.
    Constant, constant;
    /// A straight line, e0 - k v: the first order of any law that is smooth.
    Linear, linear;
    /// A power law, e* (v/v*)^-p.
    Power, power;
    /// A viscoelastic sphere, 1 - 1.153 a v^1/5 + ...
    Viscoelastic, viscoelastic;
    /// Constant below a knee and falling above it, as a hollow ball that buckles.
    Knee, knee;
    /// None of these, but a power law whose exponent changes slowly with speed: what a real surface may do.
    Smooth, smooth;
}

#[cfg(test)]
mod tests;
