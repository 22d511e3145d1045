//! Recordings of a laboratory in which the truth is known.

use std::path::Path;

use bouncelab::analysis::Options;
use bouncelab::flight::FlightModel;
use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, Noise, Scene};
use bouncelab_audio::SampleFormat;

use crate::{bouncing, write_wav};

/// How a ball bounces from a surface: e = at 1 m/s times v^-p, with scatter.
#[derive(Debug, Clone, Copy)]
pub struct Truth {
    /// Restitution at 1 m/s.
    pub restitution: f64,
    /// How it falls with speed.
    pub exponent: f64,
    /// Standard deviation of the restitution from drop to drop.
    pub between_drops: f64,
    /// Standard deviation of ln e from impact to impact.
    pub between_impacts: f64,
}

impl Truth {
    /// The mean restitution at an impact speed.
    pub fn at(&self, speed_m_s: f64) -> f64 {
        self.restitution * speed_m_s.powf(-self.exponent)
    }

    /// Writes a recording of a drop of a table-tennis ball from a height; the seed decides all that
    /// is random.
    ///
    /// # Panics
    ///
    /// If the file cannot be written.
    pub fn record(&self, path: &Path, height_m: f64, lead_in_s: f64, seed: u64) {
        let events = self.impact_events(height_m, seed);
        let scene = Scene {
            noise: Some(Noise::pink(35.0)),
            lead_in_s,
            ..Scene::default()
        };
        let sound = synth::render(&events, &scene, seed).unwrap();
        write_wav(
            path,
            sound.sample_rate_hz,
            SampleFormat::Int16,
            &[&sound.samples],
        );
    }

    fn impact_events(&self, height_m: f64, seed: u64) -> Vec<ImpactEvent> {
        /// Slower than this the ball is at rest, m/s.
        const REST_M_S: f64 = 0.25;
        let settings = Options::default();
        let model = FlightModel::new(&settings.ball, &settings.environment).unwrap();
        let mut chance = Chance(seed);
        let offset = self.between_drops * chance.normal();
        let first_speed_m_s = model.fall(height_m).unwrap().impact_speed_m_s;
        let restitution = |speed_m_s: f64| {
            (self.at(speed_m_s) + offset) * (self.between_impacts * chance.normal()).exp()
        };
        bouncing(model, settings.contact_time_s, first_speed_m_s, restitution)
            .take_while(|event| event.speed_m_s > REST_M_S)
            .collect()
    }
}

/// Random numbers that are the same everywhere (`SplitMix64`, Steele, Lea and Flood 2014).
struct Chance(u64);

impl Chance {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Box and Muller (1958).
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }
}
