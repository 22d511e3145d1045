//! Impacts as labels of programs that show sound.
//!
//! The text of a label is the number of the impact, with that of the drop before it where there are several ("2:5"),
//! and a question mark where the impact is uncertain. `bouncelab_audio::times` reads both formats.
//!
//! ```
//! use bouncelab::{Options, analyze_times};
//! use bouncelab_report::document::labels;
//!
//! let result = analyze_times(&[0.1, 0.5605, 0.9877, 1.3854], &Options::default().without_inference());
//! assert!(labels::audacity(&result).starts_with("0.1000000\t0.1000000\t1\n"));
//! assert!(labels::text_grid(&result).contains("\"impacts\""));
//! ```

mod audacity;
mod text_grid;

use bouncelab::Recording;
use bouncelab::analysis::CONFIDENT_PROBABILITY;

pub use audacity::audacity;
pub use text_grid::text_grid;

/// An impact as a label.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// Its time in s, in that of the recording.
    pub time_s: f64,
    /// Its text.
    pub text: String,
}

/// The impacts of all drops in order of time.
pub fn labels(recording: &Recording) -> Vec<Label> {
    let is_single = recording.drops.len() == 1;
    let drops = recording.drops.iter().zip(1..);
    drops
        .flat_map(|(drop, number)| drop.impacts.iter().map(move |impact| (number, impact)))
        .map(|(drop, impact)| {
            let number = if is_single {
                impact.number.to_string()
            } else {
                format!("{drop}:{}", impact.number)
            };
            let is_certain = impact.probability >= CONFIDENT_PROBABILITY;
            Label {
                time_s: impact.time_s,
                text: number + if is_certain { "" } else { "?" },
            }
        })
        .collect()
}
