//! The motion of the ball for Tracker, the video analysis of Open Source Physics.

use bouncelab::{Options, Recording};

use crate::csv::line;

/// The columns, by the names that Tracker takes for data of a track: time in s, position in m.
const HEADER: [&str; 3] = ["t", "x", "y"];

/// A row for each of some points along every flight: the height of the ball by the flight model as `y`, and `x`, which
/// is zero. Without a corrected restitution there is no row.
pub fn tracker(recording: &Recording, settings: &Options) -> String {
    let curves = recording
        .drops
        .iter()
        .flat_map(|drop| drop.height_history(settings).points);
    // What is no number separates flights, where Tracker has nothing.
    let known = curves.filter(|[_, height_m]| height_m.is_finite());
    let rows = known.map(|[time_s, height_m]| {
        line(&[
            format!("{time_s:.6}"),
            "0".to_owned(),
            format!("{height_m:.6}"),
        ])
    });
    std::iter::once(line(&HEADER)).chain(rows).collect()
}
