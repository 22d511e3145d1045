//! Which factors can be separated, and the effect of each.

use super::compare::{Difference, compare, compare_means};
use super::mean::Mean;
use super::mixed::{Component, Drop, Factor, Mixed};
use super::quantile::{interval95, student_beyond};
use crate::inference::Measured;

/// What the levels of a factor amount to: heights in metres, temperatures in kelvin.
#[derive(Debug, Clone, PartialEq)]
pub struct Covariate {
    /// The factor, by its place.
    pub factor: usize,
    /// The amount of each level.
    pub of_levels: Vec<f64>,
}

/// How restitution changes with an amount, all else equal.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Trend {
    /// The factor, by its place.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub factor: usize,
    /// How many levels it has.
    pub levels: usize,
    /// Change of restitution for each unit of the amount, with its standard error.
    pub slope: Measured,
    /// Degrees of freedom of the standard error.
    pub degrees: f64,
    /// Where the slope lies with 95 % confidence.
    pub interval95: [f64; 2],
    /// Probability of a slope at least as large if the true slope is zero (the p value).
    pub p_value: f64,
}

/// How much something varies.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct VarianceComponent {
    /// The factors, by their place: several if they always go together and cannot be told apart;
    /// none for the drops themselves.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub factors: Vec<usize>,
    /// How many levels it has.
    pub levels: usize,
    /// Standard deviation of the restitution, with interval.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub component: Component,
}

/// The factors that can be told apart, with the drops.
pub(super) struct Apart {
    drops: Vec<Drop>,
    /// With the levels that these drops have, and no others.
    factors: Vec<Factor>,
    /// What the levels of each factor are called outside.
    outside: Vec<Vec<usize>>,
    /// Factors of two levels or more; those that always go together share an entry.
    distinct: Vec<Vec<usize>>,
}

impl Apart {
    pub(super) fn new(mut drops: Vec<Drop>, factors: &[Factor], amounts: &[Covariate]) -> Self {
        let mut own = Vec::new();
        let mut outside = Vec::new();
        for (place, factor) in factors.iter().enumerate() {
            let has = |level: &usize| drops.iter().any(|d| d.levels[place] == Some(*level));
            let levels: Vec<usize> = (0..factor.levels.len()).filter(has).collect();
            for drop in &mut drops {
                let level = drop.levels[place];
                drop.levels[place] = levels.iter().position(|known| level == Some(*known));
            }
            own.push(Factor {
                name: factor.name.clone(),
                levels: levels
                    .iter()
                    .map(|&level| factor.levels[level].clone())
                    .collect(),
            });
            outside.push(levels);
        }
        // Where nearly every drop has an amount of its own, levels tell nothing.
        let is_line = |factor: usize| {
            let many = 2 * outside[factor].len() > drops.len();
            many && amounts.iter().any(|amounts| amounts.factor == factor)
        };
        let mut distinct: Vec<(Vec<usize>, Vec<usize>)> = Vec::new();
        for factor in (0..factors.len()).filter(|&factor| !is_line(factor)) {
            let partition = partition(&drops, factor);
            if partition.iter().max().is_none_or(|&last| last == 0) {
                continue;
            }
            match distinct.iter_mut().find(|(known, _)| *known == partition) {
                Some((_, together)) => together.push(factor),
                None => distinct.push((partition, vec![factor])),
            }
        }
        Self {
            drops,
            factors: own,
            outside,
            distinct: distinct.into_iter().map(|(_, factors)| factors).collect(),
        }
    }

    pub(super) fn varies(&self) -> Vec<VarianceComponent> {
        let random: Vec<usize> = self.distinct.iter().map(|together| together[0]).collect();
        let Ok(fit) = Mixed::fit(&self.drops, &self.factors, None, &random) else {
            return Vec::new();
        };
        let mut varies: Vec<VarianceComponent> = self
            .distinct
            .iter()
            .enumerate()
            .map(|(place, together)| VarianceComponent {
                factors: together.clone(),
                levels: self.factors[together[0]].levels.len(),
                component: fit.between_levels(place),
            })
            .collect();
        varies.push(VarianceComponent {
            factors: Vec::new(),
            levels: fit.drops(),
            component: fit.between_drops(),
        });
        varies
    }

    /// The slope against an amount; what the other factors do is taken out.
    pub(super) fn trend(&self, amounts: &Covariate) -> Option<Trend> {
        /// Two levels are a difference.
        const FEWEST: usize = 3;
        let factor = amounts.factor;
        let levels = &self.outside[factor];
        if levels.len() < FEWEST {
            return None;
        }
        let amount = |drop: &Drop| Some(amounts.of_levels[levels[drop.levels[factor]?]]);
        let at: Vec<Option<f64>> = self.drops.iter().map(amount).collect();
        let line = Mixed::line(&self.drops, &self.factors, &at, &self.others(factor)).ok()?;
        let (slope, degrees) = line.slope();
        Some(Trend {
            factor,
            levels: levels.len(),
            slope,
            degrees,
            interval95: interval95(slope, degrees),
            p_value: student_beyond(slope.value / slope.sd, degrees),
        })
    }

    /// With one factor its groups may scatter differently; with several, what the others do is taken
    /// out.
    pub(super) fn differences(&self) -> Vec<(usize, Vec<Difference>)> {
        let of_factor = |together: &Vec<usize>| {
            let factor = together[0];
            let others = self.others(factor);
            let mut differences = if others.is_empty() {
                compare_means(&self.means(factor)?)
            } else {
                compare(&self.drops, &self.factors, factor, &others).ok()?
            };
            for difference in &mut differences {
                difference.of = self.outside[factor][difference.of];
                difference.less = self.outside[factor][difference.less];
            }
            Some((factor, differences))
        };
        self.distinct.iter().filter_map(of_factor).collect()
    }

    /// The other factors that can be told apart, one of those that always go together.
    fn others(&self, factor: usize) -> Vec<usize> {
        let apart = self.distinct.iter();
        apart
            .filter(|together| !together.contains(&factor))
            .map(|together| together[0])
            .collect()
    }

    /// The mean of each level.
    fn means(&self, factor: usize) -> Option<Vec<Mean>> {
        (0..self.factors[factor].levels.len())
            .map(|level| {
                let of_level = self
                    .drops
                    .iter()
                    .filter(|d| d.levels[factor] == Some(level));
                let values: Vec<Measured> = of_level.map(|drop| drop.measured).collect();
                Mean::of(&values).ok()
            })
            .collect()
    }
}

/// Which drops stand together in a factor, whatever its levels are called: numbers in the order in
/// which the levels come first.
fn partition(drops: &[Drop], factor: usize) -> Vec<usize> {
    let mut seen = Vec::new();
    drops
        .iter()
        .map(|drop| {
            let level = drop.levels[factor];
            let known = seen.iter().position(|&other| other == level);
            known.unwrap_or_else(|| {
                seen.push(level);
                seen.len() - 1
            })
        })
        .collect()
}
