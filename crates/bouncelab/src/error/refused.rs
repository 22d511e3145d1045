//! What was refused: the quantity, and the values that are accepted for it.

use std::fmt;
use std::ops::{Bound, RangeBounds};

macro_rules! quantities {
    ($($variant:ident = $key:literal, $unit:literal;)+) => {
        /// A quantity of which a number was refused.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum Quantity {
            $(#[doc = concat!("`", $key, "`")] $variant,)+
        }

        impl Quantity {
            /// Every quantity.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// Its stable name, in kebab case.
            pub const fn key(self) -> &'static str {
                match self { $(Self::$variant => $key,)+ }
            }

            /// The symbol of its unit, if it has one.
            pub fn unit(self) -> Option<&'static str> {
                let unit = match self { $(Self::$variant => $unit,)+ };
                Some(unit).filter(|unit| !unit.is_empty())
            }
        }
    };
}

quantities! {
    AirDensity = "air-density", "kg/m³";
    AirPressure = "pressure", "Pa";
    AirTemperature = "temperature", "K";
    AirViscosity = "air-viscosity", "Pa s";
    Altitude = "altitude", "m";
    Apex = "apex", "m";
    Attack = "attack", "";
    BallDiameter = "ball-diameter", "m";
    BallMass = "ball-mass", "kg";
    ClickLevel = "click-level", "dB";
    ClickRate = "click-rate", "1/s";
    ClippingLevel = "clipping-level", "";
    ContactTime = "contact-time", "s";
    DcOffset = "dc-offset", "";
    DecayTime = "decay-time", "s";
    DirectToReverberant = "direct-to-reverberant-ratio", "dB";
    Dissipation = "dissipation", "";
    DragCoefficient = "drag-coefficient", "";
    Draws = "number-of-draws", "";
    DropSd = "drop-standard-error", "";
    DropValue = "drop-value", "";
    Drops = "number-of-drops", "";
    Evenness = "evenness", "";
    FlightTime = "flight-time", "s";
    FormulaFactor = "formula-factor", "m/s²";
    FormulaOffset = "formula-offset", "s";
    Gravity = "gravity", "m/s²";
    Height = "height", "m";
    HeightSd = "height-sd", "m";
    HeightTolerance = "height-tolerance", "m";
    HumFrequency = "hum-frequency", "Hz";
    HumHarmonics = "hum-harmonics", "";
    HumLevel = "hum-level", "dB";
    Humidity = "humidity", "";
    ImpactSpeed = "impact-speed", "m/s";
    ImpactTime = "impact-time", "s";
    ImpactTimeSd = "impact-time-sd", "s";
    Interval = "interval", "s";
    Latitude = "latitude", "°";
    LaunchSpeed = "launch-speed", "m/s";
    LeadIn = "lead-in", "s";
    LevelExponent = "level-exponent", "";
    LevelScatter = "level-scatter", "";
    LossProbability = "loss-probability", "";
    LostImpact = "lost-impact", "";
    LoudestImpact = "loudest-impact", "";
    ModeFrequency = "mode-frequency", "Hz";
    ModeLevel = "mode-level", "";
    Modes = "number-of-modes", "";
    Peak = "peak", "";
    PhaseScatter = "phase-scatter", "rad";
    Places = "number-of-places", "";
    Rebound = "rebound", "m";
    ReferenceShare = "reference-share", "";
    ReferenceSpeed = "reference-speed", "m/s";
    RelativeSd = "relative-sd", "";
    ReleaseTime = "release-time", "s";
    ReleaseTimeSd = "release-time-sd", "s";
    Restitution = "restitution", "";
    RestitutionExponent = "restitution-exponent", "";
    RestitutionLoss = "restitution-loss", "s/m";
    RestitutionSd = "restitution-sd", "";
    RestitutionScatter = "restitution-scatter", "";
    ReverberationTime = "reverberation-time", "s";
    Reynolds = "reynolds-number", "";
    Risk = "risk", "";
    Rounding = "rounding", "";
    SampleRate = "sample-rate", "Hz";
    Samples = "number-of-samples", "";
    SlowLossExponent = "slow-loss-exponent", "";
    Snr = "snr", "dB";
    Speed = "speed", "m/s";
    SpeedRatio = "speed-ratio", "";
    StopHeight = "stop-height", "m";
    Tail = "tail", "s";
    TerminalSpeed = "terminal-speed", "m/s";
    TotalTime = "total-time", "s";
}

impl Quantity {
    /// A value with the unit.
    pub(super) fn written(self, value: f64) -> String {
        let unit = self.unit().map(|unit| format!(" {unit}"));
        written(value) + &unit.unwrap_or_default()
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.key().replace('-', " "))
    }
}

/// The values that are accepted for a quantity. They are finite where an end is open.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    low: Bound<f64>,
    high: Bound<f64>,
}

impl Bounds {
    pub(super) fn from(range: &impl RangeBounds<f64>) -> Self {
        Self {
            low: range.start_bound().cloned(),
            high: range.end_bound().cloned(),
        }
    }

    /// The lower end.
    pub const fn low(&self) -> Option<f64> {
        end(self.low)
    }

    /// The upper end.
    pub const fn high(&self) -> Option<f64> {
        end(self.high)
    }

    /// Its kind in kebab case: `finite`, `above`, `at-least`, `below`, `at-most`, or both ends as in
    /// `at-least-below`.
    pub fn key(&self) -> String {
        let ends = self.ends().into_iter().flatten().map(|(kind, _)| kind);
        let kinds: Vec<_> = ends.collect();
        if kinds.is_empty() {
            "finite".to_owned()
        } else {
            kinds.join("-")
        }
    }

    fn ends(&self) -> [Option<(&'static str, f64)>; 2] {
        let named = |bound, excluded, included| match bound {
            Bound::Excluded(value) => Some((excluded, value)),
            Bound::Included(value) => Some((included, value)),
            Bound::Unbounded => None,
        };
        [
            named(self.low, "above", "at-least"),
            named(self.high, "below", "at-most"),
        ]
    }
}

const fn end(bound: Bound<f64>) -> Option<f64> {
    match bound {
        Bound::Excluded(value) | Bound::Included(value) => Some(value),
        Bound::Unbounded => None,
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ends = self.ends();
        let finite = ends.contains(&None).then(|| "finite".to_owned());
        let ends = ends.into_iter().flatten();
        let ends =
            ends.map(|(kind, value)| format!("{} {}", kind.replace('-', " "), written(value)));
        f.write_str(
            &finite
                .into_iter()
                .chain(ends)
                .collect::<Vec<_>>()
                .join(" and "),
        )
    }
}

/// A number without the noise of binary fractions, in powers of ten where there would be a row of
/// zeros.
fn written(value: f64) -> String {
    let value = if value.fract() == 0.0 {
        value
    } else {
        format!("{value:.8e}").parse().unwrap_or(value)
    };
    let ordinary = value == 0.0 || !value.is_finite() || (1e-9..1e15).contains(&value.abs());
    if ordinary {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}
