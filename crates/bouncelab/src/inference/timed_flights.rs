//! The flights between the impacts detected, given their durations.
//!
//! The inference needs the same few flights under thousands of slightly different drags, gravities and
//! contact times. Without drag a flight that lasts T starts and ends at g T/2; the effect of
//! drag on that changes little, and smoothly, with g T, so for each flight and each strength of drag a parabola in g T
//! replaces the [tables](crate::flight::table) from which it is made: fewer operations than an interpolation.

use std::sync::OnceLock;

use super::medium::Medium;
use super::observed::Observed;
use super::parameters::{IMPOSSIBLE_LOG_SPEED, PARABOLA_REACH};
use crate::flight::table::{Blend, FlightTable, FlightTables, STRENGTHS};
use crate::simd::Lanes;

/// The effect of drag on a flight, by the relative change x of g T: the logarithms of its launch speed and of its
/// impact speed over g T/2, each as a + x (b + x c).
pub(super) type Curves = [f64; 6];

/// The flights of a drop of one ball.
#[derive(Debug, Clone)]
pub(super) struct TimedFlights {
    /// 1/(g T) of each interval at the nominal values, s/m; 0 where impacts were missed.
    per_nominal: Vec<f64>,
    nodes: Vec<OnceLock<Vec<Curves>>>,
}

/// The flights under one strength of drag in each lane: the nodes around the strengths, with the weights in each lane.
#[derive(Debug, Clone)]
pub(super) struct FlightsAtStrengths<'a, const L: usize>(Vec<(&'a [Curves], Lanes<L>)>);

impl TimedFlights {
    pub(super) fn new(observed: &Observed, medium: &Medium) -> Self {
        let per_nominal = observed.intervals.iter().map(|interval| {
            if interval.flights == 1 {
                1.0 / (medium.gravity_m_s2 * (interval.duration_s - medium.contact_time_s))
            } else {
                0.0
            }
        });
        Self {
            per_nominal: per_nominal.collect(),
            nodes: vec![OnceLock::new(); STRENGTHS],
        }
    }

    /// Frees the memory of the curves; they are computed anew when they are needed.
    pub(super) fn forget(&mut self) {
        self.nodes = vec![OnceLock::new(); STRENGTHS];
    }

    /// Nominal 1/(g T) of an interval, s/m.
    #[inline(always)]
    pub(super) fn per_nominal(&self, interval: usize) -> f64 {
        self.per_nominal[interval]
    }

    /// The flights with the drag of these tables.
    pub(super) fn at<const L: usize>(
        &self,
        tables: &FlightTables,
        at: &[FlightTable; L],
    ) -> FlightsAtStrengths<'_, L> {
        let firsts = at.iter().map(|table| table.blend.first);
        let (least, greatest) = firsts.fold((STRENGTHS, 0), |(least, greatest), first| {
            (least.min(first), greatest.max(first))
        });
        let nodes = (least..greatest + 4).filter_map(|node| {
            let weight = |Blend { first, weights }: &Blend| {
                let offset = node.checked_sub(*first);
                offset.and_then(|offset| weights.get(offset)).copied()
            };
            let weights = Lanes::of(|lane| weight(&at[lane].blend).unwrap_or(0.0));
            let used = weights.0.iter().any(|weight| *weight != 0.0);
            used.then(|| (self.node(tables, node), weights))
        });
        FlightsAtStrengths(nodes.collect())
    }

    fn node(&self, tables: &FlightTables, node: usize) -> &[Curves] {
        self.nodes[node].get_or_init(|| {
            let table = tables.at_node(node);
            let curves = self.per_nominal.iter().map(|per_nominal| {
                let at = |x: f64| {
                    let gravity_time = (1.0 + x) / per_nominal;
                    let row = table.lasting(gravity_time);
                    let over_free = |speed: f64| (2.0 * speed / gravity_time).ln();
                    row.map_or([IMPOSSIBLE_LOG_SPEED; 2], |row| {
                        [row.launch, row.impact].map(over_free)
                    })
                };
                let (before, here, after) = (at(-PARABOLA_REACH), at(0.0), at(PARABOLA_REACH));
                let parabola = |i: usize| {
                    let slope = (after[i] - before[i]) / (2.0 * PARABOLA_REACH);
                    let bend = (after[i] - 2.0 * here[i] + before[i])
                        / (2.0 * PARABOLA_REACH * PARABOLA_REACH);
                    [here[i], slope, bend]
                };
                let ([a, b, c], [d, e, f]) = (parabola(0), parabola(1));
                [a, b, c, d, e, f]
            });
            curves.collect()
        })
    }
}

impl<const L: usize> FlightsAtStrengths<'_, L> {
    /// The curves of an interval of one flight; [`IMPOSSIBLE_LOG_SPEED`] where it is beyond the tables.
    #[inline(always)]
    pub(super) fn curves(&self, interval: usize) -> [Lanes<L>; 6] {
        let mut curves = [Lanes::all(0.0); 6];
        for (values, weights) in &self.0 {
            for (curve, value) in curves.iter_mut().zip(values[interval]) {
                *curve = *curve + *weights * value;
            }
        }
        curves
    }
}
