//! `bouncelab balls`: the balls that can be stated by name.

use bouncelab::ball::{self, Preset};
use bouncelab::settings::BallKind;
use bouncelab_report::{Quantity, Unit};
use clap::Args;

use crate::failure::Failure;
use crate::language::{text_with, translator};
use crate::terminal::print;

/// List the balls that --ball knows: name, mass, diameter, contact time, other words, source
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {}

const EXAMPLES: &str = "\
Examples:
  bouncelab balls
  bouncelab analyze drop.wav --ball \"ping pong\"
  bouncelab analyze drop.wav --ball tennis --mass 58g    drag and contact time stay those of a tennis ball
  bouncelab analyze drop.wav --ball steel:12.7mm         of a solid ball the mass follows";

pub(crate) fn run(_: &Arguments) -> Result<(), Failure> {
    let balls: Vec<String> = ball::presets().iter().map(described).collect();
    print(balls.join("\n"))
}

/// A line of numbers, and below it the other words and the source.
fn described(preset: &Preset) -> String {
    let known = &preset.known;
    let contact_sd_s = known.contact_time_s * known.contact_time_rel_sd;
    let contact = Quantity::measured(known.contact_time_s, contact_sd_s, Unit::Time);
    let ball = translator().ball(&BallKind::Measured(known.ball));
    let contact = contact.text(translator());
    let numbers = [("ball", ball.into()), ("contact", contact.into())];
    let numbers = text_with("balls-numbers", &numbers);
    let mut lines = vec![format!("{:16} {numbers}", preset.name)];
    if !preset.words.is_empty() {
        let words = preset.words.join(", ");
        lines.push(text_with("balls-words", &[("words", words.into())]));
    }
    lines.push(preset.source.to_owned());
    lines.join("\n    ") + "\n"
}
