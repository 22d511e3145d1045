//! What a person reads first of a drop: the answer with its speed and ball, or the reason that the inference gives no answer.

use std::fmt;

use bouncelab::analysis::Drop;
use bouncelab::diagnostic::{Argument, Code, Severity};
use bouncelab::inference::Posterior;
use bouncelab::restitution::PerImpact;
use bouncelab::settings::Setup;
use bouncelab::{Diagnostic, Error, Estimate};
use serde::Serialize;

use super::impact_speed;
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};

/// The answer of a drop in sentences, of which each is true as it stands.
///
/// ```
/// use bouncelab::analyze_times;
/// use bouncelab::settings::Settings;
/// use bouncelab_report::messages::Translator;
/// use bouncelab_report::quantities::Headline;
///
/// let setup = Settings::default().resolve()?;
/// let result = analyze_times(&[0.0, 0.4605], &setup.options);
/// let headline = Headline::of(&result.drops[0], &setup, &Translator::english());
/// assert!(!headline.is_answer);
/// assert!(headline.sentences[0].to_string().contains("too few impacts"));
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Headline {
    /// Whether there is an answer; otherwise the first sentence is the reason and what to do.
    pub is_answer: bool,
    /// The answer: restitution and energy kept with their impact speed, drop height, ball.
    pub sentences: Vec<Sentence>,
    /// What the log-linear fit gives, which neglects the air.
    pub without_air: Option<Sentence>,
}

/// A sentence in parts: text and values in turn, so that values can stand out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Sentence(Vec<String>);

impl fmt::Display for Sentence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|part| f.write_str(part))
    }
}

impl Headline {
    /// The headline of a drop that was analysed with these settings.
    pub fn of(drop: &Drop, setup: &Setup, translator: &Translator) -> Self {
        let writer = Writer { setup, translator };
        let asks_inference = setup.options.inference.is_some();
        let (mut sentences, is_answer) = match (&drop.posterior, &drop.per_impact) {
            (Ok(posterior), _) => (writer.inferred(posterior), true),
            (Err(_), Ok(per_impact)) if !asks_inference => match writer.median(per_impact) {
                Some(median) => (vec![median], true),
                None => (vec![writer.too_few(per_impact)], false),
            },
            (Err(_), Err(reason)) if !asks_inference => (vec![writer.none(reason)], false),
            (Err(reason), _) => (vec![writer.none(reason)], false),
        };
        if is_answer {
            sentences.push(writer.ball());
        }
        Self {
            is_answer,
            sentences,
            without_air: writer.without_air(drop),
        }
    }
}

/// The notes on a drop; the reason why it has no posterior is in its headline.
pub fn notes(drop: &Drop) -> impl Iterator<Item = &Diagnostic> {
    let diagnostics = drop.diagnostics.iter();
    diagnostics.filter(|it| it.severity != Severity::Error)
}

/// For whom a headline is written, and with which settings the drop was analysed.
struct Writer<'a> {
    setup: &'a Setup,
    translator: &'a Translator,
}

impl Writer<'_> {
    /// A message with quantities, which stand out.
    fn sentence(&self, id: &str, values: &[(&str, Quantity)]) -> Sentence {
        /// A control character, which no message and no value has.
        const MARK: char = '\u{1}';
        let marked: Vec<(&str, String)> = values
            .iter()
            .map(|(name, value)| {
                // No line ends within a value.
                let value = value.text(self.translator).replace(' ', "\u{a0}");
                (*name, format!("{MARK}{value}{MARK}"))
            })
            .collect();
        let arguments: Vec<_> = marked
            .iter()
            .map(|(name, value)| (*name, value.as_str().into()))
            .collect();
        let text = self.translator.text_with(id, &arguments);
        Sentence(text.split(MARK).map(str::to_owned).collect())
    }

    /// The posterior in sentences.
    fn inferred(&self, posterior: &Posterior) -> Vec<Sentence> {
        let share = |estimate: &Estimate| Quantity::of(estimate, Unit::Percent);
        let [slowest_m_s, fastest_m_s] = posterior.fitted_speeds_m_s;
        let kept = [
            ("share", share(&posterior.restitution)),
            ("energy", share(&posterior.energy_kept)),
            ("speed", impact_speed(posterior.at_speed_m_s)),
            ("slowest", impact_speed(slowest_m_s)),
            ("fastest", impact_speed(fastest_m_s)),
        ];
        let inference = &self.setup.options.inference;
        let asked_m_s = inference.as_ref().and_then(|it| it.at_speed_m_s);
        let is_constant = is_constant(posterior);
        let id = match asked_m_s {
            _ if is_constant => "answer-kept-always",
            Some(_) => "answer-kept-asked",
            None => "answer-kept-first",
        };
        let round = posterior
            .round_speed_m_s
            .zip(posterior.round_speed_restitution);
        let round = round.filter(|&(speed_m_s, _)| !is_constant && Some(speed_m_s) != asked_m_s);
        let round = round.map(|(speed_m_s, restitution)| {
            let values = [
                ("speed", impact_speed(speed_m_s)),
                ("share", share(&restitution)),
            ];
            self.sentence("answer-round", &values)
        });
        let height = Quantity::of(&posterior.drop_height_m, Unit::Length);
        let height = self.sentence(Self::height_id(posterior), &[("height", height)]);
        [Some(self.sentence(id, &kept)), round, Some(height)]
            .into_iter()
            .flatten()
            .collect()
    }

    /// The message of the drop height, by what it follows from.
    fn height_id(posterior: &Posterior) -> &'static str {
        if posterior.height_was_stated() {
            "answer-height-stated"
        } else if posterior.missed_first_impacts.is_some() {
            "answer-fell"
        } else {
            "answer-fell-first"
        }
    }

    /// The median of the impacts, which is the answer where no inference was asked for.
    fn median(&self, per_impact: &PerImpact) -> Option<Sentence> {
        let values = [
            (
                "share",
                Quantity::of(&per_impact.restitution?, Unit::Percent),
            ),
            ("slowest", impact_speed(per_impact.slowest_m_s?)),
            ("fastest", impact_speed(per_impact.fastest_m_s?)),
        ];
        Some(self.sentence("answer-median", &values))
    }

    fn too_few(&self, per_impact: &PerImpact) -> Sentence {
        let count = [("count", per_impact.impacts.len().into())];
        let text = self.translator.text_with("answer-median-too-few", &count);
        Sentence(vec![text])
    }

    /// Why there is no answer, and what to do.
    fn none(&self, reason: &Error) -> Sentence {
        let reason = self.translator.diagnostic(&reason.diagnostic());
        let reason = [("reason", reason.into())];
        Sentence(vec![self.translator.text_with("answer-none", &reason)])
    }

    /// The ball for which the answer holds.
    fn ball(&self) -> Sentence {
        let assumed = |code| self.setup.assumptions.iter().find(|it| it.code == code);
        if let Some(open) = assumed(Code::BallNotStated) {
            return Sentence(vec![self.translator.diagnostic(open)]);
        }
        let usual = assumed(Code::AssumedBall).and_then(|it| it.arguments.get("ball"));
        let (id, ball) = match usual {
            Some(Argument::Text(name)) => {
                ("answer-ball-assumed", self.translator.named("ball", name))
            }
            _ => ("answer-ball", self.translator.ball(&self.setup.ball)),
        };
        let ball = [("ball", ball.into())];
        Sentence(vec![self.translator.text_with(id, &ball)])
    }

    /// The log-linear fit beside the impacts corrected for drag, which have the same speeds, and the drop height.
    fn without_air(&self, drop: &Drop) -> Option<Sentence> {
        let fit = drop.log_linear_fit.as_ref().ok()?;
        let share = |estimate: &Estimate| Quantity::of(estimate, Unit::Percent);
        let mut values = vec![
            ("share", share(&fit.restitution)),
            ("height", Quantity::of(&fit.drop_height_m, Unit::Length)),
        ];
        let height = drop.posterior.as_ref().ok().map(|it| it.drop_height_m);
        let Some((corrected, height)) = drop.per_impact_restitution().zip(height) else {
            return Some(self.sentence("answer-line", &values));
        };
        let agrees = agree(&fit.restitution, &corrected) && agree(&fit.drop_height_m, &height);
        // Without its uncertainty, which is that of the times alone: the correction takes the drag as known.
        let corrected = Quantity::rounded(corrected.value, 4, Unit::Percent);
        values.push(("corrected", corrected));
        let id = if agrees {
            "answer-line-agrees"
        } else {
            "answer-line-differs"
        };
        Some(self.sentence(id, &values))
    }
}

/// Whether restitution is the same at all speeds of the drop: within the standard uncertainty that is stated with it.
fn is_constant(posterior: &Posterior) -> bool {
    let Estimate { value, sd, .. } = posterior.restitution;
    let mut band = posterior.band.iter();
    band.all(|point| (point.restitution.value - value).abs() <= sd)
}

/// Whether a value differs from an estimate by less than the standard uncertainty of the estimate.
fn agree(value: &Estimate, estimate: &Estimate) -> bool {
    (value.value - estimate.value).abs() <= estimate.sd
}
