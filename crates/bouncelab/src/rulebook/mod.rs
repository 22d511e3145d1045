//! Conformity of a ball or a floor with a rule, and its probability.
//!
//! A rule states its procedure: from which height a ball is dropped, how often, in how many places, under which conditions,
//! by which formula the height of the first rebound follows, and how high it must be, or how high compared with a reference
//! surface. A verdict is computed so, with the uncertainty of the result; what the model ([`crate::inference`]) answers
//! stands beside it.
//!
//! A verdict is *conforms*, *does not conform* or *cannot decide*, by a stated decision rule in the sense of JCGM 106:2012:
//! with guarded acceptance, the default, a ball conforms only if the probability that it is outside the
//! limits all the same is at most the accepted risk. It *conforms as far as shown* if parts of the procedure, as the
//! temperature, are not shown.
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
//! // Nothing shows from which height the ball was dropped.
//! assert_eq!(verdict.outcome, Outcome::ConformsAsFarAsShown);
//! assert!(verdict.wrong_accept().unwrap() < 0.05);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod budget;
mod inconclusive;
mod precision;
mod procedure;
mod rebound;
mod rule;
mod verdict;

pub use budget::{Cause, Component, MeanRebound};
pub use inconclusive::{InconclusiveReason, Remark};
pub use precision::Precision;
pub use procedure::{Check, Conditions, Item, Kept};
pub use rebound::Rebound;
pub use rule::{
    Averaging, Evenness, Formula, Limits, Point, Reading, Requirement, Rule, Source, find,
};
pub use verdict::{Decision, Outcome, Place, Verdict, judge, judge_rebounds};
