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
use crate::drop::{self, History, Start, Stop};
use crate::impact::ImpactEvent;
use crate::restitution::{Contact, Restitution};
use crate::settings::{AnalysisSettings, Settings};
use crate::synth::{self, Noise, Rendered, Scene};

/// The ball: 38 mm, 2.5 g.
pub const BALL: &str = "table-tennis-38";
/// The paper's drop height in metres.
pub const DROP_HEIGHT_M: f64 = 0.305;
/// With drag, this restitution gives the paper's log-linear fit its slope over ten flights.
pub const RESTITUTION: f64 = 0.9529;
/// First and last flight of the paper's log-linear fit.
const FLIGHTS: (usize, usize) = (1, 10);
/// Signal-to-noise ratio of the loudest impact in low background noise, in dB.
const SNR_DB: f64 = 40.0;

/// What a person would state of it; not its height, which the analysis is to find.
pub fn settings() -> Settings {
    Settings {
        analysis: AnalysisSettings {
            flights: Some(FLIGHTS),
            ..AnalysisSettings::default()
        },
        ..Settings::of_ball(BALL)
    }
}

/// What really happens.
///
/// # Errors
///
/// None with these numbers.
pub fn history() -> Result<History> {
    /// Below this height of bounce, in metres, the sounds run into each other.
    const REST_M: f64 = 5e-4;
    let options = settings().resolve()?.options;
    let contact = Contact::new(Restitution::constant(RESTITUTION)?, options.contact_time_s)?;
    let start = Start::Height(DROP_HEIGHT_M);
    drop::simulate(&options.model()?, &contact, start, Stop::below(REST_M))
}

/// How it sounds; the seed is that of the noise and of the small differences between impacts.
///
/// # Errors
///
/// None with these numbers.
pub fn sound(history: &History, seed: u64) -> Result<Rendered> {
    let events: Vec<ImpactEvent> = history.impact_events().collect();
    let scene = Scene {
        noise: Some(Noise::pink(SNR_DB)),
        ..Scene::default()
    };
    synth::render(&events, &scene, seed)
}
