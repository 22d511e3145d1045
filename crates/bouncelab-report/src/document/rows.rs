//! A result as rows of a table: one for each impact.

use bouncelab::Recording;

/// The columns: `file` and `drop`, the impact as in `bouncelab.analysis/2`, and the flight after it.
pub const HEADER: [&str; 14] = [
    "file",
    "drop",
    "number",
    "time_s",
    "time_sd_s",
    "probability",
    "level_db",
    "impact_speed_m_s",
    "restitution",
    "restitution_sd",
    "flight_time_ratio",
    "flight_time_s",
    "drag_free_height_m",
    "apex_m",
];

/// The rows of a result, each with a cell for each column of [`HEADER`]; an unknown value is
/// empty.
pub fn of(file: &str, recording: &Recording) -> Vec<[String; 14]> {
    let cell = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    let mut rows = Vec::new();
    for (drop, number) in recording.drops.iter().zip(1..) {
        for impact in &drop.impacts {
            let restitution = drop.impact_restitution(impact.number);
            let flight = drop.flight(impact.number);
            rows.push([
                file.to_owned(),
                number.to_string(),
                impact.number.to_string(),
                impact.time_s.to_string(),
                cell(impact.time_sd_s),
                impact.probability.to_string(),
                cell(impact.level_db),
                cell(restitution.map(|known| known.impact_speed_m_s)),
                cell(restitution.map(|known| known.restitution.value)),
                cell(restitution.and_then(|known| known.restitution.known_sd())),
                cell(restitution.map(|known| known.flight_time_ratio)),
                cell(flight.map(|flight| flight.time_s)),
                cell(flight.map(|flight| flight.drag_free_height_m)),
                cell(flight.and_then(|flight| flight.apex_m)),
            ]);
        }
    }
    rows
}
