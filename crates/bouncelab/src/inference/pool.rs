//! The draws of the posterior over all models: sampled by candidate, and pooled.

use std::array;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::candidates::{Candidate, SampledPosterior, allowed_balls, best_evidence, weigh};
use super::fit;
use super::order::order;
use super::parameters::{MANY_FLIGHTS, MIN_PART_OF_DRAWS, PRUNE_BELOW, RELEVANT_WEIGHT};
use super::predict::{self, Future, Rest};
use super::sample;
use super::smoothing::DropState;
use super::unknowns::{Model, Point};
use crate::estimate::Estimate;
use crate::restitution::Restitution;
use crate::simd::{LANES, one_for_each_lane};

/// How much to compute.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct SamplerConfig {
    /// Draws of the posterior that count as independent.
    pub draws: usize,
    /// Seed of the random numbers: the same seed gives the same answer to the last digit.
    pub seed: u64,
}

impl Default for SamplerConfig {
    fn default() -> Self {
        Self {
            draws: 1000,
            seed: 1,
        }
    }
}

impl SamplerConfig {
    /// One stream of random numbers for each candidate, so that its draws depend neither on the draws of others nor on its
    /// rank, which a last digit can change. The stream follows from the name of its law, not from the position of the law in
    /// the list. The first stream of the seed is that of the pool.
    fn rng_of(&self, candidate: &Candidate) -> ChaCha8Rng {
        let choices = [
            candidate.law.random_stream(),
            candidate.medium as u64,
            candidate.missed_first as u64,
            candidate.numbering as u64,
        ];
        let number = choices
            .iter()
            .fold(0, |number, &choice| number << 8 | choice);
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        rng.set_stream(1 + number);
        rng
    }
}

/// One draw of the posterior over everything.
#[derive(Debug, Clone, Copy)]
pub(super) struct Draw<'a> {
    pub(super) candidate: usize,
    pub(super) vector: &'a [f64],
}

/// Equally likely draws, one after the other: a recording may have a million of them.
#[derive(Debug, Clone, Default)]
pub(super) struct Pool {
    /// The candidate of each draw, and the end of its vector in the values.
    draws: Vec<(u32, u32)>,
    values: Vec<f64>,
}

impl Pool {
    fn push(&mut self, candidate: usize, vector: impl IntoIterator<Item = f64>) {
        self.values.extend(vector);
        self.draws
            .push((candidate as u32, self.values.len() as u32));
    }

    pub(super) fn len(&self) -> usize {
        self.draws.len()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.draws.is_empty()
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = Draw<'_>> {
        let mut start = 0;
        self.draws.iter().map(move |&(candidate, end)| {
            let vector = &self.values[start..end as usize];
            start = end as usize;
            Draw {
                candidate: candidate as usize,
                vector,
            }
        })
    }
}

impl SampledPosterior {
    /// Samples the relevant candidates, weighs them by their evidence and pools their draws.
    pub(super) fn sample(&mut self, sampler: &SamplerConfig) {
        let best = best_evidence(&self.candidates);
        let mut candidates = std::mem::take(&mut self.candidates);
        candidates.retain(|candidate| candidate.log_evidence > best - 2.0 * PRUNE_BELOW);
        weigh(&mut candidates);
        let draws_requested = sampler.draws * allowed_balls(&candidates);
        for candidate in &mut candidates {
            if candidate.log_evidence < best - PRUNE_BELOW {
                continue;
            }
            self.scale_restitution_by_noise(candidate);
            let model = self.model(candidate);
            let draws = (draws_requested as f64 * candidate.weight) as usize;
            let sample = sample::sample(
                &model,
                &candidate.fit,
                draws.max(sampler.draws / MIN_PART_OF_DRAWS),
                &mut sampler.rng_of(candidate),
            );
            if let Some(sample) = sample {
                candidate.log_evidence = sample.log_evidence + self.log_prior(candidate);
                candidate.sample = Some(sample);
            }
        }
        weigh(&mut candidates);
        self.candidates = candidates;
        self.draws = self.pooled(draws_requested, sampler.seed);
        for sample in self.candidates.iter_mut().filter_map(|c| c.sample.as_mut()) {
            sample.forget_draws();
        }
    }

    /// Fits a candidate again with a restitution in units of the noise, if there are too few impacts to determine the noise.
    fn scale_restitution_by_noise(&self, candidate: &mut Candidate) {
        let model = self.model(candidate);
        let observed = model.observed;
        if observed.restitutions() < 2 || observed.intervals.len() >= MANY_FLIGHTS {
            return;
        }
        let Some((index, expected)) = candidate.fit.expected_restitution(&model) else {
            return;
        };
        let mut start = candidate.fit.vector.as_slice().to_vec();
        start[index] = 0.0;
        let model = model.with_expected_restitution(Some(expected));
        if let Some(fit) = fit::best_fit(&model, start, f64::NEG_INFINITY) {
            candidate.fit = fit;
            candidate.expected_restitution = Some(expected);
        }
    }

    /// Equally likely draws from all samples, by systematic resampling: the weights
    /// are added up in an order in which neighbours are alike, and a draw is taken at each of a number of equal distances from
    /// a random start. So the answers scatter less over seeds than in the order drawn (M. Gerber, N. Chopin and N. Whiteley,
    /// Ann. Stat. 47, 2236, 2019).
    fn pooled(&self, draws: usize, seed: u64) -> Pool {
        let sampled: f64 = self
            .candidates
            .iter()
            .filter(|candidate| candidate.sample.is_some())
            .map(|candidate| candidate.weight)
            .sum();
        let offset: f64 = ChaCha8Rng::seed_from_u64(seed).random();
        let distance = sampled / draws as f64;
        let mut next = offset * distance;
        let mut sum = 0.0;
        let mut pooled = Pool {
            draws: Vec::with_capacity(draws),
            ..Pool::default()
        };
        for (index, candidate) in self.candidates.iter().enumerate() {
            let Some(sample) = &candidate.sample else {
                continue;
            };
            let unknowns = self.model(candidate).answered();
            for draw in order(&sample.vectors, &sample.weights, &unknowns) {
                sum += candidate.weight * sample.weights[draw];
                while next < sum && pooled.len() < draws {
                    pooled.push(index, sample.vectors.column(draw).iter().copied());
                    next += distance;
                }
            }
        }
        pooled.values.shrink_to_fit();
        pooled
    }

    /// Whether the weights of the sampling can be trusted: the largest Pareto shape of the relevant candidates.
    pub(super) fn pareto_shape(&self) -> f64 {
        let weights = self.candidates.iter().map(|candidate| candidate.weight);
        // Among many similar candidates none may be as probable, but they are relevant.
        let relevant = weights.fold(0.0, f64::max).min(RELEVANT_WEIGHT);
        self.candidates
            .iter()
            .filter(|candidate| candidate.weight >= relevant)
            .map(|candidate| match &candidate.sample {
                Some(sample) => sample.pareto_shape,
                None => f64::INFINITY,
            })
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// Number of independent draws with the same information.
    pub(super) fn effective_draws(&self) -> f64 {
        // The pool is a mixture: its variance is the sum over candidates of weight² / effective.
        let variance: f64 = self
            .candidates
            .iter()
            .filter_map(|candidate| {
                let effective = candidate.sample.as_ref()?.effective_draws;
                Some(candidate.weight * candidate.weight / effective)
            })
            .sum();
        1.0 / variance
    }

    /// Whole drops for one of every `every` draws, given the points of all draws; none if one of them is not valid.
    pub(super) fn drops(&self, points: &[Point], every: usize) -> Vec<DrawnDrop> {
        let draws = self.draws.iter().zip(points).step_by(every);
        let chosen: Vec<(usize, Point)> = draws
            .map(|(draw, point)| (draw.candidate, *point))
            .collect();
        let mut drops = Vec::with_capacity(chosen.len());
        for of_candidate in chosen.chunk_by(|(one, _), (other, _)| one == other) {
            let candidate = of_candidate[0].0;
            let without_first = self.leaves_out_first(&self.candidates[candidate]);
            let model = self.model(&self.candidates[candidate]);
            let points: Vec<Point> = of_candidate.iter().map(|&(_, point)| point).collect();
            let numbers = (drops.len() as u32..).take(points.len());
            let mut futures: Vec<Future> = numbers
                .map(|number| Future::new(&self.priors, number))
                .collect();
            let Some(states) = drawn_states(&model, &points, &mut futures) else {
                return Vec::new();
            };
            let drawn = points.iter().zip(&states).zip(futures);
            let bouncing = drawn.map(|((point, state), future)| (*point, state, future));
            let rests = predict::until_rest(&model, bouncing);
            drops.extend(
                states
                    .into_iter()
                    .zip(rests)
                    .map(|(state, rest)| DrawnDrop {
                        state,
                        without_first,
                        rest,
                        mass_kg: model.medium.mass_kg(),
                    }),
            );
        }
        drops
    }

    /// The summary of a number of one of every `every` draws, in their order. If the ball was not stated, the intervals hold
    /// those of each ball that the times allow: which of them it is must not decide whether they are right.
    pub(super) fn estimate(
        &self,
        every: usize,
        values: impl IntoIterator<Item = f64>,
    ) -> Option<Estimate> {
        let values: Vec<f64> = values.into_iter().collect();
        let all = Estimate::of_draws(values.iter().copied());
        if self.media.len() == 1 {
            return all;
        }
        let draws = self.draws.iter().step_by(every);
        let balls: Vec<usize> = draws
            .map(|draw| self.candidates[draw.candidate].medium)
            .collect();
        let of_ball = |ball: usize| {
            let its = balls
                .iter()
                .zip(&values)
                .filter(move |(of, _)| **of == ball);
            Estimate::of_draws(its.map(|(_, value)| *value))
        };
        let each = (0..self.media.len()).filter_map(of_ball);
        all.map(|all| each.fold(all, |all, ball| all.covering(&ball)))
    }

    /// The restitution laws of one of every `every` draws.
    pub(super) fn laws_drawn(&self, every: usize) -> impl Iterator<Item = Restitution> {
        let models = self.models();
        let draws = self.draws.iter().step_by(every);
        draws.filter_map(move |draw| {
            let [point] = models[draw.candidate].values(&[draw.vector]);
            Some(point?.law)
        })
    }

    /// A value for one of every `every` draws.
    pub(super) fn each<T>(
        &self,
        every: usize,
        mut value: impl FnMut(&Model, &Point) -> Option<T>,
    ) -> Vec<T> {
        let models = self.models();
        let draws: Vec<Draw> = self.draws.iter().step_by(every.max(1)).collect();
        let mut values = Vec::with_capacity(draws.len());
        for alike in draws.chunk_by(|one, other| one.candidate == other.candidate) {
            let model = &models[alike[0].candidate];
            for group in alike.chunks(LANES) {
                let draws: [Draw; LANES] = one_for_each_lane(group);
                let points = model.points(&draws.map(|draw| draw.vector)).into_iter();
                let points = points.take(group.len()).flatten();
                values.extend(points.filter_map(|point| value(model, &point)));
            }
        }
        values
    }
}

/// A draw of the whole drop.
#[derive(Debug, Clone)]
pub(super) struct DrawnDrop {
    pub(super) state: DropState,
    /// Whether the first impact detected is left out.
    pub(super) without_first: bool,
    /// Time and path to rest, if it comes to rest.
    pub(super) rest: Option<Rest>,
    /// Mass that moves with the ball, kg.
    pub(super) mass_kg: f64,
}

/// A drop for each point, with the random numbers of its future; `None` if one of the points is not valid.
fn drawn_states(model: &Model, points: &[Point], futures: &mut [Future]) -> Option<Vec<DropState>> {
    let mut states = Vec::with_capacity(points.len());
    for (points, futures) in points.chunks(LANES).zip(futures.chunks_mut(LANES)) {
        let mut random = futures.iter_mut().map(|future| &mut future.rng);
        let mut random: [_; LANES] = array::from_fn(|_| random.next());
        let drawn = model.drawn_states(&one_for_each_lane(points), &mut random)?;
        states.extend(drawn.into_iter().take(points.len()));
    }
    Some(states)
}
