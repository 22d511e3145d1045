//! A known drop in every format, damaged at every percent of its length in four ways: how often the
//! result is the undamaged one, has a diagnostic that names the place, is a refusal, or is wrong.
//!
//! `damage [FORMAT] [quick]`; `quick` leaves the inference out. On stderr are the cases that are wrong, and those
//! whose only warning is that all of the sound is in doubt.

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

/// `damage [FORMAT] [quick]`: prints the table.
///
/// # Errors
///
/// If an undamaged file cannot be analysed.
///
/// # Panics
///
/// If an undamaged file has no drop or a warning.
pub fn run(arguments: &[String]) -> Result {
    let mut options = Options::default();
    let mut only = None;
    for word in arguments {
        match word.as_str() {
            "quick" => options = options.without_inference(),
            _ => only = Some(word),
        }
    }
    let damages = Damage::ALL.map(Damage::words).join(" | ");
    println!("| file | {damages} |\n|---|{}", "---|".repeat(4));
    let mut sums = [[0; 4]; 4];
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
        let mut row = [[0; 4]; 4];
        for ((damage, counts), sums) in Damage::ALL.into_iter().zip(&mut row).zip(&mut sums) {
            let places: Vec<usize> = (0..100).collect();
            let judged = |&percent: &usize| {
                let damaged = analyse(&damage.at(percent, &file), &name, &options);
                let verdict = judge(&whole, damaged.as_ref().ok());
                let all_in_doubt = damaged.as_ref().is_ok_and(is_all_in_doubt);
                if verdict == Verdict::Wrong || verdict == Verdict::Warned && all_in_doubt {
                    let numbers = words(&damaged);
                    eprintln!("{verdict:?}: {name} {damage:?} {percent} %: {numbers}");
                }
                verdict
            };
            let verdicts: Vec<Verdict> = places.par_iter().map(judged).collect();
            *counts = VERDICTS.map(|it| verdicts.iter().filter(|&&verdict| verdict == it).count());
            for (sum, count) in sums.iter_mut().zip(counts) {
                *sum += *count;
            }
        }
        println!("| `{name}` | {} |", cells(row));
    }
    println!("| all | {} |", cells(sums));
    Ok(())
}

/// Numbers of cases that are right, warned of, refused and wrong, for each damage.
fn cells(row: [[usize; 4]; 4]) -> String {
    row.map(|counts| counts.map(|count| count.to_string()).join(" · "))
        .join(" | ")
}

/// Whether what is said of the file names no place but all of it.
fn is_all_in_doubt(recording: &Recording) -> bool {
    let is = |code| recording.diagnostics.iter().any(|it| it.code == code);
    is(Code::ChecksumWrong) && !is(Code::SoundMissing) && !is(Code::ClockLost)
}
