//! Failures of a command: message on stderr and exit status.

use std::io;
use std::path::Path;

use bouncelab::Plain;
use bouncelab_audio::LooksLike;
use bouncelab_report::advice;

use crate::language::{text, translated};
use crate::terminal::say;

/// Why a command did not do what was asked.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// The arguments are not valid: exit status 2.
    #[error("{0}")]
    Usage(String),
    /// The input cannot be read or holds nothing: exit status 1. Empty if the reason was printed already.
    #[error("{0}")]
    Input(String),
    /// A verdict was printed that is not a pass: this exit status.
    #[error("")]
    NoPass(u8),
    /// The result could not be printed: exit status 1.
    #[error("cannot write the result: {0}")]
    Output(#[from] io::Error),
}

impl Failure {
    /// A file that cannot be written.
    pub(crate) fn unwritable(path: &Path, reason: &io::Error) -> Self {
        Self::Input(format!(
            "cannot write {}: {reason}{}",
            Plain::path(path),
            advice(reason)
        ))
    }

    /// Prints the reason on stderr and returns the exit status.
    pub(crate) fn report(&self) -> u8 {
        // The reader may have closed the pipe (`| head`).
        let reader_is_gone =
            matches!(self, Self::Output(reason) if reason.kind() == io::ErrorKind::BrokenPipe);
        let message = self.to_string();
        if !reader_is_gone && !message.is_empty() {
            say(format_args!("bouncelab: {message}"));
        }
        match self {
            Self::Usage(_) => 2,
            Self::NoPass(status) => *status,
            Self::Input(_) | Self::Output(_) => 1,
        }
    }
}

/// An argument that the science refuses.
impl From<bouncelab::Error> for Failure {
    fn from(refusal: bouncelab::Error) -> Self {
        let advice = match &refusal {
            bouncelab::Error::UnknownName { kind: "ball", .. } => text("advice-balls"),
            _ => String::new(),
        };
        Self::Usage(
            format!("{} {advice}", translated(&refusal))
                .trim_end()
                .to_owned(),
        )
    }
}

impl From<bouncelab_audio::Error> for Failure {
    fn from(fault: bouncelab_audio::Error) -> Self {
        let advice = match &fault {
            bouncelab_audio::Error::NotSound {
                looks_like: LooksLike::Zip,
                ..
            } => "; 'bouncelab session' opens a ZIP archive of recordings",
            _ => "",
        };
        Self::Input(format!("{fault}{advice}"))
    }
}

impl From<bouncelab_report::Error> for Failure {
    fn from(fault: bouncelab_report::Error) -> Self {
        Self::Input(fault.to_string())
    }
}

impl From<bouncelab_session::Error> for Failure {
    fn from(fault: bouncelab_session::Error) -> Self {
        use bouncelab_session::Error;
        match fault {
            Error::Notes { .. }
            | Error::Pattern { .. }
            | Error::NoRecordings { .. }
            | Error::Metadata { .. } => Self::Usage(fault.to_string()),
            Error::Output { .. } | Error::Busy { .. } => {
                Self::Input(format!("{fault} (--output DIR names another folder)"))
            }
            Error::UnknownDrop { name } => Self::Usage(format!(
                "--exclude {}: there is no such drop; write the recording as in the tables, \
                 with #2 for its second drop, and --exclude before each of several",
                Plain::of(&name)
            )),
            Error::UnknownField { name, known } => {
                let known = match known.as_slice() {
                    [] => "no metadata".to_owned(),
                    _ => known.join(", "),
                };
                Self::Usage(format!(
                    "--by {}: nothing is noted of that; there is {known}",
                    Plain::of(&name)
                ))
            }
            _ => Self::Input(fault.to_string()),
        }
    }
}
