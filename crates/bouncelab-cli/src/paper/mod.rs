//! `bouncelab paper`: every number and figure of the paper, computed again.
//!
//! The paper is M. Nagurka, "Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment".

mod experiment;
mod facts;
mod figures;
mod puzzle;

use std::io::{self, Write};
use std::path::PathBuf;

use bouncelab_report::{Align, Table, save};
use clap::{Args, ValueEnum};
use serde::Serialize;

use crate::failure::Failure;
use facts::{Chapter, Fact};
use puzzle::Explanation;

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
    let chapters = facts::chapters()?;
    let explanations = puzzle::explanations()?;
    let mut out = io::stdout().lock();
    match arguments.format {
        Format::Text => {
            out.write_all(text(&chapters).as_bytes())?;
            write!(out, "\n{}", puzzle::chapter(&explanations))?;
        }
        Format::Json => {
            let document = Document::new(&chapters, explanations);
            serde_json::to_writer_pretty(&mut out, &document).map_err(io::Error::from)?;
            writeln!(out)?;
        }
    }
    if arguments.no_figures {
        return Ok(());
    }
    for (name, figure) in figures::all()? {
        let saved = save(&figure, &arguments.figures, name)?;
        eprintln!("wrote {} and .png", saved.svg.display());
    }
    Ok(())
}

/// The schema `bouncelab.paper/1`.
#[derive(Serialize)]
struct Document {
    schema: &'static str,
    facts: Vec<Row>,
    /// What would make the straight line say what it says in the paper.
    puzzle: Vec<Explanation>,
}

#[derive(Serialize)]
struct Row {
    chapter: &'static str,
    quantity: &'static str,
    /// As the paper prints it, to its digits; `null` if it does not say.
    printed: Option<&'static str>,
    computed: f64,
    unit: &'static str,
    verdict: String,
    note: &'static str,
}

impl Document {
    fn new(chapters: &[Chapter], puzzle: Vec<Explanation>) -> Self {
        let rows = chapters.iter().flat_map(|chapter| {
            chapter.facts.iter().map(|fact| Row {
                chapter: chapter.title,
                quantity: fact.quantity,
                printed: fact.printed,
                computed: fact.computed,
                unit: fact.unit,
                verdict: fact.verdict().to_string(),
                note: fact.note,
            })
        });
        Self {
            schema: "bouncelab.paper/1",
            facts: rows.collect(),
            puzzle,
        }
    }
}

fn text(chapters: &[Chapter]) -> String {
    let parts: Vec<String> = chapters
        .iter()
        .map(|chapter| format!("{}\n\n{}", chapter.title, table(&chapter.facts)))
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
            fact.quantity.to_owned(),
            fact.printed.unwrap_or("-").to_owned(),
            fact.shown(),
            fact.unit.to_owned(),
            fact.verdict().to_string(),
            fact.note.to_owned(),
        ]);
    }
    table
}
