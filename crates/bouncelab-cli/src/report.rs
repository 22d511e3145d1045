//! Reports as files.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use bouncelab_report::Saved;
use bouncelab_report::file::{Draft, write_whole};
use bouncelab_report::report::{Markdown, Page, Provenance};
use jiff::Zoned;

use crate::failure::Failure;
use crate::language::text_with;

/// How a report is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Html,
    Markdown,
}

/// A file for a report, known to be writable before any work is done.
pub(crate) struct ReportFile {
    path: PathBuf,
    form: Form,
}

impl ReportFile {
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
        // Gone at once: who interrupts the work finds nothing lying about.
        drop(Draft::new(path).map_err(|reason| Failure::unwritable(path, &reason))?);
        Ok(Self {
            path: path.to_owned(),
            form,
        })
    }

    /// Writes a page; it appears whole or not at all.
    pub(crate) fn write(self, page: &Page) -> Result<(), Failure> {
        let text = match self.form {
            Form::Html => page.html(),
            Form::Markdown => self.markdown(page)?.text,
        };
        let path = self.path;
        write_whole(&path, text.as_bytes())
            .map_err(|reason| Failure::unwritable(&path, &reason))?;
        wrote(&path);
        Ok(())
    }

    /// The page as Markdown, with its figures in a folder beside it.
    fn markdown(&self, page: &Page) -> Result<Markdown, Failure> {
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        let name = format!("{stem}-figures");
        let markdown = page.markdown(&name);
        let folder = self.path.with_file_name(&name);
        let written = fs::create_dir_all(&folder).and_then(|()| {
            let mut figures = markdown.figures.iter();
            figures.try_for_each(|(name, svg)| write_whole(&folder.join(name), svg.as_bytes()))
        });
        written.map_err(|reason| Failure::unwritable(&folder, &reason))?;
        Ok(markdown)
    }
}

/// Says on stderr that a file was written.
pub(crate) fn wrote(path: &Path) {
    let file = path.display().to_string();
    eprintln!("{}", text_with("terminal-wrote", &[("file", file.into())]));
}

/// Says on stderr that a figure was written.
pub(crate) fn wrote_figure(saved: &Saved) {
    let file = saved.svg.display().to_string();
    eprintln!(
        "{}",
        text_with("terminal-wrote-figure", &[("file", file.into())])
    );
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
pub(crate) fn quoted(word: &str) -> String {
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
    fn a_place_is_tried_and_nothing_left_there() {
        let folder = tempfile::tempdir().unwrap();
        assert!(ReportFile::new(&folder.path().join("drop.html")).is_ok());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        assert!(ReportFile::new(&folder.path().join("nowhere/drop.html")).is_err());
    }

    #[test]
    fn words_are_quoted_for_a_shell() {
        assert_eq!(quoted("--height=30.5cm"), "--height=30.5cm");
        assert_eq!(quoted("my drop.wav"), "'my drop.wav'");
        assert_eq!(quoted("it's"), r"'it'\''s'");
        assert_eq!(quoted(""), "''");
    }
}
