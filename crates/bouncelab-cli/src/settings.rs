//! The arguments from which [`Settings`] are made.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::str::FromStr;

use bouncelab::Diagnostic;
use bouncelab::drag::{DragLaw, DragTable};
use bouncelab::inference::{ApexTarget, SamplerConfig};
use bouncelab::restitution::LawKind;
use bouncelab::settings::{
    AirSettings, AnalysisSettings, BallSettings, DetectionSettings, DropSettings, EditSettings,
    GravitySettings, InferenceSettings, Inferred, Input, Settings, Setup,
};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{ArgGroup, Args};

use crate::failure::Failure;
use crate::language::{text, translator};
use crate::units;

/// All settings of drops, in `analyze`, `listen`, `session` and `verdict`.
#[derive(Args, Clone, Debug)]
pub(crate) struct SettingsArguments {
    #[command(flatten)]
    physics: PhysicsArguments,
    #[command(flatten)]
    inference: InferenceArguments,
}

/// Ball, air, drag and gravity.
#[derive(Args, Clone, Debug)]
#[command(
    group = ArgGroup::new("kind_or_diameter").args(["ball", "diameter"]).multiple(true),
    group = ArgGroup::new("kind_or_mass").args(["ball", "mass"]).multiple(true)
)]
pub(crate) struct PhysicsArguments {
    /// The ball: a name such as tennis, "ping pong" or marble, also with its diameter, as in steel:10mm; 'bouncelab
    /// balls' lists them (default: table-tennis-40)
    #[arg(long, value_name = "NAME", value_parser = units::ball, help_heading = "Ball")]
    ball: Option<String>,
    /// Mass of the ball as weighed, as in 58g; without --ball it requires --diameter
    #[arg(long, allow_hyphen_values = true, value_parser = units::mass, help_heading = "Ball", requires = "kind_or_diameter")]
    mass: Option<f64>,
    /// Diameter of the ball as measured, as in 38mm; without --ball it requires --mass
    #[arg(long, allow_hyphen_values = true, value_parser = units::length, help_heading = "Ball", requires = "kind_or_mass")]
    diameter: Option<f64>,
    /// Contact time of ball and surface, as in 1ms (default: typical of the ball)
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, value_parser = units::time, help_heading = "Ball")]
    contact_time: Option<f64>,

    /// Drag law: none (as if there were no air), constant:0.4, standard (that of a smooth sphere), or a file with
    /// Reynolds number and drag coefficient in each line [default: standard]
    #[arg(long, value_name = "LAW", value_parser = drag_law, help_heading = "Air")]
    drag: Option<DragLaw>,
    /// Temperature of the air, as in 20C
    #[arg(long, value_parser = units::temperature, allow_hyphen_values = true, help_heading = "Air")]
    temperature: Option<f64>,
    /// Pressure of the air, as in 1013hPa
    #[arg(long, allow_hyphen_values = true, value_parser = units::pressure, help_heading = "Air")]
    pressure: Option<f64>,
    /// Relative humidity of the air, as in 50%
    #[arg(long, allow_hyphen_values = true, value_parser = units::share, help_heading = "Air")]
    humidity: Option<f64>,
    /// Density of the air, instead of the three above, as in 1.2kg/m3; 0 is vacuum
    #[arg(
        long, value_name = "DENSITY", allow_hyphen_values = true, value_parser = units::density, help_heading = "Air",
        conflicts_with_all = ["temperature", "pressure", "humidity"]
    )]
    air_density: Option<f64>,
    /// Viscosity of the air, as in 18.1uPa.s; requires --air-density
    #[arg(
        long, value_name = "VISCOSITY", allow_hyphen_values = true, value_parser = units::viscosity, help_heading = "Air",
        requires = "air_density"
    )]
    air_viscosity: Option<f64>,
    /// Neglect the buoyancy of the ball in air
    #[arg(long, help_heading = "Air")]
    no_buoyancy: bool,
    /// Neglect the added mass of the air that moves with the ball
    #[arg(long, help_heading = "Air")]
    no_added_mass: bool,

    /// Acceleration of gravity, as in 9.81 (default: standard gravity, 9.80665 m/s2)
    #[arg(
        long, allow_hyphen_values = true, value_parser = units::acceleration, help_heading = "Gravity",
        conflicts_with_all = ["latitude", "altitude"]
    )]
    gravity: Option<f64>,
    /// Latitude, from which gravity is computed, as in 47.5 or 33.9S
    #[arg(long, value_parser = units::latitude, allow_hyphen_values = true, help_heading = "Gravity")]
    latitude: Option<f64>,
    /// Height above sea level, as in 500m; requires --latitude
    #[arg(
        long, allow_hyphen_values = true, value_parser = units::length, help_heading = "Gravity",
        requires = "latitude"
    )]
    altitude: Option<f64>,

    /// Accept values that look like a wrong unit, as a drop from 30.5m or a ball of 2.5kg
    #[arg(long)]
    allow_implausible: bool,
}

/// Drop height and release, priors, questions to the inference.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Inference")]
pub(crate) struct InferenceArguments {
    /// Measured drop height, floor to lowest point of the ball, as in 30.5cm
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, value_parser = units::length)]
    height: Option<f64>,
    /// Standard uncertainty of the measured height [default: 2mm]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, value_parser = units::length, requires = "height")]
    height_sd: Option<f64>,
    /// Time of the release in the recording; it applies to the next drop
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, value_parser = units::time)]
    release: Option<f64>,
    /// Standard uncertainty of the release time [default: 5ms]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, value_parser = units::time, requires = "release")]
    release_sd: Option<f64>,
    #[arg(long, value_name = "LAWS", value_delimiter = ',', help = laws_help())]
    law: Vec<String>,
    /// What is known of the restitution over the impact speed in m/s, as in normal:0.5=0.93:0.01,3=0.86:0.02 (mean and
    /// standard deviation at each) or functions:0.5=0.93:0.01:0.01,3=0.86:0.01:-0.02 (mean, and functions of which each has
    /// a standard normal factor) [default: anything from 0 to 1]
    #[arg(long, value_name = "PRIOR")]
    restitution_prior: Option<String>,
    /// Relative standard uncertainty of an input, as in mass=0.1% or drag=0: mass, diameter,
    /// air-density, gravity, added-mass, drag (around its law), contact-time, timing (of the stated
    /// errors); scatter=2% is the typical scatter of restitution on this surface, and scatter-spread=0.5
    /// halves the usual width of its prior (0: exact); slow-losses=0 lets restitution follow its law until rest
    #[arg(long, value_name = "WHAT=SHARE", value_delimiter = ',', value_parser = known)]
    known: Vec<(Input, f64)>,
    /// Infer this quantity from the data, with an uninformative prior; gravity implies --first-detected
    #[arg(long, value_name = "WHAT", value_delimiter = ',', value_parser = inferred())]
    infer: Vec<Inferred>,
    /// State the restitution at this impact speed, as in 2.4m/s [default: the middle of those detected]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true, value_parser = impact_speed)]
    at_speed: Option<f64>,
    /// Predict the drop height from which a bounce reaches an apex, as in 2:28cm
    #[arg(long, value_name = "BOUNCE:APEX", value_parser = reach)]
    reach: Vec<ApexTarget>,
    /// The first impact detected is the first impact of the drop
    #[arg(long)]
    first_detected: bool,
    #[arg(long, value_name = "N", help = draws_help())]
    draws: Option<usize>,
    /// Seed of the random numbers of the inference [default: 1]
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Skip the inference, for speed
    #[arg(long, conflicts_with_all = ["reach", "at_speed", "infer"])]
    no_inference: bool,
}

/// Settings of single recordings, in `analyze` and `listen`.
#[derive(Args, Clone, Debug)]
pub(crate) struct RecordingArguments {
    /// Flights of the log-linear fit, as in 1..10, ..20 or 3..
    #[arg(long, value_name = "A..B", value_parser = flight_range)]
    flights: Option<(usize, usize)>,
    /// Use this channel only, counted from 1 (default: the one with the clearest impacts)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    channel: Option<u16>,
    /// Compare what the impact times of each drop indicate of each known ball
    #[arg(long)]
    which_ball: bool,
    #[command(flatten)]
    settings: SettingsArguments,
}

/// Settings of recordings that are at rest on a disk, in `analyze`.
#[derive(Args, Clone, Debug)]
pub(crate) struct EditArguments {
    /// Use this frequency range only, in Hz, as in 400..6000 (default: all bands, each against its own
    /// background)
    #[arg(long, value_name = "LOW..HIGH", value_parser = frequency_range)]
    band: Option<Range<f64>>,
    /// Samples a second of a text that is one column of samples without times
    #[arg(long, value_name = "HZ", value_parser = clap::value_parser!(u32).range(1..))]
    rate: Option<u32>,
    /// Take for a drop what is only possibly one, by its number in the result without it
    #[arg(long, value_name = "N", value_delimiter = ',')]
    accept: Vec<usize>,
    /// Exclude the impacts at these times, as in 1.234s,2.5s
    #[arg(long, value_name = "TIMES", value_delimiter = ',', allow_hyphen_values = true, value_parser = units::time)]
    exclude: Vec<f64>,
    /// Add impacts at these times
    #[arg(long, value_name = "TIMES", value_delimiter = ',', allow_hyphen_values = true, value_parser = units::time)]
    include: Vec<f64>,
}

impl SettingsArguments {
    /// The settings of these arguments.
    pub(crate) fn settings(&self) -> Result<Settings, Failure> {
        let Settings {
            ball, air, gravity, ..
        } = self.physics.settings();
        Ok(Settings {
            ball,
            air,
            gravity,
            drop: self.inference.drop(),
            inference: self.inference.settings()?,
            ..Settings::default()
        })
    }

    /// The options that follow from settings, which begin with those of these arguments.
    pub(crate) fn resolve(&self, settings: &Settings) -> Result<Setup, Failure> {
        self.physics.check(settings.questions())?;
        Ok(settings.resolve()?)
    }

    /// Whether to accept values that look like a wrong unit.
    pub(crate) fn allow_implausible(&self) -> bool {
        self.physics.allow_implausible
    }
}

impl RecordingArguments {
    /// The options that follow from these arguments.
    pub(crate) fn resolve(&self) -> Result<Setup, Failure> {
        self.settings.resolve(&self.settings()?)
    }

    /// The options that follow from these and further arguments.
    pub(crate) fn resolve_with(&self, edits: &EditArguments) -> Result<Setup, Failure> {
        let mut settings = self.settings()?;
        let band_hz = edits.band.as_ref();
        settings.detection.band_hz = band_hz.map(|band_hz| (band_hz.start, band_hz.end));
        settings.detection.rate_hz = edits.rate;
        settings.edits = EditSettings {
            accept: Some(edits.accept.clone()),
            exclude_s: Some(edits.exclude.clone()),
            include_s: Some(edits.include.clone()),
        };
        self.settings.resolve(&settings)
    }

    fn settings(&self) -> Result<Settings, Failure> {
        Ok(Settings {
            detection: DetectionSettings {
                channel: self.channel.map(usize::from),
                ..DetectionSettings::default()
            },
            analysis: AnalysisSettings {
                flights: self.flights,
                compare_balls: Some(self.which_ball),
            },
            ..self.settings.settings()?
        })
    }
}

impl PhysicsArguments {
    fn settings(&self) -> Settings {
        Settings {
            ball: BallSettings {
                kind: self.ball.clone(),
                mass_kg: self.mass,
                diameter_m: self.diameter,
                contact_time_s: self.contact_time,
            },
            air: AirSettings {
                drag: self.drag.as_ref().map(ToString::to_string),
                temperature_k: self.temperature,
                pressure_pa: self.pressure,
                relative_humidity: self.humidity,
                density_kg_m3: self.air_density,
                viscosity_pa_s: self.air_viscosity,
                buoyancy: self.no_buoyancy.then_some(false),
                added_mass: self.no_added_mass.then_some(false),
            },
            gravity: GravitySettings {
                gravity_m_s2: self.gravity,
                latitude_deg: self.latitude,
                altitude_m: self.altitude,
            },
            ..Settings::default()
        }
    }

    /// The options that follow from these arguments without an inference, unless one of these or a further question
    /// looks like a mistake.
    pub(crate) fn resolve(
        &self,
        further: impl IntoIterator<Item = Diagnostic>,
    ) -> Result<Setup, Failure> {
        let settings = self.settings().without_inference();
        self.check(settings.questions().into_iter().chain(further))?;
        Ok(settings.resolve()?)
    }

    /// Refuses implausible values, unless the person allows them.
    fn check(&self, questions: impl IntoIterator<Item = Diagnostic>) -> Result<(), Failure> {
        let questions = questions.into_iter();
        let questions: Vec<String> = questions
            .map(|question| translator().diagnostic(&question))
            .collect();
        if self.allow_implausible || questions.is_empty() {
            return Ok(());
        }
        let advice = text("advice-allow-implausible");
        Err(Failure::Usage(format!("{} {advice}", questions.join(" "))))
    }
}

impl InferenceArguments {
    fn drop(&self) -> DropSettings {
        DropSettings {
            height_m: self.height,
            height_sd_m: self.height_sd,
            release_s: self.release,
            release_sd_s: self.release_sd,
            first_detected: self.first_detected.then_some(true),
        }
    }

    fn settings(&self) -> Result<InferenceSettings, Failure> {
        let mut known = BTreeMap::new();
        for &(input, relative_sd) in &self.known {
            if known.insert(input, relative_sd).is_some() {
                return Err(Failure::Usage(format!(
                    "--known states {} twice; leave out one",
                    input.name()
                )));
            }
        }
        Ok(InferenceSettings {
            enabled: self.no_inference.then_some(false),
            restitution_laws: stated(&self.law),
            restitution_prior: self.restitution_prior.clone(),
            infer: stated(&self.infer),
            known: Some(known).filter(|known| !known.is_empty()),
            at_speed_m_s: self.at_speed,
            reach: stated(&self.reach),
            draws: self.draws,
            seed: self.seed,
        })
    }
}

/// The values of an argument, if it was given.
fn stated<T: Clone>(values: &[T]) -> Option<Vec<T>> {
    Some(values.to_vec()).filter(|values| !values.is_empty())
}

fn draws_help() -> String {
    let usual = SamplerConfig::default().draws;
    format!("Target number of independent draws of the posterior [default: {usual}]")
}

fn laws_help() -> String {
    let laws = LawKind::ALL.map(LawKind::name).join(", ");
    format!("Restitution laws to consider: {laws} [default: all that the number of impacts allows]")
}

/// Reads a drag law, or a file with a table of one.
pub(crate) fn drag_law(text: &str) -> Result<DragLaw, String> {
    let path = Path::new(text);
    let law = if path.is_file() {
        let table = fs::read_to_string(path).map_err(|error| format!("{text}: {error}"))?;
        DragTable::new(&drag_points(&table)?).map(DragLaw::Table)
    } else {
        text.parse()
    };
    law.map_err(|refusal| refusal.to_string())
}

/// Points of a table: two numbers a line, separated by a comma, a semicolon, a tab or spaces. The first line may be a
/// heading, lines that begin with `#` are comments.
fn drag_points(table: &str) -> Result<Vec<(f64, f64)>, String> {
    let point = |line: &str| {
        let mut cells = line
            .split([',', ';', '\t', ' '])
            .filter(|cell| !cell.is_empty());
        let mut number = || cells.next()?.parse::<f64>().ok();
        let point = (number()?, number()?);
        cells.next().is_none().then_some(point)
    };
    let lines = table.lines().map(str::trim).enumerate();
    let mut lines = lines
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
        .peekable();
    lines.next_if(|(_, line)| line.starts_with(|first: char| first.is_alphabetic()));
    lines
        .map(|(index, line)| {
            point(line).ok_or_else(|| {
                format!(
                    "line {}: expected Reynolds number and drag coefficient, as in 10000,0.64",
                    index + 1
                )
            })
        })
        .collect()
}

/// Reads the name of an input that may be left to the data.
fn inferred() -> impl TypedValueParser<Value = Inferred> {
    let names = Inferred::ALL.iter().map(|inferred| inferred.name());
    PossibleValuesParser::new(names.collect::<Vec<_>>()).try_map(|name| {
        let mut all = Inferred::ALL.iter().copied();
        all.find(|inferred| inferred.name() == name)
            .ok_or("unknown input")
    })
}

/// Reads `mass=0.1%`.
fn known(text: &str) -> Result<(Input, f64), String> {
    let (name, share) = text
        .split_once('=')
        .ok_or_else(|| format!("\"{text}\" is no input with a share; write it as in mass=0.1%"))?;
    let mut inputs = Input::ALL.iter().copied();
    let input = inputs.find(|input| input.name() == name.trim());
    let input = input.ok_or_else(|| {
        let names: Vec<&str> = Input::ALL.iter().map(|input| input.name()).collect();
        format!(
            "\"{name}\" is no input; the inputs are {}",
            names.join(", ")
        )
    })?;
    Ok((input, units::share(share.trim())?))
}

/// Reads the speed of an impact: `2.4m/s`.
pub(crate) fn impact_speed(text: &str) -> Result<f64, String> {
    let speed_m_s = units::speed(text)?;
    if speed_m_s > 0.0 && speed_m_s.is_finite() {
        Ok(speed_m_s)
    } else {
        Err("the speed of an impact is above 0, as in 2.4m/s".to_owned())
    }
}

/// Reads `2:28cm`.
fn reach(text: &str) -> Result<ApexTarget, String> {
    let wrong = || format!("\"{text}\" is no bounce with an apex; write it as in 2:28cm");
    let (bounce, apex) = text.split_once(':').ok_or_else(wrong)?;
    let bounce: usize = bounce.trim().parse().map_err(|_| wrong())?;
    if !(1..=1000).contains(&bounce) {
        return Err(format!("{}; bounces count from 1", wrong()));
    }
    let apex_m = units::length(apex.trim())?;
    if !(apex_m > 0.0 && apex_m.is_finite()) {
        return Err(format!("{}; an apex is above 0", wrong()));
    }
    Ok(ApexTarget { bounce, apex_m })
}

/// Reads `1..10` (both ends included), `..10`, `3..` or `5`.
fn flight_range(text: &str) -> Result<(usize, usize), String> {
    let single = || text.parse().ok().map(|number| (number, number));
    let range = ends(text, "..", 1, usize::MAX).or_else(|| ends(text, "..=", 1, usize::MAX));
    let range = range.or_else(single);
    range
        .filter(|&(first, last)| 1 <= first && first <= last)
        .ok_or_else(|| {
            format!("\"{text}\" is no range of flights, counted from 1; write it as in 1..10")
        })
}

/// Reads `400..6000`, `..6000` or `400..`, in Hz.
fn frequency_range(text: &str) -> Result<Range<f64>, String> {
    ends(text, "..", 0.0, f64::INFINITY)
        .filter(|(low, high)| (0.0..*high).contains(low))
        .map(|(low, high)| low..high)
        .ok_or_else(|| {
            format!("\"{text}\" is no range of frequencies in Hz; write it as in 400..6000")
        })
}

/// The two ends of a range, either of which may be open.
fn ends<T: FromStr>(text: &str, between: &str, lowest: T, highest: T) -> Option<(T, T)> {
    let end = |text: &str, open: T| match text {
        "" => Some(open),
        _ => text.parse().ok(),
    };
    let (first, last) = text.split_once(between)?;
    Some((end(first, lowest)?, end(last, highest)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_input_and_how_well_it_is_known() {
        assert_eq!(known("mass=0.1%"), Ok((Input::Mass, 0.001)));
        assert_eq!(known("contact-time = 0"), Ok((Input::ContactTime, 0.0)));
        assert!(known("mass").is_err());
        assert!(known("colour=1%").unwrap_err().contains("diameter"));
    }

    #[test]
    fn a_bounce_and_its_apex() {
        let asked = ApexTarget {
            bounce: 2,
            apex_m: 0.28,
        };
        assert_eq!(reach("2:28cm"), Ok(asked));
        assert!(reach("0:28cm").is_err());
        assert!(reach("28cm").is_err());
        assert!(reach("2:28kg").is_err());
        assert!(reach("2:0cm").is_err() && reach("2:-1cm").is_err());
    }

    #[test]
    fn an_impact_has_a_speed() {
        assert_eq!(impact_speed("2.5m/s"), Ok(2.5));
        assert!(impact_speed("0").is_err() && impact_speed("-1").is_err());
    }

    #[test]
    fn frequency_ranges_may_be_open() {
        assert_eq!(frequency_range("400..6000"), Ok(400.0..6000.0));
        assert_eq!(frequency_range("..6000"), Ok(0.0..6000.0));
        assert_eq!(frequency_range("400.."), Ok(400.0..f64::INFINITY));
        for wrong in ["400", "6000..400", "1..1", "a..b", "nan..5", "-5..5", ""] {
            assert!(frequency_range(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn flight_ranges_include_both_ends() {
        assert_eq!(flight_range("1..10"), Ok((1, 10)));
        assert_eq!(flight_range("..10"), Ok((1, 10)));
        assert_eq!(flight_range("3.."), Ok((3, usize::MAX)));
        assert_eq!(flight_range("3..=7"), Ok((3, 7)));
        assert_eq!(flight_range("5"), Ok((5, 5)));
        assert!(flight_range("10..1").is_err());
        assert!(flight_range("0..3").is_err());
        assert!(flight_range("a..b").is_err());
    }
}
