//! Sheets of spreadsheets as texts: a line for each row, with tabs between the cells.

use std::io::Cursor;
use std::mem::take;

use calamine::{Data, DataType as _, Reader as _, Xls, Xlsx};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use zip::ZipArchive;

use super::ListFormat;
use super::book::{Budget, NamedTable, damaged};
use crate::contain;
use crate::problem::TimesProblem;

type Result<T> = std::result::Result<T, TimesProblem>;

/// Maximum number of sheets that are read.
const MAX_SHEETS: usize = 50;
/// Maximum size of a workbook, unpacked, in bytes.
const MAX_LEN: u64 = 24 << 20;
/// Number of rows and columns that are read: spreadsheets have no more rows, and no list has more columns.
const MAX_ROWS: usize = 1 << 20;
const MAX_COLUMNS: usize = 64;
/// Maximum number of cells of a sheet, and of the area of all sheets of an `.xls`, which its reader keeps in memory.
const MAX_CELLS: usize = 1 << 21;

/// Where a cell is, row first, and its text.
type Cell = (usize, usize, String);

/// The sheets of a workbook in an archive; `None` if the archive is not a workbook.
pub(super) fn of_archive(content: &[u8]) -> Result<Option<Vec<NamedTable>>> {
    let mut archive = ZipArchive::new(Cursor::new(content)).map_err(damaged)?;
    let is_open = archive.index_for_name("content.xml").is_some();
    if !is_open && archive.index_for_name("[Content_Types].xml").is_none() {
        return Ok(None);
    }
    let mut budget = Budget::new(MAX_LEN);
    if is_open {
        let file = archive.by_name("content.xml").map_err(damaged)?;
        let content = budget.unpack(file)?;
        return open_sheets(str::from_utf8(&content).map_err(damaged)?).map(Some);
    }
    // The library unpacks without a limit, and what the archive announces may be wrong.
    for index in 0..archive.len() {
        budget.unpack(archive.by_index(index).map_err(damaged)?)?;
    }
    contained(|| xlsx(content)).map(Some)
}

/// Runs a library that may panic at damaged files.
fn contained<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    contain(work).unwrap_or_else(|| Err(damaged("the sheets are damaged")))
}

fn xlsx(content: &[u8]) -> Result<Vec<NamedTable>> {
    let mut book = Xlsx::new(Cursor::new(content)).map_err(damaged)?;
    let names = book.sheet_names();
    let sheets = names.into_iter().take(MAX_SHEETS).map(|name| {
        let mut reader = book.worksheet_cells_reader(&name).map_err(damaged)?;
        let mut cells = Vec::new();
        while let Some(cell) = reader.next_cell().map_err(damaged)? {
            let (row, column) = cell.get_position();
            let value = Data::from(cell.get_value().clone());
            push(&mut cells, (row as usize, column as usize), &value)?;
        }
        Ok(sheet(name, cells))
    });
    sheets.collect()
}

/// The sheets of an `.xls`.
pub(super) fn xls(content: &[u8]) -> Result<Vec<NamedTable>> {
    check_area(content)?;
    contained(|| {
        let mut book: Xls<_> = Xls::new(Cursor::new(content)).map_err(damaged)?;
        let sheets = book
            .worksheets()
            .into_iter()
            .take(MAX_SHEETS)
            .map(|(name, range)| {
                let (first_row, first_column) = range.start().unwrap_or_default();
                let mut cells = Vec::new();
                for (row, column, value) in range.used_cells() {
                    let place = (row + first_row as usize, column + first_column as usize);
                    push(&mut cells, place, value)?;
                }
                Ok(sheet(name, cells))
            });
        sheets.collect()
    })
}

/// Refuses an `.xls` whose sheets would not fit into memory: its reader keeps the area between the outermost cells,
/// which a few bytes can state. The records are those of [MS-XLS], 2.3.
fn check_area(content: &[u8]) -> Result<()> {
    let mut file = cfb::CompoundFile::open(Cursor::new(content)).map_err(damaged)?;
    let is_book = |name: &str| {
        ["workbook", "book"]
            .iter()
            .any(|it| name.eq_ignore_ascii_case(it))
    };
    let streams = file
        .walk()
        .filter(|entry| entry.is_stream() && is_book(entry.name()));
    let paths: Vec<_> = streams.map(|entry| entry.path().to_owned()).collect();
    let mut books = Vec::new();
    for path in paths {
        let stream = file.open_stream(path).map_err(damaged)?;
        books.push(Budget::new(MAX_LEN).unpack(stream)?);
    }
    let too_long = TimesProblem::TooLong {
        max_mb: MAX_LEN >> 20,
    };
    for book in &books {
        let mut starts = Vec::new();
        let mut area = Area::default();
        area.grow(book, &mut starts);
        if starts.len() > MAX_SHEETS {
            return Err(too_long);
        }
        for &start in &starts {
            area.grow(book.get(start..).unwrap_or_default(), &mut Vec::new());
        }
        if area
            .rows
            .saturating_mul(area.columns)
            .saturating_mul(starts.len())
            > MAX_CELLS
        {
            return Err(too_long);
        }
    }
    Ok(())
}

/// The outermost row and column of all cells.
#[derive(Default)]
struct Area {
    rows: usize,
    columns: usize,
}

impl Area {
    /// Takes in the cells of all records that follow, and notes where sheets start.
    fn grow(&mut self, mut records: &[u8], starts: &mut Vec<usize>) {
        const SHEET: u16 = 0x0085;
        const DIMENSIONS: u16 = 0x0200;
        const SEVERAL: u16 = 0x00bd;
        const CELLS: [u16; 8] = [
            0x0006, 0x00d6, 0x00fd, 0x0203, 0x0204, 0x0205, 0x027e, SEVERAL,
        ];
        while let Some((&[a, b, c, d], rest)) = records.split_first_chunk() {
            let (kind, len) = (
                u16::from_le_bytes([a, b]),
                usize::from(u16::from_le_bytes([c, d])),
            );
            let (data, next) = rest.split_at(len.min(rest.len()));
            let word = |at: usize| {
                data.get(at..at + 2)
                    .map_or(0, |it| usize::from(it[0]) | usize::from(it[1]) << 8)
            };
            let long = |at: usize| word(at) | word(at + 2) << 16;
            match kind {
                SHEET => starts.push(long(0)),
                // Ends are behind the last row and column; rows have four bytes since 1997.
                DIMENSIONS if len >= 14 => self.include(long(4), word(10)),
                DIMENSIONS => self.include(word(2), word(6)),
                SEVERAL => self.include(word(0) + 1, word(len.saturating_sub(2)) + 1),
                _ if CELLS.contains(&kind) => self.include(word(0) + 1, word(2) + 1),
                _ => {}
            }
            records = next;
        }
    }

    fn include(&mut self, rows: usize, columns: usize) {
        self.rows = self.rows.max(rows);
        self.columns = self.columns.max(columns);
    }
}

/// The sheets of an `OpenDocument`.
fn open_sheets(content: &str) -> Result<Vec<NamedTable>> {
    let mut reader = Reader::from_str(content);
    let mut sheets = OpenSheets::default();
    loop {
        match reader.read_event().map_err(damaged)? {
            Event::Start(element) => sheets.start(&element),
            Event::Empty(element) => {
                sheets.start(&element);
                sheets.end(element.local_name().as_ref())?;
            }
            Event::Text(text) => {
                if let Some(cell) = &mut sheets.cell {
                    cell.text.push_str(&text.xml10_content());
                }
            }
            Event::End(element) => sheets.end(element.local_name().as_ref())?,
            Event::Eof => return Ok(sheets.sheets),
            _ => {}
        }
    }
}

/// The sheets so far: elements `table`, `table-row` and `table-cell`, of which the last two may stand for several.
#[derive(Default)]
struct OpenSheets {
    sheets: Vec<NamedTable>,
    name: String,
    cells: Vec<Cell>,
    row: usize,
    column: usize,
    /// For how many rows the present one stands.
    rows: usize,
    cell: Option<OpenCell>,
}

/// A cell of an `OpenDocument`.
struct OpenCell {
    /// For how many columns it stands.
    columns: usize,
    /// Its number, if it has one.
    value: Option<String>,
    text: String,
}

impl OpenSheets {
    fn start(&mut self, element: &BytesStart<'_>) {
        match element.local_name().as_ref() {
            "table" => {
                self.name = attribute(element, "table:name").unwrap_or_default();
                self.row = 0;
            }
            "table-row" => {
                self.rows = count(element, "table:number-rows-repeated");
                self.column = 0;
            }
            "table-cell" | "covered-table-cell" => {
                self.cell = Some(OpenCell {
                    columns: count(element, "table:number-columns-repeated"),
                    value: attribute(element, "office:value"),
                    text: String::new(),
                });
            }
            _ => {}
        }
    }

    fn end(&mut self, element: &str) -> Result<()> {
        match element {
            "table-cell" | "covered-table-cell" => {
                if let Some(cell) = self.cell.take() {
                    self.take(cell)?;
                }
            }
            "table-row" => self.row = self.row.saturating_add(self.rows).min(MAX_ROWS),
            "table" if self.sheets.len() < MAX_SHEETS => {
                let (name, cells) = (take(&mut self.name), take(&mut self.cells));
                self.sheets.push(sheet(name, cells));
            }
            _ => {}
        }
        Ok(())
    }

    fn take(&mut self, cell: OpenCell) -> Result<()> {
        let value = Data::String(cell.value.unwrap_or(cell.text));
        let columns = self.column..self.column.saturating_add(cell.columns).min(MAX_COLUMNS);
        self.column = columns.end;
        if value.as_string().is_some_and(|text| text.is_empty()) {
            return Ok(());
        }
        for row in self.row..self.row.saturating_add(self.rows).min(MAX_ROWS) {
            for column in columns.clone() {
                push(&mut self.cells, (row, column), &value)?;
            }
        }
        Ok(())
    }
}

fn attribute(element: &BytesStart<'_>, name: &str) -> Option<String> {
    let attribute = element.try_get_attribute(name).ok()??;
    Some(
        quick_xml::escape::unescape(&attribute.value)
            .ok()?
            .into_owned(),
    )
}

fn count(element: &BytesStart<'_>, name: &str) -> usize {
    attribute(element, name)
        .and_then(|count| count.parse().ok())
        .unwrap_or(1)
}

/// Adds a cell with content.
fn push(cells: &mut Vec<Cell>, (row, column): (usize, usize), value: &Data) -> Result<()> {
    let text = match value {
        Data::Empty => return Ok(()),
        Data::Int(number) => number.to_string(),
        Data::Float(number) => number.to_string(),
        // A date is no number of seconds.
        Data::DateTime(days) => format!("{} d", days.as_f64()),
        other => other.to_string(),
    };
    let text = text.replace(['\t', '\n', '\r', '"'], " ");
    if text.trim().is_empty() || row >= MAX_ROWS || column >= MAX_COLUMNS {
        return Ok(());
    }
    if cells.len() >= MAX_CELLS {
        return Err(TimesProblem::TooLong {
            max_mb: MAX_LEN >> 20,
        });
    }
    cells.push((row, column, text));
    Ok(())
}

/// A sheet as text; its lines are the rows.
fn sheet(name: String, mut cells: Vec<Cell>) -> NamedTable {
    cells.sort();
    let mut text = String::new();
    let (mut row, mut column) = (0, 0);
    for (cell_row, cell_column, cell) in cells {
        for _ in row..cell_row {
            text.push('\n');
            column = 0;
        }
        row = cell_row;
        for _ in column..cell_column {
            text.push('\t');
        }
        column = cell_column;
        // A line that begins with this sign would be a comment.
        if column == 0 && cell.starts_with('#') {
            text.push(' ');
        }
        text.push_str(&cell);
    }
    NamedTable {
        name,
        text,
        format: ListFormat::Text,
    }
}
