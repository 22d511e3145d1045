//! Samples as they come, and what they say so far: `cargo run --release --example stream`.
//!
//! A synthesised drop arrives in blocks of half a second, as a microphone would hand them over.

#![expect(clippy::print_stdout, reason = "it prints for contributors")]

use bouncelab::analysis::Plan;
use bouncelab::{Detector, Result, demo};

fn main() -> Result<()> {
    let sound = demo::sound(&demo::history()?, 1)?;
    let mut detector = Detector::new(sound.sample_rate_hz, 1);
    let mut seconds = 0.0;
    for block in sound.samples.chunks(sound.sample_rate_hz as usize / 2) {
        detector.push(&[block]);
        seconds += 0.5;
        let trains = detector.so_far().found.trains;
        let impacts = trains.last().map_or(0, |train| train.impacts().len());
        println!("{seconds:4.1} s: {impacts} impacts so far");
    }

    let plan = Plan::of_detection(detector.finish(), &demo::settings().resolve()?.options);
    for drop in plan.run().drops {
        let restitution = drop.posterior?.restitution;
        println!("e = {:.4} ± {:.4}", restitution.value, restitution.sd);
    }
    Ok(())
}
