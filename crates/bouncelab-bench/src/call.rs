//! How long a call takes: `cargo run --release -p bouncelab-bench -- call drop.f32 44100 1000 20` analyses the samples of a
//! file, one channel as 32-bit floats, repeated that often with that number of draws, and prints the seconds of each.
//! `crates/bouncelab-python/benchmarks/measure.py` compares them with those of Python.

use std::time::Instant;

use bouncelab::analyze;
use bouncelab::settings::Settings;

use crate::Result;

/// `call FILE SAMPLE_RATE_HZ DRAWS TIMES`: prints the seconds of each call.
///
/// # Errors
///
/// If an argument is missing or invalid, or the file cannot be read or analysed.
pub fn run(arguments: &[String]) -> Result {
    let [file, sample_rate_hz, draws, times] = arguments else {
        return Err("usage: call FILE SAMPLE_RATE_HZ DRAWS TIMES".into());
    };
    let bytes = std::fs::read(file)?;
    let (words, _) = bytes.as_chunks();
    let samples: Vec<f32> = words.iter().map(|&word| f32::from_le_bytes(word)).collect();
    let mut given = Settings::of_ball("table-tennis-40");
    given.inference.draws = Some(draws.parse()?);
    let (options, rate) = (given.resolve()?.options, sample_rate_hz.parse()?);
    for _ in 0..times.parse::<usize>()? {
        let start = Instant::now();
        analyze(&samples, rate, &options)?;
        println!("{}", start.elapsed().as_secs_f64());
    }
    Ok(())
}
