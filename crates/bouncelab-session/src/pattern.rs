//! Reads metadata from file names, by a pattern such as `{ball}_{surface}_{height}_{}`.

use bouncelab::Plain;

use crate::error::{Error, Result};

/// A pattern for the names of recordings without their endings.
///
/// `{field}` matches any text of at least one character, as short as the rest of the pattern allows;
/// `{}` matches text that is not used; all other characters match themselves. `{height:cm}` is a height whose unit
/// is not part of the name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pattern {
    text: String,
    /// The fields, in turn; the last literal text stands at the end.
    parts: Vec<Part>,
    end: String,
}

/// A field and what is around it.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Part {
    /// The text before it.
    before: String,
    /// Its name; empty if its text is not used.
    field: String,
    /// The unit that its value lacks.
    unit: String,
}

impl Pattern {
    /// Reads a pattern.
    ///
    /// # Errors
    /// [`Error::Pattern`] for a brace without its partner, a field with nothing between it and the
    /// next, or one named twice.
    pub fn new(text: &str) -> Result<Self> {
        let wrong = |problem: &str| Error::Pattern {
            pattern: text.to_owned(),
            problem: problem.to_owned(),
        };
        let mut parts: Vec<Part> = Vec::new();
        let mut rest = text;
        while let Some((literal, after)) = rest.split_once('{') {
            let (field, after) = after
                .split_once('}')
                .ok_or_else(|| wrong("has a { without a }"))?;
            if literal.contains('}') || field.contains('{') {
                return Err(wrong("has braces that do not go together"));
            }
            if literal.is_empty() && !parts.is_empty() {
                return Err(wrong("has two fields with nothing between them"));
            }
            let (field, unit) = field.split_once(':').unwrap_or((field, ""));
            let name = String::from(Plain::of(field.trim()));
            if !name.is_empty() && parts.iter().any(|part| part.field == name) {
                return Err(wrong("names a field twice"));
            }
            parts.push(Part {
                before: literal.to_owned(),
                field: name,
                unit: unit.trim().to_owned(),
            });
            rest = after;
        }
        if rest.contains('}') {
            return Err(wrong("has a } without a {"));
        }
        if parts.is_empty() {
            return Err(wrong("has no field"));
        }
        Ok(Self {
            text: Plain::of(text).into(),
            parts,
            end: rest.to_owned(),
        })
    }

    /// The pattern as text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The fields of a name without its ending; `None` if it does not match.
    ///
    /// ```
    /// let pattern = bouncelab_session::Pattern::new("{ball}_{surface}_{}")?;
    /// let fields = pattern.fields("red_steel_7").unwrap();
    /// assert_eq!(fields[0], ("ball", "red".to_owned()));
    /// assert_eq!(fields[1], ("surface", "steel".to_owned()));
    /// # Ok::<(), bouncelab_session::Error>(())
    /// ```
    pub fn fields(&self, stem: &str) -> Option<Vec<(&str, String)>> {
        let mut fields = Vec::new();
        let mut rest = stem.strip_prefix(self.parts[0].before.as_str())?;
        for (index, part) in self.parts.iter().enumerate() {
            let next = self.parts.get(index + 1).map(|next| next.before.as_str());
            let end = match next {
                Some(next) => rest.find(next)?,
                None => rest.strip_suffix(self.end.as_str())?.len(),
            };
            if end == 0 {
                return None;
            }
            if !part.field.is_empty() {
                let value = format!("{}{}", &rest[..end], part.unit);
                fields.push((part.field.as_str(), value));
            }
            rest = &rest[end + next.map_or(0, str::len)..];
        }
        Some(fields)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn names_are_split_into_fields() {
        let pattern = Pattern::new("drop-{ball}-{height:cm}cm").unwrap();
        let fields = vec![("ball", "red".to_owned()), ("height", "30.5cm".to_owned())];
        assert_eq!(pattern.fields("drop-red-30.5cm"), Some(fields));
        for other in [
            "drop-red-30.5",
            "red-30.5cm",
            "drop--30cm",
            "drop-red-cm",
            "",
        ] {
            assert_eq!(pattern.fields(other), None, "{other}");
        }
    }

    #[test]
    fn malformed_patterns_are_refused() {
        for text in ["", "plain", "{ball", "ball}", "{a}{b}", "{a}_{a}", "{a{b}}"] {
            assert!(Pattern::new(text).is_err(), "{text}");
        }
        assert!(Pattern::new("{}_{}").is_ok());
    }

    proptest! {
        /// Fields that are joined by the text of the pattern are split again.
        #[test]
        fn joined_fields_are_split(a in "[a-z0-9.é]{1,8}", b in "[a-z0-9.é]{1,8}") {
            let pattern = Pattern::new("{ball}_{surface}").unwrap();
            let stem = format!("{a}_{b}");
            let fields = vec![("ball", a.clone()), ("surface", b.clone())];
            prop_assert_eq!(pattern.fields(&stem), Some(fields));
        }

        #[test]
        fn no_text_panics(pattern in ".{0,20}", stem in ".{0,20}") {
            if let Ok(pattern) = Pattern::new(&pattern) {
                let _ = pattern.fields(&stem);
            }
        }
    }
}
