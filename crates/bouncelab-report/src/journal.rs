//! Lines of a journal of results.
//!
//! Each result is one line: a checksum and a JSON object. A line that was cut off or damaged does
//! not match its checksum and counts as never written; this does not affect other lines. A result is
//! valid for one recording with one content under one set of settings, which its key identifies.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::hash::{Hash, hash};

/// Name of the journal in the folder of the results.
pub const JOURNAL: &str = "journal.jsonl";

/// The text behind the checksum of every line.
const NAMED: &str = " {\"name\":";

/// Number of hexadecimal digits of a checksum.
const CHECK_LEN: usize = 16;

/// What a result is made from: the content of a recording and the settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Key {
    /// Hash of the content of the recording.
    pub content: Hash,
    /// Hash of everything else that the result depends on.
    pub settings: Hash,
}

#[derive(Serialize)]
struct Line<'a, R> {
    name: &'a str,
    key: &'a Key,
    result: &'a R,
}

/// Name and key of a line, without its result.
#[derive(Debug, Deserialize)]
pub struct Of {
    /// What the recording is called.
    pub name: String,
    /// What the result is made from.
    pub key: Key,
}

#[derive(Deserialize)]
struct Held<R> {
    result: R,
}

/// A result as a line, with its line break.
///
/// # Errors
/// If it cannot be written as JSON.
pub fn line<R: Serialize>(name: &str, key: &Key, result: &R) -> serde_json::Result<String> {
    let text = serde_json::to_string(&Line { name, key, result })?;
    Ok(format!("{} {text}\n", check(&text)))
}

/// The text of a whole line, if it matches its checksum.
pub fn checked(line: &[u8]) -> Option<&str> {
    let line = std::str::from_utf8(line.strip_suffix(b"\n")?).ok()?;
    let (stated, text) = line.split_once(' ')?;
    (stated == check(text)).then_some(text)
}

/// What the text of a line is the result of.
///
/// # Errors
/// If it is no text of a line.
pub fn of(text: &str) -> serde_json::Result<Of> {
    serde_json::from_str(text)
}

/// The result in the text of a line.
///
/// # Errors
/// If it is of another kind.
pub fn result<R: DeserializeOwned>(text: &str) -> serde_json::Result<R> {
    Ok(serde_json::from_str::<Held<R>>(text)?.result)
}

/// Whether this may be a line of a journal, or the beginning of one, by its first letters.
pub fn begins_line(line: &[u8]) -> bool {
    let (check, named) = line.split_at(CHECK_LEN.min(line.len()));
    let is_digit = |letter: &u8| matches!(letter, b'0'..=b'9' | b'a'..=b'f');
    let mut letters = std::iter::zip(named, NAMED.as_bytes());
    check.iter().all(is_digit) && letters.all(|(letter, expected)| letter == expected)
}

fn check(text: &str) -> String {
    let mut hash = hash(text.as_bytes()).to_string();
    hash.truncate(CHECK_LEN);
    hash
}
