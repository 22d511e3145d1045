//! Writes the sounds that `damage/make.sh` encodes, into the folder given.

use bouncelab_audio::SampleFormat;
use bouncelab_testkit::{damage, write_wav};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: drop_sounds FOLDER")?;
    for rate_hz in [16_000, 48_000] {
        let drop = damage::drop(rate_hz);
        let path = format!("{folder}/{rate_hz}.wav");
        write_wav(path, rate_hz, SampleFormat::Int16, &[&drop.samples]);
    }
    Ok(())
}
