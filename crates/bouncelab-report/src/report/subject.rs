//! What a page is about, and where it comes from.

use bouncelab::analysis::{Drop, Options};
use bouncelab::detection::Envelope;

use crate::document::Origin;

/// A recording, or a list of times, and what it said.
#[derive(Debug, Clone, Copy)]
pub struct Recording<'a> {
    /// Its name, as the person gave it.
    pub name: &'a str,
    /// Where the times come from.
    pub origin: &'a Origin,
    /// What was known or assumed.
    pub settings: &'a Options,
    /// The ball in words.
    pub ball_label: &'a str,
    /// What of it nobody stated, one phrase for each.
    pub assumptions: &'a [String],
    /// The drops in it, in order of time.
    pub drops: &'a [Drop],
    /// Why there is none.
    pub no_drop: Option<&'a str>,
    /// What is odd about the recording.
    pub warnings: &'a [String],
    /// Loudness over time, if it is a sound.
    pub sound: Option<&'a Envelope>,
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
