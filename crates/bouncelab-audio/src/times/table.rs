//! Texts as rows of cells.

use crate::problem::TimesProblem;

/// Number of lines by which the separator is recognised: what is above the table is shorter.
const BEGINNING: usize = 20;

/// A row that is not blank, with its line in the file.
pub(super) struct Row {
    pub(super) line: usize,
    pub(super) cells: Vec<String>,
}

/// A text as rows of cells.
pub(super) struct Table {
    pub(super) rows: Vec<Row>,
    /// The decimal sign besides the point: where commas do not separate, one in a number is its decimal sign.
    point: char,
}

impl Table {
    /// The rows of a text. Commas separate if the text is of a kind for which they do, or if points stand in its numbers.
    pub(super) fn of(text: &str, is_csv: bool) -> Result<Self, TimesProblem> {
        let (declared, text, skipped) = declared_separator(text);
        let mut lines = content(text, skipped);
        if let (Some((line, only)), None) = (lines.next(), lines.next())
            && let Some(numbers) = side_by_side(only)
        {
            let row = |cell: &str| Row {
                line,
                cells: vec![cell.replace(',', ".")],
            };
            let rows = numbers.into_iter().map(row).collect();
            return Ok(Self { rows, point: '.' });
        }
        let Some(separator) = declared.or_else(|| separator(&beginning(text), is_csv)) else {
            let row = |(line, cell): (usize, &str)| Row {
                line,
                cells: vec![cell.trim_matches('"').trim().to_owned()],
            };
            let rows = content(text, skipped).map(row).collect();
            return Ok(Self { rows, point: ',' });
        };
        let point = if separator == b',' { '.' } else { ',' };
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(separator)
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|fault| TimesProblem::NotTable {
                detail: fault.to_string(),
            })?;
            let line = record
                .position()
                .map_or(0, |position| position.line() as usize);
            if record.iter().any(|cell| !cell.is_empty()) {
                rows.push(Row {
                    line: line + skipped,
                    cells: record.iter().map(str::to_owned).collect(),
                });
            }
        }
        Ok(Self { rows, point })
    }

    /// The number in a cell.
    pub(super) fn number(&self, cell: &str) -> Option<f64> {
        number(cell, self.point)
    }
}

/// A finite number with a decimal point, or with another decimal sign.
pub(crate) fn number(cell: &str, point: char) -> Option<f64> {
    let parsed = if point == '.' {
        cell.parse()
    } else {
        cell.replace(point, ".").parse()
    };
    parsed.ok().filter(|number: &f64| number.is_finite())
}

/// Lines that are neither blank nor comments, trimmed, with their numbers.
fn content(text: &str, skipped: usize) -> impl Iterator<Item = (usize, &str)> {
    let lines = (skipped + 1..).zip(text.lines().map(str::trim));
    lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
}

fn beginning(text: &str) -> Vec<&str> {
    content(text, 0)
        .map(|(_, line)| line)
        .take(BEGINNING)
        .collect()
}

/// The separator in a first line `sep=;`, as spreadsheets write and read it; the rest of the text, and the number of lines
/// before it.
fn declared_separator(text: &str) -> (Option<u8>, &str, usize) {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    let declared = first
        .trim_end_matches('\r')
        .trim_matches('"')
        .to_ascii_lowercase();
    match declared.strip_prefix("sep=").map(str::as_bytes) {
        Some(&[separator]) => (Some(separator), rest, 1),
        _ => (None, text, 0),
    }
}

/// The separator of the cells of lines; `None` if each line is one cell.
pub(crate) fn separator(lines: &[&str], is_csv: bool) -> Option<u8> {
    let has = |sign| lines.iter().any(|line| line.contains(sign));
    if has('\t') {
        return Some(b'\t');
    }
    if has(';') {
        return Some(b';');
    }
    let is_text = |line: &&&str| line.contains(char::is_alphabetic) && number(line, ',').is_none();
    let mut headings = lines.iter().filter(is_text).peekable();
    // Below a heading without a comma there is one column.
    let has_one_column = match headings.peek() {
        Some(_) => !headings.any(|line| line.contains(',')),
        None => !is_csv,
    };
    let is_decimal = has_one_column && !has('.');
    Some(b',').filter(|_| has(',') && !is_decimal)
}

/// The numbers of a text of one line, if it holds nothing else: `0.86, 1.43`, `0,86; 1,43` or `0,86 1,43`.
fn side_by_side(line: &str) -> Option<Vec<&str>> {
    let has_points = line.contains('.');
    let separates = |sign: char| sign == ';' || sign.is_whitespace() || (sign == ',' && has_points);
    // A comma before a space separates; one within a number is its decimal sign.
    let cells = line.split(separates).map(|cell| cell.trim_end_matches(','));
    let numbers: Vec<&str> = cells.filter(|cell| !cell.is_empty()).collect();
    let all = numbers.iter().all(|cell| number(cell, ',').is_some());
    (all && numbers.len() > 1).then_some(numbers)
}
