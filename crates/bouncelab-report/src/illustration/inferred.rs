//! The figures of the inference.

use bouncelab::analysis::{self, Drop, Options};
use bouncelab::inference::{InferenceOptions, Posterior, SamplerConfig, Share};

use crate::figure::{
    self, BandPoint, Budget, CornerParameter, CutPoint, CutSeries, Figure, ModelWeight, Residual,
    Source,
};
use crate::quantity::{Quantity, Unit};
use crate::theme::Meaning;

/// Points along the fitted law.
const BAND_POINTS: usize = 60;

/// The fitted law.
pub(super) fn band(found: &Posterior) -> Vec<BandPoint> {
    found
        .band(BAND_POINTS)
        .into_iter()
        .map(|point| BandPoint {
            speed_m_s: point.speed_m_s,
            value: point.restitution.value,
            interval68: point.restitution.interval68,
            interval95: point.restitution.interval95,
        })
        .collect()
}

/// The posterior of restitution, drag coefficient and drop height, each alone and in pairs.
pub fn corner(found: &Posterior) -> Figure {
    let mut parameters = vec![CornerParameter {
        name: "restitution".to_owned(),
        values: found.draws.restitution.clone(),
        prior: None,
    }];
    if let Some(drag) = &found.drag {
        parameters.push(CornerParameter {
            name: "drag coefficient".to_owned(),
            values: found.draws.drag_coefficient.clone(),
            prior: Some((drag.prior.value, drag.prior.sd)),
        });
    }
    let heights = found
        .draws
        .drop_height_m
        .iter()
        .map(|height| height * 100.0);
    parameters.push(CornerParameter {
        name: "height (cm)".to_owned(),
        values: heights.collect(),
        prior: None,
    });
    figure::corner(&parameters)
}

/// How far each impact lies from what the ones before foretold.
pub fn residuals(found: &Posterior) -> Figure {
    let residuals: Vec<Residual> = found
        .impacts
        .iter()
        .filter_map(|impact| {
            Some(Residual {
                number: impact.number as u32,
                standardised: impact.standardised_residual?,
                odd: impact.is_odd(),
            })
        })
        .collect();
    figure::residuals(&residuals)
}

/// Where the uncertainty of restitution and drop height comes from.
pub fn budget(found: &Posterior) -> Figure {
    let sources = |shares: &[Share]| {
        shares
            .iter()
            .map(|share| Source {
                name: share.source.to_owned(),
                share: share.share,
            })
            .collect()
    };
    let (e, h) = (&found.restitution, &found.drop_height_m);
    figure::budget(&[
        Budget {
            quantity: format!(
                "restitution: {}",
                Quantity::measured(e.value, e.sd, Unit::Number)
            ),
            sources: sources(&found.budget.restitution),
        },
        Budget {
            quantity: format!(
                "drop height: {}",
                Quantity::measured(h.value, h.sd, Unit::Length)
            ),
            sources: sources(&found.budget.drop_height_m),
        },
    ])
}

/// The laws that were weighed; `None` if there was only one.
pub fn models(found: &Posterior) -> Option<Figure> {
    if found.models.len() < 2 {
        return None;
    }
    let models: Vec<ModelWeight> = found
        .models
        .iter()
        .map(|model| ModelWeight {
            name: format!("{}, {}", model.law, model.drag),
            weight: model.weight,
            value: model
                .drop_height_m
                .map(|h| (h.value * 100.0, h.interval68.map(|end| end * 100.0))),
        })
        .collect();
    Some(figure::models(&models, "drop height (cm)"))
}

/// The drop height from the first flights only: by the straight line, and by the inference, which runs
/// anew for each cut. `None` for a drop too short to cut.
pub fn cut(drop: &Drop, settings: &Options) -> Option<Figure> {
    const CUTS: [usize; 4] = [6, 10, 20, 40];
    /// A figure needs fewer draws than an answer.
    const DRAWS: usize = 600;
    let all = drop.impacts.len() - 1;
    let cuts: Vec<usize> = CUTS
        .into_iter()
        .filter(|&cut| cut < all)
        .chain([all])
        .collect();
    if cuts.len() < 3 {
        return None;
    }
    let mut line = Vec::new();
    let mut inferred = Vec::new();
    for cut in cuts {
        let mut cut_settings = Options {
            flights: Some(1..=drop.impacts[cut].number),
            inference: Some(InferenceOptions {
                sampler: SamplerConfig {
                    draws: DRAWS,
                    seed: 1,
                },
                ..InferenceOptions::default()
            }),
            ..settings.clone()
        };
        // Not to lean on a height that the person stated.
        cut_settings.priors.drop_height_m = None;
        cut_settings.priors.release_s = None;
        let found = analysis::analyze(drop.impacts[..=cut].to_vec(), &cut_settings);
        let point = |value: f64, sd: f64| CutPoint {
            flights: cut as u32,
            value: value * 100.0,
            sd: sd * 100.0,
        };
        if let Ok(fit) = &found.line {
            let height = fit.drop_height_m();
            line.push(point(
                height.value,
                height.standard_error.unwrap_or(f64::NAN),
            ));
        }
        if let Ok(found) = &found.estimate {
            inferred.push(point(found.drop_height_m.value, found.drop_height_m.sd));
        }
    }
    let series = [
        CutSeries {
            name: "straight line".to_owned(),
            meaning: Meaning::NoDrag,
            points: line,
        },
        CutSeries {
            name: "inference, with air".to_owned(),
            meaning: Meaning::Measured,
            points: inferred,
        },
    ];
    let truth = settings.priors.drop_height_m.map(|h| h.value * 100.0);
    Some(figure::cut(&series, "drop height (cm)", truth))
}
