//! The best chain of onsets by dynamic programming.
//!
//! A pair of successive impacts fixes the last flight, and the way to it fixes the
//! ratio to expect next. Each pair keeps its few best ways (the Viterbi algorithm with
//! per-survivor processing of the ratio), so the cost is that of trying every impact after every
//! pair, not every subset.

use std::ops::Range;

use super::evidence::{self, Fall, Span, Surroundings};
use super::rhythm::{self, Beat, Pulse};
use super::{FEWEST_IMPACTS, Onset};
use crate::stats::sort_by_number;

/// The longest time between two impacts heard, in seconds: an apex of 4.9 m.
const LONGEST_S: f64 = 2.0;
/// The shortest flight in seconds: an apex of 0.1 mm; the sounds run into each other.
const SHORTEST_S: f64 = 0.008;
/// The shortest first flight of a train, in seconds: below it, pitch of a voice looks like flights.
const SHORTEST_FIRST_S: f64 = 0.04;
/// At most this many impacts in a row may be missing.
const MOST_MISSED: usize = 2;
/// Logarithms of the flight ratios of a dead and of a nearly perfect bounce.
const LEAST_LN_RATIO: f64 = -0.9;
const GREATEST_LN_RATIO: f64 = -0.005;
/// A predicted flight time is never further off than this, in its logarithm.
const FARTHEST: f64 = 0.3;
/// The scatter of the ratios is learnt from the drop itself; what is expected of it counts as much
/// as so many ratios.
const EXPECTED_COUNTS: f64 = 3.0;
/// One odd impact, so many times the scatter off, teaches no more than this. (The most likely scatter of a Student
/// distribution with two degrees of freedom counts the square of a surprise of z times the scatter as 3 z² / (2 + z²) times
/// that of the scatter: 2 at twice, and never more than 3.)
const ODDEST: f64 = 2.0;
/// Each pair of impacts keeps this many ways to it, whose ratios differ by more than this, or the
/// variances of whose ratios by more than this factor: which is right is often seen only one or
/// two impacts later. Ratios that differ by less, three times the scatter on a good surface, expect about the same.
const KEPT: usize = 4;
const SAME_RATIO: f64 = 0.04;
const SAME_SCATTER: f64 = 3.0;
/// Ways with less evidence than this are not pursued. Drops begin at -9 or so, and in a crowd of like
/// sounds the second and third impacts take away more than they add.
const PRUNE_BELOW: f64 = -16.0;

/// An onset that fits as badly as this is better taken for a missed impact.
const HOPELESS_STEP: f64 = -4.0;

/// A sequence of onsets that may be the impacts of a drop.
pub(super) struct Chain {
    pub(super) links: Vec<Link>,
    pub(super) evidence: f64,
    around: Vec<Surroundings>,
}

/// One onset of a chain and its number, missed impacts counted.
#[derive(Clone, Copy)]
pub(super) struct Link {
    pub(super) onset: usize,
    pub(super) number: u32,
}

/// What was learnt on the way to a pair of impacts.
#[derive(Clone, Copy)]
struct Way {
    evidence: f64,
    ln_flight: f64,
    /// The square of the last flight, in s².
    flight2: f64,
    trend: Trend,
    /// How many ratios of flights went into the trend.
    ratios: u32,
    /// Variance of the ratios about their trend.
    scatter2: f64,
}

/// What a way says of the next interval.
#[derive(Clone, Copy)]
struct Expected {
    /// Logarithm of it over the last flight.
    ln_interval: f64,
    /// The same of the last flight in it.
    ln_last: f64,
}

/// A way, and what it says of the next impact.
struct State {
    way: Way,
    /// The most evidence that the next ratio can add.
    most: f64,
    /// The next interval with 0, 1, 2 impacts missed in it.
    expected: [Expected; MOST_MISSED + 1],
}

/// How the ratio of successive flights changes as they get shorter: its logarithm is a - b T², with T the
/// duration of the longer flight. Drag takes a share of the speed that grows with its square, and most
/// surfaces take more of a fast impact. Learnt by a Kalman filter.
#[derive(Clone, Copy, Default)]
struct Trend {
    /// Of short flights.
    ln_ratio: f64,
    /// In 1/s².
    fall: f64,
    /// Covariance of the two.
    covariance: [f64; 3],
}

impl Trend {
    /// In 1/s², before anything is seen: drag alone makes it (g / 2 v)², with v the terminal speed, near enough,
    /// 0.15 of a table-tennis ball, 0.03 of a basketball, and next to nothing of a steel ball.
    const FALL: f64 = 0.07;
    const FALL_SD: f64 = 0.07;
    /// The ratio of short flights wanders from flight to flight by a sixth of the scatter of the ratios, so that the
    /// filter forgets: the share of the variance. It then remembers six or seven flights, in which a ball with a
    /// restitution of 0.9 loses half of its speed; over more the restitution itself changes with speed.
    const WANDERING: f64 = 0.0265;
    /// No single odd impact teaches more than this.
    const GREATEST_STEP: f64 = 0.05;

    /// What the ratio of the first two flights tells.
    fn new(ln_ratio: f64, square: f64, scatter2: f64) -> Self {
        let fall2 = Self::FALL_SD * Self::FALL_SD;
        Self {
            ln_ratio: ln_ratio + Self::FALL * square,
            fall: Self::FALL,
            covariance: [scatter2 + square * square * fall2, square * fall2, fall2],
        }
    }

    /// Logarithm of the next flight over one whose duration has this square, in s².
    fn ln_ratio(&self, square: f64) -> f64 {
        let ln_ratio = self.ln_ratio - self.fall * square;
        ln_ratio.clamp(LEAST_LN_RATIO, GREATEST_LN_RATIO)
    }

    /// Its variance from what is not known of the trend.
    fn variance(&self, square: f64) -> f64 {
        let [ratio, both, fall] = self.covariance;
        ratio - square * (2.0 * both - square * fall)
    }

    /// The trend after a ratio that differs by so much from what was expected, with this variance.
    fn learn(&self, surprise: f64, variance: f64, square: f64, scatter2: f64) -> Self {
        let [ratio, both, fall] = self.covariance;
        let gains = [ratio - square * both, both - square * fall].map(|it| it / variance);
        let step = surprise.clamp(-Self::GREATEST_STEP, Self::GREATEST_STEP);
        Self {
            ln_ratio: self.ln_ratio + gains[0] * step,
            fall: self.fall + gains[1] * step,
            covariance: [
                ratio - gains[0] * gains[0] * variance + Self::WANDERING * scatter2,
                both - gains[0] * gains[1] * variance,
                fall - gains[1] * gains[1] * variance,
            ],
        }
    }
}

/// A step to a pair of onsets.
struct Step {
    interval_s: f64,
    ln_interval: f64,
    /// Variance of `ln_interval` from timing.
    variance: f64,
    /// Evidence that does not depend on the way here.
    common: f64,
    /// By how much the second is fainter, and the most evidence that this can add.
    fall: Fall,
    most: f64,
}

impl Step {
    fn new(onsets: &[Onset], around: &[Surroundings], pair: (usize, usize)) -> Self {
        let (earlier, later) = (&onsets[pair.0], &onsets[pair.1]);
        let interval_s = later.time_s - earlier.time_s;
        let timing = earlier.sigma_s.powi(2) + later.sigma_s.powi(2);
        let likeness = around[pair.0].likeness(&around[pair.1]);
        let fall = around[pair.0].fall(&around[pair.1]);
        Self {
            interval_s,
            ln_interval: interval_s.ln(),
            variance: 4.0 * timing / interval_s.powi(2),
            common: (likeness * around[pair.1].by_chance(interval_s)).ln(),
            most: fall.most().ln(),
            fall,
        }
    }
}

impl Way {
    /// The first two impacts of a train, on a smooth and on a rough surface.
    fn beginnings(step: &Step, around_first: &Surroundings) -> impl Iterator<Item = Self> {
        let by_chance = around_first.by_chance(step.interval_s).ln();
        let first_flight = evidence::ln_first_flight(step.interval_s);
        let evidence = around_first.ln_birth() + first_flight + step.common + by_chance;
        let ln_flight = step.ln_interval;
        let flight2 = step.interval_s * step.interval_s;
        let surfaces = if step.interval_s < SHORTEST_FIRST_S {
            &[]
        } else {
            evidence::SURFACES.as_slice()
        };
        surfaces.iter().map(move |surface| Self {
            evidence: evidence + surface.ln_prior,
            ln_flight,
            flight2,
            trend: Trend::default(),
            ratios: 0,
            scatter2: surface.scatter.powi(2),
        })
    }

    /// Logarithm of the next flight over the last.
    fn ln_ratio(&self) -> f64 {
        self.trend.ln_ratio(self.flight2)
    }

    /// The next intervals with 0, 1, 2... impacts missed in them.
    fn expected(&self) -> impl Iterator<Item = Expected> {
        // All in units of the last flight: the latest flight, the time until its end, and the logarithm of the flight.
        let (mut flight, mut time, mut ln_last) = (1.0, 0.0, 0.0);
        (0..).map(move |missed| {
            ln_last += self.trend.ln_ratio(self.flight2 * flight * flight);
            flight = ln_last.exp();
            time += flight;
            let ln_interval = if missed == 0 { ln_last } else { time.ln() };
            Expected {
                ln_interval,
                ln_last,
            }
        })
    }

    /// The same train one impact later, if its evidence exceeds `least`.
    fn next(&self, step: &Step, missed: usize, expected: Expected, least: f64) -> Option<Self> {
        let change = step.ln_interval - self.ln_flight;
        if self.ratios == 0 {
            return if missed == 0 {
                self.third(step, change, least)
            } else {
                None
            };
        }
        let surprise = change - expected.ln_interval;
        if surprise.abs() > FARTHEST {
            return None;
        }
        // Of the flights before the two impacts.
        let ln_fall = if missed == 0 {
            change
        } else {
            expected.ln_last
        };
        let variance = self.variance(step);
        let evidence = self.evidence
            + step.common
            + (evidence::next_ratio(change, surprise, variance) * step.fall.knowing(ln_fall)).ln()
            + missed as f64 * evidence::LN_MISSED;
        (evidence > least).then(|| {
            let scatter2 = self.learn(surprise, variance);
            // Of an interval with missed impacts, the last flight alone.
            let last = expected.ln_last - expected.ln_interval;
            let ln_flight = step.ln_interval + last;
            Self {
                evidence,
                ln_flight,
                flight2: (2.0 * ln_flight).exp(),
                trend: self.trend.learn(surprise, variance, self.flight2, scatter2),
                ratios: self.ratios + 1,
                scatter2,
            }
        })
    }

    /// Logarithm of how likely this interval is for a ball, whatever else may explain it.
    fn ln_flight(&self, stride: &Stride) -> Option<f64> {
        let change = stride.step.ln_interval - self.ln_flight;
        if self.ratios == 0 {
            return Some(evidence::FIRST_RATIO_DENSITY.ln());
        }
        let surprise = change - self.expected().nth(stride.missed)?.ln_interval;
        let variance = self.variance(&stride.step);
        Some(evidence::ln_ratio(surprise, variance))
    }

    /// Variance of the next ratio as it is predicted.
    fn variance(&self, step: &Step) -> f64 {
        step.variance + self.scatter2 + self.trend.variance(self.flight2)
    }

    /// The third impact sets the ratio.
    fn third(&self, step: &Step, change: f64, least: f64) -> Option<Self> {
        if !(LEAST_LN_RATIO..=step.variance.sqrt()).contains(&change) {
            return None;
        }
        let evidence = self.evidence
            + step.common
            + evidence::ln_first_ratio(change, self.ln_flight)
            + step.fall.knowing(change).ln();
        (evidence > least).then(|| Self {
            evidence,
            ln_flight: step.ln_interval,
            flight2: step.interval_s * step.interval_s,
            trend: Trend::new(change, self.flight2, self.scatter2),
            ratios: 1,
            scatter2: self.scatter2,
        })
    }

    /// The scatter after this surprise, whose variance was expected to be this.
    fn learn(&self, surprise: f64, variance: f64) -> f64 {
        let counts = EXPECTED_COUNTS + f64::from(self.ratios - 1);
        let share = self.scatter2 / variance;
        let seen = (surprise * surprise * share).min(ODDEST * ODDEST * self.scatter2);
        ((counts * self.scatter2 + seen) / (counts + 1.0)).max(evidence::LEAST_SCATTER.powi(2))
    }

    /// Where this stride leads, however little evidence is left.
    fn by(&self, stride: &Stride) -> Option<Self> {
        if stride.missed > MOST_MISSED {
            return None;
        }
        let expected = self.expected().nth(stride.missed)?;
        self.next(&stride.step, stride.missed, expected, f64::NEG_INFINITY)
    }
}

impl State {
    fn new(way: Way) -> Self {
        let mut expected = [Expected {
            ln_interval: 0.0,
            ln_last: 0.0,
        }; MOST_MISSED + 1];
        let most = if way.ratios == 0 {
            evidence::FIRST_RATIO_DENSITY
        } else {
            for (place, next) in expected.iter_mut().zip(way.expected()) {
                *place = next;
            }
            evidence::most_from_ratio(way.scatter2)
        };
        Self {
            way,
            most: most.ln(),
            expected,
        }
    }

    /// The same train one impact later, if its evidence exceeds `least`.
    fn next(&self, step: &Step, missed: usize, least: f64) -> Option<Way> {
        self.way.next(step, missed, self.expected[missed], least)
    }
}

/// Where a way to a pair of impacts came from: the onset and node before, and how many impacts were missed in between.
struct Origin {
    from: u32,
    missed: u32,
    back: Option<u32>,
}

impl Origin {
    /// Of a train whose first impact is this onset.
    fn beginning(onset: usize) -> Self {
        Self {
            from: onset as u32,
            missed: 0,
            back: None,
        }
    }
}

/// The measure of what a search among onsets does: for each, the pairs of others from which a flight may lead to it.
pub(crate) fn work(onsets: &[Onset]) -> u64 {
    let mut first = 0;
    let before = onsets.iter().enumerate().map(|(later, onset)| {
        while onset.time_s - onsets[first].time_s > LONGEST_S {
            first += 1;
        }
        (later - first) as u64
    });
    before.map(|before| before * before).sum()
}

/// The chain with the most evidence, if any has enough impacts.
pub(super) fn best(onsets: &[Onset], span: Span) -> Option<Chain> {
    let around = Surroundings::of(onsets, span);
    let mut nodes: Vec<(State, Origin)> = Vec::new();
    // The nodes that end at onset j are nodes[ends[j]..ends[j + 1]].
    let mut ends = vec![0];
    for later in 0..onsets.len() {
        for earlier in (0..later).rev() {
            let interval_s = onsets[later].time_s - onsets[earlier].time_s;
            if interval_s > LONGEST_S {
                break;
            }
            if interval_s < SHORTEST_S {
                continue;
            }
            let step = Step::new(onsets, &around, (earlier, later));
            if step.common < HOPELESS_STEP {
                continue;
            }
            let before = ends[earlier]..ends[earlier + 1];
            let mut ways = survivors(&nodes, before, earlier, &step);
            // A drop begins with its loudest impacts; only later ones may be faint.
            if onsets[earlier].stands_out() && onsets[later].stands_out() {
                let origin = |way| (way, Origin::beginning(earlier));
                ways.extend(Way::beginnings(&step, &around[earlier]).map(origin));
            }
            let reached = |(way, origin)| (State::new(way), origin);
            nodes.extend(ways.into_iter().map(reached));
        }
        ends.push(nodes.len());
    }
    let way = |node: usize| &nodes[node].0.way;
    let end = (0..nodes.len())
        .filter(|&n| way(n).ratios as usize + 2 >= FEWEST_IMPACTS)
        .max_by(|&a, &b| way(a).evidence.total_cmp(&way(b).evidence))?;
    let last_onset = ends.partition_point(|&e| e <= end) - 1;
    let evidence = way(end).evidence;
    Some(Chain {
        links: trace(&nodes, end, last_onset),
        evidence,
        around,
    })
}

/// The best ways to a pair, one for each ratio that may follow from it.
fn survivors(
    nodes: &[(State, Origin)],
    before: Range<usize>,
    from: usize,
    step: &Step,
) -> Vec<(Way, Origin)> {
    let mut kept: Vec<(Way, Origin)> = Vec::new();
    for back in before {
        let state = &nodes[back].0;
        let least = if kept.len() < KEPT {
            PRUNE_BELOW
        } else {
            kept[KEPT - 1].0.evidence
        };
        let most = state.way.evidence + step.common + step.most + state.most;
        for missed in 0..=MOST_MISSED {
            if most + missed as f64 * evidence::LN_MISSED <= least {
                break;
            }
            if let Some(next) = state.next(step, missed, least) {
                let origin = Origin {
                    from: from as u32,
                    missed: missed as u32,
                    back: Some(back as u32),
                };
                keep(&mut kept, next, origin);
            }
        }
    }
    kept
}

/// Puts a way in its place by evidence, unless a better one expects the same ratio and scatter.
fn keep(kept: &mut Vec<(Way, Origin)>, way: Way, origin: Origin) {
    let ln_ratio = way.ln_ratio();
    let alike = |(other, _): &(Way, Origin)| {
        let scatter = other.scatter2.max(way.scatter2) / other.scatter2.min(way.scatter2);
        (other.ln_ratio() - ln_ratio).abs() < SAME_RATIO && scatter < SAME_SCATTER
    };
    let place = kept.partition_point(|(other, _)| other.evidence >= way.evidence);
    if kept[..place].iter().any(alike) {
        return;
    }
    if let Some(worse) = (place..kept.len()).find(|&i| alike(&kept[i])) {
        kept.remove(worse);
    }
    kept.insert(place, (way, origin));
    kept.truncate(KEPT);
}

/// The way to a node, from its beginning.
fn trace(nodes: &[(State, Origin)], end: usize, last_onset: usize) -> Vec<Link> {
    let mut links = vec![Link {
        onset: last_onset,
        number: 0,
    }];
    let mut at = Some(end as u32);
    let mut back_number = 0;
    while let Some(index) = at {
        let origin = &nodes[index as usize].1;
        back_number += origin.missed + 1;
        links.push(Link {
            onset: origin.from as usize,
            number: back_number,
        });
        at = origin.back;
    }
    links.reverse();
    for link in &mut links {
        link.number = back_number - link.number;
    }
    links
}

/// The most likely number of each onset, if all of them are impacts of one drop.
pub(super) fn numbers(onsets: &[Onset]) -> Option<Vec<u32>> {
    let around = Surroundings::of(onsets, Span::EVER);
    let mut ways: Vec<(Way, Vec<u32>)> = Vec::new();
    for later in 1..onsets.len() {
        let step = Step::new(onsets, &around, (later - 1, later));
        if later == 1 {
            ways.extend(Way::beginnings(&step, &around[0]).map(|birth| (birth, vec![0, 1])));
            continue;
        }
        let mut longer: Vec<(Way, Vec<u32>)> = Vec::new();
        for (way, numbers) in ways {
            let state = State::new(way);
            for missed in 0..=MOST_MISSED {
                if let Some(next) = state.next(&step, missed, f64::NEG_INFINITY) {
                    let last = numbers[numbers.len() - 1];
                    let number = last + 1 + missed as u32;
                    longer.push((next, [numbers.as_slice(), &[number]].concat()));
                }
            }
        }
        sort_by_number(&mut longer, |(way, ..)| -way.evidence);
        longer.truncate(KEPT);
        ways = longer;
    }
    ways.into_iter().next().map(|(_, numbers)| numbers)
}

/// The intervals between these, each as if all flights in it took equally long.
pub(super) fn beats(onsets: &[Onset], links: &[Link]) -> Vec<Beat> {
    let beat = |pair: &[Link]| {
        let interval_s = onsets[pair[1].onset].time_s - onsets[pair[0].onset].time_s;
        let (from, to) = (f64::from(pair[0].number), f64::from(pair[1].number));
        Beat {
            number: 0.5 * (from + to),
            ln_interval: (interval_s / (to - from)).ln(),
        }
    };
    links.windows(2).map(beat).collect()
}

/// A step of a chain, and how many impacts were missed in it.
struct Stride {
    from: usize,
    step: Step,
    missed: usize,
}

/// Where these strides lead on a way.
fn follow(way: Way, strides: &[Stride]) -> Option<Way> {
    strides.iter().try_fold(way, |way, stride| way.by(stride))
}

impl Chain {
    /// The evidence that is left if the onset at each position is taken for a missed impact.
    pub(super) fn evidence_without_each(&self, onsets: &[Onset]) -> Vec<f64> {
        let bridge = |from: usize, to: usize| self.stride(onsets, self.links[from], self.links[to]);
        let strides: Vec<Stride> = (1..self.links.len()).map(|n| bridge(n - 1, n)).collect();
        // Where each surface had led to before the onset that is left out.
        let mut before: Vec<Option<Way>> = Vec::new();
        let evidences = (0..self.links.len()).map(|position| {
            let after = strides.get(position + 1..).unwrap_or_default();
            let over = (0 < position && position < strides.len())
                .then(|| bridge(position - 1, position + 1));
            let ways: Vec<Option<Way>> = match (position, &over) {
                (0, _) => after
                    .first()
                    .map_or_else(Vec::new, |it| self.beginnings(it)),
                (1, Some(over)) => self.beginnings(over),
                (_, Some(over)) => before
                    .iter()
                    .map(|way| way.and_then(|it| it.by(over)))
                    .collect(),
                (_, None) => before.clone(),
            };
            let begun = usize::from(position == 0);
            let rest = after.get(begun..).unwrap_or_default();
            before = match position {
                0 => Vec::new(),
                1 => self.beginnings(&strides[0]),
                _ => before
                    .iter()
                    .map(|way| way.and_then(|it| it.by(&strides[position - 1])))
                    .collect(),
            };
            let ends = ways.into_iter().filter_map(|way| follow(way?, rest));
            ends.map(|way| way.evidence)
                .fold(f64::NEG_INFINITY, f64::max)
        });
        evidences.collect()
    }

    /// The way by this sequence of onsets, on the surface on which it has more evidence.
    fn way_after(&self, onsets: &[Onset]) -> Option<Way> {
        let pairs = self.links.windows(2);
        let strides: Vec<Stride> = pairs.map(|p| self.stride(onsets, p[0], p[1])).collect();
        let (first, rest) = strides.split_first()?;
        let ways = self.beginnings(first).into_iter();
        ways.filter_map(|way| follow(way?, rest))
            .max_by(|a, b| a.evidence.total_cmp(&b.evidence))
    }

    /// Logarithm of how likely these flights are for a ball, given the first.
    pub(super) fn ln_flights(&self, onsets: &[Onset]) -> f64 {
        let best = self.ln_each_flight(onsets);
        best.map_or(f64::NEG_INFINITY, |(ln_prior, flights)| {
            flights.iter().fold(ln_prior, |sum, ln| sum + ln)
        })
    }

    /// The same of each flight after the first, on the surface on which they are most likely, and how usual that is.
    fn ln_each_flight(&self, onsets: &[Onset]) -> Option<(f64, Vec<f64>)> {
        let pairs = self.links.windows(2);
        let strides: Vec<Stride> = pairs.map(|p| self.stride(onsets, p[0], p[1])).collect();
        let (first, rest) = strides.split_first()?;
        let ways = self.beginnings(first).into_iter().flatten();
        let on_each = ways
            .zip(&evidence::SURFACES)
            .filter_map(|(birth, surface)| {
                let mut way = birth;
                let flights = rest.iter().map(|stride| {
                    let ln = way.ln_flight(stride)?;
                    way = way.by(stride)?;
                    Some(ln)
                });
                Some((surface.ln_prior, flights.collect::<Option<Vec<f64>>>()?))
            });
        let ln = |(ln_prior, flights): &(f64, Vec<f64>)| ln_prior + flights.iter().sum::<f64>();
        on_each.max_by(|a, b| ln(a).total_cmp(&ln(b)))
    }

    /// Ends the chain where its sounds begin to keep time, if that is more likely than that the ball goes on, and
    /// returns those sounds: the flights of a ball shrink until they are as long as the beat of steady sounds, which
    /// then look as if it went on.
    pub(super) fn end_at_rhythm(&mut self, onsets: &[Onset]) -> Option<Vec<Link>> {
        let (_, flights) = self.ln_each_flight(onsets)?;
        let beats = beats(onsets, &self.links);
        let end = rhythm::likeliest_beginning(&beats, &flights, FEWEST_IMPACTS)?;
        // Its first interval may be any.
        let rhythm = rhythm::ln_likelihood(&beats[end..]) + rhythm::LN_ANY;
        let begins = if self.is_heard_before(onsets, end, beats[end].interval_s()) {
            0.0
        } else {
            // The interval after the last impact may be any too, and what begins is as rare as a drop.
            rhythm::LN_ANY + evidence::LN_BIRTH
        };
        let ball: f64 = flights[end - 2..].iter().sum();
        if rhythm + rhythm::LN_USUAL + begins <= ball {
            return None;
        }
        let whole = self.way_after(onsets)?.evidence;
        let rest = self.links.split_off(end);
        self.evidence += self.way_after(onsets)?.evidence - whole;
        Some(rest)
    }

    /// Whether other sounds than those of this chain kept the same time before the one at this place.
    fn is_heard_before(&self, onsets: &[Onset], place: usize, interval_s: f64) -> bool {
        let mut pulse = Pulse::like(onsets, &self.links[place..]);
        pulse.follow(self.links[place].onset, -interval_s);
        let is_other = |index: usize| self.links.iter().all(|link| link.onset != index);
        let others = pulse.onsets(true).filter(|(index, _)| is_other(*index));
        others.count() >= FEWEST_IMPACTS
    }

    fn stride(&self, onsets: &[Onset], from: Link, to: Link) -> Stride {
        Stride {
            from: from.onset,
            step: Step::new(onsets, &self.around, (from.onset, to.onset)),
            missed: (to.number - from.number - 1) as usize,
        }
    }

    /// A train that begins so, on each surface.
    fn beginnings(&self, first: &Stride) -> Vec<Option<Way>> {
        let beginnings = Way::beginnings(&first.step, &self.around[first.from]);
        beginnings.map(Some).collect()
    }

    /// Goes on after the last impact, down to the faintest: what is known of the drop by now says
    /// when the next one must come and how loud, so that it need not stand out of the other sounds. `ln_odds` is
    /// the logarithm of the odds that there is one.
    pub(super) fn extend(&mut self, onsets: &[Onset], ln_odds: f64) {
        let Some(mut way) = self.way_after(onsets) else {
            return;
        };
        loop {
            let state = State::new(way);
            let last = self.links[self.links.len() - 1];
            let near = onsets[last.onset + 1..]
                .iter()
                .take_while(|o| o.time_s - onsets[last.onset].time_s < LONGEST_S);
            let enough = way.evidence - ln_odds;
            let mut best: Option<(Way, Link)> = None;
            for (ahead, _) in near.enumerate() {
                let onset = last.onset + 1 + ahead;
                let mut step = Step::new(onsets, &self.around, (last.onset, onset));
                if step.interval_s < SHORTEST_S {
                    continue;
                }
                let around = &self.around[onset];
                step.common += around.any_by_chance(step.interval_s).ln()
                    - around.by_chance(step.interval_s).ln();
                for missed in 0..=MOST_MISSED {
                    let least = best.as_ref().map_or(enough, |b| b.0.evidence);
                    if let Some(next) = state.next(&step, missed, least) {
                        let number = last.number + 1 + missed as u32;
                        best = Some((next, Link { onset, number }));
                    }
                }
            }
            let Some((next, link)) = best else {
                return;
            };
            self.evidence += next.evidence - way.evidence;
            way = next;
            self.links.push(link);
        }
    }
}
