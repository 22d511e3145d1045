//! How the English of this crate becomes another language.
//!
//! Everything here is written in English, once. A [`Figure`](crate::Figure) and a
//! [`Page`](crate::report::Page) keep their words apart from their form until one asks for a picture or
//! a file; until then [`Figure::translate`](crate::Figure::translate) and
//! [`Page::translate`](crate::report::Page::translate) hand each of them to whoever knows the language.

/// Gives the words of another language for a text in English: a sentence, a name, or a number.
pub type Say<'a> = dyn FnMut(&str) -> String + 'a;

/// Says a text in place.
pub(crate) fn said(text: &mut String, say: &mut Say<'_>) {
    *text = say(text);
}
