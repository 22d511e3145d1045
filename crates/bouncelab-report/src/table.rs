//! Plain-text tables.
//!
//! Own code rather than a library: columns, a rule and two alignments are all that is needed,
//! and the usual libraries bring wrapping, boxes and terminal control with them.

use std::fmt;

use bouncelab::Plain;
use serde::{Deserialize, Serialize};
use unicode_width::UnicodeWidthStr;

use crate::messages::Translator;

/// The side of its column at which a text is aligned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum Align {
    /// For words.
    Left,
    /// For numbers.
    Right,
}

/// A table in plain text: columns two spaces apart, a thin rule under the header.
///
/// ```
/// use bouncelab_report::{Align, Table};
///
/// let mut table = Table::new([("impact", Align::Right), ("time (s)", Align::Right)]);
/// table.row(["1", "0.000"]);
/// table.row(["2", "0.432"]);
/// assert_eq!(
///     table.to_string(),
///     "impact  time (s)\n\
///      ──────  ────────\n\
///      \u{20}    1     0.000\n\
///      \u{20}    2     0.432\n"
/// );
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Table {
    header: Vec<String>,
    align: Vec<Align>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// An empty table with the headings of its columns, and their alignment.
    pub fn new<H: Into<String>>(columns: impl IntoIterator<Item = (H, Align)>) -> Self {
        let (header, align) = columns
            .into_iter()
            .map(|(heading, align)| (one_line(heading), align))
            .unzip();
        Self {
            header,
            align,
            rows: Vec::new(),
        }
    }

    /// An empty table whose headings are messages, by their ids; an empty id is an empty heading.
    pub fn with_headings<'a>(
        translator: &Translator,
        columns: impl IntoIterator<Item = (&'a str, Align)>,
    ) -> Self {
        let columns = columns.into_iter();
        Self::new(columns.map(|(id, align)| (translator.text(id), align)))
    }

    /// Adds a row. Missing cells at its end stay empty, cells beyond the last column are
    /// left out, and a line break in a cell becomes a space.
    pub fn row<C: Into<String>>(&mut self, cells: impl IntoIterator<Item = C>) {
        let mut row: Vec<String> = cells.into_iter().map(one_line).collect();
        row.resize(self.header.len(), String::new());
        self.rows.push(row);
    }

    /// The headings and their alignment.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (&str, &Align)> {
        self.header.iter().map(String::as_str).zip(&self.align)
    }

    /// The rows, each as long as there are columns.
    pub(crate) fn rows(&self) -> &[Vec<String>] {
        &self.rows
    }

    /// Whether it has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    fn widths(&self) -> Vec<usize> {
        let widest = |column: usize| {
            let cells = self.rows.iter().map(|row| row[column].width());
            cells.fold(self.header[column].width(), usize::max)
        };
        (0..self.header.len()).map(widest).collect()
    }

    fn line(&self, cells: &[String], widths: &[usize]) -> String {
        let padded: Vec<String> = cells
            .iter()
            .zip(widths)
            .zip(&self.align)
            .map(|((cell, width), align)| {
                let space = " ".repeat(width.saturating_sub(cell.width()));
                match align {
                    Align::Left => format!("{cell}{space}"),
                    Align::Right => format!("{space}{cell}"),
                }
            })
            .collect();
        padded.join("  ").trim_end().to_owned()
    }
}

fn one_line(text: impl Into<String>) -> String {
    Plain::of(&text.into()).into()
}

/// The whole table; each line ends with a line break and without spaces.
impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let widths = self.widths();
        let rule: Vec<String> = widths.iter().map(|width| "─".repeat(*width)).collect();
        writeln!(f, "{}", self.line(&self.header, &widths))?;
        writeln!(f, "{}", self.line(&rule, &widths))?;
        for row in &self.rows {
            writeln!(f, "{}", self.line(row, &widths))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_right_and_words_left() {
        let mut table = Table::new([("ball", Align::Left), ("e", Align::Right)]);
        table.row(["table tennis", "0.94"]);
        table.row(["squash", "0.5"]);
        assert_eq!(
            table.to_string(),
            "ball             e\n\
             ────────────  ────\n\
             table tennis  0.94\n\
             squash         0.5\n"
        );
    }

    #[test]
    fn columns_line_up_by_width_not_by_bytes_or_letters() {
        let mut table = Table::new([("file", Align::Left), ("n", Align::Right)]);
        table.row(["ボール.wav", "38"]);
        table.row(["± µ.wav", "7"]);
        let text = table.to_string();
        let widths: Vec<usize> = text.lines().map(UnicodeWidthStr::width).collect();
        assert_eq!(widths, [14, 14, 14, 14], "{text}");
    }

    #[test]
    fn short_and_long_rows_and_line_breaks_keep_the_shape() {
        let mut table = Table::new([("a", Align::Left), ("b", Align::Left)]);
        table.row(["x"]);
        table.row(["1\n2", "y", "beyond"]);
        assert_eq!(table.to_string(), "a     b\n────  ─\nx\n1\\n2  y\n");
    }
}
