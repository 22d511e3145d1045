//! Lines of CSV.

/// A row of a table, its cells quoted where they must be.
///
/// ```
/// assert_eq!(bouncelab_report::csv::line(&["drop", "loud, near"]), "drop,\"loud, near\"\n");
/// ```
pub fn line<T: AsRef<str>>(cells: &[T]) -> String {
    let quoted = cells.iter().map(|cell| {
        let cell = cell.as_ref();
        if cell.contains([',', '"', '\n', '\r']) {
            format!("\"{}\"", cell.replace('"', "\"\""))
        } else {
            cell.to_owned()
        }
    });
    quoted.collect::<Vec<_>>().join(",") + "\n"
}

/// What begins a formula in a spreadsheet, by the list of OWASP, "CSV Injection": some take the full width of a sign for the
/// sign.
pub const FORMULA_SIGNS: [char; 11] = [
    '=', '+', '-', '@', '\t', '\r', '\n', '\u{ff1d}', '\u{ff0b}', '\u{ff0d}', '\u{ff20}',
];

/// A text in a cell of CSV that no spreadsheet runs: where it begins as a formula does, `'` is put in front.
///
/// ```
/// use bouncelab_report::csv::guarded;
///
/// assert_eq!(guarded("=HYPERLINK(A1)".to_owned()), "'=HYPERLINK(A1)");
/// assert_eq!(guarded("\u{ff1d}1+1".to_owned()), "'\u{ff1d}1+1");
/// assert_eq!(guarded("drop.wav".to_owned()), "drop.wav");
/// ```
pub fn guarded(text: String) -> String {
    if text.starts_with(FORMULA_SIGNS) {
        format!("'{text}")
    } else {
        text
    }
}
