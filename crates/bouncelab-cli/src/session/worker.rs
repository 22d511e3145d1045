//! Processes that analyse one recording after the other for a session, each within a limit of memory and of
//! processor time: a recording that ends its process ends no other.
//!
//! A worker is this program with the same arguments, so that it knows the same recordings and settings, unless
//! files have changed meanwhile. It is asked for recordings one by one, by lines of JSON on its stdin, and answers
//! with their records on its stdout.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Write};
use std::process::{Child, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::{Mutex, PoisonError};

use bouncelab_session::journal::Key;
use bouncelab_session::{KnownRecording, Record, record_of};
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::invocation::Invocation;
use crate::terminal::print_data;

/// The argument that makes a worker of a session.
pub(super) const WORKER: &str = "worker";

/// A recording to be analysed.
#[derive(Serialize, Deserialize)]
pub(super) struct Request {
    /// Its name.
    pub(super) name: String,
    /// Content and settings.
    pub(super) key: Key,
}

/// Why there is no record.
pub(super) enum Trouble {
    /// The worker ended; how.
    Died(String),
    /// The recording took all the processor time that it may take.
    OutOfTime,
    /// The session cannot go on.
    Session(Failure),
}

impl From<bouncelab_session::Error> for Trouble {
    fn from(error: bouncelab_session::Error) -> Self {
        Self::Session(error.into())
    }
}

/// Workers, started when they are needed.
#[derive(Default)]
pub(super) struct Workers {
    idle: Mutex<Vec<Worker>>,
}

impl Workers {
    /// Has a recording analysed by an idle worker; `None` if its content or its settings have changed.
    pub(super) fn record(&self, request: &Request) -> Result<Option<Record>, Trouble> {
        let mut worker = match self.idle().pop() {
            Some(worker) => worker,
            None => Worker::start().map_err(|reason| {
                let problem = format!("cannot start another process of bouncelab: {reason}");
                Trouble::Session(Failure::Input(problem))
            })?,
        };
        match worker.ask(request) {
            Ok(record) => {
                self.idle().push(worker);
                Ok(record)
            }
            Err(reason) => Err(worker.end(&reason)),
        }
    }

    fn idle(&self) -> std::sync::MutexGuard<'_, Vec<Worker>> {
        // A list of workers is whole at any time.
        self.idle.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

struct Worker {
    process: Child,
    answers: BufReader<ChildStdout>,
}

impl Worker {
    fn start() -> io::Result<Self> {
        let Invocation {
            program,
            arguments: of_session,
        } = Invocation::of_this_process();
        let (name, others) = program.split_first().ok_or(io::ErrorKind::NotFound)?;
        let mut process = Command::new(name)
            .args(others)
            .args(arguments(of_session.clone()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let answers = process.stdout.take().ok_or(io::ErrorKind::BrokenPipe)?;
        Ok(Self {
            process,
            answers: BufReader::new(answers),
        })
    }

    fn ask(&mut self, request: &Request) -> io::Result<Option<Record>> {
        let requests = self.process.stdin.as_mut();
        let requests = requests.ok_or(io::ErrorKind::BrokenPipe)?;
        writeln!(requests, "{}", serde_json::to_string(request)?)?;
        let mut answer = String::new();
        self.answers.read_line(&mut answer)?;
        Ok(serde_json::from_str(&answer)?)
    }

    /// Ends a worker that gave no answer, and returns how it ended.
    fn end(mut self, reason: &io::Error) -> Trouble {
        // One that failed has closed its end, and is gone or about to go.
        drop(self.process.stdin.take());
        match self.process.wait() {
            Ok(status) if is_out_of_time(status) => Trouble::OutOfTime,
            Ok(status) => Trouble::Died(status.to_string()),
            Err(_) => Trouble::Died(reason.to_string()),
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // It may be gone already; there is nothing in it to be lost.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// The arguments of a worker, from those of its session.
fn arguments(mut arguments: Vec<OsString>) -> Vec<OsString> {
    // Behind the name of the command: further behind, there may be a `--`.
    let command = arguments.iter().position(|word| word == "session");
    let behind = command.map_or(arguments.len(), |index| index + 1);
    arguments.insert(behind, format!("--{WORKER}").into());
    arguments
}

/// Answers the requests of a session until there are no more.
pub(super) fn serve(
    recordings: &[KnownRecording],
    memory_mb: u64,
    time_limit_s: u64,
) -> Result<(), Failure> {
    confine(memory_mb)?;
    for line in io::stdin().lock().lines() {
        let request: Request = serde_json::from_str(&line?).map_err(io::Error::from)?;
        limit_time(time_limit_s)?;
        let record = serde_json::to_string(&record_of(recordings, &request.name, &request.key));
        print_data(record.map_err(io::Error::from)? + "\n")?;
    }
    Ok(())
}

/// Drops the rights that an analysis does not need: memory beyond a limit, writing files, the network. Rights that the
/// system cannot drop remain.
#[cfg(target_os = "linux")]
fn confine(memory_mb: u64) -> Result<(), Failure> {
    use landlock::{ABI, Access, AccessFs, AccessNet, Ruleset, RulesetAttr, RulesetCreated};
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};

    // A stricter limit that was set outside remains.
    let most = mapped_data() + (memory_mb << 20);
    let most = getrlimit(Resource::Data)
        .maximum
        .map_or(most, |of_others| of_others.min(most));
    let limit = Rlimit {
        current: Some(most),
        maximum: Some(most),
    };
    setrlimit(Resource::Data, limit).map_err(|reason| {
        Failure::Input(format!(
            "cannot limit the memory to {memory_mb} MB: {reason}"
        ))
    })?;
    let abi = ABI::V5;
    Ruleset::default()
        .handle_access(AccessFs::from_write(abi))
        .and_then(|rules| rules.handle_access(AccessNet::from_all(abi)))
        .and_then(Ruleset::create)
        .and_then(RulesetCreated::restrict_self)
        .map_err(|reason| Failure::Input(format!("cannot give up writing: {reason}")))?;
    Ok(())
}

/// Bytes of data that this process has mapped. An interpreter that runs the program as a module reserves up to a gigabyte,
/// which it does not use. 0 where the system does not tell.
#[cfg(target_os = "linux")]
fn mapped_data() -> u64 {
    let kib = std::fs::read_to_string("/proc/self/status")
        .ok()
        .and_then(|status| {
            let size = status.lines().find_map(|line| line.strip_prefix("VmData:"));
            size?.trim().trim_end_matches(" kB").parse::<u64>().ok()
        });
    kib.unwrap_or(0) << 10
}

/// Has the system end this process after further `seconds` of processor time.
#[cfg(target_os = "linux")]
fn limit_time(seconds: u64) -> Result<(), Failure> {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    use rustix::time::{ClockId, clock_gettime};

    let used_s = clock_gettime(ClockId::ProcessCPUTime)
        .tv_sec
        .cast_unsigned();
    // The system counts whole seconds. A stricter limit that was set outside remains.
    let end_s = used_s + 1 + seconds;
    let maximum = getrlimit(Resource::Cpu).maximum;
    let limit = Rlimit {
        current: Some(maximum.map_or(end_s, |most_s| most_s.min(end_s))),
        maximum,
    };
    setrlimit(Resource::Cpu, limit)
        .map_err(|reason| Failure::Input(format!("cannot limit the time to {seconds} s: {reason}")))
}

#[cfg(target_os = "linux")]
fn is_out_of_time(status: ExitStatus) -> bool {
    use std::os::unix::process::ExitStatusExt;

    status.signal() == Some(rustix::process::Signal::XCPU.as_raw())
}

#[cfg(not(target_os = "linux"))]
fn confine(_: u64) -> Result<(), Failure> {
    Ok(())
}

#[cfg(not(target_os = "linux"))]
fn limit_time(_: u64) -> Result<(), Failure> {
    Ok(())
}

#[cfg(not(target_os = "linux"))]
fn is_out_of_time(_: ExitStatus) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The right of a thread alone, so this one can end with it.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_worker_can_neither_write_nor_connect() {
        use std::net::{TcpListener, TcpStream};
        use std::{fs, thread};

        use landlock::{
            ABI, Access, AccessFs, AccessNet, CompatLevel, Compatible, Ruleset, RulesetAttr,
        };

        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "kept").unwrap();
        let server = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = server.local_addr().unwrap();
        let work = || {
            const MAX_MB: u64 = 1 << 20;
            confine(MAX_MB).map_err(|refused| refused.to_string())?;
            let tries = [
                ("read", fs::read(&file).map(drop)),
                ("replaced", fs::write(&file, "lost")),
                ("made", fs::write(folder.path().join("new"), "")),
                ("removed", fs::remove_file(&file)),
                ("connected", TcpStream::connect(address).map(drop)),
            ];
            let possible = tries.into_iter().filter(|(_, tried)| tried.is_ok());
            Ok::<_, String>(possible.map(|(what, _)| what).collect::<Vec<_>>())
        };
        let possible = thread::scope(|threads| threads.spawn(work).join().unwrap()).unwrap();
        let ask = || Ruleset::default().set_compatibility(CompatLevel::HardRequirement);
        let for_files = ask().handle_access(AccessFs::from_write(ABI::V1)).is_ok();
        let for_network = ask().handle_access(AccessNet::from_all(ABI::V4)).is_ok();
        let expected = match (for_files, for_network) {
            (true, true) => &["read"][..],
            (true, false) => &["read", "connected"],
            (false, _) => &["read", "replaced", "made", "removed", "connected"],
        };
        assert_eq!(possible, expected);
    }

    #[test]
    fn a_worker_has_the_arguments_of_its_session() {
        let of = |words: &[&str]| arguments(words.iter().map(OsString::from).collect());
        assert_eq!(
            of(&["--language", "de", "session", "--", "-a"]),
            ["--language", "de", "session", "--worker", "--", "-a"]
        );
    }
}
