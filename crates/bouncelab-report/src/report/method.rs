//! The method, with formulas and references.

use super::equation::Equation;
use super::page::{Block, Section};
use crate::messages::Translator;

/// The works that the method rests on; what some of them are cited for.
const REFERENCES: [(&str, Option<&str>); 6] = [
    (
        "M. Nagurka, Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment, International Journal \
         of Engineering Education 19 (2003).",
        None,
    ),
    (
        "R. Clift, J. R. Grace, M. E. Weber, Bubbles, Drops, and Particles, Academic Press (1978)",
        Some("report-reference-drag"),
    ),
    (
        "A. Picard, R. S. Davis, M. Gl\u{e4}ser, K. Fujii, Revised formula for the density of moist air \
         (CIPM-2007), Metrologia 45 (2008).",
        None,
    ),
    (
        "M. Montaine, M. Heckel, C. Kruelle, T. Schwager, T. P\u{f6}schel, Coefficient of restitution as \
         a fluctuating quantity, Physical Review E 84 (2011)",
        Some("report-reference-scatter"),
    ),
    (
        "A. Vehtari, D. Simpson, A. Gelman, Y. Yao, J. Gabry, Pareto smoothed importance sampling, \
         Journal of Machine Learning Research 25 (2024).",
        None,
    ),
    (
        "JCGM 100:2008, Guide to the expression of uncertainty in measurement.",
        None,
    ),
];

/// The method in a few sentences.
pub fn method_in_short(translator: &Translator) -> Section {
    let told = Block::text(translator.text("report-method-short"));
    Section::new(translator.text("report-method"), vec![told])
}

/// The method with its formulas and references: the same for every page.
pub fn method(translator: &Translator) -> Section {
    let steps = [
        ("report-method-flight", Equation::PlainHeight),
        ("report-method-line", Equation::StraightLine),
        ("report-method-motion", Equation::Motion),
        ("report-method-restitution", Equation::Restitution),
        ("report-method-noise", Equation::Noise),
        ("report-method-posterior", Equation::Posterior),
    ];
    let mut blocks: Vec<Block> = steps
        .into_iter()
        .flat_map(|(id, equation)| [Block::text(translator.text(id)), Block::Equation(equation)])
        .collect();
    let references = REFERENCES.map(|(work, cited_for)| match cited_for {
        Some(id) => translator.text_with(id, &[("work", work.into())]),
        None => work.to_owned(),
    });
    blocks.push(Block::text(translator.text("report-references")));
    blocks.push(Block::List(references.into()));
    Section::new(translator.text("report-formulas"), blocks)
}
