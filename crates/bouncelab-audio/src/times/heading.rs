//! Headings of columns of times and of intervals, and their units, in English, German, French and Spanish.

/// What the numbers below a heading are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Column {
    /// Times of impacts, on any clock.
    Times,
    /// Times from one impact to the next.
    Intervals,
}

/// The meaning of a heading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Heading {
    pub(super) column: Column,
    /// The unit of the numbers, in seconds; seconds if the heading states none.
    pub(super) unit_s: f64,
    /// Whether every word of it is known: `Impact time (s)`, but not `Reaction time (s)`.
    pub(super) is_plain: bool,
    /// Whether it has a number, as `Stop 2 (s)` has, or names one of two events, as `Start (s)`.
    pub(super) is_one_of_several: bool,
}

/// The meaning of a word in a heading.
#[derive(Clone, Copy, PartialEq)]
enum Word {
    Time,
    /// An impact, or what marks one in a stopwatch.
    Impact,
    Ends,
    Interval,
    Number,
    Filler,
    Unknown,
}

impl Heading {
    /// The meaning of a heading; `None` if its column holds neither times nor intervals.
    ///
    /// `time`, `time_ms`, `Impact time (ms)`, `Zeit in s`, `Zeit t / s`, `t/µs`, `Bounce 2 (s)`, `Flugzeit (s)`. A heading
    /// without a unit has known words only: `time (h)` and `time of day` are in other units, `impact` alone is a count.
    pub(super) fn of(heading: &str) -> Option<Self> {
        let lower = heading.to_lowercase();
        let words: Vec<&str> = lower
            .split(|letter: char| !letter.is_alphanumeric())
            .filter(|word| !word.is_empty())
            .collect();
        let (words, unit_s) = match unit_s(&lower, &words) {
            Some(unit_s) => (&words[..words.len() - 1], Some(unit_s)),
            None => (words.as_slice(), None),
        };
        let meanings: Vec<Word> = words.iter().map(|word| Word::of(word)).collect();
        let has = |meaning| meanings.contains(&meaning);
        let is_plain = !has(Word::Unknown);
        let is_event =
            has(Word::Time) || (unit_s.is_some() && (has(Word::Impact) || has(Word::Ends)));
        let column = if has(Word::Interval) {
            Column::Intervals
        } else if is_event {
            Column::Times
        } else {
            return None;
        };
        (unit_s.is_some() || is_plain).then(|| Self {
            column,
            unit_s: unit_s.unwrap_or(1.0),
            is_plain,
            is_one_of_several: has(Word::Number) || has(Word::Ends),
        })
    }
}

/// Whether a line of headings begins with one of times, or with a unit of time.
pub(crate) fn is_of_times(line: &str) -> bool {
    let first = line
        .split([',', ';', '\t'])
        .next()
        .unwrap_or_default()
        .trim_matches('"');
    let is_unit = || seconds(&first.trim_matches(['(', ')', '[', ']']).to_lowercase()).is_some();
    Heading::of(first).is_some_and(|heading| heading.column == Column::Times) || is_unit()
}

/// The unit at the end of a heading, in brackets, after a slash, or as its last word.
fn unit_s(heading: &str, words: &[&str]) -> Option<f64> {
    let (last, before) = words.split_last()?;
    let unit_s = seconds(last)?;
    let in_brackets = heading
        .rsplit(['(', '['])
        .next()
        .filter(|_| heading.contains(['(', '[']));
    let is_whole =
        in_brackets.is_none_or(|unit| unit.trim_end_matches([')', ']', ' ']).trim() == *last);
    // m/s is a unit of another quantity.
    let is_divisor = matches!(
        before.last(),
        None | Some(&"m" | &"cm" | &"mm" | &"km" | &"per")
    );
    (is_whole && !is_divisor).then_some(unit_s)
}

impl Word {
    fn of(word: &str) -> Self {
        let contains = |parts: &[&str]| parts.iter().any(|part| word.contains(part));
        match word {
            "time" | "times" | "timestamp" | "t" | "zeit" | "zeiten" | "zeitpunkt"
            | "zeitpunkte" | "temps" | "instant" | "instants" | "tiempo" | "tiempos"
            | "instante" | "instantes" => Self::Time,
            "impact" | "impacts" | "bounce" | "bounces" | "hit" | "hits" | "event" | "events"
            | "onset" | "onsets" | "aufprall" | "aufpralls" | "aufpralle" | "aufschlag"
            | "aufschläge" | "stoß" | "stöße" | "stoss" | "ereignis" | "ereignisse" | "rebond"
            | "rebonds" | "choc" | "chocs" | "événement" | "événements" | "impacto"
            | "impactos" | "rebote" | "rebotes" | "bote" | "botes" | "choque" | "choques"
            | "evento" | "eventos" => Self::Impact,
            "start" | "stop" | "stopp" | "début" | "arrêt" | "inicio" | "parada" => Self::Ends,
            "interval" | "intervals" | "difference" | "differences" | "duration" | "flight"
            | "flights" | "between" | "dt" | "δt" | "delta" | "dauer" | "flug" | "flüge"
            | "intervalle" | "intervalles" | "durée" | "durées" | "vol" | "vols" | "écart"
            | "écarts" | "différence" | "intervalo" | "intervalos" | "duración" | "vuelo"
            | "vuelos" | "diferencia" => Self::Interval,
            "of" | "the" | "at" | "in" | "and" | "number" | "nr" | "no" | "latest" | "der"
            | "des" | "die" | "vom" | "zum" | "von" | "zwischen" | "de" | "du" | "d" | "l"
            | "la" | "le" | "les" | "en" | "entre" | "el" | "los" | "del" => Self::Filler,
            _ if word.chars().all(|digit| digit.is_ascii_digit()) => Self::Number,
            // "t1", and compounds of German: "Flugdauer", "Zeitdifferenz", "Aufprallzeit".
            _ if word
                .strip_prefix('t')
                .is_some_and(|rest| rest.parse::<u32>().is_ok()) =>
            {
                Self::Time
            }
            _ if contains(&[
                "intervall",
                "differenz",
                "zeitabst",
                "flugzeit",
                "flugdauer",
                "zeitdauer",
            ]) =>
            {
                Self::Interval
            }
            _ if contains(&["aufprallzeit", "aufschlagzeit", "stoßzeit", "stosszeit"]) => {
                Self::Time
            }
            _ => Self::Unknown,
        }
    }
}

/// The seconds of a unit, by its symbol or name in lower case.
pub(crate) fn seconds(unit: &str) -> Option<f64> {
    match unit {
        "s" | "sec" | "second" | "seconds" | "sekunde" | "sekunden" | "seconde" | "secondes"
        | "segundo" | "segundos" => Some(1.0),
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
    use super::{Column, Heading};

    fn read(heading: &str) -> Option<(Column, f64)> {
        Heading::of(heading).map(|read| (read.column, read.unit_s))
    }

    #[test]
    fn a_heading_has_a_word_for_time_or_impact_and_perhaps_a_unit() {
        for (heading, unit_s) in [
            ("time", 1.0),
            ("time_s", 1.0),
            ("Time (s)", 1.0),
            ("Impact time [ms]", 1e-3),
            ("time_ms", 1e-3),
            ("Zeit in ms", 1e-3),
            ("Zeit in Millisekunden", 1e-3),
            ("Zeit t / s", 1.0),
            ("t/s", 1.0),
            ("t / µs", 1e-6),
            ("Temps (min)", 60.0),
            ("Time of impact (s)", 1.0),
            ("Zeitpunkt des Aufpralls (s)", 1.0),
            ("Aufprallzeit", 1.0),
            ("Instant du rebond (s)", 1.0),
            ("Temps d’impact", 1.0),
            ("Tiempo del bote [ms]", 1e-3),
            ("Event time (s)", 1.0),
            ("Bounce 3 (s)", 1.0),
            ("t1 (s)", 1.0),
            ("Stop 2 (s)", 1.0),
            ("Latest: Time (s)", 1.0),
            ("Ball A: time (s)", 1.0),
        ] {
            assert_eq!(read(heading), Some((Column::Times, unit_s)), "{heading}");
        }
    }

    #[test]
    fn intervals_have_words_of_their_own() {
        for (heading, unit_s) in [
            ("Interval (s)", 1.0),
            ("interval_ms", 1e-3),
            ("flight time", 1.0),
            ("flight_time_s", 1.0),
            ("Time between bounces (s)", 1.0),
            ("Difference (s)", 1.0),
            ("Δt / ms", 1e-3),
            ("Flugzeit (s)", 1.0),
            ("Zeitdifferenz in ms", 1e-3),
            ("Durée du vol (s)", 1.0),
            ("Intervalo (s)", 1.0),
        ] {
            assert_eq!(
                read(heading),
                Some((Column::Intervals, unit_s)),
                "{heading}"
            );
        }
    }

    #[test]
    fn other_quantities_are_left_out() {
        for heading in [
            "time (h)",
            "time of day",
            "Timer",
            "impact",
            "Bounce",
            "Height 1 (m)",
            "Energy 2",
            "",
            "impact speed (m/s)",
            "impact_speed_m_s",
            "impact rate (1/s)",
            "s",
            "Nr.",
            "Abstand (cm)",
            "distance_cm",
        ] {
            assert_eq!(read(heading), None, "{heading}");
        }
    }

    #[test]
    fn a_heading_of_known_words_goes_before_others() {
        let is_plain = |heading| Heading::of(heading).unwrap().is_plain;
        assert!(is_plain("Time of impact (s)"));
        assert!(!is_plain("Reaction time (s)"));
        let is_one_of_several = |heading| Heading::of(heading).unwrap().is_one_of_several;
        assert!(
            is_one_of_several("Stop 2 (s)")
                && is_one_of_several("Start (s)")
                && !is_one_of_several("t (s)")
        );
    }
}
