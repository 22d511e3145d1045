//! The inference as data: `drops[].estimate`.

use bouncelab::inference::{self as inference, Posterior};
use serde::Serialize;

/// The posterior of one quantity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "Posterior"))]
pub(super) struct Summary {
    /// The median.
    value: f64,
    /// Standard deviation.
    sd: f64,
    interval68: [f64; 2],
    interval95: [f64; 2],
}

impl From<inference::Summary> for Summary {
    fn from(summary: inference::Summary) -> Self {
        let inference::Summary {
            value,
            sd,
            interval68,
            interval95,
        } = summary;
        Self {
            value,
            sd,
            interval68,
            interval95,
        }
    }
}

pub(super) fn shown(summary: Option<inference::Summary>) -> Option<Summary> {
    summary.map(Summary::from)
}

/// What the times of a drop say, all priors and models considered.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "Posterior"))]
pub(super) struct Estimate {
    restitution: Summary,
    /// The impact speed of `restitution`.
    at_speed_m_s: f64,
    /// -d ln e/d ln v there.
    restitution_slope: Summary,
    drop_height_m: Summary,
    drag_coefficient: Option<Summary>,
    /// The Reynolds number of `drag_coefficient`.
    drag_reynolds: Option<f64>,
    drag_coefficient_prior: Option<Prior>,
    terminal_speed_m_s: Option<Summary>,
    gravity_m_s2: Summary,
    /// Standard deviation of ln e from impact to impact.
    restitution_scatter: Summary,
    timing_s: Summary,
    contact_time_s: Summary,
    total_time_s: Option<Summary>,
    total_path_m: Option<Summary>,
    missed_first_impacts: Option<Vec<f64>>,
    predictions: Vec<Prediction>,
    impacts: Vec<Impact>,
    /// The restitution law over the impact speed.
    band: Vec<BandPoint>,
    models: Vec<Model>,
    prior_contraction: Vec<PriorContraction>,
    correlations: Correlations,
    budget: Budget,
    sampling: Sampling,
    priors: Vec<String>,
    remarks: Vec<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct Prior {
    value: f64,
    sd: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct Prediction {
    bounce: usize,
    apex_m: f64,
    drop_height_m: Option<Summary>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "InferredImpact"))]
#[expect(
    clippy::struct_field_names,
    reason = "the names are those of the schema"
)]
struct Impact {
    number: usize,
    impact_speed_m_s: Summary,
    restitution: Option<Summary>,
    apex_m: Option<Summary>,
    lost_to_surface_j: Option<Summary>,
    lost_to_air_j: Option<Summary>,
    standardised_residual: Option<f64>,
    weight: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct BandPoint {
    speed_m_s: f64,
    restitution: Summary,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "ModelWeight"))]
struct Model {
    restitution_law: String,
    drag_law: String,
    probability: f64,
    log_evidence: f64,
    restitution: Option<Summary>,
    drop_height_m: Option<Summary>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct PriorContraction {
    unknown: String,
    /// Width after the data over width before.
    remaining: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct Correlations {
    quantities: Vec<String>,
    matrix: Vec<Vec<f64>>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct Budget {
    restitution: Vec<Share>,
    drop_height_m: Vec<Share>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[expect(
    clippy::struct_field_names,
    reason = "the names are those of the schema"
)]
struct Share {
    source: String,
    sd: f64,
    share: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct Sampling {
    effective_draws: f64,
    pareto_shape: Option<f64>,
    converged: bool,
}

/// Points of the band: enough for a smooth line.
const BAND_POINTS: usize = 40;

impl From<&Posterior> for Estimate {
    fn from(found: &Posterior) -> Self {
        let drag = found.drag.as_ref();
        Self {
            restitution: found.restitution.into(),
            at_speed_m_s: found.at_speed_m_s,
            restitution_slope: found.slope.into(),
            drop_height_m: found.drop_height_m.into(),
            drag_coefficient: drag.map(|drag| drag.coefficient.into()),
            drag_reynolds: drag.map(|drag| drag.reynolds),
            drag_coefficient_prior: drag.map(|drag| Prior {
                value: drag.prior.value,
                sd: drag.prior.sd,
            }),
            terminal_speed_m_s: drag.and_then(|drag| shown(drag.terminal_speed_m_s)),
            gravity_m_s2: found.gravity_m_s2.into(),
            restitution_scatter: found.scatter.into(),
            timing_s: found.timing_s.into(),
            contact_time_s: found.contact_time_s.into(),
            total_time_s: shown(found.total_time_s),
            total_path_m: shown(found.total_path_m),
            missed_first_impacts: found.missed_first.clone(),
            predictions: found.predictions.iter().map(Prediction::from).collect(),
            impacts: found.impacts.iter().map(Impact::from).collect(),
            band: found
                .band(BAND_POINTS)
                .into_iter()
                .map(|point| BandPoint {
                    speed_m_s: point.speed_m_s,
                    restitution: point.restitution.into(),
                })
                .collect(),
            models: found.models.iter().map(Model::from).collect(),
            prior_contraction: found
                .prior_contraction
                .iter()
                .map(|prior_contraction| PriorContraction {
                    unknown: prior_contraction.unknown.to_string(),
                    remaining: prior_contraction.remaining,
                })
                .collect(),
            correlations: Correlations {
                quantities: found
                    .correlations
                    .quantities
                    .iter()
                    .map(ToString::to_string)
                    .collect(),
                matrix: found.correlations.matrix.clone(),
            },
            budget: Budget {
                restitution: shares(&found.budget.restitution),
                drop_height_m: shares(&found.budget.drop_height_m),
            },
            sampling: Sampling {
                effective_draws: found.sampling.effective_draws,
                pareto_shape: Some(found.sampling.pareto_shape).filter(|shape| shape.is_finite()),
                converged: found.sampling.converged,
            },
            priors: found.priors(),
            remarks: found.remarks.iter().map(ToString::to_string).collect(),
        }
    }
}

fn shares(shares: &[inference::Share]) -> Vec<Share> {
    shares
        .iter()
        .map(|share| Share {
            source: share.source.to_owned(),
            sd: share.sd,
            share: share.share,
        })
        .collect()
}

impl From<&inference::Prediction> for Prediction {
    fn from(prediction: &inference::Prediction) -> Self {
        Self {
            bounce: prediction.reach.bounce,
            apex_m: prediction.reach.apex_m,
            drop_height_m: shown(prediction.drop_height_m),
        }
    }
}

impl From<&inference::Impact> for Impact {
    fn from(impact: &inference::Impact) -> Self {
        Self {
            number: impact.number,
            impact_speed_m_s: impact.impact_speed_m_s.into(),
            restitution: shown(impact.restitution),
            apex_m: shown(impact.apex_m),
            lost_to_surface_j: shown(impact.lost_to_surface_j),
            lost_to_air_j: shown(impact.lost_to_air_j),
            standardised_residual: impact.standardised_residual,
            weight: impact.weight,
        }
    }
}

impl From<&inference::Model> for Model {
    fn from(model: &inference::Model) -> Self {
        Self {
            restitution_law: model.law.to_string(),
            drag_law: model.drag.to_string(),
            probability: model.weight,
            log_evidence: model.log_evidence,
            restitution: shown(model.restitution),
            drop_height_m: shown(model.drop_height_m),
        }
    }
}
