//! `TextGrid` files of Praat, long and short.
//!
//! Both contain the same series of numbers, texts between quotation marks and flags between angle brackets. All other
//! words, and everything behind an exclamation mark on a line, are for people (Praat manual, "`TextGrid` file formats").

use bouncelab::Plain;

use super::{Entry, Result};
use crate::problem::TimesProblem;

/// The name of the tier with the impacts, if there are several.
const TIER: &str = "impacts";

/// A tier: its name, and time and line of each point; `None` if it has intervals.
type Tier = (String, Option<Vec<Entry>>);

/// The times of the points of a tier.
pub(super) fn points(text: &str) -> Result<Vec<Entry>> {
    let mut words = Words { text, line: 1 };
    let Some(mut tiers) = tiers(&mut words) else {
        return Err((Some(words.line), TimesProblem::NotTextGrid));
    };
    let has_points = tiers.iter().any(|(_, points)| points.is_some());
    if has_points {
        tiers.retain(|(_, points)| points.is_some());
    }
    let index = match tiers.len() {
        1 => Some(0),
        _ => tiers.iter().position(|(name, _)| name == TIER),
    };
    if let Some(points) = index.and_then(|index| tiers[index].1.take()) {
        return Ok(points);
    }
    let names: Vec<&str> = tiers.iter().map(|(name, _)| name.as_str()).collect();
    let found = match names.as_slice() {
        [] => "-".to_owned(),
        _ => Plain::of(&names.join(", ")).into(),
    };
    let problem = if has_points {
        TimesProblem::WhichPointTier { found }
    } else {
        TimesProblem::NoPointTier { found }
    };
    Err((None, problem))
}

/// The tiers; `None` if the text has another structure, or ends within them.
fn tiers(words: &mut Words<'_>) -> Option<Vec<Tier>> {
    words.text().filter(|kind| kind == "ooTextFile")?;
    words.text().filter(|class| class == "TextGrid")?;
    words.extent()?;
    if words.word()? != Word::Flag("<exists>") {
        return Some(Vec::new());
    }
    let mut tiers = Vec::new();
    for _ in 0..words.count()? {
        let (class, name) = (words.text()?, words.text()?);
        words.extent()?;
        let items = words.count()?;
        if class == "TextTier" {
            tiers.push((name, Some(marks(words, items)?)));
        } else {
            tiers.push((name, None));
            for _ in 0..items {
                words.extent()?;
                words.text()?;
            }
        }
    }
    Some(tiers)
}

fn marks(words: &mut Words<'_>, count: usize) -> Option<Vec<Entry>> {
    let mut points = Vec::new();
    for _ in 0..count {
        let time_s = words.number()?;
        points.push((Some(words.line), time_s));
        words.text()?;
    }
    Some(points)
}

/// A word with a meaning.
#[derive(Debug, PartialEq)]
enum Word<'a> {
    Number(f64),
    Text(String),
    Flag(&'a str),
}

/// The rest of the text, and its line.
struct Words<'a> {
    text: &'a str,
    line: usize,
}

impl<'a> Words<'a> {
    fn word(&mut self) -> Option<Word<'a>> {
        loop {
            self.skip(self.text.len() - self.text.trim_start().len());
            match self.text.chars().next()? {
                '"' => return self.quoted().map(Word::Text),
                '!' => {
                    self.skip(self.text.find('\n').unwrap_or(self.text.len()));
                }
                _ => {
                    let end = self.text.find(char::is_whitespace);
                    let word = self.skip(end.unwrap_or(self.text.len()));
                    if word.starts_with('<') {
                        return Some(Word::Flag(word));
                    }
                    if let Some(number) = word.parse().ok().filter(|it: &f64| it.is_finite()) {
                        return Some(Word::Number(number));
                    }
                }
            }
        }
    }

    /// The text up to the next quotation mark that is not doubled.
    fn quoted(&mut self) -> Option<String> {
        let mut text = String::new();
        self.skip(1);
        loop {
            text.push_str(self.skip(self.text.find('"')?));
            self.skip(1);
            if !self.text.starts_with('"') {
                return Some(text);
            }
            text.push('"');
            self.skip(1);
        }
    }

    /// Skips a number of bytes, and returns them.
    fn skip(&mut self, bytes: usize) -> &'a str {
        let (skipped, rest) = self.text.split_at(bytes);
        self.line += skipped.matches('\n').count();
        self.text = rest;
        skipped
    }

    fn text(&mut self) -> Option<String> {
        match self.word()? {
            Word::Text(text) => Some(text),
            _ => None,
        }
    }

    fn number(&mut self) -> Option<f64> {
        match self.word()? {
            Word::Number(number) => Some(number),
            _ => None,
        }
    }

    fn count(&mut self) -> Option<usize> {
        let number = self.number()?;
        (number >= 0.0).then_some(number as usize)
    }

    /// The beginning and end of a tier or interval.
    fn extent(&mut self) -> Option<[f64; 2]> {
        Some([self.number()?, self.number()?])
    }
}
