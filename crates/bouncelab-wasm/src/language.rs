//! The messages of a language.

use bouncelab_report::messages::Translator;

use crate::refusal::{Refusal, Result};

/// The messages of a language, by its code and its files; English without any.
///
/// # Errors
///
/// If a file is not in the syntax of Fluent.
pub fn translator(code: &str, sources: &[String]) -> Result<Translator> {
    let sources: Vec<&str> = sources.iter().map(String::as_str).collect();
    let translator = if sources.is_empty() {
        Translator::english()
    } else {
        Translator::of_sources(code, &sources).map_err(Refusal::fault)?
    };
    Ok(translator.for_front_end("page"))
}
