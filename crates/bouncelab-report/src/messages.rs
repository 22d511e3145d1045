//! Messages by id and language.
//!
//! What people read is in `messages/`: a folder for each language, with files in the syntax of
//! [Fluent](https://projectfluent.org). Code names a message by its id and hands over its arguments; a
//! [`Translator`] puts them together. Numbers are written as the language writes them, and a message
//! may depend on them (plural forms) or on a word:
//!
//! ```ftl
//! drop-flights = It goes through { $count ->
//!     [one] one flight
//!    *[other] { $count } flights
//! }.
//! ```
//!
//! To add a language is to add a folder; tests find what it lacks.
//!
//! ```
//! use bouncelab_report::messages::{Translator, Value};
//!
//! let german = Translator::new("de_DE.UTF-8").expect("German is there");
//! assert_eq!(german.language(), "de");
//! assert_eq!(german.text("unit-cannot-tell"), "nicht zu sagen");
//! assert_eq!(german.number("0.953 ± 0.002"), "0,953 ± 0,002");
//! assert_eq!(
//!     german.text_with("list-and", &[("first", 3.into()), ("last", Value::fixed(5.5, 2))]),
//!     "3 und 5,50",
//! );
//! ```

use std::borrow::Cow;
use std::collections::HashMap;
use std::fmt;

use bouncelab::diagnostic::Argument;
use bouncelab::settings::BallKind;
use bouncelab::{Diagnostic, Recording};
use fluent_syntax::ast::{
    Entry, Expression, InlineExpression, Pattern, PatternElement, VariantKey,
};
use fluent_syntax::parser;
use intl_pluralrules::{PluralCategory, PluralRuleType, PluralRules};
use unic_langid::LanguageIdentifier;

use crate::digits::with_minus;
use crate::quantity::{Quantity, Unit};

/// The languages that are part of this build, each with its files.
const SOURCES: &[(&str, &[&str])] = include!(concat!(env!("OUT_DIR"), "/messages.rs"));

const ENGLISH: &str = "en";

/// Longer lists of numbers are shortened.
const MAX_IN_LIST: usize = 12;

/// Codes of the languages that are part of this build. In a browser that is English; other languages
/// are loaded ([`Translator::of_sources`]).
pub fn languages() -> impl Iterator<Item = &'static str> {
    SOURCES.iter().map(|(code, _)| *code)
}

/// What a message is given: a number, which may decide the plural form, or a text.
#[derive(Debug, Clone, PartialEq)]
pub enum Value<'a> {
    /// A number with a decimal point; it is shown with the digits that it has here.
    Number(String),
    /// A text in the language of the message, or a name.
    Text(Cow<'a, str>),
    /// A value with its uncertainty and unit.
    Quantity(Quantity),
    /// Numbers of impacts or flights, one after the other; their count decides the plural form, and of
    /// many only the first are shown.
    List(Vec<usize>),
}

impl Value<'_> {
    /// A number with this count of decimals.
    pub fn fixed(value: f64, decimals: usize) -> Self {
        Self::Number(format!("{value:.decimals$}"))
    }
}

macro_rules! values_of_numbers {
    ($($number:ty),*) => {$(
        impl From<$number> for Value<'_> {
            fn from(number: $number) -> Self {
                Self::Number(number.to_string())
            }
        }
    )*};
}

values_of_numbers!(i32, u32, u64, usize, f64);

impl<'a> From<&'a str> for Value<'a> {
    fn from(text: &'a str) -> Self {
        Self::Text(text.into())
    }
}

impl From<String> for Value<'_> {
    fn from(text: String) -> Self {
        Self::Text(text.into())
    }
}

impl From<Quantity> for Value<'_> {
    fn from(quantity: Quantity) -> Self {
        Self::Quantity(quantity)
    }
}

impl From<Vec<usize>> for Value<'_> {
    fn from(numbers: Vec<usize>) -> Self {
        Self::List(numbers)
    }
}

/// The messages of one language.
pub struct Translator {
    language: String,
    messages: HashMap<String, Pattern<String>>,
    plural: Option<PluralRules>,
    decimal_point: String,
    /// Whose advice is added to diagnostics.
    front_end: &'static str,
}

impl fmt::Debug for Translator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let messages = self.messages.len();
        write!(f, "Translator({}, {messages} messages)", self.language)
    }
}

impl Default for Translator {
    fn default() -> Self {
        Self::english()
    }
}

impl Translator {
    /// English.
    ///
    /// # Panics
    ///
    /// Never: tests read every file that is part of this build.
    pub fn english() -> Self {
        Self::new(ENGLISH).expect("English is part of every build")
    }

    /// A language by its code or by the name of a locale: `de`, `de-AT`, `de_DE.UTF-8`. `None` if there
    /// is no such language in this build.
    pub fn new(language: &str) -> Option<Self> {
        let wanted = language.split(['-', '_', '.', '@']).next()?;
        let (code, sources) = SOURCES
            .iter()
            .find(|(code, _)| code.eq_ignore_ascii_case(wanted))?;
        Self::of_sources(code, sources).ok()
    }

    /// A language by its code and its files, for a front end that loads them.
    ///
    /// # Errors
    ///
    /// What is wrong with the first line that is not Fluent, or has what is not supported here:
    /// attributes, terms and functions.
    pub fn of_sources(language: &str, sources: &[&str]) -> Result<Self, String> {
        let mut messages = HashMap::new();
        for source in sources {
            let parsed = parser::parse_runtime((*source).to_owned()).map_err(|(_, errors)| {
                errors.first().map_or_else(String::new, ToString::to_string)
            })?;
            for entry in parsed.body {
                let Entry::Message(message) = entry else {
                    return Err("only messages are supported, not terms".to_owned());
                };
                let id = message.id.name;
                let Some(pattern) = message.value.filter(|_| message.attributes.is_empty()) else {
                    return Err(format!("{id}: attributes are not supported"));
                };
                if messages.insert(id.clone(), pattern).is_some() {
                    return Err(format!("{id} is there twice"));
                }
            }
        }
        let identifier: Option<LanguageIdentifier> = language.parse().ok();
        let plural =
            identifier.and_then(|code| PluralRules::create(code, PluralRuleType::CARDINAL).ok());
        let mut translator = Self {
            language: language.to_owned(),
            messages,
            plural,
            decimal_point: String::new(),
            front_end: "",
        };
        translator.decimal_point = translator.text("decimal-point");
        Ok(translator)
    }

    /// The code of the language, as in the attribute `lang` of HTML.
    pub fn language(&self) -> &str {
        &self.language
    }

    /// Whether there is a message with this id.
    pub fn has(&self, id: &str) -> bool {
        self.messages.contains_key(id)
    }

    /// A message without arguments. One that does not exist is shown as its id.
    pub fn text(&self, id: &str) -> String {
        self.text_with(id, &[])
    }

    /// A message with its arguments, by name.
    pub fn text_with(&self, id: &str, arguments: &[(&str, Value<'_>)]) -> String {
        let mut text = String::new();
        self.write_message(id, arguments, &mut text);
        text
    }

    /// Sentences or facts in one line, with the semicolons of the language between them.
    ///
    /// ```
    /// let french = bouncelab_report::messages::Translator::new("fr").unwrap();
    /// assert_eq!(french.in_one_line(["un".into(), "deux".into()]), "un\u{202f}; deux");
    /// ```
    pub fn in_one_line(&self, parts: impl IntoIterator<Item = String>) -> String {
        let joined = parts.into_iter().reduce(|first, last| {
            let both = [
                ("first", first.as_str().into()),
                ("last", last.as_str().into()),
            ];
            self.text_with("list-semicolon", &both)
        });
        joined.unwrap_or_default()
    }

    /// What introduces something, with the colon of the language.
    ///
    /// ```
    /// let french = bouncelab_report::messages::Translator::new("fr").unwrap();
    /// assert_eq!(french.with_colon("note"), "note\u{202f}:");
    /// ```
    pub fn with_colon(&self, text: &str) -> String {
        self.text_with("with-colon", &[("text", text.into())])
    }

    /// This translator, with the advice that belongs to a front end: `terminal` or `page`.
    #[must_use]
    pub fn for_front_end(self, name: &'static str) -> Self {
        Self {
            front_end: name,
            ..self
        }
    }

    /// The sentence of a diagnostic, and what to do about it in this front end.
    pub fn diagnostic(&self, diagnostic: &Diagnostic) -> String {
        let code = diagnostic.code;
        let arguments = code.arguments().iter().map(|name| {
            let name = name.trim_end_matches('?');
            let argument = diagnostic.arguments.get(name);
            (
                name,
                argument.map_or("none".into(), |value| self.shown(name, value)),
            )
        });
        let sentence = self.text_with(
            &format!("diagnostic-{code}"),
            &arguments.collect::<Vec<_>>(),
        );
        let advice = format!("{}-advice-{code}", self.front_end);
        let advice = self.has(&advice).then(|| self.text(&advice));
        [Some(capital(&sentence)), advice]
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join(" ")
    }

    /// An argument of a diagnostic for people: the unit is the last part of its name.
    fn shown<'a>(&self, name: &str, argument: &'a Argument) -> Value<'a> {
        let quantity = |value, digits, unit| Quantity::rounded(value, digits, unit).into();
        match argument {
            Argument::Text(text) => self.named(name, text).into(),
            Argument::Numbers(numbers) => {
                Value::List(numbers.iter().map(|&number| number as usize).collect())
            }
            &Argument::Number(value) => match name {
                "contact_time_s" | "duration_s" | "interval_s" | "reach_s" | "sd_s" => {
                    quantity(value, 3, Unit::Time)
                }
                "probability" | "pareto_shape" | "least" | "greatest" => Value::fixed(value, 2),
                "slow" | "fast" | "restitution" => Value::fixed(value, 3),
                "factor" => Value::fixed(100.0 * (value - 1.0), 0),
                "pressure_pa" => plain(value / 100.0),
                "relative_humidity"
                | "relative_sd"
                | "assumed_relative_sd"
                | "low_relative_sd"
                | "high_relative_sd" => plain((value * 1e4).round() / 100.0),
                "reynolds" | "max_reynolds" => quantity(value, 3, Unit::Number),
                _ if name.ends_with("relative_sd") || name == "relative_humidity" => {
                    plain((value * 1e4).round() / 100.0)
                }
                _ if name.ends_with("_m_s2") => quantity(value, 3, Unit::Acceleration),
                _ if name.ends_with("_s") => Value::fixed(value, 2),
                _ if name.ends_with("_m") => quantity(value, 3, Unit::Length),
                _ if name.ends_with("_kg") => quantity(value, 3, Unit::Mass),
                _ if name.ends_with("_hz") => Value::fixed(value, 0),
                _ if name.ends_with("_k") => Value::fixed(value - 273.15, 1),
                _ => plain(value),
            },
        }
    }

    /// The name of something that the science calls by a key or by English words.
    pub(crate) fn named(&self, argument: &str, key: &str) -> String {
        if argument == "balls" {
            let each = key.split(", ").map(|kind| self.named("ball", kind));
            return each.collect::<Vec<_>>().join(", ");
        }
        let key_id = kebab(key);
        let id = match argument {
            "quantity" | "input" => format!("input-{key_id}"),
            "kind" | "what" => format!("kind-{key_id}"),
            "ball" => format!("ball-{key_id}"),
            "law" => format!("restitution-law-{key_id}"),
            "title" => format!("rule-title-{key_id}"),
            "surface" => format!("rule-surface-{key_id}"),
            "note" => format!("rule-note-{key_id}"),
            "conditioning" => format!("rule-conditioning-{key_id}"),
            "read" => format!("rule-read-{key_id}"),
            "item" => format!("verdict-item-{key_id}"),
            _ => return key.to_owned(),
        };
        if self.has(&id) {
            self.text(&id)
        } else {
            key.to_owned()
        }
    }

    /// A ball: the name of a preset, or what it is made of or weighs, and its diameter.
    pub fn ball(&self, ball: &BallKind) -> String {
        let diameter = |diameter_m| ("diameter", in_thousandths(diameter_m));
        match *ball {
            BallKind::Unstated => self.text("ball-unstated"),
            BallKind::Preset(preset) => self.named("ball", preset.name),
            BallKind::Sized(preset, diameter_m) => {
                let name = self.named("ball", preset.name);
                self.text_with("ball-sized", &[("ball", name.into()), diameter(diameter_m)])
            }
            BallKind::Measured(ball) => {
                let mass = ("mass", in_thousandths(ball.mass_kg()));
                self.text_with("ball-measured", &[mass, diameter(ball.diameter_m())])
            }
        }
    }

    /// Adds the sentences of this language to all diagnostics of a result.
    pub fn complete(&self, result: &mut Recording) {
        let of_posteriors = |drop: &mut bouncelab::analysis::Drop| {
            self.complete_each(&mut drop.diagnostics);
            if let Ok(posterior) = &mut drop.posterior {
                self.complete_each(&mut posterior.priors);
            }
        };
        result.drops.iter_mut().for_each(of_posteriors);
        self.complete_each(&mut result.diagnostics);
        self.complete_each(result.no_drop.as_mut_slice());
    }

    /// Adds the sentences of this language to diagnostics.
    pub fn complete_each(&self, diagnostics: &mut [Diagnostic]) {
        for diagnostic in diagnostics {
            diagnostic.message = Some(self.diagnostic(diagnostic));
        }
    }

    /// A number with this count of decimals, as this language writes it; empty if it is not finite.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        if value.is_finite() {
            self.number(&format!("{value:.decimals$}"))
        } else {
            String::new()
        }
    }

    /// A text of numbers that are written with a decimal point, as this language writes them; what has
    /// several points, such as the number of a version, is not a decimal number.
    pub fn number(&self, written: &str) -> String {
        let is_part = |c: char| c.is_ascii_digit() || c == '.';
        let mut text = String::with_capacity(written.len());
        let mut rest = written;
        while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
            let (before, number) = rest.split_at(start);
            let (number, after) =
                number.split_at(number.find(|c| !is_part(c)).unwrap_or(number.len()));
            let whole = number.trim_end_matches('.');
            text.push_str(before);
            if whole.matches('.').count() == 1 {
                text.push_str(&whole.replace('.', &self.decimal_point));
            } else {
                text.push_str(whole);
            }
            text.push_str(&number[whole.len()..]);
            rest = after;
        }
        text + rest
    }

    fn write_message(&self, id: &str, arguments: &[(&str, Value<'_>)], text: &mut String) {
        match self.messages.get(id) {
            Some(pattern) => self.write(pattern, arguments, text),
            None => text.push_str(id),
        }
    }

    fn write(&self, pattern: &Pattern<String>, arguments: &[(&str, Value<'_>)], text: &mut String) {
        for element in &pattern.elements {
            match element {
                PatternElement::TextElement { value } => text.push_str(value),
                PatternElement::Placeable { expression } => match expression {
                    Expression::Inline(inline) => self.write_inline(inline, arguments, text),
                    Expression::Select { selector, variants } => {
                        let value = argument(selector, arguments);
                        let chosen = variants
                            .iter()
                            .find(|variant| {
                                value.is_some_and(|value| self.fits(value, &variant.key))
                            })
                            .or_else(|| variants.iter().find(|variant| variant.default));
                        if let Some(variant) = chosen {
                            self.write(&variant.value, arguments, text);
                        }
                    }
                },
            }
        }
    }

    fn write_inline(
        &self,
        inline: &InlineExpression<String>,
        arguments: &[(&str, Value<'_>)],
        text: &mut String,
    ) {
        match inline {
            InlineExpression::StringLiteral { value } => {
                fluent_syntax::unicode::unescape_unicode(text, value).unwrap_or_default();
            }
            InlineExpression::MessageReference { id, .. } => {
                self.write_message(&id.name, arguments, text);
            }
            InlineExpression::Placeable { expression } => {
                if let Expression::Inline(inline) = expression.as_ref() {
                    self.write_inline(inline, arguments, text);
                }
            }
            _ => match argument(inline, arguments) {
                Some(Value::Number(number)) => text.push_str(&self.number(&with_minus(number))),
                Some(Value::Text(words)) => text.push_str(words),
                Some(Value::Quantity(quantity)) => text.push_str(&quantity.text(self)),
                Some(Value::List(numbers)) => text.push_str(&self.list(numbers)),
                None => {}
            },
        }
    }

    fn list(&self, numbers: &[usize]) -> String {
        let shown: Vec<_> = numbers
            .iter()
            .take(MAX_IN_LIST)
            .map(usize::to_string)
            .collect();
        let shown = shown.join(", ");
        match numbers.len().saturating_sub(MAX_IN_LIST) {
            0 => shown,
            more => self.text_with(
                "list-more",
                &[("first", shown.into()), ("count", more.into())],
            ),
        }
    }

    /// Whether a value is the one of a variant, or of its plural category.
    fn fits(&self, value: &Value<'_>, key: &VariantKey<String>) -> bool {
        match (value, key) {
            (Value::Text(text), VariantKey::Identifier { name }) => text == name,
            (Value::Number(number), VariantKey::NumberLiteral { value }) => {
                number.parse::<f64>().ok() == value.parse().ok()
            }
            (Value::Number(number), VariantKey::Identifier { name }) => {
                self.plural_category(number) == name
            }
            (Value::List(numbers), _) => self.fits(&numbers.len().into(), key),
            _ => false,
        }
    }

    fn plural_category(&self, number: &str) -> &'static str {
        let rules = self.plural.as_ref();
        match rules.and_then(|rules| rules.select(number).ok()) {
            Some(PluralCategory::ZERO) => "zero",
            Some(PluralCategory::ONE) => "one",
            Some(PluralCategory::TWO) => "two",
            Some(PluralCategory::FEW) => "few",
            Some(PluralCategory::MANY) => "many",
            Some(PluralCategory::OTHER) | None => "other",
        }
    }
}

fn argument<'a, 'b>(
    inline: &InlineExpression<String>,
    arguments: &'a [(&str, Value<'b>)],
) -> Option<&'a Value<'b>> {
    let InlineExpression::VariableReference { id } = inline else {
        return None;
    };
    let named = arguments.iter().find(|(name, _)| *name == id.name);
    named.map(|(_, value)| value)
}

/// Thousandths of a number, without the noise of binary fractions.
fn in_thousandths(value: f64) -> Value<'static> {
    ((value * 1e9).round() / 1e6).into()
}

/// A number with all digits that it has.
fn plain(value: f64) -> Value<'static> {
    if !value.is_finite() || (value.fract() == 0.0 && value.abs() < 1e9) {
        Value::Number(value.to_string())
    } else {
        Quantity::measured(value, 0.0, Unit::Number).into()
    }
}

/// Words as the end of an id: letters and digits, with hyphens between them.
fn kebab(words: &str) -> String {
    let lower = words.to_ascii_lowercase();
    let parts = lower.split(|c: char| !c.is_ascii_alphanumeric());
    let parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    parts.join("-")
}

/// With a capital letter.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first: String = letters
        .next()
        .into_iter()
        .flat_map(char::to_uppercase)
        .collect();
    first + letters.as_str()
}

#[cfg(test)]
mod tests {
    use bouncelab::ball::{self, Ball};

    use super::*;

    const SOURCE: &str = "decimal-point = ,\n\
        count = { $count ->\n    [0] none\n    [one] one\n   *[other] { $count } many\n}\n\
        word = { $side ->\n    [less] down\n   *[more] up\n}\n\
        nested = <{ word }> { \"\\u00a0\" }\n";

    fn invented() -> Translator {
        Translator::of_sources("de", &[SOURCE]).unwrap()
    }

    #[test]
    fn numbers_choose_plural_forms_and_words_choose_variants() {
        let translator = invented();
        let counted = |count: usize| translator.text_with("count", &[("count", count.into())]);
        assert_eq!([0, 1, 2].map(counted), ["none", "one", "2 many"]);
        let fraction = translator.text_with("count", &[("count", Value::fixed(-1.0, 1))]);
        assert_eq!(fraction, "\u{2212}1,0 many");
        let side = |side: &'static str| translator.text_with("word", &[("side", side.into())]);
        assert_eq!(["less", "more", "else"].map(side), ["down", "up", "up"]);
        let nested = translator.text_with("nested", &[("side", "less".into())]);
        assert_eq!(nested, "<down> \u{a0}");
    }

    #[test]
    fn only_numbers_take_the_decimal_point_of_the_language() {
        let translator = invented();
        let examples = [
            ("0.953 \u{b1} 0.002", "0,953 \u{b1} 0,002"),
            ("1.2.3", "1.2.3"),
            ("at 3.", "at 3."),
            ("none", "none"),
        ];
        for (written, text) in examples {
            assert_eq!(translator.number(written), text);
        }
    }

    #[test]
    fn a_long_list_is_cut_and_its_length_chooses_the_plural_form() {
        let translator = Translator::english();
        let listed = |numbers: Vec<usize>| {
            translator.text_with(
                "list-and",
                &[("first", "".into()), ("last", numbers.into())],
            )
        };
        assert_eq!(listed(vec![3, 5, 8]), " and 3, 5, 8");
        assert!(listed((1..=1000).collect()).ends_with("11, 12 and 988 more"));
        let count = invented().text_with("count", &[("count", vec![7].into())]);
        assert_eq!(count, "one");
    }

    #[test]
    fn what_is_not_supported_is_refused() {
        let refused = |source| Translator::of_sources("de", &[source]).unwrap_err();
        assert_eq!(refused("a = 1\na = 2\n"), "a is there twice");
        assert!(refused("a =\n    .b = 1\n").contains("attributes"));
        assert!(refused("-a = 1\n").contains("terms"));
        assert!(!refused("a = { \n").is_empty());
    }

    #[test]
    fn locales_name_their_language() {
        let locales = [
            ("de", "de-AT de_DE.UTF-8 DE de@euro"),
            ("en", "en_GB.UTF-8 en-US"),
            ("es", "es_ES.UTF-8 es-MX es_419"),
            ("fr", "fr_FR.UTF-8 fr_CH fr_CA.UTF-8 fr-BE@euro"),
        ];
        for (code, names) in locales {
            for locale in names.split(' ') {
                let language = Translator::new(locale).map(|found| found.language);
                assert_eq!(language.as_deref(), Some(code), "{locale}");
            }
        }
        for locale in ["C.UTF-8", "pt_BR.UTF-8", "french", ""] {
            assert!(Translator::new(locale).is_none(), "{locale}");
        }
    }

    #[test]
    fn a_ball_has_a_name_in_every_language() {
        let named = |language, ball: BallKind| Translator::new(language).unwrap().ball(&ball);
        for preset in ball::presets() {
            assert_eq!(named("en", BallKind::Preset(preset)), preset.label);
        }
        let [football, steel] = ["football", "steel"].map(|name| ball::preset(name).unwrap());
        let football = BallKind::Preset(football);
        assert_eq!(named("de", football), "Fußball");
        let steel = BallKind::Sized(steel, 0.0127);
        assert_eq!(named("es", steel), "bola de acero, 12,7 mm");
        let measured = BallKind::Measured(Ball::new(0.0025, 0.038).unwrap());
        assert_eq!(named("de", measured), "2,5 g, 38 mm");
    }

    /// The rules of CLDR. Its newer versions give a million a form of its own in French and Spanish ("un million de"),
    /// which a number in digits does not need.
    #[test]
    fn each_language_has_its_singular() {
        let singular = |language: &str| {
            let translator = Translator::new(language).unwrap();
            ["0", "1", "1.5", "2"].map(|number| translator.plural_category(number) == "one")
        };
        for language in ["de", "en", "es"] {
            assert_eq!(
                singular(language),
                [false, true, false, false],
                "{language}"
            );
        }
        assert_eq!(singular("fr"), [true, true, true, false]);
        let counted = |language: &str, count: usize| {
            let translator = Translator::new(language).unwrap();
            translator.text_with("figure-intervals-count", &[("count", count.into())])
        };
        let french = [0, 1, 2, 1_000_000].map(|count| counted("fr", count));
        assert_eq!(french, ["0 essai", "1 essai", "2 essais", "1000000 essais"]);
        let spanish = [0, 1, 2, 1_000_000].map(|count| counted("es", count));
        assert_eq!(
            spanish,
            ["0 ensayos", "1 ensayo", "2 ensayos", "1000000 ensayos"]
        );
    }
}
