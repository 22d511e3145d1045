//! One model of all drops of a session.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{DVector, SMatrix};

use super::evidence::{CurveEvidence, SHARED_INPUTS};
use super::fit::{Cell, Effects, Frame, GroupFit, Inputs, Linear, Shared, distribution};
use super::heights::{self, Height};
use super::mixture::Mixture;
use super::outlier::{Outlier, outliers};
use super::plan::drops_needed;
use super::sums::{Basis, Rows, Sums};
use crate::error::{Error, Quantity, Result, positive};
use crate::estimate::Estimate;
use crate::inference::Measured;
use crate::stats::median;

/// Something by which drops can be compared, such as the surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Factor {
    /// What it is called.
    pub name: String,
    /// Its levels.
    pub levels: Vec<String>,
}

/// What one drop adds to a study.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyDrop {
    /// What it says of the restitution curve.
    pub evidence: CurveEvidence,
    /// Scatter of ln e from impact to impact, above zero.
    pub scatter: Option<f64>,
    /// Level of each factor; `None` where it was not noted.
    pub levels: Vec<Option<usize>>,
}

/// What is asked of drops, with factors by their index.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Asked {
    /// The factors that make groups.
    pub by: Vec<usize>,
    /// The factors whose levels scatter about the group, such as operators: at most [`MAX_RANDOM`].
    pub random: Vec<usize>,
    /// The factor that says which ball it was: drops of one ball share its drag, mass, diameter and contact time.
    pub ball: Option<usize>,
    /// The impact speed at which groups are compared, m/s; if left out, a round one that the groups have in common.
    pub at_speed_m_s: Option<f64>,
    /// The half width of the 95 % interval that the restitution should have; if left out, half of what it has.
    pub wanted: Option<f64>,
}

/// Maximum number of factors whose levels scatter.
pub const MAX_RANDOM: usize = 2;

/// The drops of a ball on a surface, or whatever makes a group.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Group {
    /// Level of each of the factors that make groups.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub levels: Vec<Option<usize>>,
    /// The drops, by their place in the list given.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub drops: Vec<usize>,
    /// How many drops.
    #[cfg_attr(feature = "serde", serde(rename = "drops"))]
    pub count: usize,
    /// The slowest and the fastest of the impacts, m/s.
    pub range_m_s: [f64; 2],
    /// Restitution at the speed of the study; `None` if it lies outside the range.
    pub restitution: Option<Estimate>,
    /// Of its standard uncertainty, what all drops share and no number of drops makes smaller.
    pub shared_sd: Option<f64>,
    /// Where the next drop lies there with 95 % probability, its own errors left out.
    pub next95: Option<[f64; 2]>,
    /// The same without the outliers of the group, if it has any and others besides.
    pub without_outliers: Option<Estimate>,
    /// Scatter between drops beyond their own errors, relative.
    pub between_drops: Estimate,
    /// Typical scatter from impact to impact, relative.
    pub between_impacts: Option<f64>,
    /// Standard deviation of a drop by its own errors, relative.
    pub own_sd: f64,
    /// Standard deviation of results of one operator (ISO 5725-1, 3.15), at the speed of the study.
    pub repeatability_sd: Option<Estimate>,
    /// Standard deviation of results of different operators (ISO 5725-1, 3.20), if operators were noted.
    pub reproducibility_sd: Option<f64>,
    /// How many drops in all the wanted uncertainty takes.
    pub drops_needed: Option<usize>,
    /// Restitution over the range.
    pub curve: Vec<CurvePoint>,
}

/// Restitution of a group at one impact speed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CurvePoint {
    /// Impact speed, m/s.
    pub speed_m_s: f64,
    /// Restitution there.
    pub restitution: Estimate,
}

/// The difference of the restitutions of two groups.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Difference {
    /// The group from which it is counted, by its place.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub of: usize,
    /// The group that is subtracted.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub less: usize,
    /// At the speed of the study, if both groups have it.
    pub at_speed: Option<Compared>,
    /// The mean over the range of speeds, in ln v, that both have, if there is one.
    pub over_range: Option<Compared>,
    /// That range, m/s.
    pub range_m_s: Option<[f64; 2]>,
}

/// A difference with its probability.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Compared {
    /// The difference.
    pub difference: Estimate,
    /// The probability that it is above zero.
    pub above_zero: f64,
}

/// One drop in the light of the others.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FittedDrop {
    /// Its group, by its place.
    pub group: usize,
    /// ln e of the drop above that of its group and operators, whatever the speed, with the error of the drop alone.
    pub off: Measured,
    /// ln e of its operators above that of the group.
    pub of_operators: f64,
    /// Its drop height, m, if it tells one.
    pub height_m: Option<Estimate>,
}

/// What the drops of a session say together.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Study {
    /// The impact speed at which groups are compared, m/s.
    pub at_speed_m_s: f64,
    /// The groups, in the order of their levels.
    pub groups: Vec<Group>,
    /// The differences of groups: of all if there are few, else of those that differ in one factor.
    pub differences: Vec<Difference>,
    /// The relative scatter of the levels of each factor in [`Asked::random`].
    pub scatters: Vec<(usize, Estimate)>,
    /// Each drop; `None` if it has no usable evidence.
    pub drops: Vec<Option<FittedDrop>>,
    /// By how much stated heights are larger than those heard, m, if two or more are stated.
    pub ruler_zero_m: Option<Estimate>,
    /// Drops that do not belong to their group.
    pub outliers: Vec<Outlier>,
}

impl Study {
    /// Studies drops.
    ///
    /// # Errors
    /// [`Error::TooFewDrops`] if no drop has evidence, [`Error::OutOfRange`] for a speed that no group has.
    pub fn of(drops: &[StudyDrop], asked: &Asked) -> Result<Self> {
        let used: Vec<usize> = (0..drops.len())
            .filter(|&place| drops[place].evidence.is_usable())
            .collect();
        let members = members(drops, &used, &asked.by);
        let ranges: Vec<[f64; 2]> = members
            .values()
            .map(|of_group| range(drops, of_group))
            .collect();
        let Some(whole) = hull(&ranges) else {
            return Err(Error::TooFewDrops {
                needed: 1,
                drops: 0,
            });
        };
        let at_speed_m_s = match asked.at_speed_m_s {
            Some(speed_m_s) => {
                positive(Quantity::ImpactSpeed, speed_m_s)?;
                if !ranges.iter().any(|range| holds(range, speed_m_s)) {
                    return Err(Error::TooFewDrops {
                        needed: 1,
                        drops: 0,
                    });
                }
                speed_m_s
            }
            None => common_speed_m_s(&ranges, whole),
        };
        let fitting = Fitting::new(drops, asked, &members, Basis::covering(whole)).ok_or(
            Error::TooFewDrops {
                needed: 1,
                drops: 0,
            },
        )?;
        Ok(fitting.study(asked, at_speed_m_s, &ranges))
    }

    /// Restitution of a drop at the speed of the study, by its level and that of its operators, with its own error; `None` if
    /// its group does not have that speed.
    pub fn restitution_of(&self, drop: usize) -> Option<Measured> {
        let fitted = self.drops[drop]?;
        let group = self.groups[fitted.group].restitution?;
        let value = group.value * (fitted.off.value + fitted.of_operators).exp();
        Some(Measured {
            value,
            sd: value * fitted.off.sd,
        })
    }
}

/// The drops of each group, by the levels that make it.
type Members = BTreeMap<Vec<Option<usize>>, Vec<usize>>;

fn members(drops: &[StudyDrop], used: &[usize], by: &[usize]) -> Members {
    let mut members = Members::new();
    for &place in used {
        let levels = by.iter().map(|&factor| drops[place].levels[factor]);
        members.entry(levels.collect()).or_default().push(place);
    }
    members
}

fn range(drops: &[StudyDrop], places: &[usize]) -> [f64; 2] {
    let ranges = places.iter().map(|&place| drops[place].evidence.range_m_s);
    ranges.reduce(wider).unwrap_or([1.0, 1.0])
}

fn wider(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

fn hull(ranges: &[[f64; 2]]) -> Option<[f64; 2]> {
    ranges.iter().copied().reduce(wider)
}

fn holds([slowest, fastest]: &[f64; 2], speed_m_s: f64) -> bool {
    (slowest * (1.0 - 1e-9)..=fastest * (1.0 + 1e-9)).contains(&speed_m_s)
}

/// A round speed near the middle of the speeds that most groups have.
fn common_speed_m_s(ranges: &[[f64; 2]], whole: [f64; 2]) -> f64 {
    let having = |speed: f64| ranges.iter().filter(|range| holds(range, speed)).count();
    let ends: Vec<f64> = ranges.iter().flatten().copied().collect();
    let most = ends.iter().map(|&end| having(end)).max().unwrap_or(0);
    let common = ends.iter().copied().filter(|&end| having(end) == most);
    let [slowest, fastest] = common.map(|end| [end, end]).reduce(wider).unwrap_or(whole);
    let middle = (slowest * fastest).sqrt();
    let decade = 10_f64.powf(middle.log10().floor());
    let round = [1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0].map(|digit| digit * decade);
    let near = |speed: &f64| (speed / middle).ln().abs();
    let round = round.into_iter().filter(|&speed| having(speed) == most);
    round
        .min_by(|a, b| near(a).total_cmp(&near(b)))
        .unwrap_or(middle)
}

/// The ball of a group, which may have no name; `None` if the group mixes balls.
type BallOfGroup = Option<Option<usize>>;

/// All groups, fitted.
struct Fitting<'a> {
    drops: &'a [StudyDrop],
    members: Vec<(&'a Vec<Option<usize>>, &'a Vec<usize>)>,
    frame: Frame,
    /// The effects that each drop has.
    effects_of: Vec<Vec<usize>>,
    groups: Vec<GroupFit>,
    /// The ball of each group.
    balls: Vec<BallOfGroup>,
    inputs: Vec<Inputs>,
    effects: Vec<(f64, Effects)>,
    scatters: Vec<Estimate>,
}

impl<'a> Fitting<'a> {
    fn new(
        drops: &'a [StudyDrop],
        asked: &Asked,
        members: &'a Members,
        basis: Basis,
    ) -> Option<Self> {
        let ball = |place: usize| asked.ball.and_then(|factor| drops[place].levels[factor]);
        let balls: Vec<BallOfGroup> = members
            .values()
            .map(|places| {
                let of: BTreeSet<Option<usize>> = places.iter().map(|&place| ball(place)).collect();
                (of.len() == 1).then(|| ball(places[0]))
            })
            .collect();
        let mut by_ball: BTreeMap<Option<Option<usize>>, Vec<usize>> = BTreeMap::new();
        for (ball, places) in balls.iter().zip(members.values()) {
            by_ball.entry(*ball).or_default().extend(places);
        }
        let by_ball: BTreeMap<_, Inputs> = by_ball
            .into_iter()
            .map(|(ball, places)| (ball, inputs(drops, &places)))
            .collect();
        let inputs: Vec<Inputs> = balls.iter().map(|ball| by_ball[ball]).collect();
        let mut factors = Vec::new();
        let mut effects_of = vec![Vec::new(); drops.len()];
        for (number, &factor) in asked.random.iter().take(MAX_RANDOM).enumerate() {
            let first = factors.len();
            for (drop, effects) in drops.iter().zip(&mut effects_of) {
                if let Some(level) = drop.levels[factor] {
                    effects.push(first + level);
                    factors.resize(factors.len().max(first + level + 1), number);
                }
            }
        }
        let frame = Frame::new(basis, factors);
        let of_group = |(places, inputs): (&Vec<usize>, &Inputs)| {
            GroupFit::new(&frame, &cells(&frame, drops, &effects_of, places), inputs)
        };
        let groups = members
            .values()
            .zip(&inputs)
            .map(of_group)
            .collect::<Option<Vec<_>>>()?;
        let (effects, scatters) = Effects::of(&frame, &groups, asked.random.len().min(MAX_RANDOM));
        Some(Self {
            drops,
            members: members.iter().collect(),
            frame,
            effects_of,
            groups,
            balls,
            inputs,
            effects,
            scatters,
        })
    }

    fn study(&self, asked: &Asked, at_speed_m_s: f64, ranges: &[[f64; 2]]) -> Study {
        let mut fitted = vec![None; self.drops.len()];
        let mut found_heights = vec![None; self.drops.len()];
        for (group, (_, places)) in self.members.iter().enumerate() {
            for &place in *places {
                fitted[place] = Some((group, self.off(group, place)));
                found_heights[place] = self.height(group, place);
            }
        }
        let (ruler_zero_m, found_heights) = heights::with_zero(&found_heights);
        let places: Vec<usize> = (0..fitted.len())
            .filter(|&place| fitted[place].is_some())
            .collect();
        let (groups_of, offs): (Vec<usize>, Vec<Measured>) =
            fitted.iter().flatten().copied().unzip();
        let outliers: Vec<Outlier> = outliers(&offs, &groups_of)
            .into_iter()
            .map(|outlier| Outlier {
                drop: places[outlier.drop],
                ..outlier
            })
            .collect();
        let odd: BTreeSet<usize> = outliers.iter().map(|outlier| outlier.drop).collect();
        let drops = (0..fitted.len()).map(|place| {
            let (group, off) = fitted[place]?;
            Some(FittedDrop {
                group,
                off,
                of_operators: self.of_operators(place),
                height_m: found_heights[place],
            })
        });
        Study {
            at_speed_m_s,
            groups: (0..self.groups.len())
                .map(|group| self.group(group, asked, at_speed_m_s, ranges[group], &odd))
                .collect(),
            differences: self.differences(at_speed_m_s, ranges),
            scatters: asked
                .random
                .iter()
                .copied()
                .zip(self.scatters.iter().copied())
                .collect(),
            drops: drops.collect(),
            ruler_zero_m,
            outliers,
        }
    }

    /// The most probable effects.
    fn likeliest_effects(&self) -> &Effects {
        let mut best = &self.effects[0];
        for effects in &self.effects {
            if effects.0 > best.0 {
                best = effects;
            }
        }
        &best.1
    }

    /// The level of the operators of a drop above that of its group.
    fn of_operators(&self, place: usize) -> f64 {
        let effects = &self.likeliest_effects().mean;
        self.effects_of[place].iter().map(|&it| effects[it]).sum()
    }

    /// The level of a drop above that of its group and operators: that of its readings v - X β - a o - L z, by least squares.
    fn off(&self, group: usize, place: usize) -> Measured {
        let rows = Rows::new(&self.frame.basis, &self.drops[place].evidence);
        let len = self.frame.basis.len();
        let along = rows.table.tr_mul(&rows.level);
        let linear = self.groups[group].likeliest_linear(&along.rows(0, len).into_owned());
        let of_inputs = along
            .fixed_rows::<SHARED_INPUTS>(len)
            .dot(&self.inputs[group].mean);
        let of_curve = linear.mean + linear.by_effects.dot(&self.likeliest_effects().mean);
        Measured {
            value: (along[len + SHARED_INPUTS] - of_curve - of_inputs) / rows.precision()
                - self.of_operators(place),
            sd: rows.precision().sqrt().recip(),
        }
    }

    fn height(&self, group: usize, place: usize) -> Option<Height> {
        Height::new(
            &self.frame,
            &self.drops[place].evidence,
            &self.effects_of[place],
            &self.groups[group],
            self.likeliest_effects(),
            &self.inputs[group],
        )
    }

    /// ln e of a group at a speed.
    fn at(&self, group: &GroupFit, inputs: &Inputs, speed_m_s: f64) -> Mixture {
        let linear = group.linear(&self.frame.basis.at(speed_m_s));
        distribution(&linear, None, &self.effects, [inputs; 2])
    }

    fn group(
        &self,
        index: usize,
        asked: &Asked,
        at_speed_m_s: f64,
        range_m_s: [f64; 2],
        odd: &BTreeSet<usize>,
    ) -> Group {
        let (fit, inputs) = (&self.groups[index], &self.inputs[index]);
        let (levels, places) = self.members[index];
        let restitution = |group: &GroupFit, speed_m_s: f64| {
            self.at(group, inputs, speed_m_s)
                .estimate(f64::exp, f64::exp)
        };
        let has_speed = holds(&range_m_s, at_speed_m_s);
        let here = has_speed.then(|| restitution(fit, at_speed_m_s));
        let linear = fit.linear(&self.frame.basis.at(at_speed_m_s));
        let next = here.map(|_| self.next(&linear, inputs));
        let others: Vec<usize> = places
            .iter()
            .copied()
            .filter(|place| !odd.contains(place))
            .collect();
        let without = (1..places.len()).contains(&others.len()).then(|| {
            GroupFit::new(
                &self.frame,
                &cells(&self.frame, self.drops, &self.effects_of, &others),
                inputs,
            )
        });
        let one_drop = fit.scatter.value.hypot(fit.own_sd);
        let shared = self.shared(fit, inputs, at_speed_m_s);
        let operators = asked
            .random
            .iter()
            .zip(&self.scatters)
            .filter(|(factor, _)| Some(**factor) != asked.ball);
        let operators = operators
            .map(|(_, scatter)| scatter.value)
            .reduce(f64::hypot);
        Group {
            levels: levels.clone(),
            count: places.len(),
            drops: places.clone(),
            range_m_s,
            restitution: here,
            shared_sd: here.map(|here| here.value * shared),
            next95: next,
            without_outliers: without
                .flatten()
                .filter(|_| has_speed)
                .map(|without| restitution(&without, at_speed_m_s)),
            between_drops: fit.scatter,
            between_impacts: median(places.iter().filter_map(|&place| self.drops[place].scatter)),
            own_sd: fit.own_sd,
            repeatability_sd: here.map(|here| {
                mapped(&fit.scatter, |scatter| {
                    here.value * scatter.hypot(fit.own_sd)
                })
            }),
            reproducibility_sd: here
                .zip(operators)
                .map(|(here, between)| here.value * one_drop.hypot(between)),
            drops_needed: here.and_then(|here| {
                let [low, high] = here.interval95;
                let wanted = asked.wanted.unwrap_or(0.25 * (high - low));
                drops_needed(one_drop, shared, wanted / here.value)
            }),
            curve: speeds(range_m_s)
                .into_iter()
                .map(|speed_m_s| CurvePoint {
                    speed_m_s,
                    restitution: restitution(fit, speed_m_s),
                })
                .collect(),
        }
    }

    /// Relative standard uncertainty of a group at a speed by what no number of drops makes smaller: inputs and operators.
    fn shared(&self, fit: &GroupFit, inputs: &Inputs, speed_m_s: f64) -> f64 {
        let linear = fit.likeliest_linear(&self.frame.basis.at(speed_m_s));
        let by_inputs = linear
            .by_inputs
            .dot(&(inputs.covariance * linear.by_inputs));
        let of_effects = self.effects.iter().map(|(weight, effects)| {
            weight
                * linear
                    .by_effects
                    .dot(&(&effects.covariance * &linear.by_effects))
        });
        (by_inputs + of_effects.sum::<f64>()).sqrt()
    }

    fn next(&self, linear: &[Linear], inputs: &Inputs) -> [f64; 2] {
        let with_scatter = |linear: &Linear| Linear {
            variance: linear.variance + linear.scatter.powi(2),
            ..linear.clone()
        };
        let linear: Vec<Linear> = linear.iter().map(with_scatter).collect();
        distribution(&linear, None, &self.effects, [inputs; 2])
            .estimate(f64::exp, f64::exp)
            .interval95
    }

    fn differences(&self, at_speed_m_s: f64, ranges: &[[f64; 2]]) -> Vec<Difference> {
        /// More groups have too many pairs.
        const FEW: usize = 6;
        let is_wanted = |of: usize, less: usize| {
            let levels = std::iter::zip(self.members[of].0, self.members[less].0);
            self.groups.len() <= FEW || levels.filter(|(one, other)| one != other).count() == 1
        };
        let pairs = (0..self.groups.len())
            .flat_map(|less| (less + 1..self.groups.len()).map(move |of| (of, less)));
        let difference = |(of, less): (usize, usize)| {
            let common = [
                ranges[of][0].max(ranges[less][0]),
                ranges[of][1].min(ranges[less][1]),
            ];
            let is_common = holds(&common, at_speed_m_s);
            let has_range = common[0] < common[1];
            Difference {
                of,
                less,
                at_speed: is_common.then(|| self.compared([of, less], &[at_speed_m_s])),
                over_range: has_range.then(|| self.compared([of, less], &evenly(common))),
                range_m_s: has_range.then_some(common),
            }
        };
        pairs
            .filter(|&(of, less)| is_wanted(of, less))
            .map(difference)
            .collect()
    }

    /// The mean difference of two groups over some speeds, linear in the coefficients about the means.
    fn compared(&self, pair: [usize; 2], speeds_m_s: &[f64]) -> Compared {
        let mut constant = [0.0; 2];
        let [of, less] = [0, 1].map(|number| {
            let group = pair[number];
            let (fit, inputs) = (&self.groups[group], &self.inputs[group]);
            let mut along = DVector::zeros(self.frame.basis.len());
            for &speed_m_s in speeds_m_s {
                let at = self.at(fit, inputs, speed_m_s).mean();
                let share = at.exp() / speeds_m_s.len() as f64;
                along += self.frame.basis.at(speed_m_s) * share;
                constant[number] += share * (1.0 - at);
            }
            fit.linear(&along)
        });
        let constant = constant[0] - constant[1];
        let [one, other] = pair.map(|group| self.balls[group]);
        let same = one == other && one.is_some();
        let mixture = distribution(
            &of,
            Some((&less, same)),
            &self.effects,
            pair.map(|group| &self.inputs[group]),
        );
        Compared {
            difference: mixture.estimate(|value| value + constant, |_| 1.0),
            above_zero: 1.0 - mixture.below(-constant),
        }
    }
}

/// The sums over some drops of a group, for each set of effects.
fn cells(
    frame: &Frame,
    drops: &[StudyDrop],
    effects_of: &[Vec<usize>],
    places: &[usize],
) -> Vec<Cell> {
    let mut cells: BTreeMap<&Vec<usize>, Sums> = BTreeMap::new();
    for &place in places {
        let sums = cells
            .entry(&effects_of[place])
            .or_insert_with(|| Sums::new(&frame.basis));
        sums.add(&Rows::new(&frame.basis, &drops[place].evidence));
    }
    let cells = cells.into_iter();
    cells
        .map(|(effects, sums)| Cell {
            effects: effects.clone(),
            sums,
        })
        .collect()
}

/// What drops share: the mean over them of what each knows.
fn inputs(drops: &[StudyDrop], places: &[usize]) -> Inputs {
    let (mut mean, mut covariance) = (Shared::zeros(), SMatrix::zeros());
    for &place in places {
        let evidence = &drops[place].evidence;
        mean += Shared::from(evidence.inputs);
        covariance += SMatrix::from(evidence.inputs_covariance);
    }
    let count = places.len() as f64;
    Inputs {
        mean: mean / count,
        covariance: covariance / count,
    }
}

/// An estimate of a function that grows with the value.
fn mapped(estimate: &Estimate, of: impl Fn(f64) -> f64) -> Estimate {
    let interval68 = estimate.interval68.map(&of);
    Estimate {
        value: of(estimate.value),
        sd: 0.5 * (interval68[1] - interval68[0]),
        interval68,
        interval95: estimate.interval95.map(&of),
    }
}

/// The speeds at which a curve is given, m/s: its ends, and between them four to an octave, among them 1 m/s.
fn speeds([slowest, fastest]: [f64; 2]) -> Vec<f64> {
    const TO_AN_OCTAVE: f64 = 4.0;
    let step = |speed: f64| TO_AN_OCTAVE * speed.log2();
    let between = (step(slowest).floor() as i32 + 1..step(fastest).ceil() as i32)
        .map(|step| 2_f64.powf(f64::from(step) / TO_AN_OCTAVE));
    let mut speeds = vec![slowest];
    speeds.extend(between);
    if fastest > slowest {
        speeds.push(fastest);
    }
    speeds
}

/// Speeds at equal distances in ln v.
fn evenly([slowest, fastest]: [f64; 2]) -> Vec<f64> {
    const POINTS: usize = 9;
    let share = |point: usize| point as f64 / (POINTS - 1) as f64;
    (0..POINTS)
        .map(|point| slowest * (fastest / slowest).powf(share(point)))
        .collect()
}
