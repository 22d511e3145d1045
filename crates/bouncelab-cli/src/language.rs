//! The language of the results: chosen once, when the program starts.

use std::fmt::Display;
use std::sync::OnceLock;

use bouncelab_report::messages::{self, Translator, Value};
use bouncelab_report::report::ended;

static LANGUAGE: OnceLock<String> = OnceLock::new();
static TRANSLATOR: OnceLock<Translator> = OnceLock::new();

/// Reads the argument of `--language`.
pub(crate) fn known(language: &str) -> Result<String, String> {
    let known: Vec<&str> = messages::languages().collect();
    match Translator::new(language) {
        Some(_) => Ok(language.to_owned()),
        None => Err(format!("known languages: {}", known.join(", "))),
    }
}

/// Chooses a language; the first choice holds.
pub(crate) fn choose(language: String) {
    LANGUAGE.get_or_init(|| language);
}

/// The language that was chosen, else that of the system, else English.
pub(crate) fn translator() -> &'static Translator {
    TRANSLATOR.get_or_init(|| {
        let chosen = match LANGUAGE.get() {
            Some(language) => Translator::new(language),
            None => sys_locale::get_locales().find_map(|locale| of_locale(&locale)),
        };
        chosen.unwrap_or_default().for_front_end("terminal")
    })
}

/// The language of a locale; those without one are English.
fn of_locale(locale: &str) -> Option<Translator> {
    match locale {
        "C" | "POSIX" => Some(Translator::english()),
        _ => Translator::new(locale),
    }
}

/// A message without arguments.
pub(crate) fn text(id: &str) -> String {
    translator().text(id)
}

/// A message with its arguments.
pub(crate) fn text_with(id: &str, arguments: &[(&str, Value<'_>)]) -> String {
    translator().text_with(id, arguments)
}

/// An error of the science in the language of the results.
pub(crate) fn translated(reason: &bouncelab::Error) -> String {
    translator().diagnostic(&reason.diagnostic())
}

/// That a value cannot be determined, and why.
pub(crate) fn cannot_tell(id: &str, reason: impl Display) -> String {
    let reason = ended(reason).into();
    let why = [("what", text(id).into()), ("reason", reason)];
    text_with("terminal-cannot-tell", &why)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_locale_chooses_its_language_and_one_without_messages_leaves_it_to_the_next() {
        let language = |locale| of_locale(locale).map(|found| found.language().to_owned());
        let known = [
            ("fr_FR.UTF-8", "fr"),
            ("fr_CH", "fr"),
            ("es-MX", "es"),
            ("es_419", "es"),
            ("de-AT", "de"),
            ("C", "en"),
            ("POSIX", "en"),
        ];
        for (locale, code) in known {
            assert_eq!(language(locale).as_deref(), Some(code), "{locale}");
        }
        assert_eq!(language("pt_BR.UTF-8"), None);
    }

    #[test]
    fn an_unknown_language_is_refused_with_those_that_are_known() {
        assert_eq!(known("es-MX").as_deref(), Ok("es-MX"));
        assert_eq!(known("pt").unwrap_err(), "known languages: de, en, es, fr");
    }
}
