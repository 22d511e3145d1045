//! What the silences can tell, with uncertainties one can defend.
//!
//! The paper fits a straight line to the logarithms of the flight times. Its answer depends on how
//! many flights go into it, because a straight line knows no air, and its standard errors know
//! neither that the errors of neighbouring flights are linked nor that the impacts themselves
//! scatter. Here a physical model of the whole drop explains the times: a fall from a height, air
//! that drags, impacts that obey a restitution law but for scatter, and times with errors. The
//! unknowns have priors that say what is known of balls and rooms ([`Knowledge`]), and the answer is
//! the posterior over all of them and over all laws that may be true.
//!
//! ```
//! use bouncelab::ball;
//! use bouncelab::analysis::Settings;
//! use bouncelab::estimate::{self, Effort, Knowledge, Measured, Question};
//! use bouncelab::restitution::TimedImpact;
//!
//! // Nine flights of a ball that was dropped from 30.5 cm.
//! let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984];
//! let impacts: Vec<TimedImpact> = (1..)
//!     .zip(times_s)
//!     .map(|(number, time_s)| TimedImpact { number, time_s, standard_error_s: Some(5e-5) })
//!     .collect();
//! let knowledge = Knowledge {
//!     drop_height_m: Some(Measured { value: 0.305, sd: 0.002 }),
//!     ..Knowledge::default()
//! };
//! let Settings { ball, environment, contact_time_s, .. } = Settings::default();
//! let question = Question { effort: Effort { draws: 500, seed: 1 }, ..Question::default() };
//! let found =
//!     estimate::infer(&impacts, &ball, &environment, contact_time_s, &knowledge, &question)?;
//! assert!((found.restitution.value - 0.95).abs() < 0.01);
//! assert!(found.missed_first.unwrap()[0] > 0.99);
//! # Ok::<(), bouncelab::Error>(())
//! ```
//!
//! # How it is done
//!
//! For each restitution law, drag law and number of impacts missed before the first one heard, the
//! best fit is found by quasi-Newton search, and the posterior around it by importance sampling;
//! the Pareto shape of the weights says whether that worked. The evidence of each model is its
//! weight in the average. The likelihood is that of two kinds of noise, errors of the times and
//! scatter of the impacts, with their banded covariance and the Jacobian from times to speeds, in
//! one pass over the impacts.

mod budget;
mod fit;
mod identify;
mod knowledge;
mod likelihood;
mod model;
mod observed;
mod posterior;
mod predict;
mod remark;
mod sample;
mod summary;

pub use budget::{Budget, Share};
pub use identify::{Correlations, Narrowed, TOLD_NOTHING, Unknown};
pub use knowledge::{Knowledge, LawKind, Measured, UNKNOWN};
pub use posterior::Effort;
pub use remark::Remark;
pub use sample::GREATEST_PARETO_SHAPE;
pub use summary::Summary;

use crate::ball::Ball;
use crate::drag::DragLaw;
use crate::error::{Error, Result, positive};
use crate::flight::{Environment, FlightModel};
use crate::impact::Restitution;
use crate::restitution::TimedImpact;
use likelihood::{Evaluator, Innovation};
use posterior::Posterior;

/// What to ask of the posterior.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Question {
    /// The impact speed at which to state the restitution, m/s; if `None`, the middle of those
    /// heard, where it is known best.
    pub at_speed_m_s: Option<f64>,
    /// From which height does the flight after a bounce (1 for the first) rise to an apex, in m?
    pub reach: Vec<Reach>,
    /// How much to compute.
    pub effort: Effort,
}

/// A bounce and the apex that it is to reach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// Number of the bounce, 1 for the first.
    pub bounce: usize,
    /// Apex of the flight after it, m.
    pub apex_m: f64,
}

/// The answer to a [`Reach`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prediction {
    /// What was asked.
    pub reach: Reach,
    /// The drop height, m, with the restitution that the law expects; `None` if no height does.
    pub drop_height_m: Option<Summary>,
}

/// What the times of one drop say, all priors and models considered.
#[derive(Debug, Clone)]
pub struct Inference {
    /// The impact speed of [`Self::restitution`], m/s.
    pub at_speed_m_s: f64,
    /// The restitution law at that speed.
    pub restitution: Summary,
    /// -d ln e/d ln v at that speed: by how many per cent restitution falls when speed grows by one.
    pub slope: Summary,
    /// Height of the fall: before the first impact if a height or release was given, else before
    /// the first impact heard, m.
    pub drop_height_m: Summary,
    /// The drag coefficient, if there is drag.
    pub drag: Option<Drag>,
    /// Gravity, m/s².
    pub gravity_m_s2: Summary,
    /// Standard deviation of ln e from impact to impact.
    pub scatter: Summary,
    /// Root mean square standard error of the times, s.
    pub timing_s: Summary,
    /// Contact time, s.
    pub contact_time_s: Summary,
    /// From the release until the ball rests, s.
    pub total_time_s: Option<Summary>,
    /// Path from the release until the ball rests, m.
    pub total_path_m: Option<Summary>,
    /// Probabilities of 0, 1, 2, ... impacts before the first one heard, if a height or a release
    /// time tells.
    pub missed_first: Option<Vec<f64>>,
    /// The answers to [`Question::reach`].
    pub predictions: Vec<Prediction>,
    /// The impacts heard.
    pub impacts: Vec<Impact>,
    /// The models that were weighed, most probable first.
    pub models: Vec<Model>,
    /// How much the data narrowed what was known.
    pub narrowed: Vec<Narrowed>,
    /// Correlations between the answers.
    pub correlations: Correlations,
    /// Where the uncertainty comes from.
    pub budget: Budget,
    /// Equally likely values of the answers together.
    pub draws: Draws,
    /// Whether and how well the sampling worked.
    pub sampling: Sampling,
    /// What to know before believing it.
    pub remarks: Vec<Remark>,
    posterior: Posterior,
}

/// The drag of the ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drag {
    /// The drag coefficient at a Reynolds number.
    pub coefficient: Summary,
    /// That Reynolds number: of the fastest impact heard, where drag shows most.
    pub reynolds: f64,
    /// The coefficient before the data, with its standard deviation.
    pub prior: Measured,
    /// The terminal speed, m/s, if the drag law reaches it.
    pub terminal_speed_m_s: Option<Summary>,
}

/// An impact heard, and the flight after it.
#[derive(Debug, Clone, PartialEq)]
pub struct Impact {
    /// Its number.
    pub number: usize,
    /// Speed just before it, m/s.
    pub impact_speed_m_s: Summary,
    /// What it kept of the speed; unknown for the last, and where the next was missed.
    pub restitution: Option<Summary>,
    /// Apex of the flight after it, m.
    pub apex_m: Option<Summary>,
    /// Energy it took, J.
    pub lost_to_surface_j: Option<Summary>,
    /// Energy the air took in the flight after it, J.
    pub lost_to_air_j: Option<Summary>,
    /// How far it lies from what the impacts before it foretold, in standard deviations; unknown
    /// for the last.
    pub standardised_residual: Option<f64>,
    /// Its weight in the fit: 1 for an impact as good as any, near 0 for an odd one.
    pub weight: f64,
}

/// A model and how it fared.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Restitution law.
    pub law: LawKind,
    /// Drag law, which has a scale.
    pub drag: DragLaw,
    /// Its posterior probability, over all numbers of missed impacts.
    pub weight: f64,
    /// Logarithm of its evidence above that of the best.
    pub log_evidence: f64,
    /// The restitution if it is true; `None` if it is too improbable to have been sampled.
    pub restitution: Option<Summary>,
    /// The drop height if it is true, m.
    pub drop_height_m: Option<Summary>,
}

/// Equally likely values of the answers; those with the same index belong together.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Draws {
    /// Restitution at the stated speed.
    pub restitution: Vec<f64>,
    /// Drag coefficient; empty if there is no drag.
    pub drag_coefficient: Vec<f64>,
    /// Drop height, m.
    pub drop_height_m: Vec<f64>,
}

/// How the sampling went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Draws that count as independent.
    pub effective_draws: f64,
    /// Shape of the tail of the weights; the answer stands if it is below
    /// [`GREATEST_PARETO_SHAPE`].
    pub pareto_shape: f64,
    /// Whether it can be trusted.
    pub converged: bool,
}

/// The restitution law at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandPoint {
    /// Impact speed, m/s.
    pub speed_m_s: f64,
    /// Restitution there.
    pub restitution: Summary,
}

/// Every so many draws go into answers that take long.
const THINNED: usize = 4;

/// Infers everything that the times of one drop can tell.
///
/// # Errors
///
/// [`Error::CannotInfer`] with fewer than two impacts or if no physical model explains them,
/// [`Error::OutOfRange`] and [`Error::NotInOrder`] for times and knowledge that make no sense, and
/// the errors of [`FlightModel::new`].
pub fn infer(
    impacts: &[TimedImpact],
    ball: &Ball,
    environment: &Environment,
    contact_time_s: f64,
    knowledge: &Knowledge,
    question: &Question,
) -> Result<Inference> {
    if let Some(speed_m_s) = question.at_speed_m_s {
        positive(
            "impact speed at which to state the restitution in m/s",
            speed_m_s,
        )?;
    }
    for reach in &question.reach {
        positive("apex to reach in m", reach.apex_m)?;
    }
    let posterior = Posterior::new(
        impacts,
        ball,
        environment,
        contact_time_s,
        knowledge,
        &question.effort,
    )?;
    let at_speed_m_s = question.at_speed_m_s.unwrap_or(posterior.middle.speed_m_s);
    Answers::new(&posterior, at_speed_m_s)
        .and_then(|answers| answers.inference(&posterior, ball, environment, question))
        .ok_or_else(|| {
            Error::CannotInfer(
                "the posterior could not be sampled: no draw explains the times; are they of one \
                 drop?"
                    .to_owned(),
            )
        })
}

/// The most probable drop under one law, without uncertainties.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestFit {
    /// The restitution law.
    pub law: Restitution,
    /// Height of the fall before the first impact heard, m.
    pub drop_height_m: f64,
    /// Factor on the drag coefficient of the drag law.
    pub drag_scale: f64,
}

/// The best fit alone: a hundred times faster than [`infer`], for those who watch while it bounces.
///
/// It takes the first restitution law of the knowledge (constant if it names none) and the drag law
/// of the environment, and every impact from the first one heard.
///
/// # Errors
///
/// Those of [`infer`].
pub fn best_fit(
    impacts: &[TimedImpact],
    ball: &Ball,
    environment: &Environment,
    contact_time_s: f64,
    knowledge: &Knowledge,
) -> Result<BestFit> {
    let law = knowledge.restitution_laws.first();
    let knowledge = Knowledge {
        restitution_laws: vec![law.copied().unwrap_or(LawKind::Constant)],
        constant_drag_too: false,
        first_was_heard: true,
        ..knowledge.clone()
    };
    let posterior = Posterior::fitted_only(impacts, ball, environment, contact_time_s, &knowledge)?;
    let candidate = &posterior.candidates[0];
    let model = posterior.model(candidate);
    let mut evaluator = Evaluator::new(&model);
    let point = evaluator.point(candidate.fit.vector.as_slice());
    point
        .and_then(|point| {
            Some(BestFit {
                law: point.law,
                drop_height_m: evaluator.told(&point)?.drop_height_m,
                drag_scale: point.drag_scale,
            })
        })
        .ok_or_else(|| Error::CannotInfer("the best fit makes no sense".to_owned()))
}

/// The answers of each draw.
struct Answers {
    at_speed_m_s: f64,
    restitution: Vec<f64>,
    slope: Vec<f64>,
    drop_height_m: Vec<f64>,
    drag_scale: Vec<f64>,
    drag_strength: Vec<f64>,
    gravity_m_s2: Vec<f64>,
    scatter: Vec<f64>,
    timing_s: Vec<f64>,
    contact_time_s: Vec<f64>,
}

impl Answers {
    fn new(posterior: &Posterior, at_speed_m_s: f64) -> Option<Self> {
        let sigma_s = &posterior.observed.sigma_s;
        let squares: f64 = sigma_s.iter().map(|s| s * s).sum();
        let rms_s = (squares / sigma_s.len() as f64).sqrt();
        let rows = posterior.each(1, |evaluator, point| {
            let table = evaluator.table(point.drag_strength);
            let (gravity_height, ..) = table.fall(point.fall_launch_m_s)?;
            Some([
                point.law.at(at_speed_m_s),
                -point.law.log_slope(at_speed_m_s),
                gravity_height / point.gravity_m_s2,
                point.drag_scale,
                point.drag_strength,
                point.gravity_m_s2,
                point.scatter,
                point.timing * rms_s,
                point.contact_time_s,
            ])
        });
        if rows.len() != posterior.draws.len() || rows.is_empty() {
            return None;
        }
        let column = |place: usize| rows.iter().map(|row| row[place]).collect();
        Some(Self {
            at_speed_m_s,
            restitution: column(0),
            slope: column(1),
            drop_height_m: column(2),
            drag_scale: column(3),
            drag_strength: column(4),
            gravity_m_s2: column(5),
            scatter: column(6),
            timing_s: column(7),
            contact_time_s: column(8),
        })
    }

    fn inference(
        self,
        posterior: &Posterior,
        ball: &Ball,
        environment: &Environment,
        question: &Question,
    ) -> Option<Inference> {
        let of = |values: &[f64]| Summary::of(values.iter().copied());
        let innovations = posterior.innovations();
        let narrowed = identify::narrowed(posterior);
        let rest = posterior.each(THINNED, |evaluator, point| {
            Some(predict::until_rest(evaluator, point))
        });
        let rests = rest.iter().filter(|rest| rest.is_some()).count() * 2 > rest.len();
        let rest: Vec<predict::Rest> = rest.into_iter().flatten().filter(|_| rests).collect();
        let drag_coefficient = self.drag_coefficients(posterior, ball, environment);
        let drag = self.drag(posterior, ball, environment, &drag_coefficient);
        let gravity_m_s2 = of(&self.environment_gravity(posterior, environment))?;
        let remarks = remark::remarks(posterior, &innovations, &narrowed, rests);
        Some(Inference {
            at_speed_m_s: self.at_speed_m_s,
            restitution: of(&self.restitution)?,
            slope: of(&self.slope)?,
            drop_height_m: of(&self.drop_height_m)?,
            drag,
            gravity_m_s2,
            scatter: of(&self.scatter)?,
            timing_s: of(&self.timing_s)?,
            contact_time_s: of(&self.contact_time_s)?,
            total_time_s: Summary::of(rest.iter().map(|rest| rest.time_s)),
            total_path_m: Summary::of(rest.iter().map(|rest| rest.path_m)),
            missed_first: missed_first(posterior),
            predictions: predictions(posterior, &question.reach),
            impacts: heard(posterior, &innovations, ball, environment),
            models: self.models(posterior),
            narrowed,
            correlations: identify::correlations(vec![
                ("restitution", self.restitution.clone()),
                ("slope of restitution", self.slope.clone()),
                ("drag coefficient", self.drag_scale.clone()),
                ("drop height", self.drop_height_m.clone()),
                ("gravity", self.gravity_m_s2.clone()),
                ("contact time", self.contact_time_s.clone()),
            ]),
            budget: budget::budget(posterior, self.at_speed_m_s).unwrap_or_default(),
            sampling: Sampling {
                effective_draws: posterior.effective_draws(),
                pareto_shape: posterior.pareto_shape(),
                converged: posterior.converged(),
            },
            remarks,
            draws: Draws {
                restitution: self.restitution,
                drag_coefficient,
                drop_height_m: self.drop_height_m,
            },
            posterior: posterior.clone(),
        })
    }

    /// The drag coefficient of each draw: that of its law at the fastest impact, times the scale.
    fn drag_coefficients(
        &self,
        posterior: &Posterior,
        ball: &Ball,
        environment: &Environment,
    ) -> Vec<f64> {
        if environment.air.is_vacuum() || environment.drag == DragLaw::None {
            return Vec::new();
        }
        let reynolds = environment.air.reynolds(ball, posterior.middle.fastest_m_s);
        let nominal: Vec<f64> = posterior
            .surroundings
            .iter()
            .map(|s| s.drag_law.coefficient(reynolds).unwrap_or(f64::NAN))
            .collect();
        let of_draw = posterior.draws.iter().zip(&self.drag_scale);
        of_draw
            .map(|(draw, scale)| scale * nominal[posterior.candidates[draw.candidate].surroundings])
            .collect()
    }

    fn drag(
        &self,
        posterior: &Posterior,
        ball: &Ball,
        environment: &Environment,
        coefficients: &[f64],
    ) -> Option<Drag> {
        let coefficient = Summary::of(coefficients.iter().copied())?;
        let reynolds = environment.air.reynolds(ball, posterior.middle.fastest_m_s);
        let nominal = environment.drag.coefficient(reynolds).ok()?;
        let models: Vec<FlightModel> = posterior
            .surroundings
            .iter()
            .map(|surroundings| {
                let drag = surroundings.drag_law;
                FlightModel::new(
                    ball,
                    &Environment {
                        drag,
                        ..*environment
                    },
                )
            })
            .collect::<Result<_>>()
            .ok()?;
        let of_draw = posterior.draws.iter().zip(&self.drag_strength);
        let terminal = of_draw.step_by(THINNED).filter_map(|(draw, &strength)| {
            let surroundings = posterior.candidates[draw.candidate].surroundings;
            terminal_speed(&models[surroundings], strength)
        });
        Some(Drag {
            coefficient,
            reynolds,
            prior: Measured {
                value: nominal,
                sd: nominal * posterior.knowledge.drag,
            },
            terminal_speed_m_s: Summary::of(terminal),
        })
    }

    /// Gravity itself, of which the effective gravity is only a part: the rest of what moved that
    /// belongs to buoyancy and added mass.
    fn environment_gravity(&self, posterior: &Posterior, environment: &Environment) -> Vec<f64> {
        let surroundings = &posterior.surroundings[posterior.candidates[0].surroundings];
        let share = surroundings.inputs.gravity_share();
        self.gravity_m_s2
            .iter()
            .map(|gravity| {
                environment.gravity_m_s2 * (gravity / surroundings.gravity_m_s2).powf(share)
            })
            .collect()
    }

    /// The table of models, with the numbers of missed impacts added up.
    fn models(&self, posterior: &Posterior) -> Vec<Model> {
        let mut models: Vec<Model> = Vec::new();
        for candidate in &posterior.candidates {
            let drag = posterior.surroundings[candidate.surroundings].drag_law;
            let known = models
                .iter_mut()
                .find(|model| model.law == candidate.law && model.drag == drag);
            if let Some(model) = known {
                model.weight += candidate.weight;
                continue;
            }
            let of_model = |values: &[f64]| {
                let of_draw = posterior.draws.iter().zip(values);
                Summary::of(of_draw.filter_map(|(draw, &value)| {
                    let drawn = &posterior.candidates[draw.candidate];
                    let same =
                        drawn.law == candidate.law && drawn.surroundings == candidate.surroundings;
                    same.then_some(value)
                }))
            };
            models.push(Model {
                law: candidate.law,
                drag,
                weight: candidate.weight,
                log_evidence: 0.0,
                restitution: of_model(&self.restitution),
                drop_height_m: of_model(&self.drop_height_m),
            });
        }
        models.sort_by(|a, b| b.weight.total_cmp(&a.weight));
        let best = models.first().map_or(1.0, |model| model.weight);
        for model in &mut models {
            model.log_evidence = (model.weight / best).ln();
        }
        models
    }
}

impl Impact {
    /// Whether it is so odd that it counts little in the fit.
    pub fn is_odd(&self) -> bool {
        self.weight < remark::ODD_WEIGHT
    }
}

impl Inference {
    /// The restitution law at a speed, m/s.
    pub fn restitution_at(&self, speed_m_s: f64) -> Option<Summary> {
        Summary::of(
            self.posterior
                .each(1, |_, point| Some(point.law.at(speed_m_s))),
        )
    }

    /// The restitution law over a range of impact speeds, from a little below the slowest heard to
    /// the fastest, the first impact.
    pub fn band(&self, points: usize) -> Vec<BandPoint> {
        let middle = &self.posterior.middle;
        let fastest = self
            .impacts
            .iter()
            .map(|impact| impact.impact_speed_m_s.value)
            .fold(middle.fastest_m_s, f64::max);
        let (from, to) = (0.9 * middle.slowest_m_s, 1.05 * fastest);
        let speeds: Vec<f64> = (0..points)
            .map(|point| from + (to - from) * point as f64 / (points.max(2) - 1) as f64)
            .collect();
        let summaries = self.restitution_at_each(&speeds);
        std::iter::zip(speeds, summaries)
            .filter_map(|(speed_m_s, restitution)| {
                Some(BandPoint {
                    speed_m_s,
                    restitution: restitution?,
                })
            })
            .collect()
    }

    /// The restitution law at several speeds, m/s, from a fourth of the draws.
    pub fn restitution_at_each(&self, speeds_m_s: &[f64]) -> Vec<Option<Summary>> {
        let draws = self.posterior.each(THINNED, |_, point| {
            let law = speeds_m_s.iter().map(|&v| point.law.at(v));
            Some(law.collect::<Vec<f64>>())
        });
        (0..speeds_m_s.len())
            .map(|place| Summary::of(draws.iter().map(|draw| draw[place])))
            .collect()
    }

    /// What of the standard uncertainty of the restitution at these speeds, m/s, comes from inputs
    /// that other drops of the ball share (drag law, contact time, air, gravity, mass, diameter), and
    /// so does not average out over drops. `None` if the fit is too odd to be taken apart.
    pub fn shared_sd(&self, speeds_m_s: &[f64]) -> Option<Vec<f64>> {
        budget::shared_sd(&self.posterior, speeds_m_s)
    }

    /// Whether the first impact heard was taken to be the first.
    pub fn first_was_heard(&self) -> bool {
        let knowledge = &self.posterior.knowledge;
        knowledge.drop_height_m.is_some() && self.missed_first.is_none()
    }

    /// The priors, one line for each: what was assumed of balls and rooms before the data.
    pub fn priors(&self) -> Vec<String> {
        self.posterior.knowledge.statements()
    }
}

fn predictions(posterior: &Posterior, reach: &[Reach]) -> Vec<Prediction> {
    let height = |reach: Reach| {
        posterior.each(THINNED, |evaluator, point| {
            predict::drop_height_for(evaluator, point, reach.bounce, reach.apex_m)
        })
    };
    reach
        .iter()
        .map(|&reach| Prediction {
            reach,
            drop_height_m: Summary::of(height(reach)),
        })
        .collect()
}

/// Probabilities of numbers of missed impacts, if something tells.
fn missed_first(posterior: &Posterior) -> Option<Vec<f64>> {
    if !posterior.knowledge.tells_missed() {
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
    const STEPS: usize = 30;
    let mut speed = model.terminal_speed_m_s()? / drag_strength.sqrt();
    for _ in 0..STEPS {
        // Drag goes about as the square of the speed.
        let step = -0.5 * (drag_strength * model.drag_over_weight(speed).ok()?).ln();
        speed *= step.exp();
        if step.abs() < 1e-9 {
            break;
        }
    }
    Some(speed)
}

/// The impacts heard, with what each did to the speed and the energy of the ball.
fn heard(
    posterior: &Posterior,
    innovations: &[Innovation],
    ball: &Ball,
    environment: &Environment,
) -> Vec<Impact> {
    let told = posterior.each(THINNED, |evaluator: &mut Evaluator, point| {
        let told = evaluator.told(point)?;
        let table = evaluator.table(point.drag_strength);
        let apexes = told
            .launch_speeds
            .iter()
            .map(|&launch| Some(table.fall(launch)?.0 / point.gravity_m_s2))
            .collect::<Option<Vec<f64>>>()?;
        Some((told, apexes))
    });
    let mass_kg = FlightModel::new(ball, environment)
        .ok()
        .and_then(|model| model.moving_mass_kg())
        .unwrap_or(ball.mass_kg());
    let stretches = &posterior.observed.stretches;
    let impacts = posterior.observed.impacts.iter().enumerate();
    impacts
        .filter_map(|(place, impact)| {
            let launches = stretches.get(place).is_some();
            let single = stretches.get(place).is_some_and(|s| s.flights == 1);
            let innovation = innovations.iter().rfind(|i| i.impact == place && launches);
            let energy =
                |faster: f64, slower: f64| 0.5 * mass_kg * (faster * faster - slower * slower);
            let when = |possible: bool, value: &dyn Fn(usize) -> f64| {
                if possible {
                    Summary::of((0..told.len()).map(value))
                } else {
                    None
                }
            };
            let before = |draw: usize| told[draw].0.impact_speeds[place];
            let after = |draw: usize| told[draw].0.launch_speeds[place];
            Some(Impact {
                number: impact.number,
                impact_speed_m_s: Summary::of((0..told.len()).map(before))?,
                restitution: when(launches, &|draw| after(draw) / before(draw)),
                apex_m: when(launches, &|draw| told[draw].1[place]),
                lost_to_surface_j: when(launches, &|draw| energy(before(draw), after(draw))),
                lost_to_air_j: when(single, &|draw| {
                    energy(after(draw), told[draw].0.impact_speeds[place + 1])
                }),
                standardised_residual: innovation.map(|i| i.standardised),
                weight: innovation.map_or(1.0, |i| i.weight),
            })
        })
        .collect()
}
