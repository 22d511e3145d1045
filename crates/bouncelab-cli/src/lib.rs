//! The program `bouncelab`: from a recording of a bouncing ball to the physics.
//!
//! [`run`] is all of it: `main.rs` calls it, and so does the Python package, whose wheel has the code once.

mod analyze;
mod balls;
mod browser;
mod demo;
mod failure;
mod help;
mod history;
mod interrupt;
mod invocation;
mod job;
mod language;
mod listen;
mod manual;
#[cfg(feature = "serve")]
mod page;
mod paper;
mod report;
mod rules;
#[cfg(feature = "serve")]
mod serve;
mod session;
mod settings;
mod simulate;
mod synth;
mod terminal;
mod verdict;

use std::io::{self, Write};
use std::iter;

use bouncelab_report::units;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

pub use invocation::Invocation;

/// Measure restitution, drop height and air drag of a bouncing ball from the sound of its impacts.
#[derive(Parser)]
#[command(
    name = "bouncelab",
    version,
    arg_required_else_help = true,
    help_expected = true,
    after_help = EXAMPLES
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Language of the results, as in de (default: that of the system, else English); help and errors of
    /// arguments and files are in English
    #[arg(long, global = true, hide_short_help = true, value_name = "CODE", value_parser = language::known)]
    language: Option<String>,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab demo                                   synthesise, analyse and draw a drop
  bouncelab analyze drop.wav                       the drops of a recording
  bouncelab analyze drop.m4a --ball tennis --figures figures
  bouncelab listen                                 analyse drops live
  bouncelab session recordings                     mean and scatter of many drops
  bouncelab verdict --rule ittf-ball drop.wav      does the ball obey the rule?
  bouncelab simulate --height 30.5cm --restitution 0.935";

#[derive(Subcommand)]
enum Command {
    Analyze(analyze::Arguments),
    Listen(listen::Arguments),
    Session(session::Arguments),
    Verdict(verdict::Arguments),
    Job(job::Arguments),
    Rules(rules::Arguments),
    Balls(balls::Arguments),
    Simulate(simulate::Arguments),
    Synth(synth::Arguments),
    Paper(paper::Arguments),
    Demo(demo::Arguments),
    Completions(manual::CompletionArguments),
    Manual(manual::ManualArguments),
    #[cfg(feature = "serve")]
    Serve(serve::Arguments),
    #[cfg(feature = "serve")]
    Page(page::Arguments),
}

/// Runs the program to its end and returns its exit status: 0 for a result, 1 for an input that gives none, 2 for wrong
/// arguments, others as the command documents them. It takes over stdout, stderr and the signals that end a process, and
/// a signal ends the process: it is for a process of its own, once.
pub fn run(invocation: Invocation) -> u8 {
    bouncelab_audio::silence_contained_panics();
    let given = invocation.keep().arguments.iter().cloned();
    let words = help::arguments(iter::once("bouncelab".into()).chain(given));
    let matches = help::in_two_lengths(Cli::command()).try_get_matches_from(words);
    let cli = match matches.and_then(|matches| Cli::from_arg_matches(&matches)) {
        Ok(cli) => cli,
        Err(answer) => return tell(&answer),
    };
    if let Some(language) = cli.language {
        language::choose(language);
    }
    let result = interrupt::watch().and_then(|()| execute(cli.command));
    result.map_or_else(|failure| failure.report(), |()| 0)
}

/// Prints help, the version, or what is wrong with the arguments.
fn tell(answer: &clap::Error) -> u8 {
    let printed = answer.print().and_then(|()| io::stdout().flush());
    match printed {
        // What was asked for is a result.
        Err(reason) if !answer.use_stderr() => failure::Failure::from(reason).report(),
        _ => answer.exit_code() as u8,
    }
}

fn execute(command: Command) -> Result<(), failure::Failure> {
    match command {
        Command::Analyze(arguments) => analyze::run(&arguments),
        Command::Listen(arguments) => listen::run(&arguments),
        Command::Session(arguments) => session::run(&arguments),
        Command::Verdict(arguments) => verdict::run(&arguments),
        Command::Job(arguments) => job::run(&arguments),
        Command::Rules(arguments) => rules::run(&arguments),
        Command::Balls(arguments) => balls::run(&arguments),
        Command::Simulate(arguments) => simulate::run(&arguments),
        Command::Synth(arguments) => synth::run(&arguments),
        Command::Paper(arguments) => paper::run(&arguments),
        Command::Demo(arguments) => demo::run(&arguments),
        Command::Completions(arguments) => manual::completions(&arguments),
        Command::Manual(arguments) => manual::manual(&arguments),
        #[cfg(feature = "serve")]
        Command::Serve(arguments) => serve::run(&arguments),
        #[cfg(feature = "serve")]
        Command::Page(arguments) => page::run(&arguments),
    }
}
