//! The measuring programs of the project: how well drops are detected and inferred, and the net.
//!
//! `main` has the list of programs. Nothing here is published.

pub mod net;
pub mod scenario;
