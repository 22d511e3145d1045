//! The sounds of the cells as files, with their truth, for other detectors.

use super::drops::cells;
use bouncelab_audio::{SampleFormat, encode_wav};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// Writes `drops` recordings of each cell and `truth.json` beside them.
pub(crate) fn write(folder: &str, drops: u64) -> Result<(), String> {
    let folder = Path::new(folder);
    fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", bouncelab::Plain::path(folder)))?;
    let mut lines = Vec::new();
    for (number, cell) in cells().iter().enumerate() {
        for seed in 0..drops {
            let recording = cell.record(seed);
            let file = format!("{number:02}-{seed:02}.wav");
            let clipped: Vec<f32> = recording
                .sound
                .samples
                .iter()
                .map(|x| x.clamp(-1.0, 1.0))
                .collect();
            fs::write(
                folder.join(&file),
                encode_wav(
                    recording.sound.sample_rate_hz,
                    SampleFormat::Int16,
                    &[&clipped],
                )
                .map_err(|e| e.to_string())?,
            )
            .map_err(|e| e.to_string())?;
            let all = recording.sound.impacts.iter().map(|i| i.time_s);
            let mut line = format!(
                r#"{{"file": "{file}", "group": "{}", "cell": "{}""#,
                cell.group, cell.name
            );
            let times = |times: Vec<f64>| {
                let times: Vec<String> = times.iter().map(|t| format!("{t:.7}")).collect();
                times.join(", ")
            };
            let _ = write!(
                line,
                r#", "impacts_s": [{}], "audible_s": [{}]}}"#,
                times(all.collect()),
                times(recording.audible())
            );
            lines.push(line);
        }
    }
    let truth = format!("[\n{}\n]\n", lines.join(",\n"));
    let path = folder.join("truth.json");
    fs::write(&path, truth).map_err(|e| format!("{}: {e}", bouncelab::Plain::path(&path)))
}
