//! Many flights of one ball at once, for the inference.
//!
//! The inference asks for the same few flights under thousands of slightly different drags, and a
//! quadrature for each would take seconds. Here all flights of a ball up to a greatest launch speed
//! are solved by one march over the launch speed v. With η drag over weight and v' the impact
//! speed, energy gives
//!
//! dv'/dv = (v/v') (1 - η(v'))/(1 + η(v)),  d(gT)/dv = (1 + v/v')/(1 + η(v)),  d(gh)/dv = v/(1 + η(v)),
//!
//! which are smooth, have no end at the terminal speed and know no gravity. Between the nodes the
//! cubics with the right slopes are good to 1e-8, far below any noise; the tests hold them against
//! [`FlightModel`](super::FlightModel).

use super::FlightModel;
use crate::error::Result;

/// Nodes of the drag profile: it is read between the nodes of the march too.
const PROFILE: usize = 1024;

/// Drag over weight of a ball, for speeds from zero to a greatest.
#[derive(Debug, Clone)]
pub(crate) struct DragProfile {
    /// Drag over weight over speed, s/m, at equal steps of speed: nearly straight for every law.
    per_speed: Vec<f64>,
    step: f64,
    /// Steps of the march over the launch speed.
    march: usize,
}

impl DragProfile {
    /// The drag of a model up to a speed, for tables of so many steps; beyond the range of its law drag keeps the coefficient it
    /// has there.
    pub(crate) fn new(model: &FlightModel, greatest_speed_m_s: f64, march: usize) -> Result<Self> {
        let step = greatest_speed_m_s / PROFILE as f64;
        let mut per_speed = Vec::with_capacity(PROFILE + 2);
        // At rest the ratio is that of creeping flow, which the first speed of all comes close to.
        per_speed.push(model.drag_over_weight(step * 1e-6)? / (step * 1e-6));
        for node in 1..PROFILE + 2 {
            let speed = step * node as f64;
            let value = match model.drag_over_weight(speed) {
                Ok(share) => share / speed,
                Err(error) if node == 1 => return Err(error),
                Err(_) => per_speed[node - 1] * node as f64 / (node as f64 - 1.0).max(1.0),
            };
            per_speed.push(value);
        }
        Ok(Self {
            per_speed,
            step,
            march,
        })
    }

    /// The fastest launch that a table over this profile knows, m/s.
    fn fastest(&self) -> f64 {
        self.step * PROFILE as f64
    }

    #[inline]
    fn over_weight(&self, speed: f64) -> f64 {
        let place = (speed / self.step).clamp(0.0, PROFILE as f64);
        let node = place as usize;
        let share = place - node as f64;
        let (low, high) = (self.per_speed[node], self.per_speed[node + 1]);
        speed * (low + share * (high - low))
    }
}

/// What there is at a launch speed, with gravity taken out: multiply or divide by it.
#[derive(Debug, Clone, Copy, Default)]
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

/// Every flight of a ball, for one strength of drag.
#[derive(Debug, Clone)]
pub(crate) struct FlightTable {
    nodes: Vec<Node>,
    step: f64,
}

/// Values and slopes by the launch speed at a node, all free of gravity.
#[derive(Debug, Clone, Copy, Default)]
struct Node {
    /// Impact speed.
    impact: [f64; 2],
    /// g T.
    time: [f64; 2],
    /// (2 g h)^1/2, which is nearly straight where the height is not.
    free_fall: [f64; 2],
    /// g times the fall time.
    fall: [f64; 2],
}

impl FlightTable {
    /// An empty table, to be filled by [`FlightTable::fill`].
    pub(crate) fn new() -> Self {
        Self {
            nodes: Vec::new(),
            step: 0.0,
        }
    }

    /// Solves all flights with so many times the drag of a profile.
    pub(crate) fn fill(&mut self, profile: &DragProfile, drag_scale: f64) {
        self.step = profile.fastest() / profile.march as f64;
        let step = self.step;
        let over_weight = |speed: f64| drag_scale * profile.over_weight(speed);
        // One division each: this march is most of the time of an inference.
        let slope = |slowing: f64, v: f64, impact: f64| {
            v * (1.0 - over_weight(impact)) / (impact * slowing)
        };
        // Time, g h and fall time.
        let rates = |slowing: f64, v: f64, impact: f64| {
            let per_impact = 1.0 / (slowing * impact);
            let fall = v * per_impact;
            let per_slowing = impact * per_impact;
            [per_slowing + fall, v * per_slowing, fall]
        };
        self.nodes.clear();
        let (mut impact, mut slope_here) = (0.0, 1.0);
        let mut sums = [0.0; 3];
        // At rest the impact speed is the launch speed.
        let mut rates_here = [2.0, 0.0, 1.0];
        self.nodes.push(Node::of([0.0, 1.0], sums, rates_here));
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
            self.nodes
                .push(Node::of([next, slope_end], sums, rates_end));
            (impact, slope_here) = (next, slope_end);
            rates_here = rates_end;
        }
    }

    /// The flight with a launch speed; `None` beyond the table.
    #[inline]
    pub(crate) fn launch(&self, speed: f64) -> Option<Row> {
        let (low, high, t) = self.around(speed)?;
        let [impact, impact_slope] = hermite(low.impact, high.impact, t, self.step);
        let [time, time_slope] = hermite(low.time, high.time, t, self.step);
        Some(Row {
            launch: speed,
            impact,
            time,
            time_slope: time_slope * speed / time,
            impact_slope: impact_slope * speed / impact,
        })
    }

    /// The flight that lasts a time; takes gravity times the time, m/s.
    #[inline]
    pub(crate) fn lasting(&self, gravity_time: f64) -> Option<Row> {
        // Time grows ever slower with the launch speed, so steps from below stay below.
        let mut speed = 0.5 * gravity_time;
        for _ in 0..MAX_STEPS {
            let (low, high, t) = self.around(speed)?;
            let [time, slope] = hermite(low.time, high.time, t, self.step);
            let step = (gravity_time - time) / slope;
            speed += step;
            if step.abs() <= SMALL_STEP * speed {
                break;
            }
        }
        self.launch(speed)
    }

    /// Gravity times height and gravity times fall time of the fall that a launch with this speed
    /// would begin, and d ln(height)/d ln(launch).
    pub(crate) fn fall(&self, launch: f64) -> Option<(f64, f64, f64)> {
        let (low, high, t) = self.around(launch)?;
        let [free_fall, slope] = hermite(low.free_fall, high.free_fall, t, self.step);
        let [fall, _] = hermite(low.fall, high.fall, t, self.step);
        let log_slope = 2.0 * slope * launch / free_fall;
        Some((0.5 * free_fall * free_fall, fall, log_slope))
    }

    /// The launch that would rise to a height; takes gravity times the height.
    pub(crate) fn rising_to(&self, gravity_height: f64) -> Option<f64> {
        let mut speed = (2.0 * gravity_height).sqrt();
        for _ in 0..MAX_STEPS {
            let (height, _, log_slope) = self.fall(speed)?;
            let step = (gravity_height / height).ln() / log_slope;
            speed *= step.exp();
            if step.abs() <= SMALL_STEP {
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
            let step = (impact / row.impact).ln() / row.impact_slope.max(LEAST_SLOPE);
            speed *= step.exp();
            if step.abs() <= SMALL_STEP {
                break;
            }
        }
        Some(speed)
    }

    #[inline]
    fn around(&self, speed: f64) -> Option<(&Node, &Node, f64)> {
        let place = speed / self.step;
        if !(place > 0.0 && place + 1.0 < self.nodes.len() as f64) {
            return None;
        }
        let node = place as usize;
        Some((
            &self.nodes[node],
            &self.nodes[node + 1],
            place - node as f64,
        ))
    }
}

/// Steps square the relative error, so after one this small nothing is left to gain.
const SMALL_STEP: f64 = 1e-6;
const MAX_STEPS: usize = 30;
/// Near the terminal speed the impact speed hardly answers to the launch speed.
const LEAST_SLOPE: f64 = 1e-3;

impl Node {
    fn of(impact: [f64; 2], [time, height, fall]: [f64; 3], rates: [f64; 3]) -> Self {
        let free_fall = (2.0 * height).sqrt();
        let free_fall_slope = if height > 0.0 {
            rates[1] / free_fall
        } else {
            1.0
        };
        Self {
            impact,
            time: [time, rates[0]],
            free_fall: [free_fall, free_fall_slope],
            fall: [fall, rates[2]],
        }
    }
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
    use crate::air::{Air, Conditions};
    use crate::ball;
    use crate::drag::DragLaw;
    use crate::flight::Environment;

    fn model(drag: DragLaw) -> FlightModel {
        let environment = Environment {
            gravity_m_s2: 9.81,
            air: Air::moist(&Conditions::default()).unwrap(),
            drag,
            buoyancy: true,
            added_mass: true,
        };
        FlightModel::new(&ball::preset("table-tennis-40").unwrap().ball, &environment).unwrap()
    }

    /// The table against the closed form (constant coefficient) and the quadrature (named laws,
    /// which have joints), for drops of a table-tennis ball from 1 cm to 3 m.
    #[test]
    fn tabled_flights_are_those_of_the_model() {
        for (drag, accuracy) in [
            (DragLaw::None, 1e-11),
            (DragLaw::Constant(0.4), 2e-8),
            (DragLaw::Morrison, 1e-6),
            (DragLaw::CliftGraceWeber, 2e-5),
        ] {
            let model = model(drag);
            let profile = DragProfile::new(&model, 12.0, 80).unwrap();
            let mut table = FlightTable::new();
            table.fill(&profile, 1.0);
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
                let (height, fall, _) = table.fall(launch).unwrap();
                assert!(near(height, gravity * exact.apex_m), "{drag} {launch}");
                assert!(near(fall, gravity * exact.fall_time_s), "{drag} {launch}");
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

    /// Twice the drag in the table is the drag of twice the coefficient.
    #[test]
    fn a_table_scales_its_drag() {
        let profile = DragProfile::new(&model(DragLaw::Constant(0.3)), 8.0, 80).unwrap();
        let mut table = FlightTable::new();
        table.fill(&profile, 2.0);
        let exact = model(DragLaw::Constant(0.6)).launch(3.0).unwrap();
        let row = table.launch(3.0).unwrap();
        assert!((row.impact / exact.impact_speed_m_s - 1.0).abs() < 1e-7);
    }

    #[test]
    fn what_lies_beyond_the_table_is_not_made_up() {
        let profile = DragProfile::new(&model(DragLaw::Constant(0.4)), 5.0, 80).unwrap();
        let mut table = FlightTable::new();
        table.fill(&profile, 1.0);
        assert!(table.launch(5.1).is_none());
        assert!(table.lasting(20.0).is_none());
        assert!(table.rising_to(30.0).is_none());
        assert!(table.launch(f64::NAN).is_none());
    }
}
