//! Recording conditions: all settings of [`render`](super::render).

use std::ops::Bound::Excluded;

use super::voice::Voice;
use crate::Result;
use crate::error::{Quantity, positive_up_to, within};

/// Everything between the drop and the file: voice, reverberation, noise, disturbances, recorder.
///
/// The default is a clean table-tennis drop at 44.1 kHz and 16 bit, with white noise 60 dB
/// below the loudest impact. Levels in decibels are all relative to the loudest impact that is
/// not lost: its root mean square over the first 5 ms, before reverberation. If all are lost,
/// they are relative to the one that the voice would have made.
///
/// ```
/// use bouncelab::synth::{BitDepth, Noise, Scene, Voice};
///
/// let gym = Scene {
///     voice: Voice::basketball(),
///     noise: Some(Noise::pink(25.0)),
///     sample_rate_hz: 48_000,
///     bit_depth: BitDepth::TwentyFour,
///     ..Scene::default()
/// };
/// assert_eq!(gym.lead_in_s, 0.5);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Samples a second, 4 000 to 192 000.
    pub sample_rate_hz: u32,
    /// Seconds of recording before time 0 of the impact events; not negative.
    pub lead_in_s: f64,
    /// Seconds of recording after the last impact event; at least 0.005.
    pub tail_s: f64,
    /// What an impact sounds like.
    pub voice: Voice,
    /// Standard deviation of the natural logarithm of the level from impact to impact, 0 to 1.
    pub level_scatter: f64,
    /// Standard deviation of the phase of each mode from impact to impact in radians, 0 to pi.
    pub phase_scatter_rad: f64,
    /// Peak of the loudest impact as a fraction of full scale, above 0, at most 100.
    /// Above 1, a recorder of 8, 16 or 24 bit clips.
    pub peak: f64,
    /// Background noise, if any.
    pub noise: Option<Noise>,
    /// Mains hum, if any.
    pub hum: Option<Hum>,
    /// Reverberation of impacts and clicks, if any.
    pub reverb: Option<Reverb>,
    /// Sounds that are no impact, if any.
    pub clicks: Option<Clicks>,
    /// Impacts that are left out.
    pub lost: Lost,
    /// Constant added by the recorder, as a fraction of full scale, -1 to 1.
    pub dc_offset: f64,
    /// Level, as a fraction of full scale, at which the signal is cut off (above 0, at most 1);
    /// `None` leaves that to the bit depth.
    pub clip_at: Option<f64>,
    /// How the samples are stored.
    pub bit_depth: BitDepth,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            sample_rate_hz: 44_100,
            lead_in_s: 0.5,
            tail_s: 0.5,
            voice: Voice::default(),
            level_scatter: 0.1,
            phase_scatter_rad: 0.1,
            peak: 0.5,
            noise: Some(Noise::white(60.0)),
            hum: None,
            reverb: None,
            clicks: None,
            lost: Lost::None,
            dc_offset: 0.0,
            clip_at: None,
            bit_depth: BitDepth::Sixteen,
        }
    }
}

impl Scene {
    pub(super) fn check(&self) -> Result<()> {
        within(
            Quantity::SampleRate,
            f64::from(self.sample_rate_hz),
            4e3..=192e3,
        )?;
        within(Quantity::LeadIn, self.lead_in_s, 0.0..)?;
        within(Quantity::Tail, self.tail_s, 0.005..)?;
        self.voice.check()?;
        within(Quantity::LevelScatter, self.level_scatter, 0.0..=1.0)?;
        within(
            Quantity::PhaseScatter,
            self.phase_scatter_rad,
            0.0..=std::f64::consts::PI,
        )?;
        positive_up_to(Quantity::Peak, self.peak, 100.0)?;
        within(Quantity::DcOffset, self.dc_offset, -1.0..=1.0)?;
        if let Some(level) = self.clip_at {
            positive_up_to(Quantity::ClippingLevel, level, 1.0)?;
        }
        self.check_disturbances()
    }

    fn check_disturbances(&self) -> Result<()> {
        let nyquist_hz = f64::from(self.sample_rate_hz) / 2.0;
        if let Some(noise) = &self.noise {
            within(Quantity::Snr, noise.snr_db, -60.0..=200.0)?;
        }
        if let Some(hum) = &self.hum {
            let frequencies = (Excluded(0.0), Excluded(nyquist_hz));
            within(Quantity::HumFrequency, hum.frequency_hz, frequencies)?;
            within(Quantity::HumHarmonics, hum.harmonics as f64, 1.0..=100.0)?;
            within(Quantity::HumLevel, hum.level_db, -200.0..=60.0)?;
        }
        if let Some(reverb) = &self.reverb {
            within(Quantity::ReverberationTime, reverb.rt60_s, 0.01..=20.0)?;
            within(
                Quantity::DirectToReverberant,
                reverb.direct_to_reverberant_db,
                -60.0..=120.0,
            )?;
        }
        if let Some(clicks) = &self.clicks {
            positive_up_to(Quantity::ClickRate, clicks.rate_per_s, 1000.0)?;
            within(Quantity::ClickLevel, clicks.level_db, -200.0..=60.0)?;
        }
        if let Lost::Chance(chance) = self.lost {
            within(Quantity::LossProbability, chance, 0.0..=1.0)?;
        }
        Ok(())
    }
}

/// Background noise of known strength, Gaussian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// How its power is distributed over frequency.
    pub colour: Colour,
    /// Signal-to-noise ratio in decibels, -60 to 200: 20 log10 of the root mean square of the
    /// loudest impact over its first 5 ms, over that of the noise over the whole recording.
    pub snr_db: f64,
}

impl Noise {
    /// White noise at this signal-to-noise ratio.
    ///
    /// ```
    /// use bouncelab::synth::{Noise, Scene};
    ///
    /// let scene = Scene { noise: Some(Noise::white(20.0)), ..Scene::default() };
    /// assert_eq!(scene.noise.unwrap().snr_db, 20.0);
    /// ```
    pub const fn white(snr_db: f64) -> Self {
        Self {
            colour: Colour::White,
            snr_db,
        }
    }

    /// Pink noise at this signal-to-noise ratio.
    ///
    /// ```
    /// use bouncelab::synth::{Colour, Noise};
    ///
    /// assert_eq!(Noise::pink(20.0).colour, Colour::Pink);
    /// ```
    pub const fn pink(snr_db: f64) -> Self {
        Self {
            colour: Colour::Pink,
            snr_db,
        }
    }
}

/// How the power of a noise is distributed over frequency.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// The same power in every hertz.
    White,
    /// The same power in every octave above 10 Hz: ambient noise, wind, traffic.
    Pink,
}

/// Mains hum: a fundamental and its harmonics, the k-th at 1/k of the amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hum {
    /// The fundamental in hertz, usually 50 or 60.
    pub frequency_hz: f64,
    /// How many partials, the fundamental counted, 1 to 100. Those at or above half the sample
    /// rate are left out.
    pub harmonics: usize,
    /// Root mean square of the whole hum relative to the loudest impact, in decibels, -200 to 60.
    pub level_db: f64,
}

impl Hum {
    /// Mains hum of this frequency, 20 dB below the loudest impact.
    pub const fn mains(frequency_hz: f64) -> Self {
        Self {
            frequency_hz,
            harmonics: 5,
            level_db: -20.0,
        }
    }
}

/// Reverberation: a tail of Gaussian noise that decays exponentially, as in a diffuse sound field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reverb {
    /// Time in seconds in which the tail falls by 60 dB, 0.01 to 20.
    pub rt60_s: f64,
    /// Energy of the direct sound over that of the tail, in decibels, -60 to 120.
    pub direct_to_reverberant_db: f64,
}

impl Reverb {
    /// As a metre from the ball, with this reverberation time in seconds.
    pub const fn of_time(rt60_s: f64) -> Self {
        Self {
            rt60_s,
            direct_to_reverberant_db: 6.0,
        }
    }
}

/// Sounds that are no impact: short ticks of random pitch at random times (Poisson).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clicks {
    /// Mean number per second, above 0, at most 1000.
    pub rate_per_s: f64,
    /// Root mean square of each over its first 5 ms relative to the loudest impact, in decibels,
    /// -200 to 60.
    pub level_db: f64,
}

impl Clicks {
    /// Clicks at this mean rate, half as loud as the loudest impact.
    pub const fn often(rate_per_s: f64) -> Self {
        Self {
            rate_per_s,
            level_db: -6.0,
        }
    }
}

/// Which impacts are left out.
#[derive(Clone, Debug, PartialEq)]
pub enum Lost {
    /// None: all are in the recording.
    None,
    /// Each is lost with this chance, 0 to 1.
    Chance(f64),
    /// Those with these indices in the list of impact events, counted from 0.
    At(Vec<usize>),
}

/// How samples are stored, which determines how they are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BitDepth {
    /// 8 bit: 256 levels.
    Eight,
    /// 16 bit: 65 536 levels.
    Sixteen,
    /// 24 bit: 16 777 216 levels.
    TwentyFour,
    /// 32 bit floating point: no rounding to levels and no limit.
    Float,
}

impl BitDepth {
    /// Bits of an integer sample; `None` for floating point.
    ///
    /// ```
    /// use bouncelab::synth::BitDepth;
    ///
    /// assert_eq!((BitDepth::Eight.bits(), BitDepth::Float.bits()), (Some(8), None));
    /// ```
    pub const fn bits(self) -> Option<u32> {
        match self {
            Self::Eight => Some(8),
            Self::Sixteen => Some(16),
            Self::TwentyFour => Some(24),
            Self::Float => None,
        }
    }
}
