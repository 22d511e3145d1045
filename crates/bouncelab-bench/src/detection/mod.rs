//! Detection benchmark on sounds with known truth: `cargo xtask detection [PART...]`.
//!
//! Parts: `cells` (impacts found, false drops, by what disturbs), `timing` (errors of the times
//! against the Cramer-Rao bound and against the stated standard errors), `silence` (false drops in
//! sound without a drop), which with `cells` also prints how many of the drops of each stated
//! probability are real, `steady` (sounds of a steady rate, alone and with a drop). None means all. `drops=N` drops in each cell, `hours=H` of sound without
//! a drop of each kind, `only=WORDS` the rows of silence with these words in their names.
//! `wav=FOLDER` writes the sounds of the cells and their truth instead.
//!
//! Every sound comes from a seed: the same command prints the same numbers.

mod backgrounds;
mod cells;
mod drops;
mod export;
mod recorder;
mod reliability;
mod silence;
mod steady;
mod timing;

use crate::Result;

/// What was asked for.
struct Request {
    parts: Vec<String>,
    drops: u64,
    hours: f64,
    only: String,
    wav: Option<String>,
}

/// `detection [PART...] [drops=20] [hours=1] [only=SOUND] [wav=FOLDER]`: prints the tables.
///
/// # Errors
///
/// If an argument is unknown, or sounds cannot be written.
pub fn run(arguments: &[String]) -> Result {
    let request = parse(arguments).map_err(|argument| {
        format!(
            "unknown argument '{argument}'; known are cells, timing, silence, steady, drops=N, hours=H, only=WORDS, wav=FOLDER"
        )
    })?;
    if let Some(folder) = &request.wav {
        return Ok(export::write(folder, request.drops)?);
    }
    let asked = |part: &str| request.parts.is_empty() || request.parts.iter().any(|p| p == part);
    if asked("cells") {
        cells::print(request.drops);
    }
    if asked("timing") {
        timing::print(request.drops);
    }
    if asked("silence") {
        silence::print(request.hours, &request.only);
    }
    if asked("steady") {
        steady::print();
    }
    Ok(())
}

fn parse(arguments: &[String]) -> std::result::Result<Request, String> {
    let mut request = Request {
        parts: Vec::new(),
        drops: 20,
        hours: 1.0,
        only: String::new(),
        wav: None,
    };
    for word in arguments {
        match word.split_once('=') {
            None if ["cells", "timing", "silence", "steady"].contains(&word.as_str()) => {
                request.parts.push(word.clone());
            }
            Some(("drops", n)) => request.drops = n.parse().map_err(|_| word.clone())?,
            Some(("hours", h)) => request.hours = h.parse().map_err(|_| word.clone())?,
            Some(("only", words)) => request.only = words.into(),
            Some(("wav", folder)) => request.wav = Some(folder.into()),
            _ => return Err(word.clone()),
        }
    }
    Ok(request)
}
