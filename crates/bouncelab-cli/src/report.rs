//! Reports as files.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use bouncelab::Plain;
use bouncelab_report::Saved;
use bouncelab_report::file::{Outputs, create_folder};
use bouncelab_report::mark::{self, Mark};
use bouncelab_report::report::{Markdown, Page, Provenance};
use clap::Args;
use jiff::Zoned;

use crate::browser::Browser;
use crate::failure::Failure;
use crate::invocation::Invocation;
use crate::language::{text, text_with};
use crate::terminal::say;

/// Which files a command may replace.
#[derive(Args, Clone, Debug)]
pub(crate) struct OutputArguments {
    /// Replace also files that bouncelab did not write; recordings that are read are never replaced
    #[arg(long)]
    force: bool,
}

impl OutputArguments {
    /// What a command may write that reads these files.
    pub(crate) fn outputs(&self, inputs: impl IntoIterator<Item = impl AsRef<Path>>) -> Outputs {
        Outputs::new(inputs, self.force)
    }

    /// What a command may write that reads no files.
    pub(crate) fn of_no_input(&self) -> Outputs {
        self.outputs([""; 0])
    }
}

/// How a report is written.
enum Form {
    Html,
    Markdown,
    /// Printed by a browser.
    Pdf(Browser),
}

impl Form {
    /// The mark of an earlier report.
    const fn mark(&self) -> Mark {
        match self {
            Self::Html => mark::HTML,
            Self::Markdown => mark::MARKDOWN,
            Self::Pdf(_) => mark::PDF,
        }
    }
}

/// A file for a report, which is checked to be writable before any work is done.
pub(crate) struct ReportFile<'a> {
    path: PathBuf,
    form: Form,
    outputs: &'a Outputs,
}

impl<'a> ReportFile<'a> {
    /// A report at a path whose ending determines its form.
    pub(crate) fn new(path: &Path, outputs: &'a Outputs) -> Result<Self, Failure> {
        let ending = path.extension().map(OsStr::to_ascii_lowercase);
        let form = match ending.as_ref().and_then(|ending| ending.to_str()) {
            Some("html" | "htm") => Form::Html,
            Some("md" | "markdown") => Form::Markdown,
            Some("pdf") => {
                let found = Browser::find();
                Form::Pdf(found.ok_or_else(|| Failure::Input(text("terminal-no-browser")))?)
            }
            _ => {
                return Err(Failure::Usage(format!(
                    "a report is HTML, Markdown or PDF, so {} must end in .html, .md or .pdf",
                    Plain::path(path)
                )));
            }
        };
        // Removed at once: an interrupted command leaves no file.
        let draft = outputs.draft(path, form.mark());
        drop(draft.map_err(|reason| Failure::unwritable(path, &reason))?);
        Ok(Self {
            path: path.to_owned(),
            form,
            outputs,
        })
    }

    /// Writes a page; it appears whole or not at all.
    pub(crate) fn write(self, page: &Page) -> Result<(), Failure> {
        let bytes = match &self.form {
            Form::Html => page.html().into_bytes(),
            Form::Markdown => self.markdown(page)?.text.into_bytes(),
            Form::Pdf(browser) => {
                let printed = browser.print(&page.html())?;
                // A comment behind the end, by which a report is known to be one of bouncelab.
                let comment = format!("% {}\n", mark::PDF.text());
                [printed, comment.into_bytes()].concat()
            }
        };
        write(self.outputs, &self.path, self.form.mark(), &bytes)
    }

    /// The page as Markdown, with its figures in a folder next to it.
    fn markdown(&self, page: &Page) -> Result<Markdown, Failure> {
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        let name = format!("{stem}-figures");
        let markdown = page.markdown(&name);
        let folder = self.path.with_file_name(&name);
        let written = create_folder(&folder).and_then(|()| {
            let mut figures = markdown.figures.iter();
            figures.try_for_each(|(name, svg)| {
                let path = folder.join(name);
                self.outputs.write(&path, mark::SVG, svg.as_bytes())
            })
        });
        written.map_err(|reason| Failure::unwritable(&folder, &reason))?;
        Ok(markdown)
    }
}

/// Writes a file as a whole, and reports it on stderr.
pub(crate) fn write(
    outputs: &Outputs,
    path: &Path,
    mark: Mark,
    bytes: &[u8],
) -> Result<(), Failure> {
    let written = outputs.write(path, mark, bytes);
    written.map_err(|reason| Failure::unwritable(path, &reason))?;
    wrote(path);
    Ok(())
}

/// Reports on stderr that a file was written.
pub(crate) fn wrote(path: &Path) {
    let file = String::from(Plain::path(path));
    say(text_with("terminal-wrote", &[("file", file.into())]));
}

/// Reports on stderr that a figure was written.
pub(crate) fn wrote_figure(saved: &Saved) {
    let file = String::from(Plain::path(&saved.svg));
    say(text_with("terminal-wrote-figure", &[("file", file.into())]));
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
    let arguments = &Invocation::of_this_process().arguments;
    let quoted = arguments
        .iter()
        .map(|argument| quoted(&argument.to_string_lossy()));
    std::iter::once("bouncelab".to_owned())
        .chain(quoted)
        .collect::<Vec<String>>()
        .join(" ")
}

/// A word as a shell reads it.
pub(crate) fn quoted(word: &str) -> String {
    let word = &String::from(Plain::of(word));
    let plain = |c: char| c.is_alphanumeric() || "-_./:=,+%@".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_place_is_tried_and_nothing_left_there() {
        let folder = tempfile::tempdir().unwrap();
        let outputs = Outputs::default();
        assert!(ReportFile::new(&folder.path().join("drop.html"), &outputs).is_ok());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        assert!(ReportFile::new(&folder.path().join("nowhere/drop.html"), &outputs).is_err());
    }

    #[test]
    fn words_are_quoted_for_a_shell() {
        assert_eq!(quoted("--height=30.5cm"), "--height=30.5cm");
        assert_eq!(quoted("my drop.wav"), "'my drop.wav'");
        assert_eq!(quoted("it's"), r"'it'\''s'");
        assert_eq!(quoted(""), "''");
    }
}
