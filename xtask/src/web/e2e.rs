//! The end-to-end tests of the page: once, or many times in a row, beside other work if asked.

use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use super::{npm, npm_command, page, system, unpacked};
use crate::Result;
use crate::cargo::{built, run as run_command};
use crate::steps::{Time, Watch};

/// Runs the tests, or those whose file has one of the names in it; in Firefox with `--firefox`; `--repeat N`
/// times in a row, and with `--load` while other work keeps every processor busy. `--slowdown N` makes the page itself
/// N times slower, so that a test fails which reads the page too early. `--pictures` takes pictures of what they see,
/// into `web/tests/screenshots`.
pub(crate) fn run(words: &[&str]) -> Result {
    let mut names = Vec::new();
    let (mut repeat, mut slowdown) = (1, None);
    let (mut load, mut firefox, mut pictures) = (false, false, false);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match *word {
            "--repeat" => repeat = number("--repeat", words.next())?,
            "--slowdown" => slowdown = Some(number("--slowdown", words.next())?),
            "--load" => load = true,
            "--firefox" => firefox = true,
            "--pictures" => pictures = true,
            option if option.starts_with('-') => return Err(format!("'{option}' is no option")),
            name => names.push(name),
        }
    }
    if firefox && !system::has_firefox() {
        return Err("the end-to-end tests in Firefox need Firefox and PulseAudio".into());
    }
    if !firefox && !system::has_browser() {
        return Err("the end-to-end tests need Chromium".into());
    }
    page()?;
    unpacked()?;
    let program = built("--bin", "bouncelab")?;
    let busy = load.then(Load::start);
    let runs: Vec<(Result, Time)> = (1..=repeat)
        .map(|number| {
            if repeat > 1 {
                println!("\n== run {number} of {repeat}");
            }
            let watch = Watch::start();
            let mut command = npm_command(&["run", "e2e", "--"]);
            command.args(&names).env("BOUNCELAB_PROGRAM", &program);
            if firefox {
                command.env("BOUNCELAB_FIREFOX", system::FIREFOX);
            }
            if pictures {
                command.env("BOUNCELAB_PICTURES", "");
            }
            if let Some(times) = slowdown {
                command.env("BOUNCELAB_SLOWDOWN", times.to_string());
            }
            (run_command(&mut command), watch.time())
        })
        .collect();
    drop(busy);
    conclude(&runs)
}

fn number(option: &str, word: Option<&&str>) -> Result<u32> {
    word.and_then(|word| word.parse().ok())
        .filter(|number| *number > 0)
        .ok_or_else(|| format!("{option} takes a number"))
}

/// Runs the tests in Firefox, but for those that `web/tests/harness/firefox.ts` lists.
pub(crate) fn firefox() -> Result {
    run(&["--firefox"])
}

/// Runs the test of a whole class.
pub(crate) fn class() -> Result {
    page()?;
    let program = built("--bin", "bouncelab")?;
    let mut command = npm_command(&["run", "class"]);
    run_command(command.env("BOUNCELAB_PROGRAM", &program))
}

/// Runs the test of the page in `WebKit`.
pub(crate) fn webkit() -> Result {
    page()?;
    npm(&["run", "webkit"])
}

/// Takes the pictures of the page that the book has, and that of a notebook, which is there as HTML.
pub(crate) fn pictures(notebook: Option<&Path>) -> Result {
    page()?;
    let mut command = npm_command(&["run", "pictures"]);
    if let Some(notebook) = notebook {
        command.env("BOUNCELAB_NOTEBOOK", notebook);
    }
    run_command(&mut command)
}

fn conclude(runs: &[(Result, Time)]) -> Result {
    let failed = runs.iter().filter(|(result, _)| result.is_err()).count();
    if runs.len() > 1 {
        println!("\n== {} runs, {failed} failed", runs.len());
        for (number, (result, time)) in runs.iter().enumerate() {
            let word = if result.is_ok() { "ok" } else { "FAILED" };
            println!("   {:>3} {word:<7} {time}", number + 1);
        }
    }
    match failed {
        0 => Ok(()),
        _ => Err(format!("{failed} of {} runs failed", runs.len())),
    }
}

/// Other work on every processor, until it is dropped.
struct Load {
    is_over: Arc<AtomicBool>,
}

impl Load {
    fn start() -> Self {
        let count = thread::available_parallelism().map_or(1, usize::from);
        println!("{count} processors are loaded during the tests");
        let is_over = Arc::new(AtomicBool::new(false));
        for _ in 0..count {
            let is_over = Arc::clone(&is_over);
            thread::spawn(move || {
                let mut number = 1_u32;
                while !is_over.load(Ordering::Relaxed) {
                    number = black_box(number.wrapping_mul(1_664_525).wrapping_add(1));
                }
            });
        }
        Self { is_over }
    }
}

impl Drop for Load {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
    }
}
