//! A known drop in every format, damaged at every percent of its length in four ways: how often the
//! result is the undamaged one, has a diagnostic that names the place, is a refusal, or is wrong.
//!
//! `damage [FORMAT] [quick]`; `quick` leaves the inference out.

use std::error::Error;

use bouncelab::Options;
use bouncelab_testkit::damage::{Damage, Verdict, analyse, files, is_warned, judge, words};
use rayon::prelude::*;

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let mut options = Options::default();
    let mut only = None;
    for word in std::env::args().skip(1) {
        match word.as_str() {
            "quick" => options = options.without_inference(),
            _ => only = Some(word),
        }
    }
    println!("| file | damage | right | warned | refused | wrong |\n|---|---|---|---|---|---|");
    for (name, file) in files() {
        if only.as_ref().is_some_and(|only| !name.contains(only)) {
            continue;
        }
        let whole = analyse(&file, &name, &options)?;
        assert!(
            whole.drops.len() == 1 && !is_warned(&whole),
            "{name}: {:?}",
            whole.diagnostics
        );
        for damage in Damage::ALL {
            let places: Vec<usize> = (0..100).collect();
            let verdicts: Vec<Verdict> = places
                .par_iter()
                .map(|&percent| {
                    let damaged = analyse(&damage.at(percent, &file), &name, &options);
                    let verdict = judge(&whole, damaged.as_ref().ok());
                    if verdict == Verdict::Wrong {
                        eprintln!("{name} {damage:?} {percent} %: {}", words(&damaged));
                    }
                    verdict
                })
                .collect();
            let count = |what| verdicts.iter().filter(|&&verdict| verdict == what).count();
            println!(
                "| `{name}` | {} | {} | {} | {} | {} |",
                damage.words(),
                count(Verdict::Right),
                count(Verdict::Warned),
                count(Verdict::Refused),
                count(Verdict::Wrong)
            );
        }
    }
    Ok(())
}
