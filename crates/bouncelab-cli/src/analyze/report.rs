//! The report of a recording, as a file.

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use bouncelab_report::report::{self, Markdown, Page, Provenance, Recording};
use bouncelab_session::journal::hash_of_file;
use jiff::Zoned;
use tempfile::NamedTempFile;

use super::hear::Hearing;
use crate::failure::Failure;
use crate::physics::Physics;

/// What is said to several files.
pub(super) const OF_ONE: &str =
    "a report is of one recording, and there are several: bouncelab session makes one of many";

/// How a report is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Html,
    Markdown,
}

/// A report that is going to be written: its place is known to be writable before any work is done.
pub(crate) struct Draft {
    path: PathBuf,
    form: Form,
    file: NamedTempFile,
}

impl Draft {
    /// A report at a path whose ending says its form.
    pub(crate) fn new(path: &Path) -> Result<Self, Failure> {
        let ending = path.extension().map(OsStr::to_ascii_lowercase);
        let form = match ending.as_ref().and_then(|ending| ending.to_str()) {
            Some("html" | "htm") => Form::Html,
            Some("md" | "markdown") => Form::Markdown,
            _ => {
                return Err(Failure::Usage(format!(
                    "a report is HTML or Markdown, so {} must end in .html or .md",
                    path.display()
                )));
            }
        };
        let file = draft_in(folder(path)).map_err(|reason| refused(path, &reason))?;
        Ok(Self {
            path: path.to_owned(),
            form,
            file,
        })
    }

    /// Writes the report of what was heard in a file.
    pub(super) fn finish(
        self,
        heard: &Path,
        hearing: &Hearing,
        physics: &Physics,
    ) -> Result<(), Failure> {
        self.write(&page(heard, hearing, physics)?)
    }

    /// Writes a page; it appears whole or not at all.
    pub(crate) fn write(self, page: &Page) -> Result<(), Failure> {
        let text = match self.form {
            Form::Html => page.html(),
            Form::Markdown => self.markdown(page)?.text,
        };
        self.file
            .as_file()
            .write_all(text.as_bytes())
            .and_then(|()| self.file.as_file().sync_all())
            .map_err(|reason| refused(&self.path, &reason))?;
        let path = self.path;
        self.file
            .persist(&path)
            .map_err(|refusal| refused(&path, &refusal.error))?;
        eprintln!("wrote {}", path.display());
        Ok(())
    }

    /// The page as Markdown, with its figures in a folder beside it.
    fn markdown(&self, page: &Page) -> Result<Markdown, Failure> {
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        let name = format!("{stem}-figures");
        let markdown = page.markdown(&name);
        let folder = folder(&self.path).join(&name);
        let written = fs::create_dir_all(&folder).and_then(|()| {
            let mut figures = markdown.figures.iter();
            figures.try_for_each(|(name, svg)| fs::write(folder.join(name), svg))
        });
        written.map_err(|reason| refused(&folder, &reason))?;
        Ok(markdown)
    }
}

/// A temporary file that others may read once it has its name.
fn draft_in(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".bouncelab-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

fn folder(path: &Path) -> &Path {
    let parent = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    parent.unwrap_or(Path::new("."))
}

fn refused(path: &Path, reason: &io::Error) -> Failure {
    Failure::Input(format!(
        "cannot write the report {}: {reason}; does its folder exist, and is it writable?",
        path.display()
    ))
}

fn page(heard: &Path, hearing: &Hearing, physics: &Physics) -> Result<Page, Failure> {
    let recording = Recording {
        name: &hearing.name,
        origin: &hearing.origin,
        settings: &physics.settings,
        ball_label: &physics.ball_label,
        assumptions: &physics.assumptions,
        drops: &hearing.drops,
        no_drop: hearing.no_drop.as_deref(),
        warnings: &hearing.warnings,
        sound: hearing.envelope.as_ref(),
    };
    let provenance = Provenance {
        files: vec![(hearing.name.clone(), hash_of_file(heard)?)],
        ..provenance()
    };
    Ok(report::of_recording(&recording, &provenance))
}

/// The command of this run and the day.
pub(crate) fn provenance() -> Provenance {
    Provenance {
        command: Some(command()),
        files: Vec::new(),
        made: Some(Zoned::now().strftime("%Y-%m-%d").to_string()),
    }
}

/// The command as it was given, ready for a shell.
fn command() -> String {
    let arguments = std::env::args_os().skip(1);
    let quoted = arguments.map(|argument| quoted(&argument.to_string_lossy()));
    std::iter::once("bouncelab".to_owned())
        .chain(quoted)
        .collect::<Vec<String>>()
        .join(" ")
}

/// A word as a shell reads it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./:=,+%@".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_for_a_shell() {
        assert_eq!(quoted("--height=30.5cm"), "--height=30.5cm");
        assert_eq!(quoted("my drop.wav"), "'my drop.wav'");
        assert_eq!(quoted("it's"), r"'it'\''s'");
        assert_eq!(quoted(""), "''");
    }
}
