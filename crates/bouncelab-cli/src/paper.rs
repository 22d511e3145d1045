//! `bouncelab paper`.

use clap::Args;

use crate::failure::Failure;

/// Recompute every number and figure of the paper.
#[derive(Args)]
pub(crate) struct Arguments {}

pub(crate) fn run(_: &Arguments) -> Result<(), Failure> {
    Ok(())
}
