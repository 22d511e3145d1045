//! `bouncelab analyze`.

use clap::Args;

use crate::failure::Failure;

/// Find the drops in recordings, or in lists of impact times.
#[derive(Args)]
pub(crate) struct Arguments {}

pub(crate) fn run(_: &Arguments) -> Result<(), Failure> {
    Ok(())
}
