//! Writes the sounds that `tests/fixtures/make.sh` encodes, into the folder given.

#[path = "../tests/clicks/mod.rs"]
mod clicks;

use bouncelab_audio::SampleFormat;
use bouncelab_testkit::write_wav;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args()
        .nth(1)
        .ok_or("usage: fixture_sources FOLDER")?;
    for rate in [4_000, 8_000, 44_100, 48_000] {
        let sound = clicks::signal(rate);
        let path = format!("{folder}/{rate}.wav");
        write_wav(path, rate, SampleFormat::Float32, &[&sound]);
    }
    Ok(())
}
