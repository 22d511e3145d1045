//! `bouncelab synth`.

use clap::Args;

use crate::failure::Failure;

/// Make a recording of a drop, without a microphone.
#[derive(Args)]
pub(crate) struct Arguments {}

pub(crate) fn run(_: &Arguments) -> Result<(), Failure> {
    Ok(())
}
