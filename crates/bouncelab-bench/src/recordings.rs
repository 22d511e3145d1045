//! Real recordings against themselves: no truth is needed.
//!
//! Without its first k impacts a drop is one from the apex of flight k, which the time of that flight alone tells. The
//! inference from the rest must find it.
//!
//! ```text
//! cargo xtask calibrate recordings FOLDER
//! ```
//!
//! takes the sounds of a folder and its `truth.json`, which names the ball of each.

use std::fs;
use std::path::Path;

use bouncelab::analysis::{Drop, DropTask, analyze_impacts, renumbered};
use bouncelab::settings::Settings;
use bouncelab::{Impact, Options};
use bouncelab_audio::Input;
use rayon::prelude::*;
use serde_json::Value;

use crate::Result;
use crate::held::{Held, cells};

/// Drops of fewer impacts are left alone, and so are the rests of cuts.
const MIN_IMPACTS: usize = 8;
/// Cuts of a drop: later ones begin where impacts are faint.
const MAX_CUTS: usize = 25;

/// The cuts of the drops of a recording.
#[derive(Debug)]
pub struct Cuts {
    /// Name of its file.
    pub name: String,
    /// Whether the drop height of each rest is the apex of the flight before it.
    pub held: Vec<Held>,
}

/// The cuts of the recordings of a folder that have any, in the order of their names.
///
/// # Errors
///
/// If `truth.json` cannot be read, or a recording in it.
pub fn of_folder(folder: &Path) -> Result<Vec<Cuts>> {
    let truth: Value = serde_json::from_slice(&fs::read(folder.join("truth.json"))?)?;
    let recordings = truth["recordings"]
        .as_object()
        .ok_or("truth.json has no recordings")?;
    let mut all = Vec::new();
    for (name, about) in recordings {
        let ball = about["ball"].as_str().unwrap_or_default();
        // A ball that is in no list is not stated.
        let setup = Settings::of_ball(ball)
            .resolve()
            .or_else(|_| Settings::default().resolve())?;
        let held = of_recording(&folder.join(name), &setup.options)?;
        if !held.is_empty() {
            all.push(Cuts {
                name: name.clone(),
                held,
            });
        }
    }
    Ok(all)
}

fn of_recording(path: &Path, options: &Options) -> Result<Vec<Held>> {
    let input = Input::open(path)?;
    let plan = input.plan::<Box<dyn std::error::Error + Send + Sync>>(options, |_| Ok(()))?;
    let drops: Vec<Drop> = plan.tasks().iter().map(DropTask::run).collect();
    let cuts = drops
        .iter()
        .flat_map(|drop| (1..=MAX_CUTS).map(move |cut| (drop, cut)));
    let is_long = |(drop, cut): &(&Drop, usize)| drop.impacts.len() >= MIN_IMPACTS + cut;
    let cuts: Vec<(&Drop, usize)> = cuts.filter(is_long).collect();
    Ok(cuts
        .par_iter()
        .filter_map(|(drop, cut)| of_cut(drop, *cut, options))
        .collect())
}

/// Whether the rest of the drop after the first impacts fell from where the flight before it rose to.
pub(crate) fn of_cut(drop: &Drop, left_out: usize, options: &Options) -> Option<Held> {
    let rest: Vec<Impact> = drop.impacts.get(left_out..)?.to_vec();
    let (before, first) = (drop.impacts.get(left_out - 1)?, rest.first()?);
    let flight = drop.flight(before.number)?;
    if first.number != before.number + 1 {
        return None;
    }
    let posterior = analyze_impacts(renumbered(rest), options).posterior.ok()?;
    // Where times have no stated errors, those of a flight are small beside the scatter of an impact.
    let apex_sd_m = flight.apex_sd_m.unwrap_or(0.0);
    let height_m = &posterior.drop_height_m;
    Some(Held::within(height_m, flight.apex_m?, apex_sd_m))
}

/// `calibrate recordings FOLDER`: prints a row for each recording.
///
/// # Errors
///
/// Those of [`of_folder`], or if no folder is given.
pub(crate) fn run(arguments: &[String]) -> Result {
    let [folder] = arguments else {
        return Err("usage: calibrate recordings FOLDER".into());
    };
    println!("| recording | cuts | % in 68 | % in 95 | rms z | mean error, % | rms error, % |");
    println!("|---|--:|--:|--:|--:|--:|--:|");
    let all = of_folder(Path::new(folder))?;
    for Cuts { name, held } in &all {
        println!("| `{name}` | {} |", cells(held));
    }
    let held: Vec<Held> = all
        .iter()
        .flat_map(|cuts| cuts.held.iter().copied())
        .collect();
    println!("| all | {} |", cells(&held));
    Ok(())
}
