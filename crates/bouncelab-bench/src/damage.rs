//! A known drop in every format, damaged at every percent of its length, and in every byte of its header: how often the
//! result is the undamaged one, has a diagnostic that names the damage, is a refusal, or is wrong.
//!
//! `damage [FORMAT] [quick] [step=N]`; `quick` leaves the inference out, `step` takes every Nth place. On stderr are the
//! cases that are wrong, and those whose only warning is that all of the sound is in doubt.

use bouncelab::diagnostic::Code;
use bouncelab::{Options, Recording};
use bouncelab_testkit::damage::{Damage, Verdict, analyse, files, is_warned, judge, words};
use rayon::prelude::*;

use crate::Result;

/// In the order of the columns.
const VERDICTS: [Verdict; 4] = [
    Verdict::Right,
    Verdict::Warned,
    Verdict::Refused,
    Verdict::Wrong,
];

/// `damage [FORMAT] [quick] [step=N]`: prints the table.
///
/// # Errors
///
/// If an undamaged file cannot be analysed, or the step is no number.
///
/// # Panics
///
/// If an undamaged file has no drop or a warning.
pub fn run(arguments: &[String]) -> Result {
    let mut options = Options::default();
    let (mut only, mut step) = (None, 1);
    for word in arguments {
        match word.split_once('=') {
            Some(("step", number)) => step = number.parse::<usize>()?.max(1),
            _ if word == "quick" => options = options.without_inference(),
            _ => only = Some(word),
        }
    }
    println!("| file | {} |", Damage::ALL.map(Damage::words).join(" | "));
    println!("|---|{}", "---|".repeat(Damage::ALL.len()));
    let mut sums = [[0; 4]; Damage::ALL.len()];
    for (name, file) in files() {
        if only.is_some_and(|only: &String| !name.contains(only.as_str())) {
            continue;
        }
        let whole = analyse(&file, &name, &options)?;
        assert!(
            whole.drops.len() == 1 && !is_warned(&whole),
            "{name}: {:?}",
            whole.diagnostics
        );
        let row = Damage::ALL.map(|damage| {
            let places: Vec<usize> = (0..damage.places(&file)).step_by(step).collect();
            let judged = |&place: &usize| {
                let damaged = damage.at(place, &file);
                // It has no such part.
                if damaged == file {
                    return None;
                }
                let damaged = analyse(&damaged, &name, &options);
                let verdict = judge(&whole, damaged.as_ref().ok());
                let all_in_doubt = damaged.as_ref().is_ok_and(is_all_in_doubt);
                if verdict == Verdict::Wrong || verdict == Verdict::Warned && all_in_doubt {
                    let numbers = words(&damaged);
                    eprintln!("{verdict:?}: {name} {damage:?} {place}: {numbers}");
                }
                Some(verdict)
            };
            let verdicts: Vec<Verdict> = places.par_iter().filter_map(judged).collect();
            VERDICTS.map(|it| verdicts.iter().filter(|&&verdict| verdict == it).count())
        });
        for (sum, count) in sums.iter_mut().flatten().zip(row.iter().flatten()) {
            *sum += count;
        }
        println!("| `{name}` | {} |", cells(&row));
    }
    println!("| all | {} |", cells(&sums));
    Ok(())
}

/// Numbers of cases that are right, warned of, refused and wrong, for each damage.
fn cells(row: &[[usize; 4]; Damage::ALL.len()]) -> String {
    row.map(|counts| counts.map(|count| count.to_string()).join(" · "))
        .join(" | ")
}

/// Whether what is said of the file names no place but all of it.
fn is_all_in_doubt(recording: &Recording) -> bool {
    let is = |code| recording.diagnostics.iter().any(|it| it.code == code);
    is(Code::ChecksumWrong) && !is(Code::SoundMissing) && !is(Code::ClockLost)
}
