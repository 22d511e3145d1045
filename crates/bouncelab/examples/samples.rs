//! A file of samples becomes a result: `cargo run --release --example samples -- drop.f32 48000`.
//!
//! The file holds one channel as 32-bit floats (`ffmpeg -i drop.m4a -ac 1 -ar 48000 -f f32le drop.f32`).
//! Without a file it analyses a synthesised drop, from 30.5 cm with e = 0.9529.

#![expect(clippy::print_stdout, reason = "it prints for contributors")]

use std::error::Error;

use bouncelab::{Options, analyze, demo};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (samples, sample_rate_hz, options) = match (arguments.next(), arguments.next()) {
        (Some(file), Some(rate)) => (read(&file)?, rate.parse()?, Options::default()),
        (None, None) => {
            let sound = demo::sound(&demo::history()?, 1)?;
            (
                sound.samples,
                sound.sample_rate_hz,
                demo::settings().resolve()?.options,
            )
        }
        _ => return Err("usage: samples [FILE SAMPLE_RATE_HZ]".into()),
    };

    let result = analyze(&samples, sample_rate_hz, &options)?;
    if let Some(reason) = &result.no_drop {
        println!("no drop: {}", reason.code.name());
    }
    for drop in &result.drops {
        println!(
            "{} impacts, a drop with probability {:.3}",
            drop.impacts.len(),
            drop.probability
        );
        let line = drop.log_linear_fit.clone()?;
        println!("log-linear fit e = {:.4}", line.restitution.value);
        let posterior = drop.posterior.clone()?;
        let (e, height_m) = (posterior.restitution, posterior.drop_height_m);
        println!("posterior      e = {:.4} ± {:.4}", e.value, e.sd);
        println!(
            "              h0 = {:.3} ± {:.3} m",
            height_m.value, height_m.sd
        );
    }
    Ok(())
}

fn read(file: &str) -> std::io::Result<Vec<f32>> {
    let bytes = std::fs::read(file)?;
    let (words, _) = bytes.as_chunks();
    Ok(words.iter().map(|&word| f32::from_le_bytes(word)).collect())
}
