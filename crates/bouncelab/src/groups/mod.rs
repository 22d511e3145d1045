//! Many drops as one model: the restitution curve of each ball and surface, and how drops scatter about it.
//!
//! The likelihood of each drop goes in as it is, at its own impact speeds ([`CurveEvidence`]): high and low drops tell other
//! parts of the curve of their group, and none is left out for its speed. Drops of a group scatter in level, and so may
//! operators; what all drops of a ball share (drag, contact time, gravity) does not average out.
//!
//! | module | question that it answers |
//! |---|---|
//! | [`evidence`](CurveEvidence) | what does one drop say of the curve, without what was assumed before the data? |
//! | [`sums`](GroupSums) | what must be kept of drops, so that a million are studied as one? |
//! | `fit` | which curve has a group, and how do its drops and operators scatter? |
//! | `heights` | from which heights did they fall, and where is the zero of the ruler? |
//! | [`outlier`](outliers()) | which drops do not belong to their group? |
//! | [`plan`](drops_needed()) | how many drops does a wanted uncertainty take? |
//! | [`study`](Study) | all of it at once |
//!
//! ```
//! use bouncelab::groups::{Asked, Study, StudyDrop};
//! use bouncelab::inference::SamplerConfig;
//! use bouncelab::{Options, analyze_times};
//!
//! let options = Options::default().with_sampler(SamplerConfig { draws: 300, seed: 1 });
//! let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984];
//! let drop = |scale: f64| -> bouncelab::Result<StudyDrop> {
//!     let posterior = analyze_times(&times_s.map(|time_s| scale * time_s), &options).drops.remove(0).posterior?;
//!     let evidence = posterior.evidence().unwrap();
//!     Ok(StudyDrop { evidence, scatter: None, levels: Vec::new() })
//! };
//! let study = Study::of(&[drop(1.0)?, drop(0.999)?, drop(1.001)?], &Asked::default())?;
//! let restitution = study.groups[0].restitution.unwrap();
//! assert!((restitution.value - 0.95).abs() < 0.02);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod evidence;
mod fit;
mod heights;
mod mixture;
mod outlier;
mod plan;
mod study;
mod sums;

pub use evidence::{CurveEvidence, HeightEvidence, Reading, SHARED_INPUTS};
pub use outlier::{OUTLIER_THRESHOLD, Outlier, outliers};
pub use plan::{MAX_DROPS, drops_needed, run_limit};
pub use study::{
    Asked, Compared, CurvePoint, Difference, Factor, FittedDrop, Group, MAX_RANDOM, Study,
    StudyDrop,
};
pub use sums::GroupSums;
