//! The arguments for the release, the surface and the end of a simulated drop.

use bouncelab::drag::DragLaw;
use bouncelab::drop::{Start, Stop};
use bouncelab::restitution::{LawKind, Restitution};
use bouncelab::settings::plausibility;
use bouncelab::{Diagnostic, Options};
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
    #[arg(
        long,
        value_name = "E",
        default_value = "0.935",
        allow_hyphen_values = true,
        help = restitution_help(),
        help_heading = "Drop"
    )]
    restitution: String,
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
        let restitution: Restitution = self.restitution.parse()?;
        let start = self
            .launch
            .map_or(Start::Height(self.height), Start::Launch);
        let stop = Stop::asked(self.until, self.bounces);
        Ok(Run::simulate(law, options, restitution, start, stop)?)
    }
}

/// Names each law with an example, so that the help offers every law that there is.
fn restitution_help() -> String {
    let laws = LawKind::ALL.map(|law| format!("{} (e = {})", law.example(), law.meaning()));
    format!(
        "Coefficient of restitution, 0 to 1, or a law of the impact speed v in m/s: {}",
        laws.join("; ")
    )
}
