//! The same restitution at every speed.

use super::law::{Law, NUMBERS, fraction};
use super::{LawKind, Restitution};
use crate::error::Result;
use crate::simd::Lanes;

pub(super) const LAW: Law = Law {
    name: "constant",
    example: "constant:0.9",
    meaning: "0.9",
    of_numbers: |numbers| {
        let &[restitution] = numbers else { return None };
        Some(Restitution::constant(restitution))
    },
    random_stream: 0,
    restitutions_needed: 1,
    shapes: 0,
    of_normals: |restitution, _, _| Restitution::constant(restitution),
    start: [0.0; super::law::MAX_SHAPES],
    normal_of_slope: None,
    slope_from_few_flights: false,
};

impl Restitution {
    /// The same e at every speed, as in the paper.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless it is from 0 to 1.
    ///
    /// ```
    /// use bouncelab::restitution::Restitution;
    ///
    /// assert_eq!(Restitution::constant(0.9)?.at(5.0), 0.9);
    /// assert!(Restitution::constant(1.1).is_err());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn constant(restitution: f64) -> Result<Self> {
        fraction(restitution)?;
        let numbers = [restitution, restitution.ln()];
        Ok(Self::new(LawKind::Constant, &numbers))
    }
}

#[inline(always)]
pub(super) fn curve<const L: usize>(
    &[restitution, ..]: &[Lanes<L>; NUMBERS],
    _: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    (restitution, Lanes::all(0.0))
}

#[inline(always)]
pub(super) fn log_curve<const L: usize>(
    &[_, ln_restitution, ..]: &[Lanes<L>; NUMBERS],
    _: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    (ln_restitution, Lanes::all(0.0))
}
