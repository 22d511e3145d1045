//! Warnings, assumptions and reasons, as data.
//!
//! Every warning, note, reason and question of the science is a [`Diagnostic`]: a stable [`Code`], a
//! [`Severity`] and named arguments. Programs filter by the code; messages in any language
//! are made elsewhere from the code and its arguments.
//!
//! ```
//! use bouncelab::diagnostic::{Code, Diagnostic, Severity};
//!
//! let missed = Diagnostic::new(Code::ImpactsMissed).with("count", 2);
//! assert_eq!(missed.code.name(), "impacts-missed");
//! assert_eq!(missed.severity, Severity::Info);
//! assert_eq!(missed.number("count"), Some(2.0));
//! ```

use std::collections::BTreeMap;
use std::fmt;

/// The severity of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum Severity {
    /// An assumption, or a note on the analysis.
    Info,
    /// The result may be wrong, or less certain than it seems.
    Warning,
    /// Something could not be done.
    Error,
}

/// An argument of a diagnostic.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(untagged))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(untagged))]
pub enum Argument {
    /// A number; its unit, if it has one, is in the name of the argument.
    Number(f64),
    /// Several numbers, such as those of impacts.
    Numbers(Vec<f64>),
    /// A name.
    Text(String),
}

impl From<f64> for Argument {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<usize> for Argument {
    fn from(value: usize) -> Self {
        Self::Number(value as f64)
    }
}

impl From<u64> for Argument {
    fn from(value: u64) -> Self {
        Self::Number(value as f64)
    }
}

impl From<i32> for Argument {
    fn from(value: i32) -> Self {
        Self::Number(f64::from(value))
    }
}

impl From<&str> for Argument {
    fn from(value: &str) -> Self {
        Self::Text(value.to_owned())
    }
}

impl From<String> for Argument {
    fn from(value: String) -> Self {
        Self::Text(value)
    }
}

impl From<&[usize]> for Argument {
    fn from(values: &[usize]) -> Self {
        Self::Numbers(values.iter().map(|&value| value as f64).collect())
    }
}

/// A remark on a result.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Diagnostic {
    /// What it is about.
    #[cfg_attr(feature = "typescript", ts(type = "string"))]
    pub code: Code,
    /// How much it matters.
    pub severity: Severity,
    /// The values that belong to it, by name.
    #[cfg_attr(
        feature = "typescript",
        ts(type = "{ readonly [name: string]: Argument }")
    )]
    pub arguments: BTreeMap<String, Argument>,
    /// The message. The science leaves it out; the front end adds it in the language of the reader.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none")
    )]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub message: Option<String>,
}

impl Diagnostic {
    /// A diagnostic of this code, without arguments, with the severity of its code.
    pub fn new(code: Code) -> Self {
        Self {
            code,
            severity: code.severity(),
            arguments: BTreeMap::new(),
            message: None,
        }
    }

    /// The same with an argument more.
    ///
    /// ```
    /// use bouncelab::diagnostic::{Code, Diagnostic};
    ///
    /// let clipped = Diagnostic::new(Code::Clipped).with("samples", 120_u64);
    /// assert_eq!((clipped.code.name(), clipped.number("samples")), ("clipped", Some(120.0)));
    /// ```
    #[must_use]
    pub fn with(mut self, name: &str, value: impl Into<Argument>) -> Self {
        self.arguments.insert(name.to_owned(), value.into());
        self
    }

    /// The number of this name, if there is one.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.arguments.get(name)? {
            Argument::Number(value) => Some(*value),
            Argument::Numbers(_) | Argument::Text(_) => None,
        }
    }
}

macro_rules! codes {
    ($($(#[$doc:meta])+ $variant:ident = $name:literal, $severity:ident, [$($argument:literal),*];)+) => {
        /// What a diagnostic is about.
        ///
        /// The names are stable: within a version of the schema none is removed or changes its meaning.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Code {
            $($(#[$doc])+ $variant,)+
        }

        impl Code {
            /// Every code.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// Its stable name, in kebab case.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)+ }
            }

            /// How much it matters.
            pub const fn severity(self) -> Severity {
                match self { $(Self::$variant => Severity::$severity,)+ }
            }

            /// The names of its arguments; one that ends in a question mark may be left out.
            pub const fn arguments(self) -> &'static [&'static str] {
                match self { $(Self::$variant => &[$($argument),*],)+ }
            }
        }
    };
}

codes! {
    // Of a recording.
    /// The recording holds no sound: all samples have the same value.
    RecordingSilent = "recording-silent", Error, [];
    /// No sound stands out from the background.
    NoSound = "no-sound", Error, [];
    /// Fewer sounds stand out than it takes to distinguish a drop from chance.
    TooFewSounds = "too-few-sounds", Error, ["count", "needed"];
    /// The sounds keep time, as of a clock, steps or a drum.
    PeriodicSounds = "periodic-sounds", Error, ["count", "interval_s"];
    /// Sounds stand out, but not at shrinking intervals.
    NoPattern = "no-pattern", Error, ["count", "needed"];
    /// A list has fewer than two times.
    TooFewTimes = "too-few-times", Error, [];
    /// A list has more times than a drop has impacts.
    TooManyTimes = "too-many-times", Error, ["count", "most"];
    /// Impacts are so far apart that the times are probably in milliseconds.
    TimesInMilliseconds = "times-in-milliseconds", Error, [];
    /// The intervals of a list of times do not get shorter, as the flights of a drop do.
    FlightsDoNotFall = "flights-do-not-fall", Error, ["count", "first_s", "last_s"];
    /// A threshold measured the listed times: it marks a faint impact later than a loud one.
    TimesByThreshold = "times-by-threshold", Warning, [];
    /// The listed times are sums of intervals.
    TimesOfIntervals = "times-of-intervals", Info, [];
    /// No flight is left after impacts were excluded.
    NothingLeft = "nothing-left", Error, [];
    /// A far fainter ball was detected and left out.
    DistantBall = "distant-ball", Info, ["start_s", "end_s", "impacts"];
    /// Two drops share their time: two balls bounced at once.
    DropsAtOnce = "drops-at-once", Warning, ["start_s", "end_s"];
    /// Sounds as loud as the impacts of a drop are near it and were not used.
    SoundsUnused = "sounds-unused", Info, ["count", "start_s"];
    /// A sound before a drop may be an earlier impact.
    EarlierImpact = "earlier-impact", Warning, ["time_s", "start_s"];
    /// Samples are clipped.
    Clipped = "clipped", Warning, ["samples"];
    /// Sounds may be a drop, but other sounds are more likely.
    PossibleDrop = "possible-drop", Info, ["number", "start_s", "impacts", "probability"];
    /// A candidate is to be accepted that does not exist.
    NoCandidate = "no-candidate", Warning, ["number", "count"];
    /// No impact lies within 20 ms of a time to exclude.
    NothingToExclude = "nothing-to-exclude", Warning, ["time_s"];
    /// A time to include lies too far from every drop.
    TooFarToInclude = "too-far-to-include", Warning, ["time_s", "reach_s"];
    /// Sound was lost within a drop: only the longest part without a gap is used.
    SoundLost = "sound-lost", Warning, ["at_s", "impacts", "kept"];
    /// No drop begins after the stated release.
    ReleaseWithoutDrop = "release-without-drop", Warning, ["time_s"];
    /// The stated height is far from the detected one, but would fit in another unit.
    HeightOfAnotherUnit = "height-of-another-unit", Warning, ["stated_m", "detected_m", "meant_m"];

    // Of the file that holds the recording.
    /// The file cannot be read.
    FileUnreadable = "file-unreadable", Error, [];
    /// The file ends before its header says, or in the middle of something, or holds more sound than its header counts.
    FileTruncated = "file-truncated", Warning, ["read_s", "expected_s?"];
    /// Samples are not numbers and were replaced by zero.
    SamplesNotFinite = "samples-not-finite", Warning, ["samples", "first_s"];
    /// Sound was lost and replaced by silence of the same length: times hold.
    SoundMissing = "sound-missing", Warning, ["places", "first_s", "missing_s"];
    /// Sound of unknown length was lost: times before and after cannot be compared.
    ClockLost = "clock-lost", Warning, ["places", "first_s"];
    /// The sound is exactly zero for a while, and not elsewhere: it may have been lost or overwritten.
    SoundBlank = "sound-blank", Warning, ["places", "first_s", "blank_s"];
    /// Samples jump by a power of two and back with the next one, as if bits of the file had been flipped.
    BitsFlipped = "bits-flipped", Warning, ["samples", "first_s"];
    /// The decoded sound does not match the checksum or the counts of the file, somewhere in this interval.
    ChecksumWrong = "checksum-wrong", Warning, ["start_s", "end_s"];
    /// The rate or number of channels changes; the recording was read up to there.
    FormatChanges = "format-changes", Warning, ["at_s"];
    /// The header of the file states one rate and, by its bytes a second, another; or an unusual one that nothing confirms.
    RateInDoubt = "rate-in-doubt", Warning, ["stated_hz", "implied_hz?"];
    /// The edit list of the file was ignored.
    EditListIgnored = "edit-list-ignored", Info, [];

    // Of a drop.
    /// Impacts between the first and the last were not detected; they are counted.
    ImpactsMissed = "impacts-missed", Info, ["count"];
    /// Impacts seem to give energy: restitution above 1.
    ImpactGainsEnergy = "impact-gains-energy", Warning, ["count", "impacts"];
    /// The corrected restitution rises with the speed, as that of no real ball does.
    RestitutionRises = "restitution-rises", Warning, ["slow", "fast"];
    /// Impacts are more likely other sounds.
    ImpactsDoubtful = "impacts-doubtful", Warning, ["count"];
    /// A flight lasts longer than the one before.
    FlightGrows = "flight-grows", Warning, ["flight"];

    // Of the posterior.
    /// Late impacts are so close to each other that the ball can hardly have flown in between, and were left out.
    ImpactsTooClose = "impacts-too-close", Warning, ["count", "start_s", "contact_time_s"];
    /// The number of impacts is so small that the priors dominate.
    FewImpacts = "few-impacts", Warning, ["count"];
    /// Between each two of few impacts one may have been missed, which times alone do not show: the restitution and the drop
    /// height then.
    FlightsMayBeTwo = "flights-may-be-two", Info, ["count", "restitution", "height_m"];
    /// A restitution law takes more impacts to be distinguished from a constant.
    LawNeedsImpacts = "law-needs-impacts", Info, ["law", "needed", "seen"];
    /// Impacts are outliers and count less.
    ImpactsOdd = "impacts-odd", Warning, ["count", "impacts"];
    /// Restitution scatters far more than is assumed.
    ScatterExceedsPrior = "scatter-exceeds-prior", Warning, ["relative_sd", "assumed_relative_sd"];
    /// The measured height contradicts the flight times.
    HeightContradictsTimes = "height-contradicts-times", Warning, ["measured_m", "detected_m", "gravity_m_s2"];
    /// The first impact may be another sound or of an earlier drop: with which probability, and from where the ball fell then.
    FirstImpactDoubtful = "first-impact-doubtful", Warning, ["time_s", "probability", "height_m"];
    /// The stated release contradicts the times: how long before the first impact it was, and how long the ball fell.
    ReleaseContradictsTimes = "release-contradicts-times", Warning, ["stated_s", "detected_s"];
    /// Impacts before the first one detected were missed.
    FirstImpactsMissed = "first-impacts-missed", Warning, ["probability"];
    /// Another ball explains the times much better than the one that was stated or assumed.
    OtherBallFitsBetter = "other-ball-fits-better", Warning, ["balls", "odds"];
    /// Some of the possible restitution laws lose so little at slow impacts that the ball would not come to rest.
    NeverRests = "never-rests", Info, [];
    /// No inference was asked for.
    InferenceOff = "inference-off", Info, [];
    /// An inference takes two impacts.
    InferenceNeedsImpacts = "inference-needs-impacts", Error, ["count"];
    /// The impacts do not determine the restitution: it is that of its prior.
    RestitutionUndetermined = "restitution-undetermined", Error, ["count", "least", "greatest"];
    /// Two impacts are so close to each other that the ball cannot have flown in between.
    ContactOverlaps = "contact-overlaps", Error, ["first", "second", "time_s", "interval_s", "contact_time_s"];
    /// No physical model explains the times.
    NoModelFits = "no-model-fits", Error, [];
    /// The sampling did not converge, so that its intervals could not be trusted.
    SamplingNotConverged = "sampling-not-converged", Error, ["pareto_shape?"];
    /// No draw of the posterior explains the times.
    SamplingFailed = "sampling-failed", Error, [];
    /// Too many impacts in a row were missed.
    MissedInARow = "missed-in-a-row", Error, ["missed", "after"];
    /// No ball with so much drag flies so long.
    FlightTooLong = "flight-too-long", Error, ["after", "duration_s"];
    /// The ball would gain speed in most impacts.
    GainsSpeed = "gains-speed", Error, [];
    /// The variances of groups cannot be separated.
    VariancesConfounded = "variances-confounded", Error, [];

    // Of input.
    /// A number is outside its range.
    OutOfRange = "out-of-range", Error, ["quantity", "value", "unit?", "range", "low?", "high?"];
    /// A name is not in the list.
    UnknownName = "unknown-name", Error, ["kind", "name", "nearest", "known"];
    /// The ball is faster than a drag table states.
    ReynoldsTooHigh = "reynolds-too-high", Error, ["reynolds", "max_reynolds"];
    /// The ball is lighter than the air it displaces.
    BallFloats = "ball-floats", Error, ["mass_kg", "displaced_kg"];
    /// The drop does not end.
    EndlessDrop = "endless-drop", Error, ["bounces", "apex_m"];
    /// A log-linear fit takes two flights.
    TooFewFlights = "too-few-flights", Error, ["flights"];
    /// A statistic takes more drops.
    TooFewDrops = "too-few-drops", Error, ["needed", "drops"];
    /// No frequency band lies in the range.
    NoBand = "no-band", Error, ["range", "bands"];
    /// Two settings contradict each other.
    SettingsContradict = "settings-contradict", Error, ["first", "second"];
    /// Numbers do not increase.
    NotInOrder = "not-in-order", Error, ["what", "number"];
    /// The recording has no channel of this number.
    NoChannel = "no-channel", Error, ["channel", "channels"];
    /// There are more drops than are analysed of one recording.
    TooManyDrops = "too-many-drops", Warning, ["drops", "most", "end_s"];
    /// There are more channels than can be analysed together.
    TooManyChannels = "too-many-channels", Error, ["channels", "most"];
    /// A rule that evaluates each drop cannot compare with a reference.
    EachOfReference = "each-of-reference", Error, [];
    /// A quantity is implausible, and another unit may be meant.
    ImplausibleQuantity = "implausible-quantity", Warning, ["quantity", "value", "unit", "meant?", "meant_unit?"];
    /// No ball has this mass and diameter, and other units may be meant.
    ImplausibleBall = "implausible-ball", Warning, ["mass_kg", "diameter_m", "meant_g?", "meant_cm?", "meant_mm?"];

    // What was assumed.
    /// The ball was not stated.
    AssumedBall = "assumed-ball", Info, ["ball"];
    /// Nobody stated the ball: it is one of the unknowns.
    BallNotStated = "ball-not-stated", Info, [];
    /// The contact time was not stated.
    AssumedContactTime = "assumed-contact-time", Info, ["contact_time_s"];
    /// The air was not stated, or not all of it.
    AssumedAir = "assumed-air", Info, ["temperature_k", "pressure_pa", "relative_humidity"];
    /// Gravity was not stated.
    AssumedGravity = "assumed-gravity", Info, ["gravity_m_s2"];

    /// The ball is that of the rule.
    AssumedRuleBall = "assumed-rule-ball", Info, ["ball"];
    /// The height of the fall is that of the rule.
    AssumedRuleHeight = "assumed-rule-height", Info, ["height_m", "sd_m"];

    // What was assumed before the data.
    /// Restitution: anything from 0 to 1.
    PriorRestitution = "prior-restitution", Info, [];
    /// Restitution: as a [`RestitutionPrior`](crate::restitution::RestitutionPrior) states it.
    PriorRestitutionStated = "prior-restitution-stated", Info, ["prior"];
    /// Scatter of restitution: about this, likely half as much to 2.5 times as much.
    PriorScatter = "prior-scatter", Info, ["relative_sd", "low_relative_sd", "high_relative_sd"];
    /// Impacts slower than those detected may lose more speed than the law says.
    PriorSlowLosses = "prior-slow-losses", Info, ["exponent"];
    /// An input is exact.
    PriorExact = "prior-exact", Info, ["input"];
    /// An input is unknown, within a factor e.
    PriorUnknown = "prior-unknown", Info, ["input"];
    /// An input is known to a relative standard uncertainty.
    PriorInput = "prior-input", Info, ["input", "relative_sd"];
    /// The drop height was measured.
    PriorHeight = "prior-height", Info, ["height_m", "sd_m"];
    /// The drop height is anything.
    PriorHeightFlat = "prior-height-flat", Info, [];
    /// The release was measured.
    PriorRelease = "prior-release", Info, ["release_s", "sd_s"];
    /// A constant drag coefficient is as probable as the law.
    /// Each further impact missed at the start is half as likely.
    PriorMissed = "prior-missed", Info, [];

    // Of a verdict.
    /// A part of the procedure of the rule was not kept.
    ProcedureNotKept = "procedure-not-kept", Warning, ["item"];
    /// The rule names no limits.
    RuleWithoutLimits = "rule-without-limits", Warning, [];
    /// Nobody stated the drop height.
    RuleNeedsHeight = "rule-needs-height", Warning, [];
    /// The first flight of a drop was not detected, or others came before it.
    DropWithoutFirstFlight = "drop-without-first-flight", Warning, ["drop"];
    /// A limit lies within the uncertainty.
    LimitWithinUncertainty = "limit-within-uncertainty", Warning, [];
    /// The rule was written from memory.
    RuleUnverified = "rule-unverified", Warning, [];
    /// Not the text of the rule was read, but one that cites it.
    RuleSecondary = "rule-secondary", Warning, [];
    /// The text of the formula was not read.
    FormulaUnverified = "formula-unverified", Warning, ["read"];
    /// The ball is another than the rule's.
    RuleOtherBall = "rule-other-ball", Warning, ["ball"];
    /// The rule does not state where heights are measured.
    RuleWithoutPoint = "rule-without-point", Info, [];
    /// The model answers with another value, beyond the uncertainties of both.
    ModelDiffers = "model-differs", Warning, [];
    /// The number of drops that would decide, if they had this mean and scatter.
    DropsThatDecide = "drops-that-decide", Info, ["drops"];
    /// No number of drops would decide.
    NoDropsDecide = "no-drops-decide", Info, [];
    /// There are too few drops to show how drops differ.
    VerdictOfFewDrops = "verdict-of-few-drops", Info, ["drops"];
}

/// By the name: derived traits for this number of variants compile to much code.
#[cfg(feature = "serde")]
impl serde::Serialize for Code {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(self.name())
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Code {
    fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let name = String::deserialize(from)?;
        let known = Self::ALL.iter().find(|code| code.name() == name);
        let unknown = || serde::de::Error::custom(format_args!("no diagnostic is called {name}"));
        known.copied().ok_or_else(unknown)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn names_are_kebab_case_and_unique() {
        let names: HashSet<_> = Code::ALL.iter().map(|code| code.name()).collect();
        assert_eq!(names.len(), Code::ALL.len());
        for name in names {
            let kebab = |c: char| c.is_ascii_lowercase() || c == '-';
            assert!(name.chars().all(kebab), "{name}");
        }
    }

    #[cfg(feature = "serde")]
    #[test]
    fn a_code_is_read_as_it_is_written() {
        for &code in Code::ALL {
            let json = serde_json::to_value(code).unwrap();
            assert_eq!(json, code.name());
            assert_eq!(serde_json::from_value::<Code>(json).unwrap(), code);
        }
        assert!(serde_json::from_str::<Code>("\"no-such-code\"").is_err());
    }
}
