//! Whether the result of a damaged file is right, warned of, refused or wrong.

use std::error::Error;

use bouncelab::diagnostic::Code;
use bouncelab::{Estimate, Options, Recording};
use bouncelab_audio::Input;

/// What a result is worth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// The undamaged one within its uncertainties.
    Right,
    /// Another one, with a diagnostic that names the place.
    Warned,
    /// None.
    Refused,
    /// Another one, as if nothing were.
    Wrong,
}

/// What the file says.
///
/// # Errors
/// What keeps the file from being read.
pub fn analyse(
    file: &[u8],
    name: &str,
    options: &Options,
) -> Result<Recording, Box<dyn Error + Send + Sync>> {
    let input = Input::from_bytes(file, name)?;
    let plan = input.plan::<Box<dyn Error + Send + Sync>>(options, |_| Ok(()))?;
    Ok(plan.run())
}

/// What the result of a damaged file is worth, given that of the whole one.
pub fn judge(whole: &Recording, damaged: Option<&Recording>) -> Verdict {
    let is_answer = |it: &&Recording| it.no_drop.is_none() && !numbers(it).is_empty();
    let Some(damaged) = damaged.filter(is_answer) else {
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

/// Whether every answer is within three standard uncertainties of the damaged one, or is not given any more: of fewer
/// impacts it may not be known whether the ball rests.
fn agree(whole: &Recording, damaged: &Recording) -> bool {
    let (whole, damaged) = (numbers(whole), numbers(damaged));
    let within = |pair: (&Option<Estimate>, &Option<Estimate>)| match pair {
        (Some(whole), Some(damaged)) => (damaged.value - whole.value).abs() <= 3.0 * damaged.sd,
        (_, damaged) => damaged.is_none(),
    };
    // Of two files that were joined the drop is there twice.
    damaged.len().is_multiple_of(whole.len()) && whole.iter().cycle().zip(&damaged).all(within)
}

/// The estimates of all drops that are compared.
fn numbers(recording: &Recording) -> Vec<Option<Estimate>> {
    let of_drop =
        recording
            .drops
            .iter()
            .flat_map(|drop| match (&drop.posterior, &drop.log_linear_fit) {
                (Ok(posterior), _) => vec![
                    Some(posterior.restitution),
                    Some(posterior.drop_height_m),
                    posterior.total_time_s,
                ],
                (_, Ok(fit)) => vec![
                    Some(fit.restitution),
                    Some(fit.drop_height_m),
                    fit.total_time_s,
                ],
                _ => Vec::new(),
            });
    of_drop.collect()
}

/// The numbers in words.
pub fn words<E>(recording: &Result<Recording, E>) -> String {
    let numbers = recording.as_ref().map_or_else(|_| Vec::new(), numbers);
    let words = numbers
        .iter()
        .flatten()
        .map(|it| format!("{:.4} ± {:.4}", it.value, it.sd));
    words.collect::<Vec<_>>().join(", ")
}

/// Whether a diagnostic names the place of the damage. That may be all of the sound, if it says that the results may be
/// wrong and that impacts anywhere in it may be missing, moved or added.
pub fn is_warned(recording: &Recording) -> bool {
    recording.diagnostics.iter().any(|known| {
        matches!(
            known.code,
            Code::FileTruncated
                | Code::SoundMissing
                | Code::ClockLost
                | Code::SoundBlank
                | Code::BitsFlipped
                | Code::SamplesNotFinite
                | Code::ChecksumWrong
                | Code::RateInDoubt
                | Code::FormatChanges
                | Code::EarlierImpact
        )
    })
}
