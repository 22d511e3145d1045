//! The engine of the browser laboratory.
//!
//! A worker of the page calls this crate. Requests and responses are plain data: the result types of the
//! science, and [`wire`]. The example `types` writes them as types of TypeScript. The modules have Rust
//! interfaces, so that they are tested like all other code; `engine` and `decoders`, on wasm only, convert
//! to JSON and arrays.
//!
//! It is compiled twice, with the feature `engine` and with the feature `decoders`: nearly half of
//! the size are decoders, which a page needs only when a file is opened, or a drop becomes a link.
//!
//! | module | what it does |
//! |---|---|
//! | [`wire`] | requests and responses |
//! | [`refusal`] | reasons for a refused request |
//! | [`catalogue`] | choices of the settings |
//! | [`pyramid`] | envelope at any zoom |
//! | [`spectrogram`] | spectrogram |
//! | [`detector`] | drops of a recording |
//! | [`job`] | a test by a rule, drop after drop |
//! | [`language`] | messages of a language |
//! | [`link`](mod@link) | a drop as a link and a QR code |
//! | [`analyst`] | analysis of impacts |
//! | [`groups`] | the study of many drops |
//! | [`verdict`](mod@verdict) | drops judged by a rule |
//! | [`simulator`] | simulated drops and their sound |

#![allow(
    missing_debug_implementations,
    reason = "these are objects of JavaScript, which shows them"
)]

pub mod analyst;
pub mod catalogue;
#[cfg(all(target_family = "wasm", feature = "decoders"))]
pub mod decoders;
pub mod detector;
#[cfg(all(target_family = "wasm", feature = "engine"))]
pub mod engine;
#[cfg(all(target_family = "wasm", feature = "decoders"))]
mod file;
pub mod groups;
pub mod job;
pub mod language;
pub mod link;
pub mod pyramid;
pub mod refusal;
pub mod simulator;
pub mod spectrogram;
pub mod verdict;
pub mod wire;
