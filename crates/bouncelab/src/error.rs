//! What can go wrong in the science.

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
    #[error("{quantity} is {value}; it must be {allowed}")]
    OutOfRange {
        /// The quantity with its unit, as in "mass in kg".
        quantity: &'static str,
        /// The value that was given.
        value: f64,
        /// The values that are accepted, in words.
        allowed: &'static str,
    },
}
