//! Impacts in a table: which cells are times, and which are intervals between them.

use bouncelab::Plain;

use super::heading::{Column, Heading, seconds};
use super::table::{Row, Table};
use super::{Entry, Events, Result};
use crate::problem::TimesProblem;

/// Maximum number of rows above the headings, such as a title.
const MAX_TITLES: usize = 20;
/// Maximum relative difference of an interval from that between two times of the same table, which are rounded.
const MAX_DIFFERENCE: f64 = 0.01;

/// A column with a meaning.
#[derive(Clone, Copy)]
struct Chosen {
    index: usize,
    heading: Heading,
}

impl Events {
    /// The events of a table.
    pub(super) fn of_table(table: &Table) -> Result<Self> {
        let is_heading = |row: &Row| row.cells.iter().any(|cell| Heading::of(cell).is_some());
        match table.rows.iter().take(MAX_TITLES).position(is_heading) {
            Some(at) => below(table, &table.rows[at], &table.rows[at + 1..]),
            None => without_heading(table),
        }
    }

    /// The events of numbers without a heading: times if they increase, intervals if they decrease.
    pub(super) fn of_numbers(entries: Vec<Entry>) -> Result<Self> {
        let falls = entries.windows(2).all(|pair| pair[1].1 < pair[0].1);
        if falls && entries.len() > 1 && entries.iter().all(|entry| entry.1 > 0.0) {
            return Self::of_intervals(&entries);
        }
        match entries.windows(2).find(|pair| pair[1].1 <= pair[0].1) {
            Some(&[(_, before), (line, number)]) => {
                Err((line, TimesProblem::NoOrder { number, before }))
            }
            _ => Ok(Self::at(entries)),
        }
    }

    /// Events at these times.
    pub(super) fn at(entries: Vec<Entry>) -> Self {
        Self {
            entries,
            of_intervals: false,
            program: None,
        }
    }

    /// Events with these intervals between them, the first at zero.
    fn of_intervals(intervals: &[Entry]) -> Result<Self> {
        if let Some((line, interval)) = intervals.iter().find(|(_, interval)| *interval <= 0.0) {
            let text = interval.to_string();
            return Err((*line, TimesProblem::NotInterval { text }));
        }
        let first = intervals.first().map(|(line, _)| (*line, 0.0));
        let others = intervals.iter().scan(0.0, |time_s, (line, interval_s)| {
            *time_s += interval_s;
            Some((*line, *time_s))
        });
        Ok(Self {
            of_intervals: true,
            ..Self::at(first.into_iter().chain(others).collect())
        })
    }
}

/// The events below headings.
fn below(table: &Table, headings: &Row, rows: &[Row]) -> Result<Events> {
    let refuse = |problem| Err((Some(headings.line), problem));
    let found = || Plain::of(&headings.cells.join(", ")).into();
    let mut times = columns(headings, Column::Times);
    let mut intervals = columns(headings, Column::Intervals);
    if !times.is_empty() && headings.cells.iter().any(|cell| is_position(cell)) {
        return refuse(TimesProblem::Positions { found: found() });
    }
    if headings.cells.iter().any(|cell| cell == "recording") {
        return refuse(TimesProblem::OfRecordings);
    }
    let sole: Vec<Chosen> = times
        .iter()
        .filter(|it| !it.heading.is_one_of_several)
        .copied()
        .collect();
    if sole.len() == 1 {
        times = sole;
    }
    let rows = with_unit(rows, times.iter_mut().chain(&mut intervals));
    let reader = Reader {
        table,
        columns: headings.cells.len(),
    };
    let events = match (times.as_slice(), intervals.as_slice()) {
        ([times], intervals) => {
            let mut events = reader.column(*times, rows)?;
            if let [interval] = intervals {
                events.extend(reader.after_last(&events, *interval, rows));
            }
            Events::at(events)
        }
        ([], [interval]) => Events::of_intervals(&reader.column(*interval, rows)?)?,
        ([], several) if rows.len() == 1 => Events::of_intervals(&reader.row(several, &rows[0])?)?,
        (several, _) if rows.len() == 1 => Events::at(reader.row(several, &rows[0])?),
        _ if rows.is_empty() => Events::at(Vec::new()),
        _ => {
            let (found, rows) = (found(), rows.len());
            return refuse(TimesProblem::SeveralDrops { found, rows });
        }
    };
    Ok(Events {
        program: program(&headings.cells),
        ..events
    })
}

/// The columns of a meaning; if some headings consist of known words, only those.
fn columns(headings: &Row, column: Column) -> Vec<Chosen> {
    let read = headings.cells.iter().enumerate();
    let read = read.filter_map(|(index, cell)| {
        Some(Chosen {
            index,
            heading: Heading::of(cell)?,
        })
    });
    let mut chosen: Vec<Chosen> = read.filter(|it| it.heading.column == column).collect();
    if chosen.iter().any(|it| it.heading.is_plain) {
        chosen.retain(|it| it.heading.is_plain);
    }
    chosen
}

/// Whether a column has a coordinate of a moving body.
fn is_position(heading: &str) -> bool {
    let symbol = heading
        .split(|letter: char| !letter.is_alphanumeric())
        .next();
    symbol.is_some_and(|symbol| {
        ["x", "y", "z"]
            .iter()
            .any(|it| symbol.eq_ignore_ascii_case(it))
    })
}

/// The rows behind one that has only the units of the columns, which it sets.
fn with_unit<'a, 'b>(rows: &'a [Row], chosen: impl Iterator<Item = &'b mut Chosen>) -> &'a [Row] {
    let Some((first, rest)) = rows.split_first() else {
        return rows;
    };
    let mut has_units = false;
    for column in chosen {
        let cell = first.cells.get(column.index).map_or("", String::as_str);
        let unit = cell.trim_matches(['(', ')', '[', ']']).to_lowercase();
        if let Some(unit_s) = seconds(&unit) {
            column.heading.unit_s = unit_s;
            has_units = true;
        }
    }
    if has_units { rest } else { rows }
}

/// Reads the numbers of a table below its headings.
struct Reader<'a> {
    table: &'a Table,
    /// Number of headings.
    columns: usize,
}

impl Reader<'_> {
    /// The numbers of a column, in seconds; it may end before others do.
    fn column(&self, column: Chosen, rows: &[Row]) -> Result<Vec<Entry>> {
        let mut entries = Vec::new();
        let mut blank = None;
        for row in rows {
            self.check_width(row)?;
            let cell = row.cells.get(column.index).map_or("", String::as_str);
            if cell.is_empty() {
                blank = blank.or(Some(row.line));
            } else if let Some(line) = blank {
                return Err((Some(line), TimesProblem::Missing));
            } else {
                entries.push(self.number(cell, row.line, column.heading.unit_s)?);
            }
        }
        Ok(entries)
    }

    /// The numbers of a row, in seconds; a stopwatch leaves stops that it did not see blank or at zero.
    fn row(&self, columns: &[Chosen], row: &Row) -> Result<Vec<Entry>> {
        self.check_width(row)?;
        let is_seen = |cell: &&str| {
            let is_nan = cell.eq_ignore_ascii_case("nan");
            !cell.is_empty() && !is_nan && self.table.number(cell) != Some(0.0)
        };
        let cells = columns
            .iter()
            .map(|it| row.cells.get(it.index).map_or("", String::as_str));
        let last = cells.clone().collect::<Vec<_>>().iter().rposition(is_seen);
        let seen = std::iter::zip(columns, cells).take(last.map_or(0, |last| last + 1));
        seen.map(|(column, cell)| self.number(cell, row.line, column.heading.unit_s))
            .collect()
    }

    /// The event that ends the last interval, if each interval is that to the next time.
    fn after_last(&self, events: &[Entry], interval: Chosen, rows: &[Row]) -> Option<Entry> {
        let (line, last_s) = *events.last()?;
        let rows = rows.get(..events.len())?;
        let number = |row: &Row| self.table.number(row.cells.get(interval.index)?);
        let intervals_s: Option<Vec<f64>> = rows.iter().map(number).collect();
        let intervals_s: Vec<f64> = intervals_s?
            .iter()
            .map(|it| it * interval.heading.unit_s)
            .collect();
        let is_next = |(pair, interval_s): (&[Entry], &f64)| {
            (pair[1].1 - pair[0].1 - interval_s).abs() <= MAX_DIFFERENCE * interval_s
        };
        let are_next = std::iter::zip(events.windows(2), &intervals_s).all(is_next);
        let last_interval_s = intervals_s
            .last()
            .filter(|&&interval_s| interval_s > 0.0 && are_next)?;
        Some((line, last_s + last_interval_s))
    }

    /// A decimal comma would count as a separator.
    fn check_width(&self, row: &Row) -> Result<()> {
        let (found, columns) = (row.cells.len(), self.columns);
        let has_more = row.cells.iter().skip(columns).any(|cell| !cell.is_empty());
        let problem = has_more.then_some(TimesProblem::MoreColumns { found, columns });
        problem.map_or(Ok(()), |problem| Err((Some(row.line), problem)))
    }

    fn number(&self, cell: &str, line: usize, unit_s: f64) -> Result<Entry> {
        match self.table.number(cell) {
            Some(number) => Ok((Some(line), number * unit_s)),
            None if cell.is_empty() => Err((Some(line), TimesProblem::Missing)),
            None => {
                let text = cell.to_owned();
                Err((Some(line), TimesProblem::NotNumber { text }))
            }
        }
    }
}

/// The events of a table without a heading of times: one column of numbers, or of numbers with labels.
fn without_heading(table: &Table) -> Result<Events> {
    let Some(first) = table.rows.first() else {
        return Ok(Events::at(Vec::new()));
    };
    let is_number = |cell: &String| table.number(cell).is_some();
    let columns = first.cells.len();
    let is_label = |row: &Row| row.cells[1..].iter().all(|cell| !is_number(cell));
    if !first.cells.iter().any(is_number) && first.cells[0].starts_with(char::is_alphabetic) {
        let found = Plain::of(&first.cells.join(", ")).into();
        return Err((Some(first.line), TimesProblem::NoTimeColumn { found }));
    }
    if columns > 1 && !table.rows.iter().all(is_label) {
        return Err((Some(first.line), TimesProblem::NamelessColumns { columns }));
    }
    let reader = Reader { table, columns };
    let entries = table
        .rows
        .iter()
        .map(|row| reader.number(&row.cells[0], row.line, 1.0));
    Events::of_numbers(entries.collect::<Result<_>>()?)
}

/// The program that exports a table with these headings.
fn program(headings: &[String]) -> Option<&'static str> {
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    match headings.as_slice() {
        ["Event time (s)", "Interval (s)"]
        | ["Start (s)", "Stop (s)", "Difference (s)"]
        | ["Start (s)", "Stop 1 (s)", ..] => Some("phyphox acoustic stopwatch"),
        ["Bounce 0 (s)", "Height 0 (m)", ..] => Some("phyphox inelastic collision"),
        _ => None,
    }
}
