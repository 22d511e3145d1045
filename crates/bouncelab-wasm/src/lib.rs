//! bouncelab for the browser: the laboratory's engine.
//!
//! The page never sees this crate: a worker does, and hands on what a page asks for. What is asked
//! and answered is plain data ([`wire`]), of which `web/src/lab/types.ts` is made. The rooms answer
//! in Rust, so that they are tested like everything else; `engine` and `decoders`, which exist on
//! wasm only, turn their answers into JSON and arrays.
//!
//! It is compiled twice, with the feature `engine` and with the feature `decoders`: nearly half of it
//! all are decoders, which a page needs only once a file is opened.
//!
//! | room | question it answers |
//! |---|---|
//! | [`wire`] | what does the page ask, and what is it told? |
//! | [`refusal`] | why was it not done? |
//! | `settings` | what does the page state, in the words of the science? |
//! | [`catalogue`] | what is there to choose from? |
//! | [`pyramid`] | how loud is it, at any zoom? |
//! | [`spectrogram`] | how does the energy lie over time and frequency? |
//! | [`sound`] | what is heard in it? |
//! | [`analyst`] | what do the impacts say? |
//! | [`simulator`] | what would a drop do, and how would it sound? |

pub mod analyst;
pub mod catalogue;
#[cfg(all(target_family = "wasm", feature = "decoders"))]
pub mod decoders;
#[cfg(all(target_family = "wasm", feature = "engine"))]
pub mod engine;
pub mod pyramid;
pub mod refusal;
mod settings;
pub mod simulator;
pub mod sound;
pub mod spectrogram;
pub mod wire;
