//! An analysis as rows of a table: one for each impact, from the JSON document.

use serde_json::Value;

use super::Document;

/// The columns: `file` and `drop`, then the fields of an impact in `bouncelab.analysis/1`, then
/// those of the flight after it.
pub const HEADER: [&str; 14] = [
    "file",
    "drop",
    "number",
    "time_s",
    "sigma_s",
    "probability",
    "level_db",
    "impact_speed_m_s",
    "restitution",
    "restitution_sd",
    "plain_restitution",
    "flight_time_s",
    "plain_height_m",
    "apex_m",
];

/// The rows of a document, each with a cell for each column of [`HEADER`]; what cannot be told is
/// empty.
pub fn of(document: &Document) -> Vec<Vec<String>> {
    let document = serde_json::to_value(document).unwrap_or(Value::Null);
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let mut rows = Vec::new();
    for (drop, number) in list(&document["drops"]).iter().zip(1..) {
        let flights = list(&drop["flights"]);
        for impact in list(&drop["impacts"]) {
            let none = Value::Null;
            let flight = flights
                .iter()
                .find(|flight| flight["number"] == impact["number"]);
            let flight = flight.unwrap_or(&none);
            let mut row = vec![cell(&document["file"]), number.to_string()];
            row.extend(HEADER[2..11].iter().map(|column| cell(&impact[*column])));
            row.extend(["time_s", "plain_height_m", "apex_m"].map(|column| cell(&flight[column])));
            rows.push(row);
        }
    }
    rows
}

fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}
