//! One drop in words, numbers and figures.

use bouncelab::analysis::{CONFIDENT_PROBABILITY, Drop, Options};
use bouncelab::inference::{Posterior, PriorContraction, UNINFORMATIVE};
use bouncelab::regression::LogLinearFit;

use super::page::{Block, Section, ended, sentence};
use crate::figure::{self, ReportSection, Subject};
use crate::messages::{Translator, Value, capital};
use crate::quantities::{self, Level, Method, QuantityList, Reported};
use crate::quantity::{Quantity, Unit};
use crate::table::{Align, Table};
use crate::tables;

/// The answer of a drop in plain words: one sentence to remember, and what it rests on.
pub fn in_words(drop: &Drop, words: &Translator) -> Vec<Block> {
    let mut blocks = vec![
        Block::Lead(kept(drop, words)),
        Block::text(detected(drop, words)),
    ];
    if let (Ok(found), Ok(line)) = (&drop.posterior, &drop.log_linear_fit) {
        blocks.push(Block::text(against_the_line(found, line, words)));
    }
    blocks
}

/// "The ball kept 94.6 ± 0.2 % of its speed at each bounce and fell from 30.4 ± 0.6 cm."
fn kept(drop: &Drop, words: &Translator) -> String {
    let inline = |quantity: Quantity| Value::from(unbroken(quantity, words));
    match (
        &drop.posterior,
        drop.per_impact_restitution(),
        &drop.log_linear_fit,
    ) {
        (Ok(found), ..) => {
            let is_release = found.first_was_detected() || found.missed_first_impacts.is_some();
            let id = if is_release {
                "report-kept-and-fell"
            } else {
                "report-kept-and-fell-first"
            };
            let share = inline(Quantity::of(&found.restitution, Unit::Percent));
            let height = inline(Quantity::of(&found.drop_height_m, Unit::Length));
            words.text_with(id, &[("share", share), ("height", height)])
        }
        (_, Some(corrected), _) => {
            let share = inline(Quantity::of(&corrected, Unit::Percent));
            words.text_with("report-kept", &[("share", share)])
        }
        (.., Ok(line)) => {
            let share = inline(Quantity::of(&line.restitution, Unit::Percent));
            let height = inline(Quantity::of(&line.drop_height_m, Unit::Length));
            words.text_with(
                "report-kept-without-air",
                &[("share", share), ("height", height)],
            )
        }
        (.., Err(reason)) => words.text_with(
            "report-kept-unknown",
            &[(
                "reason",
                ended(words.diagnostic(&reason.diagnostic())).into(),
            )],
        ),
    }
}

fn detected(drop: &Drop, words: &Translator) -> String {
    let impacts = &drop.impacts;
    let seconds = |impact: Option<&bouncelab::Impact>| {
        Value::fixed(impact.map_or(f64::NAN, |impact| impact.time_s), 2)
    };
    let uncertain = impacts
        .iter()
        .filter(|i| i.probability < CONFIDENT_PROBABILITY)
        .count();
    let impacts = words.text_with(
        "report-impacts",
        &[
            ("count", impacts.len().into()),
            ("first", seconds(impacts.first())),
            ("last", seconds(impacts.last())),
            ("uncertain", uncertain.into()),
        ],
    );
    let Ok(found) = &drop.posterior else {
        return impacts;
    };
    let value = unbroken(Quantity::of(&found.restitution, Unit::Number), words);
    let speed = unbroken(Quantity::rounded(found.at_speed_m_s, 3, Unit::Speed), words);
    let restitution = [("value", value.into()), ("speed", speed.into())];
    format!(
        "{impacts} {}",
        words.text_with("report-restitution", &restitution)
    )
}

/// What drag does to the log-linear fit of the paper.
fn against_the_line(found: &Posterior, line: &LogLinearFit, words: &Translator) -> String {
    let points = 100.0 * (found.restitution.value - line.restitution.value);
    let difference = match points {
        _ if points.abs() < 0.05 => "none",
        _ if points > 0.0 => "less",
        _ => "more",
    };
    let share = unbroken(Quantity::of(&line.restitution, Unit::Percent), words);
    let height = unbroken(Quantity::of(&line.drop_height_m, Unit::Length), words);
    words.text_with(
        "report-line-says",
        &[
            ("share", share.into()),
            ("difference", difference.into()),
            ("points", Value::fixed(points.abs(), 1)),
            ("height", height.into()),
        ],
    )
}

/// The answer of one drop and its main figures; `in_words_too` puts the answer in words first.
pub fn drop(
    heading: &str,
    drop: &Drop,
    settings: &Options,
    in_words_too: bool,
    words: &Translator,
) -> Section {
    let mut blocks = if in_words_too {
        in_words(drop, words)
    } else {
        Vec::new()
    };
    let notes = drop.diagnostics.iter();
    blocks.extend(notes.map(|known| Block::Note(sentence(&words.diagnostic(known)))));
    let lists = quantities::of_drop(drop, settings, words);
    let answers = answers(&lists, words);
    blocks.push(Block::table(words.text("report-answers"), answers));
    let part = Part {
        subject: &Subject::new(drop, settings),
        words,
    };
    blocks.extend(part.figures(ReportSection::Answer));
    Section::new(heading, blocks)
}

/// What else there is to say of one drop, part by part.
pub fn drop_details(drop: &Drop, settings: &Options, words: &Translator) -> Vec<Section> {
    let part = Part {
        subject: &Subject::new(drop, settings),
        words,
    };
    let lists = quantities::of_drop(drop, settings, words);
    let mut parts = vec![
        part.impacts(drop),
        part.straight_line(drop),
        other_quantities(&lists, words),
    ];
    parts.retain(|section| !section.is_empty());
    if let Ok(found) = &drop.posterior {
        parts.push(part.uncertainty(found));
        parts.push(part.laws(found));
        parts.push(part.contraction(found));
        parts.push(part.fit(found));
    }
    parts
}

/// The methods with and without air side by side.
fn answers(lists: &[QuantityList], words: &Translator) -> Table {
    let mut table = Table::with_headings(
        words,
        [
            ("", Align::Left),
            ("column-inference", Align::Right),
            ("column-95", Align::Right),
            ("column-straight-line", Align::Right),
        ],
    );
    let (with_air, fitted): (Vec<_>, Vec<_>) = lists
        .iter()
        .partition(|list| list.method != Method::LogLinearFit);
    for id in quantities::ids() {
        let of_id = |row: &&Reported| row.id == id && row.level < Level::Details;
        let fitted = fitted.iter().flat_map(|list| &list.rows).find(of_id);
        let fit_value = fitted.map_or("", |row| &row.value);
        let mut rows: Vec<[String; 4]> = with_air
            .iter()
            .flat_map(|list| list.rows.iter().filter(of_id).map(|row| cells(list, row)))
            .map(|[title, value, interval]| [title, value, interval, fit_value.to_owned()])
            .collect();
        if rows.is_empty() {
            let alone = fitted.map(|row| {
                let value = row.value.clone();
                [row.title(), String::new(), String::new(), value]
            });
            rows.extend(alone);
        }
        for row in rows {
            table.row(row);
        }
    }
    table
}

/// Name, value and interval of a quantity; the name says by which method it is, unless by the inference.
fn cells(list: &QuantityList, row: &Reported) -> [String; 3] {
    let title = match list.method {
        Method::Inference => row.title(),
        Method::PerImpact | Method::LogLinearFit => format!("{}, {}", row.title(), list.heading),
    };
    let interval = row.interval.clone().unwrap_or_default();
    [title, row.value.clone(), interval]
}

/// The quantities that explain or check the answers.
fn other_quantities(lists: &[QuantityList], words: &Translator) -> Section {
    let mut table = Table::with_headings(
        words,
        [
            ("", Align::Left),
            ("column-inference", Align::Right),
            ("column-95", Align::Right),
        ],
    );
    for list in lists {
        let rows = list.rows.iter().filter(|row| row.level == Level::Details);
        for row in rows {
            table.row(cells(list, row));
        }
    }
    let heading = words.text("report-quantities");
    let blocks = (!table.is_empty()).then(|| Block::table(heading.clone(), table));
    Section::new(heading, blocks.into_iter().collect())
}

/// What the parts of a section have in common.
#[derive(Clone, Copy)]
struct Part<'a> {
    subject: &'a Subject<'a>,
    words: &'a Translator,
}

impl Part<'_> {
    /// The figures that stand in a section of the report.
    fn figures(self, section: ReportSection) -> impl Iterator<Item = Block> {
        let figures = figure::of_drop(self.subject).filter(move |it| it.section == section);
        figures.map(move |it| Block::figure(it.name, it.chart(self.subject, self.words)))
    }

    fn impacts(self, drop: &Drop) -> Section {
        let mut blocks: Vec<Block> = self.figures(ReportSection::Impacts).collect();
        let table = tables::impacts(drop, true, self.words);
        blocks.push(Block::table(self.words.text("report-impacts-table"), table));
        Section::new(self.words.text("report-impacts-heading"), blocks)
    }

    fn straight_line(self, drop: &Drop) -> Section {
        let words = self.words;
        let mut blocks = Vec::new();
        match &drop.log_linear_fit {
            Ok(line) => {
                let count = drop.flights.iter().filter(|flight| flight.in_fit).count();
                blocks.push(Block::text(match line.r_squared {
                    Some(determination) => words.text_with(
                        "report-line-fits",
                        &[
                            ("count", count.into()),
                            ("determination", Value::fixed(determination, 5)),
                        ],
                    ),
                    None => words.text_with("report-line-flights", &[("count", count.into())]),
                }));
                blocks.extend(self.figures(ReportSection::LogLinearFit));
            }
            Err(reason) => {
                let reason = [(
                    "reason",
                    ended(words.diagnostic(&reason.diagnostic())).into(),
                )];
                blocks.push(Block::text(words.text_with("report-no-line", &reason)));
            }
        }
        Section::new(words.text("report-line-heading"), blocks)
    }

    fn uncertainty(self, found: &Posterior) -> Section {
        let words = self.words;
        let (budget, length) = (&found.budget, Unit::Length);
        let mut blocks = vec![
            Block::table(
                words.text("report-budget-restitution"),
                tables::budget(&budget.restitution, Unit::Number, words),
            ),
            Block::table(
                words.text("report-budget-drop-height"),
                tables::budget(&budget.drop_height_m, length, words),
            ),
        ];
        blocks.extend(self.figures(ReportSection::Uncertainty));
        Section::new(words.text("report-uncertainty"), blocks)
    }

    fn laws(self, found: &Posterior) -> Section {
        let words = self.words;
        let table = tables::models(found, words);
        let mut blocks = vec![Block::table(words.text("report-laws-table"), table)];
        blocks.extend(self.figures(ReportSection::Laws));
        Section::new(words.text("report-laws"), blocks)
    }

    /// What the data determined, and what only the priors did.
    fn contraction(self, found: &Posterior) -> Section {
        let words = self.words;
        let unknowns = found.prior_contraction.iter();
        let sentences = unknowns
            .map(|unknown| contraction(unknown, words))
            .collect();
        let mut blocks = vec![Block::List(sentences)];
        blocks.extend(self.figures(ReportSection::Contraction));
        let table = tables::correlations(found, words);
        blocks.push(Block::table(words.text("report-correlations"), table));
        Section::new(words.text("report-contraction"), blocks)
    }

    fn fit(self, found: &Posterior) -> Section {
        let words = self.words;
        let sampling = &found.sampling;
        let mut blocks: Vec<Block> = self.figures(ReportSection::Fit).collect();
        let table = tables::fitted_impacts(found, words);
        blocks.push(Block::table(words.text("report-fit-table"), table));
        blocks.push(Block::text(words.text_with(
            "report-sampling",
            &[
                ("draws", Value::fixed(sampling.effective_draws, 0)),
                ("shape", Value::fixed(sampling.pareto_shape, 2)),
            ],
        )));
        Section::new(words.text("report-fit"), blocks)
    }
}

fn contraction(found: &PriorContraction, words: &Translator) -> String {
    let unknown = capital(&tables::unknown(found.unknown, words)).into();
    let left = Value::fixed(100.0 * found.remaining, 0);
    if found.remaining > UNINFORMATIVE {
        words.text_with("report-uninformative", &[("unknown", unknown)])
    } else if found.remaining > 0.5 {
        words.text_with(
            "report-little-informative",
            &[("unknown", unknown), ("left", left)],
        )
    } else {
        words.text_with(
            "report-informative",
            &[("unknown", unknown), ("left", left)],
        )
    }
}

/// A quantity in a sentence: no line ends within it.
fn unbroken(quantity: Quantity, words: &Translator) -> String {
    quantity.text(words).replace(' ', "\u{a0}")
}
