//! The subject of a page, and its source.

use bouncelab::setup::Setup;

/// A recording, or a list of times, and what it says.
#[derive(Debug, Clone, Copy)]
pub struct Recording<'a> {
    /// Its name, as the person gave it.
    pub name: &'a str,
    /// What was known or assumed.
    pub setup: &'a Setup,
    /// What it says.
    pub result: &'a bouncelab::Recording,
}

/// How to get the same page again.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Provenance {
    /// The command, ready to be typed.
    pub command: Option<String>,
    /// Name and SHA-256 (in hexadecimal) of each file that was read.
    pub files: Vec<(String, String)>,
    /// When the page was made, as it shall be shown.
    pub made: Option<String>,
}
