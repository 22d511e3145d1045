//! `bouncelab paper`: every number and figure of the paper, computed again.
//!
//! The paper is M. Nagurka, "Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment".

use std::path::PathBuf;

use bouncelab_report::paper::{self, Chapter, Document, Explanation, Fact};
use bouncelab_report::tables::restitution_law;
use bouncelab_report::{Align, Table, save};
use clap::{Args, ValueEnum};

use crate::failure::Failure;
use crate::language::{text, translator};
use crate::report::{OutputArguments, wrote_figure};
use crate::terminal::{print, print_json};

/// Recompute every number and figure of the paper, with further results
///
/// The paper is M. Nagurka, "Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment".
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Folder for the paper's Figs. 2, 4, 5, 6, 7 and 8, as SVG, PNG, PDF and CSV
    #[arg(long, value_name = "DIR", default_value = "bouncelab-paper")]
    figures: PathBuf,
    /// Write no figures
    #[arg(long, conflicts_with = "figures")]
    no_figures: bool,
    /// How to print the numbers; JSON is documented in docs/json.md
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    outputs: OutputArguments,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab paper
  bouncelab paper --figures /tmp/paper
  bouncelab paper --no-figures --format json";

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// For programs
    Json,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let chapters = paper::chapters()?;
    let explanations = paper::explanations()?;
    match arguments.format {
        Format::Text => {
            let (numbers, puzzle) = (numbers(&chapters), puzzle(&explanations));
            print(format_args!("{numbers}\n{puzzle}"))?;
        }
        Format::Json => {
            print_json(&Document::new(&chapters, explanations, translator()))?;
        }
    }
    if arguments.no_figures {
        return Ok(());
    }
    let outputs = arguments.outputs.of_no_input();
    for (name, figure) in paper::figures(translator())? {
        let saved = save(&figure, &arguments.figures, name, &outputs)?;
        wrote_figure(&saved);
    }
    Ok(())
}

fn numbers(chapters: &[Chapter]) -> String {
    let parts: Vec<String> = chapters
        .iter()
        .map(|chapter| {
            format!(
                "{}\n\n{}",
                chapter.title(translator()),
                table(&chapter.facts)
            )
        })
        .collect();
    parts.join("\n")
}

fn table(facts: &[Fact]) -> Table {
    let translator = translator();
    let mut table = Table::with_headings(
        translator,
        [
            ("puzzle-quantity", Align::Left),
            ("puzzle-printed", Align::Right),
            ("puzzle-computed", Align::Right),
            ("", Align::Left),
            ("puzzle-verdict", Align::Left),
            ("", Align::Left),
        ],
    );
    for fact in facts {
        table.row([
            fact.quantity(translator),
            translator.number(fact.printed.unwrap_or("-")),
            translator.number(&fact.shown()),
            fact.unit.to_owned(),
            fact.verdict().text(translator),
            fact.note(translator).unwrap_or_default(),
        ]);
    }
    table
}

/// The puzzle and its possible explanations.
fn puzzle(explanations: &[Explanation]) -> String {
    let translator = translator();
    let mut table = Table::with_headings(
        translator,
        [
            ("quantity-restitution", Align::Left),
            ("column-drag", Align::Left),
            ("puzzle-flights", Align::Right),
            ("puzzle-first", Align::Right),
            ("puzzle-slow", Align::Right),
            ("puzzle-height", Align::Right),
            ("puzzle-solved", Align::Left),
        ],
    );
    for explanation in explanations {
        let solved = if explanation.reproduces {
            "puzzle-yes"
        } else {
            "puzzle-no"
        };
        table.row([
            restitution_law(explanation.restitution_law, translator),
            text(&format!("paper-air-{}", explanation.drag)),
            explanation.flights.to_string(),
            translator.fixed(explanation.restitution_at_first, 4),
            translator.fixed(explanation.restitution_at_slow, 4),
            translator.fixed(explanation.drop_height_m * 100.0, 2),
            text(solved),
        ]);
    }
    let (question, answer) = (text("puzzle-question"), text("puzzle-answer"));
    format!("{question}\n\n{table}\n{answer}\n")
}
