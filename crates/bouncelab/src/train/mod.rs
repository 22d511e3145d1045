//! Candidates to trains: which onsets are the impacts of one drop, and which are missing.
//!
//! The flight times of a drop shrink by a ratio that changes slowly, and the impacts of one ball
//! on one spot sound alike. Clicks, voices, claps, clocks and rallies do none of this for long.
//! So the inference is put as a choice between two explanations of the same onsets: *a drop*, whose
//! next impact is predicted by the ones before, or *other sounds*, which come when they like. The
//! logarithm of their probability ratio is the evidence, in nats. It adds up over the impacts
//! (the module `evidence`), so that the best train of all is found by dynamic programming (`chain`).
//! What is found must then stand against a third explanation: somebody or something that keeps time,
//! and may speed up (`rhythm`).
//! There is no threshold on loudness anywhere.
//!
//! ```
//! use bouncelab::onset::Onset;
//! use bouncelab::train;
//!
//! // Ten impacts whose flights shrink by 0.9, as candidates of equal sound.
//! let mut time_s = 0.1;
//! let onsets: Vec<Onset> = (0..10)
//!     .map(|n| {
//!         time_s += 0.4 * 0.9_f64.powi(n);
//!         Onset { time_s, ..Onset::click(0.0) }
//!     })
//!     .collect();
//! let found = train::find(&onsets);
//! assert_eq!(found.trains.len(), 1);
//! assert_eq!(found.trains[0].impacts().len(), 10);
//! ```

mod align;
mod chain;
mod evidence;
mod rhythm;

use crate::diagnostic::{Code, Diagnostic};
use crate::onset::Onset;
use crate::stats::{logistic, median, softplus, sort_by_number};
pub(crate) use chain::work;
use chain::{Chain, Link};
pub(crate) use evidence::{LN_MISSED, Span};
use rhythm::Pulse;
use statrs::function::beta::ln_beta;
use std::ops::Range;

/// The fewest impacts that can be told from chance: three set the ratio of the flights, two more
/// confirm it.
pub const FEWEST_IMPACTS: usize = 5;

/// Evidence in nats from which a train is believed: a drop is then more likely than other sounds.
const BELIEVED: f64 = 0.0;

/// Where the evidence is below this, in nats, for or against, the waveforms are asked too: they bring no
/// more.
const DOUBTFUL: f64 = 8.0;

/// A train that is heard this much fainter than a surer one, at the same speed of impact, is
/// another ball farther away: 12 dB is four times the distance.
const DISTANT_DB: f64 = 12.0;

/// An impact as heard.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TrainImpact {
    /// Where and how it was heard.
    pub onset: Onset,
    /// Number in the train, counted from 0 at the first impact heard; a missed impact takes a
    /// number too, so that numbers may have gaps.
    pub number: u32,
    /// Probability that this onset is an impact of the drop, given that the rest of the train is.
    pub probability: f64,
}

/// The impacts of one drop, in order of time.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Train {
    impacts: Vec<TrainImpact>,
    evidence: f64,
    log_bayes_factor: f64,
}

impl Train {
    /// The impacts heard, at least [`FEWEST_IMPACTS`], in order of time.
    pub fn impacts(&self) -> &[TrainImpact] {
        &self.impacts
    }

    /// Evidence that this is a drop and neither chance nor a rhythm, in nats.
    pub fn evidence(&self) -> f64 {
        self.evidence
    }

    /// Evidence that this is no chance, in nats: it grows with every impact that is heard well, where
    /// a rhythm is ruled out by a few.
    pub fn log_bayes_factor(&self) -> f64 {
        self.log_bayes_factor
    }

    /// Probability that this is a drop and neither chance nor a rhythm.
    pub fn probability(&self) -> f64 {
        logistic(self.evidence)
    }

    /// Time of the first impact heard, in seconds.
    pub fn start_s(&self) -> f64 {
        self.impacts[0].onset.time_s
    }

    /// Time of the last impact heard, in seconds.
    pub fn end_s(&self) -> f64 {
        self.impacts[self.impacts.len() - 1].onset.time_s
    }

    /// Whether it is the same drop as another that was found in the same recording: most impacts of the one with
    /// fewer of them are impacts of the other.
    pub fn is_same_drop(&self, other: &Self) -> bool {
        /// Impacts whose times were sharpened are nearer to each other.
        const SAME_S: f64 = 0.003;
        let [fewer, more] = if self.impacts.len() < other.impacts.len() {
            [self, other]
        } else {
            [other, self]
        };
        let times_s = fewer.impacts.iter().map(|impact| impact.onset.time_s);
        let shared = times_s.filter(|time_s| more.distance_s(*time_s) < SAME_S);
        2 * shared.count() > fewer.impacts.len()
    }

    /// How far the nearest impact is from a time, in seconds.
    fn distance_s(&self, time_s: f64) -> f64 {
        let after = self.impacts.partition_point(|i| i.onset.time_s < time_s);
        let near = self.impacts[after.saturating_sub(1)..].iter().take(2);
        near.map(|impact| (impact.onset.time_s - time_s).abs())
            .fold(f64::INFINITY, f64::min)
    }

    /// Whether an onset is one of its impacts.
    pub(crate) fn has(&self, onset: &Onset) -> bool {
        self.distance_s(onset.time_s) <= 0.0
    }

    /// Whether another goes on meanwhile: not only its end or its beginning.
    fn is_beside(&self, other: &Self) -> bool {
        /// Three impacts set the ratio of the flights.
        const ENOUGH: usize = 3;
        let during = self.start_s()..=self.end_s();
        let beside = other.impacts.iter();
        let beside = beside.filter(|impact| during.contains(&impact.onset.time_s));
        beside.count() >= ENOUGH
    }

    /// Whether most impacts come equally long after one of another train: echoes, or what rattles.
    fn echoes(&self, other: &Self) -> bool {
        const SAME_S: f64 = 0.002;
        let delays_s: Vec<f64> = self
            .impacts
            .iter()
            .filter_map(|impact| {
                let after = other
                    .impacts
                    .partition_point(|i| i.onset.time_s <= impact.onset.time_s);
                let before = other.impacts.get(after.checked_sub(1)?)?;
                Some(impact.onset.time_s - before.onset.time_s)
            })
            .collect();
        let Some(usual_s) = median(delays_s.iter().copied()) else {
            return false;
        };
        let usual = delays_s
            .iter()
            .filter(|delay_s| (**delay_s - usual_s).abs() < SAME_S);
        2 * usual.count() > self.impacts.len()
    }

    /// How many impacts between the first and the last were not heard.
    pub fn missed(&self) -> usize {
        let last = self.impacts[self.impacts.len() - 1].number as usize;
        last + 1 - self.impacts.len()
    }

    /// Sharpens the times by what the sounds of the impacts have in common (`align`), and finds
    /// missed impacts, between others and after the last, where the same sound stands at the time
    /// to expect.
    ///
    /// `samples` are the recording from `start_s` on. Impacts outside them, or unlike the others,
    /// keep their times.
    pub fn align(&mut self, samples: &[f32], start_s: f64, rate_hz: f64) {
        loop {
            let heard = self.impacts.len();
            let last = self.impacts[heard - 1].number;
            self.impacts.extend(expected(&self.impacts));
            let agrees = align::align(&mut self.impacts, heard, samples, start_s, rate_hz);
            let mut index = 0;
            self.impacts.retain(|_| {
                index += 1;
                index <= heard || agrees[index - 1]
            });
            sort_by_number(&mut self.impacts, |impact| f64::from(impact.number));
            if self.impacts[self.impacts.len() - 1].number == last {
                return;
            }
        }
    }

    /// Takes in a later train if that is the same ball, heard again: its first flight is the one to expect, had
    /// the flights gone on to shrink evenly.
    fn go_on_with(&mut self, later: &Self) -> bool {
        /// A flight is never further off than this, in its logarithm.
        const FARTHEST: f64 = 0.3;
        let flight_s = |pair: &[TrainImpact]| {
            let flights = f64::from(pair[1].number - pair[0].number);
            (pair[1].onset.time_s - pair[0].onset.time_s) / flights
        };
        let last = self.impacts.len() - 1;
        let ratio = ratio_near(&self.impacts, last);
        if ratio >= 1.0 {
            return false;
        }
        let mut next_s = ratio * flight_s(&self.impacts[last - 1..]);
        let mut time_s = self.end_s();
        let mut number = self.impacts[last].number;
        while next_s > SHORTEST_S && time_s + 0.5 * next_s < later.start_s() {
            time_s += next_s;
            next_s *= ratio;
            number += 1;
        }
        let off = (flight_s(&later.impacts[..2]) / next_s).ln();
        if next_s < SHORTEST_S || off.abs() > FARTHEST {
            return false;
        }
        let impacts = later.impacts.iter().map(|impact| TrainImpact {
            number: number + impact.number,
            ..*impact
        });
        self.impacts.extend(impacts);
        self.evidence = self.evidence.max(later.evidence);
        self.log_bayes_factor += later.log_bayes_factor;
        true
    }

    /// Level in dB relative to full scale that an impact at 1 m/s would have, if the amplitude
    /// follows the speed: how near and how hard the surface is, whatever the height of the drop.
    fn level_at_unit_speed_db(&self) -> f64 {
        let levels = self
            .impacts
            .windows(2)
            .filter(|pair| pair[1].number == pair[0].number + 1)
            .map(|pair| {
                let flight_s = pair[1].onset.time_s - pair[0].onset.time_s;
                // An impact is followed by a flight of duration 2 v/g, near enough.
                pair[0].onset.level_db - 20.0 * (flight_s * 9.81 / 2.0).log10()
            });
        median(levels).unwrap_or(f64::NEG_INFINITY)
    }
}

/// What was found among the onsets.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TrainSearch {
    /// The trains, in the order of their first impacts; those of two balls at once share their time.
    pub trains: Vec<Train>,
    /// Trains left out because they are far fainter than the rest: other balls, farther away.
    pub distant: Vec<Train>,
    /// Sequences that look like a train but keep time: a clock, a machine, steps, applause.
    pub periodic: Vec<PeriodicSequence>,
}

/// Sounds that keep time, though perhaps a little faster as they go on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct PeriodicSequence {
    /// Time of the first sound in seconds.
    pub start_s: f64,
    /// Mean interval in seconds.
    pub interval_s: f64,
    /// How many sounds.
    pub count: usize,
}

impl TrainSearch {
    /// Moves the trains that are far fainter than another, surer one from `trains` to `distant`.
    pub(crate) fn set_distant_apart(&mut self) {
        let heard: Vec<(f64, f64)> = self
            .trains
            .iter()
            .map(|train| (train.level_at_unit_speed_db(), train.log_bayes_factor()))
            .collect();
        let is_distant = |&(level_db, log_bayes_factor): &(f64, f64)| {
            heard
                .iter()
                .any(|other| other.0 > level_db + DISTANT_DB && other.1 > log_bayes_factor)
        };
        let mut distant = heard.iter().map(is_distant);
        self.distant
            .extend(self.trains.extract_if(.., |_| distant.next() == Some(true)));
    }

    /// The times that two trains share, each from when on and until when, in seconds.
    pub(crate) fn at_once(&self) -> impl Iterator<Item = (f64, f64)> {
        let trains = self.trains.iter().enumerate();
        let pairs = trains.flat_map(|(place, one)| {
            let later = self.trains[place + 1..].iter();
            later.map(move |other| (other.start_s(), one.end_s().min(other.end_s())))
        });
        pairs.filter(|(start_s, end_s)| start_s < end_s)
    }

    /// How well all trains together are heard: their evidence against chance, in nats.
    pub fn log_bayes_factor(&self) -> f64 {
        self.trains.iter().map(Train::log_bayes_factor).sum()
    }

    /// Why there is no drop; `onsets` is how many candidates there were.
    pub fn no_drop(&self, onsets: usize) -> Diagnostic {
        let of_count = |code: Code| {
            let diagnostic = Diagnostic::new(code).with("count", onsets);
            diagnostic.with("needed", FEWEST_IMPACTS)
        };
        match (onsets, self.periodic.first()) {
            (_, Some(periodic)) => Diagnostic::new(Code::PeriodicSounds)
                .with("count", periodic.count)
                .with("interval_s", periodic.interval_s),
            (0, None) => Diagnostic::new(Code::NoSound),
            (n, None) if n < FEWEST_IMPACTS => of_count(Code::TooFewSounds),
            _ => of_count(Code::NoPattern),
        }
    }
}

/// Finds the drops among onset candidates, which must be in order of time.
///
/// ```
/// use bouncelab::onset::Onset;
/// use bouncelab::train;
///
/// let clock = [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0].map(Onset::click);
/// assert!(train::find(&clock).trains.is_empty());
/// ```
pub fn find(onsets: &[Onset]) -> TrainSearch {
    let mut found = TrainSearch::default();
    search(onsets, Span::EVER, &|_| Recording::default(), &mut found);
    found.set_distant_apart();
    found
}

/// The latest time at which another impact of this drop could be heard, in seconds: no flight is
/// longer than the one before it, and no more than two impacts in a row escape notice. After it the
/// ball rests, or was stopped.
///
/// ```
/// use bouncelab::onset::Onset;
/// use bouncelab::train;
///
/// let found = train::find(&[0.0, 0.5, 0.9, 1.2, 1.4].map(Onset::click));
/// let next_s = train::latest_next_s(found.trains[0].impacts());
/// assert!(next_s > 1.4 + 3.0 * 0.2);
/// ```
pub fn latest_next_s(impacts: &[TrainImpact]) -> f64 {
    /// Two impacts that were missed, and the one that was heard.
    const FLIGHTS: f64 = 3.0;
    /// No two impacts heard are farther apart, in seconds: the flight would be 5 m high.
    const LONGEST_S: f64 = 2.0;
    /// An impact is noticed this much later at most, in seconds.
    const NOTICE_S: f64 = 0.3;
    let last_flight_s = impacts
        .windows(2)
        .map(|pair| {
            let flights = f64::from(pair[1].number - pair[0].number);
            (pair[1].onset.time_s - pair[0].onset.time_s) / flights
        })
        .next_back()
        .unwrap_or(LONGEST_S);
    let last_s = impacts.last().map_or(0.0, |impact| impact.onset.time_s);
    last_s + (FLIGHTS * last_flight_s).min(LONGEST_S) + NOTICE_S
}

/// Numbers the impacts of one drop, the first 0, so that the flights shrink most evenly: an
/// interval that is too long counts for several flights.
///
/// `times_s` must increase. Where they do not look like a drop at all, every interval counts for
/// one flight.
///
/// ```
/// use bouncelab::train::number_impacts;
///
/// assert_eq!(number_impacts(&[0.0, 0.5, 0.95, 1.355]), [0, 1, 2, 3]);
/// // An impact was missed after 1.7 s.
/// let times_s = [0.0, 0.5, 0.95, 1.355, 1.7195, 2.3428, 2.6085, 2.8477];
/// assert_eq!(number_impacts(&times_s), [0, 1, 2, 3, 4, 6, 7, 8]);
/// ```
pub fn number_impacts(times_s: &[f64]) -> Vec<u32> {
    let onsets: Vec<Onset> = times_s.iter().map(|&time_s| Onset::click(time_s)).collect();
    chain::numbers(&onsets).unwrap_or_else(|| (0..times_s.len() as u32).collect())
}

/// With shorter flights, in seconds, an impact cannot be told from the ringing of another.
const SHORTEST_S: f64 = 0.012;

/// Where missing impacts should be: those between others, and the next after the last.
fn expected(impacts: &[TrainImpact]) -> Vec<TrainImpact> {
    let mut expected = Vec::new();
    for (index, pair) in impacts.windows(2).enumerate() {
        let flights = pair[1].number - pair[0].number;
        let ratio = ratio_near(impacts, index);
        let whole: f64 = (0..flights).map(|n| ratio.powf(f64::from(n))).sum();
        let mut flight_s = (pair[1].onset.time_s - pair[0].onset.time_s) / whole;
        let mut time_s = pair[0].onset.time_s;
        let is_last = index + 2 == impacts.len();
        for n in 1..=flights {
            time_s += flight_s;
            flight_s *= ratio;
            if n < flights {
                expected.push(missed(&pair[0], n, time_s, flight_s));
            } else if is_last && flight_s > SHORTEST_S {
                expected.push(missed(
                    &pair[0],
                    n + 1,
                    pair[1].onset.time_s + flight_s,
                    flight_s,
                ));
            }
        }
    }
    expected
}

/// An impact so many after another, as if it sounded like it and were a little less sure; `align` measures its level.
fn missed(before: &TrainImpact, steps: u32, time_s: f64, flight_s: f64) -> TrainImpact {
    /// Scatter of a predicted flight time.
    const SCATTER: f64 = 0.02;
    TrainImpact {
        onset: Onset {
            time_s,
            sigma_s: SCATTER * flight_s,
            ..before.onset
        },
        number: before.number + steps,
        probability: UNHEARD * before.probability,
    }
}

/// How sure an impact is that only the sound of the others made heard.
const UNHEARD: f64 = 0.95;

/// The median ratio of successive flights among the impacts around this one.
fn ratio_near(impacts: &[TrainImpact], index: usize) -> f64 {
    const AROUND: usize = 6;
    let around = &impacts[index.saturating_sub(AROUND)..(index + AROUND).min(impacts.len())];
    let ratios = around
        .windows(3)
        .filter(|three| three[2].number == three[0].number + 2)
        .map(|three| {
            let later_s = three[2].onset.time_s - three[1].onset.time_s;
            later_s / (three[1].onset.time_s - three[0].onset.time_s)
        });
    median(ratios).unwrap_or(1.0)
}

/// Finds the trains among the onsets, which are all that was heard in this span.
pub(crate) fn search(onsets: &[Onset], span: Span, read: Read, found: &mut TrainSearch) {
    let known = found.trains.len();
    let telling = telling(onsets);
    search_among(&telling, span, read, found);
    let mut new = found.trains.split_off(known);
    beside(&telling, span, read, &mut new);
    join(&mut new);
    found.trains.append(&mut new);
}

/// A part of a recording.
#[derive(Default)]
pub(crate) struct Recording {
    pub(crate) samples: Vec<f32>,
    pub(crate) start_s: f64,
    pub(crate) rate_hz: f64,
}

/// Gives the recording between two times, in seconds.
pub(crate) type Read<'a> = &'a dyn Fn(Range<f64>) -> Recording;

/// Leaves out the faint onsets where they come thick: among so many some will always lie as the
/// impacts of a drop.
fn telling(onsets: &[Onset]) -> Vec<Onset> {
    /// So many in this time to both sides, in seconds, are too many.
    const REACH_S: f64 = 3.0;
    const MANY: usize = 12;
    let faint: Vec<f64> = onsets
        .iter()
        .filter(|o| !o.stands_out())
        .map(|o| o.time_s)
        .collect();
    let is_thick = |time_s: f64| {
        let first = faint.partition_point(|t| *t < time_s - REACH_S);
        let end = faint.partition_point(|t| *t <= time_s + REACH_S);
        end - first > MANY
    };
    onsets
        .iter()
        .filter(|o| o.stands_out() || !is_thick(o.time_s))
        .copied()
        .collect()
}

/// Takes the best train and searches again before and after it.
fn search_among(onsets: &[Onset], span: Span, read: Read, found: &mut TrainSearch) {
    let best = match best(onsets, span, read, 0.0) {
        None => return,
        Some(Best::Rhythm(links)) => {
            let rest = take_periodic(onsets, &links, found);
            search_among(&rest, span, read, found);
            return;
        }
        Some(Best::Drop(train)) => train,
    };
    let before = Span {
        end_s: best.start_s() - FALL_S,
        ..span
    };
    let after = Span {
        start_s: best.end_s() + FALL_S,
        ..span
    };
    let first = onsets.partition_point(|o| o.time_s < before.end_s);
    let rest = onsets.partition_point(|o| o.time_s <= after.start_s);
    search_among(&onsets[..first], before, read, found);
    found.trains.push(best);
    search_among(&onsets[rest..], after, read, found);
}

/// What the best chain among some onsets is.
enum Best {
    Drop(Train),
    Rhythm(Vec<Link>),
}

/// The best chain, if it is more likely than chance; `ln_prior` are the odds of a drop here over those
/// anywhere.
fn best(onsets: &[Onset], span: Span, read: Read, ln_prior: f64) -> Option<Best> {
    if onsets.len() < FEWEST_IMPACTS {
        return None;
    }
    let mut chain = chain::best(onsets, span)?;
    let rhythm = chain.end_at_rhythm(onsets);
    chain.evidence += ln_prior + alone(onsets, &chain) + loudest(onsets, &chain);
    if chain.evidence.abs() < DOUBTFUL {
        chain.evidence += alike(onsets, &chain, read);
    }
    if chain.evidence < BELIEVED {
        return rhythm.map(Best::Rhythm);
    }
    chain.extend(onsets, 0.0);
    chain.end_at_rhythm(onsets);
    let beats = chain::beats(onsets, &chain.links);
    let against_rhythm =
        chain.ln_flights(onsets) - rhythm::ln_likelihood(&beats) - rhythm::LN_USUAL;
    let evidence = against_both(chain.evidence, against_rhythm);
    if evidence < BELIEVED {
        return Some(Best::Rhythm(chain.links));
    }
    let log_bayes_factor = chain.evidence;
    chain.extend(onsets, evidence::LN_GOES_ON);
    chain.end_at_rhythm(onsets);
    Some(Best::Drop(Train {
        evidence,
        log_bayes_factor,
        impacts: impacts(onsets, &chain),
    }))
}

/// Adds the drops that share their time with these: other balls that bounce meanwhile.
fn beside(onsets: &[Onset], span: Span, read: Read, trains: &mut Vec<Train>) {
    /// Of a hundred drops one has another beside it.
    const LN_TWO_AT_ONCE: f64 = -4.6;
    /// So many seconds before and after a drop another may begin or end that shares its time.
    const REACH_S: f64 = 10.0;
    let mut place = 0;
    while let Some(train) = trains.get(place) {
        let first = onsets.partition_point(|o| o.time_s < train.start_s() - REACH_S);
        let end = onsets.partition_point(|o| o.time_s <= train.end_s() + REACH_S);
        // The train itself is among them.
        let taken: Vec<&Train> = trains.iter().filter(|it| train.is_beside(it)).collect();
        let is_free = |onset: &&Onset| !taken.iter().any(|it| it.has(onset));
        let rest: Vec<Onset> = onsets[first..end].iter().filter(is_free).copied().collect();
        let found = match best(&rest, span, read, LN_TWO_AT_ONCE) {
            Some(Best::Drop(other)) if train.is_beside(&other) && !other.echoes(train) => other,
            _ => {
                place += 1;
                continue;
            }
        };
        // What was found of it before or after the first one alone is a part of it. Only a larger train takes the
        // place of others, so that no two can take each other's for ever.
        let grows = |known: &Train| known.impacts.len() < found.impacts.len();
        let mut same = trains.iter().filter(|known| known.is_same_drop(&found));
        if same.all(grows) && !train.is_same_drop(&found) {
            trains.retain(|known| !known.is_same_drop(&found));
            trains.push(found);
        } else {
            place += 1;
        }
    }
    sort_by_number(trains, Train::start_s);
}

/// Joins trains, in order of their beginnings, with the one that ended last before them if that is the same ball.
fn join(trains: &mut Vec<Train>) {
    let mut place = 1;
    while place < trains.len() {
        let (earlier, later) = trains.split_at_mut(place);
        let later = &later[0];
        let before = earlier.iter_mut().filter(|it| it.end_s() < later.start_s());
        let last = before.max_by(|a, b| a.end_s().total_cmp(&b.end_s()));
        if last.is_some_and(|last| last.go_on_with(later)) {
            trains.remove(place);
        } else {
            place += 1;
        }
    }
}

/// Takes out a sequence that keeps time, with what goes on with its beat before and after; returns the
/// other sounds.
fn take_periodic(onsets: &[Onset], links: &[Link], found: &mut TrainSearch) -> Vec<Onset> {
    let mut pulse = Pulse::like(onsets, links);
    pulse.take(links);
    let times_s: Vec<f64> = pulse.onsets(true).map(|(_, onset)| onset.time_s).collect();
    let intervals_s = times_s.windows(2).map(|pair| pair[1] - pair[0]);
    found.periodic.push(PeriodicSequence {
        start_s: times_s[0],
        interval_s: median(intervals_s).unwrap_or(f64::INFINITY),
        count: times_s.len(),
    });
    pulse.onsets(false).map(|(_, onset)| *onset).collect()
}

/// A ball that falls off a table needs more seconds to the floor, and a hand to the next drop: from
/// 60 cm it falls so long. What bounces sooner is the same ball, coming to rest or not yet let go.
const FALL_S: f64 = 0.35;

/// Evidence from how loud the loudest impact is.
fn loudest(onsets: &[Onset], chain: &Chain) -> f64 {
    let levels_db = chain.links.iter().map(|link| onsets[link.onset].level_db);
    evidence::ln_loudest(levels_db.fold(f64::NEG_INFINITY, f64::max))
}

/// Evidence from how alone the impacts are.
///
/// Other sounds are as likely to fall before, between and after the impacts of a drop as in their
/// places. If n impacts and m other sounds as strong are heard, the rate of other sounds that
/// explains all of them is (n + m) / m times the one that explains the rest beside the drop. The
/// ratio of the two Poisson probabilities is exp(n) (m / (n + m))^m.
fn alone(onsets: &[Onset], chain: &Chain) -> f64 {
    /// Seconds before the first and after the last impact that count.
    const AROUND_S: f64 = 0.5;
    let time_s = |link: usize| onsets[chain.links[link].onset].time_s;
    let start_s = time_s(0) - AROUND_S;
    let end_s = time_s(chain.links.len() - 1) + AROUND_S;
    let first = onsets.partition_point(|o| o.time_s < start_s);
    let last = onsets.partition_point(|o| o.time_s <= end_s);
    let impacts: Vec<f64> = chain
        .links
        .iter()
        .map(|l| onsets[l.onset].strength)
        .collect();
    impacts
        .iter()
        .map(|&strength| {
            let as_strong = |s: &&f64| **s >= strength;
            let n = impacts.iter().filter(as_strong).count();
            let all: Vec<f64> = onsets[first..last].iter().map(|o| o.strength).collect();
            let m = all.iter().filter(as_strong).count() - n;
            let (n, m) = (n as f64, m as f64);
            if m > 0.0 {
                n - m * (1.0 + n / m).ln()
            } else {
                n
            }
        })
        .fold(0.0, f64::max)
}

/// Evidence from the waveforms: the impacts of a drop agree with each other where the other sounds around
/// do not agree with them.
///
/// If it is a drop, some share of its impacts agrees, depending on ball and recorder, and one other in
/// twenty by chance. If it is not, the same share of all does, as of drums that repeat.
fn alike(onsets: &[Onset], chain: &Chain, read: Read) -> f64 {
    /// Seconds before the first and after the last impact in which other sounds are compared, and
    /// before and after those in which they may sound.
    const AROUND_S: f64 = 1.0;
    const SOUND_S: f64 = 0.1;
    /// Beta distributions of a share of which nothing is known, of one that is rather small, because sounds
    /// by chance are rather unlike, and of one that is small.
    const ANY: (f64, f64) = (1.0, 1.0);
    const RATHER_SMALL: (f64, f64) = (1.0, 2.0);
    const ONE_IN_TWENTY: (f64, f64) = (1.0, 19.0);
    /// So many others say enough.
    const OTHERS: usize = 20;
    let impacts: Vec<Onset> = chain.links.iter().map(|l| onsets[l.onset]).collect();
    let start_s = impacts[0].time_s - AROUND_S;
    let end_s = impacts[impacts.len() - 1].time_s + AROUND_S;
    let near = onsets.partition_point(|o| o.time_s < start_s)
        ..onsets.partition_point(|o| o.time_s <= end_s);
    let is_other = |index: &usize| {
        onsets[*index].stands_out() && chain.links.iter().all(|link| link.onset != *index)
    };
    let mut others: Vec<Onset> = near.filter(is_other).map(|index| onsets[index]).collect();
    sort_by_number(&mut others, |onset| -onset.strength);
    others.truncate(OTHERS);
    let Recording {
        samples,
        start_s,
        rate_hz,
    } = read(start_s - SOUND_S..end_s + SOUND_S);
    let agreement = align::agreement(&impacts, &others, &samples, start_s, rate_hz);
    let (agree, of_impacts) = agreement.impacts;
    let (agree_too, of_others) = agreement.others;
    let all = (agree + agree_too, of_impacts + of_others);
    ln_share((agree, of_impacts), ANY) + ln_share((agree_too, of_others), ONE_IN_TWENTY)
        - ln_share(all, RATHER_SMALL)
}

/// Logarithm of how likely it is that just these of so many do something, if the share that does has
/// a beta distribution of these parameters.
fn ln_share((doing, of): (usize, usize), (a, b): (f64, f64)) -> f64 {
    let (doing, not) = (doing as f64, (of - doing) as f64);
    ln_beta(a + doing, b + not) - ln_beta(a, b)
}

/// Evidence for one explanation over two others that are equally usual.
fn against_both(one: f64, other: f64) -> f64 {
    one - softplus(one - other)
}

fn impacts(onsets: &[Onset], chain: &Chain) -> Vec<TrainImpact> {
    std::iter::zip(&chain.links, chain.evidence_without_each(onsets))
        .map(|(link, without)| TrainImpact {
            onset: onsets[link.onset],
            number: link.number,
            probability: logistic(chain.evidence - without),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const RATE_HZ: f64 = 44_100.0;

    /// A faint drop of six impacts among ten other sounds.
    fn times_s() -> (Vec<f64>, Vec<f64>) {
        let impacts_s = (0..6).scan(1.0, |time_s, n| {
            let now_s = *time_s;
            *time_s += 0.4 * 0.85_f64.powi(n);
            Some(now_s)
        });
        let others_s = (0..10).map(|n| 0.63 + 0.2817 * f64::from(n) + 0.01 * f64::from(n * n % 7));
        (impacts_s.collect(), others_s.collect())
    }

    /// A sound of 5 ms at each of these times, in faint noise; those of one pitch are alike.
    fn record(sounds: &[(f64, f64)]) -> Vec<f32> {
        let mut state = 1_u32;
        let mut samples: Vec<f32> = (0..4 * RATE_HZ as usize)
            .map(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                1e-4 * ((state >> 8) as f32 / 8e6 - 1.0)
            })
            .collect();
        for &(time_s, pitch_hz) in sounds {
            let first = (time_s * RATE_HZ).ceil() as usize;
            for (n, sample) in samples[first..first + 220].iter_mut().enumerate() {
                let t = (first + n) as f64 / RATE_HZ - time_s;
                *sample += (0.1 * (-t / 0.001).exp() * (TAU * pitch_hz * t).sin()) as f32;
            }
        }
        samples
    }

    /// What the waveforms say of the drop.
    fn evidence(read: Read) -> f64 {
        let (impacts_s, others_s) = times_s();
        let mut times_s = [impacts_s, others_s].concat();
        times_s.sort_by(f64::total_cmp);
        let onsets: Vec<Onset> = times_s.into_iter().map(Onset::click).collect();
        let chain = chain::best(&onsets, Span::EVER).unwrap();
        assert_eq!(chain.links.len(), 6);
        alike(&onsets, &chain, read)
    }

    /// The same if the other sounds have pitches this far apart.
    fn evidence_in(apart_hz: f64) -> f64 {
        let (impacts_s, others_s) = times_s();
        let impacts = impacts_s.iter().map(|t| (*t, 3000.0));
        let others = (1..).zip(&others_s);
        let others = others.map(|(n, t)| (*t, 3000.0 + apart_hz * f64::from(n)));
        let samples = record(&impacts.chain(others).collect::<Vec<_>>());
        evidence(&|_| Recording {
            samples: samples.clone(),
            start_s: 0.0,
            rate_hz: RATE_HZ,
        })
    }

    #[test]
    fn impacts_that_are_alike_among_others_that_are_not_are_more_likely_a_drop() {
        assert!(evidence_in(1000.0) > 5.0);
    }

    #[test]
    fn impacts_that_are_alike_among_others_like_them_are_less_likely_a_drop() {
        assert!(evidence_in(0.0) < -5.0);
    }

    /// Impacts of a drop whose flights shrink by 0.92, those of some numbers left out.
    fn drop_without(missed: Range<u32>) -> Vec<Onset> {
        let times_s = (0..30).scan(1.0, |time_s, n| {
            let now_s = *time_s;
            *time_s += 0.5 * 0.92_f64.powi(n);
            Some((n as u32, now_s))
        });
        let heard = times_s.filter(|(number, _)| !missed.contains(number));
        heard.map(|(_, time_s)| Onset::click(time_s)).collect()
    }

    #[test]
    fn a_drop_with_a_long_gap_is_one_drop() {
        let found = find(&drop_without(10..17));
        assert_eq!(found.trains.len(), 1);
        let numbers: Vec<u32> = found.trains[0].impacts().iter().map(|i| i.number).collect();
        assert_eq!(numbers, (0..10).chain(17..30).collect::<Vec<_>>());
    }

    /// What follows is no longer what it would be if the flights had gone on to shrink.
    #[test]
    fn a_second_drop_after_the_first_is_another() {
        let mut onsets = drop_without(12..30);
        let start_s = onsets[11].time_s + 0.6;
        onsets.extend(drop_without(30..30).into_iter().map(|onset| Onset {
            time_s: start_s + onset.time_s,
            ..onset
        }));
        assert_eq!(find(&onsets).trains.len(), 2);
    }

    /// Sounds two milliseconds before some impacts and after others are no other drop. Each of the two once took the
    /// place of the other, for ever.
    #[test]
    fn sounds_beside_each_impact_are_no_drop_of_their_own() {
        let drop = drop_without(30..30);
        let twins = drop.iter().enumerate().map(|(place, onset)| Onset {
            time_s: onset.time_s + [-0.0025, 0.0025][place / 8 % 2],
            ..*onset
        });
        let mut onsets: Vec<Onset> = drop.iter().copied().chain(twins).collect();
        onsets.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
        assert_eq!(find(&onsets).trains.len(), 1);
    }

    /// Sounds of the last bits of a recording, which are as regular as a drop is just enough.
    #[test]
    fn a_drop_far_below_full_scale_takes_more_evidence() {
        let (impacts_s, _) = times_s();
        let at_level = |level_db: f64| {
            let clicks = impacts_s.iter().map(|&time_s| Onset {
                level_db,
                ..Onset::click(time_s)
            });
            find(&clicks.collect::<Vec<_>>()).trains[0].log_bayes_factor()
        };
        assert!((at_level(-20.0) - at_level(-50.0)).abs() < 1e-9);
        let lost = at_level(-20.0) - at_level(-80.0);
        assert!((lost - 10.0_f64.ln()).abs() < 1e-9, "{lost}");
    }

    #[test]
    fn without_a_sound_it_says_nothing() {
        assert!(evidence(&|_| Recording::default()).abs() < 1e-12);
    }
}
