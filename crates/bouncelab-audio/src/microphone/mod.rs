//! A microphone as a stream of samples.
//!
//! ```no_run
//! use bouncelab_audio::microphone::{Arrival, Microphone};
//!
//! let mut microphone = Microphone::open(None)?;
//! let mut planes = Vec::new();
//! loop {
//!     match microphone.read(&mut planes)? {
//!         Arrival::Sound => println!("{} samples of each channel", planes[0].len()),
//!         Arrival::Lost { frames } => println!("{frames} samples of each channel were lost"),
//!         Arrival::Nothing => std::thread::sleep(std::time::Duration::from_millis(20)),
//!     }
//! }
//! # #[allow(unreachable_code)]
//! # Ok::<(), bouncelab_audio::Error>(())
//! ```

mod handover;

pub use handover::Arrival;

use std::fmt;
use std::sync::Arc;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use cpal::traits::{DeviceTrait, HostTrait, StreamTrait};
use cpal::{
    BufferSize, ErrorKind, FromSample, SizedSample, StreamInstant, SupportedBufferSize,
    SupportedStreamConfig,
};

use self::handover::{Feeder, Taker, handover};
use crate::error::{Error, Result};
use crate::wav::SampleFormat;

/// An input device.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Device {
    /// Its identifier in the system.
    pub id: String,
    /// A description for people.
    pub description: String,
    /// Whether it is the default device.
    pub is_default: bool,
}

/// The input devices that the system lists. Whether one works is only known
/// when it is opened.
///
/// # Errors
///
/// [`Error::Microphone`] if the system's sound service is not there.
pub fn devices() -> Result<Vec<Device>> {
    let host = cpal::default_host();
    let default = host.default_input_device().as_ref().and_then(id_of);
    let devices = host
        .input_devices()
        .map_err(|reason| refused("", &reason))?
        .filter_map(|device| {
            let id = id_of(&device)?;
            Some(Device {
                description: description(&device),
                is_default: default.as_ref() == Some(&id),
                id,
            })
        });
    Ok(devices.collect())
}

/// A microphone that records.
///
/// The samples are those of the device, at its own rate and in its own number of channels. They are
/// kept for up to half a minute until they are read; the thread that fetches them never waits for the reader.
pub struct Microphone {
    name: String,
    sample_rate_hz: u32,
    channels: usize,
    format: SampleFormat,
    taker: Taker,
    faults: Arc<Faults>,
    last_arrival: Instant,
    /// Stops when it is dropped.
    _stream: cpal::Stream,
}

impl fmt::Debug for Microphone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Microphone")
            .field("name", &self.name)
            .field("sample_rate_hz", &self.sample_rate_hz)
            .field("channels", &self.channels)
            .finish_non_exhaustive()
    }
}

/// Faults that the device reports.
#[derive(Default)]
struct Faults {
    /// Number of interruptions of the sound.
    interruptions: AtomicU64,
    /// The error after which no more sound comes.
    end: OnceLock<cpal::Error>,
}

impl Microphone {
    /// Opens a microphone and starts recording: the system's default device, or the device with this id, or the only
    /// one whose id or description contains this text, in small or capital letters.
    ///
    /// # Errors
    ///
    /// [`Error::Microphone`] if there is no such device, the name means several, or the device
    /// cannot be opened.
    pub fn open(name: Option<&str>) -> Result<Self> {
        let host = cpal::default_host();
        let device = match name {
            Some(name) => find(&host, name)?,
            None => host.default_input_device().ok_or_else(|| {
                fault(
                    "",
                    "the system has no default input; is a microphone plugged in?".to_owned(),
                )
            })?,
        };
        let name = description(&device);
        let config = device
            .default_input_config()
            .map_err(|reason| refused(&name, &reason))?;
        let started = match start(&device, &config, buffer(&config)) {
            Err(reason) if reason.kind() == ErrorKind::UnsupportedConfig => {
                start(&device, &config, BufferSize::Default)
            }
            started => started,
        };
        let (stream, taker, faults) = started.map_err(|reason| refused(&name, &reason))?;
        Ok(Self {
            name,
            sample_rate_hz: config.sample_rate(),
            channels: usize::from(config.channels()),
            format: lossless(config.sample_format()),
            taker,
            faults,
            last_arrival: Instant::now(),
            _stream: stream,
        })
    }

    /// The description of the device.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Sample rate, in Hz.
    pub fn sample_rate_hz(&self) -> u32 {
        self.sample_rate_hz
    }

    /// Number of channels of the device.
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// The format of a WAV file that represents the samples without loss.
    pub fn format(&self) -> SampleFormat {
        self.format
    }

    /// Takes the samples since the last call, without waiting. They replace those in `planes`,
    /// which gets one plane for each channel.
    ///
    /// # Errors
    ///
    /// [`Error::Microphone`] after the device is gone, or has sent nothing for five seconds, and
    /// everything that it sent before has been read.
    pub fn read(&mut self, planes: &mut Vec<Vec<f32>>) -> Result<Arrival> {
        /// Maximum time without sound: wireless devices take seconds to start.
        const MAX_SILENCE: Duration = Duration::from_secs(5);
        // Read before the samples: those before the end are in the ring by then.
        let end = self.faults.end.get();
        let arrival = self.taker.take(planes);
        if arrival != Arrival::Nothing {
            self.last_arrival = Instant::now();
        } else if let Some(reason) = end {
            return Err(refused(&self.name, reason));
        } else if self.last_arrival.elapsed() > MAX_SILENCE {
            let problem = format!(
                "no sound has come for {} s; is it still plugged in?",
                MAX_SILENCE.as_secs()
            );
            return Err(fault(&self.name, problem));
        }
        Ok(arrival)
    }
}

/// The device with this id, or the only one whose id or description contains this text.
fn find(host: &cpal::Host, name: &str) -> Result<cpal::Device> {
    let inputs = || {
        host.input_devices()
            .map_err(|reason| refused(name, &reason))
    };
    if let Some(device) = inputs()?.find(|device| id_of(device).as_deref() == Some(name)) {
        return Ok(device);
    }
    let wanted = name.to_lowercase();
    let mut matching: Vec<cpal::Device> = inputs()?
        .filter(|device| {
            let id = id_of(device).unwrap_or_default();
            [id, description(device)]
                .iter()
                .any(|text| text.to_lowercase().contains(&wanted))
        })
        .collect();
    let Some(device) = matching.pop() else {
        return Err(fault(name, "there is no such input device".to_owned()));
    };
    if matching.is_empty() {
        return Ok(device);
    }
    let ids: Vec<String> = matching.iter().chain([&device]).filter_map(id_of).collect();
    let problem = format!(
        "several devices have this in their name: {}; name one",
        ids.join(", ")
    );
    Err(fault(name, problem))
}

fn id_of(device: &cpal::Device) -> Option<String> {
    Some(device.id().ok()?.id().to_owned())
}

/// The first line of the system's description of a device.
fn description(device: &cpal::Device) -> String {
    device.description().map_or_else(
        |_| "unknown".to_owned(),
        |it| it.name().lines().next().unwrap_or_default().to_owned(),
    )
}

/// The requested size of the device's buffers: a tenth of a second, where the device allows it.
/// The delay does not matter, and a computer that is late by less than that loses no sound.
fn buffer(config: &SupportedStreamConfig) -> BufferSize {
    match *config.buffer_size() {
        SupportedBufferSize::Range { min, max } if min <= max => {
            BufferSize::Fixed((config.sample_rate() / 10).clamp(min, max))
        }
        _ => BufferSize::Default,
    }
}

/// The format of a WAV file that represents samples of a device without loss. A converter with 32-bit integers
/// uses at most 24 bits, which a float represents.
fn lossless(format: cpal::SampleFormat) -> SampleFormat {
    use cpal::SampleFormat as Device;
    match format {
        Device::I8 | Device::U8 | Device::I16 | Device::U16 => SampleFormat::Int16,
        Device::I24 | Device::U24 => SampleFormat::Int24,
        _ => SampleFormat::Float32,
    }
}

/// A stream, the end of the ring for its samples, and its faults.
type Started = (cpal::Stream, Taker, Arc<Faults>);

/// Starts the stream in the format of the device.
fn start(
    device: &cpal::Device,
    config: &SupportedStreamConfig,
    buffer_size: BufferSize,
) -> std::result::Result<Started, cpal::Error> {
    use cpal::SampleFormat as Device;
    let build = match config.sample_format() {
        Device::I8 => stream::<i8>,
        Device::U8 => stream::<u8>,
        Device::I16 => stream::<i16>,
        Device::U16 => stream::<u16>,
        Device::I24 => stream::<cpal::I24>,
        Device::U24 => stream::<cpal::U24>,
        Device::I32 => stream::<i32>,
        Device::U32 => stream::<u32>,
        Device::F64 => stream::<f64>,
        Device::F32 => stream::<f32>,
        _ => return Err(ErrorKind::UnsupportedOperation.into()),
    };
    let (feeder, taker) = handover(config.sample_rate(), usize::from(config.channels()));
    let faults = Arc::new(Faults::default());
    let config = cpal::StreamConfig {
        buffer_size,
        ..config.config()
    };
    let stream = build(device, config, feeder, &faults)?;
    stream.play()?;
    Ok((stream, taker, faults))
}

/// A stream that feeds samples of one type.
fn stream<T>(
    device: &cpal::Device,
    config: cpal::StreamConfig,
    mut feeder: Feeder,
    faults: &Arc<Faults>,
) -> std::result::Result<cpal::Stream, cpal::Error>
where
    T: SizedSample,
    f32: FromSample<T>,
{
    /// Time after which the system reports a device that sends nothing.
    const TIMEOUT: Duration = Duration::from_secs(1);
    let mut clock = Clock::new(&config);
    let seen = Arc::clone(faults);
    let mut interruptions = 0;
    let feed = move |samples: &[T], info: &cpal::InputCallbackInfo| {
        let missing = clock.missing_frames(info.timestamp().capture, samples.len());
        let now = seen.interruptions.load(Ordering::Acquire);
        if now != interruptions {
            interruptions = now;
            feeder.lose(missing);
        }
        feeder.feed(samples.iter().map(|sample| sample.to_sample::<f32>()));
    };
    let faults = Arc::clone(faults);
    let note = move |reason: cpal::Error| match reason.kind() {
        // The sound continues after a gap.
        ErrorKind::Xrun | ErrorKind::DeviceChanged | ErrorKind::BackendError => {
            faults.interruptions.fetch_add(1, Ordering::AcqRel);
        }
        // This makes gaps more likely; each is reported when it occurs.
        ErrorKind::RealtimeDenied => {}
        _ => {
            let _ = faults.end.set(reason);
        }
    };
    device.build_input_stream(config, feed, note, Some(TIMEOUT))
}

/// Computes how much sound is missing between buffers, by the time stamps of the device.
struct Clock {
    channels: usize,
    sample_rate_hz: f64,
    /// Time at which the next buffer should begin.
    next: Option<StreamInstant>,
}

impl Clock {
    fn new(config: &cpal::StreamConfig) -> Self {
        Self {
            channels: usize::from(config.channels),
            sample_rate_hz: f64::from(config.sample_rate),
            next: None,
        }
    }

    /// Number of frames that are missing between the last buffer and this one.
    fn missing_frames(&mut self, begin: StreamInstant, samples: usize) -> u64 {
        let frames = (samples / self.channels) as f64;
        let late_s = self.next.map_or(0.0, |next| {
            begin.saturating_duration_since(next).as_secs_f64()
        });
        self.next = begin.checked_add(Duration::from_secs_f64(frames / self.sample_rate_hz));
        (late_s * self.sample_rate_hz).round() as u64
    }
}

fn refused(name: &str, reason: &cpal::Error) -> Error {
    let advice = match reason.kind() {
        ErrorKind::DeviceBusy => "; another program uses it: close that first",
        ErrorKind::PermissionDenied => {
            "; allow this program to use the microphone in the settings of the system (on Linux, \
             join the group audio)"
        }
        ErrorKind::DeviceNotAvailable | ErrorKind::HostUnavailable => {
            "; is a microphone plugged in and switched on?"
        }
        _ => "",
    };
    let text = reason.to_string();
    fault(name, format!("{}{advice}", text.trim_end_matches('.')))
}

fn fault(name: &str, problem: String) -> Error {
    let name = if name.is_empty() { "(default)" } else { name };
    Error::Microphone {
        name: name.to_owned(),
        problem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_jump_of_the_clock_gives_the_missing_frames() {
        let config = cpal::StreamConfig {
            channels: 2,
            sample_rate: 48_000,
            buffer_size: cpal::BufferSize::Default,
        };
        let mut clock = Clock::new(&config);
        let at = StreamInstant::from_millis;
        // Buffers of 480 frames in stereo, 10 ms each; the third is 30 ms late, the last early.
        let missing: Vec<u64> = [0, 10, 50, 59]
            .map(|ms| clock.missing_frames(at(ms), 960))
            .to_vec();
        assert_eq!(missing, [0, 0, 1440, 0]);
    }
}
