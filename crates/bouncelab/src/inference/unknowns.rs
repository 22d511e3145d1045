//! The unknowns of a drop, their priors, and the index of each in a vector.

use nalgebra::DMatrix;
use rand::RngExt;

use super::medium::Medium;
use super::observed::Observed;
use super::parameters::{
    MANY_FLIGHTS, MAX_START_NORMAL, MIN_KEPT, NEWTON_TOLERANCE, START_RESTITUTIONS,
    UNSTATED_TIMING_SD,
};
use super::priors::{Measured, Priors};
use super::reference_speed::ReferenceSpeed;
use super::scatter_prior::ScatterPrior;
use super::timed_flights::TimedFlights;
use crate::flight::table::MAX_STEPS;
use crate::restitution::{LawKind, MAX_SHAPES, PriorOver, Restitution};
use crate::simd::Lanes;

/// One physical explanation of a drop: which restitution law, which ball, and how many impacts
/// went before the first one detected.
#[derive(Debug, Clone)]
pub(super) struct Model<'a> {
    pub(super) observed: &'a Observed,
    pub(super) timed_flights: &'a TimedFlights,
    pub(super) law: LawKind,
    pub(super) missed_first: usize,
    pub(super) medium: &'a Medium,
    pub(super) reference: &'a ReferenceSpeed,
    pub(super) height_m: Option<Measured>,
    pub(super) release_s: Option<Measured>,
    pub(super) timing_sd: f64,
    pub(super) scatter: ScatterPrior,
    /// The stated prior of the restitution; if `None`, the usual one of the law.
    stated: Option<PriorOver>,
    slots: Vec<Slot>,
    /// Origin of the coordinate of the restitution, which is then in units of the noise; if `None`, the coordinate is the
    /// logit.
    expected_restitution: Option<ExpectedRestitution>,
}

/// The restitution that is expected given the unknowns that impacts hardly determine: its logit is linear in them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ExpectedRestitution {
    /// The logit where all of them are zero.
    pub(super) logit: f64,
    /// Its derivative by each of them.
    pub(super) slopes: [f64; ExpectedRestitution::BY.len()],
}

impl ExpectedRestitution {
    /// The unknowns that impacts hardly determine.
    pub(super) const BY: [Slot; 4] = [Slot::Drag, Slot::Gravity, Slot::Inputs, Slot::Contact];
}

/// An unknown, which has an index in the vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Slot {
    /// ln of the drag scale, a standard normal before the data.
    Drag,
    /// ln of effective gravity, a standard normal before the data.
    Gravity,
    /// ln of drag over weight without its coefficient, given gravity; a standard normal before the data.
    Inputs,
    /// logit e*, or its distance from the expected one in units of the noise.
    Restitution,
    /// A number of the law besides e*, a standard normal before the data.
    Shape(usize),
    /// The drop height, with the coordinate that [`Height`] states.
    Height,
    /// ln of the scatter, as a function of a standard normal ([`ScatterPrior`]).
    Scatter,
    /// ln of the factor on the errors of the times, a standard normal before the data.
    Timing,
    /// ln of the contact time, a standard normal before the data.
    Contact,
}

/// The coordinate of the drop height. Each is chosen so that the posterior is nearly normal: the correlations of the height
/// itself with the other unknowns are curved where it is known well or few impacts were detected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Height {
    /// Deviation from the measured height in its standard uncertainties.
    Measured(Measured),
    /// Deviation of ln(launch speed of the fall) from the value that first flight and law predict, in units of the noise
    /// between the two.
    FromFirstFlight,
    /// ln of the launch speed with which the ball would rise to it.
    Speed,
}

/// Values of the unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) law: Restitution,
    /// Factor on the drag coefficient of the law.
    pub(super) drag_scale: f64,
    /// Factor on drag over weight: the coefficient and everything else.
    pub(super) drag_strength: f64,
    /// Effective gravity.
    pub(super) gravity_m_s2: f64,
    /// Launch speed of the flight whose second half is the fall from the drop height.
    pub(super) fall_launch_m_s: f64,
    /// Logarithm of the prior density of the coordinate of the restitution, and of the unit of the coordinate of the height.
    pub(super) log_density: f64,
    /// Standard deviation of ln e.
    pub(super) scatter: f64,
    /// Factor on the standard errors of the times.
    pub(super) timing: f64,
    pub(super) contact_time_s: f64,
}

impl Point {
    /// The impact speed that the law turns into a launch speed: the root of ln v + ln e(v) = ln(launch) by Newton's method
    /// in ln v, whose derivative is 1 + d ln e/d ln v.
    pub(super) fn impact_before(&self, launch: f64) -> Option<f64> {
        let mut impact = launch / self.law.at(launch);
        for _ in 0..MAX_STEPS {
            let (restitution, log_slope) = self.law.at_with_log_slope(impact);
            let step = (launch / (impact * restitution)).ln() / (1.0 + log_slope).max(MIN_KEPT);
            impact *= step.exp();
            if step.abs() < NEWTON_TOLERANCE {
                break;
            }
        }
        impact.is_finite().then_some(impact)
    }
}

impl<'a> Model<'a> {
    pub(super) fn new(
        observed: &'a Observed,
        timed_flights: &'a TimedFlights,
        medium: &'a Medium,
        reference: &'a ReferenceSpeed,
        law: LawKind,
        missed_first: usize,
        priors: &Priors,
    ) -> Self {
        let timing_sd = if observed.sigma_stated {
            priors.timing_rel_sd
        } else {
            UNSTATED_TIMING_SD
        };
        let inputs = &medium.inputs;
        let stated = priors
            .restitution
            .as_ref()
            .map(|prior| prior.over(&reference.speeds));
        let shapes = stated.as_ref().map_or(law.shapes(), |_| PriorOver::SHAPES);
        let shapes = (0..shapes).map(|number| (Slot::Shape(number), true));
        let before = [
            (Slot::Drag, medium.drag_sd > 0.0),
            (Slot::Gravity, inputs.gravity_sd > 0.0),
            (Slot::Inputs, inputs.drag_sd > 0.0),
            (Slot::Restitution, true),
        ];
        let after = [
            (Slot::Height, true),
            (Slot::Scatter, true),
            (Slot::Timing, timing_sd > 0.0),
            (
                Slot::Contact,
                medium.contact_time_s * medium.contact_sd > 0.0,
            ),
        ];
        let slots = before
            .into_iter()
            .chain(shapes)
            .chain(after)
            .filter_map(|(slot, wanted)| wanted.then_some(slot))
            .collect();
        Self {
            observed,
            timed_flights,
            law,
            missed_first,
            medium,
            reference,
            height_m: priors.drop_height_m,
            release_s: priors.release_s,
            timing_sd,
            scatter: priors.scatter(),
            stated,
            slots,
            expected_restitution: None,
        }
    }

    /// The same with a coordinate of the restitution that is its deviation from the expected one, if that is given, in units
    /// of the noise. Few impacts hardly determine the noise, and the width of the posterior of the restitution grows with the
    /// noise: a funnel, which a normal proposal covers badly. In units of the noise the width is the same everywhere.
    pub(super) fn with_expected_restitution(self, expected: Option<ExpectedRestitution>) -> Self {
        Self {
            expected_restitution: expected,
            ..self
        }
    }

    /// The unknowns, in the order of the vector.
    pub(super) fn slots(&self) -> &[Slot] {
        &self.slots
    }

    /// The index of an unknown in the vector.
    pub(super) fn index(&self, slot: Slot) -> Option<usize> {
        self.slots.iter().position(|&s| s == slot)
    }

    /// The indices in the vector of the unknowns that are reported; the others are nuisance parameters.
    pub(super) fn answered(&self) -> Vec<usize> {
        let slots = self.slots.iter().enumerate();
        slots
            .filter(|(_, slot)| {
                matches!(
                    slot,
                    Slot::Restitution | Slot::Shape(_) | Slot::Height | Slot::Drag
                )
            })
            .map(|(index, _)| index)
            .collect()
    }

    /// The coordinate of the height.
    pub(super) fn height(&self) -> Height {
        match self.height_m {
            Some(measured) => Height::Measured(measured),
            None if self.missed_first == 0 => Height::FromFirstFlight,
            None => Height::Speed,
        }
    }

    /// Information about an unknown from its prior alone: minus the second derivative of the log density.
    pub(super) fn prior_information(&self, slot: Slot, point: &Point) -> f64 {
        match slot {
            // Flat in e: the density of the logit x is e (1 - e), and -d² ln(e (1 - e))/dx² = 2 e (1 - e).
            Slot::Restitution => {
                let (scatter, timing) = (Lanes([point.scatter]), Lanes([point.timing]));
                let [unit] = self.restitution_unit(scatter, timing).0;
                let e = point.law.at(self.reference.speeds.reference_m_s);
                // Of a normal ln e, whose density in x is N(ln e) (1 - e): (1 - e)²/sd² + e (1 - e), expected.
                let of_logit = self.stated.as_ref().map_or(2.0 * e * (1.0 - e), |prior| {
                    ((1.0 - e) / prior.sd).powi(2) + e * (1.0 - e)
                });
                of_logit * unit * unit
            }
            Slot::Height if self.height_m.is_none() => 0.0,
            _ => 1.0,
        }
    }

    /// The values of the unknowns at vectors, without the fall, which needs the flights; `None` where the law has no such
    /// numbers.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) fn values<const L: usize>(&self, vectors: &[&[f64]; L]) -> [Option<Point>; L] {
        let mut values = [Lanes::<L>::all(0.0); Slot::WITHOUT_SHAPES + MAX_SHAPES];
        for (index, slot) in self.slots.iter().enumerate() {
            values[slot.position()] = Lanes::of(|lane| vectors[lane][index]);
        }
        let at = |slot: Slot| values[slot.position()];
        let (medium, inputs) = (self.medium, &self.medium.inputs);
        // Each factor is exp(sd z) with its standard normal z. Gravity and inputs share the two rows of their triangular root.
        let drag_scale = (at(Slot::Drag) * medium.drag_sd).exp();
        let log_inputs =
            at(Slot::Gravity) * inputs.drag_on_gravity + at(Slot::Inputs) * inputs.drag_sd;
        let drag_strength = drag_scale * log_inputs.exp();
        let gravity_m_s2 = (at(Slot::Gravity) * inputs.gravity_sd).exp() * medium.gravity_m_s2;
        let scatter = self.scatter.scatters(at(Slot::Scatter));
        let timing = (at(Slot::Timing) * self.timing_sd).exp();
        let unit = self.restitution_unit(scatter, timing);
        let expected = self.expected_restitution.map_or(Lanes::all(0.0), |it| {
            let by = ExpectedRestitution::BY.into_iter().zip(it.slopes);
            by.fold(Lanes::all(it.logit), |sum, (slot, slope)| {
                sum + at(slot) * slope
            })
        });
        let logit = at(Slot::Restitution) * unit + expected;
        let restitution = Lanes::all(1.0) / ((-logit).exp() + 1.0);
        let log_density = match &self.stated {
            // Flat in e: de/d(logit) = e (1 - e) = exp(-|x|)/(1 + exp(-|x|))², times the unit of the coordinate.
            None => {
                let off = -logit.abs();
                off - (off.exp() + 1.0).ln() * 2.0 + unit.ln()
            }
            // d ln e/d(logit) = 1 - e, with ln(1 - e) = ln e - x.
            Some(prior) => {
                let ln_e = restitution.ln();
                prior.log_density(ln_e) + (ln_e - logit) + unit.ln()
            }
        };
        let contact_time_s = (at(Slot::Contact) * medium.contact_sd).exp() * medium.contact_time_s;
        let (law, speeds) = (self.law, &self.reference.speeds);
        std::array::from_fn(|lane| {
            let shapes = std::array::from_fn(|number| at(Slot::Shape(number)).0[lane]);
            Some(Point {
                law: match &self.stated {
                    None => law.of_normals(restitution.0[lane], shapes, speeds),
                    Some(prior) => prior.law(restitution.0[lane], shapes),
                }
                .ok()?,
                drag_scale: drag_scale.0[lane],
                drag_strength: drag_strength.0[lane],
                gravity_m_s2: gravity_m_s2.0[lane],
                fall_launch_m_s: f64::NAN,
                log_density: log_density.0[lane],
                scatter: scatter.0[lane],
                timing: timing.0[lane],
                contact_time_s: contact_time_s.0[lane],
            })
        })
    }

    /// Change of the logit for one unit of the coordinate of the restitution.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn restitution_unit<const L: usize>(&self, scatter: Lanes<L>, timing: Lanes<L>) -> Lanes<L> {
        if self.expected_restitution.is_none() {
            return Lanes::all(1.0);
        }
        self.noise(self.observed.intervals.len() / 2, scatter, timing)
    }

    /// Approximate standard deviation of ln(launch speed) after an impact, given the speed before it: that of the scatter, and
    /// that of the duration of the flight after it, to which the launch speed is nearly proportional.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) fn noise<const L: usize>(
        &self,
        impact: usize,
        scatter: Lanes<L>,
        timing: Lanes<L>,
    ) -> Lanes<L> {
        let observed = self.observed;
        let square = |x: f64| x * x;
        let sigma_s = square(observed.sigma_s[impact]) + square(observed.sigma_s[impact + 1]);
        let per_duration = sigma_s / square(observed.intervals[impact].duration_s);
        (scatter * scatter + timing * timing * per_duration).sqrt()
    }

    /// logit e*, drawn from its prior.
    pub(super) fn draw_logit(&self, random: &mut impl RngExt) -> f64 {
        let restitution = match &self.stated {
            None => random.random(),
            Some(prior) => prior.draw_restitution(random),
        };
        (restitution / (1.0 - restitution)).ln()
    }

    /// Mean and standard deviation of ln e* before the data, but for its bound at zero; `None` if e* is flat.
    pub(super) fn stated_level(&self) -> Option<[f64; 2]> {
        self.stated.as_ref().map(|prior| [prior.mean, prior.sd])
    }

    /// Whether the first number of the law besides e* is a slope.
    pub(super) fn has_slope(&self) -> bool {
        self.stated.is_none() && self.law.has_slope()
    }

    /// Start of a search: the differences between impacts are all scatter, or all errors of the times, whichever is more
    /// probable.
    pub(super) fn start(&self) -> Vec<f64> {
        let scatter = self.reference.scatter;
        let scatter = scatter.map_or(0.0, |scatter| self.scatter.normal(scatter));
        let timing = self
            .reference
            .timing
            .map_or(0.0, |timing| timing.ln().max(0.0) / self.timing_sd);
        let starts = [(scatter, 0.0), (0.0, timing)];
        self.most_probable(
            starts
                .map(|(scatter, timing)| self.start_with(scatter, timing))
                .into(),
        )
    }

    /// The most probable of some vectors, the first of equals; one without a posterior is less probable than any.
    pub(super) fn most_probable(&self, vectors: Vec<Vec<f64>>) -> Vec<f64> {
        let tried = DMatrix::from_fn(self.slots.len(), vectors.len(), |index, number| {
            vectors[number][index]
        });
        let logs = self.log_posteriors(&tried).into_iter().zip(vectors);
        let best = logs.reduce(|best, other| if other.0 > best.0 { other } else { best });
        best.map(|(_, vector)| vector).unwrap_or_default()
    }

    /// The start with these standard normals of scatter and timing.
    fn start_with(&self, scatter: f64, timing: f64) -> Vec<f64> {
        let e = self
            .reference
            .restitution
            .clamp(START_RESTITUTIONS[0], START_RESTITUTIONS[1]);
        // With one more missed impact the fall was faster by a factor 1/e.
        let first = self.reference.first_launch_m_s / e.powf(self.missed_first as f64 + 1.0);
        let height = match self.height() {
            Height::Measured(_) | Height::FromFirstFlight => 0.0,
            Height::Speed => first.ln(),
        };
        self.slots
            .iter()
            .map(|slot| match slot {
                Slot::Restitution => (e / (1.0 - e)).ln(),
                Slot::Height => height,
                Slot::Shape(number) => self.law.start(*number),
                Slot::Scatter => scatter.clamp(-MAX_START_NORMAL, MAX_START_NORMAL),
                Slot::Timing => timing.clamp(-MAX_START_NORMAL, MAX_START_NORMAL),
                _ => 0.0,
            })
            .collect()
    }

    /// Start of a search after another model of the same drop has been fitted: a law with the same restitution and slope at
    /// v*, and the same other unknowns. The nearer the fit, the fewer steps.
    pub(super) fn start_from(&self, fitted: &Self, fit: &[f64]) -> Vec<f64> {
        let same_law = self.law == fitted.law;
        let point = fitted.point(fit).filter(|_| !same_law);
        let log_slope = point.map(|point| point.law.log_slope(self.reference.speeds.reference_m_s));
        let many_flights = self.observed.intervals.len() >= MANY_FLIGHTS;
        let from_fit = |slot: &Slot| match slot {
            Slot::Shape(0) if !same_law => {
                self.law
                    .normal_of_slope(log_slope?, &self.reference.speeds, many_flights)
            }
            Slot::Shape(_) if !same_law => None,
            Slot::Height if self.missed_first != fitted.missed_first => None,
            _ => fitted.index(*slot).map(|index| fit[index]),
        };
        let usual = self.slots.iter().zip(self.start_with(0.0, 0.0));
        usual
            .map(|(slot, usual)| from_fit(slot).unwrap_or(usual))
            .collect()
    }

    /// Logarithm of the prior density of vectors, but for a constant and for [`Point::log_density`], given
    /// d ln(height)/d ln(launch) of their falls.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) fn log_prior<const L: usize>(
        &self,
        vectors: &[&[f64]; L],
        height_slope: Lanes<L>,
    ) -> Lanes<L> {
        let mut sum = Lanes::all(0.0);
        for (index, slot) in self.slots.iter().enumerate() {
            let value = Lanes::of(|lane| vectors[lane][index]);
            let log = match slot {
                // In Point::log_density, since it depends on the noise too.
                Slot::Restitution => Lanes::all(0.0),
                // Flat in ln h: the density of ln(launch) is d ln h/d ln(launch).
                Slot::Height if self.height_m.is_none() => height_slope.ln(),
                _ => value * value * -0.5,
            };
            sum = sum + log;
        }
        sum
    }
}

impl Slot {
    /// Number of unknowns without those of the law.
    const WITHOUT_SHAPES: usize = 8;

    /// Its position among all unknowns that a model may have.
    fn position(self) -> usize {
        match self {
            Self::Restitution => 0,
            Self::Height => 1,
            Self::Drag => 2,
            Self::Scatter => 3,
            Self::Timing => 4,
            Self::Contact => 5,
            Self::Gravity => 6,
            Self::Inputs => 7,
            Self::Shape(number) => Self::WITHOUT_SHAPES + number,
        }
    }
}
