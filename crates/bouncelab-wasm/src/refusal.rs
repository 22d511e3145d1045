//! Reasons for a refused request.

use bouncelab::Diagnostic;
use bouncelab_audio::{Error, LayoutProblem, LooksLike, MissingContent, Stage, TimesProblem};
use bouncelab_report::link::LinkProblem;
use serde::Serialize;
#[cfg(not(target_family = "wasm"))]
use ts_rs::TS;

/// Why something could not be done.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Refusal {
    /// What kind of trouble it is.
    pub kind: RefusalKind,
    /// What was wrong and what to do, in English.
    pub message: String,
    /// The same as data, where the science refused something.
    pub diagnostic: Option<Box<Diagnostic>>,
    /// The same as data, where a file or a link was refused.
    pub reason: Option<Box<Reason>>,
}

/// Kinds of trouble that a page may want to distinguish.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
#[serde(rename_all = "kebab-case")]
pub enum RefusalKind {
    /// The file has no content, or no sound or time in it.
    Empty,
    /// The file is no recording, or one of a kind that is not read.
    Unsupported,
    /// The file is damaged beyond use.
    Damaged,
    /// The list of times is invalid.
    Times,
    /// A setting that the physics refuses.
    Setting,
    /// The link of a drop cannot be made or read.
    Link,
    /// It does not fit into the memory of a browser.
    TooLong,
    /// A fault of the program itself.
    Fault,
}

/// What exactly is wrong with a file or a link. The page has a message for each in every language.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
#[serde(tag = "code", rename_all = "kebab-case")]
pub enum Reason {
    /// There is nothing in it.
    Empty {
        /// What is missing.
        what: MissingContent,
    },
    /// It is no sound.
    NotSound {
        /// What it looks like.
        looks_like: LooksLike,
    },
    /// It breaks the rules of its format.
    Malformed {
        /// The container, for example "MP4".
        format: String,
        /// What was being done.
        stage: Stage,
        /// The complaint of the reader or decoder, in English.
        detail: String,
    },
    /// It has no track with sound.
    NoAudioTrack {
        /// The container.
        format: String,
    },
    /// Its sound cannot be decoded.
    UnsupportedCodec {
        /// The container.
        format: String,
        /// The codec, and what about it is not supported, in English.
        codec: String,
    },
    /// Its sound is of no use.
    UnsupportedLayout {
        /// Why.
        problem: LayoutProblem,
    },
    /// It goes on for longer than is read.
    LastsTooLong {
        /// How many hours are read at most.
        max_h: f64,
    },
    /// The browser cannot read it any more.
    Unreadable,
    /// It is no list of times.
    Times {
        /// The line, counted from 1.
        line: Option<usize>,
        /// What is wrong.
        problem: TimesProblem,
    },
    /// It is a recording of the job already; each counts once.
    Counted {
        /// Its number.
        number: usize,
    },
    /// It is no link of a drop, or cannot be one.
    Link {
        /// Why.
        problem: LinkProblem,
    },
}

impl Reason {
    /// What a file was refused for; `None` for what does not happen to a file in a browser.
    fn of(error: &Error) -> Option<Self> {
        Some(match error {
            Error::Empty { what, .. } => Self::Empty { what: *what },
            Error::NotSound { looks_like, .. } => Self::NotSound {
                looks_like: *looks_like,
            },
            Error::Malformed {
                format,
                stage,
                detail,
                ..
            } => Self::Malformed {
                format: (*format).to_owned(),
                stage: *stage,
                detail: detail.clone(),
            },
            Error::NoAudioTrack { format, .. } => Self::NoAudioTrack {
                format: (*format).to_owned(),
            },
            Error::UnsupportedCodec { format, codec, .. } => Self::UnsupportedCodec {
                format: (*format).to_owned(),
                codec: codec.clone(),
            },
            Error::UnsupportedLayout { problem, .. } => {
                Self::UnsupportedLayout { problem: *problem }
            }
            Error::Io { .. } => Self::Unreadable,
            Error::TooLong { max_h, .. } => Self::LastsTooLong { max_h: *max_h },
            Error::Times { line, problem, .. } => Self::Times {
                line: *line,
                problem: problem.clone(),
            },
            _ => return None,
        })
    }
}

/// A result for the page.
pub type Result<T> = std::result::Result<T, Refusal>;

impl Refusal {
    /// A fault of the program itself.
    pub(crate) fn fault(message: impl Into<String>) -> Self {
        Self {
            kind: RefusalKind::Fault,
            message: message.into(),
            diagnostic: None,
            reason: None,
        }
    }
}

/// The refusal of a name that is not in the list.
pub(crate) fn unknown(kind: &'static str, name: &str, known: &[&str]) -> Refusal {
    bouncelab::Error::unknown_name(kind, name, known).into()
}

impl From<bouncelab::Error> for Refusal {
    fn from(error: bouncelab::Error) -> Self {
        Self {
            kind: RefusalKind::Setting,
            message: error.to_string(),
            diagnostic: Some(Box::new(error.diagnostic())),
            reason: None,
        }
    }
}

impl From<bouncelab_report::Error> for Refusal {
    fn from(error: bouncelab_report::Error) -> Self {
        Self::fault(error.to_string())
    }
}

impl From<LinkProblem> for Refusal {
    fn from(problem: LinkProblem) -> Self {
        Self {
            kind: RefusalKind::Link,
            message: problem.to_string(),
            diagnostic: None,
            reason: Some(Box::new(Reason::Link { problem })),
        }
    }
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        let kind = match error {
            Error::Empty { .. } => RefusalKind::Empty,
            Error::NotSound { .. }
            | Error::NoAudioTrack { .. }
            | Error::UnsupportedCodec { .. }
            | Error::UnsupportedLayout { .. } => RefusalKind::Unsupported,
            Error::Times { .. } => RefusalKind::Times,
            Error::TooLong { .. } => RefusalKind::TooLong,
            Error::Malformed { .. } | Error::Io { .. } => RefusalKind::Damaged,
            _ => RefusalKind::Fault,
        };
        Self {
            kind,
            message: error.to_string(),
            diagnostic: None,
            reason: Reason::of(&error).map(Box::new),
        }
    }
}

impl From<serde_json::Error> for Refusal {
    fn from(error: serde_json::Error) -> Self {
        Self::fault(format!(
            "the page and the engine have different versions: {error}"
        ))
    }
}

/// A refusal as it is thrown.
#[cfg(target_family = "wasm")]
impl From<Refusal> for wasm_bindgen::JsValue {
    fn from(refusal: Refusal) -> Self {
        let json = serde_json::to_string(&refusal);
        Self::from_str(&json.unwrap_or(refusal.message))
    }
}
