//! From the draws of the posterior to the estimates.

use super::candidates::{FittedSpeeds, SampledPosterior};
use super::likelihood::Innovation;
use super::medium::Medium;
use super::parameters::{
    MAX_REMAINING_RESTITUTION, MAX_TERMINAL_SPEED_STEPS, MIN_SHARE_AT_REST, NEWTON_TOLERANCE,
    ROUND_SPEEDS_M_S, SPARSE, THINNING,
};
use super::pool::DrawnDrop;
use super::posterior::{Draws, ImpactPosterior, Model, Posterior, Sampling};
use super::predict::Rest;
use super::priors::Measured;
use super::unknowns::Point;
use super::{ApexTarget, InferenceOptions, Prediction, budget, findings, identify, predict};
use crate::diagnostic::{Code, Diagnostic};
use crate::drag::DragLaw;
use crate::error::{Error, InferenceFailure, Result};
use crate::estimate::Estimate;
use crate::flight::FlightModel;
use crate::stats::sort_by_number;

/// The drag of the ball.
struct Drag {
    coefficient: Estimate,
    reynolds: f64,
    prior: Measured,
    terminal_speed_m_s: Option<Estimate>,
}

/// The answers of each draw.
pub(super) struct Answers {
    at_speed_m_s: f64,
    points: Vec<Point>,
    restitution: Vec<f64>,
    slope: Vec<f64>,
    drop_height_m: Vec<f64>,
}

impl Answers {
    pub(super) fn new(posterior: &SampledPosterior, at_speed_m_s: f64) -> Option<Self> {
        let rows = posterior.each(1, |model, point| {
            let (restitution, log_slope) = point.law.at_with_log_slope(at_speed_m_s);
            let drop_height_m = model.drop_height_m(point)?;
            Some((*point, [restitution, -log_slope, drop_height_m]))
        });
        if rows.len() != posterior.draws.len() || rows.is_empty() {
            return None;
        }
        let column = |index: usize| rows.iter().map(|(_, row)| row[index]).collect();
        Some(Self {
            at_speed_m_s,
            points: rows.iter().map(|(point, _)| *point).collect(),
            restitution: column(0),
            slope: column(1),
            drop_height_m: column(2),
        })
    }

    /// `Ok` if the impacts determine the restitution.
    ///
    /// # Errors
    /// [`InferenceFailure::RestitutionUndetermined`].
    pub(super) fn check_restitution(&self, impacts: usize) -> Result<()> {
        let found = Estimate::of_draws(self.restitution.iter().copied());
        let undetermined = found.filter(|it| {
            // Before the data it is uniform from 0 to 1, with variance 1/12.
            it.sd * 12.0_f64.sqrt() > MAX_REMAINING_RESTITUTION
        });
        undetermined.map_or(Ok(()), |it| {
            let [low, high] = it.interval95;
            let reason = InferenceFailure::RestitutionUndetermined { impacts, low, high };
            Err(Error::CannotInfer(reason))
        })
    }

    /// A number of the point of each draw.
    fn of_points(&self, number: impl Fn(&Point) -> f64) -> Vec<f64> {
        self.points.iter().map(number).collect()
    }

    #[expect(
        clippy::too_many_lines,
        reason = "one field of the result after the other"
    )]
    pub(super) fn inference(
        self,
        posterior: SampledPosterior,
        speeds: FittedSpeeds,
        inference: &InferenceOptions,
    ) -> Option<Posterior> {
        let of = |values: &[f64]| posterior.estimate(1, values.iter().copied());
        let innovations = posterior.innovations();
        let weights = weights(&posterior, &innovations);
        let sigma_s = &posterior.observed().sigma_s;
        let squares: f64 = sigma_s.iter().map(|s| s * s).sum();
        let rms_s = (squares / sigma_s.len() as f64).sqrt();
        let contact_time_s = self.of_points(|point| point.contact_time_s);
        let prior_contraction = identify::prior_contraction(&posterior);
        // Time and path until rest take few whole drops, the results of each impact many.
        let every = if inference.each_impact {
            THINNING
        } else {
            SPARSE
        };
        let mut drops = posterior.drops(&self.points, every);
        let rest: Vec<Rest> = drops.iter().filter_map(|drop| drop.rest).collect();
        let rests = rest.len() as f64 >= MIN_SHARE_AT_REST * drops.len() as f64 && !rest.is_empty();
        let of_rest = |number: fn(Rest) -> f64| {
            let numbers = drops.iter().map(|drop| drop.rest.map_or(f64::NAN, number));
            posterior.estimate(every, numbers).filter(|_| rests)
        };
        let (total_time_s, total_path_m) = (of_rest(|it| it.time_s), of_rest(|it| it.path_m));
        let rest = if rests { rest } else { Vec::new() };
        if !inference.each_impact {
            drops.clear();
        }
        let drag_coefficient = self.drag_coefficients(&posterior);
        let drag = self.drag(&posterior, &drag_coefficient);
        let gravity_m_s2 = of(&self.environment_gravity(&posterior))?;
        let restitution_scatter = of(&self.of_points(|point| point.scatter))?;
        let mut diagnostics = findings::diagnostics(&posterior, &innovations);
        if inference.each_impact && !rests {
            diagnostics.push(Diagnostic::new(Code::NeverRests));
        }
        diagnostics.extend(findings::scattered(&posterior, restitution_scatter.value));
        let (e, h) = (of(&self.restitution)?.value, of(&self.drop_height_m)?.value);
        diagnostics.extend(findings::doubled(&posterior, e, h));
        let fitted = speeds.slowest_m_s..=speeds.fastest_m_s;
        let mut round = ROUND_SPEEDS_M_S.into_iter();
        let round_speed_m_s = round.find(|speed| fitted.contains(speed));
        let mut inferred = Posterior {
            at_speed_m_s: self.at_speed_m_s,
            restitution: of(&self.restitution)?,
            first_speed_m_s: speeds.first_m_s,
            energy_kept: of(&self.of_points(|point| point.law.at(speeds.first_m_s).powi(2)))?,
            round_speed_m_s,
            round_speed_restitution: round_speed_m_s
                .and_then(|speed| of(&self.of_points(|point| point.law.at(speed)))),
            restitution_slope: of(&self.slope)?,
            drop_height_m: of(&self.drop_height_m)?,
            drag_coefficient: drag.as_ref().map(|drag| drag.coefficient),
            drag_reynolds: drag.as_ref().map(|drag| drag.reynolds),
            drag_coefficient_prior: drag.as_ref().map(|drag| drag.prior),
            terminal_speed_m_s: drag.and_then(|drag| drag.terminal_speed_m_s),
            gravity_m_s2,
            restitution_scatter,
            timing_s: of(&self.of_points(|point| point.timing * rms_s))?,
            contact_time_s: of(&contact_time_s)?,
            total_time_s,
            total_path_m,
            missed_first_impacts: missed_first(&posterior),
            first_is_other_sound: other_sound(&posterior),
            predictions: predictions(&posterior, &inference.reach),
            impacts: detected(&posterior, &drops, &innovations, &weights),
            models: self.models(&posterior),
            log_evidence: posterior.log_evidence(),
            prior_contraction,
            correlations: identify::correlations(vec![
                ("restitution", self.restitution.clone()),
                ("slope", self.slope.clone()),
                ("drag", self.of_points(|point| point.drag_scale)),
                ("drop-height", self.drop_height_m.clone()),
                ("gravity", self.of_points(|point| point.gravity_m_s2)),
                ("contact-time", contact_time_s),
            ]),
            budget: budget::budget(
                &posterior,
                self.at_speed_m_s,
                &self.restitution,
                &self.drop_height_m,
            )
            .unwrap_or_default(),
            sampling: Sampling {
                effective_draws: posterior.effective_draws(),
                pareto_shape: posterior.pareto_shape(),
            },
            priors: posterior.priors.diagnostics(),
            band: Vec::new(),
            diagnostics,
            draws: Draws {
                restitution: self.restitution,
                drag_coefficient,
                drop_height_m: self.drop_height_m,
                total_time_s: if inference.each_impact {
                    rest.iter().map(|rest| rest.time_s).collect()
                } else {
                    Vec::new()
                },
            },
            fitted_speeds_m_s: [speeds.slowest_m_s, speeds.fastest_m_s],
            weights,
            sampled: posterior,
        };
        inferred.band = inferred.compute_band();
        inferred.sampled.forget_flights();
        Some(inferred)
    }

    /// The drag coefficient of each draw: that of its law at the fastest impact, times the scale.
    fn drag_coefficients(&self, posterior: &SampledPosterior) -> Vec<f64> {
        let environment = &posterior.environment;
        if environment.air.is_vacuum() || environment.drag == DragLaw::None {
            return Vec::new();
        }
        let nominal: Vec<f64> = posterior
            .media
            .iter()
            .map(|medium| {
                let reynolds = fastest_reynolds(posterior, medium);
                let coefficient = environment.drag.coefficient(reynolds);
                coefficient.unwrap_or(f64::NAN)
            })
            .collect();
        let of_draw = posterior.draws.iter().zip(&self.points);
        of_draw
            .map(|(draw, point)| {
                point.drag_scale * nominal[posterior.candidates[draw.candidate].medium]
            })
            .collect()
    }

    fn drag(&self, posterior: &SampledPosterior, coefficients: &[f64]) -> Option<Drag> {
        let coefficient = posterior.estimate(1, coefficients.iter().copied())?;
        let best = posterior.medium_of(0);
        let reynolds = fastest_reynolds(posterior, best);
        let nominal = posterior.environment.drag.coefficient(reynolds).ok()?;
        let of_draw = posterior.draws.iter().zip(&self.points);
        let terminal = of_draw.step_by(THINNING).map(|(draw, point)| {
            let medium = posterior.medium_of(draw.candidate);
            terminal_speed(&medium.model, point.drag_strength).unwrap_or(f64::NAN)
        });
        Some(Drag {
            coefficient,
            reynolds,
            prior: Measured {
                value: nominal,
                sd: nominal * best.drag_sd,
            },
            terminal_speed_m_s: posterior.estimate(THINNING, terminal),
        })
    }

    /// Gravity itself, of each draw.
    fn environment_gravity(&self, posterior: &SampledPosterior) -> Vec<f64> {
        let of_draw = posterior.draws.iter().zip(&self.points);
        of_draw
            .map(|(draw, point)| {
                posterior.gravity_itself(posterior.medium_of(draw.candidate), point)
            })
            .collect()
    }

    /// The table of models, with the numbers of missed impacts added up.
    fn models(&self, posterior: &SampledPosterior) -> Vec<Model> {
        let mut models: Vec<Model> = Vec::new();
        for candidate in &posterior.candidates {
            let kind = posterior.media[candidate.medium].kind;
            let ball = (!kind.is_empty()).then_some(kind);
            let known = models
                .iter_mut()
                .find(|model| model.restitution_law == candidate.law && model.ball == ball);
            if let Some(model) = known {
                model.probability += candidate.weight;
                continue;
            }
            let of_model = |values: &[f64]| {
                let of_draw = posterior.draws.iter().zip(values);
                Estimate::of_draws(of_draw.filter_map(|(draw, &value)| {
                    let drawn = &posterior.candidates[draw.candidate];
                    let same = drawn.law == candidate.law && drawn.medium == candidate.medium;
                    same.then_some(value)
                }))
            };
            models.push(Model {
                restitution_law: candidate.law,
                ball,
                probability: candidate.weight,
                log_odds: 0.0,
                restitution: of_model(&self.restitution),
                drop_height_m: of_model(&self.drop_height_m),
            });
        }
        sort_by_number(&mut models, |model| -model.probability);
        let best = models.first().map_or(1.0, |model| model.probability);
        for model in &mut models {
            model.log_odds = (model.probability / best).ln();
        }
        models
    }
}

impl SampledPosterior {
    /// Gravity itself, of which the effective gravity is only a part: the rest of what moved that
    /// belongs to buoyancy and added mass.
    pub(super) fn gravity_itself(&self, medium: &Medium, point: &Point) -> f64 {
        let change = point.gravity_m_s2 / medium.gravity_m_s2;
        self.environment.gravity_m_s2 * change.powf(medium.inputs.gravity_share())
    }
}

/// The Reynolds number of the fastest impact detected, where drag is strongest.
fn fastest_reynolds(posterior: &SampledPosterior, medium: &Medium) -> f64 {
    let air = &posterior.environment.air;
    air.reynolds(&medium.ball, posterior.reference.speeds.fastest_m_s)
}

fn predictions(posterior: &SampledPosterior, reach: &[ApexTarget]) -> Vec<Prediction> {
    let height = |reach: ApexTarget| {
        posterior.each(THINNING, |model, point| {
            let height_m = predict::drop_height_for(model, point, reach.bounce, reach.apex_m);
            Some(height_m.unwrap_or(f64::NAN))
        })
    };
    reach
        .iter()
        .map(|&target| Prediction {
            target,
            drop_height_m: posterior.estimate(THINNING, height(target)),
        })
        .collect()
}

/// Probability that the first impact detected is another sound.
fn other_sound(posterior: &SampledPosterior) -> f64 {
    let left_out = posterior.left_out.first();
    let probability = left_out.and_then(|it| it.number("probability"));
    probability.unwrap_or_else(|| posterior.first_is_other_sound())
}

/// Probabilities of numbers of missed impacts, if a height or a release determines them.
fn missed_first(posterior: &SampledPosterior) -> Option<Vec<f64>> {
    if !posterior.priors.determine_missed() {
        return None;
    }
    let most = posterior.candidates.iter().map(|c| c.missed_first).max()?;
    let mut probabilities = vec![0.0; most + 1];
    for candidate in &posterior.candidates {
        probabilities[candidate.missed_first] += candidate.weight;
    }
    Some(probabilities)
}

/// The speed at which drag balances weight, by Newton on the logarithms, from where it would be for
/// a constant coefficient.
fn terminal_speed(model: &FlightModel, drag_strength: f64) -> Option<f64> {
    let mut speed = model.terminal_speed_m_s()? / drag_strength.sqrt();
    for _ in 0..MAX_TERMINAL_SPEED_STEPS {
        // Drag goes about as the square of the speed.
        let step = -0.5 * (drag_strength * model.drag_over_weight(speed).ok()?).ln();
        speed *= step.exp();
        if step.abs() < NEWTON_TOLERANCE {
            break;
        }
    }
    Some(speed)
}

/// The innovation of an impact, by its index; `None` for the last impact, which no flight follows.
fn innovation_of(
    innovations: &[Innovation],
    intervals: usize,
    impact: usize,
) -> Option<&Innovation> {
    let innovation = innovations.iter().rfind(|it| it.impact == impact);
    innovation.filter(|_| impact < intervals)
}

/// The weight of each impact detected in the fit.
fn weights(posterior: &SampledPosterior, innovations: &[Innovation]) -> Vec<f64> {
    let intervals = posterior.observed().intervals.len();
    let weight = |impact| innovation_of(innovations, intervals, impact).map_or(1.0, |it| it.weight);
    (0..=intervals).map(weight).collect()
}

/// The impacts detected, with the changes of speed and energy at each.
fn detected(
    posterior: &SampledPosterior,
    drops: &[DrawnDrop],
    innovations: &[Innovation],
    weights: &[f64],
) -> Vec<ImpactPosterior> {
    let intervals = &posterior.observed().intervals;
    let impacts = posterior.observed().impacts.iter().enumerate();
    let left_out = usize::from(posterior.observed().other_sound.is_some());
    impacts
        .filter_map(|(index, impact)| {
            let launches = intervals.get(index).is_some();
            let single = intervals.get(index).is_some_and(|s| s.flights == 1);
            let innovation = innovation_of(innovations, intervals.len(), index);
            let energy = |drop: &DrawnDrop, faster: f64, slower: f64| {
                0.5 * drop.mass_kg * (faster * faster - slower * slower)
            };
            // A drop without the first impact detected has no state of it.
            let index_in =
                |drop: &DrawnDrop| (index + left_out).checked_sub(usize::from(drop.without_first));
            let when = |possible: bool, value: &dyn Fn(&DrawnDrop, usize) -> f64| {
                let values = drops.iter().map(|drop| {
                    let index = index_in(drop);
                    index.map_or(f64::NAN, |index| value(drop, index))
                });
                if possible {
                    posterior.estimate(THINNING, values)
                } else {
                    None
                }
            };
            let before = |drop: &DrawnDrop, index: usize| drop.state.impact_speeds[index];
            let after = |drop: &DrawnDrop, index: usize| drop.state.launch_speeds[index];
            Some(ImpactPosterior {
                number: impact.number,
                impact_speed_m_s: when(true, &before)?,
                restitution: when(launches, &|drop, index| {
                    after(drop, index) / before(drop, index)
                }),
                apex_m: when(launches, &|drop, index| drop.state.apexes_m[index]),
                lost_to_surface_j: when(launches, &|drop, index| {
                    energy(drop, before(drop, index), after(drop, index))
                }),
                lost_to_air_j: when(single, &|drop, index| {
                    energy(drop, after(drop, index), before(drop, index + 1))
                }),
                standardised_residual: innovation.map(|i| i.standardised),
                weight: weights[index],
            })
        })
        .collect()
}
