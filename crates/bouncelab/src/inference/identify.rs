//! Prior contraction: what the data determine, and what the priors.

use super::candidates::SampledPosterior;
use super::parameters::{CONSTANT_REL_SD, MIN_PART_WITH_UNKNOWN};
use super::unknowns::Slot;
use crate::stats::{mean, sd};

/// An unknown of the inference.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Unknown {
    /// The drag coefficient, as a factor on that of the law.
    Drag,
    /// The slope of restitution over speed, if the law has one.
    Slope,
    /// The scatter of restitution from impact to impact.
    Scatter,
    /// The errors of the times, as a factor on those given.
    Timing,
    /// The contact time.
    ContactTime,
    /// Effective gravity: gravity, buoyancy and added mass.
    Gravity,
}

impl Unknown {
    /// Its stable name, in kebab case.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Drag => "drag",
            Self::Slope => "slope",
            Self::Scatter => "scatter",
            Self::Timing => "timing",
            Self::ContactTime => "contact-time",
            Self::Gravity => "gravity",
        }
    }
}

/// How much the data contracted the prior of an unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct PriorContraction {
    /// The unknown.
    pub unknown: Unknown,
    /// Standard deviation after the data over the one before: 1 if the data contain no information, 0 if they determine it.
    pub remaining: f64,
}

/// How much the data narrowed each unknown, over the models that have it.
pub(super) fn prior_contraction(posterior: &SampledPosterior) -> Vec<PriorContraction> {
    let unknowns = [
        (Unknown::Drag, Slot::Drag),
        (Unknown::Slope, Slot::Shape(0)),
        (Unknown::Scatter, Slot::Scatter),
        (Unknown::Timing, Slot::Timing),
        (Unknown::ContactTime, Slot::Contact),
        (Unknown::Gravity, Slot::Gravity),
    ];
    let models = posterior.models();
    unknowns
        .into_iter()
        .filter_map(|(unknown, slot)| {
            let values: Vec<f64> = posterior
                .draws
                .iter()
                .filter_map(|draw| {
                    let model = &models[draw.candidate];
                    if unknown == Unknown::Slope && !model.has_slope() {
                        return None;
                    }
                    Some(draw.vector[model.index(slot)?])
                })
                .collect();
            // Too few draws would have it for a summary.
            (MIN_PART_WITH_UNKNOWN * values.len() > posterior.draws.len()).then(|| {
                PriorContraction {
                    unknown,
                    // Before the data all of these are standard normals.
                    remaining: sd(&values),
                }
            })
        })
        .collect()
}

/// Correlations between the quantities of interest.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Correlations {
    /// What they are, in order: names as in [`Unknown`], and `restitution` and `drop-height`.
    pub quantities: Vec<&'static str>,
    /// From -1 to 1, one row for each quantity.
    pub matrix: Vec<Vec<f64>>,
}

/// Correlations of columns of equal length; those that do not vary are left out.
pub(super) fn correlations(columns: Vec<(&'static str, Vec<f64>)>) -> Correlations {
    let standardised = columns.into_iter().filter_map(|(name, mut values)| {
        let (mean, sd) = (mean(&values), sd(&values));
        for value in &mut values {
            *value = (*value - mean) / sd;
        }
        (sd > CONSTANT_REL_SD * mean.abs().max(CONSTANT_REL_SD)).then_some((name, values))
    });
    let columns: Vec<_> = standardised.collect();
    let correlation = |a: &[f64], b: &[f64]| {
        let products = a.iter().zip(b).map(|(a, b)| a * b);
        products.sum::<f64>() / a.len() as f64
    };
    Correlations {
        quantities: columns.iter().map(|(name, _)| *name).collect(),
        matrix: columns
            .iter()
            .map(|(_, a)| columns.iter().map(|(_, b)| correlation(a, b)).collect())
            .collect(),
    }
}
