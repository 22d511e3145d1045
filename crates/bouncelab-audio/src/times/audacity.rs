//! Label tracks, as Audacity exports them: a line for each label with its start, its end and its text, separated
//! by tabs; below it, after a backslash, the frequencies that were selected with it, if any (Audacity manual,
//! "Importing and Exporting Labels").

use super::Entry;
use super::table::number;

/// The starts of the labels of a track; `None` if a line is not a label, such as a row of a table.
pub(super) fn starts(text: &str) -> Option<Vec<Entry>> {
    let is_label = |(line, _): &(&str, usize)| !line.trim().is_empty() && !line.starts_with('\\');
    let lines = text.lines().zip(1..).filter(is_label);
    lines
        .map(|(line, number)| Some((Some(number), start(line)?)))
        .collect()
}

fn start(label: &str) -> Option<f64> {
    let mut cells = label.splitn(3, '\t');
    let mut next = || number(cells.next()?.trim(), ',');
    let (start_s, end_s) = (next()?, next()?);
    // The text may be empty, but its tab is there.
    cells.next().filter(|_| start_s <= end_s).map(|_| start_s)
}
