use std::fmt;
use std::io;

use crate::formats::SoundFormat;
use crate::problem::{LayoutProblem, LooksLike, MissingContent, Stage, TimesProblem};

/// Errors of reading samples or times from a file, of writing a file, and of microphones.
///
/// Each message states the file, what is wrong with it and what to do. Damage that leaves part of the sound readable is a
/// [`Warning`](crate::Warning) instead.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The file does not exist.
    #[error("{name}: no such file; check the spelling and the folder")]
    NotFound {
        /// The file as the caller named it.
        name: String,
    },

    /// The path is that of a pipe or a device, which can be read only from the beginning to the end.
    #[error(
        "{name}: is a pipe or a device, which can be read only once, from beginning to end; save it as a file first"
    )]
    Pipe {
        /// The pipe as the caller named it.
        name: String,
    },

    /// The path is that of a folder.
    #[error("{name}: is a folder; name the recordings in it")]
    Directory {
        /// The folder as the caller named it.
        name: String,
    },

    /// The file has no bytes, or a header and nothing after it.
    #[error("{name}: empty: {what}; record or export it again")]
    Empty {
        /// The file as the caller named it.
        name: String,
        /// What is missing.
        what: MissingContent,
    },

    /// The content is in none of the formats of [`SoundFormat`], whatever the name of the file is.
    #[error(
        "{name}: not a sound file: it looks like {looks_like}; the formats that are read are {}",
        SoundFormat::names()
    )]
    NotSound {
        /// The file as the caller named it.
        name: String,
        /// What the first bytes look like.
        looks_like: LooksLike,
    },

    /// The format is known, but the file violates its rules before any sound could be decoded.
    #[error("{name}: damaged or unusual {format} file: cannot {stage} ({detail}); export it again")]
    Malformed {
        /// The file as the caller named it.
        name: String,
        /// Name of the format, such as "MP4".
        format: &'static str,
        /// The stage of reading.
        stage: Stage,
        /// The error of the demuxer or decoder.
        detail: String,
    },

    /// The file has no track with sound.
    #[error(
        "{name}: this {format} file has no audio track, or none of a known kind; was the microphone off?"
    )]
    NoAudioTrack {
        /// The file as the caller named it.
        name: String,
        /// Name of the format, such as "MP4".
        format: &'static str,
    },

    /// The codec of the sound, or this variant of it, cannot be decoded.
    #[error(
        "{name}: cannot decode the sound in this {format} file: {codec}; \
         convert it, for example with: ffmpeg -i INPUT output.wav"
    )]
    UnsupportedCodec {
        /// The file as the caller named it.
        name: String,
        /// Name of the format, such as "MP4".
        format: &'static str,
        /// The codec, and what in it is not supported.
        codec: String,
    },

    /// The sound was decoded but is refused: its sample rate is too low or too high, or it has too many channels.
    #[error("{name}: {problem}")]
    UnsupportedLayout {
        /// The file as the caller named it.
        name: String,
        /// What is wrong and what is expected.
        problem: LayoutProblem,
    },

    /// The recording is longer than the maximum for its sample rate and number of channels.
    #[error("{name}: lasts longer than {max_h} hours, the maximum; cut it into parts")]
    TooLong {
        /// The file as the caller named it.
        name: String,
        /// The maximum, in hours.
        max_h: f64,
    },

    /// A file is neither a list of impact times nor a sampled waveform in text.
    #[error("{name}{}: {}", AtLine(*line), Shortened(problem))]
    Times {
        /// The file as the caller named it.
        name: String,
        /// The line, counted from 1; `None` if the problem is not in one line.
        line: Option<usize>,
        /// What is wrong and what is expected.
        problem: TimesProblem,
    },

    /// The samples do not fit into a WAV file.
    #[error("{name}: cannot write this sound: {problem}")]
    Unwritable {
        /// The file as the caller named it.
        name: String,
        /// What is wrong and what is allowed.
        problem: String,
    },

    /// A recording would overwrite a file.
    #[error("{name}: exists already and is not overwritten; choose another name")]
    Exists {
        /// The file as the caller named it.
        name: String,
    },

    /// The microphone cannot be opened, or stopped.
    #[error("microphone {name}: {problem}")]
    Microphone {
        /// The device as the caller or the system names it.
        name: String,
        /// What is wrong and what to do.
        problem: String,
    },

    /// The operating system refused to read or write.
    #[error("{name}: {source}")]
    Io {
        /// The file as the caller named it.
        name: String,
        /// The system's reason.
        source: io::Error,
    },
}

/// Shorthand for results with this crate's [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// The error for a path that the system could not open, read or write.
    pub(crate) fn io(name: &str, source: io::Error) -> Self {
        let name = name.to_owned();
        match source.kind() {
            io::ErrorKind::NotFound => Self::NotFound { name },
            io::ErrorKind::IsADirectory => Self::Directory { name },
            io::ErrorKind::NotSeekable => Self::Pipe { name },
            io::ErrorKind::AlreadyExists => Self::Exists { name },
            _ => Self::Io { name, source },
        }
    }

    /// The error for a list of times or a waveform, or for one of its lines.
    pub(crate) fn times(name: &str, line: Option<usize>, problem: TimesProblem) -> Self {
        Self::Times {
            name: name.to_owned(),
            line,
            problem,
        }
    }

    /// The error for samples that do not fit into a WAV file.
    pub(crate) fn unwritable(name: &str, problem: impl Into<String>) -> Self {
        Self::Unwritable {
            name: name.to_owned(),
            problem: problem.into(),
        }
    }
}

/// Prints ", line 3", or nothing.
struct AtLine(Option<usize>);

impl fmt::Display for AtLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(line) => write!(f, ", line {line}"),
            None => Ok(()),
        }
    }
}

/// Prints a problem without the middle of what it quotes, if that is long: a file may be one line of megabytes.
struct Shortened<'a>(&'a TimesProblem);

impl fmt::Display for Shortened<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        /// Maximum length in letters, and the parts of it before and behind what is left out: the end says what to do.
        const MAX: usize = 600;
        const FRONT: usize = 300;
        const BACK: usize = 250;
        let text = self.0.to_string();
        let letters = text.chars().count();
        if letters <= MAX {
            return f.write_str(&text);
        }
        let front: String = text.chars().take(FRONT).collect();
        let back: String = text.chars().skip(letters - BACK).collect();
        write!(f, "{front} … {back}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_problem_quotes_no_megabytes() {
        let text = "x".repeat(3_000_000);
        let error = Error::times("long.csv", Some(1), TimesProblem::NotNumber { text });
        let said = error.to_string();
        assert!(
            said.len() < 700 && said.starts_with("long.csv, line 1: "),
            "{said}"
        );
        assert!(said.ends_with("expected a number such as 0.125"), "{said}");
    }
}
