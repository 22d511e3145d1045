//! What can go wrong in the science.

/// What can go wrong in the science: always something that was asked of it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A quantity outside the range in which it means something.
    #[error("{quantity} is {value}, expected {expected}")]
    Invalid {
        /// What the number stands for, with its unit.
        quantity: &'static str,
        /// The number that was given.
        value: f64,
        /// What would have been accepted.
        expected: &'static str,
    },
}

/// A result of the science.
pub type Result<T, E = Error> = std::result::Result<T, E>;
