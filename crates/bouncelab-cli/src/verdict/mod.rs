//! `bouncelab verdict`: whether a ball or a floor conforms to a rule.

mod text;

use std::collections::BTreeMap;
use std::path::PathBuf;

use bouncelab::Plain;
use bouncelab::rulebook::{self, Decision, Item, Outcome, Rebound, Rule};
use bouncelab::settings::{Settings, Setup};
use bouncelab_report::document::verdict::{Evaluation, Surface, VerdictDocument};
use bouncelab_report::report::Provenance;
use bouncelab_report::report::verdict::of_verdict;
use bouncelab_session::hash::hash_of_file;
use clap::{Args, ValueEnum};

use crate::analyze::{Analysed, read};
use crate::failure::Failure;
use crate::language::translator;
use crate::report::{OutputArguments, ReportFile, provenance};
use crate::rules::Files;
use crate::settings::SettingsArguments;
use crate::terminal::{print, print_json};
use crate::units;

pub(crate) use text::report as text;

/// Test drops by the procedure of a rule: conforms, does not conform, or cannot decide
///
/// Each file is one place on the surface, with one or more drops. Ball and height are those of the
/// rule unless you state others. Exit status: 0 conforms, 1 a file cannot be read or holds no drop, 2 wrong
/// usage, 3 does not conform, 4 cannot decide, 5 conforms as far as shown.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Recordings, or lists of impact times
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The rule, one of `bouncelab rules list`
    #[arg(long, value_name = "NAME")]
    rule: String,
    /// Recordings of the same ball on the reference surface, for rules that compare
    #[arg(long, value_name = "FILE", num_args = 1..)]
    reference: Vec<PathBuf>,
    #[command(flatten)]
    rules: Files,
    /// Parts of the procedure that were kept and that nothing else shows: surface, reference, conditioning; with commas
    #[arg(long, value_name = "PART", value_delimiter = ',')]
    kept: Vec<String>,
    /// Decision rule
    #[arg(long, value_enum, default_value_t = DecisionRule::Guarded)]
    decision: DecisionRule,
    /// Greatest probability of a wrong decision, as in 5% [default: 5%]
    #[arg(long, value_name = "SHARE", value_parser = risk)]
    risk: Option<f64>,
    /// How to print the result; JSON is documented in docs/json.md
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write a report: .html (one file), .md (with its figures in a folder) or .pdf (printed by an installed Chromium, Chrome
    /// or Edge)
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    #[command(flatten)]
    outputs: OutputArguments,
    #[command(flatten)]
    settings: SettingsArguments,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab verdict --rule ittf-ball drop.wav
  bouncelab verdict --rule itf-tennis --height 2.54m --temperature 20C drop1.wav drop2.wav
  bouncelab verdict --rule indoor-floor-basketball floor1.wav floor2.wav --reference concrete.wav
  bouncelab verdict --rule our-hall --rules own.toml drop.wav --format json
  bouncelab verdict --rule ittf-ball drop1.wav drop2.wav drop3.wav --report verdict.html";

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum DecisionRule {
    /// Guarded acceptance (JCGM 106): a decision only if it is wrong with at most the risk
    Guarded,
    /// Simple acceptance: the more probable outcome
    Simple,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people
    Text,
    /// For programs
    Json,
}

/// The rebounds in files, each of which is a place.
fn surface(files: &[PathBuf], rule: &Rule, setup: &Setup) -> Result<Surface, Failure> {
    let mut surface = Surface::default();
    for file in files {
        let analysed = read(file, &setup.options, false)?;
        if let Some(reason) = analysed.no_drop() {
            return Err(Failure::Input(reason));
        }
        surface.push(analysed.name.clone(), rebounds(&analysed, rule, setup));
    }
    Ok(surface)
}

/// The rebounds of the drops of a recording.
pub(crate) fn rebounds(analysed: &Analysed, rule: &Rule, setup: &Setup) -> Vec<Rebound> {
    let drops = analysed.result.drops.iter();
    drops
        .map(|drop| Rebound::new(drop, rule, &setup.options))
        .collect()
}

/// The exit status of a verdict.
pub(crate) fn status(outcome: Outcome) -> Result<(), Failure> {
    match outcome {
        Outcome::Conforms => Ok(()),
        Outcome::DoesNotConform => Err(Failure::NoPass(3)),
        Outcome::CannotDecide => Err(Failure::NoPass(4)),
        Outcome::ConformsAsFarAsShown => Err(Failure::NoPass(5)),
    }
}

/// Maximum probability of a wrong decision, if none is stated.
const RISK: f64 = 0.05;

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let rules = arguments.rules.read()?;
    let rule = rulebook::find(&rules, &String::from(Plain::of(&arguments.rule)))?;
    let decision = match (arguments.decision, arguments.risk) {
        (DecisionRule::Guarded, risk) => Decision::Guarded {
            risk: risk.unwrap_or(RISK),
        },
        (DecisionRule::Simple, None) => Decision::Simple,
        (DecisionRule::Simple, Some(_)) => {
            return Err(Failure::Usage(
                "--decision simple knows no --risk: leave out one".to_owned(),
            ));
        }
    };
    let settings = arguments.settings.settings()?;
    let mut setup = setup_of_rule(&settings, rule, |settings| {
        arguments.settings.resolve(settings)
    })?;
    if !arguments.settings.allow_implausible() {
        check_height(&setup, rule)?;
    }
    let kept = arguments.kept.iter().map(|name| Item::stated(name));
    setup.conditions.kept = kept.collect::<Result<_, _>>()?;
    if !rule.needs_reference() && !arguments.reference.is_empty() {
        return Err(Failure::Usage(format!(
            "the rule {} compares with no other surface; omit --reference",
            rule.name
        )));
    }
    let hashes = once_each(arguments.files.iter().chain(&arguments.reference))?;
    let inputs = arguments.files.iter().chain(&arguments.reference);
    let outputs = arguments
        .outputs
        .outputs(inputs.chain(arguments.rules.paths()));
    let report_file = arguments
        .report
        .as_deref()
        .map(|path| ReportFile::new(path, &outputs))
        .transpose()?;
    let here = surface(&arguments.files, rule, &setup)?;
    let there = surface(&arguments.reference, rule, &setup)?;
    let evaluation = Evaluation::new(rule, &setup, here, there, decision)?;
    if let Some(file) = report_file {
        let provenance = Provenance {
            files: hashes,
            ..provenance()
        };
        file.write(&of_verdict(&evaluation, &provenance, None, translator()))?;
    }
    match arguments.format {
        Format::Text => print(text(&evaluation))?,
        Format::Json => print_json(&VerdictDocument::new(&evaluation, translator()))?,
    }
    status(evaluation.verdict.outcome)
}

/// Name and hash of each file, once each: the same drop counted twice would make a verdict seem more certain than it is.
fn once_each<'a>(
    files: impl Iterator<Item = &'a PathBuf>,
) -> Result<Vec<(String, String)>, Failure> {
    let mut seen = BTreeMap::new();
    let mut hashes = Vec::new();
    for file in files {
        // A file that cannot be read is reported when it is opened.
        let Ok(content) = hash_of_file(file) else {
            continue;
        };
        hashes.push((String::from(Plain::path(file)), content.to_string()));
        if let Some(first) = seen.insert(content, file) {
            return Err(Failure::Usage(format!(
                "{} and {} are the same recording; give each recording once",
                Plain::path(first),
                Plain::path(file)
            )));
        }
    }
    Ok(hashes)
}

/// The options of the settings, with the ball and the height of the rule where they state none.
pub(crate) fn setup_of_rule(
    settings: &Settings,
    rule: &Rule,
    resolve: impl FnOnce(&Settings) -> Result<Setup, Failure>,
) -> Result<Setup, Failure> {
    let no_ball = || {
        Failure::Usage(format!(
            "the rule {} names no known ball: state it with --ball, or with --mass and --diameter",
            rule.name
        ))
    };
    let (settings, is_its_ball) = settings.with_ball_of(rule).ok_or_else(no_ball)?;
    let mut setup = resolve(&settings)?;
    setup.assume(rule, is_its_ball);
    Ok(setup)
}

/// A height far from that of the rule is probably in another unit.
fn check_height(setup: &Setup, rule: &Rule) -> Result<(), Failure> {
    const OUTLIER_THRESHOLD: f64 = 8.0;
    let of_rule = rule.fall_m(setup.options.ball.diameter_m(), None);
    let Some((stated, of_rule_m)) = setup.conditions.drop_height_m.zip(of_rule) else {
        return Ok(());
    };
    let factor = stated.value / of_rule_m;
    if (1.0 / OUTLIER_THRESHOLD..OUTLIER_THRESHOLD).contains(&factor) {
        return Ok(());
    }
    Err(Failure::Usage(format!(
        "--height {} m is {} times the rule's {of_rule_m:.3} m: is the unit right? Correct it, or \
         accept it with --allow-implausible",
        stated.value,
        (factor * 1000.0).round() / 1000.0
    )))
}

fn risk(text: &str) -> Result<f64, String> {
    let risk = units::share(text)?;
    if risk > 0.0 && risk <= 0.5 {
        Ok(risk)
    } else {
        Err("a risk is above 0 and at most 50 %, as in 5%".to_owned())
    }
}
