//! `bouncelab simulate`: from ball, air and surface to the trajectory of a drop.

use std::path::PathBuf;

use bouncelab::drag::DragLaw;
use bouncelab::settings::Setup;
use bouncelab_report::columns;
use bouncelab_report::data_table::Formulas;
use bouncelab_report::document::simulation::{Document, Run};
use bouncelab_report::figure::{self, Curve};
use bouncelab_report::messages::Translator;
use bouncelab_report::theme::Meaning;
use bouncelab_report::{Align, Chart, Quantity, Table, Unit, save, tables};
use clap::{Args, ValueEnum};

use crate::analyze::assumed;
use crate::failure::Failure;
use crate::history::HistoryArguments;
use crate::language::{text, text_with, translator};
use crate::report::{OutputArguments, wrote_figure};
use crate::settings::{PhysicsArguments, drag_law};
use crate::terminal::{print, print_data, print_json};

/// Simulate a drop: a table of bounces, totals, and height against time
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    history: HistoryArguments,
    /// Simulate also with this drag law, for comparison; may be repeated
    #[arg(long, value_name = "LAW", value_parser = drag_law)]
    compare: Vec<DragLaw>,
    /// How to print the result; JSON is documented in docs/json.md
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write height against time as SVG, PNG, PDF and CSV into this folder
    #[arg(long, value_name = "DIR")]
    figures: Option<PathBuf>,
    #[command(flatten)]
    outputs: OutputArguments,
    #[command(flatten)]
    physics: PhysicsArguments,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab simulate --height 30.5cm --restitution 0.935
  bouncelab simulate --compare none --compare constant:0.4 --figures figures
  bouncelab simulate --ball tennis --height 2.54m --restitution 0.75 --bounces 5 --format csv
  bouncelab simulate --restitution linear:0.95,0.01              e falls with speed
  bouncelab simulate --air-density 0 --gravity 1.62                 on the Moon";

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// For programs
    Json,
    /// One row for each bounce
    Csv,
}

/// Maximum number of rows of a table for people.
const MAX_ROWS: usize = 100;

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let physics = arguments.physics.resolve(arguments.history.question())?;
    let laws =
        std::iter::once(physics.options.environment.drag.clone()).chain(arguments.compare.clone());
    let runs = laws
        .map(|law| arguments.history.run(law, &physics.options))
        .collect::<Result<Vec<Run>, Failure>>()?;
    if let Some(folder) = &arguments.figures {
        let (chart, outputs) = (
            height_chart(&runs, translator()),
            arguments.outputs.of_no_input(),
        );
        let saved = save(&chart, folder, "height", &outputs)?;
        wrote_figure(&saved);
    }
    match arguments.format {
        Format::Text => print(report(&runs, &physics)),
        Format::Json => {
            let mut assumptions = physics.assumptions.clone();
            translator().complete_each(&mut assumptions);
            print_json(&Document::new(&runs, &physics.options, &assumptions))
        }
        Format::Csv => print_data(columns::bounces(&runs).csv(Formulas::Guarded)),
    }
}

fn report(runs: &[Run], physics: &Setup) -> String {
    let ball = [("ball", translator().ball(&physics.ball).into())];
    let mut parts = vec![text_with("simulate-heading", &ball)];
    parts.push(String::new());
    parts.push(totals(runs).to_string());
    if let Some(run) = runs.first() {
        let law = [("law", tables::drag_law(&run.law, translator()).into())];
        parts.push(text_with("simulate-each-bounce", &law));
        parts.push(String::new());
        parts.push(bounces(run).to_string());
        let hidden = run.history.bounces().len().saturating_sub(MAX_ROWS);
        if hidden > 0 {
            let hidden = [("count", hidden.into())];
            parts.push(text_with("terminal-all-shown", &hidden) + "\n");
        }
    }
    if !physics.assumptions.is_empty() {
        parts.push(assumed(&physics.assumptions).trim_start().to_owned());
    }
    parts.join("\n") + "\n"
}

/// The sums of each run, side by side.
fn totals(runs: &[Run]) -> Table {
    let translator = translator();
    let mut columns = vec![(text("column-drag"), Align::Left)];
    columns.extend(
        runs.iter()
            .map(|run| (tables::drag_law(&run.law, translator), Align::Right)),
    );
    let mut table = Table::new(columns);
    let mut row = |id: &str, value: &dyn Fn(&Run) -> String| {
        table.row(std::iter::once(text(id)).chain(runs.iter().map(value)));
    };
    let shown = |value: f64, unit: Unit| Quantity::rounded(value, 4, unit).text(translator);
    row("simulate-bounces", &|run| {
        run.history.bounces().len().to_string()
    });
    row("simulate-first-speed", &|run| {
        let first = run.history.impact_events().next();
        shown(first.map_or(f64::NAN, |s| s.speed_m_s), Unit::Speed)
    });
    row("quantity-terminal-speed", &|run| {
        run.terminal_speed_m_s.map_or_else(
            || text("simulate-no-terminal-speed"),
            |v| shown(v, Unit::Speed),
        )
    });
    row("simulate-total-time", &|run| {
        shown(run.history.total_time_s(), Unit::Time)
    });
    row("simulate-total-path", &|run| {
        shown(run.history.total_path_m(), Unit::Length)
    });
    row("simulate-initial-energy", &|run| {
        shown(run.initial_energy_j(), Unit::Energy)
    });
    row("simulate-lost-to-surface", &|run| {
        shown(run.lost_to_surface_j(), Unit::Energy)
    });
    row("simulate-lost-to-air", &|run| {
        shown(run.lost_to_air_j(), Unit::Energy)
    });
    table
}

fn bounces(run: &Run) -> Table {
    let translator = translator();
    let headings = [
        "simulate-bounce",
        "column-time",
        "column-speed",
        "column-e",
        "column-flight",
        "column-apex",
        "simulate-to-surface",
        "simulate-to-air",
    ];
    let mut table = Table::with_headings(translator, headings.map(|id| (id, Align::Right)));
    for (bounce, number) in run.history.bounces().iter().zip(1..=MAX_ROWS) {
        table.row([
            format!("{number}"),
            translator.fixed(bounce.time_s, 4),
            translator.fixed(bounce.impact_speed_m_s, 4),
            translator.fixed(bounce.restitution, 4),
            translator.fixed(bounce.flight.time_s(), 4),
            translator.fixed(bounce.flight.apex_m * 100.0, 3),
            translator.fixed(run.mass_kg * bounce.lost_to_surface_j_kg * 1e6, 1),
            translator.fixed(run.mass_kg * bounce.lost_to_air_j_kg * 1e6, 1),
        ]);
    }
    table
}

/// Height against time of all runs.
fn height_chart(runs: &[Run], translator: &Translator) -> Chart {
    /// Points along a curve.
    const POINTS: usize = 4000;
    let curves: Vec<Curve> = runs
        .iter()
        .map(|run| {
            let end_s = run.history.total_time_s();
            let times = (0..=POINTS).map(|point| end_s * point as f64 / POINTS as f64);
            Curve {
                name: text_with(
                    "simulate-drag",
                    &[("law", tables::drag_law(&run.law, translator).into())],
                ),
                meaning: if run.law == DragLaw::None {
                    Meaning::Plain
                } else {
                    Meaning::Drag
                },
                points: times
                    .map(|time_s| [time_s, run.history.height_at(time_s)])
                    .collect(),
            }
        })
        .collect();
    figure::height("height", &curves, &[], translator)
}
