//! The sound of an impact: decaying modes of ball and surface.

use crate::error::{Quantity, Result, positive, positive_up_to, within};

/// One ringing mode of the ball or of the surface: a sine that decays exponentially.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// Frequency in hertz; positive. A mode at or above half the sample rate is left out.
    pub frequency_hz: f64,
    /// Time in seconds in which the amplitude falls to 1/e; above 0, at most 1.
    pub decay_s: f64,
    /// Amplitude relative to the other modes of the same voice; positive.
    pub level: f64,
}

impl Mode {
    /// A mode from its frequency, its 1/e decay time and its relative amplitude.
    pub const fn new(frequency_hz: f64, decay_s: f64, level: f64) -> Self {
        Self {
            frequency_hz,
            decay_s,
            level,
        }
    }
}

/// The sound of a ball on a surface.
///
/// The presets are plausible rather than measured: their frequencies and decays resemble
/// what ordinary recordings show, and vary from ball to ball and from table to table.
///
/// ```
/// use bouncelab::synth::{Mode, Voice};
///
/// let glass_marble = Voice {
///     modes: vec![Mode::new(900.0, 0.004, 0.5), Mode::new(6_300.0, 0.003, 1.0)],
///     contact_time_s: 60e-6,
///     ..Voice::steel_ball()
/// };
/// assert_eq!(glass_marble.level_exponent, 1.2);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Voice {
    /// The ringing modes; at least one.
    pub modes: Vec<Mode>,
    /// How long ball and surface touch, in seconds; above 0, at most 0.1.
    pub contact_time_s: f64,
    /// The part of the contact over which the sound rises, 0 to 1.
    ///
    /// The rise is a quarter period of a squared sine: smooth at both ends, so that it adds
    /// little above the modes themselves. It takes at least two samples, the rise of an
    /// anti-alias filter.
    pub attack: f64,
    /// The exponent p in: sound pressure is proportional to (impact speed)^p; 0 to 4.
    ///
    /// A linear surface has p = 1. Where contact follows Hertz, the peak force, and with it the
    /// sound, goes as the speed to the power 6/5.
    pub level_exponent: f64,
}

impl Voice {
    /// The names that [`Voice::named`] knows.
    pub const NAMES: [&'static str; 4] = ["table-tennis", "steel-ball", "basketball", "tennis"];

    /// The preset of this name, one of [`Voice::NAMES`].
    ///
    /// ```
    /// use bouncelab::synth::Voice;
    ///
    /// assert_eq!(Voice::named("tennis"), Some(Voice::tennis()));
    /// assert!(Voice::NAMES.into_iter().all(|name| Voice::named(name).is_some()));
    /// ```
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "table-tennis" => Some(Self::table_tennis()),
            "steel-ball" => Some(Self::steel_ball()),
            "basketball" => Some(Self::basketball()),
            "tennis" => Some(Self::tennis()),
            _ => None,
        }
    }

    /// A table-tennis ball on a table or counter: the board's thump below 1.5 kHz under the
    /// short bright click of the shell, 8 to 13 kHz.
    pub fn table_tennis() -> Self {
        Self {
            modes: vec![
                Mode::new(350.0, 8e-3, 0.5),
                Mode::new(680.0, 6e-3, 0.6),
                Mode::new(1_150.0, 5e-3, 0.6),
                Mode::new(8_300.0, 2.5e-3, 1.0),
                Mode::new(9_800.0, 2e-3, 0.8),
                Mode::new(12_900.0, 1.5e-3, 0.5),
            ],
            contact_time_s: 1e-3,
            attack: 0.1,
            level_exponent: 1.0,
        }
    }

    /// A steel bearing ball of about a centimetre on a thick plate: a contact of some tens of
    /// microseconds that excites the plate up to the highest modes.
    pub fn steel_ball() -> Self {
        Self {
            modes: vec![
                Mode::new(270.0, 10e-3, 0.6),
                Mode::new(805.0, 9e-3, 0.7),
                Mode::new(1_630.0, 8e-3, 0.6),
                Mode::new(4_700.0, 6e-3, 1.0),
                Mode::new(9_400.0, 4e-3, 0.7),
            ],
            contact_time_s: 50e-6,
            attack: 0.5,
            level_exponent: 1.2,
        }
    }

    /// A basketball on a wooden floor: a low thump, and the ring of the air inside.
    ///
    /// The lowest mode of air in a rigid sphere of radius a has 2 pi f a / c = 2.0816
    /// (Rayleigh), 950 Hz for a = 0.12 m.
    pub fn basketball() -> Self {
        Self {
            modes: vec![
                Mode::new(65.0, 20e-3, 1.0),
                Mode::new(245.0, 15e-3, 0.6),
                Mode::new(420.0, 12e-3, 0.6),
                Mode::new(950.0, 20e-3, 0.3),
                Mode::new(1_350.0, 8e-3, 0.15),
            ],
            contact_time_s: 15e-3,
            attack: 0.1,
            level_exponent: 1.0,
        }
    }

    /// A tennis ball, or soft rubber, on a hard floor: a dull thump with hardly anything
    /// above 1.5 kHz.
    pub fn tennis() -> Self {
        Self {
            modes: vec![
                Mode::new(120.0, 10e-3, 0.7),
                Mode::new(200.0, 8e-3, 1.0),
                Mode::new(280.0, 7e-3, 0.7),
                Mode::new(960.0, 5e-3, 0.6),
                Mode::new(1_130.0, 4e-3, 0.5),
            ],
            contact_time_s: 5e-3,
            attack: 0.1,
            level_exponent: 1.0,
        }
    }

    pub(super) fn check(&self) -> Result<()> {
        within(Quantity::Modes, self.modes.len() as f64, 1.0..=1000.0)?;
        for mode in &self.modes {
            positive(Quantity::ModeFrequency, mode.frequency_hz)?;
            positive_up_to(Quantity::DecayTime, mode.decay_s, 1.0)?;
            positive(Quantity::ModeLevel, mode.level)?;
        }
        positive_up_to(Quantity::ContactTime, self.contact_time_s, 0.1)?;
        within(Quantity::Attack, self.attack, 0.0..=1.0)?;
        within(Quantity::LevelExponent, self.level_exponent, 0.0..=4.0)?;
        Ok(())
    }
}

impl Default for Voice {
    fn default() -> Self {
        Self::table_tennis()
    }
}
