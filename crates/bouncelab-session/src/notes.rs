//! Reads metadata of recordings from a TOML file or a CSV.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use bouncelab::Plain;
use bouncelab::settings::Settings;
use bouncelab_report::file::read_noted;
use bouncelab_report::rules;
use serde::Deserialize;
use toml::Spanned;

use crate::error::{Error, Result};
use crate::name;

/// No table of notes is longer, or has more columns.
const MAX_MB: u64 = 16;
const MAX_COLUMNS: usize = 1_000;

/// Nor more cells with something in them, each of which is a note in memory.
const MAX_CELLS: usize = 500_000;

/// A statement and who made it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// What was said, as it was written.
    pub text: String,
    /// Who said it: "notes.csv, line 3", "the file name".
    pub said_by: Arc<str>,
}

/// Statements by the name of their field.
pub type Notes = BTreeMap<String, Note>;

/// What a session file says.
#[derive(Debug, Default)]
pub(crate) struct SessionFile {
    pub(crate) title: Option<String>,
    pub(crate) pattern: Option<String>,
    pub(crate) notes: Option<PathBuf>,
    pub(crate) folders: Option<Vec<PathBuf>>,
    pub(crate) settings: Settings,
    pub(crate) all: Notes,
    pub(crate) balls: BTreeMap<String, Notes>,
    pub(crate) recordings: Listed,
}

/// Recordings as a file of notes calls them, with what it says of each.
#[derive(Debug, Default)]
pub(crate) struct Listed {
    pub(crate) file: PathBuf,
    /// Name, line and notes.
    pub(crate) rows: Vec<(String, Option<usize>, Notes)>,
}

type Table = BTreeMap<String, Spanned<toml::Value>>;

/// The TOML as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    title: Option<String>,
    pattern: Option<String>,
    notes: Option<PathBuf>,
    folders: Option<Vec<PathBuf>>,
    #[serde(default)]
    settings: Settings,
    #[serde(default)]
    all: Table,
    #[serde(default)]
    balls: BTreeMap<String, Table>,
    #[serde(default)]
    recordings: BTreeMap<String, Spanned<Table>>,
}

impl SessionFile {
    pub(crate) fn read(path: &Path) -> Result<Self> {
        let text = text_of(path, rules::MAX_MB)?;
        let written: Written = toml::from_str(&text).map_err(|fault| {
            let place = fault
                .span()
                .map(|span| Lines::new(path, &text).place(span.start));
            Error::Notes {
                path: path.to_owned(),
                line: place.map(|(line, _)| line),
                column: place.map(|(_, column)| column),
                problem: fault.message().trim_end().to_owned(),
            }
        })?;
        let lines = Lines::new(path, &text);
        let notes = |table: Table| lines.notes(table);
        let recordings = written.recordings.into_iter().map(|(name, table)| {
            let line = lines.number(table.span().start);
            Ok((name, Some(line), notes(table.into_inner())?))
        });
        Ok(Self {
            title: written.title.map(|title| Plain::of(&title).into()),
            pattern: written.pattern,
            notes: written.notes,
            folders: written.folders,
            settings: written.settings,
            recordings: Listed {
                file: path.to_owned(),
                rows: recordings.collect::<Result<_>>()?,
            },
            all: notes(written.all)?,
            balls: written
                .balls
                .into_iter()
                .map(|(ball, table)| Ok((Plain::of(&ball).into(), notes(table)?)))
                .collect::<Result<_>>()?,
        })
    }
}

/// The lines of a file of notes.
struct Lines<'a> {
    path: &'a Path,
    text: &'a str,
    /// Where each line but the first begins.
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    fn new(path: &'a Path, text: &'a str) -> Self {
        let starts = text.match_indices('\n').map(|(end, _)| end + 1).collect();
        Self { path, text, starts }
    }

    /// The line of a byte, counted from 1.
    fn number(&self, byte: usize) -> usize {
        self.starts.partition_point(|&start| start <= byte) + 1
    }

    /// Line and column, counted from 1, of a byte.
    fn place(&self, byte: usize) -> (usize, usize) {
        let line = self.number(byte);
        let start = line.checked_sub(2).map_or(0, |line| self.starts[line]);
        let before = self.text.get(start..byte).unwrap_or_default();
        (line, before.chars().count() + 1)
    }

    fn notes(&self, table: Table) -> Result<Notes> {
        table
            .into_iter()
            .map(|(field, value)| {
                let start = value.span().start;
                let said = match value.into_inner() {
                    toml::Value::String(said) => said,
                    toml::Value::Integer(said) => said.to_string(),
                    toml::Value::Float(said) => said.to_string(),
                    toml::Value::Boolean(said) => said.to_string(),
                    toml::Value::Datetime(said) => said.to_string(),
                    toml::Value::Array(_) | toml::Value::Table(_) => {
                        let (line, column) = self.place(start);
                        return Err(Error::Notes {
                            path: self.path.to_owned(),
                            line: Some(line),
                            column: Some(column),
                            problem: format!(
                                "{field} must be a text or a number, as in \"30.5cm\""
                            ),
                        });
                    }
                };
                let line = self.number(start);
                let said_by = format!("{}, line {line}", name::shown(self.path)).into();
                let text = Plain::of(said.trim()).into();
                Ok((Plain::of(&field).into(), Note { text, said_by }))
            })
            .collect()
    }
}

/// Reads a CSV with a column `recording` and one column for each field.
///
/// Commas, semicolons or tabs separate; a heading may end in a unit in brackets, as in
/// "height (cm)"; an empty cell says nothing.
pub(crate) fn read_csv(path: &Path) -> Result<Listed> {
    let text = text_of(path, MAX_MB)?;
    let header = text
        .lines()
        .find(|line| !line.is_empty())
        .unwrap_or_default();
    let delimiter = [b',', b';', b'\t']
        .into_iter()
        .max_by_key(|&delimiter| header.bytes().filter(|&byte| byte == delimiter).count());
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter.unwrap_or(b','))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let headings: Vec<(String, String)> = reader
        .headers()
        .map_err(|fault| csv_fault(path, &fault))?
        .iter()
        .map(heading)
        .collect();
    if headings.len() > MAX_COLUMNS {
        let columns = headings.len();
        let problem = format!("has {columns} columns (at most {MAX_COLUMNS} are read)");
        return Err(Error::notes(path, Some(1), problem));
    }
    let mut fields = BTreeSet::new();
    for (field, _) in headings.iter().filter(|(field, _)| !field.is_empty()) {
        if !fields.insert(field) {
            let problem = format!("has two columns \"{field}\"; leave one out or rename it");
            return Err(Error::notes(path, Some(1), problem));
        }
    }
    let named = headings.iter().position(|(field, _)| field == "recording");
    let named = named.ok_or_else(|| {
        let found: Vec<&str> = headings.iter().map(|(field, _)| field.as_str()).collect();
        Error::notes(
            path,
            Some(1),
            format!(
                "has no column \"recording\"; its columns are {}",
                found.join(", ")
            ),
        )
    })?;
    let (mut rows, mut noted) = (Vec::new(), 0);
    for record in reader.records() {
        let record = record.map_err(|fault| csv_fault(path, &fault))?;
        let line = record.position().map(|position| position.line() as usize);
        let said_by: Arc<str> = match line {
            Some(line) => format!("{}, line {line}", name::shown(path)).into(),
            None => name::shown(path).into(),
        };
        let cells = headings.iter().zip(&record).enumerate();
        let cells = cells.filter(|(_, (_, cell))| !cell.is_empty());
        if let Some((_, (_, cell))) = cells.clone().find(|(_, ((field, _), _))| field.is_empty()) {
            let problem = format!("\"{cell}\" stands in a column without a name; give it one");
            return Err(Error::notes(path, line, problem));
        }
        let notes =
            cells
                .filter(|(column, _)| *column != named)
                .map(|(_, ((field, unit), cell))| {
                    let number = match delimiter {
                        Some(b',') => Cow::Borrowed(cell),
                        _ => with_point(cell),
                    };
                    let note = Note {
                        text: Plain::of(&format!("{number}{unit}")).into(),
                        said_by: said_by.clone(),
                    };
                    (field.clone(), note)
                });
        let notes: Notes = notes.collect();
        noted += notes.len();
        if noted > MAX_CELLS {
            let problem =
                format!("has more than {MAX_CELLS} cells; leave out columns or recordings");
            return Err(Error::notes(path, line, problem));
        }
        let recording = record.get(named).unwrap_or_default().to_owned();
        rows.push((recording, line, notes));
    }
    Ok(Listed {
        file: path.to_owned(),
        rows,
    })
}

/// "Height (cm)" as ("height", "cm").
fn heading(text: &str) -> (String, String) {
    let open = text.find(['(', '[']);
    let (field, unit) = open.map_or((text, ""), |open| text.split_at(open));
    let unit = unit.trim_matches(|c: char| "()[] ".contains(c));
    let field = String::from(Plain::of(field.trim()))
        .to_lowercase()
        .replace([' ', '-'], "_");
    (field, unit.to_owned())
}

/// A number with a decimal comma, as spreadsheets of many countries write it, with a point; anything
/// else as it is.
fn with_point(cell: &str) -> Cow<'_, str> {
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let number = cell.split_once(',').filter(|(whole, rest)| {
        is_digits(whole.trim_start_matches(['+', '-']))
            && rest.starts_with(|c: char| c.is_ascii_digit())
            && !rest.contains(',')
    });
    match number {
        Some((whole, rest)) => Cow::Owned(format!("{whole}.{rest}")),
        None => Cow::Borrowed(cell),
    }
}

fn csv_fault(path: &Path, fault: &csv::Error) -> Error {
    let line = fault.position().map(|position| position.line() as usize);
    let problem = match fault.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!(
            "has {len} cells, but the first line has {expected_len}; put text with a separator in \
             quotes"
        ),
        _ => fault.to_string(),
    };
    Error::notes(path, line, problem)
}

/// The text of a file of notes, without the mark that some programs put at its beginning.
fn text_of(path: &Path, most_mb: u64) -> Result<String> {
    let bytes = read_noted(path, most_mb).map_err(Error::read(path))?;
    let mut text = String::from_utf8(bytes).map_err(|fault| {
        let valid = &fault.as_bytes()[..fault.utf8_error().valid_up_to()];
        let line = valid.split(|&byte| byte == b'\n').count();
        Error::notes(path, Some(line), "is no UTF-8 text; save it as UTF-8")
    })?;
    if text.starts_with('\u{feff}') {
        text.remove(0);
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use bouncelab::settings::Input;

    use super::*;

    #[cfg(unix)]
    #[test]
    fn what_can_be_no_notes_is_refused_at_once() {
        let (_folder, link) = written("link.csv", b"");
        fs::remove_file(&link).unwrap();
        std::os::unix::fs::symlink("/dev/zero", &link).unwrap();
        let refused = read_csv(&link).err().unwrap().to_string();
        assert!(refused.contains("a device"), "{refused}");
        let columns = (0..1_000_000).map(|n| format!("a{n},"));
        let columns = columns.collect::<Vec<_>>().concat();
        let (_folder, wide) = written("wide.csv", format!("recording,{columns}\n").as_bytes());
        let refused = read_csv(&wide).err().unwrap().to_string();
        assert!(refused.contains("columns"), "{refused}");
        let deep = format!("title = {}", "[".repeat(1_000_000));
        let (_folder, deep) = written("deep.toml", deep.as_bytes());
        assert!(SessionFile::read(&deep).is_err());
    }

    fn written(name: &str, bytes: &[u8]) -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        (folder, path)
    }

    #[test]
    fn a_session_file_with_everything() {
        let text = "title = \"Class 9b\"\npattern = \"{ball}_{}\"\n[settings.air]\ndrag = \"constant:0.45\"\n\
                    [settings.inference]\nknown = { mass = 0.001 }\n[all]\ntemperature = 21.5\n\
                    [balls.red]\nkind = \"table-tennis-40\"\n[recordings.\"a.wav\"]\n\
                    height = \"30.5 cm\"\nlid = true\n";
        let (_folder, path) = written("session.toml", text.as_bytes());
        let file = SessionFile::read(&path).unwrap();
        assert_eq!(file.title.as_deref(), Some("Class 9b"));
        assert_eq!(file.settings.air.drag.as_deref(), Some("constant:0.45"));
        assert!((file.settings.inference.known.unwrap()[&Input::Mass] - 0.001).abs() < 1e-12);
        assert_eq!(file.all["temperature"].text, "21.5");
        assert_eq!(file.balls["red"]["kind"].text, "table-tennis-40");
        let (name, line, notes) = &file.recordings.rows[0];
        assert_eq!((name.as_str(), *line), ("a.wav", Some(11)));
        assert_eq!(notes["height"].text, "30.5 cm");
        assert!(notes["height"].said_by.ends_with("session.toml, line 12"));
        assert_eq!(notes["lid"].text, "true");
    }

    #[test]
    fn faults_of_a_session_file_have_a_place() {
        let fault = |text: &str| {
            let (_folder, path) = written("session.toml", text.as_bytes());
            SessionFile::read(&path).unwrap_err().to_string()
        };
        let unclosed = fault("title = \"a\"\npattern = \"{ball}\n");
        assert!(
            unclosed.contains("session.toml, line 2, column"),
            "{unclosed}"
        );
        let unknown = fault("titel = \"a\"\n");
        assert!(unknown.contains("line 1, column 1"), "{unknown}");
        assert!(
            unknown.contains("titel") && unknown.contains("title"),
            "{unknown}"
        );
        let setting = fault("[settings.ball]\nmas_kg = 0.0027\n");
        assert!(
            setting.contains("line 2, column 1") && setting.contains("mass_kg"),
            "{setting}"
        );
        let list = fault("[all]\n\nheight = [1, 2]\n");
        assert!(
            list.contains("line 3, column 10") && list.contains("height"),
            "{list}"
        );
    }

    #[test]
    fn a_csv_with_units_in_its_headings() {
        let text = "\u{feff}\nRecording;Height (cm);Ball type;note\na.wav;30.5;red;\nb.wav;\"40\";;\"x;y\"\n";
        let (_folder, path) = written("notes.csv", text.as_bytes());
        let listed = read_csv(&path).unwrap();
        let (name, line, notes) = &listed.rows[0];
        assert_eq!((name.as_str(), *line), ("a.wav", Some(3)));
        assert_eq!(notes["height"].text, "30.5cm");
        assert_eq!(notes["ball_type"].text, "red");
        assert!(!notes.contains_key("note"));
        assert_eq!(listed.rows[1].2["note"].text, "x;y");
    }

    /// As a German spreadsheet saves them.
    #[test]
    fn decimal_commas_are_read_where_commas_do_not_separate() {
        let noted = |text: &str| {
            let (_folder, path) = written("notes.csv", text.as_bytes());
            let listed = read_csv(&path).unwrap();
            let (_, _, notes) = &listed.rows[0];
            ["height", "temperature", "surface"].map(|field| notes[field].text.clone())
        };
        assert_eq!(
            noted("recording;height (cm);temperature;surface\na.wav;30,5;-1,5 C;wood, 1,5 mm\n"),
            ["30.5cm", "-1.5 C", "wood, 1,5 mm"]
        );
        assert_eq!(
            noted("recording,height (cm),temperature,surface\na.wav,\"30,5\",20,\"1,2\"\n"),
            ["30,5cm", "20", "1,2"]
        );
    }

    #[test]
    fn faults_of_a_csv_have_a_line() {
        let fault = |bytes: &[u8]| {
            let (_folder, path) = written("notes.csv", bytes);
            read_csv(&path).unwrap_err().to_string()
        };
        assert!(fault(b"name,height\na,1\n").contains("no column \"recording\""));
        let short = fault(b"recording,height\na.wav,1\nb.wav\n");
        assert!(
            short.contains("line 3") && short.contains("has 1 cells"),
            "{short}"
        );
        let latin = fault(b"recording,surface\na.wav,M\xfcnchen\n");
        assert!(
            latin.contains("line 2") && latin.contains("UTF-8"),
            "{latin}"
        );
        assert!(fault(b"").contains("no column"));
        let twice = fault(b"recording,height (cm),Height\na.wav,30,40cm\n");
        assert!(twice.contains("two columns \"height\""), "{twice}");
        let nameless = fault(b"recording,surface,\na.wav,steel,30cm\n");
        assert!(
            nameless.contains("line 2") && nameless.contains("\"30cm\""),
            "{nameless}"
        );
    }
}
