//! bouncelab for the browser: the laboratory's engine.
//!
//! The page never sees this crate: a worker does, and hands on what a page asks for. What is asked
//! and answered is plain data: the result types of the science, and [`wire`]. The example
//! `types` writes them as types of TypeScript. The modules answer in Rust, so that they are tested like everything
//! else; `engine` and `decoders`, which exist on wasm only, turn their answers into JSON and arrays.
//!
//! It is compiled twice, with the feature `engine` and with the feature `decoders`: nearly half of it
//! all are decoders, which a page needs only once a file is opened.
//!
//! | module | question it answers |
//! |---|---|
//! | [`wire`] | what does the page ask, and what is answered besides results? |
//! | [`refusal`] | why was it not done? |
//! | [`catalogue`] | what is there to choose from? |
//! | [`pyramid`] | how loud is it, at any zoom? |
//! | [`spectrogram`] | how does the energy lie over time and frequency? |
//! | [`detector`] | which drops are in a recording? |
//! | [`analyst`] | what do the impacts say? |
//! | [`simulator`] | what would a drop do, and how would it sound? |

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
pub mod pyramid;
pub mod refusal;
pub mod simulator;
pub mod spectrogram;
pub mod wire;
