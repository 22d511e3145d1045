//! The best chain of onsets by dynamic programming.
//!
//! A pair of successive impacts determines the last flight, and the impacts before the pair determine the
//! ratio to expect next. Each pair keeps its few best hypotheses (the Viterbi algorithm with
//! per-survivor processing of the ratio: Raheli, Polydoros and Tzou 1995). So the cost is that of trying every impact after
//! every pair, not that of every subset.

mod hypothesis;
mod trend;

use std::iter;
use std::ops::Range;

use super::evidence::{Span, Surroundings};
use super::parameters::{
    LN_DROP, LN_FIRST_INTERVAL, LN_MISSED, LN_RHYTHM, MAX_DOUBTED, MAX_GROWTH_SIGMA,
    MAX_HYPOTHESES, MAX_INTERVAL_S, MAX_MISSED, MIN_DOUBTED_EVIDENCE, MIN_FLIGHT_S,
    MIN_PURSUED_EVIDENCE, MIN_RATIO_DIFFERENCE, MIN_SCATTER_RATIO, MIN_STEP_EVIDENCE, SURFACES,
};
use super::rhythm::{self, Beat, Pulse};
use super::{MIN_IMPACTS, Onset};
use crate::stats::sort_by_number;
use hypothesis::{Hypothesis, State, Step, Transition};

/// A sequence of onsets that may be the impacts of a drop.
pub(super) struct Chain<'s> {
    pub(super) links: Vec<Link>,
    pub(super) evidence: f64,
    around: &'s [Surroundings],
    /// The onsets that are impacts only if the others are, each with the logarithm of the odds of that.
    doubted: Vec<(usize, f64)>,
}

/// A chain with one impact more than another.
pub(super) struct Longer<'s> {
    pub(super) chain: Chain<'s>,
    /// The onset of that impact.
    pub(super) onset: usize,
    /// Logarithm of the odds, by its time and its level, that it is an impact of the other chain, if that is a drop.
    pub(super) ln_odds: f64,
}

impl<'s> Longer<'s> {
    /// The longer chain, if these are the odds of its impact by all that is known of it.
    pub(super) fn accepted(self, ln_odds: f64) -> Chain<'s> {
        let mut chain = self.chain;
        chain.doubted.push((self.onset, ln_odds));
        chain
    }
}

/// All chains of some onsets that are worth pursuing.
pub(super) struct Chains<'o> {
    pub(super) onsets: &'o [Onset],
    around: Vec<Surroundings>,
    nodes: Vec<(State, Origin)>,
    /// The nodes that end at onset j are `nodes[ends[j]..ends[j + 1]]`.
    ends: Vec<usize>,
}

/// One onset of a chain and its number, missed impacts counted.
#[derive(Clone, Copy)]
pub(super) struct Link {
    pub(super) onset: usize,
    pub(super) number: u32,
}

/// The origin of a hypothesis: the onset and node before, and the number of impacts missed in between.
struct Origin {
    from: u32,
    missed: u32,
    back: Option<u32>,
}

impl Origin {
    /// Of a train whose first impact is this onset.
    fn initial(onset: usize) -> Self {
        Self {
            from: onset as u32,
            missed: 0,
            back: None,
        }
    }
}

/// A measure of the computation that a search among onsets takes: for each, the pairs of others from which a flight may
/// lead to it.
pub(crate) fn work(onsets: &[Onset]) -> u64 {
    let mut first = 0;
    let before = onsets.iter().enumerate().map(|(later, onset)| {
        while onset.time_s - onsets[first].time_s > MAX_INTERVAL_S {
            first += 1;
        }
        (later - first) as u64
    });
    before.map(|before| before * before).sum()
}

impl<'o> Chains<'o> {
    /// The search among onsets, which are all of this span.
    pub(super) fn of(onsets: &'o [Onset], span: Span) -> Self {
        let around = Surroundings::of(onsets, span);
        let mut nodes: Vec<(State, Origin)> = Vec::new();
        let mut ends = vec![0];
        for later in 0..onsets.len() {
            for earlier in (0..later).rev() {
                let interval_s = onsets[later].time_s - onsets[earlier].time_s;
                if interval_s > MAX_INTERVAL_S {
                    break;
                }
                if interval_s < MIN_FLIGHT_S {
                    continue;
                }
                let step = Step::new(onsets, &around, (earlier, later));
                if step.common < MIN_STEP_EVIDENCE {
                    continue;
                }
                let before = ends[earlier]..ends[earlier + 1];
                let mut survivors = survivors(&nodes, before, earlier, &step);
                // A drop begins with its loudest impacts; only later ones may be faint.
                if onsets[earlier].stands_out() && onsets[later].stands_out() {
                    let with_origin = |hypothesis| (hypothesis, Origin::initial(earlier));
                    survivors.extend(Hypothesis::initial(&step, &around[earlier]).map(with_origin));
                }
                // Only survivors get their predictions, which are the expensive part of a state.
                let node = |(hypothesis, origin)| (State::new(hypothesis), origin);
                nodes.extend(survivors.into_iter().map(node));
            }
            ends.push(nodes.len());
        }
        Self {
            onsets,
            around,
            nodes,
            ends,
        }
    }

    /// The chain with the most evidence, if any has at least this many impacts.
    pub(super) fn best(&self, min_impacts: usize) -> Option<Chain<'_>> {
        let hypothesis = |node: usize| &self.nodes[node].0.hypothesis;
        let end = (0..self.nodes.len())
            .filter(|&node| hypothesis(node).impacts() >= min_impacts)
            .max_by(|&a, &b| hypothesis(a).evidence.total_cmp(&hypothesis(b).evidence))?;
        Some(self.chain(end))
    }

    /// The chains of at least this many impacts that have most evidence, at most [`MAX_DOUBTED`] and the best first; of those
    /// that share most of their impacts only the best.
    pub(super) fn several(&self, min_impacts: usize) -> Vec<Chain<'_>> {
        let hypothesis = |node: usize| &self.nodes[node].0.hypothesis;
        let is_doubted = |node: &usize| {
            let hypothesis = hypothesis(*node);
            hypothesis.impacts() >= min_impacts && hypothesis.evidence > MIN_DOUBTED_EVIDENCE
        };
        let mut ends: Vec<usize> = (0..self.nodes.len()).filter(is_doubted).collect();
        sort_by_number(&mut ends, |&node| hypothesis(node).evidence);
        let mut chains: Vec<Chain> = Vec::new();
        while chains.len() < MAX_DOUBTED
            && let Some(end) = ends.pop()
        {
            let chain = self.chain(end);
            if !chains.iter().any(|better| chain.is_mostly_in(better)) {
                chains.push(chain);
            }
        }
        chains
    }

    /// The chain that ends with this node.
    fn chain(&self, end: usize) -> Chain<'_> {
        let last_onset = self.ends.partition_point(|&e| e <= end) - 1;
        Chain {
            links: trace(&self.nodes, end, last_onset),
            evidence: self.nodes[end].0.hypothesis.evidence,
            around: &self.around,
            doubted: Vec::new(),
        }
    }
}

/// The best hypotheses that end with a pair of onsets, one for each ratio that may follow it.
fn survivors(
    nodes: &[(State, Origin)],
    before: Range<usize>,
    from: usize,
    step: &Step,
) -> Vec<(Hypothesis, Origin)> {
    let mut kept: Vec<(Hypothesis, Origin)> = Vec::new();
    for back in before {
        let state = &nodes[back].0;
        let min_evidence = if kept.len() < MAX_HYPOTHESES {
            MIN_PURSUED_EVIDENCE
        } else {
            kept[MAX_HYPOTHESES - 1].0.evidence
        };
        // A bound without logarithms, which excludes most pairs of state and step.
        let bound = state.hypothesis.evidence + step.common + step.max_fall + state.max_ratio;
        for missed in 0..=MAX_MISSED {
            if bound + missed as f64 * LN_MISSED <= min_evidence {
                break;
            }
            if let Some(next) = state.next(step, missed, min_evidence) {
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

/// Inserts a hypothesis in the order of evidence, unless a better one predicts the same ratio and scatter.
fn keep(kept: &mut Vec<(Hypothesis, Origin)>, hypothesis: Hypothesis, origin: Origin) {
    let ln_ratio = hypothesis.ln_ratio();
    let predicts_the_same = |(other, _): &(Hypothesis, Origin)| {
        let scatter =
            other.scatter2.max(hypothesis.scatter2) / other.scatter2.min(hypothesis.scatter2);
        (other.ln_ratio() - ln_ratio).abs() < MIN_RATIO_DIFFERENCE && scatter < MIN_SCATTER_RATIO
    };
    let index = kept.partition_point(|(other, _)| other.evidence >= hypothesis.evidence);
    if kept[..index].iter().any(predicts_the_same) {
        return;
    }
    if let Some(worse) = (index..kept.len()).find(|&i| predicts_the_same(&kept[i])) {
        kept.remove(worse);
    }
    kept.insert(index, (hypothesis, origin));
    kept.truncate(MAX_HYPOTHESES);
}

/// The onsets of the hypothesis of a node, from the first to the last.
fn trace(nodes: &[(State, Origin)], end: usize, last_onset: usize) -> Vec<Link> {
    // Backwards, with the numbers counted from the last impact.
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
    let around = Surroundings::of(onsets, Span::UNBOUNDED);
    let mut hypotheses: Vec<(Hypothesis, Vec<u32>)> = Vec::new();
    for later in 1..onsets.len() {
        let step = Step::new(onsets, &around, (later - 1, later));
        if later == 1 {
            let initial = Hypothesis::initial(&step, &around[0]);
            hypotheses.extend(initial.map(|hypothesis| (hypothesis, vec![0, 1])));
            continue;
        }
        let mut longer: Vec<(Hypothesis, Vec<u32>)> = Vec::new();
        for (hypothesis, numbers) in hypotheses {
            let state = State::new(hypothesis);
            for missed in 0..=MAX_MISSED {
                if let Some(next) = state.next(&step, missed, f64::NEG_INFINITY) {
                    let last = numbers[numbers.len() - 1];
                    let number = last + 1 + missed as u32;
                    longer.push((next, [numbers.as_slice(), &[number]].concat()));
                }
            }
        }
        sort_by_number(&mut longer, |(hypothesis, ..)| -hypothesis.evidence);
        longer.truncate(MAX_HYPOTHESES);
        hypotheses = longer;
    }
    let best = hypotheses.into_iter().next();
    best.map(|(_, numbers)| numbers)
}

/// The intervals between these onsets, each divided by the number of flights in it.
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

impl<'s> Chain<'s> {
    /// Whether most impacts of the shorter of the two are impacts of both.
    fn is_mostly_in(&self, other: &Self) -> bool {
        let is_shared = |link: &&Link| {
            let same = other.links.binary_search_by_key(&link.onset, |it| it.onset);
            same.is_ok()
        };
        let shared = self.links.iter().filter(is_shared).count();
        2 * shared > self.links.len().min(other.links.len())
    }

    /// The evidence that remains if the onset at each index is taken for a missed impact.
    pub(super) fn evidence_without_each(&self, onsets: &[Onset]) -> Vec<f64> {
        let transitions = self.transitions(onsets);
        // The hypotheses of each surface up to the onset before the one that is left out.
        let mut before: Vec<Option<Hypothesis>> = Vec::new();
        let evidences = (0..self.links.len()).map(|index| {
            // The transition over the left-out onset replaces those to it and from it.
            let later = transitions.get(index + 1..).unwrap_or_default();
            let over = (0 < index && index < transitions.len())
                .then(|| self.transition(onsets, self.links[index - 1], self.links[index + 1]));
            let after_it: Vec<Option<Hypothesis>> = match (index, &over) {
                // Without the first onset the chain begins with the second transition.
                (0, _) => later.first().map_or_else(Vec::new, |it| self.initial(it)),
                // Without the second it begins with the transition over it.
                (1, Some(over)) => self.initial(over),
                (_, Some(over)) => before
                    .iter()
                    .map(|hypothesis| hypothesis.and_then(|it| it.after(over)))
                    .collect(),
                // Without the last one it ends where it is.
                (_, None) => before.clone(),
            };
            let used = usize::from(index == 0);
            let rest = later.get(used..).unwrap_or_default();
            before = match index {
                0 => Vec::new(),
                1 => self.initial(&transitions[0]),
                _ => before
                    .iter()
                    .map(|hypothesis| hypothesis.and_then(|it| it.after(&transitions[index - 1])))
                    .collect(),
            };
            let ends = after_it.into_iter().filter_map(|it| it?.after_all(rest));
            ends.map(|hypothesis| hypothesis.evidence)
                .fold(f64::NEG_INFINITY, f64::max)
        });
        evidences.collect()
    }

    /// The hypothesis of this sequence of onsets, on the surface on which it has more evidence.
    fn hypothesis(&self, onsets: &[Onset]) -> Option<Hypothesis> {
        let transitions = self.transitions(onsets);
        let (first, rest) = transitions.split_first()?;
        let on_each = self.initial(first).into_iter();
        on_each
            .filter_map(|hypothesis| hypothesis?.after_all(rest))
            .max_by(|a, b| a.evidence.total_cmp(&b.evidence))
    }

    /// Log likelihood of these flights for a ball, given the first.
    pub(super) fn ln_flights(&self, onsets: &[Onset]) -> f64 {
        let best = self.ln_each_flight(onsets);
        best.map_or(f64::NEG_INFINITY, |(ln_prior, flights)| {
            flights.iter().fold(ln_prior, |sum, ln| sum + ln)
        })
    }

    /// The log density of each flight after the first, on the surface on which they are most likely, and the log prior of
    /// that surface.
    fn ln_each_flight(&self, onsets: &[Onset]) -> Option<(f64, Vec<f64>)> {
        let transitions = self.transitions(onsets);
        let (first, rest) = transitions.split_first()?;
        let initial = self.initial(first).into_iter().flatten();
        let on_each = initial
            .zip(&SURFACES)
            .filter_map(|(mut hypothesis, surface)| {
                let flights = rest.iter().map(|transition| {
                    let ln = hypothesis.ln_density(transition)?;
                    hypothesis = hypothesis.after(transition)?;
                    Some(ln)
                });
                Some((surface.ln_prior, flights.collect::<Option<Vec<f64>>>()?))
            });
        let ln = |(ln_prior, flights): &(f64, Vec<f64>)| ln_prior + flights.iter().sum::<f64>();
        on_each.max_by(|a, b| ln(a).total_cmp(&ln(b)))
    }

    /// Ends the chain where its sounds begin to keep time, if that is more likely than that the ball bounces on, and
    /// returns those sounds: the flights of a ball shrink until they are as long as the interval of steady sounds, which
    /// then look like further impacts.
    pub(super) fn end_at_rhythm(&mut self, onsets: &[Onset]) -> Option<Vec<Link>> {
        let (_, flights) = self.ln_each_flight(onsets)?;
        let beats = beats(onsets, &self.links);
        let end = rhythm::likeliest_beginning(&beats, &flights, MIN_IMPACTS)?;
        let ln_beats = rhythm::ln_likelihood(&beats[end..]) + LN_FIRST_INTERVAL;
        let ln_beginning = if self.is_continued_before(onsets, end, beats[end].interval_s()) {
            0.0
        } else {
            // The interval after the last impact may be any too, and a rhythm that begins just here is as rare as a drop.
            LN_FIRST_INTERVAL + LN_DROP
        };
        // flights[k] ends at link k + 2, so these are the flights that end at link `end` and later.
        let ln_ball: f64 = flights[end - 2..].iter().sum();
        if ln_beats + LN_RHYTHM + ln_beginning <= ln_ball {
            return None;
        }
        let whole = self.hypothesis(onsets)?.evidence;
        let rest = self.links.split_off(end);
        self.evidence += self.hypothesis(onsets)?.evidence - whole;
        Some(rest)
    }

    /// Whether other sounds than those of this chain keep the same time before the link of this index.
    fn is_continued_before(&self, onsets: &[Onset], index: usize, interval_s: f64) -> bool {
        let mut pulse = Pulse::like(onsets, &self.links[index..]);
        pulse.follow(self.links[index].onset, -interval_s);
        let is_other = |onset: usize| self.links.iter().all(|link| link.onset != onset);
        let others = pulse.onsets(true).filter(|(onset, _)| is_other(*onset));
        others.count() >= MIN_IMPACTS
    }

    fn transitions(&self, onsets: &[Onset]) -> Vec<Transition> {
        let pairs = self.links.windows(2);
        pairs
            .map(|pair| self.transition(onsets, pair[0], pair[1]))
            .collect()
    }

    fn transition(&self, onsets: &[Onset], from: Link, to: Link) -> Transition {
        Transition {
            from: from.onset,
            step: Step::new(onsets, self.around, (from.onset, to.onset)),
            missed: (to.number - from.number - 1) as usize,
        }
    }

    /// The initial states of a train that begins with this transition, one for each surface.
    fn initial(&self, first: &Transition) -> Vec<Option<Hypothesis>> {
        let initial = Hypothesis::initial(&first.step, &self.around[first.from]);
        initial.map(Some).collect()
    }

    /// Its onsets.
    pub(super) fn sounds(&self, onsets: &[Onset]) -> Vec<Onset> {
        self.links.iter().map(|link| onsets[link.onset]).collect()
    }

    /// Maximum logarithm of the odds that this onset is an impact, if the others are.
    pub(super) fn ln_odds_of(&self, onset: usize) -> f64 {
        let doubted = self.doubted.iter().find(|(doubted, _)| *doubted == onset);
        doubted.map_or(f64::INFINITY, |(_, ln_odds)| *ln_odds)
    }

    /// The chains that have one impact more, before the first or after the last one. `ln_odds` is the logarithm of the odds that
    /// there is one.
    pub(super) fn longer(&self, onsets: &[Onset], ln_odds: f64) -> Vec<Longer<'s>> {
        let Some(hypothesis) = self.hypothesis(onsets) else {
            return Vec::new();
        };
        let flight_s = |from: Link, to: Link| {
            let interval_s = onsets[to.onset].time_s - onsets[from.onset].time_s;
            interval_s / f64::from(to.number - from.number)
        };
        let last = self.links.len() - 1;
        let last_flight_s = flight_s(self.links[last - 1], self.links[last]);
        // A sound that is alike may be an impact of another drop, whose flights are longer.
        let max_flight_s = last_flight_s * (MAX_GROWTH_SIGMA * hypothesis.scatter2.sqrt()).exp();
        let later = self.next(onsets, &hypothesis);
        let later = later.filter(|(_, link)| flight_s(self.links[last], *link) < max_flight_s);
        let later = later.map(|(next, link)| {
            let more = next.evidence - hypothesis.evidence;
            Longer {
                chain: self.with([self.links.as_slice(), &[link]].concat(), more),
                onset: link.onset,
                ln_odds: ln_odds + more,
            }
        });
        let first = self.links[0].onset;
        let near = (0..first)
            .rev()
            .take_while(|&onset| onsets[first].time_s - onsets[onset].time_s < MAX_INTERVAL_S);
        let earlier = near.filter_map(|onset| {
            let later = self.links.iter().map(|link| Link {
                number: link.number + 1,
                ..*link
            });
            let links = iter::once(Link { onset, number: 0 }).chain(later);
            let mut chain = self.with(links.collect(), 0.0);
            let more = chain.hypothesis(onsets)?.evidence - hypothesis.evidence;
            chain.evidence += more;
            // How rare drops are is no evidence here: the drop is certain, only its beginning is not.
            let rarity = self.around[onset].ln_drop() - self.around[first].ln_drop();
            Some(Longer {
                chain,
                onset,
                ln_odds: ln_odds + more - rarity,
            })
        });
        earlier.chain(later).collect()
    }

    /// A chain of other links, with this much more evidence.
    fn with(&self, links: Vec<Link>, more: f64) -> Self {
        Self {
            links,
            evidence: self.evidence + more,
            around: self.around,
            doubted: self.doubted.clone(),
        }
    }

    /// The hypotheses after each impact that may follow.
    fn next(
        &self,
        onsets: &[Onset],
        hypothesis: &Hypothesis,
    ) -> impl Iterator<Item = (Hypothesis, Link)> {
        let state = State::new(*hypothesis);
        let last = self.links[self.links.len() - 1];
        let interval_s = move |onset: usize| onsets[onset].time_s - onsets[last.onset].time_s;
        let near =
            (last.onset + 1..onsets.len()).take_while(move |&o| interval_s(o) < MAX_INTERVAL_S);
        let far_enough = near.filter(move |&onset| interval_s(onset) >= MIN_FLIGHT_S);
        far_enough.filter_map(move |onset| {
            let mut step = Step::new(onsets, self.around, (last.onset, onset));
            // Its strength is no evidence here: any sound may be there by chance.
            let around = &self.around[onset];
            step.common +=
                around.any_by_chance(step.interval_s).ln() - around.by_chance(step.interval_s).ln();
            let each = (0..=MAX_MISSED).filter_map(|missed| {
                let next = state.next(&step, missed, f64::NEG_INFINITY)?;
                let number = last.number + 1 + missed as u32;
                Some((next, Link { onset, number }))
            });
            each.max_by(|one, other| one.0.evidence.total_cmp(&other.0.evidence))
        })
    }

    /// Adds impacts after the last one, down to the faintest: the drop now predicts when the next one comes and how loud,
    /// so that it need not stand out of the other sounds. `ln_odds` is the logarithm of the odds that there is another.
    pub(super) fn extend(&mut self, onsets: &[Onset], ln_odds: f64) {
        let Some(mut hypothesis) = self.hypothesis(onsets) else {
            return;
        };
        loop {
            let next = self.next(onsets, &hypothesis);
            let best = next.max_by(|one, other| one.0.evidence.total_cmp(&other.0.evidence));
            let Some((next, link)) = best else {
                return;
            };
            let more = next.evidence - hypothesis.evidence;
            if more <= -ln_odds {
                return;
            }
            self.evidence += more;
            hypothesis = next;
            self.links.push(link);
        }
    }
}
