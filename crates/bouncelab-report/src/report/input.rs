//! The input of a report.

use bouncelab::settings::Setup;

/// A recording, or a list of times, with its settings and result.
#[derive(Debug, Clone, Copy)]
pub struct ReportInput<'a> {
    /// Its name, as it was given.
    pub name: &'a str,
    /// The settings, given or assumed.
    pub setup: &'a Setup,
    /// The result of its analysis.
    pub result: &'a bouncelab::Recording,
}

/// How to get the same page again.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Provenance {
    /// The command, ready to be typed.
    pub command: Option<String>,
    /// Name and SHA-256 (in hexadecimal) of each file that was read.
    pub files: Vec<(String, String)>,
    /// When the page was made, as it is shown.
    pub made: Option<String>,
}
