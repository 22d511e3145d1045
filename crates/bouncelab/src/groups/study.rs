//! All statistics of the drops of a session.

use std::collections::{BTreeMap, BTreeSet};

use super::compare::Difference;
use super::components::{Apart, Covariate, Trend, VarianceComponent};
use super::curve::{CurvePoint, RestitutionCurve};
use super::mean::Mean;
use super::mixed::{Drop, Factor};
use super::outlier::{Outlier, outliers};
use super::plan::drops_needed;
use crate::error::{Error, Quantity, Result, positive};
use crate::inference::Measured;
use crate::stats::median;

/// What one drop adds to a study.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyDrop {
    /// Its restitution at [`RestitutionCurve::speeds`].
    pub curve: RestitutionCurve,
    /// Scatter of ln e from impact to impact, above zero.
    pub scatter: Option<Measured>,
    /// Level of each factor; `None` where it was not noted.
    pub levels: Vec<Option<usize>>,
}

/// Drops that have the same levels of the factors by which they are grouped.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Group {
    /// Level of each of those factors.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub levels: Vec<Option<usize>>,
    /// The drops, by their place in the list given.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub drops: Vec<usize>,
    /// The mean restitution at the speed of the study, with the scatter between drops.
    #[cfg_attr(feature = "serde", serde(rename = "restitution"))]
    pub mean: Mean,
    /// The same without the outliers of the study, if this group has any and others besides.
    pub without_outliers: Option<Mean>,
    /// Standard uncertainty that all drops share, and that no number of drops makes smaller.
    pub shared_sd: f64,
    /// Typical scatter of restitution from impact to impact, relative.
    pub between_impacts: Option<f64>,
    /// How many drops in all the wanted half width of the 95 % interval takes, or half of the present
    /// one if none was stated.
    pub drops_needed: Option<usize>,
    /// Restitution against speed, pooled over the drops that know it: at each speed a mean of its own.
    pub curve: Vec<MeanAtSpeed>,
}

/// The mean restitution of the drops of a group that know it at an impact speed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MeanAtSpeed {
    /// Impact speed, m/s.
    pub speed_m_s: f64,
    /// The mean there.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub mean: Mean,
}

/// What the drops of a session say together.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Study {
    /// The impact speed at which all drops are compared, m/s.
    pub at_speed_m_s: f64,
    /// Drops that do not know their restitution at this speed, by their place.
    pub left_out: Vec<usize>,
    /// All drops as one group.
    pub all: Group,
    /// The groups, in the order of their levels; a single one repeats `all`.
    pub groups: Vec<Group>,
    /// Who varies: each factor of two levels or more, then the drops.
    pub varies: Vec<VarianceComponent>,
    /// For each factor of two levels or more its place and the differences of its levels. A factor
    /// with amounts that has a level for nearly every drop is not compared by levels.
    pub differences: Vec<(usize, Vec<Difference>)>,
    /// For each factor with amounts and three levels or more, how restitution changes with them.
    pub trends: Vec<Trend>,
    /// Drops that do not belong to their group, by their place in the list given.
    pub outliers: Vec<Outlier>,
}

impl Study {
    /// Studies drops, grouped `by` some of the factors, of which some have amounts.
    ///
    /// Without a speed it takes that which most drops know. `wanted` is the half width of a 95 %
    /// interval for [`Group::drops_needed`].
    ///
    /// # Errors
    /// [`Error::TooFewDrops`] if no drop knows its restitution at the speed, [`Error::OutOfRange`]
    /// for a speed that is not above zero.
    pub fn of(
        drops: &[StudyDrop],
        factors: &[Factor],
        amounts: &[Covariate],
        by: &[usize],
        at_speed_m_s: Option<f64>,
        wanted: Option<f64>,
    ) -> Result<Self> {
        let speed_m_s = match at_speed_m_s {
            Some(speed_m_s) => positive(Quantity::ImpactSpeed, speed_m_s)?,
            None => common_speed_m_s(drops).ok_or(Error::TooFewDrops {
                needed: 1,
                drops: 0,
            })?,
        };
        let known: Vec<Option<CurvePoint>> =
            drops.iter().map(|drop| drop.curve.at(speed_m_s)).collect();
        let used: Vec<usize> = (0..drops.len()).filter(|&i| known[i].is_some()).collect();
        let values: Vec<Measured> = known.iter().flatten().map(own).collect();
        let cells = cells(drops, &used, by);
        let outliers = outliers_of(&cells, &used, &values);
        let odd: BTreeSet<usize> = outliers.iter().map(|outlier| outlier.drop).collect();
        let of = |places: &[usize], levels: Vec<Option<usize>>| {
            group(drops, &known, places, &odd, levels, wanted)
        };
        let groups = cells
            .iter()
            .map(|(levels, places)| of(places, levels.clone()))
            .collect::<Result<Vec<_>>>()?;
        let modelled: Vec<Drop> = used
            .iter()
            .zip(&values)
            .map(|(&place, &measured)| Drop {
                measured,
                levels: drops[place].levels.clone(),
            })
            .collect();
        let apart = Apart::new(modelled, factors, amounts);
        Ok(Self {
            at_speed_m_s: speed_m_s,
            left_out: (0..drops.len()).filter(|&i| known[i].is_none()).collect(),
            all: of(&used, Vec::new())?,
            varies: apart.varies(),
            differences: apart.differences(),
            trends: amounts.iter().filter_map(|a| apart.trend(a)).collect(),
            groups,
            outliers,
        })
    }
}

/// The drops that have the same levels of some factors, by those levels.
type Cells = BTreeMap<Vec<Option<usize>>, Vec<usize>>;

fn cells(drops: &[StudyDrop], used: &[usize], by: &[usize]) -> Cells {
    let mut cells = Cells::new();
    for &place in used {
        let levels = by.iter().map(|&factor| drops[place].levels[factor]);
        cells.entry(levels.collect()).or_default().push(place);
    }
    cells
}

/// The drops that do not belong to their cell, by their place in the list given.
fn outliers_of(cells: &Cells, used: &[usize], values: &[Measured]) -> Vec<Outlier> {
    let mut cell_of = BTreeMap::new();
    for (places, number) in cells.values().zip(0..) {
        cell_of.extend(places.iter().map(|&place| (place, number)));
    }
    let groups: Vec<usize> = used.iter().map(|place| cell_of[place]).collect();
    outliers(values, &groups)
        .into_iter()
        .map(|outlier| Outlier {
            drop: used[outlier.drop],
            ..outlier
        })
        .collect()
}

/// The value of a drop with what of its uncertainty is its own.
fn own(point: &CurvePoint) -> Measured {
    Measured {
        value: point.value,
        sd: point.own_sd,
    }
}

/// The speed that most drops know; of several, the one nearest to the middle of what drops know.
fn common_speed_m_s(drops: &[StudyDrop]) -> Option<f64> {
    let mut known: BTreeMap<u64, usize> = BTreeMap::new();
    for point in drops.iter().flat_map(|drop| &drop.curve.0) {
        // Speeds are positive, so their bits are in the order of their values.
        *known.entry(point.speed_m_s.to_bits()).or_default() += 1;
    }
    let most = known.values().copied().max()?;
    let middle = median(drops.iter().filter_map(|drop| {
        let (first, last) = (drop.curve.0.first()?, drop.curve.0.last()?);
        Some((first.speed_m_s * last.speed_m_s).sqrt().ln())
    }))?;
    known
        .into_iter()
        .filter(|(_, count)| *count == most)
        .map(|(bits, _)| f64::from_bits(bits))
        .min_by(|a, b| (a.ln() - middle).abs().total_cmp(&(b.ln() - middle).abs()))
}

fn group(
    drops: &[StudyDrop],
    known: &[Option<CurvePoint>],
    places: &[usize],
    odd: &BTreeSet<usize>,
    levels: Vec<Option<usize>>,
    wanted: Option<f64>,
) -> Result<Group> {
    let points: Vec<CurvePoint> = places.iter().filter_map(|&place| known[place]).collect();
    let values: Vec<Measured> = points.iter().map(own).collect();
    let mean = Mean::of(&values)?;
    let ordinary = std::iter::zip(places, &values).filter(|(place, _)| !odd.contains(place));
    let ordinary: Vec<Measured> = ordinary.map(|(_, value)| *value).collect();
    let has_both = (1..values.len()).contains(&ordinary.len());
    Ok(Group {
        levels,
        drops: places.to_vec(),
        without_outliers: has_both.then(|| Mean::of(&ordinary)).transpose()?,
        shared_sd: points.iter().map(|point| point.shared_sd).sum::<f64>() / points.len() as f64,
        between_impacts: typical_scatter(places.iter().filter_map(|&place| drops[place].scatter)),
        drops_needed: wanted
            .or_else(|| mean.interval95.map(|[low, high]| 0.25 * (high - low)))
            .and_then(|wanted| drops_needed(&mean, wanted)),
        curve: pooled(drops, places),
        mean,
    })
}

/// The scatter that drops have in common. One drop knows its own to a fifth or so, as a factor: the
/// mean of the logarithms is not raised by that, as a mean of squares would be.
fn typical_scatter(scatters: impl Iterator<Item = Measured>) -> Option<f64> {
    let logarithms: Vec<Measured> = scatters
        .map(|scatter| Measured {
            value: scatter.value.ln(),
            sd: scatter.sd / scatter.value,
        })
        .collect();
    Some(Mean::of(&logarithms).ok()?.value.exp())
}

/// At each speed the mean of the drops that know it.
fn pooled(drops: &[StudyDrop], places: &[usize]) -> Vec<MeanAtSpeed> {
    let mut at_speed: BTreeMap<u64, Vec<Measured>> = BTreeMap::new();
    for point in places.iter().flat_map(|&place| &drops[place].curve.0) {
        let known = at_speed.entry(point.speed_m_s.to_bits()).or_default();
        known.push(own(point));
    }
    at_speed
        .into_iter()
        .filter_map(|(bits, values)| {
            Some(MeanAtSpeed {
                speed_m_s: f64::from_bits(bits),
                mean: Mean::of(&values).ok()?,
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(slowest: f64, fastest: f64, value: impl Fn(f64) -> f64) -> RestitutionCurve {
        let points = RestitutionCurve::speeds(slowest, fastest).into_iter();
        RestitutionCurve(
            points
                .map(|speed_m_s| CurvePoint {
                    speed_m_s,
                    value: value(speed_m_s),
                    own_sd: 0.001,
                    shared_sd: 0.0005,
                })
                .collect(),
        )
    }

    fn factor(name: &str, levels: &[&str]) -> Factor {
        Factor {
            name: name.to_owned(),
            levels: levels.iter().map(|level| (*level).to_owned()).collect(),
        }
    }

    /// Drops from different heights of a ball whose restitution falls with speed differ at their own
    /// speeds and agree at a common one.
    #[test]
    fn drops_from_different_heights_meet_at_one_speed() {
        let falling = |speed: f64| 0.95 - 0.01 * speed;
        let drops: Vec<StudyDrop> = [2.0, 3.0, 4.5, 2.5]
            .iter()
            .map(|&fastest| StudyDrop {
                curve: curve(0.7, fastest, falling),
                scatter: Some(Measured {
                    value: 0.003,
                    sd: 0.0006,
                }),
                levels: vec![],
            })
            .collect();
        let study = Study::of(&drops, &[], &[], &[], None, Some(0.01)).unwrap();
        assert!(study.at_speed_m_s <= 2.0);
        let expected = falling(study.at_speed_m_s);
        assert!((study.all.mean.value - expected).abs() < 1e-9);
        assert!((study.all.between_impacts.unwrap() - 0.003).abs() < 1e-12);
        assert!((study.all.shared_sd - 0.0005).abs() < 1e-12);
        assert_eq!(study.groups.len(), 1);
        let fastest = study.all.curve.last().unwrap();
        assert!(fastest.speed_m_s >= 4.0 && fastest.mean.drops == 1);
        let fast = Study::of(&drops, &[], &[], &[], Some(4.0), None).unwrap();
        assert_eq!(fast.left_out, [0, 1, 3]);
        assert!(Study::of(&drops, &[], &[], &[], Some(40.0), None).is_err());
    }

    /// The low drops never were as fast, so their height is no level there; the others are compared.
    #[test]
    fn levels_that_do_not_know_the_speed_do_not_hide_the_others() {
        let factors = [
            factor("height", &["low", "middle", "high"]),
            factor("ball", &["a", "b"]),
        ];
        let drops: Vec<StudyDrop> = (0..18)
            .map(|drop| StudyDrop {
                curve: curve(0.5, [1.5, 3.0, 4.5][drop % 3], |_| {
                    0.9 + 0.01 * (drop / 3 % 2) as f64 + 0.0004 * (drop / 6) as f64
                }),
                scatter: None,
                levels: vec![Some(drop % 3), Some(drop / 3 % 2)],
            })
            .collect();
        let study = Study::of(&drops, &factors, &[], &[1], Some(2.5), None).unwrap();
        assert_eq!(study.left_out.len(), 6);
        let (factor, of_height) = &study.differences[0];
        assert_eq!((*factor, of_height.len()), (0, 1));
        assert_eq!((of_height[0].of, of_height[0].less), (2, 1));
        let (factor, of_ball) = &study.differences[1];
        assert_eq!(*factor, 1);
        assert!((of_ball[0].value.value - 0.01).abs() < 1e-6);
        assert_eq!(study.varies[0].levels, 2);
    }

    /// Scatters that are known to a quarter, spread by as much as that: their root mean square is 3 %
    /// above what is common to them.
    #[test]
    fn uncertain_scatters_do_not_add_up() {
        let spread = [-0.25_f64, 0.25, -0.25, 0.25].map(|off| 0.003 * off.exp());
        let scatters = spread.map(|value| Measured {
            value,
            sd: 0.25 * value,
        });
        let typical = typical_scatter(scatters.into_iter()).unwrap();
        assert!((typical - 0.003).abs() < 1e-9, "{typical}");
        assert_eq!(typical_scatter(std::iter::empty()), None);
    }

    /// Sixteen drops of two balls, each at a temperature of its own: e grows by 0.0005 a kelvin. The
    /// last drop but one is far off.
    #[test]
    fn an_amount_that_every_drop_has_of_its_own_is_a_line() {
        let factors = [
            factor("ball", &["a", "b"]),
            Factor {
                name: "temperature".to_owned(),
                levels: (0..16).map(|kelvin| kelvin.to_string()).collect(),
            },
        ];
        let drops: Vec<StudyDrop> = (0..16)
            .map(|drop| StudyDrop {
                curve: curve(1.0, 2.0, |_| {
                    let kelvin = drop as f64;
                    let odd = if drop == 14 { 0.1 } else { 0.0 };
                    0.9 + 0.02 * (drop % 2) as f64 + 0.0005 * kelvin + odd
                }),
                scatter: None,
                levels: vec![Some(drop % 2), Some(drop)],
            })
            .collect();
        let amounts = Covariate {
            factor: 1,
            of_levels: (0..16).map(|kelvin| 290.0 + f64::from(kelvin)).collect(),
        };
        let study = |drops: &[StudyDrop]| {
            let amounts = std::slice::from_ref(&amounts);
            Study::of(drops, &factors, amounts, &[0], None, None).unwrap()
        };
        let found = study(&drops);
        assert_eq!(found.outliers[0].drop, 14);
        let (with, without) = (&found.groups[0].mean, found.groups[0].without_outliers);
        assert!((with.drops, without.unwrap().drops) == (8, 7));
        assert!(with.value - without.unwrap().value > 0.01);
        assert_eq!(found.groups[1].without_outliers, None);
        let found = study(&[&drops[..14], &drops[15..]].concat());
        let [trend] = found.trends.as_slice() else {
            panic!("{:?}", found.trends)
        };
        assert_eq!((trend.factor, trend.levels), (1, 15));
        assert!((trend.slope.value - 0.0005).abs() < 1e-6, "{trend:?}");
        let compared: Vec<usize> = found
            .differences
            .iter()
            .map(|(factor, _)| *factor)
            .collect();
        assert_eq!(compared, [0]);
    }

    #[test]
    fn factors_that_always_go_together_are_one() {
        let factors = [
            factor("ball", &["a", "b", "c"]),
            factor("operator", &["x", "y", "z"]),
            factor("surface", &["one"]),
        ];
        let drops: Vec<StudyDrop> = (0..9)
            .map(|drop| {
                let value = 0.9 + 0.01 * (drop % 3) as f64 + 0.0005 * (drop / 3) as f64;
                StudyDrop {
                    curve: curve(1.0, 2.0, |_| value),
                    scatter: None,
                    levels: vec![Some(drop % 3), Some(2 - drop % 3), Some(0)],
                }
            })
            .collect();
        let study = Study::of(&drops, &factors, &[], &[0], None, None).unwrap();
        assert_eq!(study.varies.len(), 2);
        assert_eq!(study.varies[0].factors, [0, 1]);
        assert!((study.varies[0].component.sd - 0.01).abs() < 0.001);
        assert_eq!(study.varies[1].factors, Vec::<usize>::new());
        assert_eq!(study.groups.len(), 3);
        let (factor, differences) = &study.differences[0];
        assert_eq!((*factor, differences.len()), (0, 3));
        assert!((differences[0].value.value - 0.01).abs() < 1e-9);
    }
}
