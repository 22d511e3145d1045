//! `bouncelab demo`.

use clap::Args;

use crate::failure::Failure;

/// Make, hear and analyse a drop, and compare with the truth.
#[derive(Args)]
pub(crate) struct Arguments {}

pub(crate) fn run(_: &Arguments) -> Result<(), Failure> {
    Ok(())
}
