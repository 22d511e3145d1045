//! Drops of all heights and balls, as sound.

use super::backgrounds::Kind;
use bouncelab::detection::{Detection, Detector};
use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, Noise, Rendered, Scene, Voice};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const GRAVITY: f64 = 9.81;

/// One cell of the grid: a scene, and a background beside that of the scene.
pub(crate) struct Cell {
    pub(crate) group: &'static str,
    pub(crate) name: String,
    pub(crate) scene: Scene,
    pub(crate) background: Option<(Kind, f64)>,
}

/// A recorded drop and its truth.
pub(crate) struct Recording {
    pub(crate) sound: Rendered,
    /// Noise and background together under the loudest impact, in dB.
    pub(crate) snr_db: f64,
}

/// A table-tennis drop in white noise at this signal-to-noise ratio.
pub(crate) fn usual(snr_db: f64) -> Scene {
    Scene {
        noise: Some(Noise::white(snr_db)),
        lead_in_s: 1.0,
        tail_s: 1.0,
        ..Scene::default()
    }
}

/// All cells.
pub(crate) fn cells() -> Vec<Cell> {
    use bouncelab::synth::{BitDepth, Clicks, Hum, Lost, Reverb};
    let mut cells = Vec::new();
    let mut add = |group, name: String, scene, background| {
        cells.push(Cell {
            group,
            name,
            scene,
            background,
        });
    };
    for voice in Voice::NAMES {
        for snr_db in [-5.0, 0.0, 5.0, 10.0, 20.0, 30.0, 40.0] {
            let voice_of = Voice::named(voice).unwrap_or_default();
            let scene = Scene {
                voice: voice_of,
                ..usual(snr_db)
            };
            add(
                "ball and noise",
                format!("{voice}, {snr_db} dB"),
                scene,
                None,
            );
        }
    }
    for rt60_s in [0.2, 0.5, 1.0, 2.0] {
        let reverb = Some(Reverb {
            rt60_s,
            direct_to_reverberant_db: 6.0,
        });
        let scene = Scene {
            reverb,
            ..usual(20.0)
        };
        add("reverberation", format!("{rt60_s} s"), scene, None);
    }
    for sample_rate_hz in [8_000, 16_000, 22_050, 48_000, 96_000] {
        let scene = Scene {
            sample_rate_hz,
            ..usual(20.0)
        };
        add("sample rate", format!("{sample_rate_hz} Hz"), scene, None);
    }
    for (name, bit_depth) in [("8 bit", BitDepth::Eight), ("24 bit", BitDepth::TwentyFour)] {
        let scene = Scene {
            bit_depth,
            ..usual(20.0)
        };
        add("bit depth", name.into(), scene, None);
    }
    let clipped = Scene {
        peak: 3.0,
        ..usual(20.0)
    };
    add(
        "bit depth",
        "16 bit, clipped by 10 dB".into(),
        clipped,
        None,
    );
    for rate_per_s in [0.3, 1.0, 3.0] {
        let clicks = Some(Clicks {
            rate_per_s,
            level_db: -6.0,
        });
        let scene = Scene {
            clicks,
            ..usual(20.0)
        };
        add("clicks", format!("{rate_per_s} a second"), scene, None);
    }
    for chance in [0.05, 0.1, 0.2] {
        let scene = Scene {
            lost: Lost::Chance(chance),
            ..usual(20.0)
        };
        add("lost impacts", format!("{} %", 100.0 * chance), scene, None);
    }
    for snr_db in [10.0, 20.0] {
        let pink = Scene {
            noise: Some(Noise::pink(snr_db)),
            ..usual(snr_db)
        };
        add("background", format!("pink, {snr_db} dB"), pink, None);
        let hum = Some(Hum {
            frequency_hz: 50.0,
            harmonics: 8,
            level_db: -snr_db,
        });
        let hum = Scene { hum, ..usual(40.0) };
        add("background", format!("hum, {snr_db} dB"), hum, None);
        for kind in [Kind::Speech, Kind::Music] {
            let name = format!("{}, {snr_db} dB", kind.name());
            add("background", name, usual(40.0), Some((kind, snr_db)));
        }
    }
    cells
}

/// The impacts of a drop down to bounces of 0.5 mm, its height and restitution drawn from a seed:
/// 10 cm to 1.5 m, and what such a ball keeps.
pub(crate) fn impact_events(seed: u64, voice: &Voice) -> Vec<ImpactEvent> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let height_m = 0.1 * 15.0_f64.powf(rng.random());
    let (least, most) = if *voice == Voice::steel_ball() {
        (0.85, 0.97)
    } else if *voice == Voice::table_tennis() {
        (0.85, 0.95)
    } else {
        (0.7, 0.87)
    };
    let restitution: f64 = least + (most - least) * rng.random::<f64>();
    let mut speed_m_s = (2.0 * GRAVITY * height_m).sqrt();
    let mut time_s = 0.0;
    let mut events = Vec::new();
    while speed_m_s * speed_m_s / (2.0 * GRAVITY) > 5e-4 {
        events.push(ImpactEvent { time_s, speed_m_s });
        // Real ratios scatter by half a percent or so.
        let scatter = 1.0 + 0.005 * (rng.random::<f64>() - 0.5) * 12f64.sqrt();
        speed_m_s *= restitution * scatter;
        time_s += 2.0 * speed_m_s / GRAVITY;
    }
    events
}

impl Cell {
    /// The recording of this seed.
    pub(crate) fn record(&self, seed: u64) -> Recording {
        let events = impact_events(seed, &self.scene.voice);
        let mut sound = synth::render(&events, &self.scene, seed)
            .unwrap_or_else(|e| panic!("{}: {e}", self.name));
        let mut snr_db = self.scene.noise.map_or(f64::INFINITY, |noise| noise.snr_db);
        if let Some(hum) = self.scene.hum {
            snr_db = snr_db.min(-hum.level_db);
        }
        if let Some((kind, background_db)) = self.background {
            // White noise of known distance tells how loud the loudest impact is.
            let rms = loudest_rms(&sound);
            kind.add(&mut sound, rms * 10f64.powf(-background_db / 20.0), seed);
            snr_db = snr_db.min(background_db);
        }
        Recording { sound, snr_db }
    }
}

/// Root mean square of the loudest impact over its first 5 ms.
fn loudest_rms(sound: &Rendered) -> f64 {
    let rate = f64::from(sound.sample_rate_hz);
    let audible = sound.impacts.iter().filter(|impact| !impact.lost);
    audible
        .map(|impact| {
            let first = (impact.time_s * rate).ceil() as usize;
            let samples = &sound.samples[first..first + (0.005 * rate) as usize];
            let energy: f64 = samples.iter().map(|&x| f64::from(x).powi(2)).sum();
            (energy / samples.len() as f64).sqrt()
        })
        .fold(0.0, f64::max)
}

impl Recording {
    /// Times of the impacts that are audible: those as loud as the background.
    pub(crate) fn audible(&self) -> Vec<f64> {
        let loudest = self.sound.impacts.iter().filter(|i| !i.lost);
        let loudest_db = loudest.map(|i| i.snr_db).fold(f64::NEG_INFINITY, f64::max);
        let audible = self
            .sound
            .impacts
            .iter()
            .filter(|i| !i.lost && i.snr_db - loudest_db + self.snr_db >= 0.0);
        audible.map(|i| i.time_s).collect()
    }

    /// The detections.
    pub(crate) fn detect(&self) -> Detection {
        detect(&self.sound.samples, self.sound.sample_rate_hz)
    }
}

/// The detections in these samples.
pub(crate) fn detect(samples: &[f32], sample_rate_hz: u32) -> Detection {
    let mut detector = Detector::new(sample_rate_hz, 1);
    detector.push(&[samples]);
    detector.finish()
}
