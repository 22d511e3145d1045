//! The reported quantities of a drop as text.

use bouncelab::analysis::Drop;
use bouncelab::settings::Setup;
use bouncelab_report::messages::Value;
use bouncelab_report::quantities::{self, Headline, Level, Method, QuantityList, Reported};
use bouncelab_report::{Unit, tables};
use unicode_width::UnicodeWidthStr;

use crate::language::{cannot_tell, text, text_with, translated, translator};

/// The answer in sentences, and the quantities by each method, the best first; with `details`, those of every level.
pub(super) fn lines(drop: &Drop, physics: &Setup, details: bool) -> Vec<String> {
    let headline = Headline::of(drop, physics, translator());
    // Spaces that no line may end at would be strange characters to programs that read text.
    let sentences = headline.sentences.iter();
    let mut lines: Vec<String> = sentences
        .map(|it| it.to_string().replace('\u{a0}', " "))
        .collect();
    lines.push(String::new());
    let lists = quantities::of_drop(drop, &physics.options, translator());
    let listed = |method: Method, heading: String| listed(&lists, method, heading, details);
    lines.extend(listed(Method::Inference, text("analyze-inference-heading")));
    let law = tables::drag_law(&physics.options.environment.drag, translator());
    let heading = text_with("analyze-corrected-heading", &[("law", law.into())]);
    lines.extend(match &drop.per_impact {
        Ok(_) => listed(Method::PerImpact, heading),
        // The headline states it already.
        Err(reason) if drop.posterior.as_ref().err() == Some(reason) => Vec::new(),
        Err(reason) => vec![cannot_tell("analyze-corrected", translated(reason))],
    });
    lines.extend(match &drop.log_linear_fit {
        Ok(_) => listed(Method::LogLinearFit, text("analyze-line-heading")),
        Err(reason) => vec![cannot_tell("analyze-line", translated(reason))],
    });
    lines
}

/// A heading and the quantities of a method below it, their values in one column; nothing if all are for
/// `details`, which were not asked for.
fn listed(lists: &[QuantityList], method: Method, heading: String, details: bool) -> Vec<String> {
    /// The longest name in English.
    const USUAL: usize = 18;
    let most = if details { Level::Details } else { Level::More };
    let rows = lists.iter().filter(|list| list.method == method);
    let rows = rows.flat_map(|list| &list.rows);
    let rows: Vec<&Reported> = rows.filter(|row| row.level <= most).collect();
    if rows.is_empty() {
        return Vec::new();
    }
    let widths = rows.iter().map(|row| row.name.width());
    let width = widths.fold(USUAL, usize::max);
    let lines = rows.iter().map(|row| {
        let space = " ".repeat(width - row.name.width());
        let symbol = match row.symbol {
            "" => String::new(),
            symbol => format!("{symbol:<2} ="),
        };
        let note = row.note.iter().map(|note| format!("   ({note})"));
        let note: String = note.collect();
        format!("  {}{space}{symbol:>5} {}{note}", row.name, row.value)
    });
    std::iter::once(heading).chain(lines).collect()
}

/// The tables behind the answers.
pub(super) fn details(drop: &Drop) -> Vec<String> {
    let Ok(found) = &drop.posterior else {
        return Vec::new();
    };
    let words = translator();
    let budget = &found.budget;
    let tables = [
        (
            "analyze-details-budget-restitution",
            tables::budget(&budget.restitution, Unit::Number, words),
        ),
        (
            "analyze-details-budget-height",
            tables::budget(&budget.drop_height_m, Unit::Length, words),
        ),
        (
            "analyze-details-contraction",
            tables::prior_contraction(found, words),
        ),
        (
            "analyze-details-correlations",
            tables::correlations(found, words),
        ),
        (
            "analyze-details-impacts",
            tables::fitted_impacts(found, words),
        ),
    ];
    // One model is no comparison.
    let models =
        (found.models.len() > 1).then(|| ("analyze-details-models", tables::models(found, words)));
    let tables = models.into_iter().chain(tables);
    let mut blocks: Vec<String> = tables
        .map(|(heading, table)| format!("{}\n{table}", text(heading)))
        .collect();
    let priors = found
        .priors
        .iter()
        .map(|known| words.diagnostic(known))
        .collect::<Vec<_>>()
        .join("\n  ");
    blocks.push(format!("{}\n  {priors}", text("analyze-details-priors")));
    let sampling = [
        ("draws", Value::fixed(found.sampling.effective_draws, 0)),
        ("shape", Value::fixed(found.sampling.pareto_shape, 2)),
    ];
    blocks.push(text_with("analyze-details-sampling", &sampling));
    blocks
}
