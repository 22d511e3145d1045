//! Tables as data: columns with a type, a unit and a meaning, and rows of cells.

use std::borrow::{Borrow, Cow};

use serde::{Deserialize, Serialize};

use crate::csv;

/// What the cells of a column hold; any cell may be empty.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// Text.
    Text,
    /// A number.
    Number,
    /// A whole number.
    Count,
    /// Yes or no.
    Flag,
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// Its name, with the unit at its end if there is one: `height_m`.
    pub name: Cow<'static, str>,
    /// What its cells hold.
    pub kind: Kind,
    /// Its unit, as in "m/s"; empty for text and plain numbers.
    pub unit: Cow<'static, str>,
    /// What it means, in one sentence.
    pub about: Cow<'static, str>,
}

/// A cell; `None` is not known.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Cell {
    /// Text.
    Text(Option<String>),
    /// A number; one that is not finite counts as not known.
    Number(Option<f64>),
    /// A whole number.
    Count(Option<usize>),
    /// Yes or no.
    Flag(Option<bool>),
}

impl Cell {
    /// Its text, if it holds one.
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => text.as_deref(),
            _ => None,
        }
    }

    /// Its number, if it holds a finite one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => number.filter(|number| number.is_finite()),
            _ => None,
        }
    }

    /// Its whole number, if it holds one.
    pub fn count(&self) -> Option<i64> {
        match *self {
            Self::Count(count) => count.and_then(|count| i64::try_from(count).ok()),
            _ => None,
        }
    }

    /// Its yes or no, if it holds one.
    pub const fn flag(&self) -> Option<bool> {
        match *self {
            Self::Flag(flag) => flag,
            _ => None,
        }
    }

    /// Whether it is not known.
    pub fn is_empty(&self) -> bool {
        match self {
            Self::Text(_) => self.text().is_none(),
            Self::Number(_) => self.number().is_none(),
            Self::Count(_) => self.count().is_none(),
            Self::Flag(_) => self.flag().is_none(),
        }
    }

    /// The cell in a line of CSV, empty if it is not known.
    fn in_csv(&self, formulas: Formulas) -> String {
        match self {
            Self::Text(_) => formulas.text(self.text().unwrap_or_default()),
            Self::Number(_) => self.number().map_or_else(String::new, |it| it.to_string()),
            Self::Count(_) => self.count().map_or_else(String::new, |it| it.to_string()),
            Self::Flag(_) => self.flag().map_or_else(String::new, |it| it.to_string()),
        }
    }
}

/// Whether texts in CSV that a spreadsheet would run as formulas are changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Formulas {
    /// They get `'` in front, so that they are texts.
    Guarded,
    /// They stay as they are.
    Raw,
}

impl Formulas {
    fn text(self, text: &str) -> String {
        match self {
            Self::Guarded => csv::guarded(text.to_owned()),
            Self::Raw => text.to_owned(),
        }
    }

    /// The first line of a table as CSV: the names of its columns.
    pub fn header(self, columns: &[Column]) -> String {
        let names = columns.iter().map(|it| self.text(&it.name));
        csv::line(&names.collect::<Vec<_>>())
    }

    /// A row as a line of CSV.
    pub fn line(self, row: &[Cell]) -> String {
        let cells = row.iter().map(|cell| cell.in_csv(self));
        csv::line(&cells.collect::<Vec<_>>())
    }
}

/// A table in memory.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct DataTable {
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows, each with a cell for each column.
    pub rows: Vec<Vec<Cell>>,
}

impl DataTable {
    /// A table with these columns, without rows.
    pub const fn new(columns: Vec<Column>) -> Self {
        let rows = Vec::new();
        Self { columns, rows }
    }

    /// A table of these rows.
    pub fn of<R, B: Borrow<R>>(
        definitions: &[Definition<CellOf<R>>],
        rows: impl IntoIterator<Item = B>,
    ) -> Self {
        let cells = |row: B| cells(definitions, row.borrow());
        Self {
            columns: columns(definitions),
            rows: rows.into_iter().map(cells).collect(),
        }
    }

    /// The table as CSV.
    pub fn csv(&self, formulas: Formulas) -> String {
        formulas.header(&self.columns) + &self.lines(formulas)
    }

    /// The rows as lines of CSV.
    pub fn lines(&self, formulas: Formulas) -> String {
        self.rows.iter().map(|row| formulas.line(row)).collect()
    }
}

/// The function that makes the cell of a column from a row.
pub type CellOf<R> = fn(&R) -> Cell;

/// A column, and the function that makes its cell from a row: [`CellOf`], unless rows borrow.
pub type Definition<F> = (Column, F);

/// The columns of definitions.
pub fn columns<F>(definitions: &[Definition<F>]) -> Vec<Column> {
    let columns = definitions.iter().map(|(column, _)| column.clone());
    columns.collect()
}

/// A row as cells, one for each column.
pub fn cells<R>(definitions: &[Definition<CellOf<R>>], row: &R) -> Vec<Cell> {
    definitions.iter().map(|(_, cell)| cell(row)).collect()
}

/// Defines columns, one a line: name, kind, unit, meaning, and the value in a row, which is an `Option`
/// and may use `?`.
///
/// ```
/// use bouncelab_report::data_table::{Cell, CellOf, Definition, cells};
/// use bouncelab_report::define_columns;
///
/// const BALLS: &[Definition<CellOf<f64>>] = define_columns! { |mass_kg: f64|
///     mass_kg: Number ["kg"] "mass of the ball" = Some(*mass_kg);
/// };
/// assert_eq!(BALLS[0].0.name, "mass_kg");
/// assert_eq!(cells(BALLS, &0.0027), [Cell::Number(Some(0.0027))]);
/// ```
#[macro_export]
macro_rules! define_columns {
    (|$row:ident: $type:ty| $($name:ident: $kind:ident [$unit:literal] $about:literal = $value:expr;)*) => {
        &[$((
            $crate::data_table::Column {
                name: ::std::borrow::Cow::Borrowed(stringify!($name)),
                kind: $crate::data_table::Kind::$kind,
                unit: ::std::borrow::Cow::Borrowed($unit),
                about: ::std::borrow::Cow::Borrowed($about),
            },
            |$row: &$type| {
                let value = || $value;
                $crate::data_table::Cell::$kind(value())
            },
        )),*]
    };
}
