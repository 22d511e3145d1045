//! The measuring programs of the project, a module each, and what they share; `cargo xtask help` lists them.
//!
//! Most print a table of the documents. Every drop and every sound comes from a seed, so the same command
//! prints the same numbers.

#![expect(
    clippy::print_stderr,
    clippy::print_stdout,
    reason = "it prints for contributors"
)]

pub mod balls;
pub mod calibration;
pub mod call;
pub mod damage;
pub mod detection;
pub mod drop_sounds;
pub mod held;
mod independent;
pub mod laboratory;
pub mod misfit;
pub mod net;
pub mod recordings;
pub mod scenario;
pub mod sessions;
pub mod stated;
mod tape;
pub mod verdicts;

use bouncelab::inference::{InferenceOptions, SamplerConfig};
use rayon::prelude::*;

/// The result of a program; an error is what it refuses or could not do, to be printed.
pub type Result<T = ()> = std::result::Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// The default inference with random numbers of this seed.
fn seeded(seed: u64) -> InferenceOptions {
    InferenceOptions {
        sampler: SamplerConfig {
            seed,
            ..SamplerConfig::default()
        },
        ..InferenceOptions::default()
    }
}

/// The results of the first seeds that have one, in equal parts on all cores.
pub fn of_seeds<T: Send>(count: usize, result: impl Fn(u64) -> Option<T> + Sync) -> Vec<T> {
    let cores = rayon::current_num_threads();
    let parts = (0..cores).into_par_iter().map(|core| {
        let seeds = (core as u64..).step_by(cores);
        let results = seeds.filter_map(&result);
        results.take(count.div_ceil(cores)).collect::<Vec<T>>()
    });
    parts.flatten_iter().collect()
}
