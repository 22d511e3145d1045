//! Every unknown of each draw, with the prior, the likelihood and replicated data, for programs that compare models.

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;
use rand_distr::{Distribution, StandardNormal};

use super::candidates::SampledPosterior;
use super::posterior::Posterior;
use super::tail;
use super::unknowns::{Model, Point, Slot};
use crate::simd::{LANES, one_for_each_lane};

/// A quantity of each draw: one number, or several along an axis.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Variable {
    /// Its name.
    pub name: &'static str,
    /// Its unit; empty for a ratio.
    pub unit: &'static str,
    /// What its numbers of a draw belong to; `None` if there is one.
    pub along: Option<Axis>,
    /// The numbers, draw after draw; not a number where a draw has none, such as of an impact that it leaves out.
    pub values: Vec<f64>,
}

/// What several numbers of a draw belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Axis {
    /// The impacts detected.
    Impact,
    /// The impacts detected but the last, each with the time until the next.
    Interval,
    /// [`DrawnUnknowns::speeds_m_s`].
    Speed,
}

/// Every unknown of each draw, as [`Posterior::drawn_unknowns`] gives them.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct DrawnUnknowns {
    /// Numbers of the impacts detected.
    pub impacts: Vec<usize>,
    /// Times from each of them to the next, s.
    pub intervals_s: Vec<f64>,
    /// Impact speeds at which the law is stated, m/s: the slowest, one in the middle, the fastest, and those halfway in ln v.
    /// The smooth law is determined by its restitution and slopes there.
    pub speeds_m_s: [f64; 5],
    /// The posterior.
    pub posterior: Vec<Variable>,
    /// As many draws of what has a proper prior, without the data.
    pub prior: Vec<Variable>,
    /// Logarithm of the density of each interval given those before it, in 1/s.
    pub log_likelihood: Variable,
    /// Intervals as they would be measured again, s.
    pub replicated: Variable,
    /// Which kind of ball, how many impacts went before the first detected, and whether that is left out as another sound.
    pub sample: Vec<Variable>,
}

impl Posterior {
    /// Every unknown of each draw, in the order of [`Posterior::draws`](Self::draws), with draws of the prior, the
    /// likelihood of each interval, and replicated intervals; `None` if a draw cannot be worked out again.
    ///
    /// ```
    /// use bouncelab::inference::SamplerConfig;
    /// use bouncelab::{Options, analyze_times};
    ///
    /// let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984];
    /// let options = Options::default().with_sampler(SamplerConfig { draws: 300, seed: 1 });
    /// let posterior = analyze_times(&times_s, &options).drops.remove(0).posterior?;
    /// let drawn = posterior.drawn_unknowns(1).unwrap();
    /// assert_eq!(drawn.log_likelihood.values.len(), 9 * posterior.draws.restitution.len());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    #[expect(
        clippy::too_many_lines,
        reason = "one variable after the other, all of the same draws"
    )]
    pub fn drawn_unknowns(&self, seed: u64) -> Option<DrawnUnknowns> {
        let sampled = &self.sampled;
        let longest = sampled.numberings.iter().map(|it| &it.observed);
        let whole = longest.max_by_key(|observed| observed.impacts.len())?;
        let impacts = whole.impacts.len();
        let points = sampled.each(1, |_, point| Some(*point));
        let drops = sampled.drops(&points, 1);
        if points.len() != sampled.draws.len() || drops.len() != points.len() {
            return None;
        }
        let speeds = &sampled.reference.speeds;
        let ends = [speeds.slowest_m_s, speeds.reference_m_s, speeds.fastest_m_s];
        let [slow, middle, fast] = ends;
        let speeds_m_s = [
            slow,
            (slow * middle).sqrt(),
            middle,
            (middle * fast).sqrt(),
            fast,
        ];
        let candidates = || {
            sampled
                .draws
                .iter()
                .map(|draw| &sampled.candidates[draw.candidate])
        };
        let media = candidates().map(|it| it.medium);
        let drawn: Vec<(usize, Point)> = media.zip(points.iter().copied()).collect();
        let mut posterior = vec![number(
            "drop_height_m",
            "m",
            self.draws.drop_height_m.clone(),
        )];
        posterior.extend(of_points(sampled, &drawn, &speeds_m_s));
        let speeds = drops.iter().map(|drop| drop.state.impact_speeds.clone());
        posterior.push(padded(
            "impact_speed_m_s",
            "m/s",
            Axis::Impact,
            impacts,
            speeds,
        ));
        let kept = drops.iter().map(|drop| {
            let launched = drop.state.launch_speeds.iter();
            let pairs = launched.zip(&drop.state.impact_speeds);
            pairs.map(|(launch, impact)| launch / impact).collect()
        });
        posterior.push(padded(
            "impact_restitution",
            "",
            Axis::Interval,
            impacts - 1,
            kept,
        ));
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        let (mut log_likelihood, mut replicated) = (Vec::new(), Vec::new());
        let models = sampled.models();
        let all: Vec<(usize, Point)> = sampled
            .draws
            .iter()
            .map(|draw| draw.candidate)
            .zip(points.iter().copied())
            .collect();
        for alike in all.chunk_by(|(one, _), (other, _)| one == other) {
            let model = &models[alike[0].0];
            // The density of an interval before the first impact of the drop is that of another sound.
            let other = model
                .observed
                .other_sound
                .map(|_| model.observed.ln_other_sound());
            for group in alike.chunks(LANES) {
                let lanes = one_for_each_lane::<_, LANES>(group).map(|(_, point)| point);
                let densities = model.log_densities(&lanes)?;
                for (lane, (_, point)) in group.iter().enumerate() {
                    log_likelihood.extend(other);
                    log_likelihood.extend(densities.iter().map(|density| density.0[lane]));
                    replicated.push(replicated_intervals(model, point, &mut random));
                }
            }
        }
        let flag = |it: bool| if it { 1.0 } else { 0.0 };
        Some(DrawnUnknowns {
            impacts: whole.impacts.iter().map(|impact| impact.number).collect(),
            intervals_s: whole.intervals.iter().map(|it| it.duration_s).collect(),
            speeds_m_s,
            posterior,
            prior: prior(sampled, &speeds_m_s, points.len(), &mut random),
            log_likelihood: Variable {
                name: "interval_s",
                unit: "",
                along: Some(Axis::Interval),
                values: log_likelihood,
            },
            replicated: padded("interval_s", "s", Axis::Interval, impacts - 1, replicated),
            sample: vec![
                number(
                    "ball",
                    "",
                    candidates().map(|it| it.medium as f64).collect(),
                ),
                number(
                    "missed_first_impacts",
                    "",
                    candidates().map(|it| it.missed_first as f64).collect(),
                ),
                number(
                    "first_is_other_sound",
                    "",
                    drops.iter().map(|drop| flag(drop.without_first)).collect(),
                ),
            ],
        })
    }

    /// The kinds of ball by the number that [`DrawnUnknowns::sample`] has; an empty name is the stated one.
    pub fn possible_kinds(&self) -> Vec<&'static str> {
        self.sampled
            .media
            .iter()
            .map(|medium| medium.kind)
            .collect()
    }
}

fn number(name: &'static str, unit: &'static str, values: Vec<f64>) -> Variable {
    Variable {
        name,
        unit,
        along: None,
        values,
    }
}

/// Numbers along an axis, of which a draw that leaves out the first impact has one fewer.
fn padded(
    name: &'static str,
    unit: &'static str,
    along: Axis,
    length: usize,
    rows: impl IntoIterator<Item = Vec<f64>>,
) -> Variable {
    let mut values = Vec::new();
    for row in rows {
        values.resize(values.len() + length.saturating_sub(row.len()), f64::NAN);
        values.extend(row);
    }
    Variable {
        name,
        unit,
        along: Some(along),
        values,
    }
}

/// The unknowns that have a prior whatever is measured, at points with the index of their ball.
fn of_points(
    sampled: &SampledPosterior,
    points: &[(usize, Point)],
    speeds_m_s: &[f64],
) -> Vec<Variable> {
    let each = |value: fn(&Point) -> f64| points.iter().map(|(_, point)| value(point)).collect();
    let laws = || points.iter().map(|(_, point)| point.law);
    let along_speed = |name, values: Vec<f64>| Variable {
        name,
        unit: "",
        along: Some(Axis::Speed),
        values,
    };
    let slopes = laws().flat_map(|law| speeds_m_s.iter().map(move |&speed| law.log_slope(speed)));
    let gravity = points
        .iter()
        .map(|(medium, point)| sampled.gravity_itself(&sampled.media[*medium], point));
    vec![
        along_speed(
            "restitution_curve",
            laws().flat_map(|law| law.at_each(speeds_m_s)).collect(),
        ),
        along_speed("restitution_slope", slopes.collect()),
        number("restitution_scatter", "", each(|point| point.scatter)),
        number("drag_scale", "", each(|point| point.drag_scale)),
        number("gravity_m_s2", "m/s²", gravity.collect()),
        number("contact_time_s", "s", each(|point| point.contact_time_s)),
        number("timing_scale", "", each(|point| point.timing)),
    ]
}

/// Draws of the prior, each possible ball being as probable as the others; the drop height has a proper prior only if it was
/// measured.
fn prior(
    sampled: &SampledPosterior,
    speeds_m_s: &[f64],
    count: usize,
    random: &mut Xoshiro256PlusPlus,
) -> Vec<Variable> {
    let law = sampled
        .candidates
        .first()
        .map_or(sampled.laws()[0], |it| it.law);
    let (mut points, mut heights) = (Vec::new(), Vec::new());
    // A law that no surface has is drawn again; a bound on the tries bounds the time.
    for number in 0..2 * count {
        let medium = number % sampled.media.len();
        let model = sampled.model_of(law, medium, 0, 0);
        let vector: Vec<f64> = model
            .slots()
            .iter()
            .map(|slot| match slot {
                Slot::Restitution => model.draw_logit(random),
                _ => StandardNormal.sample(random),
            })
            .collect();
        let [point] = model.values(&[&vector]);
        if let (Some(point), true) = (point, points.len() < count) {
            points.push((medium, point));
            let normal: f64 = StandardNormal.sample(random);
            heights.extend(model.height_m.map(|it| it.value + it.sd * normal));
        }
    }
    let mut prior = of_points(sampled, &points, speeds_m_s);
    if !heights.is_empty() {
        prior.insert(0, self::number("drop_height_m", "m", heights));
    }
    prior
}

/// Times from each impact detected to the next as they would be measured in another drop with these unknowns; not a number
/// from where the ball is faster or slower than the flights that are known.
fn replicated_intervals(model: &Model, point: &Point, random: &mut Xoshiro256PlusPlus) -> Vec<f64> {
    let observed = model.observed;
    let mut error = |sigma_s: f64| {
        let normal: f64 = StandardNormal.sample(random);
        point.timing * sigma_s * normal
    };
    let errors: Vec<f64> = observed
        .sigma_s
        .iter()
        .map(|&sigma_s| error(sigma_s))
        .collect();
    let table = model.table(point);
    let fallen = table
        .as_ref()
        .and_then(|it| it.launch(point.fall_launch_m_s));
    let mut impact = fallen.map(|row| row.impact);
    let mut fly = || {
        let speed = impact?;
        let scatter = point.scatter * tail::draw([Some(&mut *random)]).0[0];
        let row = table
            .as_ref()?
            .launch(speed * point.law.at(speed) * scatter.exp());
        impact = row.as_ref().map(|row| row.impact);
        row.map(|row| row.time / point.gravity_m_s2 + point.contact_time_s)
    };
    for _ in 0..model.missed_first {
        fly();
    }
    let intervals = observed.intervals.iter().zip(errors.windows(2));
    intervals
        .map(|(interval, errors)| {
            let flown: Option<f64> = (0..interval.flights).map(|_| fly()).sum();
            flown.map_or(f64::NAN, |flown| flown + errors[1] - errors[0])
        })
        .collect()
}
