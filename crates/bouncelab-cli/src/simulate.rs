//! `bouncelab simulate`.

use clap::Args;

use crate::failure::Failure;

/// Simulate a drop: a table, and height against time.
#[derive(Args)]
pub(crate) struct Arguments {}

pub(crate) fn run(_: &Arguments) -> Result<(), Failure> {
    Ok(())
}
