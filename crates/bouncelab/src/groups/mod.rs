//! Statistics of many drops: by ball, surface, operator, or other metadata.
//!
//! Every drop has one value, say the restitution at a speed, with a standard error of its own. But
//! drops differ by more than their errors: each finds another spot of the surface. So the mean of a
//! group is that of a random-effects model, y = m + b + r, with a scatter b between drops beside the
//! known error r of each. What all drops share, such as the drag law, does not average out and is
//! kept apart by those who call.
//!
//! | module | question that it answers |
//! |---|---|
//! | [`mean`](Mean) | what is the mean of a group, and how do its drops scatter? |
//! | [`mixed`](Mixed) | who varies: ball, surface, operator or drop? |
//! | [`compare`](compare()) | by how much do two groups differ? |
//! | [`outlier`](outliers()) | which drops do not belong to their group? |
//! | [`plan`](drops_needed()) | how many drops does a wanted uncertainty take? |
//! | [`law`](RestitutionCurve) | what does a drop know of its restitution, at speeds that all drops share? |
//! | [`apart`](VarianceComponent) | which factors can be told apart, and what does each of them do? |
//! | [`study`](Study) | all of it at once |
//!
//! ```
//! use bouncelab::inference::Measured;
//! use bouncelab::groups::Mean;
//!
//! let drops = [0.921, 0.924, 0.919, 0.926].map(|value| Measured { value, sd: 0.001 });
//! let mean = Mean::of(&drops)?;
//! assert_eq!(format!("{:.4}", mean.value), "0.9225");
//! // Equal errors: the standard error is that of any mean, scatter over root n.
//! assert_eq!(format!("{:.4}", mean.standard_error), "0.0016");
//! let [low, high] = mean.interval95.unwrap();
//! assert!(low < 0.918 && high > 0.927);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod compare;
mod components;
mod curve;
mod mean;
mod mixed;
mod outlier;
mod plan;
mod quantile;
mod reml;
mod study;

pub use compare::{Difference, compare, compare_means};
pub use components::{Covariate, Trend, VarianceComponent};
pub use curve::{CurvePoint, RestitutionCurve};
pub use mean::Mean;
pub use mixed::{Component, Drop, Factor, Mixed};
pub use outlier::{OUTLIER_THRESHOLD, Outlier, outliers};
pub use plan::{MAX_DROPS, drops_needed, run_limit};
pub use study::{Group, MeanAtSpeed, Study, StudyDrop};
