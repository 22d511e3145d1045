//! Help in two lengths: `--help` shows what a first user needs of a command, `--help all` every option.

use std::ffi::OsString;

use clap::{Arg, ArgAction, Command};

/// Maximum number of options of a command whose `--help` shows all of them.
const MAX_SHOWN: usize = 12;

/// The options that `--help` shows of a command with more.
const FIRST: [&str; 13] = [
    "ball",
    "by",
    "figures",
    "format",
    "height",
    "kept",
    "notes",
    "pattern",
    "reference",
    "report",
    "restitution",
    "rule",
    "save",
];

/// The arguments of the program, with the two forms of help as clap's: `-h` and `--help`.
pub(crate) fn arguments(given: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut arguments = Vec::new();
    let mut given = given.peekable();
    while let Some(argument) = given.next() {
        if argument == "--" {
            arguments.push(argument);
            break;
        }
        let is_long = argument == "--help";
        if is_long && given.next_if(|next| next == "all").is_none() {
            arguments.push("-h".into());
        } else {
            arguments.push(argument);
        }
    }
    arguments.extend(given);
    arguments
}

/// The command, whose short help leaves out what few need.
pub(crate) fn in_two_lengths(command: Command) -> Command {
    let command = command.mut_subcommands(in_two_lengths);
    let is_option = |argument: &&Arg| argument.get_long().is_some();
    if command.get_arguments().filter(is_option).count() <= MAX_SHOWN {
        return command;
    }
    let whole = command
        .get_after_help()
        .map(ToString::to_string)
        .unwrap_or_default();
    let shortened = format!(
        "{whole}\n\nAll options: bouncelab {} --help all",
        command.get_name()
    );
    command
        .mut_args(|argument| {
            let is_shown = argument.get_long().is_none_or(|name| FIRST.contains(&name));
            argument.hide_short_help(!is_shown)
        })
        .after_long_help(whole)
        .after_help(shortened)
        .disable_help_flag(true)
        .arg(
            Arg::new("help")
                .help_heading(None)
                .short('h')
                .long("help")
                .action(ArgAction::Help)
                .help("Print help; --help all shows every option"),
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rewritten(given: &[&str]) -> Vec<String> {
        let given = given.iter().map(OsString::from);
        let arguments = arguments(given).into_iter();
        arguments
            .map(|argument| argument.into_string().unwrap())
            .collect()
    }

    #[test]
    fn only_the_whole_help_is_asked_for_by_a_word() {
        assert_eq!(
            rewritten(&["bouncelab", "analyze", "--help"]),
            ["bouncelab", "analyze", "-h"]
        );
        assert_eq!(
            rewritten(&["bouncelab", "analyze", "--help", "all"]),
            ["bouncelab", "analyze", "--help"]
        );
        assert_eq!(
            rewritten(&["bouncelab", "analyze", "--", "--help", "all"]),
            ["bouncelab", "analyze", "--", "--help", "all"]
        );
    }
}
