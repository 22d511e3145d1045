//! `bouncelab completions` and `bouncelab manual`: completions of shells and manual pages, made from the arguments.

use std::path::{Path, PathBuf};

use bouncelab::ball;
use bouncelab::drag::DragLaw;
use bouncelab::restitution::LawKind;
use bouncelab::synth::Voice;
use bouncelab_report::file::create_folder;
use bouncelab_report::mark::{MANUAL, MANUAL_LINE};
use bouncelab_report::{messages, rules};
use clap::builder::PossibleValuesParser;
use clap::{Arg, Args, Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;

use crate::Cli;
use crate::failure::Failure;
use crate::report::{OutputArguments, write};
use crate::terminal::print_data;

/// Print the completions for a shell
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct CompletionArguments {
    /// The shell
    shell: Shell,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab completions bash > ~/.local/share/bash-completion/completions/bouncelab
  bouncelab completions zsh > ~/.zfunc/_bouncelab
  bouncelab completions fish > ~/.config/fish/completions/bouncelab.fish";

/// Write the manual pages, one for each command
#[derive(Args)]
pub(crate) struct ManualArguments {
    /// Folder for the pages
    #[arg(value_name = "DIR", default_value = "man1")]
    folder: PathBuf,
    #[command(flatten)]
    outputs: OutputArguments,
}

pub(crate) fn completions(arguments: &CompletionArguments) -> Result<(), Failure> {
    let mut command = with_names(Cli::command());
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    print_data(String::from_utf8_lossy(&script))
}

/// The command and its subcommands, with the known names of their arguments, which a shell then offers. Other values,
/// such as steel:10mm, can be typed too: completions check nothing.
fn with_names(command: Command) -> Command {
    command.mut_args(with_names_of).mut_subcommands(with_names)
}

fn with_names_of(argument: Arg) -> Arg {
    let names: Vec<String> = match argument.get_id().as_str() {
        "ball" => texts(ball::presets().iter().map(|preset| preset.name)),
        "drag" => texts(DragLaw::EXAMPLES),
        "law" => texts(LawKind::ALL.iter().map(|law| law.name())),
        "rule" => {
            let rules = rules::built_in().unwrap_or_default();
            texts(rules.iter().map(|rule| rule.name.as_str()))
        }
        "voice" => texts(Voice::NAMES),
        "language" => texts(messages::languages()),
        _ => return argument,
    };
    argument.value_parser(PossibleValuesParser::new(names))
}

fn texts<'a>(names: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    names.into_iter().map(str::to_owned).collect()
}

pub(crate) fn manual(arguments: &ManualArguments) -> Result<(), Failure> {
    let folder = &arguments.folder;
    create_folder(folder).map_err(|reason| Failure::unwritable(folder, &reason))?;
    let mut command = Cli::command().disable_help_subcommand(true);
    command.build();
    pages(&command, folder, &arguments.outputs)
}

/// Writes the page of a command, and those of its subcommands.
fn pages(command: &Command, folder: &Path, outputs: &OutputArguments) -> Result<(), Failure> {
    let name = command.get_display_name().unwrap_or(command.get_name());
    // A comment in the page distinguishes it from files of others.
    let mut page = format!("{MANUAL_LINE}\n").into_bytes();
    let man = Man::new(command.clone()).title(name.to_owned());
    man.render(&mut page)?;
    let path = folder.join(format!("{name}.1"));
    write(&outputs.of_no_input(), &path, MANUAL, &page)?;
    let own = command.get_subcommands().filter(|own| !own.is_hide_set());
    own.into_iter()
        .try_for_each(|own| pages(own, folder, outputs))
}
