//! The arguments for the release, the surface and the end of a simulated drop.

use bouncelab::Diagnostic;
use bouncelab::drop::{self, History, Start, Stop};
use bouncelab::flight::FlightModel;
use bouncelab::impact::{Contact, Restitution};
use clap::Args;

use crate::failure::Failure;
use crate::physics::of_quantities;
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

/// The height of bounce at which a drop counts as over, in metres.
const REST_M: f64 = 1e-3;

impl HistoryArguments {
    /// What looks like a mistake of units.
    pub(crate) fn questions(&self) -> Vec<Diagnostic> {
        of_quantities(&[("height", Some(self.height))])
    }

    /// Simulates the drop with this model.
    pub(crate) fn simulate(
        &self,
        model: &FlightModel,
        contact_time_s: f64,
    ) -> Result<History, Failure> {
        let restitution = if self.restitution_slope == 0.0 {
            Restitution::constant(self.restitution)?
        } else {
            Restitution::linear(self.restitution, self.restitution_slope)?
        };
        let contact = Contact::new(restitution, contact_time_s)?;
        let start = self
            .launch
            .map_or(Start::Height(self.height), Start::Launch);
        let stop = match (self.until, self.bounces) {
            (None, None) => Stop::below(REST_M),
            (Some(apex_m), None) => Stop::below(apex_m),
            (None, Some(bounces)) => Stop::after(bounces),
            (Some(apex_m), Some(bounces)) => Stop::below(apex_m).or_after(bounces),
        };
        Ok(drop::simulate(model, &contact, start, stop)?)
    }
}
