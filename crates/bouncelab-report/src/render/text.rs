//! Widths and line breaks of texts.

use bouncelab::Plain;
use std::borrow::Cow;

const SOFT_HYPHEN: char = '\u{ad}';

/// Longer texts than this, in lines, are left out in part.
pub(super) const MAX_LINES: usize = 4;

/// Width of a text in figure pixels, rather too wide than too narrow: by the classes of
/// letters of `DejaVu Sans`, which is wider than the fonts of most systems.
pub(super) fn text_width(text: &str, size: u32) -> f64 {
    let em: f64 = text.chars().map(letter_width).sum();
    em * f64::from(size)
}

fn letter_width(letter: char) -> f64 {
    match letter {
        SOFT_HYPHEN => 0.0,
        ' ' | '\u{202f}' | '.' | ',' | 'i' | 'j' | 'l' | 'I' | '\'' | '’' => 0.32,
        'f' | 't' | 'r' | '(' | ')' | '-' | '/' | ':' | ';' | '|' | '!' => 0.42,
        'w' | '=' | '+' | '<' | '>' | '±' | '×' | '−' | '≈' => 0.84,
        'm' | 'M' | 'W' | '%' | '@' => 1.0,
        'A'..='Z' => 0.79,
        '⁰'..='⁹' | '⁻' | '¹' | '²' | '³' => 0.5,
        _ if (letter as u32) < 0x80 => 0.64,
        _ if (letter as u32) < 0x0250 => 0.75,
        _ => 1.1,
    }
}

/// From line to line, in figure pixels.
pub(super) fn line_height(size: u32) -> f64 {
    1.15 * f64::from(size)
}

/// The text in lines no wider than `width` figure pixels, at least one and at most `most`: broken
/// between words where that goes, within one where not, and shortened where even that is too long.
pub(super) fn wrapped(text: &str, size: u32, width: f64, most: usize) -> Vec<Cow<'_, str>> {
    let mut lines = Vec::new();
    let mut rest = text.trim();
    while lines.len() + 1 < most && text_width(rest, size) > width {
        let Some(end) = line_end(rest, size, width) else {
            break;
        };
        let (line, following) = rest.split_at(end);
        lines.push(Cow::Borrowed(line.trim_end()));
        rest = following.trim_start();
    }
    lines.push(shortened(rest, size, width));
    lines
}

/// Where the first line of a text that is too wide ends; `None` if not even a letter fits.
fn line_end(text: &str, size: u32, width: f64) -> Option<usize> {
    let fits = |&end: &usize| text_width(text[..end].trim_end(), size) <= width;
    let ends = text.char_indices().map(|(end, _)| end).skip(1);
    let ends: Vec<usize> = ends.take_while(fits).collect();
    let after = |signs: &[char]| {
        let is_after = |end: &&usize| text[..**end].ends_with(signs);
        ends.iter().rfind(is_after)
    };
    let end = after(&[' ']).or_else(|| after(&['-', '_', '/']));
    end.or(ends.last()).copied()
}

/// The text, shortened with an ellipsis if it is wider than `width` figure pixels.
fn shortened(text: &str, size: u32, width: f64) -> Cow<'_, str> {
    if text_width(text, size) <= width {
        return Cow::Borrowed(text);
    }
    let mut short = String::new();
    for letter in text.chars() {
        if text_width(&short, size) + f64::from(size) * (letter_width(letter) + 1.1) > width {
            break;
        }
        short.push(letter);
    }
    short.truncate(short.trim_end().len());
    short.push('…');
    Cow::Owned(short)
}

/// Without hyphens for the end of a line, since a drawing breaks none. What must not be shown is left blank, so
/// that a text is as long as when its position was computed.
pub(super) fn printable(text: &str) -> String {
    text.chars()
        .filter(|&c| c != SOFT_HYPHEN)
        .map(|c| if Plain::hides(c) { ' ' } else { c })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shortened_texts_fit() {
        let text = "a rather long name of a curve";
        let short = shortened(text, 14, 100.0);
        assert!(
            short.ends_with('…') && text_width(&short, 14) <= 100.0,
            "{short}"
        );
        assert_eq!(shortened(text, 14, 1000.0), text);
    }

    #[test]
    fn long_texts_are_broken_between_words_and_nothing_is_lost() {
        let text = "blue ball of the school, old-gymnasium";
        for width in [60.0, 100.0, 150.0, 1000.0] {
            let lines = wrapped(text, 13, width, 20);
            assert!(lines.iter().all(|line| text_width(line, 13) <= width));
            let letters = |text: &str| text.replace(' ', "");
            assert_eq!(letters(&lines.concat()), letters(text), "{width}");
        }
        assert_eq!(
            wrapped(text, 13, 150.0, 4),
            ["blue ball of the", "school,", "old-gymnasium"]
        );
    }

    #[test]
    fn what_has_no_words_is_broken_anywhere_and_shortened_at_last() {
        let text = "a".repeat(60);
        let lines = wrapped(&text, 13, 100.0, 3);
        assert_eq!(lines.len(), 3);
        assert!(lines[2].ends_with('…'), "{lines:?}");
        assert_eq!(wrapped("one-two-three", 13, 70.0, 3), ["one-two-", "three"]);
        assert_eq!(wrapped(&text, 13, 0.0, 3).len(), 1);
        assert_eq!(wrapped("", 13, 10.0, 3), [""]);
    }
}
