//! Samples to onset candidates.
