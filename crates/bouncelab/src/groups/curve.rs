//! Restitution against impact speed, at speeds that all drops share.

use crate::inference::Posterior;

/// Restitution at one impact speed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct CurvePoint {
    /// Impact speed, m/s.
    pub speed_m_s: f64,
    /// Restitution there.
    pub value: f64,
    /// Its standard uncertainty by what is this drop's own: timing and the scatter of its impacts.
    pub own_sd: f64,
    /// Its standard uncertainty by what it shares with other drops of the ball: drag law, air,
    /// gravity, mass, diameter, contact.
    pub shared_sd: f64,
}

/// Restitution against impact speed, at increasing speeds.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct RestitutionCurve(pub Vec<CurvePoint>);

impl RestitutionCurve {
    /// The speeds at which laws of different drops can be compared, m/s: four to an octave, among
    /// them 1 m/s, from `slowest` to `fastest`.
    ///
    /// ```
    /// let speeds = bouncelab::groups::RestitutionCurve::speeds(0.5, 2.0);
    /// assert_eq!((speeds.len(), speeds[0], speeds[4], speeds[8]), (9, 0.5, 1.0, 2.0));
    /// ```
    pub fn speeds(slowest_m_s: f64, fastest_m_s: f64) -> Vec<f64> {
        const TO_AN_OCTAVE: f64 = 4.0;
        if !(slowest_m_s > 0.0 && fastest_m_s.is_finite()) {
            return Vec::new();
        }
        let step = |speed: f64| TO_AN_OCTAVE * speed.log2();
        let (first, last) = (
            step(slowest_m_s).ceil() as i32,
            step(fastest_m_s).floor() as i32,
        );
        (first..=last)
            .map(|step| 2_f64.powf(f64::from(step) / TO_AN_OCTAVE))
            .collect()
    }

    /// The law at a speed, between neighbours in proportion to the logarithm of the speed; `None`
    /// outside the speeds it is known at.
    pub fn at(&self, speed_m_s: f64) -> Option<CurvePoint> {
        /// Speeds that differ by less are the same.
        const SAME: f64 = 1e-9;
        let after = self
            .0
            .iter()
            .position(|point| point.speed_m_s >= speed_m_s * (1.0 - SAME))?;
        let high = &self.0[after];
        if high.speed_m_s <= speed_m_s * (1.0 + SAME) {
            return Some(*high);
        }
        let low = self.0.get(after.checked_sub(1)?)?;
        let share = (speed_m_s / low.speed_m_s).ln() / (high.speed_m_s / low.speed_m_s).ln();
        let between = |low: f64, high: f64| low + share * (high - low);
        Some(CurvePoint {
            speed_m_s,
            value: between(low.value, high.value),
            own_sd: between(low.own_sd, high.own_sd),
            shared_sd: between(low.shared_sd, high.shared_sd),
        })
    }
}

impl From<&Posterior> for RestitutionCurve {
    /// Restitution at the [speeds](Self::speeds) within those of the impacts.
    fn from(posterior: &Posterior) -> Self {
        let [slowest, fastest] = posterior.fitted_speeds_m_s;
        let speeds = Self::speeds(slowest, fastest);
        let shared = posterior.shared_sd(&speeds).unwrap_or_default();
        let known = posterior.restitution_at_each(&speeds).into_iter();
        let points = known.enumerate().filter_map(|(place, restitution)| {
            let restitution = restitution.filter(|restitution| restitution.sd.is_finite())?;
            let shared_sd = shared.get(place).copied().filter(|sd| sd.is_finite());
            // What is not shared is this drop's own: the whole of it where the fit is too odd to be
            // taken apart.
            let shared_sd = shared_sd.unwrap_or(0.0).min(restitution.sd);
            Some(CurvePoint {
                speed_m_s: speeds[place],
                value: restitution.value,
                own_sd: (restitution.sd.powi(2) - shared_sd.powi(2)).sqrt(),
                shared_sd,
            })
        });
        Self(points.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_are_the_same_for_all_drops() {
        assert_eq!(RestitutionCurve::speeds(0.9, 2.1).len(), 5);
        assert_eq!(
            RestitutionCurve::speeds(0.9, 2.1)[0].to_bits(),
            1.0_f64.to_bits()
        );
        let wide = RestitutionCurve::speeds(0.3, 5.0);
        assert!(
            RestitutionCurve::speeds(0.9, 2.1)
                .iter()
                .all(|speed| wide.contains(speed))
        );
        assert_eq!(RestitutionCurve::speeds(0.0, 2.0), Vec::<f64>::new());
        assert_eq!(RestitutionCurve::speeds(1.05, 1.1), Vec::<f64>::new());
    }

    #[test]
    fn a_law_is_read_between_its_speeds_and_not_beyond() {
        let points = RestitutionCurve::speeds(1.0, 4.0).into_iter();
        let law = RestitutionCurve(
            points
                .map(|speed_m_s| CurvePoint {
                    speed_m_s,
                    value: 0.9 - 0.01 * speed_m_s.ln(),
                    own_sd: 0.001,
                    shared_sd: 0.0005,
                })
                .collect(),
        );
        let point = law.at(1.5).unwrap();
        assert!((point.value - (0.9 - 0.01 * 1.5_f64.ln())).abs() < 1e-12);
        assert_eq!(law.at(2.0).unwrap().speed_m_s.to_bits(), 2.0_f64.to_bits());
        assert_eq!(law.at(0.9), None);
        assert_eq!(law.at(4.5), None);
    }
}
