//! A drop that the page judges.

use bouncelab::Impact;
use bouncelab::analysis::{ListOrigin, Source};
use bouncelab_wasm::wire::{DropMarks, JudgedPlace};

/// A drop of nine impacts without air, by this name, whose first rebound is this high: h = g T²/8.
pub(crate) fn place(name: &str, rebound_m: f64, restitution: f64) -> JudgedPlace {
    let first_s = (8.0 * rebound_m / 9.806_65).sqrt();
    let times_s = (0..9).scan((0.5, first_s), |(time_s, flight_s), _| {
        let now_s = *time_s;
        *time_s += *flight_s;
        *flight_s *= restitution;
        Some(now_s)
    });
    let impacts = (1..)
        .zip(times_s)
        .map(|(number, time_s)| Impact::new(number, time_s).with_time_sd_s(2e-5));
    JudgedPlace {
        name: name.to_owned(),
        source: Source::Times(ListOrigin::default()),
        drops: vec![DropMarks {
            impacts: impacts.collect(),
            probability: 1.0,
            edited: false,
        }],
    }
}
