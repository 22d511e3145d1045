//! The numbers of the paper: as printed, and as computed.

use bouncelab::Result;
use bouncelab::drag::DragLaw;
use bouncelab::drop::{self, Stop};

use crate::messages::Translator;

use super::experiment::{
    self, CONSTANT, DROP_HEIGHT_M, GRAVITY_M_S2, REGRESSED, SIMULATED, dropped, model, regressed,
};

/// Facts that belong together.
#[derive(Clone, Debug)]
pub struct Chapter {
    /// What they are about, as a code.
    code: &'static str,
    /// The facts, in the order of the paper.
    pub facts: Vec<Fact>,
}

/// A number of the paper.
#[derive(Clone, Debug)]
pub struct Fact {
    /// What it is, as a code.
    code: &'static str,
    /// Of which flight or restitution, where there are several of its kind.
    of: Option<f64>,
    /// As the paper prints it; `None` if it does not state it.
    pub printed: Option<&'static str>,
    /// As computed here.
    pub computed: f64,
    /// Unit of both.
    pub unit: &'static str,
    /// Decimals to show of the computed value.
    decimals: usize,
    kind: Kind,
}

/// On what ground a printed number is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// It must come out as printed.
    Plain,
    /// It comes out with a corrected equation or reading.
    Corrected,
    /// It was read off a figure: two digits are fair.
    ReadOff,
    /// What a misprint would give.
    Misprint,
}

/// The result of the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The computed value rounds to the printed one.
    Agrees,
    /// It does with a corrected equation or reading.
    AgreesWhenCorrected,
    /// It does as well as one can read a figure.
    AgreesRoughly,
    /// The printed equation gives something else.
    Misprint,
    /// It does not.
    Differs,
    /// The paper does not state it.
    NotInThePaper,
}

impl Verdict {
    /// Its code, as in documents; `None` if there is nothing to compare.
    pub const fn code(self) -> Option<&'static str> {
        match self {
            Self::Agrees => Some("agrees"),
            Self::AgreesWhenCorrected => Some("agrees-when-corrected"),
            Self::AgreesRoughly => Some("agrees-within-reading"),
            Self::Misprint => Some("misprint"),
            Self::Differs => Some("differs"),
            Self::NotInThePaper => None,
        }
    }

    /// As a text; empty if there is nothing to compare.
    pub fn text(self, translator: &Translator) -> String {
        self.code().map_or_else(String::new, |code| {
            translator.text(&format!("paper-verdict-{code}"))
        })
    }
}

impl Chapter {
    /// What its facts are about.
    pub fn title(&self, translator: &Translator) -> String {
        translator.text(&format!("paper-chapter-{}", self.code))
    }
}

impl Fact {
    fn printed(
        code: &'static str,
        printed: &'static str,
        unit: &'static str,
        computed: f64,
        decimals: usize,
    ) -> Self {
        let printed = Some(printed);
        Self {
            code,
            of: None,
            printed,
            computed,
            unit,
            decimals,
            kind: Kind::Plain,
        }
    }

    fn new(code: &'static str, unit: &'static str, computed: f64, decimals: usize) -> Self {
        Self {
            printed: None,
            ..Self::printed(code, "", unit, computed, decimals)
        }
    }

    fn of(self, kind: Kind) -> Self {
        Self { kind, ..self }
    }

    fn numbered(self, of: f64) -> Self {
        Self {
            of: Some(of),
            ..self
        }
    }

    /// What it is, as a code that no other fact has.
    pub fn code(&self) -> String {
        match self.of {
            Some(of) => format!("{}-{of}", self.code),
            None => self.code.to_owned(),
        }
    }

    /// What it is, as a text.
    pub fn quantity(&self, translator: &Translator) -> String {
        let of = self.of.map(|of| ("of", of.into()));
        translator.text_with(&format!("paper-{}", self.code), of.as_slice())
    }

    /// What to know about it.
    pub fn note(&self, translator: &Translator) -> Option<String> {
        let id = format!("paper-{}-note", self.code);
        translator.has(&id).then(|| translator.text(&id))
    }

    /// The computed value in as many decimals as are of use.
    pub fn shown(&self) -> String {
        format!("{:.*}", self.decimals, self.computed)
    }

    /// Whether the computed value rounds to the printed one.
    pub fn verdict(&self) -> Verdict {
        let Some(printed) = self.printed else {
            return Verdict::NotInThePaper;
        };
        if self.kind == Kind::Misprint {
            return Verdict::Misprint;
        }
        let value: f64 = printed.parse().unwrap_or(f64::NAN);
        let decimals = printed
            .split_once('.')
            .map_or(0, |(_, decimals)| decimals.len());
        // Trailing zeros of a whole number are not digits: 6200 is 6197.
        let zeros = printed.len() - printed.trim_end_matches('0').len();
        let last_place = if decimals == 0 {
            10_f64.powi(i32::try_from(zeros).unwrap_or(0))
        } else {
            10_f64.powi(-i32::try_from(decimals).unwrap_or(0))
        };
        let off = (self.computed - value).abs();
        let rounds = off <= 0.5 * last_place * (1.0 + 1e-9);
        match self.kind {
            Kind::Plain if rounds => Verdict::Agrees,
            Kind::Corrected if rounds => Verdict::AgreesWhenCorrected,
            Kind::ReadOff if off <= 0.02 * value => Verdict::AgreesRoughly,
            _ => Verdict::Differs,
        }
    }
}

/// All of them, in the order of the paper.
///
/// # Errors
///
/// Those of the physics; none with the numbers of the paper.
pub fn chapters() -> Result<Vec<Chapter>> {
    Ok(vec![
        Chapter {
            code: "numbers",
            facts: forces_and_speeds()?,
        },
        Chapter {
            code: "series",
            facts: series()?,
        },
        Chapter {
            code: "equations",
            facts: misprints()?,
        },
        Chapter {
            code: "beyond",
            facts: unsaid()?,
        },
        Chapter {
            code: "flights",
            facts: flights()?,
        },
    ])
}

fn forces_and_speeds() -> Result<Vec<Fact>> {
    let (ball, air) = (experiment::ball()?, experiment::air()?);
    let weight_n = ball.weight_n(GRAVITY_M_S2);
    let buoyancy_n = ball.buoyancy_n(&air, GRAVITY_M_S2);
    let plain_speed = model(DragLaw::None)?.fall(DROP_HEIGHT_M)?.impact_speed_m_s;
    let constant = model(CONSTANT)?;
    let curve = model(DragLaw::Standard)?;
    let terminal = |model: &bouncelab::flight::FlightModel| {
        model.terminal_speed_m_s().unwrap_or(f64::INFINITY)
    };
    Ok(vec![
        Fact::printed("weight", "2.45", "10^-2 N", 100.0 * weight_n, 4),
        Fact::printed("buoyancy", "3.46", "10^-4 N", 1e4 * buoyancy_n, 2),
        Fact::printed(
            "buoyancy-over-weight",
            "1.41",
            "%",
            100.0 * buoyancy_n / weight_n,
            2,
        ),
        Fact::printed("first-impact", "2.45", "m/s", plain_speed, 4),
        Fact::printed(
            "reynolds-number",
            "6200",
            "",
            air.reynolds(&ball, plain_speed),
            0,
        ),
        Fact::printed("terminal-speed", "9.38", "m/s", terminal(&constant), 4).of(Kind::ReadOff),
        Fact::printed(
            "first-impact-with-drag",
            "2.405",
            "m/s",
            constant.fall(DROP_HEIGHT_M)?.impact_speed_m_s,
            4,
        ),
        Fact::printed(
            "drag-over-weight",
            "6.4",
            "%",
            100.0 * curve.drag_over_weight(2.4)?,
            2,
        )
        .of(Kind::ReadOff),
        Fact::printed(
            "terminal-speed-of-sphere",
            "8.8",
            "m/s",
            terminal(&curve),
            3,
        )
        .of(Kind::ReadOff),
    ])
}

fn series() -> Result<Vec<Fact>> {
    let root = |rebound_m: f64| (rebound_m / DROP_HEIGHT_M).sqrt();
    let first_s = model(DragLaw::None)?.fall(DROP_HEIGHT_M)?.time_s;
    let of_time = |time_s| drop::restitution_of_total_time(time_s, DROP_HEIGHT_M, GRAVITY_M_S2);
    Ok(vec![
        Fact::printed("rule-steel-least", "0.878", "", root(0.235), 4),
        Fact::printed("rule-steel-most", "0.914", "", root(0.255), 4),
        Fact::printed("rule-table-least", "0.849", "", root(0.22), 4),
        Fact::printed("rule-table-most", "0.905", "", root(0.25), 4),
        Fact::printed(
            "height-error",
            "12.3",
            "%",
            100.0 * (1.0 - 0.267 / 0.305),
            2,
        )
        .of(Kind::ReadOff),
        Fact::printed(
            "restitution-of-time",
            "0.938",
            "",
            of_time(7.5 + first_s)?,
            4,
        )
        .of(Kind::Corrected),
        Fact::new("restitution-of-total-time", "", of_time(7.5)?, 4),
        Fact::printed(
            "total-path",
            "4.94",
            "m",
            drop::total_path_m(0.94, DROP_HEIGHT_M)?,
            4,
        ),
    ])
}

fn misprints() -> Result<Vec<Fact>> {
    // 10^b = 2 v0/g of a drop from the 26.7 cm that the paper finds.
    let power_of_b = (8.0 * 0.267 / GRAVITY_M_S2).sqrt();
    let constant = model(CONSTANT)?;
    let terminal = constant.terminal_speed_m_s().unwrap_or(f64::INFINITY);
    let fall = constant.fall(DROP_HEIGHT_M)?;
    let share = (fall.impact_speed_m_s / terminal).powi(2);
    let fallen_13 = -terminal * terminal / (2.0 * GRAVITY_M_S2) * (-share).ln_1p();
    let fallen_14 =
        terminal * terminal / GRAVITY_M_S2 * (GRAVITY_M_S2 * fall.time_s / terminal).cosh().ln();
    Ok(vec![
        Fact::printed(
            "equation-6-printed",
            "26.7",
            "cm",
            12.5 * GRAVITY_M_S2 * power_of_b,
            1,
        )
        .of(Kind::Misprint),
        Fact::printed(
            "equation-6",
            "26.7",
            "cm",
            12.5 * GRAVITY_M_S2 * power_of_b.powi(2),
            1,
        )
        .of(Kind::Corrected),
        Fact::new("equation-13", "cm", 100.0 * fallen_13, 2),
        Fact::new("equation-14", "cm", 100.0 * fallen_14, 2),
    ])
}

fn unsaid() -> Result<Vec<Fact>> {
    let counted_twice = regressed(SIMULATED, 10)?;
    let behind = experiment::behind_the_regression(10)?;
    let seen = regressed(behind, 10)?;
    let longer = regressed(experiment::behind_the_regression(20)?, 20)?;
    let explained = (DROP_HEIGHT_M - seen.drop_height_m.value) / (DROP_HEIGHT_M - 0.267);
    let effective = experiment::model_with_buoyancy(CONSTANT)?.gravity_m_s2() / GRAVITY_M_S2;
    Ok(vec![
        Fact::new("drag-twice", "", counted_twice.restitution.value, 4),
        Fact::new(
            "drag-twice-height",
            "cm",
            100.0 * counted_twice.drop_height_m.value,
            2,
        ),
        Fact::new("behind-line", "", behind, 4),
        Fact::new(
            "behind-line-height",
            "cm",
            100.0 * seen.drop_height_m.value,
            2,
        ),
        Fact::new("explained", "%", 100.0 * explained, 0),
        Fact::new(
            "twenty-flights-height",
            "cm",
            100.0 * longer.drop_height_m.value,
            2,
        ),
        Fact::new("lost-gravity", "%", 100.0 * (1.0 - effective), 1),
    ])
}

fn flights() -> Result<Vec<Fact>> {
    let behind = experiment::behind_the_regression(10)?;
    let history = dropped(&model(CONSTANT)?, behind, Stop::after(10))?;
    let mut facts = Vec::new();
    for (number, bounce) in (1..).zip(history.bounces()) {
        let time_s = bounce.flight.time_s();
        facts.push(Fact::new("flight-time", "s", time_s, 4).numbered(f64::from(number)));
    }
    debug_assert!((regressed(behind, 10)?.restitution.value - REGRESSED).abs() < 1e-9);
    for restitution in [0.935, 0.94, 0.945, 0.95] {
        let (time_s, path_m) = experiment::totals(restitution)?;
        facts.push(Fact::new("time-until-rest", "s", time_s, 3).numbered(restitution));
        facts.push(Fact::new("path-until-rest", "m", path_m, 3).numbered(restitution));
    }
    Ok(facts)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(code: &str) -> f64 {
        let chapters = chapters().unwrap();
        let mut facts = chapters.iter().flat_map(|chapter| &chapter.facts);
        facts.find(|fact| fact.code() == code).unwrap().computed
    }

    /// Every printed number comes out, but for the one misprint.
    #[test]
    fn the_paper_agrees() {
        for fact in chapters()
            .unwrap()
            .iter()
            .flat_map(|chapter| &chapter.facts)
        {
            assert_ne!(
                fact.verdict(),
                Verdict::Differs,
                "{}: {}",
                fact.code(),
                fact.computed
            );
        }
    }

    #[test]
    fn every_fact_has_a_name() {
        let translator = Translator::english();
        for chapter in chapters().unwrap() {
            let facts = chapter.facts.iter().map(|fact| fact.quantity(&translator));
            for name in facts.chain([chapter.title(&translator)]) {
                assert!(!name.starts_with("paper-"), "{name}");
            }
        }
    }

    /// Independently computed values: of a numerical recomputation of the paper.
    #[test]
    fn what_the_paper_did_not_say() {
        for (code, expected, tolerance) in [
            ("drag-twice", 0.9221, 5e-5),
            ("behind-line", 0.9529, 5e-5),
            ("explained", 46.0, 1.0),
            ("twenty-flights-height", 26.83, 5e-3),
            ("lost-gravity", 2.1, 0.05),
            ("equation-13", 30.5, 1e-9),
            ("equation-14", 30.5, 1e-9),
            ("flight-time-1", 0.4605, 5e-5),
            ("flight-time-10", 0.2569, 5e-5),
            ("time-until-rest-0.935", 6.454, 5e-4),
            ("path-until-rest-0.935", 3.682, 5e-4),
            ("time-until-rest-0.95", 8.164, 5e-4),
            ("path-until-rest-0.95", 4.570, 5e-4),
        ] {
            let computed = value(code);
            assert!(
                (computed - expected).abs() <= tolerance,
                "{code}: {computed}"
            );
        }
    }
}
