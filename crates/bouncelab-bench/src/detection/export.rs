//! The sounds of the cells as files, with their truth, for other detectors.

use super::drops::cells;
use bouncelab_audio::{SampleFormat, encode_wav};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Writes `drops` recordings of each cell and `truth.json` beside them.
pub(crate) fn write(folder: &str, drops: u64) -> Result<(), String> {
    let folder = Path::new(folder);
    fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", bouncelab::Plain::path(folder)))?;
    let mut truth = Vec::new();
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
            let impacts = recording.sound.impacts.iter().map(|it| it.time_s);
            truth.push(json!({
                "file": file,
                "group": cell.group,
                "cell": cell.name,
                "impacts_s": impacts.collect::<Vec<f64>>(),
                "audible_s": recording.audible(),
            }));
        }
    }
    let truth = Value::from(truth).to_string();
    let path = folder.join("truth.json");
    fs::write(&path, truth).map_err(|e| format!("{}: {e}", bouncelab::Plain::path(&path)))
}
