//! The arguments for the release, the surface and the end of a simulated drop.

use bouncelab::drag::DragLaw;
use bouncelab::drop::{Start, Stop};
use bouncelab::restitution::Restitution;
use bouncelab::{Diagnostic, Options, plausibility};
use bouncelab_report::document::simulation::Run;
use clap::Args;

use crate::failure::Failure;
use crate::units;

/// Release, surface and end of a simulated drop.
#[derive(Args, Clone, Debug)]
pub(crate) struct HistoryArguments {
    /// Height of release above the surface, as in 30.5cm
    #[arg(
        long, default_value = "30.5cm", allow_hyphen_values = true, value_parser = units::length,
        help_heading = "Drop"
    )]
    height: f64,
    /// Start upwards from the surface at this speed instead, as in 2.4m/s
    #[arg(
        long, value_name = "SPEED", allow_hyphen_values = true, value_parser = units::speed,
        conflicts_with = "height", help_heading = "Drop"
    )]
    launch: Option<f64>,
    /// Coefficient of restitution, 0 to 1; with --restitution-slope, that at speed zero
    #[arg(
        long,
        value_name = "E",
        default_value_t = 0.935,
        allow_hyphen_values = true,
        help_heading = "Drop"
    )]
    restitution: f64,
    /// Decrease of restitution per m/s of impact speed, as in 0.01
    #[arg(
        long,
        value_name = "SLOPE",
        default_value_t = 0.0,
        allow_hyphen_values = true,
        help_heading = "Drop"
    )]
    restitution_slope: f64,
    /// Stop when the ball no longer rises above this height (default: 1mm, unless --bounces is given)
    #[arg(
        long, value_name = "HEIGHT", allow_hyphen_values = true, value_parser = units::length,
        help_heading = "Drop"
    )]
    until: Option<f64>,
    /// Stop after this number of bounces
    #[arg(long, value_name = "N", help_heading = "Drop")]
    bounces: Option<usize>,
}

impl HistoryArguments {
    /// What looks like a mistake of units.
    pub(crate) fn question(&self) -> Option<Diagnostic> {
        plausibility::of_quantity("height", self.height)
    }

    /// Simulates the drop under a drag law, all else being as in the options.
    pub(crate) fn run(&self, law: DragLaw, options: &Options) -> Result<Run, Failure> {
        let restitution = if self.restitution_slope == 0.0 {
            Restitution::constant(self.restitution)?
        } else {
            Restitution::linear(self.restitution, self.restitution_slope)?
        };
        let start = self
            .launch
            .map_or(Start::Height(self.height), Start::Launch);
        let stop = Stop::asked(self.until, self.bounces);
        Ok(Run::simulate(law, options, restitution, start, stop)?)
    }
}
