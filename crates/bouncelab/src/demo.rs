//! A synthesised drop with known truth: that of the paper.
//!
//! ```
//! use bouncelab::demo;
//!
//! let history = demo::history()?;
//! let sound = demo::sound(&history, 1)?;
//! assert_eq!(sound.impacts.len(), history.impact_events().count());
//! # Ok::<(), bouncelab::Error>(())
//! ```

use crate::Result;
use crate::analysis::Options;
use crate::ball;
use crate::drop::{self, History, Start, Stop};
use crate::impact::ImpactEvent;
use crate::inference::{InferenceOptions, Priors};
use crate::restitution::{Contact, Restitution};
use crate::synth::{self, Noise, Rendered, Scene};

/// The ball: 38 mm, 2.5 g.
pub const BALL: &str = "table-tennis-38";
/// The paper's drop height in metres.
pub const DROP_HEIGHT_M: f64 = 0.305;
/// With drag, this restitution gives the paper's log-linear fit its slope over ten flights.
pub const RESTITUTION: f64 = 0.9529;
/// First and last flight of the paper's log-linear fit.
pub const FLIGHTS: (u32, u32) = (1, 10);
/// Signal-to-noise ratio of the loudest impact in low background noise, in dB.
const SNR_DB: f64 = 40.0;

/// What a person would say of it; not its height, which is to be found again.
///
/// # Errors
///
/// None: the ball is a preset.
pub fn settings() -> Result<Options> {
    let preset = ball::preset(BALL)?;
    Ok(Options {
        ball: preset.ball,
        contact_time_s: preset.contact_time_s,
        flights: Some(FLIGHTS.0 as usize..=FLIGHTS.1 as usize),
        priors: Priors::of_preset(preset),
        inference: Some(InferenceOptions::default()),
        ..Options::default()
    })
}

/// What really happens.
///
/// # Errors
///
/// None with these numbers.
pub fn history() -> Result<History> {
    /// Below this height of bounce, in metres, the sounds run into each other.
    const REST_M: f64 = 5e-4;
    let settings = settings()?;
    let contact = Contact::new(Restitution::constant(RESTITUTION)?, settings.contact_time_s)?;
    let start = Start::Height(DROP_HEIGHT_M);
    drop::simulate(&settings.model()?, &contact, start, Stop::below(REST_M))
}

/// How it sounds; the seed is that of the noise and of the small differences between impacts.
///
/// # Errors
///
/// None with these numbers.
pub fn sound(history: &History, seed: u64) -> Result<Rendered> {
    let strikes: Vec<ImpactEvent> = history.impact_events().collect();
    let scene = Scene {
        noise: Some(Noise::pink(SNR_DB)),
        ..Scene::default()
    };
    synth::render(&strikes, &scene, seed)
}
