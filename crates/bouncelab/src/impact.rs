//! Impacts: as they were measured, and as sources of sound.

/// An impact as measured: in a recording, in a list of times, or set by hand.
///
/// ```
/// use bouncelab::Impact;
///
/// let impact = Impact::new(3, 1.2854).with_time_sd_s(5e-5);
/// assert_eq!(impact.probability, 1.0);
/// assert_eq!(impact.level_db, None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Impact {
    /// Number, 1 for the first impact; a missed impact leaves a gap.
    pub number: usize,
    /// Time in seconds.
    pub time_s: f64,
    /// Standard uncertainty of the time in seconds, where it is known; the errors of different
    /// impacts are independent.
    pub time_sd_s: Option<f64>,
    /// Probability that this is an impact of the drop; 1 if it was set by hand.
    pub probability: f64,
    /// Level in dB relative to full scale, if it was detected in sound.
    pub level_db: Option<f64>,
    /// For how long before it the sound held nothing nearly as loud, in seconds; known for the first impact of a drop that
    /// was detected in sound. An impact as loud in this time would have been detected.
    #[cfg_attr(feature = "serde", serde(default))]
    pub quiet_before_s: Option<f64>,
    /// Natural logarithm of how much more probable its level and spectrum are if it is an impact of this ball than if it is
    /// any other sound; known for the first impact of a drop that was detected in sound.
    #[cfg_attr(feature = "serde", serde(default))]
    pub ln_alike: Option<f64>,
}

impl Impact {
    /// An impact with its number (1 for the first) and time alone.
    pub const fn new(number: usize, time_s: f64) -> Self {
        Self {
            number,
            time_s,
            time_sd_s: None,
            probability: 1.0,
            level_db: None,
            quiet_before_s: None,
            ln_alike: None,
        }
    }

    /// The same with a standard uncertainty of its time, in seconds.
    #[must_use]
    pub const fn with_time_sd_s(self, time_sd_s: f64) -> Self {
        Self {
            time_sd_s: Some(time_sd_s),
            ..self
        }
    }

    /// The same with its level, in dB relative to full scale.
    #[must_use]
    pub const fn with_level_db(self, level_db: f64) -> Self {
        Self {
            level_db: Some(level_db),
            ..self
        }
    }
}

/// One impact as a source of sound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactEvent {
    /// When the ball touches the surface, s after release.
    pub time_s: f64,
    /// How fast it arrives, m/s.
    pub speed_m_s: f64,
}
