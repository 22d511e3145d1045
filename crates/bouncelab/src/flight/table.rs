//! Many flights of one ball at once, for the inference.
//!
//! The inference needs the same few flights under thousands of slightly different drags, and a
//! quadrature for each would take seconds. Here all flights of a ball up to a maximum launch speed
//! are solved by one integration over the launch speed v. With η drag over weight and v' the impact
//! speed, energy gives
//!
//! dv'/dv = (v/v') (1 - η(v'))/(1 + η(v)),  d(gT)/dv = (1 + v/v')/(1 + η(v)),  d(gh)/dv = v/(1 + η(v)),
//!
//! which are smooth, continue beyond the terminal speed and do not depend on gravity. A second integration, over gT,
//! gives the flight of a given duration. Both are computed for a few strengths of drag, each when it is
//! first needed, and interpolated by cubics: with the slopes between the nodes of an integration (a march), and through
//! four nodes between the strengths. The error is 1e-8, and 1e-6 where drag is as large as the
//! weight, far below any noise; the tests compare with [`FlightModel`](super::FlightModel).

use std::array;
use std::sync::OnceLock;

use super::FlightModel;
use crate::error::Result;

/// Nodes of the drag profile: it is evaluated between the nodes of the march too.
const PROFILE: usize = 1024;

/// Drag over weight of a ball, for speeds from zero to a maximum.
#[derive(Debug, Clone)]
pub(crate) struct DragProfile {
    /// Drag over weight over speed, s/m, at equal steps of speed: nearly straight for every law.
    per_speed: Vec<f64>,
    step: f64,
    /// Steps of the march over the launch speed.
    march: usize,
}

impl DragProfile {
    /// The drag of a model up to a speed, for tables of `march` steps; beyond the range of its law the drag
    /// coefficient is constant.
    pub(crate) fn new(model: &FlightModel, max_speed_m_s: f64, march: usize) -> Result<Self> {
        let step = max_speed_m_s / PROFILE as f64;
        let mut per_speed = Vec::with_capacity(PROFILE + 2);
        // At rest the ratio is that of creeping flow, which is reached at a very low speed.
        per_speed.push(model.drag_over_weight(step * 1e-6)? / (step * 1e-6));
        for node in 1..PROFILE + 2 {
            let speed = step * node as f64;
            let value = match model.drag_over_weight(speed) {
                Ok(share) => share / speed,
                Err(error) if node == 1 => return Err(error),
                Err(_) => per_speed[node - 1] * node as f64 / (node - 1) as f64,
            };
            per_speed.push(value);
        }
        Ok(Self {
            per_speed,
            step,
            march,
        })
    }

    /// The maximum launch speed of a table over this profile, m/s.
    fn fastest(&self) -> f64 {
        self.step * PROFILE as f64
    }

    fn march_step(&self) -> f64 {
        self.fastest() / self.march as f64
    }

    #[inline]
    fn over_weight(&self, speed: f64) -> f64 {
        let steps = (speed / self.step).clamp(0.0, PROFILE as f64);
        let node = steps as usize;
        let share = steps - node as f64;
        let (low, high) = (self.per_speed[node], self.per_speed[node + 1]);
        speed * (low + share * (high - low))
    }
}

/// The flight of a launch speed, independent of gravity: multiply or divide by it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Row {
    /// Launch speed, m/s.
    pub(crate) launch: f64,
    /// Speed at the next impact, m/s.
    pub(crate) impact: f64,
    /// Gravity times flight time, m/s.
    pub(crate) time: f64,
    /// d ln(flight time)/d ln(launch).
    pub(crate) time_slope: f64,
    /// d ln(impact speed)/d ln(launch).
    pub(crate) impact_slope: f64,
}

impl Row {
    /// From the launch speed, and from impact speed and g T with their slopes by it.
    #[inline]
    fn of_launch(launch: f64, [[impact, impact_slope], [time, time_slope]]: [[f64; 2]; 2]) -> Self {
        Self {
            launch,
            impact,
            time,
            time_slope: time_slope * launch / time,
            impact_slope: impact_slope * launch / impact,
        }
    }
}

/// Every flight of a ball, for every strength of drag.
#[derive(Debug, Clone)]
pub(crate) struct FlightTables {
    profile: DragProfile,
    marches: Vec<OnceLock<March>>,
}

/// Strengths s lie at equal steps of s/(1 + s), so that weak and strong drag are resolved equally well.
pub(crate) const STRENGTHS: usize = 64;

/// A strength of drag among the nodes: four of them, and their weights.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Blend {
    /// The first of the four nodes.
    pub(crate) first: usize,
    pub(crate) weights: [f64; 4],
}

impl Blend {
    /// `None` for a strength below zero, and beyond the nodes.
    pub(crate) fn of(strength: f64) -> Option<Self> {
        let steps = STRENGTHS as f64 * strength / (1.0 + strength);
        if !(strength >= 0.0 && steps + 2.0 < STRENGTHS as f64) {
            return None;
        }
        let first = (steps as usize).saturating_sub(1);
        let t = steps - first as f64;
        Some(Self {
            first,
            // Lagrange, through the nodes 0, 1, 2 and 3.
            weights: [
                (1.0 - t) * (2.0 - t) * (3.0 - t) / 6.0,
                t * (2.0 - t) * (3.0 - t) / 2.0,
                t * (t - 1.0) * (3.0 - t) / 2.0,
                t * (t - 1.0) * (t - 2.0) / 6.0,
            ],
        })
    }
}

/// Every flight of a ball under one drag: a view of the tables.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FlightTable<'a> {
    marches: [&'a March; 4],
    pub(crate) blend: Blend,
    step: f64,
    /// Number of nodes of time that all marches have. The stronger the drag, the shorter the longest flight; a march may
    /// end earlier where it breaks down.
    times: usize,
}

/// All flights under the drag of a node.
#[derive(Debug, Clone)]
struct March {
    by_speed: Vec<SpeedNode>,
    by_time: Vec<TimeNode>,
}

/// A whole flight: up, and down again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RiseAndFall {
    pub(crate) row: Row,
    /// Gravity times the height of the apex, and d ln(height)/d ln(launch).
    pub(crate) gravity_height: f64,
    pub(crate) height_slope: f64,
    /// Gravity times the time of the fall from the apex, m/s.
    pub(crate) fall_time: f64,
}

/// Values and slopes by the launch speed at a node, all free of gravity: those of [`IMPACT`], [`TIME`],
/// [`FREE_FALL`] and [`FALL`].
type SpeedNode = [[f64; 2]; 4];

/// Impact speed.
const IMPACT: usize = 0;
/// g T.
const TIME: usize = 1;
/// (2 g h)^1/2, which is nearly straight where the height is not.
const FREE_FALL: usize = 2;
/// g times the fall time.
const FALL: usize = 3;

/// The same between the strengths of four marches, one after the other.
type BlendedNode = [f64; 8];

/// Every flight of a ball under one drag, for many flights near each other: each node is blended once.
#[derive(Debug)]
pub(crate) struct BlendedTable<'a> {
    table: FlightTable<'a>,
    nodes: Vec<Option<BlendedNode>>,
}

impl BlendedTable<'_> {
    /// As that of [`FlightTable`].
    #[inline]
    pub(crate) fn rise_and_fall(&mut self, speed: f64) -> Option<RiseAndFall> {
        let (node, t) = self.table.around(speed)?;
        if self.nodes.len() < node + 2 {
            self.nodes.resize(node + 2, None);
        }
        let ends = [node, node + 1]
            .map(|node| *self.nodes[node].get_or_insert_with(|| self.table.blended(node)));
        Some(RiseAndFall::between(&ends, t, self.table.step, speed))
    }
}

impl RiseAndFall {
    /// At a share t of the step between two nodes.
    #[inline]
    fn between([low, high]: &[BlendedNode; 2], t: f64, step: f64, speed: f64) -> Self {
        let of = |value: usize| {
            let pair = |node: &BlendedNode| [node[2 * value], node[2 * value + 1]];
            hermite(pair(low), pair(high), t, step)
        };
        let ([free_fall, slope], [fall_time, _]) = (of(FREE_FALL), of(FALL));
        Self {
            row: Row::of_launch(speed, [of(IMPACT), of(TIME)]),
            gravity_height: 0.5 * free_fall * free_fall,
            height_slope: 2.0 * slope * speed / free_fall,
            fall_time,
        }
    }
}

/// Values and slopes by g T at a node.
#[derive(Debug, Clone, Copy)]
struct TimeNode {
    launch: [f64; 2],
    impact: [f64; 2],
}

impl FlightTables {
    /// Tables for the drag of a profile, still empty.
    pub(crate) fn new(profile: DragProfile) -> Self {
        Self {
            profile,
            marches: vec![OnceLock::new(); STRENGTHS],
        }
    }

    /// Forgets the flights; they are solved again when they are needed.
    pub(crate) fn forget(&mut self) {
        self.marches = vec![OnceLock::new(); STRENGTHS];
    }

    /// The flights with `strength` times the drag of the profile; `None` below zero, and above
    /// thirty or so.
    pub(crate) fn at(&self, strength: f64) -> Option<FlightTable<'_>> {
        let blend = Blend::of(strength)?;
        let marches: [&March; 4] = array::from_fn(|node| self.march(blend.first + node));
        Some(self.between(marches, blend))
    }

    /// The flights with the drag of one node.
    pub(crate) fn at_node(&self, node: usize) -> FlightTable<'_> {
        let blend = Blend {
            first: node,
            weights: [1.0, 0.0, 0.0, 0.0],
        };
        self.between([self.march(node); 4], blend)
    }

    fn between<'a>(&self, marches: [&'a March; 4], blend: Blend) -> FlightTable<'a> {
        let times = marches.iter().map(|march| march.by_time.len());
        FlightTable {
            marches,
            times: times.min().unwrap_or(0),
            blend,
            step: self.profile.march_step(),
        }
    }

    fn march(&self, node: usize) -> &March {
        self.marches[node].get_or_init(|| {
            let strength = node as f64 / (STRENGTHS - node) as f64;
            March {
                by_speed: march_by_speed(&self.profile, strength),
                by_time: march_by_time(&self.profile, strength),
            }
        })
    }
}

/// Solves all flights with `strength` times the drag of a profile, at equal steps of the launch speed.
fn march_by_speed(profile: &DragProfile, strength: f64) -> Vec<SpeedNode> {
    let step = profile.march_step();
    let over_weight = |speed: f64| strength * profile.over_weight(speed);
    let slope =
        |slowing: f64, v: f64, impact: f64| v * (1.0 - over_weight(impact)) / (impact * slowing);
    // Time, g h and fall time.
    let rates = |slowing: f64, v: f64, impact: f64| {
        [
            (1.0 + v / impact) / slowing,
            v / slowing,
            v / (impact * slowing),
        ]
    };
    let (mut impact, mut slope_here) = (0.0, 1.0);
    let mut sums = [0.0; 3];
    // At rest the impact speed is the launch speed.
    let mut rates_here = [2.0, 0.0, 1.0];
    let mut nodes = vec![speed_node([0.0, 1.0], sums, rates_here)];
    for node in 1..=profile.march {
        let v = step * (node - 1) as f64;
        let (middle, end) = (v + 0.5 * step, v + step);
        let (slowing_middle, slowing_end) = (1.0 + over_weight(middle), 1.0 + over_weight(end));
        // Runge-Kutta for the impact speed; its first slope is the last of the step before.
        let k1 = slope_here;
        let k2 = slope(slowing_middle, middle, impact + 0.5 * step * k1);
        let k3 = slope(slowing_middle, middle, impact + 0.5 * step * k2);
        let k4 = slope(slowing_end, end, impact + step * k3);
        let next = impact + step / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
        let slope_end = slope(slowing_end, end, next);
        // Simpson for the rest, the middle from the cubic through both ends.
        let between = 0.5 * (impact + next) + step / 8.0 * (slope_here - slope_end);
        let rates_middle = rates(slowing_middle, middle, between);
        let rates_end = rates(slowing_end, end, next);
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum += step / 6.0 * (rates_here[i] + 4.0 * rates_middle[i] + rates_end[i]);
        }
        nodes.push(speed_node([next, slope_end], sums, rates_end));
        (impact, slope_here) = (next, slope_end);
        rates_here = rates_end;
    }
    nodes
}

/// The same at equal steps of gravity times the flight time, twice those of the launch speed: without
/// drag a launch lasts twice its speed over gravity.
fn march_by_time(profile: &DragProfile, strength: f64) -> Vec<TimeNode> {
    let step = TIME_STEP * profile.march_step();
    let over_weight = |speed: f64| strength * profile.over_weight(speed);
    let slopes = |[launch, impact]: [f64; 2]| {
        let both = launch + impact;
        [
            impact * (1.0 + over_weight(launch)) / both,
            launch * (1.0 - over_weight(impact)) / both,
        ]
    };
    let mut speeds = [0.0; 2];
    // At rest both speeds are alike.
    let mut slopes_here = [0.5; 2];
    let mut nodes = Vec::with_capacity(profile.march + 1);
    while speeds[0] <= profile.fastest() && nodes.len() <= profile.march {
        nodes.push(TimeNode {
            launch: [speeds[0], slopes_here[0]],
            impact: [speeds[1], slopes_here[1]],
        });
        let after = |share: f64, k: [f64; 2]| [0, 1].map(|i| speeds[i] + share * step * k[i]);
        let k1 = slopes_here;
        let k2 = slopes(after(0.5, k1));
        let k3 = slopes(after(0.5, k2));
        let k4 = slopes(after(1.0, k3));
        speeds = [0, 1].map(|i| speeds[i] + step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        slopes_here = slopes(speeds);
    }
    nodes
}

/// Steps of the march over time, in steps of the march over speed.
const TIME_STEP: f64 = 2.0;

impl<'a> FlightTable<'a> {
    /// The same for many flights near each other.
    pub(crate) fn for_many(self) -> BlendedTable<'a> {
        BlendedTable {
            table: self,
            nodes: Vec::new(),
        }
    }

    /// The flight with a launch speed; `None` beyond the table.
    #[inline]
    pub(crate) fn launch(&self, speed: f64) -> Option<Row> {
        let (node, t) = self.around(speed)?;
        let values = [IMPACT, TIME].map(|value| self.by_speed(node, t, |node| node[value]));
        Some(Row::of_launch(speed, values))
    }

    /// The same flight with its apex, in one look-up.
    #[inline]
    pub(crate) fn rise_and_fall(&self, speed: f64) -> Option<RiseAndFall> {
        let (node, t) = self.around(speed)?;
        let ends = [node, node + 1].map(|node| self.blended(node));
        Some(RiseAndFall::between(&ends, t, self.step, speed))
    }

    /// All values at a node.
    #[inline]
    fn blended(&self, node: usize) -> BlendedNode {
        let [a, b, c, d] = self
            .marches
            .map(|march| march.by_speed[node].as_flattened());
        let [wa, wb, wc, wd] = self.blend.weights;
        array::from_fn(|i| wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i])
    }

    /// The flight that lasts a time; takes gravity times the time, m/s.
    #[inline]
    pub(crate) fn lasting(&self, gravity_time: f64) -> Option<Row> {
        let step = TIME_STEP * self.step;
        let steps = gravity_time / step;
        if !(steps > 0.0 && steps + 1.0 < self.times as f64) {
            return None;
        }
        let node = steps as usize;
        let t = steps - node as f64;
        let launch = |node: usize| self.blend(|march| march.by_time[node].launch);
        let impact = |node: usize| self.blend(|march| march.by_time[node].impact);
        let [launch, launch_slope] = hermite(launch(node), launch(node + 1), t, step);
        let [impact, impact_slope] = hermite(impact(node), impact(node + 1), t, step);
        Some(Row {
            launch,
            impact,
            time: gravity_time,
            time_slope: launch / (gravity_time * launch_slope),
            impact_slope: impact_slope * launch / (impact * launch_slope),
        })
    }

    /// Gravity times the height to which a launch with this speed rises, and d ln(height)/d ln(launch).
    #[inline]
    pub(crate) fn apex(&self, launch: f64) -> Option<(f64, f64)> {
        let (node, t) = self.around(launch)?;
        let [free_fall, slope] = self.by_speed(node, t, |node| node[FREE_FALL]);
        let log_slope = 2.0 * slope * launch / free_fall;
        Some((0.5 * free_fall * free_fall, log_slope))
    }

    /// The launch that would rise to a height; takes gravity times the height.
    pub(crate) fn rising_to(&self, gravity_height: f64) -> Option<f64> {
        let free_fall = (2.0 * gravity_height).sqrt();
        let mut speed = free_fall;
        for _ in 0..MAX_STEPS {
            let (node, t) = self.around(speed)?;
            let [here, slope] = self.by_speed(node, t, |node| node[FREE_FALL]);
            let step = (free_fall - here) / slope;
            speed += step;
            if step.abs() <= SMALL_STEP * speed {
                break;
            }
        }
        Some(speed)
    }

    /// The launch whose flight ends with an impact speed.
    pub(crate) fn launch_leading_to(&self, impact: f64) -> Option<f64> {
        let mut speed = impact;
        for _ in 0..MAX_STEPS {
            let row = self.launch(speed)?;
            let step = (impact / row.impact).ln() / row.impact_slope.max(MIN_SLOPE);
            speed *= step.exp();
            if step.abs() <= SMALL_STEP {
                break;
            }
        }
        Some(speed)
    }

    /// The node below a launch speed, and the share of the step above it.
    #[inline]
    fn around(&self, speed: f64) -> Option<(usize, f64)> {
        let steps = speed / self.step;
        let last = self.marches[0].by_speed.len() - 1;
        let node = steps as usize;
        (steps > 0.0 && steps < last as f64).then_some((node, steps - node as f64))
    }

    #[inline]
    fn by_speed(&self, node: usize, t: f64, value: impl Fn(&SpeedNode) -> [f64; 2]) -> [f64; 2] {
        let at = |node: usize| self.blend(|march| value(&march.by_speed[node]));
        hermite(at(node), at(node + 1), t, self.step)
    }

    /// A value with its slope, between the strengths of the marches.
    #[inline]
    fn blend(&self, value: impl Fn(&March) -> [f64; 2]) -> [f64; 2] {
        let [a, b, c, d] = self.marches;
        let [a, b, c, d] = [value(a), value(b), value(c), value(d)];
        let [wa, wb, wc, wd] = self.blend.weights;
        let sum = |i: usize| wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i];
        [sum(0), sum(1)]
    }
}

/// Newton's steps square the relative error, so the one after a step this small would be rounding.
const SMALL_STEP: f64 = 1e-4;
/// Maximum number of Newton's steps.
pub(crate) const MAX_STEPS: usize = 30;
/// Minimum slope of Newton's steps: near the terminal speed the impact speed hardly depends on the launch speed.
pub(crate) const MIN_SLOPE: f64 = 1e-3;

fn speed_node(impact: [f64; 2], [time, height, fall]: [f64; 3], rates: [f64; 3]) -> SpeedNode {
    let free_fall = (2.0 * height).sqrt();
    let free_fall_slope = if height > 0.0 {
        rates[1] / free_fall
    } else {
        1.0
    };
    [
        impact,
        [time, rates[0]],
        [free_fall, free_fall_slope],
        [fall, rates[2]],
    ]
}

/// Value and slope of the cubic through two values with two slopes, at a share t of the step.
#[inline]
fn hermite(low: [f64; 2], high: [f64; 2], t: f64, step: f64) -> [f64; 2] {
    let (rise, a, b) = (high[0] - low[0], step * low[1], step * high[1]);
    let c = 3.0 * rise - 2.0 * a - b;
    let d = a + b - 2.0 * rise;
    [
        low[0] + t * (a + t * (c + t * d)),
        (a + t * (2.0 * c + 3.0 * t * d)) / step,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Options;
    use crate::drag::DragLaw;

    fn model(drag: DragLaw) -> FlightModel {
        let options = Options::default().with_gravity_m_s2(9.81).with_drag(drag);
        options.model().unwrap()
    }

    /// Where drag is so strong that the steps of a march are too long for it, it ends early, and not
    /// the strongest drag first. Seen with flights of 24 s and an unknown drag.
    #[test]
    fn flights_of_absurd_drag_are_refused() {
        let model = model(DragLaw::Standard);
        for fastest_m_s in [12.0, 120.0, 1200.0] {
            let tables = FlightTables::new(DragProfile::new(&model, fastest_m_s, 80).unwrap());
            for strength in (0..300).map(|tenth| 0.1 * f64::from(tenth)) {
                let Some(table) = tables.at(strength) else {
                    continue;
                };
                let times = (1..200).map(|n| 0.01 * f64::from(n) * fastest_m_s);
                // None of them is looked for beyond the end of a march.
                assert!(times.filter_map(|time| table.lasting(time)).count() < 200);
            }
        }
    }

    /// The table against the closed form (constant coefficient) and the quadrature (laws with joints), for drops of a table-tennis ball from 1 cm to 3 m.
    #[test]
    fn tabled_flights_are_those_of_the_model() {
        let measured = "table:100=1.1,1000=0.47,6000=0.39,200000=0.5"
            .parse()
            .unwrap();
        for (drag, accuracy) in [
            (DragLaw::None, 1e-11),
            (DragLaw::Constant(0.4), 2e-8),
            (measured, 5e-6),
            (DragLaw::Standard, 2e-5),
        ] {
            let model = model(drag.clone());
            let tables = FlightTables::new(DragProfile::new(&model, 12.0, 80).unwrap());
            let table = tables.at(1.0).unwrap();
            let mut for_many = table.for_many();
            let gravity = model.gravity_m_s2();
            for launch in [0.4, 1.0, 2.0, 4.0, 7.0] {
                let exact = model.launch(launch).unwrap();
                let row = table.lasting(gravity * exact.time_s()).unwrap();
                let near = |a: f64, b: f64| (a / b - 1.0).abs() < accuracy;
                assert!(
                    near(row.launch, launch),
                    "{drag}: {:e} {launch}",
                    row.launch / launch - 1.0
                );
                assert!(near(row.impact, exact.impact_speed_m_s), "{drag} {launch}");
                let whole = table.rise_and_fall(launch).unwrap();
                assert!(
                    near(whole.gravity_height, gravity * exact.apex_m),
                    "{drag} {launch}"
                );
                assert!(
                    near(whole.fall_time, gravity * exact.fall_time_s),
                    "{drag} {launch}"
                );
                assert!(
                    near(whole.row.impact, exact.impact_speed_m_s),
                    "{drag} {launch}"
                );
                assert_eq!(for_many.rise_and_fall(launch), Some(whole));
                let apex = (whole.gravity_height, whole.height_slope);
                assert_eq!(table.apex(launch), Some(apex), "{drag} {launch}");
                let slopes = model.launch_derivatives(&exact).unwrap();
                let expected = slopes.time * launch / exact.time_s();
                assert!((row.time_slope - expected).abs() < 1e-3, "{drag} {launch}");
                let expected = slopes.impact_speed * launch / exact.impact_speed_m_s;
                assert!(
                    (row.impact_slope - expected).abs() < 1e-3,
                    "{drag} {launch}"
                );
                let back = table.rising_to(gravity * exact.apex_m).unwrap();
                assert!(near(back, launch), "{drag} {launch} {back}");
                let back = table.launch_leading_to(row.impact).unwrap();
                assert!((back / launch - 1.0).abs() < 1e-4, "{drag} {launch} {back}");
            }
        }
    }

    /// A multiple of the drag in the table is the drag of the same multiple of the coefficient, at the nodes
    /// and between them, up to the weakest and the strongest.
    #[test]
    fn a_table_scales_its_drag() {
        let nominal = model(DragLaw::Constant(0.3));
        let tables = FlightTables::new(DragProfile::new(&nominal, 8.0, 80).unwrap());
        for strength in [0.0, 0.003, 0.02, 0.2, 0.77, 1.0, 1.013, 2.0] {
            let table = tables.at(strength).unwrap();
            let scaled = model(DragLaw::Constant(0.3 * strength));
            for launch in [0.5, 3.0, 6.0] {
                let exact = scaled.launch(launch).unwrap();
                let gravity_time = scaled.gravity_m_s2() * exact.time_s();
                let far = [
                    table.launch(launch).unwrap().impact / exact.impact_speed_m_s,
                    table.launch(launch).unwrap().time / gravity_time,
                    table.lasting(gravity_time).unwrap().launch / launch,
                    table.lasting(gravity_time).unwrap().impact / exact.impact_speed_m_s,
                ]
                .map(|ratio| (ratio - 1.0).abs())
                .into_iter()
                .fold(0.0, f64::max);
                assert!(far < 1e-6, "{strength} {launch}: {far:e}");
            }
        }
    }

    #[test]
    fn what_lies_beyond_the_table_is_not_made_up() {
        let drag = model(DragLaw::Constant(0.4));
        let tables = FlightTables::new(DragProfile::new(&drag, 5.0, 80).unwrap());
        let table = tables.at(1.0).unwrap();
        assert!(table.launch(5.1).is_none());
        assert!(table.lasting(20.0).is_none());
        assert!(table.rising_to(30.0).is_none());
        assert!(table.launch(f64::NAN).is_none());
        for strength in [-0.1, 40.0, f64::INFINITY, f64::NAN] {
            assert!(tables.at(strength).is_none(), "{strength}");
        }
    }
}
