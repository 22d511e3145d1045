//! `bouncelab paper`: every number and figure of the paper, computed again.
//!
//! The paper is M. Nagurka, "Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment".

use std::io::{self, Write};
use std::path::PathBuf;

use bouncelab_report::paper::{self, Chapter, Document, Explanation, Fact};
use bouncelab_report::{Align, Table, save};
use clap::{Args, ValueEnum};

use crate::failure::Failure;
use crate::language::translator;

/// Compute every number and figure of the paper, and what it did not say
///
/// The paper is M. Nagurka, "Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment".
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Folder for the paper's Figs. 2, 4, 5, 6, 7 and 8, as SVG and PNG
    #[arg(long, value_name = "DIR", default_value = "bouncelab-paper")]
    figures: PathBuf,
    /// Write no figures
    #[arg(long, conflicts_with = "figures")]
    no_figures: bool,
    /// How to print the numbers; JSON is documented in docs/json.md
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
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
    let mut out = io::stdout().lock();
    match arguments.format {
        Format::Text => {
            out.write_all(text(&chapters).as_bytes())?;
            write!(out, "\n{}", puzzle(&explanations))?;
        }
        Format::Json => {
            let document = Document::new(&chapters, explanations, translator());
            serde_json::to_writer_pretty(&mut out, &document).map_err(io::Error::from)?;
            writeln!(out)?;
        }
    }
    if arguments.no_figures {
        return Ok(());
    }
    for (name, figure) in paper::figures(translator())? {
        let saved = save(&figure, &arguments.figures, name)?;
        eprintln!("wrote {} and .png", saved.svg.display());
    }
    Ok(())
}

fn text(chapters: &[Chapter]) -> String {
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
    let mut table = Table::new([
        ("quantity", Align::Left),
        ("printed", Align::Right),
        ("computed", Align::Right),
        ("", Align::Left),
        ("verdict", Align::Left),
        ("", Align::Left),
    ]);
    for fact in facts {
        table.row([
            fact.quantity(translator()),
            fact.printed.unwrap_or("-").to_owned(),
            fact.shown(),
            fact.unit.to_owned(),
            fact.verdict().text(translator()),
            fact.note(translator()).unwrap_or_default(),
        ]);
    }
    table
}

/// The puzzle and what would explain it.
fn puzzle(explanations: &[Explanation]) -> String {
    let mut table = Table::new([
        ("restitution", Align::Left),
        ("drag", Align::Left),
        ("flights", Align::Right),
        ("e at 2.4 m/s", Align::Right),
        ("e at 0.5 m/s", Align::Right),
        ("line says h0 cm", Align::Right),
        ("the paper's 26.7?", Align::Left),
    ]);
    for explanation in explanations {
        table.row([
            explanation.restitution_law.clone(),
            explanation.drag.clone(),
            explanation.flights.to_string(),
            format!("{:.4}", explanation.restitution_at_first),
            format!("{:.4}", explanation.restitution_at_slow),
            format!("{:.2}", explanation.drop_height_m * 100.0),
            if explanation.reproduces { "yes" } else { "no" }.to_owned(),
        ]);
    }
    format!(
        "The puzzle: what makes the straight line say e = 0.9375 and h0 = 26.7 cm of a ball dropped \
         from 30.5 cm?\n\n{table}\n\
         Each law was chosen so that the line says e = 0.9375. Drag with a constant restitution\n\
         gives 26.7 cm only with some 21 flights in the line; with ten flights the restitution must\n\
         also fall with speed. A straight line cannot tell the two; how many flights go into it\n\
         decides what it says.\n"
    )
}
