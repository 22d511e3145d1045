//! Headings of columns of times, and their units.

/// The unit in seconds of a column of times, by its heading; `None` if the heading is that of another column.
///
/// `time`, `time_ms`, `Impact time (ms)`, `Zeit in s`, `t / µs`: what follows the word for time is its unit. Without one
/// the times are in seconds. A heading such as `flight time` is not that of impact times.
pub(super) fn unit_s(heading: &str) -> Option<f64> {
    let lower = heading.trim().to_ascii_lowercase();
    let words: Vec<&str> = lower
        .split(|letter: char| " _/()[],.".contains(letter))
        .filter(|word| !word.is_empty() && *word != "in")
        .collect();
    let time_words = match words.as_slice() {
        ["impact" | "impacts", rest @ ..] => rest,
        all => all,
    };
    match time_words {
        [word] if is_time(word) => Some(1.0),
        [word, unit] if is_time(word) => seconds(unit),
        _ => None,
    }
}

fn is_time(word: &str) -> bool {
    matches!(word, "time" | "times" | "t" | "zeit" | "temps" | "tiempo")
}

/// The seconds of a unit, by its symbol or name in lower case.
pub(crate) fn seconds(unit: &str) -> Option<f64> {
    match unit {
        "s" | "sec" | "second" | "seconds" | "sekunden" | "secondes" | "segundos" => Some(1.0),
        "ms" | "msec" | "millisecond" | "milliseconds" | "millisekunden" | "millisecondes"
        | "milisegundos" => Some(1e-3),
        "us" | "µs" | "μs" | "microsecond" | "microseconds" | "mikrosekunden" | "microsecondes"
        | "microsegundos" => Some(1e-6),
        "min" | "minutes" | "minuten" | "minutos" => Some(60.0),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::unit_s;

    #[test]
    fn a_heading_has_a_word_for_time_and_perhaps_a_unit() {
        for (heading, expected_s) in [
            ("time", Some(1.0)),
            ("time_s", Some(1.0)),
            ("Time (s)", Some(1.0)),
            ("Impact time [ms]", Some(1e-3)),
            ("time_ms", Some(1e-3)),
            ("Zeit in ms", Some(1e-3)),
            ("Zeit in Millisekunden", Some(1e-3)),
            ("t/s", Some(1.0)),
            ("t / µs", Some(1e-6)),
            ("Temps (min)", Some(60.0)),
            ("flight time", None),
            ("flight_time_s", None),
            ("time (h)", None),
            ("time of day", None),
            ("Timer", None),
            ("impact", None),
            ("", None),
        ] {
            assert_eq!(unit_s(heading), expected_s, "{heading}");
        }
    }
}
