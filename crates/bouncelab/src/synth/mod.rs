//! Synthesises the sound of a drop, with noise of known level.
//!
//! [`render`] turns a list of [`ImpactEvent`]s into a recording as a microphone would have made it,
//! and returns the truth with it: when each impact began (to a small fraction of a sample), its
//! level above the noise, whether it was left out, and the times of the clicks that are no
//! impacts. The detection is tested by undoing this.
//!
//! Each impact is a handful of decaying sines ([`Voice`]) that start at its exact time and are
//! evaluated at the sample times, so nothing is rounded to the sample grid. The [`Scene`] adds
//! the effects between a drop and a file: clicks, reverberation, hum, noise, an offset,
//! clipping and rounding, in this order. Everything random comes from one seed, each part from
//! its own stream: adding hum leaves the noise as it was.
//!
//! ```
//! use bouncelab::impact::ImpactEvent;
//! use bouncelab::synth::{self, Noise, Scene};
//!
//! let events = [
//!     ImpactEvent { time_s: 0.0, speed_m_s: 2.4 },
//!     ImpactEvent { time_s: 0.4605, speed_m_s: 2.2 },
//! ];
//! let scene = Scene { noise: Some(Noise::white(40.0)), ..Scene::default() };
//! let recording = synth::render(&events, &scene, 1)?;
//!
//! assert_eq!(recording.sample_rate_hz, 44_100);
//! // The recording starts half a second (the lead-in) before time 0 of the impact events.
//! assert_eq!(recording.impacts[1].time_s, 0.5 + 0.4605);
//! # Ok::<(), bouncelab::Error>(())
//! ```
//!
//! It does not model how sound travels, how a microphone colours it, or how a file format
//! compresses it.

mod background;
mod burst;
mod recorder;
mod reverb;
mod scene;
mod voice;

use std::ops::Bound::{Excluded, Unbounded};

use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Exp1, StandardNormal};

use crate::error::{Error, Quantity, Result, positive, within};
use crate::impact::ImpactEvent;
use burst::Burst;
pub use scene::{BitDepth, Clicks, Colour, Hum, Lost, Noise, Reverb, Scene};
pub use voice::{Mode, Voice};

/// Maximum samples of a recording: an hour at 48 kHz. More is surely a mistake, and would fill the memory.
const MAX_SAMPLES: f64 = 48_000.0 * 3600.0;

/// Minimum samples of the rise of an onset: that of an anti-alias filter.
const MIN_RISE_SAMPLES: f64 = 2.0;

/// A recording and the truth about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// The samples, 1 being full scale.
    pub samples: Vec<f32>,
    /// Samples a second.
    pub sample_rate_hz: u32,
    /// Every impact event in order, audible or not.
    pub impacts: Vec<SynthImpact>,
    /// Onsets of the sounds that are no impact, in seconds from the start of the recording.
    pub clicks_s: Vec<f64>,
}

/// The truth about one impact in a rendered recording.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SynthImpact {
    /// First contact, and start of the sound, in seconds from the first sample.
    pub time_s: f64,
    /// Impact speed in metres per second.
    pub speed_m_s: f64,
    /// 20 log10 of the root mean square of this impact alone over its first 5 ms, over that of
    /// the background noise. Infinite without noise; minus infinity for an impact over 120 dB
    /// below the loudest, which is not rendered. For a lost impact: what it would have been.
    pub snr_db: f64,
    /// Whether it was left out of the sound.
    pub lost: bool,
}

/// Renders impact events as a recording.
///
/// The recording starts `lead_in_s` before time 0 of the impact events and ends `tail_s` after the
/// last one. Without impact events it holds only the disturbances. The same arguments give the same
/// samples on the same machine.
///
/// # Errors
///
/// [`Error::OutOfRange`] if a number of the scene is outside its range, if an impact event has a negative
/// time or a speed that is not positive, if the impact events are not in the order of time, if a lost
/// impact is not in the list, if the voice makes no sound at this sample rate, or if the recording
/// would have more samples than an hour at 48 kHz.
///
/// ```
/// use bouncelab::synth::{self, Noise, Scene, Voice};
///
/// let events: Vec<_> = bouncelab::demo::history()?.impact_events().take(10).collect();
/// let scene = Scene {
///     voice: Voice::steel_ball(),
///     noise: Some(Noise::pink(30.0)),
///     ..Scene::default()
/// };
/// let sound = synth::render(&events, &scene, 7)?;
/// assert_eq!(sound.impacts.len(), 10);
/// assert_eq!(sound, synth::render(&events, &scene, 7)?); // the same seed, the same samples
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn render(events: &[ImpactEvent], scene: &Scene, seed: u64) -> Result<Rendered> {
    scene.check()?;
    check_events(events)?;
    let studio = Studio::new(scene, seed)?;
    let mut samples = vec![0.0; studio.length(events)?];

    let lost = studio.lost(events.len())?;
    let sounds = studio.add_impacts(&mut samples, events, &lost);
    let reference = studio.reference(&sounds, &lost)?;
    let clicks_s = studio.add_clicks(&mut samples, reference.rms);
    studio.add_reverb(&mut samples);
    let gain = scene.peak / reference.peak;
    for sample in &mut samples {
        *sample *= gain as f32;
    }
    let noise_rms = studio.add_background(&mut samples, gain * reference.rms);
    recorder::record(&mut samples, scene);

    let impacts = std::iter::zip(events, std::iter::zip(sounds, lost))
        .map(|(event, (sound, lost))| SynthImpact {
            time_s: scene.lead_in_s + event.time_s,
            speed_m_s: event.speed_m_s,
            snr_db: snr_db(gain * sound.rms, noise_rms),
            lost,
        })
        .collect();
    Ok(Rendered {
        samples,
        sample_rate_hz: scene.sample_rate_hz,
        impacts,
        clicks_s,
    })
}

fn check_events(events: &[ImpactEvent]) -> Result<()> {
    let mut earliest = 0.0;
    for event in events {
        within(Quantity::ImpactTime, event.time_s, earliest..)?;
        positive(Quantity::ImpactSpeed, event.speed_m_s)?;
        earliest = event.time_s;
    }
    Ok(())
}

/// How loud one impact is, before the gain of the recording.
#[derive(Clone, Copy)]
struct Loudness {
    rms: f64,
    peak: f64,
}

impl Loudness {
    fn of(burst: &Burst) -> Self {
        Self {
            rms: burst.rms(),
            peak: burst.peak(),
        }
    }
}

/// The independent sources of chance. Their order numbers the streams of the seed, so a new one
/// goes to the end.
#[derive(Clone, Copy)]
enum Chance {
    Lost,
    Impacts,
    Clicks,
    Reverb,
    Hum,
    Noise,
}

/// A scene with the numbers that every stage needs.
struct Studio<'a> {
    scene: &'a Scene,
    seed: u64,
    sample_rate_hz: f64,
    /// The modes that fit below half the sample rate, the loudest at level 1.
    modes: Vec<Mode>,
    rise_s: f64,
}

impl<'a> Studio<'a> {
    fn new(scene: &'a Scene, seed: u64) -> Result<Self> {
        let sample_rate_hz = f64::from(scene.sample_rate_hz);
        let voice = &scene.voice;
        let mut modes = voice.modes.clone();
        modes.retain(|mode| mode.frequency_hz < sample_rate_hz / 2.0);
        if modes.is_empty() {
            let frequencies = voice.modes.iter().map(|mode| mode.frequency_hz);
            let above = Excluded(2.0 * frequencies.fold(f64::INFINITY, f64::min));
            return Err(Error::out_of_range(
                Quantity::SampleRate,
                sample_rate_hz,
                (above, Unbounded),
            ));
        }
        let loudest = modes.iter().fold(0.0, |top: f64, mode| top.max(mode.level));
        for mode in &mut modes {
            mode.level /= loudest;
        }
        let rise_s = (voice.attack * voice.contact_time_s).max(MIN_RISE_SAMPLES / sample_rate_hz);
        Ok(Self {
            scene,
            seed,
            sample_rate_hz,
            modes,
            rise_s,
        })
    }

    fn rng(&self, chance: Chance) -> ChaCha8Rng {
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        rng.set_stream(chance as u64);
        rng
    }

    /// Samples in the recording.
    fn length(&self, events: &[ImpactEvent]) -> Result<usize> {
        let last_s = events.last().map_or(0.0, |event| event.time_s);
        let duration_s = self.scene.lead_in_s + last_s + self.scene.tail_s;
        let samples = (duration_s * self.sample_rate_hz).ceil();
        within(Quantity::Samples, samples, 0.0..=MAX_SAMPLES)?;
        Ok(samples as usize)
    }

    /// Which of `count` impacts are lost.
    fn lost(&self, count: usize) -> Result<Vec<bool>> {
        let mut lost = vec![false; count];
        match &self.scene.lost {
            Lost::None => {}
            Lost::Chance(chance) => {
                let mut rng = self.rng(Chance::Lost);
                lost.fill_with(|| rng.random_bool(*chance));
            }
            Lost::At(indices) => {
                for &index in indices {
                    within(Quantity::LostImpact, index as f64, 0.0..count as f64)?;
                    lost[index] = true;
                }
            }
        }
        Ok(lost)
    }

    /// Adds the impacts that are not lost; the loudness of each, lost or not.
    fn add_impacts(
        &self,
        samples: &mut [f32],
        events: &[ImpactEvent],
        lost: &[bool],
    ) -> Vec<Loudness> {
        let scene = self.scene;
        let mut rng = self.rng(Chance::Impacts);
        let fastest = events.iter().fold(0.0, |top: f64, s| top.max(s.speed_m_s));
        let mut burst = Burst::default();
        std::iter::zip(events, lost)
            .map(|(event, &lost)| {
                let scatter: f64 = scene.level_scatter * normal(&mut rng);
                let level =
                    (event.speed_m_s / fastest).powf(scene.voice.level_exponent) * scatter.exp();
                let modes = self
                    .modes
                    .iter()
                    .map(|&mode| (mode, scene.phase_scatter_rad * normal(&mut rng)));
                let time_s = scene.lead_in_s + event.time_s;
                burst.excite(time_s, modes, level, self.rise_s, self.sample_rate_hz);
                if !lost {
                    burst.add_to(samples, 1.0);
                }
                Loudness::of(&burst)
            })
            .collect()
    }

    /// The loudest impact that is not lost, or if all are, the one that the voice would have made.
    fn reference(&self, sounds: &[Loudness], lost: &[bool]) -> Result<Loudness> {
        let loudest = std::iter::zip(sounds, lost)
            .filter(|&(_, &lost)| !lost)
            .map(|(&sound, _)| sound)
            .max_by(|a, b| a.rms.total_cmp(&b.rms))
            .unwrap_or_else(|| {
                let mut burst = Burst::default();
                let modes = self.modes.iter().map(|&mode| (mode, 0.0));
                burst.excite(0.0, modes, 1.0, self.rise_s, self.sample_rate_hz);
                Loudness::of(&burst)
            });
        // All samples are divided by this, so it must be well above the smallest numbers of their type.
        within(Quantity::LoudestImpact, loudest.rms, 1e-9..)?;
        Ok(loudest)
    }

    /// Adds the clicks; their onsets.
    fn add_clicks(&self, samples: &mut [f32], reference_rms: f64) -> Vec<f64> {
        let Some(clicks) = self.scene.clicks else {
            return Vec::new();
        };
        let rms = reference_rms * from_db(clicks.level_db);
        let end_s = samples.len() as f64 / self.sample_rate_hz;
        let mut rng = self.rng(Chance::Clicks);
        let mut burst = Burst::default();
        let mut onsets = Vec::new();
        let mut time_s = 0.0;
        loop {
            time_s += rng.sample::<f64, _>(Exp1) / clicks.rate_per_s;
            if time_s >= end_s {
                return onsets;
            }
            let tick = std::iter::once((self.tick(&mut rng), 0.0));
            let rise_s = MIN_RISE_SAMPLES / self.sample_rate_hz;
            burst.excite(time_s, tick, 1.0, rise_s, self.sample_rate_hz);
            burst.add_to(samples, rms / burst.rms());
            onsets.push(time_s);
        }
    }

    /// A tick of random pitch: all octaves from 500 Hz to 10 kHz are equally likely.
    fn tick(&self, rng: &mut impl Rng) -> Mode {
        let highest = (0.45 * self.sample_rate_hz).min(10e3);
        let frequency_hz = 500.0 * (highest / 500.0).powf(rng.random());
        Mode::new(frequency_hz, 1e-3, 1.0)
    }

    fn add_reverb(&self, samples: &mut [f32]) {
        if let Some(reverb) = &self.scene.reverb {
            let mut rng = self.rng(Chance::Reverb);
            reverb::add_reverb(samples, reverb, self.sample_rate_hz, &mut rng);
        }
    }

    /// Adds hum and noise; the root mean square of the noise.
    fn add_background(&self, samples: &mut [f32], reference_rms: f64) -> f64 {
        if let Some(hum) = &self.scene.hum {
            let rms = reference_rms * from_db(hum.level_db);
            let mut rng = self.rng(Chance::Hum);
            background::add_hum(samples, hum, rms, self.sample_rate_hz, &mut rng);
        }
        let Some(noise) = self.scene.noise else {
            return 0.0;
        };
        let rms = reference_rms * from_db(-noise.snr_db);
        let mut rng = self.rng(Chance::Noise);
        background::add_noise(samples, noise.colour, rms, self.sample_rate_hz, &mut rng);
        rms
    }
}

fn snr_db(rms: f64, noise_rms: f64) -> f64 {
    if noise_rms > 0.0 {
        20.0 * (rms / noise_rms).log10()
    } else {
        f64::INFINITY
    }
}

fn normal(rng: &mut impl Rng) -> f64 {
    rng.sample(StandardNormal)
}

fn from_db(level_db: f64) -> f64 {
    10_f64.powf(level_db / 20.0)
}
