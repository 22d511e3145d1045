//! Makes recordings of ten seconds with known truth, to measure sessions with:
//! `cargo run --release -p bouncelab-cli --example laboratory -- FOLDER COUNT`.

#![expect(clippy::print_stderr, reason = "it prints for contributors")]

use std::path::PathBuf;

#[path = "../tests/laboratory/world.rs"]
mod world;

use world::Truth;

const BALLS: [&str; 4] = ["amber", "blue", "cyan", "dun"];
const SURFACES: [&str; 3] = ["steel", "stone", "wood"];
const HEIGHTS_CM: [usize; 5] = [20, 30, 45, 70, 100];
/// With the drop it makes about ten seconds.
const LEAD_IN_S: f64 = 4.5;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let (Some(folder), Some(count)) = (arguments.next(), arguments.next()) else {
        eprintln!("usage: laboratory FOLDER COUNT");
        std::process::exit(2);
    };
    let folder = PathBuf::from(folder);
    let count: usize = count.parse().expect("a number of recordings");
    std::fs::create_dir_all(&folder).expect("a folder to write into");
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
}
