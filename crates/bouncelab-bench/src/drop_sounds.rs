//! Writes the sounds that `damage/make.sh` of the testkit encodes.

use bouncelab_audio::SampleFormat;
use bouncelab_testkit::{damage, write_wav};

use crate::Result;

/// `drop-sounds FOLDER`: writes a sound for each sample rate.
///
/// # Errors
///
/// If no folder is given.
pub fn run(arguments: &[String]) -> Result {
    let [folder] = arguments else {
        return Err("usage: drop-sounds FOLDER".into());
    };
    for rate_hz in [16_000, 48_000] {
        let drop = damage::drop(rate_hz);
        let path = format!("{folder}/{rate_hz}.wav");
        write_wav(path, rate_hz, SampleFormat::Int16, &[&drop.samples]);
    }
    Ok(())
}
