//! Text of others, made fit to be shown.
//!
//! Names of files, headings and notes come from anywhere. Shown as they are, escape codes in them would command
//! a terminal, and bidirectional controls or line breaks would make a line say something else.

use std::fmt::{self, Write as _};
use std::path::Path;

/// A text of others as one line that says what is in it: control characters, line breaks, bidirectional controls
/// and bytes that are no UTF-8 are written out. Ordinary text of any language stays as it is.
///
/// ```
/// use std::path::Path;
/// use bouncelab::Plain;
///
/// assert_eq!(Plain::of("red\u{1b}[31m\n").to_string(), r"red\u{1b}[31m\n");
/// assert_eq!(Plain::of("a\u{202e}vaw.").to_string(), r"a\u{202e}vaw.");
/// assert_eq!(Plain::path(Path::new("Übung 1.wav")).to_string(), "Übung 1.wav");
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plain(String);

impl Plain {
    /// A text.
    pub fn of(text: &str) -> Self {
        let mut plain = String::with_capacity(text.len());
        push(&mut plain, text);
        Self(plain)
    }

    /// A text of several lines that was put together from other texts: its line breaks stay.
    pub fn lines(text: &str) -> Self {
        let lines: Vec<String> = text.split('\n').map(|line| Self::of(line).0).collect();
        Self(lines.join("\n"))
    }

    /// A path.
    pub fn path(path: &Path) -> Self {
        let mut plain = String::new();
        for chunk in path.as_os_str().as_encoded_bytes().utf8_chunks() {
            push(&mut plain, chunk.valid());
            for byte in chunk.invalid() {
                // Writing to a String cannot fail.
                let _ = write!(plain, "\\x{byte:02x}");
            }
        }
        Self(plain)
    }

    /// Whether a character must not be shown as it is.
    pub fn hides(letter: char) -> bool {
        letter.is_control()
            || matches!(letter,
                // Marks of direction, embeddings, overrides and isolates.
                '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
                // Separators of lines and paragraphs, and what is not seen at all.
                | '\u{2028}' | '\u{2029}' | '\u{ad}' | '\u{180e}' | '\u{200b}' | '\u{2060}'..='\u{2064}' | '\u{feff}'
                // Controls of old ways to shape and annotate text, and tags, which can hide a whole text.
                | '\u{206a}'..='\u{206f}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}'
                // Letters of Hangul that are blank.
                | '\u{115f}' | '\u{1160}' | '\u{3164}' | '\u{ffa0}')
    }
}

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.0)
    }
}

impl From<Plain> for String {
    fn from(plain: Plain) -> Self {
        plain.0
    }
}

fn push(plain: &mut String, text: &str) {
    for letter in text.chars() {
        if Plain::hides(letter) {
            plain.extend(letter.escape_default());
        } else {
            plain.push(letter);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinary_text_stays_as_it_is() {
        for text in [
            "drop.wav",
            "a/b/ü ñ.wav",
            "C:\\a b",
            "球 1",
            "كرة.wav",
            "👩‍🔬",
            "e\u{301}",
        ] {
            assert_eq!(Plain::of(text).to_string(), text);
            assert_eq!(Plain::path(Path::new(text)).to_string(), text);
        }
    }

    /// Joiners of letters and of emoji change what is seen, and stay.
    #[test]
    fn what_is_not_seen_is_written_out() {
        for letter in "\u{ad}\u{2062}\u{206c}\u{3164}\u{fff9}\u{e0041}".chars() {
            let shown = Plain::of(&format!("a{letter}b")).to_string();
            assert_eq!(shown, format!("a{}b", letter.escape_unicode()));
        }
        assert_eq!(
            Plain::of("می\u{200c}شود ☎\u{fe0f}").to_string(),
            "می\u{200c}شود ☎\u{fe0f}"
        );
    }

    #[test]
    fn lines_stay_lines() {
        assert_eq!(
            Plain::lines("a\u{9b}b\n\nc\r\n").to_string(),
            "a\\u{9b}b\n\nc\\r\n"
        );
    }

    #[cfg(unix)]
    #[test]
    fn bytes_that_are_no_text_are_written_out() {
        use std::os::unix::ffi::OsStrExt;
        let path = Path::new(std::ffi::OsStr::from_bytes(b"drop\xff\x07.wav"));
        assert_eq!(Plain::path(path).to_string(), "drop\\xff\\u{7}.wav");
    }
}
