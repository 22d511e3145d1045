//! Writes the sounds that `damage/make.sh` encodes, into the folder given.

use std::fs;

use bouncelab_audio::{SampleFormat, encode_wav};
use bouncelab_testkit::damage;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: drop_sounds FOLDER")?;
    for rate_hz in [16_000, 48_000] {
        let drop = damage::drop(rate_hz);
        let path = format!("{folder}/{rate_hz}.wav");
        fs::write(
            path,
            encode_wav(rate_hz, SampleFormat::Int16, &[&drop.samples])?,
        )?;
    }
    Ok(())
}
