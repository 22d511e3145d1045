//! Code shared by the tests, benchmarks and fuzz targets of the workspace.
//!
//! Only dev-dependencies point here, so no user of the other crates builds it. It panics where a
//! library would return an error: only tests call it.

mod checksum;
pub mod containers;
pub mod damage;
#[cfg(feature = "fuzz")]
pub mod fuzz;
pub mod hostile;
pub mod laboratory;

use std::fs;
use std::iter::successors;
use std::path::{Path, PathBuf};

use bouncelab::Options;
use bouncelab::drag::DragLaw;
use bouncelab::flight::FlightModel;
use bouncelab::gravity;
use bouncelab::impact::ImpactEvent;
use bouncelab_audio::{SampleFormat, encode_wav};

/// Writes a WAV file: one slice of samples for each channel, all of the same length.
///
/// # Panics
///
/// If it cannot be encoded or written.
pub fn write_wav(
    path: impl AsRef<Path>,
    sample_rate_hz: u32,
    format: SampleFormat,
    channels: &[&[f32]],
) {
    let wav = encode_wav(sample_rate_hz, format, channels).expect("samples of a WAV file");
    fs::write(path, wav).expect("a file that can be written");
}

/// The drag of a smooth sphere by the formula of Clift and Gauvin (1971), as a table up to a Reynolds number of 1e5.
///
/// # Panics
/// Never.
pub fn clift_gauvin() -> DragLaw {
    "table:100=1.0938,1000=0.4662,6200=0.3937,20000=0.4559,100000=0.4918"
        .parse()
        .expect("a drag table")
}

/// Flights of a table-tennis ball under this drag law, in ordinary air with buoyancy and added mass, with 9.81 m/s².
///
/// # Panics
///
/// If a constant coefficient is out of range.
pub fn table_tennis(drag: DragLaw) -> FlightModel {
    let options = Options::default().with_gravity_m_s2(9.81).with_drag(drag);
    options.model().expect("a law of a table-tennis ball")
}

/// The impacts of a drop without end, the first at time zero. `restitution` is asked at each impact
/// speed in m/s, so it may scatter, which the laws of the library do not.
pub fn bouncing(
    model: FlightModel,
    contact_time_s: f64,
    first_speed_m_s: f64,
    mut restitution: impl FnMut(f64) -> f64,
) -> impl Iterator<Item = ImpactEvent> {
    let first = ImpactEvent {
        time_s: 0.0,
        speed_m_s: first_speed_m_s,
    };
    successors(Some(first), move |impact| {
        let launch_m_s = restitution(impact.speed_m_s) * impact.speed_m_s;
        let flight = model.launch(launch_m_s).ok()?;
        Some(ImpactEvent {
            time_s: impact.time_s + contact_time_s + flight.time_s(),
            speed_m_s: flight.impact_speed_m_s,
        })
    })
}

/// The same without drag and contact time, and with a constant restitution.
///
/// # Panics
///
/// Never: gravity is above zero.
pub fn impact_events(first_speed_m_s: f64, restitution: f64) -> impl Iterator<Item = ImpactEvent> {
    let model = FlightModel::drag_free(gravity::STANDARD_M_S2).expect("gravity is above zero");
    bouncing(model, 0.0, first_speed_m_s, move |_| restitution)
}

/// The folder of real recordings that the environment names. They are not part of the project: the
/// tests that read them are ignored unless asked for, which `cargo xtask test` does where there are some.
///
/// # Panics
///
/// If `BOUNCELAB_RECORDINGS` is not set.
pub fn recordings() -> PathBuf {
    let folder = std::env::var_os("BOUNCELAB_RECORDINGS");
    folder
        .expect("BOUNCELAB_RECORDINGS names the folder of recordings")
        .into()
}
