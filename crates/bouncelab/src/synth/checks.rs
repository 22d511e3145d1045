//! Range checks of a scene's numbers. Not-a-number lies in no range.

use std::ops::RangeInclusive;

use crate::Result;
use crate::error::require;

/// Accepts a value in the closed range.
pub(super) fn within(
    quantity: &'static str,
    value: f64,
    range: RangeInclusive<f64>,
    allowed: &'static str,
) -> Result<()> {
    require(range.contains(&value), quantity, value, allowed)
}

/// Accepts a value above zero and not above `max`, which `allowed` names.
pub(super) fn positive_up_to(
    quantity: &'static str,
    value: f64,
    max: f64,
    allowed: &'static str,
) -> Result<()> {
    within(quantity, value, f64::MIN_POSITIVE..=max, allowed)
}
