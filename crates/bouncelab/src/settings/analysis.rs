//! The detection, corrections by hand, and what to compute besides the inference.

use std::ops::RangeInclusive;

use crate::analysis::{DetectionOptions, Edits};

/// Where in a recording to look for impacts.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct DetectionSettings {
    /// The only channel to use, the first being 1; the one with the clearest impacts if left out.
    pub channel: Option<usize>,
    /// The only frequencies to use, in Hz; all bands, each against its own background, if left out.
    pub band_hz: Option<(f64, f64)>,
    /// The sample rate in Hz of a file that does not state it: samples in text without times.
    pub rate_hz: Option<u32>,
}

/// Candidates accepted, and impacts excluded and included by hand.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct EditSettings {
    /// What may be a drop and is taken for one, by its place in `candidates`, the first being 1.
    pub accept: Option<Vec<usize>>,
    /// Times of impacts to exclude: of each, the nearest impact within 20 ms.
    pub exclude_s: Option<Vec<f64>>,
    /// Times of impacts to add.
    pub include_s: Option<Vec<f64>>,
}

/// What to compute of a drop besides the inference.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct AnalysisSettings {
    /// First and last flight of the log-linear fit; all between certain impacts if left out.
    pub flights: Option<(usize, usize)>,
    /// Whether to compare what the impact times indicate of each preset ball; `false` if left out.
    pub compare_balls: Option<bool>,
}

impl DetectionSettings {
    pub(super) fn resolve(&self) -> DetectionOptions {
        DetectionOptions {
            channel: self.channel,
            band_hz: self.band_hz.map(|(low, high)| low..high),
            rate_hz: self.rate_hz,
        }
    }
}

impl EditSettings {
    pub(super) fn resolve(&self) -> Edits {
        Edits {
            accept: self.accept.clone().unwrap_or_default(),
            exclude_s: self.exclude_s.clone().unwrap_or_default(),
            include_s: self.include_s.clone().unwrap_or_default(),
            gaps: Vec::new(),
        }
    }
}

impl AnalysisSettings {
    pub(super) fn flights(&self) -> Option<RangeInclusive<usize>> {
        let (first, last) = self.flights?;
        Some(first..=last)
    }
}
