//! The label track of Audacity (Audacity manual, "Importing and Exporting Labels").

use bouncelab::Recording;

use super::labels;

/// A line for each impact: start and end, which are the same, and the text, separated by tabs.
pub fn audacity(recording: &Recording) -> String {
    let line = |label: super::Label| {
        let super::Label { time_s, text } = label;
        format!("{time_s:.7}\t{time_s:.7}\t{text}\n")
    };
    labels(recording).into_iter().map(line).collect()
}
