//! One model of all drops of a session.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::DVector;

use super::evidence::{CurveEvidence, SHARED_INPUTS};
use super::fit::{Cell, Effects, Frame, GroupFit, Inputs, Linear, distribution};
use super::heights::{self, Height};
use super::mixture::Mixture;
use super::outlier::{Outlier, outliers};
use super::plan::drops_needed;
use super::sums::{Basis, GroupSums, Rows, Sums, wider};
use crate::error::{Error, Quantity, Result, positive};
use crate::estimate::Estimate;
use crate::inference::Measured;

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
    /// By how much stated heights are larger than those inferred from sound, m, if two or more are stated.
    pub ruler_zero_m: Option<Estimate>,
    /// Drops that do not belong to their group.
    pub outliers: Vec<Outlier>,
}

impl Asked {
    /// The levels of a drop by which it may scatter.
    pub(super) fn effects_of(&self, drop: &StudyDrop) -> Vec<Option<usize>> {
        let random = self.random.iter().take(MAX_RANDOM);
        random.map(|&factor| drop.levels[factor]).collect()
    }
}

impl Study {
    /// Studies drops.
    ///
    /// # Errors
    /// [`Error::TooFewDrops`] if no drop has evidence or no group has the speed, [`Error::OutOfRange`] for a speed that is not
    /// above zero.
    pub fn of(drops: &[StudyDrop], asked: &Asked) -> Result<Self> {
        let mut members: BTreeMap<Vec<Option<usize>>, (GroupSums, Vec<usize>)> = BTreeMap::new();
        for (place, drop) in drops.iter().enumerate() {
            if drop.evidence.is_usable() {
                let levels = asked.by.iter().map(|&factor| drop.levels[factor]);
                let (sums, places) = members.entry(levels.collect()).or_default();
                sums.add(drop, asked);
                places.push(place);
            }
        }
        let (groups, places): (Vec<_>, Vec<_>) = members
            .into_iter()
            .map(|(levels, (sums, places))| ((levels, sums), places))
            .unzip();
        let fitting = Fitting::new(&groups, asked)?;
        Ok(fitting.with_drops(fitting.study(), drops, &places))
    }

    /// Studies groups, each of its levels, by sums over their drops: without what needs each drop ([`Study::drops`], outliers
    /// and the ruler's zero).
    ///
    /// # Errors
    /// As [`Study::of`].
    pub fn of_sums(groups: &[(Vec<Option<usize>>, GroupSums)], asked: &Asked) -> Result<Self> {
        Ok(Fitting::new(groups, asked)?.study())
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

/// A group, fitted.
struct FittedGroup<'a> {
    levels: &'a [Option<usize>],
    sums: &'a GroupSums,
    range_m_s: [f64; 2],
    inputs: Inputs,
    fit: GroupFit,
}

/// All groups, fitted.
struct Fitting<'a> {
    asked: &'a Asked,
    at_speed_m_s: f64,
    frame: Frame,
    /// The effect of the first level of each factor that scatters.
    first_effects: Vec<usize>,
    groups: Vec<FittedGroup<'a>>,
    effects: Vec<(f64, Effects)>,
    scatters: Vec<Estimate>,
}

impl<'a> Fitting<'a> {
    fn new(groups: &'a [(Vec<Option<usize>>, GroupSums)], asked: &'a Asked) -> Result<Self> {
        let too_few = Error::TooFewDrops {
            needed: 1,
            drops: 0,
        };
        let ranges: Vec<[f64; 2]> = groups
            .iter()
            .filter_map(|(_, sums)| sums.range_m_s())
            .collect();
        let Some(whole) = ranges.iter().copied().reduce(wider) else {
            return Err(too_few);
        };
        let at_speed_m_s = match asked.at_speed_m_s {
            Some(speed_m_s) => {
                positive(Quantity::ImpactSpeed, speed_m_s)?;
                if !ranges.iter().any(|range| holds(range, speed_m_s)) {
                    return Err(too_few);
                }
                speed_m_s
            }
            None => common_speed_m_s(&ranges, whole),
        };
        let (mut factors, mut first_effects) = (Vec::new(), Vec::new());
        for number in 0..asked.random.len().min(MAX_RANDOM) {
            first_effects.push(factors.len());
            let levels = groups.iter().flat_map(|(_, sums)| sums.levels());
            let count = levels
                .filter_map(|levels| levels[number])
                .max()
                .map_or(0, |last| last + 1);
            factors.resize(factors.len() + count, number);
        }
        let frame = Frame::new(Basis::covering(whole), factors);
        let mut fitted = Vec::new();
        for ((levels, sums), range_m_s) in groups.iter().zip(ranges) {
            let of_ball = groups
                .iter()
                .map(|(_, other)| other)
                .filter(|other| other.balls() == sums.balls());
            let inputs = GroupSums::inputs(of_ball);
            let cells = cells(&frame, &first_effects, sums);
            fitted.push(FittedGroup {
                levels,
                sums,
                range_m_s,
                fit: GroupFit::new(&frame, &cells, &inputs).ok_or_else(|| too_few.clone())?,
                inputs,
            });
        }
        let fits = fitted.iter().map(|group| &group.fit);
        let (effects, scatters) = Effects::of(&frame, fits, first_effects.len());
        Ok(Self {
            asked,
            at_speed_m_s,
            frame,
            first_effects,
            groups: fitted,
            effects,
            scatters,
        })
    }

    /// The groups and their differences.
    fn study(&self) -> Study {
        let random = self.asked.random.iter().copied();
        Study {
            at_speed_m_s: self.at_speed_m_s,
            groups: self.groups.iter().map(|group| self.group(group)).collect(),
            differences: self.differences(),
            scatters: random.zip(self.scatters.iter().copied()).collect(),
            drops: Vec::new(),
            ruler_zero_m: None,
            outliers: Vec::new(),
        }
    }

    /// The study with each drop in the light of the others, and what follows from it. Each group has its drops at these places.
    fn with_drops(&self, mut study: Study, drops: &[StudyDrop], places: &[Vec<usize>]) -> Study {
        let mut fitted = vec![None; drops.len()];
        let mut found_heights = vec![None; drops.len()];
        for (group, places) in places.iter().enumerate() {
            for &place in places {
                let effects = effects(&self.first_effects, &self.asked.effects_of(&drops[place]));
                let evidence = &drops[place].evidence;
                fitted[place] = Some(FittedDrop {
                    group,
                    off: self.off(group, evidence, &effects),
                    of_operators: self.of_operators(&effects),
                    height_m: None,
                });
                found_heights[place] = self.height(group, evidence, &effects);
            }
        }
        let (ruler_zero_m, found_heights) = heights::with_zero(&found_heights);
        for (fitted, height_m) in fitted.iter_mut().zip(found_heights) {
            if let Some(fitted) = fitted {
                fitted.height_m = height_m;
            }
        }
        let of_fitted = fitted
            .iter()
            .enumerate()
            .filter_map(|(place, fitted)| Some((place, (*fitted)?)));
        let (places_of, (groups_of, offs)): (Vec<usize>, (Vec<usize>, Vec<Measured>)) = of_fitted
            .map(|(place, fitted)| (place, (fitted.group, fitted.off)))
            .unzip();
        let in_list = |outlier: Outlier| Outlier {
            drop: places_of[outlier.drop],
            ..outlier
        };
        study.outliers = outliers(&offs, &groups_of)
            .into_iter()
            .map(in_list)
            .collect();
        let odd: BTreeSet<usize> = study.outliers.iter().map(|outlier| outlier.drop).collect();
        for ((group, of_group), places) in study.groups.iter_mut().zip(&self.groups).zip(places) {
            let others = places
                .iter()
                .filter(|place| !odd.contains(place))
                .map(|&place| &drops[place]);
            group.without_outliers = self.without_outliers(of_group, others);
            group.drops.clone_from(places);
        }
        Study {
            drops: fitted,
            ruler_zero_m,
            ..study
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
    fn of_operators(&self, effects: &[usize]) -> f64 {
        let levels = &self.likeliest_effects().mean;
        effects.iter().map(|&effect| levels[effect]).sum()
    }

    /// The level of a drop above that of its group and operators: that of its readings v - X β - a o - L z, by least squares.
    fn off(&self, group: usize, evidence: &CurveEvidence, effects: &[usize]) -> Measured {
        let group = &self.groups[group];
        let rows = Rows::new(self.frame.basis, evidence);
        let len = self.frame.basis.len();
        let along = rows.table.tr_mul(&rows.level);
        let linear = group.fit.likeliest_linear(&along.rows(0, len).into_owned());
        let of_inputs = along
            .fixed_rows::<SHARED_INPUTS>(len)
            .dot(&group.inputs.mean);
        let of_curve = linear.mean + linear.by_effects.dot(&self.likeliest_effects().mean);
        Measured {
            value: (along[len + SHARED_INPUTS] - of_curve - of_inputs) / rows.precision()
                - self.of_operators(effects),
            sd: rows.precision().sqrt().recip(),
        }
    }

    fn height(&self, group: usize, evidence: &CurveEvidence, effects: &[usize]) -> Option<Height> {
        let group = &self.groups[group];
        let of_all = self.likeliest_effects();
        Height::new(
            &self.frame,
            evidence,
            effects,
            &group.fit,
            of_all,
            &group.inputs,
        )
    }

    /// ln e of a group at a speed.
    fn at(&self, group: &GroupFit, inputs: &Inputs, speed_m_s: f64) -> Mixture {
        let linear = group.linear(&self.frame.basis.at(speed_m_s));
        distribution(&linear, None, &self.effects, [inputs; 2])
    }

    fn group(&self, group: &FittedGroup<'_>) -> Group {
        let (fit, inputs, at_speed_m_s) = (&group.fit, &group.inputs, self.at_speed_m_s);
        let restitution = |speed_m_s: f64| self.restitution(fit, inputs, speed_m_s);
        let has_speed = holds(&group.range_m_s, at_speed_m_s);
        let here = has_speed.then(|| restitution(at_speed_m_s));
        let linear = fit.linear(&self.frame.basis.at(at_speed_m_s));
        let one_drop = fit.scatter.value.hypot(fit.own_sd);
        let shared = self.shared(fit, inputs, at_speed_m_s);
        let operators = self.asked.random.iter().zip(&self.scatters);
        let operators = operators.filter(|(factor, _)| Some(**factor) != self.asked.ball);
        let operators = operators
            .map(|(_, scatter)| scatter.value)
            .reduce(f64::hypot);
        Group {
            levels: group.levels.to_vec(),
            count: group.sums.drops(),
            drops: Vec::new(),
            range_m_s: group.range_m_s,
            restitution: here,
            shared_sd: here.map(|here| here.value * shared),
            next95: here.map(|_| self.next(&linear, inputs)),
            without_outliers: None,
            between_drops: fit.scatter,
            between_impacts: group.sums.between_impacts(),
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
                let wanted = self.asked.wanted.unwrap_or(0.25 * (high - low));
                drops_needed(one_drop, shared, wanted / here.value)
            }),
            curve: speeds(group.range_m_s)
                .into_iter()
                .map(|speed_m_s| CurvePoint {
                    speed_m_s,
                    restitution: restitution(speed_m_s),
                })
                .collect(),
        }
    }

    fn restitution(&self, fit: &GroupFit, inputs: &Inputs, speed_m_s: f64) -> Estimate {
        self.at(fit, inputs, speed_m_s).estimate(f64::exp, f64::exp)
    }

    /// The restitution of a group at the speed of the study by some of its drops, if these are neither none nor all.
    fn without_outliers<'d>(
        &self,
        group: &FittedGroup<'_>,
        drops: impl Iterator<Item = &'d StudyDrop>,
    ) -> Option<Estimate> {
        let mut sums = GroupSums::default();
        drops.for_each(|drop| sums.add(drop, self.asked));
        if !(1..group.sums.drops()).contains(&sums.drops())
            || !holds(&group.range_m_s, self.at_speed_m_s)
        {
            return None;
        }
        let cells = cells(&self.frame, &self.first_effects, &sums);
        let fit = GroupFit::new(&self.frame, &cells, &group.inputs)?;
        Some(self.restitution(&fit, &group.inputs, self.at_speed_m_s))
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

    fn differences(&self) -> Vec<Difference> {
        /// More groups have too many pairs.
        const FEW: usize = 6;
        let is_wanted = |of: usize, less: usize| {
            let levels = std::iter::zip(self.groups[of].levels, self.groups[less].levels);
            self.groups.len() <= FEW || levels.filter(|(one, other)| one != other).count() == 1
        };
        let pairs = (0..self.groups.len())
            .flat_map(|less| (less + 1..self.groups.len()).map(move |of| (of, less)));
        let difference = |(of, less): (usize, usize)| {
            let [one, other] = [of, less].map(|group| self.groups[group].range_m_s);
            let common = [one[0].max(other[0]), one[1].min(other[1])];
            let is_common = holds(&common, self.at_speed_m_s);
            let has_range = common[0] < common[1];
            Difference {
                of,
                less,
                at_speed: is_common.then(|| self.compared([of, less], &[self.at_speed_m_s])),
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
            let FittedGroup { fit, inputs, .. } = &self.groups[pair[number]];
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
        let [one, other] = pair.map(|group| self.groups[group].sums.balls());
        let same = one == other && one.len() == 1;
        let mixture = distribution(
            &of,
            Some((&less, same)),
            &self.effects,
            pair.map(|group| &self.groups[group].inputs),
        );
        Compared {
            difference: mixture.estimate(|value| value + constant, |_| 1.0),
            above_zero: 1.0 - mixture.below(-constant),
        }
    }
}

/// The effects of these levels of the factors that scatter, by index.
fn effects(first: &[usize], levels: &[Option<usize>]) -> Vec<usize> {
    let of_factors = std::iter::zip(first, levels);
    of_factors
        .filter_map(|(first, level)| Some(first + (*level)?))
        .collect()
}

/// The sums of a group for each set of effects, over the common basis.
fn cells(frame: &Frame, first_effects: &[usize], sums: &GroupSums) -> Vec<Cell> {
    let of_levels = |(levels, sums): (&[Option<usize>], Sums)| Cell {
        effects: effects(first_effects, levels),
        sums,
    };
    sums.cells(frame.basis).map(of_levels).collect()
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
