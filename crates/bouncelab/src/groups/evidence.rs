//! What the times of one drop say of the restitution curve, without what was assumed before the data.

use crate::inference::Measured;

/// How many inputs the drops of a ball share: drag coefficient, gravity, air with mass and diameter, contact time, and the
/// choice of the drag law or of an open ball.
pub const SHARED_INPUTS: usize = 5;

/// What one drop says of ln e at a few of its impact speeds, as independent readings with a standard error of 1.
///
/// The readings are the likelihood, not the posterior: the prior of the law is divided out, since many drops would count it
/// many times. Directions in which the prior dominates have no reading, so a drop of few impacts has one and a long one has
/// four.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct CurveEvidence {
    /// The slowest and the fastest of its impacts, m/s.
    pub range_m_s: [f64; 2],
    /// The impact speeds of [`Reading::weights`], m/s, increasing.
    pub speeds_m_s: Vec<f64>,
    /// The readings.
    pub readings: Vec<Reading>,
    /// The shared inputs, each of mean 0 and variance 1 before the data: mean after them.
    pub inputs: [f64; SHARED_INPUTS],
    /// Their covariance.
    pub inputs_covariance: [[f64; SHARED_INPUTS]; SHARED_INPUTS],
    /// Its drop height, if it tells one.
    pub height: Option<HeightEvidence>,
}

/// weights · ln e + shared · inputs = value, with a standard error of 1.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Reading {
    /// Weight of ln e at each of [`CurveEvidence::speeds_m_s`].
    pub weights: Vec<f64>,
    /// Weight of each shared input.
    pub shared: [f64; SHARED_INPUTS],
    /// The value.
    pub value: f64,
}

/// ln of the drop height in metres, given the curve and the shared inputs: constant + curve · ln e + shared · inputs.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct HeightEvidence {
    /// The constant.
    pub constant: f64,
    /// Factor of ln e at each of [`CurveEvidence::speeds_m_s`].
    pub curve: Vec<f64>,
    /// Factor of each shared input.
    pub shared: [f64; SHARED_INPUTS],
    /// Its standard uncertainty, relative, given those.
    pub rel_sd: f64,
    /// The height that was stated, m, which the inference used.
    pub stated_m: Option<Measured>,
}

impl CurveEvidence {
    /// Restitutions at some speeds, m/s, measured in any way, with errors of their own: of a drop that was filmed, say.
    ///
    /// ```
    /// use bouncelab::groups::{Asked, CurveEvidence, Study, StudyDrop};
    /// use bouncelab::inference::Measured;
    ///
    /// let drop = |value| StudyDrop {
    ///     evidence: CurveEvidence::measured(&[1.0, 2.0].map(|speed_m_s| (speed_m_s, Measured { value, sd: 0.001 }))),
    ///     scatter: None,
    ///     levels: Vec::new(),
    /// };
    /// let study = Study::of(&[0.921, 0.924, 0.919, 0.926].map(drop), &Asked::default())?;
    /// assert!((study.groups[0].restitution.unwrap().value - 0.9225).abs() < 2e-4);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn measured(restitutions: &[(f64, Measured)]) -> Self {
        let mut restitutions = restitutions.to_vec();
        restitutions.sort_by(|one, other| one.0.total_cmp(&other.0));
        let speeds_m_s: Vec<f64> = restitutions
            .iter()
            .map(|(speed_m_s, _)| *speed_m_s)
            .collect();
        let reading = |(index, (_, measured)): (usize, &(f64, Measured))| {
            let mut weights = vec![0.0; speeds_m_s.len()];
            weights[index] = measured.value / measured.sd;
            Reading {
                value: weights[index] * measured.value.ln(),
                weights,
                shared: [0.0; SHARED_INPUTS],
            }
        };
        let ends = speeds_m_s.first().zip(speeds_m_s.last());
        Self {
            range_m_s: ends.map_or([f64::NAN; 2], |(slowest, fastest)| [*slowest, *fastest]),
            readings: restitutions.iter().enumerate().map(reading).collect(),
            speeds_m_s,
            inputs: [0.0; SHARED_INPUTS],
            inputs_covariance: [[0.0; SHARED_INPUTS]; SHARED_INPUTS],
            height: None,
        }
    }

    /// Whether it has a reading, and every number of it is finite and in range: a file may hold anything.
    pub fn is_usable(&self) -> bool {
        let points = self.speeds_m_s.len();
        let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        let speeds = [&self.range_m_s[..], &self.speeds_m_s].concat();
        let reading = |it: &Reading| {
            it.weights.len() == points
                && finite(&it.weights)
                && finite(&it.shared)
                && it.value.is_finite()
        };
        let height = |it: &HeightEvidence| {
            it.curve.len() == points
                && finite(&it.curve)
                && finite(&it.shared)
                && it.constant.is_finite()
                && it.rel_sd.is_finite()
                && it.rel_sd > 0.0
                && it
                    .stated_m
                    .is_none_or(|it| it.value.is_finite() && it.sd.is_finite() && it.sd > 0.0)
        };
        !self.readings.is_empty()
            && speeds.iter().all(|speed| (1e-6..=1e6).contains(speed))
            && self.range_m_s[0] <= self.range_m_s[1]
            && self.readings.iter().all(reading)
            && finite(&self.inputs)
            && self.inputs_covariance.iter().all(|row| finite(row))
            && self.height.as_ref().is_none_or(height)
    }
}
