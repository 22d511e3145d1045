//! The search for trains among onsets.

use super::align;
use super::chain::{self, Chain, Chains, Link};
use super::evidence::{self, Span};
use super::parameters::{
    AGREEING_IMPACTS, AGREEING_OTHERS, AGREEING_SOUNDS, COMPARED_MARGIN_S, COMPARED_REACH_S,
    CONCURRENT_REACH_S, CROWD_REACH_S, EARLIER_FLIGHT_REACH, FOLLOWING_REACH_S, HIDDEN_BELOW_DB,
    HIDDEN_FLIGHT_REACH, ISOLATION_REACH_S, LN_CONCURRENT, LN_CONTINUES, LN_RHYTHM, LOWERED_BY,
    MAX_COMPARED, MAX_DOUBT, MAX_FAINT_ONSETS, MAX_HIDING, MAX_LN_ALIKE, MAX_MISSED,
    MIN_CANDIDATE_EVIDENCE, MIN_CANDIDATE_IMPACTS, MIN_EVIDENCE, MIN_FALL_S, UNUSED_BELOW_DB,
    UNUSED_REACH_S,
};
use super::rhythm::{self, Pulse};
use super::{MIN_IMPACTS, Onset, PeriodicSequence, Train, TrainImpact, TrainSearch};
use crate::stats::{logistic, median, softplus, sort_by_number};
use statrs::function::beta::ln_beta;
use std::ops::Range;

/// A part of a recording.
#[derive(Default)]
pub(crate) struct Excerpt {
    pub(crate) samples: Vec<f32>,
    pub(crate) start_s: f64,
    pub(crate) rate_hz: f64,
}

impl Excerpt {
    /// Its low frequencies at a rate that is lower by this factor.
    fn lowered(&self, factor: usize) -> Self {
        Self {
            samples: align::lowered(&self.samples, factor),
            rate_hz: self.rate_hz / factor as f64,
            ..*self
        }
    }
}

/// Reads the part of the recording between two times, in seconds.
pub(crate) type Read<'a> = &'a dyn Fn(Range<f64>) -> Excerpt;

/// Adds the trains among these onsets to `result`; they are all onsets of this span.
pub(crate) fn search(onsets: &[Onset], span: Span, read: Read, result: &mut TrainSearch) {
    let before = result.trains.len();
    let informative = informative(onsets);
    search_among(&informative, span, read, result);
    let mut new = result.trains.split_off(before);
    add_concurrent(&informative, span, read, &mut new);
    result.add_candidates(join(&mut new));
    note_unused(&informative, &mut new);
    let is_found = |candidate: &Train| new.iter().any(|train| train.is_same_drop(candidate));
    result.candidates.retain(|candidate| !is_found(candidate));
    result.trains.append(&mut new);
}

/// Leaves out the faint onsets where they are crowded: more than [`MAX_FAINT_ONSETS`] within ±[`CROWD_REACH_S`].
fn informative(onsets: &[Onset]) -> Vec<Onset> {
    let faint_s: Vec<f64> = onsets
        .iter()
        .filter(|o| !o.stands_out())
        .map(|o| o.time_s)
        .collect();
    let is_crowded = |time_s: f64| {
        let first = faint_s.partition_point(|t| *t < time_s - CROWD_REACH_S);
        let end = faint_s.partition_point(|t| *t <= time_s + CROWD_REACH_S);
        end - first > MAX_FAINT_ONSETS
    };
    onsets
        .iter()
        .filter(|o| o.stands_out() || !is_crowded(o.time_s))
        .copied()
        .collect()
}

/// Takes the best train and searches again before and after it.
fn search_among(onsets: &[Onset], span: Span, read: Read, result: &mut TrainSearch) {
    let chains = Chains::of(onsets, span);
    let best = match best(&chains, read, 0.0) {
        None => {
            let offered = candidate(&chains, read);
            match offered.as_ref().and_then(|few| completed(few, read)) {
                Some(drop) => result.trains.push(drop),
                None => result.add_candidates(offered),
            }
            return;
        }
        Some(Best::Rhythm(links)) => {
            let others = take_periodic(onsets, &links, result);
            search_among(&others, span, read, result);
            return;
        }
        Some(Best::Drop(train)) => train,
    };
    let before = Span {
        end_s: best.start_s() - MIN_FALL_S,
        ..span
    };
    let end_before = onsets.partition_point(|o| o.time_s < before.end_s);
    search_among(&onsets[..end_before], before, read, result);
    let index_after = |time_s: f64| onsets.partition_point(|o| o.time_s <= time_s);
    let later = |start_s: f64| Span { start_s, ..span };
    let mut last = best;
    let next_s = loop {
        let end_s = last.end_s();
        let next_s = end_s + MIN_FALL_S;
        let soon = &onsets[index_after(end_s)..index_after(end_s + FOLLOWING_REACH_S)];
        // What follows before the ball could fall again is the same ball as it comes to rest, or another.
        let follows = soon.first().is_some_and(|onset| onset.time_s <= next_s);
        let chains = follows.then(|| Chains::of(soon, later(end_s)));
        let next = chains
            .as_ref()
            .and_then(|it| following(it, onsets, &last, read));
        result.trains.push(last);
        let Some(train) = next else {
            result.add_candidates(chains.and_then(|it| candidate(&it, read)));
            break next_s;
        };
        last = train;
    };
    search_among(&onsets[index_after(next_s)..], later(next_s), read, result);
}

/// The explanation of the best chain among some onsets.
enum Best {
    Drop(Train),
    Rhythm(Vec<Link>),
}

/// The best chain, if it is more likely than chance; `ln_prior` is the logarithm of the prior odds of a drop here over
/// those anywhere.
fn best<'c>(chains: &'c Chains, read: Read, ln_prior: f64) -> Option<Best> {
    let onsets = chains.onsets;
    let weighed = |mut chain: Chain<'c>| {
        let rhythm = chain.end_at_rhythm(onsets);
        chain.evidence += ln_prior;
        weigh_sounds(&mut chain, onsets, read);
        (chain, rhythm)
    };
    let is_drop = |chain: &Chain| chain.evidence >= MIN_EVIDENCE;
    let (best, rhythm) = weighed(chains.best(MIN_IMPACTS)?);
    let likely = if is_drop(&best) {
        Some(best)
    } else {
        // The times alone do not tell which of several chains is the drop.
        let others = chains.several(MIN_IMPACTS).into_iter().skip(1);
        others.map(|chain| weighed(chain).0).find(is_drop)
    };
    let Some(mut chain) = likely else {
        return rhythm.map(Best::Rhythm);
    };
    // Further impacts first, because the rhythm explains all of them too.
    chain.extend(onsets, 0.0);
    chain.end_at_rhythm(onsets);
    let evidence = over_chance_and_rhythm(onsets, &chain);
    if evidence < MIN_EVIDENCE {
        return Some(Best::Rhythm(chain.links));
    }
    Some(Best::Drop(accepted(chain, onsets, evidence, read)))
}

/// The train of a chain that is a drop.
fn accepted(mut chain: Chain, onsets: &[Onset], evidence: f64, read: Read) -> Train {
    // What an accepted drop makes more likely is no evidence for it.
    let log_bayes_factor = chain.evidence;
    chain.extend(onsets, LN_CONTINUES);
    complete(&mut chain, onsets, read);
    chain.end_at_rhythm(onsets);
    Train::new(impacts(onsets, &chain), evidence, log_bayes_factor)
}

/// The drop that follows another so soon that both are of one ball or of one place: one that sounds like the other need not
/// stand out as much from chance and from a rhythm.
fn following(chains: &Chains, onsets: &[Onset], earlier: &Train, read: Read) -> Option<Train> {
    let mut chain = chains.best(MIN_IMPACTS)?;
    weigh_sounds(&mut chain, chains.onsets, read);
    let evidence = over_chance_and_rhythm(chains.onsets, &chain);
    if evidence < -MAX_LN_ALIKE {
        return None;
    }
    let before: Vec<Onset> = earlier.impacts.iter().map(|it| it.onset).collect();
    let sounds = chain.sounds(chains.onsets);
    let alike = ln_alike(onsets, &before, &sounds, read);
    // The sounds of a rhythm are alike, so that all of them are no more evidence than one.
    let evidence = evidence + alike.iter().flatten().sum::<f64>() / sounds.len() as f64;
    (evidence >= MIN_EVIDENCE).then(|| accepted(chain, chains.onsets, evidence, read))
}

/// Adds the impacts before the first and after the last one of a drop that their times and their waveforms together make likely.
fn complete(chain: &mut Chain, onsets: &[Onset], read: Read) {
    loop {
        let mut longer = chain.longer(onsets, LN_CONTINUES);
        longer.retain(|it| it.ln_odds > -MAX_LN_ALIKE);
        let ends: Vec<Onset> = longer.iter().map(|it| onsets[it.onset]).collect();
        let alike = ln_alike(onsets, &chain.sounds(onsets), &ends, read);
        let odds = std::iter::zip(longer, alike).filter_map(|(it, alike)| {
            let alike = alike?;
            Some((it.ln_odds + alike, it))
        });
        let best = odds.max_by(|one, other| one.0.total_cmp(&other.0));
        match best {
            Some((ln_odds, longer)) if ln_odds > 0.0 => *chain = longer.accepted(ln_odds),
            _ => return,
        }
        chain.extend(onsets, LN_CONTINUES);
    }
}

/// Adds the evidence of the sounds of a chain to that of its times.
fn weigh_sounds(chain: &mut Chain, onsets: &[Onset], read: Read) {
    chain.evidence += isolation(onsets, chain) + loudest(onsets, chain);
    if chain.evidence.abs() < MAX_DOUBT {
        chain.evidence += agreement(onsets, chain, read);
    }
}

/// The best chain among onsets without a drop, also of fewer impacts, if it is not much less likely than chance.
fn candidate(chains: &Chains, read: Read) -> Option<Train> {
    let onsets = chains.onsets;
    MIN_CANDIDATE_IMPACTS.into_iter().find_map(|min_impacts| {
        let mut chain = chains.best(min_impacts)?;
        if let [first, second] = &chain.links[..] {
            chain.evidence += evidence::ln_fall_of_two(&onsets[first.onset], &onsets[second.onset]);
        }
        weigh_sounds(&mut chain, onsets, read);
        let evidence = over_chance_and_rhythm(onsets, &chain);
        (evidence > MIN_CANDIDATE_EVIDENCE)
            .then(|| Train::new(impacts(onsets, &chain), evidence, chain.evidence))
    })
}

/// The drop of a few impacts that are more likely those of a ball than other sounds, if their waveform reveals at the expected
/// times as many more as a drop needs.
fn completed(few: &Train, read: Read) -> Option<Train> {
    if few.evidence < MIN_EVIDENCE || few.impacts.len() >= MIN_IMPACTS {
        return None;
    }
    let mut train = few.clone();
    train.align_within(read);
    (train.impacts.len() >= MIN_IMPACTS).then_some(train)
}

/// Adds the drops that share their time with these: other balls that bounce concurrently.
fn add_concurrent(onsets: &[Onset], span: Span, read: Read, trains: &mut Vec<Train>) {
    let mut index = 0;
    while let Some(train) = trains.get(index) {
        let first = onsets.partition_point(|o| o.time_s < train.start_s() - CONCURRENT_REACH_S);
        let end = onsets.partition_point(|o| o.time_s <= train.end_s() + CONCURRENT_REACH_S);
        // The train itself is among them.
        let taken: Vec<&Train> = trains.iter().filter(|it| train.is_concurrent(it)).collect();
        let is_free = |onset: &&Onset| !taken.iter().any(|it| it.has(onset));
        let free: Vec<Onset> = onsets[first..end].iter().filter(is_free).copied().collect();
        let candidate = match best(&Chains::of(&free, span), read, LN_CONCURRENT) {
            Some(Best::Drop(other)) if train.is_concurrent(&other) && !other.echoes(train) => other,
            _ => {
                index += 1;
                continue;
            }
        };
        // A partial train found earlier, before or after the first one, is contained in the new one. Only a longer train
        // replaces others, which guarantees termination.
        let is_longer = |other: &Train| other.impacts.len() < candidate.impacts.len();
        let mut replaced = trains.iter().filter(|other| other.is_same_drop(&candidate));
        if replaced.all(is_longer) && !train.is_same_drop(&candidate) {
            trains.retain(|other| !other.is_same_drop(&candidate));
            trains.push(candidate);
        } else {
            index += 1;
        }
    }
    sort_by_number(trains, Train::start_s);
}

/// Joins each train, in order of the starts, with the one that ended last before it if that is the same ball. Returns those
/// that are only its rattling.
fn join(trains: &mut Vec<Train>) -> Vec<Train> {
    let mut rattling = Vec::new();
    let mut index = 1;
    while index < trains.len() {
        let (earlier, rest) = trains.split_at_mut(index);
        let later = &rest[0];
        let over = earlier.iter_mut().filter(|it| it.end_s() < later.start_s());
        let last = over.max_by(|a, b| a.end_s().total_cmp(&b.end_s()));
        let rattles = last.as_ref().is_some_and(|last| later.is_rattling_of(last));
        if last.is_some_and(|last| last.continue_with(later)) {
            trains.remove(index);
        } else if rattles {
            rattling.push(trains.remove(index));
        } else {
            index += 1;
        }
    }
    rattling
}

/// Notes the sounds near each train that belong to no train: how many are nearly as loud as its loudest impact, and whether one
/// may be an earlier impact.
fn note_unused(onsets: &[Onset], trains: &mut [Train]) {
    let is_used = |onset: &Onset| trains.iter().any(|train| train.has(onset));
    let unused: Vec<&Onset> = onsets.iter().filter(|onset| !is_used(onset)).collect();
    for train in trains {
        let near_s = train.start_s() - UNUSED_REACH_S..train.end_s() + UNUSED_REACH_S;
        let min_db = train.loudest_db() - UNUSED_BELOW_DB;
        let is_loud = |o: &&&Onset| near_s.contains(&o.time_s) && o.level_db > min_db;
        train.unused = unused.iter().filter(is_loud).count();
        train.earlier_s = earlier_impact_s(train, &unused);
    }
}

/// The time of a sound that may be an impact before the first one of a train, if its flights shrink as the first few do: one
/// that is like the first impact, or one about as loud just where the impact before should be, since damage
/// or another sound may have hidden it.
fn earlier_impact_s(train: &Train, unused: &[&Onset]) -> Option<f64> {
    let first = &train.impacts[0].onset;
    let (mut flight_s, ratio) = train.first_flight_s();
    let mut due_s = first.time_s;
    let is_loud = |o: &&&Onset, below_db: f64| o.level_db > first.level_db - below_db;
    (0..=MAX_MISSED).find_map(|missed| {
        flight_s /= ratio;
        due_s -= flight_s;
        let near = |o: &&&Onset, reach: f64| (o.time_s - due_s).abs() < reach * flight_s;
        let is_alike = |o: &&&Onset| {
            near(o, EARLIER_FLIGHT_REACH)
                && is_loud(o, UNUSED_BELOW_DB)
                && evidence::ln_alike(o, first) > 0.0
        };
        let alike = unused.iter().rfind(is_alike);
        let before_s = due_s - flight_s..first.time_s;
        let hides = |o: &&&Onset| before_s.contains(&o.time_s) && is_loud(o, HIDDEN_BELOW_DB);
        let hiding: Vec<_> = unused.iter().filter(hides).collect();
        let mut there = hiding.iter().filter(|o| near(o, HIDDEN_FLIGHT_REACH));
        let hidden = there
            .next()
            .filter(|_| missed == 0 && hiding.len() <= MAX_HIDING);
        let earlier = alike.or(hidden.copied());
        earlier.map(|onset| onset.time_s)
    })
}

/// Takes out a sequence that keeps time, with the beats that continue it to both sides; returns the
/// other sounds.
fn take_periodic(onsets: &[Onset], links: &[Link], result: &mut TrainSearch) -> Vec<Onset> {
    let mut pulse = Pulse::like(onsets, links);
    pulse.take(links);
    let times_s: Vec<f64> = pulse.onsets(true).map(|(_, onset)| onset.time_s).collect();
    let intervals_s = times_s.windows(2).map(|pair| pair[1] - pair[0]);
    result.periodic.push(PeriodicSequence {
        start_s: times_s[0],
        interval_s: median(intervals_s).unwrap_or(f64::INFINITY),
        count: times_s.len(),
    });
    pulse.onsets(false).map(|(_, onset)| *onset).collect()
}

/// Evidence from the level of the loudest impact.
fn loudest(onsets: &[Onset], chain: &Chain) -> f64 {
    let levels_db = chain.links.iter().map(|link| onsets[link.onset].level_db);
    evidence::ln_loudest(levels_db.fold(f64::NEG_INFINITY, f64::max))
}

/// Evidence from the isolation of the impacts.
///
/// Other sounds are as likely to fall before, between and after the impacts of a drop as at their
/// times. If there are n impacts and m other sounds as strong, the rate of other sounds that
/// explains all of them is (n + m) / m times the one that explains only the others. The
/// ratio of the two Poisson probabilities is exp(n) (m / (n + m))^m.
fn isolation(onsets: &[Onset], chain: &Chain) -> f64 {
    let time_s = |link: usize| onsets[chain.links[link].onset].time_s;
    let start_s = time_s(0) - ISOLATION_REACH_S;
    let end_s = time_s(chain.links.len() - 1) + ISOLATION_REACH_S;
    let first = onsets.partition_point(|o| o.time_s < start_s);
    let end = onsets.partition_point(|o| o.time_s <= end_s);
    let impacts: Vec<f64> = chain
        .links
        .iter()
        .map(|l| onsets[l.onset].strength)
        .collect();
    // The strength above which sounds are counted is free: the one with the most evidence.
    impacts
        .iter()
        .map(|&strength| {
            let as_strong = |s: &&f64| **s >= strength;
            let n = impacts.iter().filter(as_strong).count();
            let all: Vec<f64> = onsets[first..end].iter().map(|o| o.strength).collect();
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
/// twenty by chance. If it is not, the same share of all agrees, such as that of drums that repeat.
///
/// A bright ball agrees over all frequencies, a dull one among other sounds only over low ones. Its brightness is unknown, so
/// that the evidence is that of the mean of the probability ratios.
fn agreement(onsets: &[Onset], chain: &Chain, read: Read) -> f64 {
    let compared = compared(onsets, &chain.sounds(onsets), &[], read);
    rhythm::ln_mean(&compared.iter().map(Compared::ln_drop).collect::<Vec<f64>>())
}

/// For each of these sounds near a drop, the logarithm of how much more probable its waveform is if it is another impact of the
/// drop; `None` if it cannot be compared.
///
/// It agrees with the impacts as probably as they agree with each other, or as the other sounds do. Each rate at
/// which they are compared counts as much as it is evidence for the drop, and for a ball without higher frequencies.
fn ln_alike(onsets: &[Onset], impacts: &[Onset], asked: &[Onset], read: Read) -> Vec<Option<f64>> {
    if asked.is_empty() {
        return Vec::new();
    }
    let compared = compared(onsets, impacts, asked, read);
    let of_drop: Vec<f64> = compared.iter().map(Compared::ln_drop).collect();
    // An impact before the others is louder: if they agree over high frequencies, it does, too. A fainter one may be lost in
    // noise there.
    let mut bright = of_drop.clone();
    let mut dull = 0.0;
    for (weight, it) in std::iter::zip(&mut bright, &compared) {
        *weight += dull;
        dull += ln_share(it.impacts, AGREEING_OTHERS) - ln_share(it.impacts, AGREEING_IMPACTS);
    }
    let of_sound = |index: usize| {
        let is_earlier = asked[index].time_s < impacts[0].time_s;
        let weights = if is_earlier { &bright } else { &of_drop };
        let alike: Vec<Option<f64>> = compared.iter().map(|it| it.ln_alike(index)).collect();
        alike.iter().any(Option::is_some).then(|| {
            let both = std::iter::zip(weights, alike);
            let both: Vec<f64> = both
                .map(|(weight, it)| weight + it.unwrap_or(0.0))
                .collect();
            rhythm::ln_mean(&both) - rhythm::ln_mean(weights)
        })
    };
    (0..asked.len()).map(of_sound).collect()
}

/// Which sounds agree with the impacts of a drop over the frequencies of one rate.
struct Compared {
    /// The number of impacts, and of other sounds, that agree, each with the number of those compared.
    impacts: (usize, usize),
    others: (usize, usize),
    /// Whether each sound that was asked about agrees.
    asked: Vec<Option<bool>>,
}

impl Compared {
    /// Log probability ratio of a drop.
    fn ln_drop(&self) -> f64 {
        let all = (
            self.impacts.0 + self.others.0,
            self.impacts.1 + self.others.1,
        );
        ln_share(self.impacts, AGREEING_IMPACTS) + ln_share(self.others, AGREEING_OTHERS)
            - ln_share(all, AGREEING_SOUNDS)
    }

    /// Log probability ratio of another impact, if it was compared.
    fn ln_alike(&self, asked: usize) -> Option<f64> {
        let agrees = self.asked[asked]?;
        let ln_next = |(count, of): (usize, usize), prior| {
            ln_share((count + usize::from(agrees), of + 1), prior) - ln_share((count, of), prior)
        };
        Some(ln_next(self.impacts, AGREEING_IMPACTS) - ln_next(self.others, AGREEING_OTHERS))
    }
}

/// Compares the sounds that are `asked` about, and the strongest others near, with the impacts of a drop, over all frequencies and
/// over ever lower ones.
fn compared(onsets: &[Onset], impacts: &[Onset], asked: &[Onset], read: Read) -> Vec<Compared> {
    let times_s = || impacts.iter().chain(asked).map(|onset| onset.time_s);
    let start_s = times_s().fold(f64::INFINITY, f64::min) - COMPARED_REACH_S;
    let end_s = times_s().fold(f64::NEG_INFINITY, f64::max) + COMPARED_REACH_S;
    let near = onsets.partition_point(|o| o.time_s < start_s)
        ..onsets.partition_point(|o| o.time_s <= end_s);
    let is_other = |onset: &&Onset| {
        onset.stands_out() && times_s().all(|time_s| (onset.time_s - time_s).abs() > 0.0)
    };
    let mut others: Vec<Onset> = onsets[near].iter().filter(is_other).copied().collect();
    sort_by_number(&mut others, |onset| -onset.strength);
    others.truncate(MAX_COMPARED);
    let sounds = [asked, &others].concat();
    let mut excerpt = read(start_s - COMPARED_MARGIN_S..end_s + COMPARED_MARGIN_S);
    let compare = |excerpt: &Excerpt| {
        let (samples, start_s, rate_hz) = (&excerpt.samples, excerpt.start_s, excerpt.rate_hz);
        let mut agreement = align::agreement(impacts, &sounds, samples, start_s, rate_hz);
        let others = agreement.others.split_off(asked.len());
        let agreeing = others.iter().filter(|agrees| **agrees == Some(true));
        Compared {
            impacts: agreement.impacts,
            others: (agreeing.count(), others.iter().flatten().count()),
            asked: agreement.others,
        }
    };
    let mut compared = vec![compare(&excerpt)];
    for factor in LOWERED_BY {
        excerpt = excerpt.lowered(factor);
        compared.push(compare(&excerpt));
    }
    compared
}

/// Log probability that a given `count` of `of` sounds agree, if their share has
/// a beta distribution with parameters `a` and `b`.
fn ln_share((count, of): (usize, usize), (a, b): (f64, f64)) -> f64 {
    let (agreeing, others) = (count as f64, (of - count) as f64);
    ln_beta(a + agreeing, b + others) - ln_beta(a, b)
}

/// Evidence for a drop over both chance and a rhythm.
fn over_chance_and_rhythm(onsets: &[Onset], chain: &Chain) -> f64 {
    let beats = chain::beats(onsets, &chain.links);
    let over_rhythm = chain.ln_flights(onsets) - rhythm::ln_likelihood(&beats) - LN_RHYTHM;
    over_both(chain.evidence, over_rhythm)
}

/// Evidence for an explanation over the sum of two others, given that over each of them: with odds x and y it is
/// 1/(1/x + 1/y).
fn over_both(one: f64, other: f64) -> f64 {
    one - softplus(one - other)
}

fn impacts(onsets: &[Onset], chain: &Chain) -> Vec<TrainImpact> {
    std::iter::zip(&chain.links, chain.evidence_without_each(onsets))
        .map(|(link, without)| TrainImpact {
            onset: onsets[link.onset],
            number: link.number,
            probability: logistic((chain.evidence - without).min(chain.ln_odds_of(link.onset))),
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

    /// A sound of 5 ms at each of these times, in faint noise; those of one pitch agree.
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

    /// Evidence of the waveforms for the drop.
    fn evidence(read: Read) -> f64 {
        let (impacts_s, others_s) = times_s();
        let mut times_s = [impacts_s, others_s].concat();
        times_s.sort_by(f64::total_cmp);
        let onsets: Vec<Onset> = times_s.into_iter().map(Onset::click).collect();
        let chains = Chains::of(&onsets, Span::UNBOUNDED);
        let chain = chains.best(MIN_IMPACTS).unwrap();
        assert_eq!(chain.links.len(), 6);
        agreement(&onsets, &chain, read)
    }

    /// The same if the other sounds have pitches this far apart.
    fn evidence_in(apart_hz: f64) -> f64 {
        let (impacts_s, others_s) = times_s();
        let impacts = impacts_s.iter().map(|t| (*t, 3000.0));
        let numbered = (1..).zip(&others_s);
        let others = numbered.map(|(n, t)| (*t, 3000.0 + apart_hz * f64::from(n)));
        let samples = record(&impacts.chain(others).collect::<Vec<_>>());
        evidence(&|_| Excerpt {
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

    #[test]
    fn without_samples_the_waveforms_are_no_evidence() {
        assert!(evidence(&|_| Excerpt::default()).abs() < 1e-12);
    }

    /// The number of impacts of the drop after its first and its last one were left out, if the first comes a little early and
    /// has this pitch where all others have 3 kHz.
    fn completed_impacts(first_hz: f64) -> usize {
        let (mut impacts_s, others_s) = times_s();
        impacts_s[0] -= 0.015;
        let impacts = (0..).zip(&impacts_s);
        let impacts = impacts.map(|(n, t)| (*t, if n == 0 { first_hz } else { 3000.0 }));
        let others = (1..).zip(&others_s);
        let others = others.map(|(n, t)| (*t, 3000.0 + 1000.0 * f64::from(n)));
        let mut sounds: Vec<(f64, f64)> = impacts.chain(others).collect();
        sounds.sort_by(|one, other| one.0.total_cmp(&other.0));
        let onsets: Vec<Onset> = sounds.iter().map(|(t, _)| Onset::click(*t)).collect();
        let samples = record(&sounds);
        let chains = Chains::of(&onsets, Span::UNBOUNDED);
        let mut chain = chains.best(MIN_IMPACTS).unwrap();
        chain.links.pop();
        chain.links.remove(0);
        chain.links.iter_mut().for_each(|link| link.number -= 1);
        complete(&mut chain, &onsets, &|_| Excerpt {
            samples: samples.clone(),
            start_s: 0.0,
            rate_hz: RATE_HZ,
        });
        assert!(
            chain
                .links
                .iter()
                .map(|link| link.number)
                .eq(0..chain.links.len() as u32)
        );
        chain.links.len()
    }

    #[test]
    fn impacts_at_the_ends_of_a_drop_are_found_if_they_sound_like_the_others() {
        assert_eq!(completed_impacts(3000.0), 6);
        assert_eq!(completed_impacts(1000.0), 5);
    }

    #[test]
    fn of_several_chains_none_shares_most_of_its_impacts_with_a_better_one() {
        let drop = |start_s: f64| {
            (0..8).scan(start_s, |time_s, n| {
                let now_s = *time_s;
                *time_s += 0.4 * 0.85_f64.powi(n);
                Some(Onset::click(now_s))
            })
        };
        let onsets: Vec<Onset> = drop(1.0).chain(drop(6.0)).collect();
        let chains = Chains::of(&onsets, Span::UNBOUNDED);
        let several = chains.several(MIN_IMPACTS);
        assert!(several.is_sorted_by(|a, b| a.evidence >= b.evidence));
        let mut firsts: Vec<usize> = several.iter().map(|it| it.links[0].onset).collect();
        firsts.truncate(2);
        firsts.sort_unstable();
        assert_eq!(firsts, [0, 8]);
    }
}
