//! The catalogue of reported quantities: what terminal, report, page and Python state of a drop.
//!
//! A quantity is one entry of `CATALOGUE`: how it follows from each method, its symbol, unit and level, and the
//! message with its name. Every front end takes its list, the order and the digits from [`of_drop`], and decides
//! only how the rows look and where each [`Level`] is; the tables of drops have a column for each estimate. What a
//! person reads first is the [`Headline`].
//!
//! ```
//! use bouncelab::{Options, analyze_times};
//! use bouncelab_report::messages::Translator;
//! use bouncelab_report::quantities::{self, Method};
//!
//! let options = Options::default().without_inference();
//! let result = analyze_times(&[0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], &options);
//! let lists = quantities::of_drop(&result.drops[0], &options, &Translator::english());
//! let fit = lists.iter().find(|list| list.method == Method::LogLinearFit).unwrap();
//! let [restitution, ..] = fit.rows.as_slice() else { panic!("there is a fit") };
//! assert_eq!(restitution.title(), "restitution e");
//! assert_eq!(restitution.value, "0.9322 ± 0.0010");
//! ```

mod headline;

use std::collections::BTreeMap;
use std::iter;

use bouncelab::Estimate;
use bouncelab::analysis::{Drop, Options};
use bouncelab::inference::{ApexTarget, Posterior, Prediction, UNKNOWN};
use bouncelab::regression::LogLinearFit;
use bouncelab::restitution::PerImpact;
use serde::Serialize;

use crate::columns::ENGLISH;
use crate::messages::{Translator, Value};
use crate::quantity::{Quantity, Unit};

pub use headline::{Headline, Sentence, notes};

/// Which readers a quantity is for; each level contains the ones before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Level {
    /// The answer.
    Headline,
    /// What most readers want besides.
    More,
    /// What explains or checks the answer.
    Details,
}

/// How quantities follow from the times of a drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// The posterior, with air.
    Inference,
    /// The restitution of each impact, corrected for drag.
    PerImpact,
    /// The log-linear fit of the flight times, without air.
    LogLinearFit,
}

impl Method {
    /// Every method, the best first.
    const ALL: [Self; 3] = [Self::Inference, Self::PerImpact, Self::LogLinearFit];

    /// What the names of its columns begin with.
    const fn prefix(self) -> &'static str {
        match self {
            Self::Inference => "",
            Self::PerImpact => "per_impact_",
            Self::LogLinearFit => "log_linear_fit_",
        }
    }

    /// Its name: the heading of its column or list.
    pub fn heading(self, translator: &Translator) -> String {
        translator.text(match self {
            Self::Inference => "column-inference",
            Self::PerImpact => "column-corrected",
            Self::LogLinearFit => "column-straight-line",
        })
    }
}

/// The quantities by one method.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct QuantityList {
    /// The method.
    pub method: Method,
    /// Its name, in the language of the reader.
    pub heading: String,
    /// In the order of the catalogue.
    pub rows: Vec<Reported>,
}

/// A quantity with its value, in the language of the reader.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Reported {
    /// Its field in the JSON document, in `posterior`, `per_impact` or `log_linear_fit` by the method.
    pub id: &'static str,
    /// Its name.
    pub name: String,
    /// Its symbol; empty if it has none.
    pub symbol: &'static str,
    /// Which readers it is for.
    pub level: Level,
    /// Its value with uncertainty and unit.
    pub value: String,
    /// The 95 % credible interval of an inferred quantity.
    #[serde(skip)]
    pub interval: Option<String>,
    /// The interval and what else belongs to the value, in one line.
    pub note: Option<String>,
}

impl Reported {
    /// Name and symbol.
    pub fn title(&self) -> String {
        format!("{} {}", self.name, self.symbol)
            .trim_end()
            .to_owned()
    }
}

/// How a method gives a quantity.
struct By<R: 'static> {
    /// `None` if the method does not give it.
    estimate: Option<fn(&R) -> Option<Estimate>>,
    /// The note on its value.
    note: fn(&R, &Translator) -> Option<String>,
    /// The impact speed that its name states, m/s.
    speed_m_s: fn(&R) -> Option<f64>,
}

impl<R> By<R> {
    /// The method does not give it.
    const NOT: Self = Self {
        estimate: None,
        note: |_, _| None,
        speed_m_s: |_| None,
    };

    const fn new(estimate: fn(&R) -> Option<Estimate>) -> Self {
        Self {
            estimate: Some(estimate),
            ..Self::NOT
        }
    }

    const fn noted(self, note: fn(&R, &Translator) -> Option<String>) -> Self {
        Self { note, ..self }
    }

    const fn at(self, speed_m_s: fn(&R) -> Option<f64>) -> Self {
        Self { speed_m_s, ..self }
    }

    fn of(&self, result: &R) -> Option<Estimate> {
        self.estimate.and_then(|estimate| estimate(result))
    }
}

/// An entry of the catalogue.
struct Entry {
    id: &'static str,
    /// The message with its name.
    message: &'static str,
    symbol: &'static str,
    unit: Unit,
    level: Level,
    inferred: By<Posterior>,
    per_impact: By<PerImpact>,
    fitted: By<LogLinearFit>,
    is_reported: fn(&Options) -> bool,
}

impl Entry {
    /// A quantity without symbol that no method gives yet.
    const fn new(id: &'static str, message: &'static str, unit: Unit, level: Level) -> Self {
        Self {
            id,
            message,
            symbol: "",
            unit,
            level,
            inferred: By::NOT,
            per_impact: By::NOT,
            fitted: By::NOT,
            is_reported: |_| true,
        }
    }
}

/// Every quantity, in the order in which they are reported.
static CATALOGUE: [Entry; 13] = [
    Entry {
        symbol: "e",
        inferred: By::new(|it: &Posterior| Some(it.restitution)).at(|it| Some(it.at_speed_m_s)),
        per_impact: By::new(|it: &PerImpact| it.restitution).noted(of_impacts),
        fitted: By::new(|it: &LogLinearFit| Some(it.restitution)),
        ..Entry::new(
            "restitution",
            "quantity-restitution",
            Unit::Number,
            Level::Headline,
        )
    },
    Entry {
        symbol: "e",
        inferred: By::new(|it: &Posterior| it.round_speed_restitution).at(|it| it.round_speed_m_s),
        ..Entry::new(
            "round_speed_restitution",
            "quantity-restitution",
            Unit::Number,
            Level::Headline,
        )
    },
    Entry {
        inferred: By::new(|it: &Posterior| Some(it.energy_kept)).at(|it| Some(it.first_speed_m_s)),
        fitted: By::new(|it: &LogLinearFit| Some(it.energy_kept)),
        ..Entry::new(
            "energy_kept",
            "quantity-energy-kept",
            Unit::Percent,
            Level::Headline,
        )
    },
    Entry {
        symbol: "h0",
        inferred: By::new(|it: &Posterior| Some(it.drop_height_m)).noted(of_which_fall),
        fitted: By::new(|it: &LogLinearFit| Some(it.drop_height_m)).noted(of_flights),
        ..Entry::new(
            "drop_height_m",
            "quantity-drop-height",
            Unit::Length,
            Level::Headline,
        )
    },
    Entry {
        symbol: "C_D",
        inferred: By::new(|it: &Posterior| it.drag_coefficient).noted(before_data),
        ..Entry::new(
            "drag_coefficient",
            "quantity-drag",
            Unit::Number,
            Level::More,
        )
    },
    Entry {
        inferred: By::new(|it: &Posterior| it.terminal_speed_m_s),
        ..Entry::new(
            "terminal_speed_m_s",
            "quantity-terminal-speed",
            Unit::Speed,
            Level::More,
        )
    },
    Entry {
        symbol: "g",
        inferred: By::new(|it: &Posterior| Some(it.gravity_m_s2)),
        // Otherwise it is a setting.
        is_reported: |options| options.priors.gravity_rel_sd >= UNKNOWN,
        ..Entry::new(
            "gravity_m_s2",
            "quantity-gravity",
            Unit::Acceleration,
            Level::More,
        )
    },
    Entry {
        inferred: By::new(|it: &Posterior| it.total_time_s),
        fitted: By::new(|it: &LogLinearFit| it.total_time_s),
        ..Entry::new(
            "total_time_s",
            "quantity-total-time",
            Unit::Time,
            Level::More,
        )
    },
    Entry {
        inferred: By::new(|it: &Posterior| it.total_path_m),
        fitted: By::new(|it: &LogLinearFit| it.total_path_m),
        ..Entry::new(
            "total_path_m",
            "quantity-total-path",
            Unit::Length,
            Level::More,
        )
    },
    Entry {
        inferred: By::new(|it: &Posterior| Some(it.restitution_slope))
            .noted(|_, _| Some("−d ln e/d ln v".to_owned())),
        ..Entry::new(
            "restitution_slope",
            "quantity-slope",
            Unit::Number,
            Level::Details,
        )
    },
    Entry {
        inferred: By::new(|it: &Posterior| Some(it.restitution_scatter)),
        ..Entry::new(
            "restitution_scatter",
            "quantity-scatter",
            Unit::Percent,
            Level::Details,
        )
    },
    Entry {
        inferred: By::new(|it: &Posterior| Some(it.timing_s)),
        ..Entry::new("timing_s", "quantity-timing", Unit::Time, Level::Details)
    },
    Entry {
        inferred: By::new(|it: &Posterior| Some(it.contact_time_s)),
        ..Entry::new(
            "contact_time_s",
            "quantity-contact-time",
            Unit::Time,
            Level::Details,
        )
    },
];

/// Predictions of other drops, as many as were asked for.
const PREDICTIONS: &str = "predictions";

/// The ids of all quantities, in the order in which they are reported.
pub fn ids() -> impl Iterator<Item = &'static str> {
    let ids = CATALOGUE.iter().map(|entry| entry.id);
    ids.chain([PREDICTIONS])
}

/// A quantity by one method, as tables of drops have it.
pub(crate) struct Tabulated {
    /// The name of its column: the field of the document that holds it.
    pub(crate) name: String,
    pub(crate) unit: Unit,
    /// What it is.
    pub(crate) about: String,
}

/// Every quantity that tables of drops have, method by method.
pub(crate) fn tabulated() -> impl Iterator<Item = Tabulated> {
    let of_method = |method: Method| {
        let given = CATALOGUE.iter().filter(move |entry| match method {
            Method::Inference => entry.inferred.estimate.is_some(),
            Method::PerImpact => entry.per_impact.estimate.is_some(),
            Method::LogLinearFit => entry.fitted.estimate.is_some(),
        });
        given.map(move |entry| Tabulated {
            name: format!("{}{}", method.prefix(), entry.id),
            unit: entry.unit,
            about: format!(
                "{} ({})",
                ENGLISH.text(entry.message),
                method.heading(&ENGLISH)
            ),
        })
    };
    Method::ALL.into_iter().flat_map(of_method)
}

/// The estimates of a drop, by the names of their columns.
pub(crate) fn estimates(drop: &Drop) -> BTreeMap<String, Estimate> {
    let (inferred, fit) = (
        drop.posterior.as_ref().ok(),
        drop.log_linear_fit.as_ref().ok(),
    );
    let per_impact = drop.per_impact.as_ref().ok();
    let of_entry = |entry: &'static Entry| {
        let by_method = [
            inferred.and_then(|it| entry.inferred.of(it)),
            per_impact.and_then(|it| entry.per_impact.of(it)),
            fit.and_then(|it| entry.fitted.of(it)),
        ];
        let named = move |(method, estimate): (Method, Option<Estimate>)| {
            Some((format!("{}{}", method.prefix(), entry.id), estimate?))
        };
        iter::zip(Method::ALL, by_method).filter_map(named)
    };
    CATALOGUE.iter().flat_map(of_entry).collect()
}

/// The quantities of a drop, method by method, the best first; a method that gives none has no list.
pub fn of_drop(drop: &Drop, options: &Options, translator: &Translator) -> Vec<QuantityList> {
    let reader = Reader {
        options,
        translator,
    };
    let posterior = drop.posterior.as_ref().ok();
    let inferred = posterior.map(|posterior| {
        let predictions = posterior.predictions.iter();
        let predictions = predictions.map(|prediction| reader.prediction(prediction));
        let mut rows = reader.rows(Method::Inference, posterior, |entry| &entry.inferred);
        rows.extend(predictions);
        rows
    });
    let per_impact = drop.per_impact.as_ref().ok().map(|result| {
        let mut rows = reader.rows(Method::PerImpact, result, |entry| &entry.per_impact);
        // It is an answer where no inference was asked for. It checks one that is there, and replaces none that failed.
        let level = match (posterior, &options.inference) {
            (Some(_), _) => Level::Details,
            (None, Some(_)) => Level::More,
            (None, None) => Level::Headline,
        };
        for row in &mut rows {
            row.level = level;
        }
        rows
    });
    let fit = drop.log_linear_fit.as_ref().ok();
    let fitted = fit.map(|fit| {
        let mut rows = reader.rows(Method::LogLinearFit, fit, |entry| &entry.fitted);
        // Without the air it is no answer.
        for row in &mut rows {
            row.level = row.level.max(Level::More);
        }
        rows
    });
    [
        (Method::Inference, inferred),
        (Method::PerImpact, per_impact),
        (Method::LogLinearFit, fitted),
    ]
    .into_iter()
    .filter_map(|(method, rows)| {
        let rows = rows.filter(|rows| !rows.is_empty())?;
        let heading = method.heading(translator);
        Some(QuantityList {
            method,
            heading,
            rows,
        })
    })
    .collect()
}

/// The answer of a drop in one line: each headline quantity with its name; empty if there is no answer.
pub fn in_one_line(drop: &Drop, options: &Options, translator: &Translator) -> String {
    let lists = of_drop(drop, options, translator).into_iter();
    let rows = lists.flat_map(|list| list.rows);
    let headline = rows.filter(|row| row.level == Level::Headline);
    let answers = headline.map(|row| format!("{} {}", row.name, row.value));
    answers.collect::<Vec<_>>().join(", ")
}

/// For whom quantities are written.
struct Reader<'a> {
    options: &'a Options,
    translator: &'a Translator,
}

impl Reader<'_> {
    /// What a method gives.
    fn rows<R>(&self, method: Method, result: &R, by: fn(&Entry) -> &By<R>) -> Vec<Reported> {
        let entries = CATALOGUE.iter();
        let reported = entries.filter(|entry| (entry.is_reported)(self.options));
        let rows = reported.filter_map(|entry| {
            let by = by(entry);
            let estimate = by.of(result)?;
            let note = (by.note)(result, self.translator);
            let (interval, note) = match method {
                Method::Inference => self.interval(&estimate, entry.unit, note),
                Method::PerImpact | Method::LogLinearFit => (None, note),
            };
            Some(Reported {
                id: entry.id,
                name: self.name(entry, (by.speed_m_s)(result)),
                symbol: entry.symbol,
                level: entry.level,
                value: Quantity::of(&estimate, entry.unit).text(self.translator),
                interval,
                note,
            })
        });
        rows.collect()
    }

    /// The name of a quantity, with the impact speed at which it holds.
    fn name(&self, entry: &Entry, speed_m_s: Option<f64>) -> String {
        let name = self.translator.text(entry.message);
        let Some(speed_m_s) = speed_m_s else {
            return name;
        };
        let speed = impact_speed(speed_m_s);
        let named = [("quantity", name.into()), ("speed", speed.into())];
        self.translator.text_with("quantity-at-speed", &named)
    }

    /// The height from which a bounce reaches an apex.
    fn prediction(&self, prediction: &Prediction) -> Reported {
        let ApexTarget { bounce, apex_m } = prediction.target;
        let apex = Quantity::rounded(apex_m, 4, Unit::Length);
        let target = [("bounce", bounce.into()), ("apex", apex.into())];
        let height = prediction.drop_height_m.as_ref();
        let (interval, note) = height
            .map(|height| self.interval(height, Unit::Length, None))
            .unwrap_or_default();
        Reported {
            id: PREDICTIONS,
            name: self
                .translator
                .text_with("quantity-height-to-reach", &target),
            symbol: "",
            level: Level::More,
            value: height.map_or_else(
                || self.translator.text("unit-cannot-tell"),
                |height| Quantity::of(height, Unit::Length).text(self.translator),
            ),
            interval,
            note,
        }
    }

    /// The interval of an inferred quantity, and its note with the interval in it.
    fn interval(
        &self,
        estimate: &Estimate,
        unit: Unit,
        note: Option<String>,
    ) -> (Option<String>, Option<String>) {
        if estimate.sd == 0.0 {
            return (None, Some(self.translator.text("quantity-known")));
        }
        let value = Quantity::of(estimate, unit);
        let interval = value.interval_text(estimate.interval95, self.translator);
        let stated = [("interval", interval.as_str().into())];
        let stated = self.translator.text_with("quantity-interval", &stated);
        let note = self.translator.in_one_line(iter::once(stated).chain(note));
        (Some(interval), Some(note))
    }
}

/// An impact speed: a round one by its single digit.
fn impact_speed(speed_m_s: f64) -> Quantity {
    let is_round = !format!("{speed_m_s:e}").contains('.');
    Quantity::rounded(speed_m_s, if is_round { 1 } else { 3 }, Unit::Speed)
}

/// How many impacts a median is of, and at which speeds.
fn of_impacts(result: &PerImpact, translator: &Translator) -> Option<String> {
    let impacts = [
        ("count", result.impacts.len().into()),
        ("slowest", Value::fixed(result.slowest_m_s?, 2)),
        ("fastest", Value::fixed(result.fastest_m_s?, 2)),
    ];
    Some(translator.text_with("quantity-of-impacts", &impacts))
}

/// How many flights a fit is of.
#[expect(
    clippy::unnecessary_wraps,
    reason = "notes of other quantities may be missing"
)]
fn of_flights(fit: &LogLinearFit, translator: &Translator) -> Option<String> {
    let count = [("count", fit.flights.into())];
    Some(translator.text_with("quantity-of-flights", &count))
}

/// Whether the drop height was stated, and before which impact its fall is: how many were missed before, or that it is the
/// first detected.
fn of_which_fall(posterior: &Posterior, translator: &Translator) -> Option<String> {
    /// Smaller probabilities would be shown as 0 %.
    const MIN_SHOWN: f64 = 0.005;
    let is_stated = posterior.height_was_stated();
    let stated = is_stated.then(|| translator.text("quantity-stated"));
    let Some(probabilities) = &posterior.missed_first_impacts else {
        return stated.or_else(|| Some(translator.text("quantity-first-fall")));
    };
    let counts = probabilities.iter().enumerate();
    let likely = counts.filter(|(_, probability)| **probability >= MIN_SHOWN);
    let shown =
        likely.map(|(missed, probability)| format!("{missed}: {:.0} %", probability * 100.0));
    let list = shown.collect::<Vec<_>>().join(", ");
    let missed = translator.text_with("quantity-missed", &[("list", list.into())]);
    let notes: Vec<String> = stated.into_iter().chain([missed]).collect();
    Some(notes.join("; "))
}

/// The drag coefficient before the data.
fn before_data(posterior: &Posterior, translator: &Translator) -> Option<String> {
    let prior = posterior.drag_coefficient_prior?;
    if prior.sd == 0.0 {
        return Some(translator.text("quantity-known"));
    }
    let value = Quantity::measured(prior.value, prior.sd, Unit::Number);
    Some(translator.text_with("quantity-before-data", &[("value", value.into())]))
}

#[cfg(test)]
mod tests {
    use bouncelab::analyze_times;
    use bouncelab::inference::{InferenceOptions, SamplerConfig};
    use serde_json::Value as Json;

    use super::*;

    const TIMES_S: [f64; 10] = [
        0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984,
    ];

    fn options() -> Options {
        let sampler = SamplerConfig {
            draws: 300,
            seed: 1,
        };
        Options::default().with_sampler(sampler)
    }

    fn drop_of(options: &Options) -> Drop {
        analyze_times(&TIMES_S, options).drops.remove(0)
    }

    fn list(lists: &[QuantityList], method: Method) -> &[Reported] {
        let list = lists.iter().find(|list| list.method == method);
        list.map_or(&[], |list| &list.rows)
    }

    /// The number that a field of a document holds.
    fn number(document: &Json, id: &str) -> Option<f64> {
        let estimate = document.get(id)?;
        if estimate.is_null() {
            return None;
        }
        Some(estimate["value"].as_f64().unwrap())
    }

    /// So tables, which have the names of the document, and the catalogue mean the same by a name.
    #[test]
    fn an_id_is_the_field_of_the_document_that_holds_the_number() {
        let drop = drop_of(&options());
        let posterior = drop.posterior.as_ref().unwrap();
        let per_impact = drop.per_impact.as_ref().unwrap();
        let fit = drop.log_linear_fit.as_ref().unwrap();
        let document = serde_json::to_value(&drop).unwrap();
        for entry in &CATALOGUE {
            let same = |method: &str, estimate: Option<Estimate>| {
                if let Some(estimate) = estimate {
                    let stated = number(&document[method], entry.id);
                    assert_eq!(stated, Some(estimate.value), "{}", entry.id);
                }
            };
            same("posterior", entry.inferred.of(posterior));
            same("per_impact", entry.per_impact.of(per_impact));
            same("log_linear_fit", entry.fitted.of(fit));
        }
    }

    #[test]
    fn every_estimate_of_a_drop_has_a_column() {
        let columns: Vec<String> = tabulated().map(|it| it.name).collect();
        let estimates = estimates(&drop_of(&options()));
        assert_eq!(estimates["log_linear_fit_energy_kept"].value.to_bits(), {
            let fit = drop_of(&options()).log_linear_fit.unwrap();
            fit.energy_kept.value.to_bits()
        });
        // Gravity and the time until rest are among them.
        assert!(estimates.keys().all(|name| columns.contains(name)));
        assert_eq!(estimates.len(), columns.len(), "{columns:?}");
    }

    #[test]
    fn without_inference_the_median_of_the_impacts_is_the_answer() {
        let level = |options: &Options| {
            let lists = of_drop(&drop_of(options), options, &Translator::english());
            list(&lists, Method::PerImpact)[0].level
        };
        assert_eq!(level(&options()), Level::Details);
        assert_eq!(level(&options().without_inference()), Level::Headline);
    }

    #[test]
    fn gravity_is_reported_where_it_is_inferred() {
        let mut options = Options::default();
        let is_reported = |options: &Options| {
            let lists = of_drop(&drop_of(options), options, &Translator::english());
            let rows = list(&lists, Method::Inference);
            rows.iter().any(|row| row.id == "gravity_m_s2")
        };
        assert!(!is_reported(&options));
        options.priors.gravity_rel_sd = UNKNOWN;
        assert!(is_reported(&options));
    }

    #[test]
    fn a_prediction_is_a_quantity_and_so_is_one_that_cannot_be_made() {
        let target = |apex_m| ApexTarget { bounce: 2, apex_m };
        let mut options = options();
        options.inference = options.inference.map(|inference| InferenceOptions {
            reach: vec![target(0.28), target(1e6)],
            ..inference
        });
        let lists = of_drop(&drop_of(&options), &options, &Translator::english());
        let rows = list(&lists, Method::Inference).iter();
        let mut predictions = rows.filter(|row| row.id == "predictions");
        let near = predictions.next().unwrap();
        assert_eq!(near.name, "bounce 2 reaches 28.00 cm from");
        assert!(near.interval.is_some() && near.value.ends_with(" cm"));
        assert_eq!(predictions.next().unwrap().value, "cannot tell");
    }

    #[test]
    fn one_line_has_the_restitution_with_its_speed_and_the_drop_height() {
        let options = options();
        let line = in_one_line(&drop_of(&options), &options, &Translator::english());
        let rows: Vec<&str> = line.split(", ").collect();
        assert!(rows[0].starts_with("restitution at 2.3"), "{line}");
        assert!(rows[1].starts_with("restitution at 2 m/s 0.9"), "{line}");
        assert!(rows[2].starts_with("energy kept at 2.3"), "{line}");
        assert!(rows[3].starts_with("drop height ") && rows[3].ends_with(" cm"));
    }
}
