//! The detector: samples in, drops out.
//!
//! It takes a recording of any length in blocks of any size, channel by channel, and remembers
//! as much of it as the longest drop lasts, at most 128 MB of samples. All channels are
//! analysed; the result is that of the channel whose drops have the most evidence over chance, and names
//! it. All numbers are in `parameters`.
//!
//! ```
//! use bouncelab::impact::ImpactEvent;
//! use bouncelab::detection::Detector;
//! use bouncelab::synth::{self, Scene};
//!
//! let mut time_s = 0.0;
//! let events: Vec<ImpactEvent> = (0..20)
//!     .map(|n| {
//!         let speed_m_s = 2.4 * 0.9_f64.powi(n);
//!         let event = ImpactEvent { time_s, speed_m_s };
//!         time_s += 2.0 * 0.9 * speed_m_s / 9.81;
//!         event
//!     })
//!     .collect();
//! let recording = synth::render(&events, &Scene::default(), 7)?;
//!
//! let mut detector = Detector::new(recording.sample_rate_hz, 1);
//! for block in recording.samples.chunks(1024) {
//!     detector.push(&[block]);
//! }
//! let detection = detector.finish();
//! assert_eq!(detection.found.trains.len(), 1);
//! assert_eq!(detection.found.trains[0].impacts().len(), 20);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod clipping;
mod envelope;
mod parameters;
mod stream;
mod watch;

use crate::diagnostic::{Code, Diagnostic};
use crate::onset;
use crate::stats::median;
use crate::train::{MIN_UNUSED, Train, TrainSearch};
use std::ops::Range;

pub use envelope::Envelope;
pub use stream::Detector;
pub use watch::DropWatch;

/// Where in a recording to look for impacts.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct DetectionOptions {
    /// The only channel to use, the first being 1; if `None`, the one with the most evidence.
    pub channel: Option<usize>,
    /// The only frequencies to use, in Hz; if `None`, all bands, each against its own background.
    pub band_hz: Option<Range<f64>>,
    /// The sample rate in Hz of a file that does not state it: samples in text without times.
    pub rate_hz: Option<u32>,
}

/// The detections in a recording.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Detection {
    /// Sample rate, Hz.
    pub sample_rate_hz: u32,
    /// Number of channels.
    pub channels: usize,
    /// The channel with the most evidence, counted from 0.
    pub channel: usize,
    /// Number of channels that differ from each other.
    pub distinct_channels: usize,
    /// The drops in it.
    pub found: TrainSearch,
    /// Number of sounds that stand out of its background.
    pub onsets: usize,
    /// Its loudness over time, for a picture.
    pub envelope: Envelope,
    /// Length of the recording in seconds.
    pub duration_s: f64,
    /// Number of its samples at full scale or at its own limit, in runs: clipping.
    pub clipped_samples: u64,
}

impl Detection {
    /// Why there is no drop; `None` if there is one.
    ///
    /// ```
    /// use bouncelab::Detector;
    ///
    /// let mut detector = Detector::new(48_000, 1);
    /// detector.push(&[&[0.0; 48_000]]);
    /// let reason = detector.finish().no_drop().unwrap();
    /// assert_eq!(reason.code.name(), "recording-silent");
    /// ```
    pub fn no_drop(&self) -> Option<Diagnostic> {
        if !self.found.trains.is_empty() {
            return None;
        }
        Some(if self.envelope.is_constant() {
            Diagnostic::new(Code::RecordingSilent)
        } else {
            self.found.no_drop(self.onsets)
        })
    }

    /// The band in which the impacts of all drops stand out most, by its index in
    /// [`onset::bands_hz`], and the median of their levels above the noise there in dB; `None` without a drop.
    pub fn strongest_band(&self) -> Option<(usize, f64)> {
        let impacts = || self.found.trains.iter().flat_map(Train::impacts);
        (0..onset::BANDS)
            .filter_map(|band| {
                let above_db =
                    impacts().map(|i| i.onset.band_levels_db[band] - i.onset.band_noise_db[band]);
                Some((band, median(above_db.map(f64::from))?))
            })
            .max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Warnings about the recording as a whole.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let distant = self.found.distant.iter().map(|train| {
            Diagnostic::new(Code::DistantBall)
                .with("start_s", train.start_s())
                .with("end_s", train.end_s())
                .with("impacts", train.impacts().len())
        });
        let mut diagnostics: Vec<Diagnostic> = distant.collect();
        diagnostics.extend(self.found.overlaps().map(|(start_s, end_s)| {
            let at_once = Diagnostic::new(Code::DropsAtOnce);
            at_once.with("start_s", start_s).with("end_s", end_s)
        }));
        diagnostics.extend(self.found.trains.iter().filter_map(|train| {
            let earlier = Diagnostic::new(Code::EarlierImpact).with("time_s", train.earlier_s?);
            Some(earlier.with("start_s", train.start_s()))
        }));
        let near = self
            .found
            .trains
            .iter()
            .filter(|train| train.unused >= MIN_UNUSED);
        diagnostics.extend(near.map(|train| {
            Diagnostic::new(Code::SoundsUnused)
                .with("count", train.unused)
                .with("start_s", train.start_s())
        }));
        if self.clipped_samples > 0 && !self.found.trains.is_empty() {
            let clipped = Diagnostic::new(Code::Clipped);
            diagnostics.push(clipped.with("samples", self.clipped_samples));
        }
        diagnostics
    }
}
