//! Which figures an analysis has: the one place that turns what was found into drawings.
//!
//! The program's folder of figures, its reports and the browser all take them from here, each
//! figure by itself or all of a drop.
//!
//! ```
//! use bouncelab::analysis::{self, Options};
//! use bouncelab_report::illustration;
//!
//! let settings = Options { inference: None, ..Options::default() };
//! let impacts = analysis::impacts_of_times(&[0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045]);
//! let drop = analysis::analyze(impacts, &settings);
//! let names: Vec<_> = illustration::of_drop(&drop, &settings).iter().map(|i| i.name).collect();
//! let plain = ["flight-times", "restitution", "height", "bounce-heights", "bounce-energies"];
//! assert_eq!(names, plain);
//! ```

mod air;
mod heard;
mod inferred;

use bouncelab::analysis::{Drop, Options};

pub use air::{drag, drag_curves, drag_log};
pub use heard::{
    BounceEnergy, Flown, bounce_energies, bounce_heights, energies, flight_times, flown, height,
    height_with, restitution, waveform,
};
pub(crate) use heard::{envelope, line};
pub use inferred::{budget, corner, cut, models, residuals};

use crate::Figure;

/// A figure with the name by which files and links call it.
#[derive(Debug)]
pub struct Illustration {
    /// Lower-case letters and hyphens.
    pub name: &'static str,
    /// The drawing.
    pub figure: Figure,
}

impl Illustration {
    fn new(name: &'static str, figure: Figure) -> Self {
        Self { name, figure }
    }
}

/// Every figure of one drop: of what was heard, and of the inference if there is one.
pub fn of_drop(drop: &Drop, settings: &Options) -> Vec<Illustration> {
    let mut figures = vec![
        Illustration::new("flight-times", flight_times(drop)),
        Illustration::new("restitution", restitution(drop)),
        Illustration::new("height", height(drop, settings)),
        Illustration::new("bounce-heights", bounce_heights(drop)),
        Illustration::new("bounce-energies", bounce_energies(drop, settings)),
    ];
    if let Ok(found) = &drop.estimate {
        figures.push(Illustration::new("posterior", corner(found)));
        figures.push(Illustration::new("residuals", residuals(found)));
        figures.push(Illustration::new("budget", budget(found)));
        figures.extend(models(found).map(|drawn| Illustration::new("models", drawn)));
        figures.extend(cut(drop, settings).map(|drawn| Illustration::new("cut", drawn)));
    }
    figures
}

/// The figures of the air, up to the fastest impact of the drops; none if no speed is known.
pub fn of_air(drops: &[Drop], settings: &Options) -> Vec<Illustration> {
    let fastest_m_s = drops
        .iter()
        .filter_map(Drop::speed_range_m_s)
        .map(|(_, fastest)| fastest)
        .reduce(f64::max);
    let Some(fastest_m_s) = fastest_m_s else {
        return Vec::new();
    };
    let linear = drag(settings, fastest_m_s).map(|drawn| Illustration::new("drag", drawn));
    let log = drag_log(settings, fastest_m_s).map(|drawn| Illustration::new("drag-log", drawn));
    linear.into_iter().chain(log).collect()
}
