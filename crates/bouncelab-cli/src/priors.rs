//! The arguments for measured quantities, priors and options of the inference.

use bouncelab::analysis::Options;
use bouncelab::drag::DragLaw;
use bouncelab::inference::{ApexTarget, Priors, SamplerConfig};
use bouncelab::restitution::LawKind;
use bouncelab::setup::{self, Settings, Setup};
use clap::{Args, ValueEnum};

use crate::failure::Failure;
use crate::units;

/// Measurements, priors and questions.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Inference")]
pub(crate) struct PriorArguments {
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
    /// Relative standard uncertainty of an input, as in mass=0.1% or drag=0: mass, diameter,
    /// air-density, gravity, added-mass, drag (around its law), contact-time, timing (of the stated
    /// errors); scatter=2% is the typical scatter of restitution on this surface; slow-losses=0 lets
    /// restitution follow its law until rest
    #[arg(long, value_name = "WHAT=SHARE", value_delimiter = ',', value_parser = known)]
    known: Vec<(Input, f64)>,
    /// Infer this quantity from the data, with an uninformative prior
    #[arg(long, value_name = "WHAT", value_delimiter = ',', value_enum)]
    infer: Vec<Inferred>,
    /// State the restitution at this impact speed, as in 2.4m/s [default: the middle of those detected]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true, value_parser = impact_speed)]
    at_speed: Option<f64>,
    /// Predict the drop height from which a bounce reaches an apex, as in 2:28cm
    #[arg(long, value_name = "BOUNCE:APEX", value_parser = reach)]
    reach: Vec<ApexTarget>,
    /// The first impact detected is the first impact of the drop
    #[arg(long, alias = "first-heard")]
    first_detected: bool,
    /// Target number of independent draws of the posterior
    #[arg(long, value_name = "N", default_value_t = SamplerConfig::default().draws)]
    draws: usize,
    /// Seed of the random numbers of the inference
    #[arg(long, value_name = "N", default_value_t = SamplerConfig::default().seed)]
    seed: u64,
    /// Skip the inference, for speed
    #[arg(long, conflicts_with_all = ["reach", "at_speed", "infer"])]
    no_inference: bool,
}

fn laws_help() -> String {
    let laws = LawKind::ALL.map(LawKind::name).join(", ");
    format!("Restitution laws to consider: {laws} [default: all that the number of impacts allows]")
}

/// What may be left to the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Inferred {
    /// The acceleration of gravity; implies --first-detected
    Gravity,
    /// The drag coefficient
    Drag,
    /// The contact time
    ContactTime,
}

impl Inferred {
    /// The input whose uncertainty it stands for.
    fn input(self) -> Input {
        match self {
            Self::Gravity => Input::Gravity,
            Self::Drag => Input::Drag,
            Self::ContactTime => Input::ContactTime,
        }
    }
}

impl From<Inferred> for setup::Inferred {
    fn from(inferred: Inferred) -> Self {
        match inferred {
            Inferred::Gravity => Self::Gravity,
            Inferred::Drag => Self::Drag,
            Inferred::ContactTime => Self::ContactTime,
        }
    }
}

/// An input whose uncertainty may be stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Input {
    Mass,
    Diameter,
    AirDensity,
    Gravity,
    AddedMass,
    Drag,
    ContactTime,
    Timing,
    Scatter,
    SlowLosses,
}

impl Input {
    /// As in arguments.
    fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// Where the priors has it.
    fn of(self, priors: &mut Priors) -> &mut f64 {
        match self {
            Self::Mass => &mut priors.mass_rel_sd,
            Self::Diameter => &mut priors.diameter_rel_sd,
            Self::AirDensity => &mut priors.air_density_rel_sd,
            Self::Gravity => &mut priors.gravity_rel_sd,
            Self::AddedMass => &mut priors.added_mass_rel_sd,
            Self::Drag => &mut priors.drag_rel_sd,
            Self::ContactTime => &mut priors.contact_time_rel_sd,
            Self::Timing => &mut priors.timing_rel_sd,
            Self::Scatter => &mut priors.restitution_scatter,
            Self::SlowLosses => &mut priors.slow_loss_exponent,
        }
    }
}

impl PriorArguments {
    /// Adds what these arguments say, and what they ask, to what the physics says.
    pub(crate) fn complete(&self, physics: Settings) -> Settings {
        Settings {
            height_m: self.height,
            height_sd_m: self.height_sd,
            release_s: self.release,
            release_sd_s: self.release_sd,
            first_detected: Some(self.first_detected),
            restitution_laws: Some(self.law.clone()),
            infer: Some(self.infer.iter().map(|&inferred| inferred.into()).collect()),
            at_speed_m_s: self.at_speed,
            reach: Some(self.reach.clone()),
            draws: Some(self.draws),
            seed: Some(self.seed),
            ..physics
        }
    }

    /// What follows from settings that these arguments have completed.
    pub(crate) fn resolve(&self, settings: &Settings) -> Result<Setup, Failure> {
        let mut setup = settings.resolve(!self.no_inference)?;
        self.check_against(&setup.options).map_err(Failure::Usage)?;
        for &(input, share) in &self.known {
            *input.of(&mut setup.options.priors) = share;
        }
        setup.options.priors.check()?;
        Ok(setup)
    }

    /// Whether no two arguments contradict each other; if some do, which.
    fn check_against(&self, settings: &Options) -> Result<(), String> {
        let known: Vec<Input> = self.known.iter().map(|&(input, _)| input).collect();
        for (place, input) in known.iter().enumerate() {
            if known[..place].contains(input) {
                return Err(format!(
                    "--known states {} twice; leave out one",
                    input.name()
                ));
            }
        }
        if let Some(both) = self.infer.iter().find(|it| known.contains(&it.input())) {
            let name = both.input().name();
            return Err(format!(
                "--known {name} and --infer {name} contradict each other; leave out one"
            ));
        }
        let environment = &settings.environment;
        let no_drag = environment.drag == DragLaw::None || environment.air.is_vacuum();
        if no_drag && self.infer.contains(&Inferred::Drag) {
            return Err(
                "--infer drag and no drag at all (--drag none, --air-density 0) contradict each \
                 other; leave out one"
                    .to_owned(),
            );
        }
        if settings.contact_time_s == 0.0 && self.infer.contains(&Inferred::ContactTime) {
            return Err(
                "--infer contact-time and a contact time of exactly 0 contradict each other; leave \
                 out one"
                    .to_owned(),
            );
        }
        Ok(())
    }
}

/// Reads `mass=0.1%`.
fn known(text: &str) -> Result<(Input, f64), String> {
    let (name, share) = text
        .split_once('=')
        .ok_or_else(|| format!("\"{text}\" is no input with a share; write it as in mass=0.1%"))?;
    let input = Input::from_str(name.trim(), true).map_err(|_| {
        let names = Input::value_variants().iter().map(|input| input.name());
        let names: Vec<String> = names.collect();
        format!("\"{name}\" is none of {}", names.join(", "))
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
}
