//! What the journal keeps of a recording.

use bouncelab::analysis::Drop;
use bouncelab::groups::{CurvePoint, RestitutionCurve};
use bouncelab::inference::{Measured, Posterior, Remark, Summary};
use bouncelab::regression::Estimate;
use serde::{Deserialize, Serialize};

/// Changes whenever a record of before could not be read, or would say something else.
pub const RECORD: &str = "bouncelab.record/1";

/// What one recording says.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Record {
    /// Length in seconds, if it is sound.
    pub duration_s: Option<f64>,
    /// Its drops, in order of time.
    pub drops: Vec<DropRecord>,
    /// Why there is none.
    pub no_drop: Option<String>,
    /// Why it could not be read.
    pub failure: Option<String>,
    /// What is odd about it.
    pub warnings: Vec<String>,
}

/// What one drop says.
#[derive(Debug, Serialize, Deserialize)]
pub struct DropRecord {
    /// That it is a drop.
    pub probability: f64,
    pub impacts: Vec<ImpactRecord>,
    pub line: Option<LineRecord>,
    pub estimate: Option<EstimateRecord>,
    /// Why there is no estimate.
    pub no_estimate: Option<String>,
    /// What is odd about it, in words.
    pub remarks: Vec<String>,
}

/// One impact and the flight after it.
#[derive(Debug, Serialize, Deserialize)]
pub struct ImpactRecord {
    pub number: usize,
    pub time_s: f64,
    pub sigma_s: Option<f64>,
    pub probability: f64,
    pub level_db: Option<f64>,
    pub impact_speed_m_s: Option<f64>,
    pub restitution: Option<f64>,
    pub restitution_sd: Option<f64>,
    pub plain_restitution: Option<f64>,
    pub flight_time_s: Option<f64>,
    pub plain_height_m: Option<f64>,
    pub apex_m: Option<f64>,
    /// Its weight in the inference.
    pub weight: Option<f64>,
}

/// The straight line.
#[derive(Debug, Serialize, Deserialize)]
pub struct LineRecord {
    pub restitution: Value,
    pub drop_height_m: Value,
}

/// The inference.
#[derive(Debug, Serialize, Deserialize)]
pub struct EstimateRecord {
    pub at_speed_m_s: f64,
    pub restitution: Value,
    pub drop_height_m: Value,
    pub drag_coefficient: Option<Value>,
    pub scatter: Value,
    pub timing_s: Value,
    /// Most probable number of impacts missed before the first one heard.
    pub missed_first: Option<usize>,
    pub converged: bool,
    /// Restitution at speeds that all drops share: speed, value, own and shared uncertainty.
    pub law: Vec<[f64; 4]>,
    /// Whether the measured height contradicts the flight times.
    pub height_contradicts: bool,
}

/// A value and its standard uncertainty, where that is known.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Value {
    pub value: f64,
    pub sd: Option<f64>,
}

impl Value {
    /// The value, if its uncertainty is known.
    pub fn measured(self) -> Option<Measured> {
        let Self { value, sd } = self;
        Some(Measured { value, sd: sd? })
    }
}

impl From<Summary> for Value {
    fn from(summary: Summary) -> Self {
        Self {
            value: summary.value,
            sd: finite(summary.sd),
        }
    }
}

impl From<Estimate> for Value {
    fn from(estimate: Estimate) -> Self {
        Self {
            value: estimate.value,
            sd: estimate.standard_error.and_then(finite),
        }
    }
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

impl Record {
    /// A recording that could not be read.
    pub fn failed(reason: String) -> Self {
        Self {
            failure: Some(reason),
            ..Self::default()
        }
    }
}

impl DropRecord {
    /// What to keep of a drop.
    pub fn of(drop: &Drop, probability: f64) -> Self {
        let inferred = drop.estimate.as_ref().ok();
        let remarks = inferred.map_or(&[][..], |found| &found.remarks);
        Self {
            probability,
            impacts: impacts(drop),
            line: drop.line.as_ref().ok().map(|line| LineRecord {
                restitution: line.restitution().into(),
                drop_height_m: line.drop_height_m().into(),
            }),
            estimate: inferred.map(EstimateRecord::of),
            no_estimate: drop.estimate.as_ref().err().map(ToString::to_string),
            remarks: drop
                .warnings
                .iter()
                .map(ToString::to_string)
                .chain(
                    remarks
                        .iter()
                        .filter(|r| is_odd(r))
                        .map(ToString::to_string),
                )
                .collect(),
        }
    }
}

/// Whether a remark says something of this drop, and not of all drops like it.
fn is_odd(remark: &Remark) -> bool {
    !matches!(
        remark,
        Remark::HeightIsOfFirstHeard
            | Remark::DragFromPrior
            | Remark::DragOrSlope
            | Remark::NoLawWins
            | Remark::Odd(_)
    )
}

fn impacts(drop: &Drop) -> Vec<ImpactRecord> {
    let inferred = drop.estimate.as_ref().ok();
    drop.impacts
        .iter()
        .map(|impact| {
            let number = impact.number;
            let flight = drop.flight(number);
            let found = drop.corrected_impact(number);
            let modelled = drop.modelled_flight(number);
            let weighed = inferred.and_then(|found| found.impact(number));
            ImpactRecord {
                number,
                time_s: impact.time_s,
                sigma_s: impact.sigma_s,
                probability: impact.probability,
                level_db: impact.level_db.and_then(finite),
                impact_speed_m_s: found.map(|f| f.impact_speed_m_s),
                restitution: found.map(|f| f.restitution.value),
                restitution_sd: found.and_then(|f| f.restitution.standard_error),
                plain_restitution: found.map(|f| f.raw_ratio),
                flight_time_s: flight.map(|f| f.time_s),
                plain_height_m: flight.map(|f| f.plain_height_m),
                apex_m: modelled.map(|m| m.flight.apex_m),
                weight: weighed.map(|w| w.weight),
            }
        })
        .collect()
}

impl EstimateRecord {
    fn of(found: &Posterior) -> Self {
        let likeliest = |probabilities: &Vec<f64>| {
            let numbered = probabilities.iter().enumerate();
            numbered
                .max_by(|a, b| a.1.total_cmp(b.1))
                .map(|(missed, _)| missed)
        };
        Self {
            at_speed_m_s: found.at_speed_m_s,
            restitution: found.restitution.into(),
            drop_height_m: found.drop_height_m.into(),
            drag_coefficient: found.drag.map(|drag| drag.coefficient.into()),
            scatter: found.scatter.into(),
            timing_s: found.timing_s.into(),
            missed_first: found.missed_first.as_ref().and_then(likeliest),
            converged: found.sampling.converged,
            law: law(found)
                .0
                .iter()
                .map(|point| [point.speed_m_s, point.value, point.own_sd, point.shared_sd])
                .collect(),
            height_contradicts: found
                .remarks
                .iter()
                .any(|remark| matches!(remark, Remark::HeightContradicts { .. })),
        }
    }

    /// Restitution at speeds that all drops share.
    pub fn law(&self) -> RestitutionCurve {
        let points = self
            .law
            .iter()
            .map(|&[speed_m_s, value, own_sd, shared_sd]| CurvePoint {
                speed_m_s,
                value,
                own_sd,
                shared_sd,
            });
        RestitutionCurve(points.collect())
    }
}

/// Restitution at the speeds of [`RestitutionCurve::speeds`] within those of the impacts heard.
fn law(found: &Posterior) -> RestitutionCurve {
    let speeds = found
        .impacts
        .iter()
        .filter(|impact| impact.restitution.is_some())
        .map(|impact| impact.impact_speed_m_s.value);
    let (slowest, fastest) = speeds.fold((f64::INFINITY, 0.0), |(slowest, fastest), speed| {
        (speed.min(slowest), speed.max(fastest))
    });
    let speeds = RestitutionCurve::speeds(slowest, fastest);
    let shared = found.shared_sd(&speeds).unwrap_or_default();
    let points = found.restitution_at_each(&speeds).into_iter().zip(&speeds);
    RestitutionCurve(
        points
            .enumerate()
            .filter_map(|(place, (summary, &speed_m_s))| {
                let summary = summary.filter(|summary| summary.sd.is_finite())?;
                let shared_sd = shared.get(place).copied().filter(|sd| sd.is_finite());
                // What is not shared is this drop's own: the whole of it where the fit is too odd to be
                // taken apart.
                let shared_sd = shared_sd.unwrap_or(0.0).min(summary.sd);
                Some(CurvePoint {
                    speed_m_s,
                    value: summary.value,
                    own_sd: (summary.sd.powi(2) - shared_sd.powi(2)).sqrt(),
                    shared_sd,
                })
            })
            .collect(),
    )
}
