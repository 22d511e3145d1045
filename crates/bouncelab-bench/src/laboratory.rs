//! Makes recordings of ten seconds with known truth, to measure sessions with: `cargo xtask laboratory FOLDER COUNT`.

use std::path::PathBuf;

use bouncelab_testkit::laboratory::Truth;

use crate::Result;

const BALLS: [&str; 4] = ["amber", "blue", "cyan", "dun"];
const SURFACES: [&str; 3] = ["steel", "stone", "wood"];
const HEIGHTS_CM: [usize; 5] = [20, 30, 45, 70, 100];
/// With the drop it makes about ten seconds.
const LEAD_IN_S: f64 = 4.5;

/// `laboratory FOLDER COUNT`: writes the recordings.
///
/// # Errors
///
/// If an argument is missing or the folder cannot be made.
pub fn run(arguments: &[String]) -> Result {
    let [folder, count] = arguments else {
        return Err("usage: laboratory FOLDER COUNT".into());
    };
    let (folder, count) = (PathBuf::from(folder), count.parse::<usize>()?);
    std::fs::create_dir_all(&folder)?;
    for number in 0..count {
        let (ball, surface) = (number % 4, number / 4 % 3);
        let height_cm = HEIGHTS_CM[number / 12 % 5];
        let truth = Truth {
            restitution: 0.93 - 0.01 * ball as f64 - 0.02 * surface as f64,
            exponent: 0.01,
            between_drops: 0.0015,
            between_impacts: 0.003,
        };
        let (ball, surface) = (BALLS[ball], SURFACES[surface]);
        let name = format!("{ball}_{surface}_{height_cm}cm_{number:05}.wav");
        truth.record(
            &folder.join(name),
            height_cm as f64 / 100.0,
            LEAD_IN_S,
            number as u64 + 1,
        );
    }
    Ok(())
}
