//! `bouncelab rules`: the known rules, and the contents of each.

use std::path::PathBuf;

use bouncelab::Plain;
use bouncelab::rulebook::{self, Rule};
use bouncelab_report::rules::words::{drop, facts, read, title, wanted_in_short};
use bouncelab_report::{Align, Table, rules};
use clap::{Args, Subcommand};
use unicode_width::UnicodeWidthStr;

use crate::failure::Failure;
use crate::language::translator;
use crate::terminal::print;

/// List the rules for verdicts, or show one
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    what: What,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab rules list
  bouncelab rules show itf-court
  bouncelab rules new > own.toml                        a rule to fill in
  bouncelab rules show our-rule --rules own.toml        checks it; the format is in docs/rulebooks.md";

#[derive(Subcommand)]
enum What {
    /// List the rules, one per line
    List {
        #[command(flatten)]
        files: Files,
    },
    /// Print a file with a rule to fill in
    New,
    /// Show all of a rule
    Show {
        /// Name of the rule
        #[arg(value_name = "RULE")]
        name: String,
        #[command(flatten)]
        files: Files,
    },
}

/// Rules of one's own.
#[derive(Args, Clone, Debug)]
pub(crate) struct Files {
    /// A file with rules of your own, used besides those built in; see docs/rulebooks.md
    #[arg(long, value_name = "FILE.toml")]
    rules: Vec<PathBuf>,
}

impl Files {
    /// The files.
    pub(crate) fn paths(&self) -> &[PathBuf] {
        &self.rules
    }

    /// The rules that are built in, and those of the files; a rule of a file replaces one of the same
    /// name.
    pub(crate) fn read(&self) -> Result<Vec<Rule>, Failure> {
        Ok(rules::all(&self.rules)?)
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let page = match &arguments.what {
        What::List { files } => list(&files.read()?).to_string(),
        What::New => rules::TEMPLATE.to_owned(),
        What::Show { name, files } => {
            let name = String::from(Plain::of(name));
            show(rulebook::find(&files.read()?, &name)?)
        }
    };
    print(page)
}

fn list(rules: &[Rule]) -> Table {
    let mut table = Table::with_headings(
        translator(),
        [
            ("rule-title", Align::Left),
            ("rule-sport", Align::Left),
            ("rule-drop", Align::Right),
            ("rule-wants", Align::Left),
            ("rule-status", Align::Left),
        ],
    );
    for rule in rules {
        table.row([
            rule.name.clone(),
            title(rule, translator()),
            drop(rule, translator()),
            wanted_in_short(rule, translator()),
            read(rule.source.read, translator()),
        ]);
    }
    table
}

/// The rule in full, one fact a line.
fn show(rule: &Rule) -> String {
    let facts = facts(rule, translator());
    let width = facts.iter().map(|(name, _)| name.width());
    let width = width.fold(12, usize::max);
    let mut lines = vec![format!(
        "{} {}",
        translator().with_colon(&rule.name),
        title(rule, translator())
    )];
    lines.extend(facts.into_iter().map(|(name, value)| {
        let space = " ".repeat(width - name.width());
        format!("  {name}{space} {value}")
    }));
    lines.join("\n") + "\n"
}
