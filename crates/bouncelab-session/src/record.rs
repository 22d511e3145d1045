//! The record of one recording, and the analysis that makes it.

use std::io::Seek;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

use bouncelab::analysis::{Drop, MeasuredFlight, Recording};
use bouncelab::diagnostic::Code;
use bouncelab::groups::RestitutionCurve;
use bouncelab::inference::Posterior;
use bouncelab::restitution::ImpactRestitution;
use bouncelab::{Diagnostic, Estimate, Impact, Options, Plain};
use bouncelab_audio::Input;
use serde::{Deserialize, Serialize};

use crate::hash::{self, Hash, hash, hash_of_all};

/// Name and version of the form of a [`Record`]: another whenever a record of before could not be read,
/// or would say something else.
pub const RECORD: &str = "bouncelab.record/2";

/// What one recording says.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Its drops, in order of time.
    pub drops: Vec<DropRecord>,
    /// Why there is none.
    pub no_drop: Option<Diagnostic>,
    /// Why it could not be read or analysed.
    pub failure: Option<String>,
    /// What is odd about it.
    pub diagnostics: Vec<Diagnostic>,
}

/// What one drop says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DropRecord {
    /// Probability that it is a drop.
    pub probability: f64,
    /// Its impacts, in order of time.
    pub impacts: Vec<ImpactRecord>,
    /// The log-linear fit: the straight line through the logarithms of the flight times.
    pub log_linear_fit: Option<FitRecord>,
    /// What all of it says together.
    pub posterior: Option<PosteriorRecord>,
    /// Why there is no posterior.
    pub no_posterior: Option<Diagnostic>,
    /// What is odd about it.
    pub diagnostics: Vec<Diagnostic>,
}

/// One impact and the flight after it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ImpactRecord {
    /// The impact.
    pub impact: Impact,
    /// What it kept of the speed.
    pub restitution: Option<ImpactRestitution>,
    /// The flight after it.
    pub flight: Option<MeasuredFlight>,
    /// Its weight in the inference.
    pub weight: Option<f64>,
}

/// The answers of the log-linear fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FitRecord {
    /// Restitution.
    pub restitution: Estimate,
    /// Drop height, m.
    pub drop_height_m: Estimate,
}

/// The answers of the inference by which drops are compared.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PosteriorRecord {
    /// The impact speed of [`Self::restitution`], m/s.
    pub at_speed_m_s: f64,
    /// Restitution at that speed.
    pub restitution: Estimate,
    /// Height of the fall, m.
    pub drop_height_m: Estimate,
    /// Drag coefficient at the fastest impact.
    pub drag_coefficient: Option<Estimate>,
    /// Standard deviation of ln e from impact to impact.
    pub restitution_scatter: Estimate,
    /// Root mean square standard error of the times, s.
    pub timing_s: Estimate,
    /// Probabilities of 0, 1, 2, ... impacts before the first one detected.
    pub missed_first_impacts: Option<Vec<f64>>,
    /// Whether the sampling can be trusted.
    pub converged: bool,
    /// Restitution at speeds that all drops share.
    pub curve: RestitutionCurve,
}

impl Record {
    /// What the content of a file says: nothing else matters but its name, which tells lists of times
    /// from sound, and the options.
    ///
    /// ```
    /// use bouncelab::Options;
    /// use bouncelab_session::Record;
    ///
    /// let times = b"0\n0.4605\n0.8877\n1.2854\n1.6568\n2.0045\n";
    /// let options = Options::default().without_inference();
    /// let record = Record::of_bytes(&times[..], "drop.txt", &options);
    /// assert_eq!(record.drops[0].impacts.len(), 6);
    /// ```
    pub fn of_bytes(bytes: impl Into<Arc<[u8]>>, name: &str, options: &Options) -> Self {
        let bytes = bytes.into();
        let content = hash(&bytes);
        Self::of(content, name, options, || Input::from_bytes(bytes, name))
    }

    /// What a file with this content says; `None` if it has another one, or gets it meanwhile.
    pub fn of_file(path: &Path, content: Hash, options: &Options) -> Option<Self> {
        let name = String::from(Plain::path(path));
        let file = hash::open(path).ok()?;
        let mut same = file.try_clone().ok()?;
        let record = Self::of(content, &name, options, || Input::from_reader(file, &name));
        // Of what was read, whatever has the name by now; and after it, since it may be written into.
        same.rewind().ok()?;
        (hash_of_all(same).ok()? == content).then_some(record)
    }

    pub(crate) fn of(
        content: Hash,
        name: &str,
        options: &Options,
        open: impl FnOnce() -> bouncelab_audio::Result<Input>,
    ) -> Self {
        let mut options = options.clone();
        if let Some(inference) = &mut options.inference {
            // Equal seeds would give the errors of sampling of all drops the same sign.
            inference.sampler.seed ^= content.number();
            // Drops are compared by their restitution and height.
            inference.each_impact = false;
        }
        // A fault of the program in one recording must not end the work on others.
        let analysed = catch_unwind(AssertUnwindSafe(|| analyze(open()?, &options)));
        match analysed {
            Ok(Ok(recording)) => Self::from(&recording),
            Ok(Err(failure)) => Self::failed(failure.to_string()),
            Err(_) => Self::failed(format!(
                "{name}: the analysis failed by a fault of the program; please report it"
            )),
        }
    }

    pub(crate) fn failed(reason: String) -> Self {
        Self {
            failure: Some(reason),
            ..Self::default()
        }
    }
}

/// Every drop of an opened file.
fn analyze(input: Input, options: &Options) -> Result<Recording, Box<dyn std::error::Error>> {
    let plan = input.plan::<Box<dyn std::error::Error>>(options, |_| Ok(()))?;
    Ok(plan.run())
}

impl From<&Recording> for Record {
    fn from(recording: &Recording) -> Self {
        Self {
            drops: recording.drops.iter().map(DropRecord::from).collect(),
            no_drop: recording.no_drop.clone(),
            failure: None,
            diagnostics: recording.diagnostics.clone(),
        }
    }
}

impl From<&Drop> for DropRecord {
    fn from(drop: &Drop) -> Self {
        let posterior = drop.posterior.as_ref();
        let weight = |number: usize| posterior.ok()?.weight(number);
        let impacts = drop.impacts.iter().map(|&impact| ImpactRecord {
            impact,
            restitution: drop.impact_restitution(impact.number).copied(),
            flight: drop.flight(impact.number).copied(),
            weight: weight(impact.number),
        });
        let fit = drop.log_linear_fit.as_ref().ok();
        Self {
            probability: drop.probability,
            impacts: impacts.collect(),
            log_linear_fit: fit.map(|fit| FitRecord {
                restitution: fit.restitution,
                drop_height_m: fit.drop_height_m,
            }),
            posterior: posterior.ok().map(PosteriorRecord::from),
            no_posterior: posterior.err().map(bouncelab::Error::diagnostic),
            diagnostics: drop
                .diagnostics
                .iter()
                .filter(|known| is_odd(known))
                .cloned()
                .collect(),
        }
    }
}

/// Whether a diagnostic says something of this drop, and not of all drops like it.
fn is_odd(diagnostic: &Diagnostic) -> bool {
    !matches!(
        diagnostic.code,
        Code::HeightOfFirstDetected
            | Code::DragFromPrior
            | Code::DragOrSlope
            | Code::NoLawWins
            | Code::ImpactsOdd
    )
}

impl From<&Posterior> for PosteriorRecord {
    fn from(posterior: &Posterior) -> Self {
        Self {
            at_speed_m_s: posterior.at_speed_m_s,
            restitution: posterior.restitution,
            drop_height_m: posterior.drop_height_m,
            drag_coefficient: posterior.drag_coefficient,
            restitution_scatter: posterior.restitution_scatter,
            timing_s: posterior.timing_s,
            missed_first_impacts: posterior.missed_first_impacts.clone(),
            converged: posterior.sampling.converged,
            curve: RestitutionCurve::from(posterior),
        }
    }
}

impl PosteriorRecord {
    /// The most probable number of impacts missed before the first one detected.
    pub fn missed_first(&self) -> Option<usize> {
        let numbered = self.missed_first_impacts.as_ref()?.iter().enumerate();
        let likeliest = numbered.max_by(|a, b| a.1.total_cmp(b.1))?;
        Some(likeliest.0)
    }
}

impl DropRecord {
    /// Whether the measured height contradicts the flight times.
    pub fn height_contradicts(&self) -> bool {
        let mut diagnostics = self.diagnostics.iter();
        diagnostics.any(|diagnostic| diagnostic.code == Code::HeightContradictsTimes)
    }
}
