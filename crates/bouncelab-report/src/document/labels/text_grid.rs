//! The `TextGrid` of Praat (Praat manual, "`TextGrid` file formats").

use std::fmt::Write;

use bouncelab::Recording;
use bouncelab::analysis::Source;

use super::labels;

/// One point tier, `impacts`, in the long format.
pub fn text_grid(recording: &Recording) -> String {
    let labels = labels(recording);
    let times = || labels.iter().map(|label| label.time_s);
    let first_s = times().fold(0.0, f64::min);
    let end_s = match recording.source {
        Source::Sound { duration_s, .. } => duration_s,
        Source::Times(_) => first_s,
    };
    let end_s = times().fold(end_s, f64::max);
    let mut text = format!(
        "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\n\
         xmin = {first_s}\nxmax = {end_s}\ntiers? <exists>\nsize = 1\nitem []:\n    item [1]:\n        \
         class = \"TextTier\"\n        name = \"impacts\"\n        \
         xmin = {first_s}\n        xmax = {end_s}\n        points: size = {}\n",
        labels.len()
    );
    for (label, number) in labels.iter().zip(1..) {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "        points [{number}]:\n            number = {}\n            mark = \"{}\"",
            label.time_s, label.text
        );
    }
    text
}
