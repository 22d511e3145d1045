//! Runs and measures the commands of a task, and reports the slowest and what failed.

use std::collections::VecDeque;
use std::fs;
use std::io::{self, BufRead, BufReader, IsTerminal, Read};
use std::process::{Command, ExitStatus, Stdio};
use std::sync::Mutex;
use std::thread;
use std::time::{Duration, Instant};

/// What ran, and how long.
pub(crate) struct Step {
    pub(crate) name: String,
    pub(crate) time: Time,
    /// The last lines that it printed, if it failed while its output went to a log.
    pub(crate) last_lines: Vec<String>,
}

impl Step {
    /// Whether it is worth a line.
    pub(crate) fn is_long(&self) -> bool {
        self.time.clock > Duration::from_secs(5)
    }
}

/// A time on the clock, and that of the processors together, where the system tells it: beside other
/// work the first says little.
#[derive(Clone, Copy)]
pub(crate) struct Time {
    pub(crate) clock: Duration,
    pub(crate) processors: Option<Duration>,
}

static STEPS: Mutex<Vec<Step>> = Mutex::new(Vec::new());

/// Runs a command, and notes how long it takes. In a log the end of what a command printed is soon far
/// up: that of one which fails is kept for the summary.
pub(crate) fn run(command: &mut Command) -> io::Result<ExitStatus> {
    let watch = Watch::start();
    let (status, last_lines) = if io::stdout().is_terminal() {
        (command.status()?, Vec::new())
    } else {
        run_logged(command)?
    };
    let mut steps = STEPS.lock().expect("nothing panics while it holds this");
    steps.push(Step {
        name: name(command),
        time: watch.time(),
        last_lines: if status.success() {
            Vec::new()
        } else {
            last_lines
        },
    });
    Ok(status)
}

/// Both outputs go to ours, line by line.
fn run_logged(command: &mut Command) -> io::Result<(ExitStatus, Vec<String>)> {
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    let tail = Mutex::new(VecDeque::new());
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    thread::scope(|scope| {
        scope.spawn(|| stdout.map(|pipe| log(pipe, &tail)));
        scope.spawn(|| stderr.map(|pipe| log(pipe, &tail)));
    });
    let tail = tail
        .into_inner()
        .expect("nothing panics while it holds this");
    Ok((child.wait()?, tail.into()))
}

fn log(pipe: impl Read, tail: &Mutex<VecDeque<String>>) {
    const LINES: usize = 60;
    for line in BufReader::new(pipe).split(b'\n').map_while(Result::ok) {
        let line = String::from_utf8_lossy(&line).into_owned();
        println!("{line}");
        let mut tail = tail.lock().expect("nothing panics while it holds this");
        if tail.len() == LINES {
            tail.pop_front();
        }
        tail.push_back(line);
    }
}

/// The steps since the last call.
pub(crate) fn take() -> Vec<Step> {
    std::mem::take(&mut STEPS.lock().expect("nothing panics while it holds this"))
}

static SKIPPED: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Says that something is left out, and why; the summary repeats it.
pub(crate) fn skip(what: &str) {
    println!("SKIPPED: {what}");
    let mut skipped = SKIPPED.lock().expect("nothing panics while it holds this");
    skipped.push(what.to_owned());
}

/// All that was left out.
pub(crate) fn skipped() -> Vec<String> {
    let skipped = SKIPPED.lock().expect("nothing panics while it holds this");
    skipped.clone()
}

/// The program and its words, as far as they fit a line.
fn name(command: &Command) -> String {
    const LONGEST: usize = 70;
    let program = command.get_program().to_string_lossy();
    let program = program.rsplit('/').next().unwrap_or_default().to_owned();
    let words = command.get_args().map(|word| word.to_string_lossy());
    let mut name = words.fold(program, |name, word| name + " " + &word);
    if let Some((end, _)) = name.char_indices().nth(LONGEST) {
        name.truncate(end);
        name.push_str("...");
    }
    name
}

/// Runs from its start.
pub(crate) struct Watch {
    start: Instant,
    processors: Option<Duration>,
}

impl Watch {
    pub(crate) fn start() -> Self {
        Self {
            start: Instant::now(),
            processors: of_children(),
        }
    }

    pub(crate) fn time(&self) -> Time {
        let processors = of_children().zip(self.processors);
        Time {
            clock: self.start.elapsed(),
            processors: processors.map(|(now, before)| now.saturating_sub(before)),
        }
    }
}

impl std::fmt::Display for Time {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:7.1} s", self.clock.as_secs_f64())?;
        match self.processors {
            Some(time) => write!(f, " {:7.1} s", time.as_secs_f64()),
            None => Ok(()),
        }
    }
}

/// Processor time of all commands that have ended, as Linux counts it, in hundredths of a second.
fn of_children() -> Option<Duration> {
    let numbers = fs::read_to_string("/proc/self/stat").ok()?;
    // The second field, a name in parentheses, may contain anything.
    let (_, after_name) = numbers.rsplit_once(')')?;
    let mut times = after_name.split_whitespace().skip(13);
    let mut next = || times.next()?.parse::<u64>().ok();
    let (user, system) = (next()?, next()?);
    Some(Duration::from_millis(10 * (user + system)))
}
