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

/// A device that can be listened to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Device {
    /// The name by which the system knows it.
    pub id: String,
    /// What it is, in words.
    pub description: String,
    /// Whether it is the one that is taken if none is named.
    pub is_default: bool,
}

/// The devices that can be listened to, as the system lists them. Whether one works is only known
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

/// A device that is being listened to.
///
/// The samples are those of the device, at its own rate and in its own number of channels. They
/// wait up to half a minute to be read; the thread that fetches them never waits for the reader.
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
        let mut said = f.debug_struct("Microphone");
        said.field("name", &self.name);
        said.field("sample_rate_hz", &self.sample_rate_hz);
        said.field("channels", &self.channels);
        said.finish_non_exhaustive()
    }
}

/// What the device reports beside samples.
#[derive(Default)]
struct Faults {
    /// How many times sound was interrupted.
    interruptions: AtomicU64,
    /// Why no more sound will come.
    end: OnceLock<cpal::Error>,
}

impl Microphone {
    /// Starts listening: to the system's default device, or to the one of this id, or of which
    /// this is a part of the id or description, in small or capital letters.
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

    /// The device in words.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Frames each second.
    pub fn sample_rate_hz(&self) -> u32 {
        self.sample_rate_hz
    }

    /// How many channels the device has.
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// The format of a WAV file that keeps all that the samples say.
    pub fn format(&self) -> SampleFormat {
        self.format
    }

    /// Takes what came since the last call, without waiting. Samples replace those in `planes`,
    /// which gets one plane for each channel.
    ///
    /// # Errors
    ///
    /// [`Error::Microphone`] once the device is gone, or has sent nothing for five seconds, and
    /// all that it sent before has been read.
    pub fn read(&mut self, planes: &mut Vec<Vec<f32>>) -> Result<Arrival> {
        /// Wireless devices take seconds to wake up.
        const PATIENCE: Duration = Duration::from_secs(5);
        // Looked at first: what came before the end is in the rings by now.
        let end = self.faults.end.get();
        let arrival = self.taker.take(planes);
        if arrival != Arrival::Nothing {
            self.last_arrival = Instant::now();
        } else if let Some(reason) = end {
            return Err(refused(&self.name, reason));
        } else if self.last_arrival.elapsed() > PATIENCE {
            let problem = format!(
                "no sound has come for {} s; is it still plugged in?",
                PATIENCE.as_secs()
            );
            return Err(fault(&self.name, problem));
        }
        Ok(arrival)
    }
}

/// The device of this id, or the only one of which this is a part of the id or description.
fn find(host: &cpal::Host, name: &str) -> Result<cpal::Device> {
    let inputs = || {
        host.input_devices()
            .map_err(|reason| refused(name, &reason))
    };
    if let Some(device) = inputs()?.find(|device| id_of(device).as_deref() == Some(name)) {
        return Ok(device);
    }
    let wanted = name.to_lowercase();
    let mut meant: Vec<cpal::Device> = inputs()?
        .filter(|device| {
            let id = id_of(device).unwrap_or_default();
            [id, description(device)]
                .iter()
                .any(|text| text.to_lowercase().contains(&wanted))
        })
        .collect();
    let Some(device) = meant.pop() else {
        return Err(fault(name, "there is no such input device".to_owned()));
    };
    if meant.is_empty() {
        return Ok(device);
    }
    let ids: Vec<String> = meant.iter().chain([&device]).filter_map(id_of).collect();
    let problem = format!("this may be any of {}; say which", ids.join(", "));
    Err(fault(name, problem))
}

fn id_of(device: &cpal::Device) -> Option<String> {
    Some(device.id().ok()?.id().to_owned())
}

/// The first line of what the system says of a device.
fn description(device: &cpal::Device) -> String {
    device.description().map_or_else(
        |_| "unknown".to_owned(),
        |it| it.name().lines().next().unwrap_or_default().to_owned(),
    )
}

/// The size of the device's buffers that is asked for: a tenth of a second, where the device can.
/// The delay does not matter, and a computer that is late by less loses nothing.
fn buffer(config: &SupportedStreamConfig) -> BufferSize {
    match *config.buffer_size() {
        SupportedBufferSize::Range { min, max } if min <= max => {
            BufferSize::Fixed((config.sample_rate() / 10).clamp(min, max))
        }
        _ => BufferSize::Default,
    }
}

/// The format of a WAV file that keeps all that samples of a device say. Of 32-bit integers a
/// converter fills 24 bits at most, which is what a float holds.
fn lossless(format: cpal::SampleFormat) -> SampleFormat {
    use cpal::SampleFormat as Device;
    match format {
        Device::I8 | Device::U8 | Device::I16 | Device::U16 => SampleFormat::Int16,
        Device::I24 | Device::U24 => SampleFormat::Int24,
        _ => SampleFormat::Float32,
    }
}

/// A stream, where its samples come out, and its faults.
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
    /// How often a device that sends nothing is looked after.
    const LOOK: Duration = Duration::from_secs(1);
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
        // Sound goes on, after a gap.
        ErrorKind::Xrun | ErrorKind::DeviceChanged | ErrorKind::BackendError => {
            faults.interruptions.fetch_add(1, Ordering::AcqRel);
        }
        // Gaps may become more likely; those that come are reported.
        ErrorKind::RealtimeDenied => {}
        _ => {
            let _ = faults.end.set(reason);
        }
    };
    device.build_input_stream(config, feed, note, Some(LOOK))
}

/// Tells from the time stamps of the device how much is missing between its buffers.
struct Clock {
    channels: usize,
    sample_rate_hz: f64,
    /// When the next buffer should begin.
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

    /// How many frames should have come between the last buffer and this one.
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
    let reason = reason.to_string();
    fault(name, format!("{}{advice}", reason.trim_end_matches('.')))
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
    fn a_clock_that_jumps_tells_how_much_is_missing() {
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
