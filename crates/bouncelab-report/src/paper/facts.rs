//! The numbers of the paper: as printed, and as computed.

use std::fmt;

use bouncelab::Result;
use bouncelab::drag::DragLaw;
use bouncelab::drop::{self, Stop};

use super::experiment::{
    self, CONSTANT, DROP_HEIGHT_M, GRAVITY_M_S2, REGRESSED, SIMULATED, dropped, model, regressed,
};

/// Facts that belong together.
#[derive(Clone, Debug)]
pub struct Chapter {
    /// What they are about.
    pub title: &'static str,
    /// The facts, in the order of the paper.
    pub facts: Vec<Fact>,
}

/// A number of the paper.
#[derive(Clone, Debug)]
pub struct Fact {
    /// What it is.
    pub quantity: &'static str,
    /// As the paper prints it; `None` if it does not say.
    pub printed: Option<&'static str>,
    /// As computed here.
    pub computed: f64,
    /// Unit of both.
    pub unit: &'static str,
    /// Decimals to show of the computed value.
    decimals: usize,
    kind: Kind,
    /// What to know about it; empty if nothing.
    pub note: &'static str,
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

/// What the comparison says.
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
    /// The paper does not say.
    NotInThePaper,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Agrees => "agrees",
            Self::AgreesWhenCorrected => "agrees when corrected",
            Self::AgreesRoughly => "agrees within reading",
            Self::Misprint => "misprint",
            Self::Differs => "differs",
            Self::NotInThePaper => "",
        })
    }
}

impl Fact {
    fn printed(
        quantity: &'static str,
        printed: &'static str,
        unit: &'static str,
        computed: f64,
        decimals: usize,
    ) -> Self {
        let printed = Some(printed);
        Self {
            quantity,
            printed,
            computed,
            unit,
            decimals,
            kind: Kind::Plain,
            note: "",
        }
    }

    fn new(quantity: &'static str, unit: &'static str, computed: f64, decimals: usize) -> Self {
        Self {
            printed: None,
            ..Self::printed(quantity, "", unit, computed, decimals)
        }
    }

    fn of(self, kind: Kind, note: &'static str) -> Self {
        Self { kind, note, ..self }
    }

    fn noted(self, note: &'static str) -> Self {
        Self { note, ..self }
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
            title: "The numbers of the paper",
            facts: forces_and_speeds()?,
        },
        Chapter {
            title: "Restitution, time and distance without drag",
            facts: series()?,
        },
        Chapter {
            title: "Equations as printed, and as they must be",
            facts: misprints()?,
        },
        Chapter {
            title: "What the paper did not say",
            facts: unsaid()?,
        },
        Chapter {
            title: "The drop that its straight line sees: e = 0.9529 with drag",
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
    let curve = model(DragLaw::CliftGraceWeber)?;
    let terminal = |model: &bouncelab::flight::FlightModel| {
        model.terminal_speed_m_s().unwrap_or(f64::INFINITY)
    };
    Ok(vec![
        Fact::printed("weight", "2.45", "10^-2 N", 100.0 * weight_n, 4),
        Fact::printed("buoyancy", "3.46", "10^-4 N", 1e4 * buoyancy_n, 2)
            .noted("it fixes the density of air, 1.2276 kg/m3"),
        Fact::printed(
            "buoyancy over weight",
            "1.41",
            "%",
            100.0 * buoyancy_n / weight_n,
            2,
        ),
        Fact::printed("first impact, no drag", "2.45", "m/s", plain_speed, 4),
        Fact::printed(
            "Reynolds number there",
            "6200",
            "",
            air.reynolds(&ball, plain_speed),
            0,
        )
        .noted("not turbulent as printed: below the drag crisis, a laminar boundary layer"),
        Fact::printed(
            "terminal speed, C_D = 0.4",
            "9.38",
            "m/s",
            terminal(&constant),
            4,
        )
        .of(Kind::ReadOff, "9.385 lies on the edge of rounding"),
        Fact::printed(
            "first impact, C_D = 0.4 (Eq. 15)",
            "2.405",
            "m/s",
            constant.fall(DROP_HEIGHT_M)?.impact_speed_m_s,
            4,
        ),
        Fact::printed(
            "drag over weight at 2.4 m/s, C_D(Re)",
            "6.4",
            "%",
            100.0 * curve.drag_over_weight(2.4)?,
            2,
        )
        .of(Kind::ReadOff, "the paper read its curve off a figure"),
        Fact::printed("terminal speed, C_D(Re)", "8.8", "m/s", terminal(&curve), 3)
            .of(Kind::ReadOff, "the same"),
    ])
}

fn series() -> Result<Vec<Fact>> {
    let root = |rebound_m: f64| (rebound_m / DROP_HEIGHT_M).sqrt();
    let first_s = model(DragLaw::None)?.fall(DROP_HEIGHT_M)?.time_s;
    let of_time = |time_s| drop::restitution_of_total_time(time_s, DROP_HEIGHT_M, GRAVITY_M_S2);
    Ok(vec![
        Fact::printed(
            "e by the rule book, steel, least",
            "0.878",
            "",
            root(0.235),
            4,
        ),
        Fact::printed(
            "e by the rule book, steel, most",
            "0.914",
            "",
            root(0.255),
            4,
        ),
        Fact::printed(
            "e by the rule book, table, least",
            "0.849",
            "",
            root(0.22),
            4,
        ),
        Fact::printed(
            "e by the rule book, table, most",
            "0.905",
            "",
            root(0.25),
            4,
        ),
        Fact::printed(
            "error of h0 = 26.7 cm",
            "12.3",
            "%",
            100.0 * (1.0 - 0.267 / 0.305),
            2,
        )
        .of(
            Kind::ReadOff,
            "from the rounded 26.7 cm; the flight times are not printed",
        ),
        Fact::printed(
            "e from 7.50 s after the first impact",
            "0.938",
            "",
            of_time(7.5 + first_s)?,
            4,
        )
        .of(Kind::Corrected, "if the 7.50 s count from the first impact"),
        Fact::new(
            "e from 7.50 s after the release (Eq. 7)",
            "",
            of_time(7.5)?,
            4,
        )
        .noted("Eq. 7 counts from the release"),
        Fact::printed(
            "path until rest at e = 0.94 (Eq. 8)",
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
            "h0 by Eq. 6 as printed: g 10^b/8",
            "26.7",
            "cm",
            12.5 * GRAVITY_M_S2 * power_of_b,
            1,
        )
        .of(Kind::Misprint, "10^b = 2 v0/g must be squared"),
        Fact::printed(
            "h0 by Eq. 6 corrected: g (10^b)^2/8",
            "26.7",
            "cm",
            12.5 * GRAVITY_M_S2 * power_of_b.powi(2),
            1,
        )
        .of(Kind::Corrected, ""),
        Fact::new("Eq. 13 at the first impact", "cm", 100.0 * fallen_13, 2)
            .noted("the drop height: its left side is the distance y, not v"),
        Fact::new("Eq. 14 at the first impact", "cm", 100.0 * fallen_14, 2).noted("the same"),
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
        Fact::new(
            "e = 0.935 with drag (Fig. 8) regresses to",
            "",
            counted_twice.restitution.value,
            4,
        )
        .noted("Fig. 8 takes the drag into account twice"),
        Fact::new(
            "drop height of that straight line",
            "cm",
            100.0 * counted_twice.drop_height_m.value,
            2,
        ),
        Fact::new("e that regresses to 0.9375 with drag", "", behind, 4).noted("over ten flights"),
        Fact::new(
            "drop height of its straight line",
            "cm",
            100.0 * seen.drop_height_m.value,
            2,
        ),
        Fact::new(
            "share of the gap to 30.5 cm that drag explains",
            "%",
            100.0 * explained,
            0,
        )
        .noted("the rest: restitution that falls with speed, or more flights in the fit"),
        Fact::new(
            "drop height, same e, twenty flights",
            "cm",
            100.0 * longer.drop_height_m.value,
            2,
        )
        .noted("the straight line depends on how many flights it is drawn through"),
        Fact::new(
            "gravity lost to buoyancy and added mass",
            "%",
            100.0 * (1.0 - effective),
            1,
        )
        .noted("buoyancy alone 1.4 %; every height shrinks with it"),
    ])
}

fn flights() -> Result<Vec<Fact>> {
    const FLIGHTS: [&str; 10] = ["T1", "T2", "T3", "T4", "T5", "T6", "T7", "T8", "T9", "T10"];
    const TOTALS: [(f64, &str, &str); 4] = [
        (
            0.935,
            "time until rest with drag, e = 0.935",
            "path until rest with drag, e = 0.935",
        ),
        (
            0.94,
            "time until rest with drag, e = 0.94",
            "path until rest with drag, e = 0.94",
        ),
        (
            0.945,
            "time until rest with drag, e = 0.945",
            "path until rest with drag, e = 0.945",
        ),
        (
            0.95,
            "time until rest with drag, e = 0.95",
            "path until rest with drag, e = 0.95",
        ),
    ];
    let behind = experiment::behind_the_regression(10)?;
    let history = dropped(&model(CONSTANT)?, behind, Stop::after(10))?;
    let mut facts = FLIGHTS
        .into_iter()
        .zip(1..)
        .map(|(name, number)| {
            Ok(Fact::new(
                name,
                "s",
                experiment::flight_time_s(&history, number)?,
                4,
            ))
        })
        .collect::<Result<Vec<Fact>>>()?;
    debug_assert!((regressed(behind, 10)?.restitution.value - REGRESSED).abs() < 1e-9);
    for (restitution, time, path) in TOTALS {
        let (time_s, path_m) = experiment::totals(restitution)?;
        facts.push(Fact::new(time, "s", time_s, 3));
        facts.push(Fact::new(path, "m", path_m, 3));
    }
    Ok(facts)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(quantity: &str) -> f64 {
        let chapters = chapters().unwrap();
        let mut facts = chapters.iter().flat_map(|chapter| &chapter.facts);
        facts
            .find(|fact| fact.quantity == quantity)
            .unwrap()
            .computed
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
                fact.quantity,
                fact.computed
            );
        }
    }

    /// Independently computed values: of a numerical recomputation of the paper.
    #[test]
    fn what_the_paper_did_not_say() {
        for (quantity, expected, tolerance) in [
            ("e = 0.935 with drag (Fig. 8) regresses to", 0.9221, 5e-5),
            ("e that regresses to 0.9375 with drag", 0.9529, 5e-5),
            ("share of the gap to 30.5 cm that drag explains", 46.0, 1.0),
            ("drop height, same e, twenty flights", 26.83, 5e-3),
            ("gravity lost to buoyancy and added mass", 2.1, 0.05),
            ("Eq. 13 at the first impact", 30.5, 1e-9),
            ("Eq. 14 at the first impact", 30.5, 1e-9),
            ("T1", 0.4605, 5e-5),
            ("T10", 0.2569, 5e-5),
            ("time until rest with drag, e = 0.935", 6.454, 5e-4),
            ("path until rest with drag, e = 0.935", 3.682, 5e-4),
            ("time until rest with drag, e = 0.95", 8.164, 5e-4),
            ("path until rest with drag, e = 0.95", 4.570, 5e-4),
        ] {
            let computed = value(quantity);
            assert!(
                (computed - expected).abs() <= tolerance,
                "{quantity}: {computed}"
            );
        }
    }
}
