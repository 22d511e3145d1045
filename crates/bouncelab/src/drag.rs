//! Drag laws: C<sub>D</sub> against the Reynolds number.
//!
//! All named laws are for a smooth sphere in a steady stream. Those that reach Reynolds numbers from
//! 1e3 to 1e4, where small balls bounce, scatter there by about 3 % (standard deviation): that is how
//! well drag is known before one measures. Felt, dimples, holes and seams change it further.
//!
//! ```
//! use bouncelab::drag::DragLaw;
//!
//! let law: DragLaw = "clift-grace-weber".parse()?;
//! assert_eq!(format!("{:.4}", law.coefficient(6200.0)?), "0.3879");
//! # Ok::<(), bouncelab::Error>(())
//! ```

use std::fmt;
use std::str::FromStr;

use crate::error::{Error, Quantity, Result, within};

/// How the drag coefficient C<sub>D</sub> of a ball depends on its Reynolds number.
///
/// Above the upper end of its range ([`DragLaw::max_reynolds`]) a law is an error, never an
/// extrapolation. There is no lower end: every named law tends to Stokes' 24/Re, so the coefficient
/// goes to infinity as the speed goes to zero while the drag *force* goes to zero.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum DragLaw {
    /// No drag, as in the paper's first model.
    None,
    /// The same coefficient at all speeds, as in the paper's second model; finite, not negative.
    Constant(f64),
    /// Stokes 1851: 24/Re, creeping flow, Re < 0.3.
    Stokes,
    /// Schiller & Naumann 1933, Re < 800.
    SchillerNaumann,
    /// Clift & Gauvin 1971, Re < 3e5.
    CliftGauvin,
    /// Turton & Levenspiel 1986, Re < 2.6e5.
    TurtonLevenspiel,
    /// Haider & Levenspiel 1989, Re < 2e5.
    HaiderLevenspiel,
    /// Brown & Lawler 2003, Re < 2e5.
    BrownLawler,
    /// Cheng 2009, Re < 2e5.
    Cheng,
    /// Almedeij 2008, through the drag crisis, Re < 1e6.
    Almedeij,
    /// Morrison 2016, through the drag crisis, Re < 1e6.
    Morrison,
    /// Clift, Grace & Weber 1978: the standard drag curve in pieces, no upper end. The published
    /// pieces do not quite meet: by 0.8 % at Re = 20, less than 0.1 % at the other joints up to
    /// 4.4e4, 0.6 % at 3.38e5 and, deep in the drag crisis, 21 % at 4e5.
    CliftGraceWeber,
}

impl DragLaw {
    /// The laws for a smooth sphere, in the order in which they were published, the standard drag
    /// curve last.
    pub const NAMED: [Self; 10] = [
        Self::Stokes,
        Self::SchillerNaumann,
        Self::CliftGauvin,
        Self::TurtonLevenspiel,
        Self::HaiderLevenspiel,
        Self::BrownLawler,
        Self::Almedeij,
        Self::Cheng,
        Self::Morrison,
        Self::CliftGraceWeber,
    ];

    /// The name by which it is looked up, as in "clift-grace-weber".
    ///
    /// ```
    /// use bouncelab::drag::DragLaw;
    ///
    /// let law: DragLaw = DragLaw::Morrison.name().parse()?;
    /// assert_eq!(law, DragLaw::Morrison);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub const fn name(&self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Constant(_) => "constant",
            Self::Stokes => "stokes",
            Self::SchillerNaumann => "schiller-naumann",
            Self::CliftGauvin => "clift-gauvin",
            Self::TurtonLevenspiel => "turton-levenspiel",
            Self::HaiderLevenspiel => "haider-levenspiel",
            Self::BrownLawler => "brown-lawler",
            Self::Cheng => "cheng",
            Self::Almedeij => "almedeij",
            Self::Morrison => "morrison",
            Self::CliftGraceWeber => "clift-grace-weber",
        }
    }

    /// The upper end of its range of Reynolds numbers; infinite if it has none.
    ///
    /// ```
    /// use bouncelab::drag::DragLaw;
    ///
    /// let slowest_to_end = DragLaw::NAMED.into_iter().min_by(|a, b| a.max_reynolds().total_cmp(&b.max_reynolds()));
    /// assert_eq!(slowest_to_end, Some(DragLaw::Stokes));
    /// ```
    pub const fn max_reynolds(&self) -> f64 {
        match self {
            Self::Stokes => 0.3,
            Self::SchillerNaumann => 800.0,
            Self::TurtonLevenspiel => 2.6e5,
            Self::HaiderLevenspiel | Self::BrownLawler | Self::Cheng => 2e5,
            Self::CliftGauvin => 3e5,
            Self::Almedeij | Self::Morrison => 1e6,
            Self::None | Self::Constant(_) | Self::CliftGraceWeber => f64::INFINITY,
        }
    }

    /// The drag coefficient at a Reynolds number.
    ///
    /// At Re = 0 the named laws give infinity (and a drag force of zero).
    ///
    /// # Errors
    /// [`Error::ReynoldsTooHigh`] above [`DragLaw::max_reynolds`], [`Error::OutOfRange`] for a
    /// negative number, NaN, or a constant that is negative or not finite.
    ///
    /// ```
    /// use bouncelab::drag::DragLaw;
    ///
    /// assert_eq!(DragLaw::Stokes.coefficient(0.1)?, 240.0);
    /// assert!(DragLaw::Stokes.coefficient(10.0).is_err()); // beyond its range
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn coefficient(&self, reynolds: f64) -> Result<f64> {
        self.check()?;
        within(Quantity::Reynolds, reynolds, 0.0..)?;
        self.check_reynolds(reynolds)?;
        Ok(match *self {
            Self::None => 0.0,
            Self::Constant(coefficient) => coefficient,
            _ => 24.0 / reynolds * self.over_stokes(reynolds),
        })
    }

    /// Refuses a constant that is no coefficient.
    pub(crate) fn check(&self) -> Result<()> {
        match *self {
            Self::Constant(c) => within(Quantity::DragCoefficient, c, 0.0..).map(drop),
            _ => Ok(()),
        }
    }

    /// Refuses a Reynolds number above the range of the law.
    pub(crate) fn check_reynolds(&self, reynolds: f64) -> Result<()> {
        let max_reynolds = self.max_reynolds();
        if reynolds > max_reynolds {
            return Err(Error::ReynoldsTooHigh {
                law: self.name(),
                reynolds,
                max_reynolds,
            });
        }
        Ok(())
    }

    /// Drag over Stokes drag, C<sub>D</sub> Re/24: finite everywhere, 1 at Re = 0 for a named law.
    ///
    /// Written without the 24/Re of the published forms so that it holds down to Re = 0. Does not
    /// check the range.
    pub(crate) fn over_stokes(&self, re: f64) -> f64 {
        match *self {
            Self::None => 0.0,
            Self::Constant(coefficient) => coefficient * re / 24.0,
            Self::Stokes => 1.0,
            Self::SchillerNaumann => schiller_naumann(re),
            Self::CliftGauvin => {
                schiller_naumann(re) + re / 24.0 * 0.42 / (1.0 + 42_500.0 * re.powf(-1.16))
            }
            Self::TurtonLevenspiel => {
                1.0 + 0.173 * re.powf(0.657) + re / 24.0 * 0.413 / (1.0 + 16_300.0 * re.powf(-1.09))
            }
            Self::HaiderLevenspiel => {
                1.0 + 0.1806 * re.powf(0.6459) + re / 24.0 * 0.4251 * re / (re + 6_880.95)
            }
            Self::BrownLawler => {
                1.0 + 0.150 * re.powf(0.681) + re / 24.0 * 0.407 * re / (re + 8_710.0)
            }
            Self::Cheng => {
                (1.0 + 0.27 * re).powf(0.43) - re / 24.0 * 0.47 * (-0.04 * re.powf(0.38)).exp_m1()
            }
            Self::Almedeij => almedeij(re),
            Self::Morrison => morrison(re),
            Self::CliftGraceWeber => clift_grace_weber(re),
        }
    }

    /// Reynolds numbers at which the formula changes, ascending: where a quadrature must split.
    pub(crate) const fn joints(&self) -> &'static [f64] {
        match self {
            Self::CliftGraceWeber => &[0.01, 20.0, 260.0, 1500.0, 1.2e4, 4.4e4, 3.38e5, 4e5, 1e6],
            _ => &[],
        }
    }
}

fn schiller_naumann(re: f64) -> f64 {
    1.0 + 0.15 * re.powf(0.687)
}

/// Every published term is multiplied by Re/24 before it is raised to the tenth power, so that
/// nothing overflows at small Re except terms whose reciprocal is then rightly zero.
fn almedeij(re: f64) -> f64 {
    let term = |factor: f64, exponent: f64| (factor / 24.0 * re.powf(exponent + 1.0)).powi(10);
    let laminar = 1.0 + term(21.0, -0.67) + term(4.0, -0.33) + term(0.4, 0.0);
    let newton = 1.0 / (term(0.148, 0.11).recip() + term(0.5, 0.0).recip());
    let crisis = term(1.57e8, -1.625);
    let turbulent = 1.0 / (term(6e-17, 2.63).recip() + term(0.2, 0.0).recip());
    (1.0 / ((laminar + newton).recip() + crisis.recip()) + turbulent).powf(0.1)
}

/// The published fraction y^-7.94/(1 + y^-8) is written y^0.06/(1 + y^8), which holds at y = 0.
fn morrison(re: f64) -> f64 {
    let crisis = re / 2.63e5;
    let coefficient_less_stokes = 2.6 * (re / 5.0) / (1.0 + (re / 5.0).powf(1.52))
        + 0.411 * crisis.powf(0.06) / (1.0 + crisis.powi(8))
        + 0.25 * (re / 1e6) / (1.0 + re / 1e6);
    1.0 + re / 24.0 * coefficient_less_stokes
}

/// Clift, Grace & Weber 1978, "Bubbles, Drops, and Particles", table 5.2. Some reprints have 3/16
/// for the 9/2 (here 9/48 after division by 24) and 0.19 w for the 0.1 w: misprints.
fn clift_grace_weber(re: f64) -> f64 {
    if re < 0.01 {
        return 1.0 + 9.0 / 48.0 * re;
    }
    let w = re.log10();
    if re < 20.0 {
        return 1.0 + 0.1315 * re.powf(0.82 - 0.05 * w);
    }
    if re < 260.0 {
        return 1.0 + 0.1935 * re.powf(0.6305);
    }
    let coefficient = if re < 1500.0 {
        10_f64.powf(1.6435 - 1.1242 * w + 0.1558 * w * w)
    } else if re < 1.2e4 {
        10_f64.powf(-2.4571 + 2.5558 * w - 0.9295 * w * w + 0.1049 * w * w * w)
    } else if re < 4.4e4 {
        10_f64.powf(-1.9181 + 0.6370 * w - 0.0636 * w * w)
    } else if re < 3.38e5 {
        10_f64.powf(-4.3390 + 1.5809 * w - 0.1546 * w * w)
    } else if re < 4e5 {
        29.78 - 5.3 * w
    } else if re < 1e6 {
        0.1 * w - 0.49
    } else {
        0.19 - 8e4 / re
    };
    re / 24.0 * coefficient
}

#[cfg(feature = "serde")]
impl serde::Serialize for DragLaw {
    fn serialize<S: serde::Serializer>(
        &self,
        serializer: S,
    ) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl fmt::Display for DragLaw {
    /// What [`FromStr`] reads: the name, and the coefficient as in "constant:0.4".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant(coefficient) => write!(f, "constant:{coefficient}"),
            _ => f.write_str(self.name()),
        }
    }
}

impl FromStr for DragLaw {
    type Err = Error;

    /// Reads "none", "constant:0.4" or one of the [`DragLaw::NAMED`].
    fn from_str(text: &str) -> Result<Self> {
        if text == "none" {
            return Ok(Self::None);
        }
        if let Some(number) = text.strip_prefix("constant:") {
            let coefficient = number.trim().parse().unwrap_or(f64::NAN);
            within(Quantity::DragCoefficient, coefficient, 0.0..)?;
            return Ok(Self::Constant(coefficient));
        }
        Self::NAMED
            .into_iter()
            .find(|law| law.name() == text)
            .ok_or_else(|| {
                let mut known = vec!["none", "constant:0.4"];
                known.extend(Self::NAMED.iter().map(Self::name));
                Error::unknown_name("drag law", text, &known)
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use DragLaw::{
        Almedeij, BrownLawler, Cheng, CliftGauvin, CliftGraceWeber, HaiderLevenspiel, Morrison,
        SchillerNaumann, Stokes, TurtonLevenspiel,
    };

    /// Values computed independently from the published formulas, to all their digits.
    #[test]
    fn laws_give_the_reference_values() {
        let laws = [
            CliftGraceWeber,
            CliftGauvin,
            TurtonLevenspiel,
            HaiderLevenspiel,
            BrownLawler,
            Cheng,
            Morrison,
            Almedeij,
        ];
        let table = [
            (
                100.0,
                [
                    1.0870, 1.0938, 1.0994, 1.0947, 1.0731, 1.1024, 1.0381, 0.9925,
                ],
            ),
            (
                1000.0,
                [
                    0.4711, 0.4662, 0.4547, 0.4535, 0.4634, 0.4663, 0.4838, 0.4358,
                ],
            ),
            (
                6200.0,
                [
                    0.3879, 0.3937, 0.3995, 0.4022, 0.3952, 0.4085, 0.3977, 0.4210,
                ],
            ),
            (
                2e4,
                [
                    0.4417, 0.4559, 0.4497, 0.4475, 0.4376, 0.4345, 0.3931, 0.4468,
                ],
            ),
            (
                1e5,
                [
                    0.5018, 0.4918, 0.4707, 0.4715, 0.4661, 0.4697, 0.4257, 0.4843,
                ],
            ),
        ];
        for (reynolds, row) in table {
            for (law, expected) in laws.iter().zip(row) {
                let found = law.coefficient(reynolds).unwrap();
                assert_eq!(
                    format!("{found:.4}"),
                    format!("{expected:.4}"),
                    "{law} at {reynolds}"
                );
            }
        }
    }

    /// Stokes and Schiller-Naumann have no row in the reference table: their formulas by hand.
    #[test]
    fn low_laws_follow_their_formulas() {
        assert!((Stokes.coefficient(0.1).unwrap() - 240.0).abs() < 1e-10);
        let expected = 0.24 * (1.0 + 0.15 * 100_f64.powf(0.687));
        assert!((SchillerNaumann.coefficient(100.0).unwrap() - expected).abs() < 1e-14);
    }

    /// The measured standard curve of a sphere, read from a published figure, before the drag
    /// crisis. It is a sanity check: the laws and the reading of the figure agree within 15 %.
    #[test]
    fn good_laws_follow_the_measured_curve() {
        let measured = [
            (1000.0, 0.4786),
            (1862.0, 0.4365),
            (3162.0, 0.4074),
            (4764.0, 0.3890),
            (8375.0, 0.3981),
            (15_560.0, 0.4395),
            (26_480.0, 0.4571),
            (34_670.0, 0.4775),
            (58_880.0, 0.4732),
            (1e5, 0.4624),
            (170_200.0, 0.4395),
        ];
        for law in [
            CliftGraceWeber,
            CliftGauvin,
            TurtonLevenspiel,
            HaiderLevenspiel,
            BrownLawler,
            Cheng,
        ] {
            for (reynolds, coefficient) in measured {
                let ratio = law.coefficient(reynolds).unwrap() / coefficient;
                assert!((ratio - 1.0).abs() < 0.15, "{law} at {reynolds}: {ratio}");
            }
        }
    }

    /// The laws that go through the drag crisis drop by a factor of two or more there.
    #[test]
    fn the_drag_crisis_is_there() {
        for law in [CliftGraceWeber, Almedeij, Morrison] {
            let fall = law.coefficient(1e5).unwrap() / law.coefficient(4.5e5).unwrap();
            assert!(fall > 2.0, "{law}: {fall}");
        }
    }

    /// Below the data every law becomes Stokes' law, down to the smallest numbers.
    #[test]
    fn laws_tend_to_stokes() {
        for law in DragLaw::NAMED {
            for reynolds in [0.0, 1e-300, 1e-40, 1e-12, 1e-6] {
                let ratio = law.over_stokes(reynolds);
                assert!((ratio - 1.0).abs() < 1e-3, "{law} at {reynolds}: {ratio}");
            }
            assert_eq!(law.coefficient(0.0), Ok(f64::INFINITY));
        }
    }

    /// How far the published pieces of the standard curve miss each other, computed independently.
    #[test]
    fn pieces_of_the_standard_curve_meet() {
        let gaps_percent = [
            0.003, 0.756, 0.009, 0.065, -0.009, -0.013, 0.594, -21.190, 0.000,
        ];
        for (&joint, expected) in CliftGraceWeber.joints().iter().zip(gaps_percent) {
            let below = CliftGraceWeber.over_stokes(joint * (1.0 - 1e-12));
            let gap = 100.0 * (CliftGraceWeber.over_stokes(joint) / below - 1.0);
            assert!((gap - expected).abs() < 6e-4, "at {joint}: {gap} %");
        }
    }

    #[test]
    fn outside_the_range_is_an_error() {
        for law in DragLaw::NAMED {
            let max = law.max_reynolds();
            if max.is_finite() {
                assert!(law.coefficient(max).is_ok());
                assert!(matches!(
                    law.coefficient(max * 1.0001),
                    Err(Error::ReynoldsTooHigh { .. })
                ));
            }
            assert!(law.coefficient(-1.0).is_err());
            assert!(law.coefficient(f64::NAN).is_err());
        }
        assert!(DragLaw::Constant(-0.4).coefficient(100.0).is_err());
    }

    #[test]
    fn names_round_trip() {
        for law in DragLaw::NAMED
            .into_iter()
            .chain([DragLaw::None, DragLaw::Constant(0.445)])
        {
            assert_eq!(law.to_string().parse(), Ok(law));
        }
        for text in [
            "",
            "constant",
            "constant:",
            "constant:fast",
            "constant:-1",
            "Stokes ",
        ] {
            assert!(text.parse::<DragLaw>().is_err(), "{text}");
        }
        let message = "clift-grace".parse::<DragLaw>().unwrap_err().to_string();
        assert!(
            message.contains("nearest is \"clift-grace-weber\""),
            "{message}"
        );
    }
}
