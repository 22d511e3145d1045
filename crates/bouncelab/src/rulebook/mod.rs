//! Conformity of a ball or a floor with a rule, and its probability.
//!
//! A rule says from which height a ball is dropped and how high it must rebound, or how high compared
//! with a reference surface. What counts is the **rebound**: the apex after the first impact of a drop
//! from the rule's height. It is predicted from everything that the drops said ([`crate::inference`]),
//! so that drops from other heights tell too, and with its uncertainty.
//!
//! A verdict is pass, fail or *cannot decide*, by a stated decision rule in the sense of JCGM 106:2012:
//! with guarded acceptance, the default, a ball passes only if the probability that it is outside the
//! limits all the same is at most the accepted risk.
//!
//! ```
//! use bouncelab::{Options, analyze_times};
//! use bouncelab::inference::{SamplerConfig, Measured, InferenceOptions};
//! use bouncelab::rulebook::{self, Conditions, Decision, Limits, Outcome, Requirement, Rule};
//!
//! let rule = Rule {
//!     requirement: Requirement::Height(Limits::between(0.24, 0.26)),
//!     ..Rule::new("ittf-ball", "Table-tennis ball", 0.305)
//! };
//! let mut settings = Options::default();
//! settings.inference = Some(InferenceOptions { sampler: SamplerConfig { draws: 500, seed: 1 }, ..InferenceOptions::default() });
//! settings.priors.drop_height_m = Some(Measured { value: 0.305, sd: 0.001 });
//! let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984];
//! let recording = analyze_times(&times_s, &settings);
//! let place = vec![&recording.drops[0]];
//! let verdict = rulebook::judge(
//!     &rule, &settings, &Conditions::default(), &[place], &[], Decision::default(),
//! )?;
//! assert_eq!(verdict.outcome, Outcome::Pass);
//! assert!(verdict.wrong_accept().unwrap() < 0.05);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod inconclusive;
mod pool;
mod rebound;
mod rule;
mod verdict;

pub use inconclusive::{InconclusiveReason, Remark};
pub use rebound::{Correction, Rebound, Step};
pub use rule::{
    Averaging, Conditions, Evenness, Formula, Limits, Point, Requirement, Rule, Status, find,
};
pub use verdict::{Decision, Outcome, Place, Verdict, judge};
