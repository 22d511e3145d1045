//! What is given of a drop, and assumptions for the rest.
//!
//! A front end (the program, the page, Python) fills in what is given, as [`Settings`], and leaves out the rest.
//! [`Settings::resolve`] makes of it the [`Options`] of the analysis: what is left out is assumed, each assumption
//! is a diagnostic, and what is given counts as measured with ordinary care.
//!
//! ```
//! use bouncelab::ball;
//! use bouncelab::settings::{BallKind, BallSettings, Settings};
//!
//! let ball = BallSettings { kind: Some("tennis".to_owned()), ..BallSettings::default() };
//! let setup = Settings { ball, ..Settings::default() }.resolve()?;
//! assert_eq!(setup.ball, BallKind::Preset(ball::preset("tennis")?));
//! let codes: Vec<_> = setup.assumptions.iter().map(|assumed| assumed.code.name()).collect();
//! assert!(codes.contains(&"assumed-gravity"));
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod air;
mod analysis;
mod ball;
mod drop;
mod gravity;
mod inference;
pub mod plausibility;

use crate::Result;
use crate::analysis::Options;
use crate::diagnostic::{Code, Diagnostic};
use crate::drag::DragLaw;
use crate::flight::Environment;
use crate::inference::{Measured, PossibleBall, Priors};
use crate::rulebook::{Conditions, Rule};

pub use air::AirSettings;
pub use analysis::{AnalysisSettings, DetectionSettings, EditSettings};
pub use ball::{BallKind, BallSettings};
pub use drop::DropSettings;
pub use gravity::GravitySettings;
pub use inference::{InferenceSettings, Inferred, Input};

/// What is given of ball, air, gravity and drop, and what is asked; everything may be left out.
///
/// This is the one form in which front ends state it, also as JSON. Quantities are in SI, with the unit in the name.
///
/// ```
/// use bouncelab::settings::{BallSettings, Settings};
///
/// let ball = BallSettings { kind: Some("steel:0.01".to_owned()), ..BallSettings::default() };
/// let setup = Settings { ball, ..Settings::default() }.resolve()?;
/// assert!((setup.options.ball.mass_kg() - 0.0041).abs() < 1e-4);
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct Settings {
    /// The ball.
    #[cfg_attr(feature = "typescript", ts(as = "Option<BallSettings>"))]
    pub ball: BallSettings,
    /// The air, and its forces on the ball.
    #[cfg_attr(feature = "typescript", ts(as = "Option<AirSettings>"))]
    pub air: AirSettings,
    /// Gravity.
    #[cfg_attr(feature = "typescript", ts(as = "Option<GravitySettings>"))]
    pub gravity: GravitySettings,
    /// The drop.
    #[cfg_attr(feature = "typescript", ts(as = "Option<DropSettings>"))]
    pub drop: DropSettings,
    /// Where in a recording to look for impacts.
    #[cfg_attr(feature = "typescript", ts(as = "Option<DetectionSettings>"))]
    pub detection: DetectionSettings,
    /// Impacts excluded and included by hand.
    #[cfg_attr(feature = "typescript", ts(as = "Option<EditSettings>"))]
    pub edits: EditSettings,
    /// What to compute besides the inference.
    #[cfg_attr(feature = "typescript", ts(as = "Option<AnalysisSettings>"))]
    pub analysis: AnalysisSettings,
    /// The inference.
    #[cfg_attr(feature = "typescript", ts(as = "Option<InferenceSettings>"))]
    pub inference: InferenceSettings,
}

/// What follows from [`Settings`].
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Setup {
    /// The options of the analysis.
    pub options: Options,
    /// The ball, given or assumed.
    pub ball: BallKind,
    /// What was assumed, one diagnostic for each.
    pub assumptions: Vec<Diagnostic>,
    /// The circumstances that were given, as far as rules of sports ask for them.
    pub conditions: Conditions,
}

impl Settings {
    /// The settings of a preset ball, also with its diameter as in `steel:0.01`, and of nothing else.
    #[must_use]
    pub fn of_ball(kind: &str) -> Self {
        let ball = BallSettings {
            kind: Some(kind.to_owned()),
            ..BallSettings::default()
        };
        Self {
            ball,
            ..Self::default()
        }
    }

    /// The same without the inference.
    #[must_use]
    pub fn without_inference(mut self) -> Self {
        self.inference.enabled = Some(false);
        self
    }

    /// The options that follow, and what was assumed.
    ///
    /// # Errors
    ///
    /// [`Error::UnknownName`](crate::Error::UnknownName) for a ball or a law that is in no list,
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for a number outside its range,
    /// [`Error::Contradiction`](crate::Error::Contradiction) for two settings of which only one can hold, and the
    /// errors of [`FlightModel::new`](crate::flight::FlightModel::new) for a ball that cannot fall.
    pub fn resolve(&self) -> Result<Setup> {
        let mut assumptions = Vec::new();
        let drag = self.air.drag()?;
        let (kind, known) = self.ball.resolve(&mut assumptions)?;
        let environment = Environment {
            gravity_m_s2: self.gravity.resolve(&mut assumptions)?,
            air: self.air.resolve(&mut assumptions)?,
            // Without drag the ball flies as if there were no air at all.
            buoyancy: self.air.buoyancy != Some(false) && drag != DragLaw::None,
            added_mass: self.air.added_mass != Some(false) && drag != DragLaw::None,
            drag,
        };
        let mut options = Options {
            ball: known.ball,
            environment,
            contact_time_s: known.contact_time_s,
            flights: self.analysis.flights(),
            priors: Priors::default().with_ball(&known),
            inference: None,
            detection: self.detection.resolve(),
            edits: self.edits.resolve(),
            compares_balls: self.analysis.compare_balls == Some(true),
        };
        // A ball that cannot fall is refused here, before a recording is read.
        options.model()?;
        self.air.inform(&mut options.priors);
        self.gravity.inform(&mut options.priors);
        self.drop.inform(&mut options.priors);
        self.inference.check_against(&options)?;
        self.inference.inform(&mut options.priors)?;
        options.priors.check()?;
        options.inference = self.inference.resolve()?;
        if kind == BallKind::Unstated {
            assumptions.insert(0, self.leave_ball_open(&mut options)?);
        }
        let conditions = Conditions {
            drop_height_m: options.priors.drop_height_m,
            temperature_k: self.air.temperature_k,
            relative_humidity: self.air.relative_humidity,
            altitude_m: self.gravity.altitude_m,
            kept: Vec::new(),
        };
        Ok(Setup {
            options,
            ball: kind,
            assumptions,
            conditions,
        })
    }

    /// Makes the ball one of the unknowns; without an inference the usual ball is assumed.
    fn leave_ball_open(&self, options: &mut Options) -> Result<Diagnostic> {
        if options.inference.is_none() {
            let assumed = Diagnostic::new(Code::AssumedBall);
            return Ok(assumed.with("ball", crate::ball::usual().name));
        }
        for possible in PossibleBall::kinds() {
            let mut priors = options.priors.clone().with_ball(&possible.known);
            let mut contact_time_s = possible.known.contact_time_s;
            if let Some(measured_s) = self.ball.contact_time_s {
                contact_time_s = measured_s;
                priors.contact_time_rel_sd = options.priors.contact_time_rel_sd;
            }
            self.inference.inform(&mut priors)?;
            let known = priors.known(possible.known.ball, contact_time_s);
            options
                .priors
                .possible_balls
                .push(PossibleBall { known, ..*possible });
        }
        Ok(Diagnostic::new(Code::BallNotStated))
    }

    /// The settings with the ball of a rule where they state none, and whether it is that; `None` if neither has one.
    pub fn with_ball_of(&self, rule: &Rule) -> Option<(Self, bool)> {
        let mut settings = self.clone();
        if settings.ball.kind.is_some() || settings.ball.mass_kg.is_some() {
            return Some((settings, false));
        }
        settings.ball.kind = Some(rule.ball.clone()?);
        Some((settings, true))
    }

    /// The values that another unit would explain better.
    pub fn questions(&self) -> Vec<Diagnostic> {
        plausibility::of_settings(self)
    }
}

impl Setup {
    /// Assumes what a rule states of the drops that it evaluates: their height, unless one is given, and its ball
    /// if `is_its_ball`, where none was given.
    ///
    /// ```
    /// use bouncelab::rulebook::Rule;
    /// use bouncelab::settings::Settings;
    ///
    /// let mut setup = Settings::default().resolve()?;
    /// setup.assume(&Rule::new("a", "A rule", 0.305), false);
    /// assert_eq!(setup.options.priors.drop_height_m.map(|height| height.value), Some(0.305));
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn assume(&mut self, rule: &Rule, is_its_ball: bool) {
        if is_its_ball {
            let ball = Diagnostic::new(Code::AssumedRuleBall);
            let name = rule.ball.as_deref().unwrap_or_default();
            self.assumptions.insert(0, ball.with("ball", name));
        }
        let fall_m = rule.fall_m(self.options.ball.diameter_m(), None);
        if let (None, Some(fall_m)) = (self.options.priors.drop_height_m, fall_m) {
            let sd = rule
                .drop_tolerance_m
                .map_or(drop::HEIGHT_SD_M, |tolerance| {
                    // Anywhere within the tolerance: the standard deviation of a rectangle.
                    tolerance / 3.0_f64.sqrt()
                });
            self.assumptions.push(
                Diagnostic::new(Code::AssumedRuleHeight)
                    .with("height_m", fall_m)
                    .with("sd_m", sd),
            );
            self.options.priors.drop_height_m = Some(Measured { value: fall_m, sd });
        }
    }
}
