//! A known drop in every format, damaged at every percent of its length in four ways: how often the
//! result is the undamaged one, has a diagnostic that names the place, is a refusal, or is wrong.
//!
//! `damage [FORMAT] [quick]`; `quick` leaves the inference out.

use std::error::Error;

use bouncelab::diagnostic::Code;
use bouncelab::{Detector, Estimate, Options, Recording};
use bouncelab_audio::Source;
use bouncelab_session::plan_of_sound;
use bouncelab_testkit::damage::{Damage, files};
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
        assert!(whole.drops.len() == 1 && !is_warned(&whole), "{name}: {:?}", whole.diagnostics);
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

#[derive(Clone, Copy, PartialEq)]
enum Verdict {
    Right,
    Warned,
    Refused,
    Wrong,
}

fn analyse(file: &[u8], name: &str, options: &Options) -> Result<Recording, Box<dyn Error + Send + Sync>> {
    let mut source = Source::from_bytes(file, name)?;
    let detector = Detector::new(source.sample_rate_hz(), source.channels());
    Ok(plan_of_sound(&mut source, detector, options, |_| ())?.run())
}

fn judge(whole: &Recording, damaged: Option<&Recording>) -> Verdict {
    let Some(damaged) = damaged.filter(|it| it.no_drop.is_none()) else {
        return Verdict::Refused;
    };
    if agree(whole, damaged) {
        Verdict::Right
    } else if is_warned(damaged) {
        Verdict::Warned
    } else {
        Verdict::Wrong
    }
}

/// Whether every answer is within the uncertainties of the damaged one.
fn agree(whole: &Recording, damaged: &Recording) -> bool {
    let (whole, damaged) = (numbers(whole), numbers(damaged));
    let within = |(of_whole, of_damaged): (&Estimate, &Estimate)| {
        (of_damaged.value - of_whole.value).abs() <= 2.0 * of_damaged.sd
    };
    whole.len() == damaged.len() && whole.iter().zip(&damaged).all(within)
}

/// What is said of all drops.
fn numbers(recording: &Recording) -> Vec<Estimate> {
    let of_drop = recording.drops.iter().flat_map(|drop| match (&drop.posterior, &drop.log_linear_fit) {
        (Ok(posterior), _) => vec![
            posterior.restitution,
            posterior.drop_height_m,
            posterior.total_time_s.unwrap_or(posterior.gravity_m_s2),
        ],
        (_, Ok(fit)) => vec![fit.restitution, fit.drop_height_m, fit.total_time_s.unwrap_or(fit.drop_height_m)],
        _ => Vec::new(),
    });
    of_drop.collect()
}

fn words<E>(recording: &Result<Recording, E>) -> String {
    let numbers = recording.as_ref().map_or_else(|_| Vec::new(), numbers);
    let words = numbers.iter().map(|it| format!("{:.4} ± {:.4}", it.value, it.sd));
    words.collect::<Vec<_>>().join(", ")
}

/// Whether a diagnostic names the place of the damage.
fn is_warned(recording: &Recording) -> bool {
    recording.diagnostics.iter().any(|known| {
        matches!(known.code, Code::FileTruncated | Code::SoundMissing | Code::ClockLost | Code::SoundLost)
    })
}
