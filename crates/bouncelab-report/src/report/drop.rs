//! One drop in sentences, numbers and figures.

use bouncelab::analysis::{CONFIDENT_PROBABILITY, Drop, Options};
use bouncelab::inference::{Posterior, PriorContraction, UNINFORMATIVE};
use bouncelab::settings::Setup;

use super::page::{Block, Section, ended, sentence};
use crate::figure::{self, FigureInput, ReportSection};
use crate::messages::{Translator, Value, capital};
use crate::quantities::{self, Headline, Level, Method, QuantityList, Reported, Sentence};
use crate::quantity::Unit;
use crate::table::{Align, Table};
use crate::tables;

/// The answer of a drop in sentences: first the result, then what it follows from.
pub fn in_words(drop: &Drop, setup: &Setup, translator: &Translator) -> Vec<Block> {
    let headline = Headline::of(drop, setup, translator);
    let mut sentences = headline.sentences.iter().map(Sentence::to_string);
    let lead = sentences.next().map(Block::Lead);
    let rest = sentences.chain([detected(drop, translator)]);
    let rest = Block::text(rest.collect::<Vec<_>>().join(" "));
    let without_air = headline.without_air.map(|it| Block::text(it.to_string()));
    lead.into_iter().chain([rest]).chain(without_air).collect()
}

fn detected(drop: &Drop, translator: &Translator) -> String {
    let impacts = &drop.impacts;
    let seconds = |impact: Option<&bouncelab::Impact>| {
        Value::fixed(impact.map_or(f64::NAN, |impact| impact.time_s), 2)
    };
    let uncertain = impacts
        .iter()
        .filter(|i| i.probability < CONFIDENT_PROBABILITY)
        .count();
    let detected = [
        ("count", impacts.len().into()),
        ("first", seconds(impacts.first())),
        ("last", seconds(impacts.last())),
        ("uncertain", uncertain.into()),
    ];
    translator.text_with("report-impacts", &detected)
}

/// The answer of one drop and its main figures; `in_words_too` puts the sentences first.
pub fn drop(
    heading: &str,
    drop: &Drop,
    setup: &Setup,
    in_words_too: bool,
    translator: &Translator,
) -> Section {
    let settings = &setup.options;
    let mut blocks = if in_words_too {
        in_words(drop, setup, translator)
    } else {
        Vec::new()
    };
    let notes = quantities::notes(drop);
    blocks.extend(notes.map(|known| Block::Note(sentence(&translator.diagnostic(known)))));
    let lists = quantities::of_drop(drop, settings, translator);
    let answers = answers(&lists, translator);
    blocks.push(Block::table(translator.text("report-answers"), answers));
    let part = Part {
        input: &FigureInput::new(drop, settings),
        translator,
    };
    blocks.extend(part.figures(ReportSection::Answer));
    Section::new(heading, blocks)
}

/// The details of one drop, part by part.
pub fn drop_details(drop: &Drop, settings: &Options, translator: &Translator) -> Vec<Section> {
    let part = Part {
        input: &FigureInput::new(drop, settings),
        translator,
    };
    let lists = quantities::of_drop(drop, settings, translator);
    let mut parts = vec![
        part.impacts(drop),
        part.straight_line(drop),
        other_quantities(&lists, translator),
    ];
    parts.retain(|section| !section.is_empty());
    if let Ok(posterior) = &drop.posterior {
        parts.push(part.uncertainty(posterior));
        if posterior.models.len() > 1 && posterior.models.len() > 1 {
            parts.push(part.laws(posterior));
        }
        parts.push(part.contraction(posterior));
        parts.push(part.fit(posterior));
    }
    parts
}

/// The methods with and without air side by side.
fn answers(lists: &[QuantityList], translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
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
        let mut fitted = fitted.iter().flat_map(|list| &list.rows).find(of_id);
        let of_id = with_air
            .iter()
            .flat_map(|list| list.rows.iter().filter(of_id).map(|row| cells(list, row)));
        let mut rows: Vec<[String; 4]> = of_id
            .map(|[title, value, interval]| {
                // The fit knows no impact speed at which its restitution would hold.
                let same = fitted.take_if(|row| row.title() == title);
                [
                    title,
                    value,
                    interval,
                    same.map_or_else(String::new, |row| row.value.clone()),
                ]
            })
            .collect();
        rows.extend(fitted.map(|row| {
            let value = row.value.clone();
            [row.title(), String::new(), String::new(), value]
        }));
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
fn other_quantities(lists: &[QuantityList], translator: &Translator) -> Section {
    let mut table = Table::with_headings(
        translator,
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
    let caption = translator.text("report-quantities-table");
    let blocks = (!table.is_empty()).then(|| Block::table(caption, table));
    let heading = translator.text("report-quantities");
    Section::new(heading, blocks.into_iter().collect())
}

/// What the parts of a section have in common.
#[derive(Clone, Copy)]
struct Part<'a> {
    input: &'a FigureInput<'a>,
    translator: &'a Translator,
}

impl Part<'_> {
    /// The figures that stand in a section of the report.
    fn figures(self, section: ReportSection) -> impl Iterator<Item = Block> {
        let figures = figure::of_drop(self.input).filter(move |it| it.section == section);
        figures.map(move |it| Block::figure(it.name, it.chart(self.input, self.translator)))
    }

    fn impacts(self, drop: &Drop) -> Section {
        let mut blocks: Vec<Block> = self.figures(ReportSection::Impacts).collect();
        let table = tables::impacts(drop, true, self.translator);
        blocks.push(Block::table(
            self.translator.text("report-impacts-table"),
            table,
        ));
        Section::new(self.translator.text("report-impacts-heading"), blocks)
    }

    fn straight_line(self, drop: &Drop) -> Section {
        let translator = self.translator;
        let mut blocks = Vec::new();
        match &drop.log_linear_fit {
            Ok(line) => {
                let count = drop.flights.iter().filter(|flight| flight.in_fit).count();
                blocks.push(Block::text(match line.r_squared {
                    Some(determination) => translator.text_with(
                        "report-line-fits",
                        &[
                            ("count", count.into()),
                            ("determination", Value::fixed(determination, 5)),
                        ],
                    ),
                    None => translator.text_with("report-line-flights", &[("count", count.into())]),
                }));
                blocks.extend(self.figures(ReportSection::LogLinearFit));
            }
            Err(reason) => {
                let reason = [(
                    "reason",
                    ended(translator.diagnostic(&reason.diagnostic())).into(),
                )];
                blocks.push(Block::text(translator.text_with("report-no-line", &reason)));
            }
        }
        Section::new(translator.text("report-line-heading"), blocks)
    }

    fn uncertainty(self, posterior: &Posterior) -> Section {
        let translator = self.translator;
        let (budget, length) = (&posterior.budget, Unit::Length);
        let mut blocks = vec![
            Block::table(
                translator.text("report-budget-restitution"),
                tables::budget(&budget.restitution, Unit::Number, translator),
            ),
            Block::table(
                translator.text("report-budget-drop-height"),
                tables::budget(&budget.drop_height_m, length, translator),
            ),
        ];
        blocks.extend(self.figures(ReportSection::Uncertainty));
        Section::new(translator.text("report-uncertainty"), blocks)
    }

    fn laws(self, posterior: &Posterior) -> Section {
        let translator = self.translator;
        let table = tables::models(posterior, translator);
        let mut blocks = vec![Block::table(translator.text("report-laws-table"), table)];
        blocks.extend(self.figures(ReportSection::Laws));
        Section::new(translator.text("report-laws"), blocks)
    }

    /// What the data determined, and what only the priors.
    fn contraction(self, posterior: &Posterior) -> Section {
        let translator = self.translator;
        let unknowns = posterior.prior_contraction.iter();
        let sentences = unknowns
            .map(|unknown| contraction(unknown, translator))
            .collect();
        let mut blocks = vec![Block::List(sentences)];
        blocks.extend(self.figures(ReportSection::Contraction));
        let table = tables::correlations(posterior, translator);
        blocks.push(Block::table(translator.text("report-correlations"), table));
        Section::new(translator.text("report-contraction"), blocks)
    }

    fn fit(self, posterior: &Posterior) -> Section {
        let translator = self.translator;
        let sampling = &posterior.sampling;
        let mut blocks: Vec<Block> = self.figures(ReportSection::Fit).collect();
        let table = tables::fitted_impacts(posterior, translator);
        blocks.push(Block::table(translator.text("report-fit-table"), table));
        blocks.push(Block::text(translator.text_with(
            "report-sampling",
            &[
                ("draws", Value::fixed(sampling.effective_draws, 0)),
                ("shape", Value::fixed(sampling.pareto_shape, 2)),
            ],
        )));
        Section::new(translator.text("report-fit"), blocks)
    }
}

fn contraction(contraction: &PriorContraction, translator: &Translator) -> String {
    let unknown = capital(&tables::unknown(contraction.unknown, translator)).into();
    let left = Value::fixed(100.0 * contraction.remaining, 0);
    if contraction.remaining > UNINFORMATIVE {
        translator.text_with("report-uninformative", &[("unknown", unknown)])
    } else if contraction.remaining > 0.5 {
        translator.text_with(
            "report-little-informative",
            &[("unknown", unknown), ("left", left)],
        )
    } else {
        translator.text_with(
            "report-informative",
            &[("unknown", unknown), ("left", left)],
        )
    }
}
