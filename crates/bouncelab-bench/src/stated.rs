//! What people state wrongly, or not at all, and surfaces that no law describes: drops simulated by the module `independent`.

use bouncelab::impact::ImpactEvent;
use bouncelab::settings::{BallSettings, Settings};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::independent::{
    BallOnSurface, KINDS, Kind, Law, Ring, between, log_between, normal, quiet,
};
use crate::misfit::{Case, Observed, Truth};
use crate::scenario::{MAX_IMPACTS, MIN_IMPACTS, SHORTEST_FLIGHT_S};

/// What is stated of a drop, and what is odd about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stated {
    /// The ball of any of six kinds, rightly.
    RightBall,
    /// Nothing of a ball of this place in the list of kinds.
    NoBall(usize),
    /// Another kind of ball.
    WrongBall,
    /// Mass and diameter of a hollow ball, nothing else.
    MassAndDiameter,
    /// The ball; the list has two impacts.
    TwoImpacts,
    /// The ball; one interval of the list is shorter than 2 ms.
    CloseImpacts,
    /// The ball; restitution is 1 - c v^(1/5) with c from 0.03 to 0.4.
    FifthPower,
    /// The ball; restitution is 15 % lower below 0.3 m/s.
    WorseWhenSlow,
    /// The ball; the list begins with another sound.
    OtherSoundFirst,
    /// The ball; in the recording something clicks before the drop.
    Click,
    /// The ball; the recording begins with the last impact of an earlier drop.
    EarlierDrop,
    /// The ball, and a height from which the first impact would have been missed; the recording is quiet before.
    WrongHeight,
    /// The ball and the height; the recording began after the first impacts.
    LateStart,
}

const NO_BALL: [&str; KINDS.len()] = [
    "no-ball-table-tennis",
    "no-ball-tennis",
    "no-ball-basketball",
    "no-ball-golf",
    "no-ball-marble",
    "no-ball-steel",
];

/// Heights from which balls fall, m.
const HEIGHTS_M: (f64, f64) = (0.15, 1.5);
/// Typical error of the times, s.
const TIME_SD_S: f64 = 5e-5;
/// Strengths of the losses that published balls show.
const LOSSES: (f64, f64) = (0.03, 0.4);
/// Recordings go on for this long after the last impact, s.
const TAIL_S: f64 = 0.7;
/// Amplitude of the loudest impact, and of the noise over it.
const LOUDEST: f64 = 0.3;
const NOISE: f64 = 3e-3;
/// Range of tones of impacts, and of other sounds, Hz.
const IMPACT_HZ: (f64, f64) = (1_500.0, 9_000.0);
const CLICK_HZ: (f64, f64) = (400.0, 4_000.0);
/// Standard uncertainty of a height that is measured, m; the library assumes as much.
const HEIGHT_SD_M: f64 = 0.002;

impl Stated {
    /// Every one.
    pub const ALL: [Self; 18] = [
        Self::RightBall,
        Self::NoBall(0),
        Self::NoBall(1),
        Self::NoBall(2),
        Self::NoBall(3),
        Self::NoBall(4),
        Self::NoBall(5),
        Self::WrongBall,
        Self::MassAndDiameter,
        Self::TwoImpacts,
        Self::CloseImpacts,
        Self::FifthPower,
        Self::WorseWhenSlow,
        Self::OtherSoundFirst,
        Self::Click,
        Self::EarlierDrop,
        Self::WrongHeight,
        Self::LateStart,
    ];

    /// Its name, as in arguments and tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::RightBall => "right-ball",
            Self::NoBall(kind) => NO_BALL[kind],
            Self::WrongBall => "wrong-ball",
            Self::MassAndDiameter => "mass-and-diameter",
            Self::TwoImpacts => "two-impacts",
            Self::CloseImpacts => "close-impacts",
            Self::FifthPower => "fifth-power",
            Self::WorseWhenSlow => "worse-when-slow",
            Self::OtherSoundFirst => "other-sound-first",
            Self::Click => "click",
            Self::EarlierDrop => "earlier-drop",
            Self::WrongHeight => "wrong-height",
            Self::LateStart => "late-start",
        }
    }

    fn ball_on_surface(self, rng: &mut ChaCha8Rng) -> BallOnSurface {
        let any = rng.random_range(0..KINDS.len());
        let mut simulated = BallOnSurface::of(
            match self {
                Self::NoBall(kind) => &KINDS[kind],
                // The hollow ones come first.
                Self::MassAndDiameter => &KINDS[any % 3],
                _ => &KINDS[any],
            },
            rng,
        );
        match self {
            Self::FifthPower => simulated.law = Law::FifthPower(log_between(LOSSES, rng)),
            Self::WorseWhenSlow => simulated.law = Law::WorseWhenSlow(between((0.75, 0.95), rng)),
            _ => {}
        }
        simulated
    }

    /// A drop as a list or a recording, with what is stated of it; `None` if it is too short to be detected.
    pub(crate) fn drawn(self, rng: &mut ChaCha8Rng) -> Option<Case> {
        let simulated = self.ball_on_surface(rng);
        let height_m = log_between(HEIGHTS_M, rng);
        let end = match self {
            // Below 0.3 m/s flights are shorter than 60 ms.
            Self::WorseWhenSlow => (MAX_IMPACTS, 0.03),
            _ => (MAX_IMPACTS, SHORTEST_FLIGHT_S),
        };
        let events = simulated.impact_events(height_m, end, rng);
        let first = events.first()?;
        let missed = match self {
            Self::LateStart => 1 + usize::from(rng.random::<f64>() < 0.3),
            _ => 0,
        };
        if events.len() < MIN_IMPACTS + missed {
            return None;
        }
        let mut settings = self.ball_settings(&simulated, rng);
        match self {
            // As if an impact were missed: higher by the energy that it takes.
            Self::WrongHeight => {
                let kept = simulated.law.at(first.speed_m_s).powi(2);
                settings.drop.height_m = Some(height_m / kept * (0.02 * normal(rng)).exp());
            }
            Self::LateStart => settings.drop.height_m = Some(height_m + HEIGHT_SD_M * normal(rng)),
            _ => {}
        }
        let observed = match self {
            Self::Click | Self::EarlierDrop | Self::WrongHeight | Self::LateStart => {
                self.recording(&simulated, &events, missed, rng)
            }
            _ => Observed::Times(self.list(&simulated, &events, rng)),
        };
        let law = simulated.law;
        Some(Case {
            observed,
            options: settings.resolve().ok()?.options,
            truth: Truth {
                restitution: Box::new(move |speed_m_s| law.at(speed_m_s)),
                middle_m_s: (first.speed_m_s * events.last()?.speed_m_s).sqrt(),
                height_m,
                rest_s: None,
                numbers: None,
            },
        })
    }

    fn ball_settings(self, simulated: &BallOnSurface, rng: &mut ChaCha8Rng) -> Settings {
        let sphere = &simulated.sphere;
        let stated = |kind: &Kind| Settings::of_ball(&(kind.stated)(sphere.diameter_m));
        match self {
            Self::NoBall(_) => Settings::default(),
            Self::WrongBall => {
                let others = KINDS
                    .iter()
                    .filter(|other| other.name != simulated.kind.name);
                let others: Vec<&Kind> = others.collect();
                stated(others[rng.random_range(0..others.len())])
            }
            Self::MassAndDiameter => Settings {
                ball: BallSettings {
                    mass_kg: Some(sphere.mass_kg),
                    diameter_m: Some(sphere.diameter_m),
                    ..BallSettings::default()
                },
                ..Settings::default()
            },
            _ => stated(simulated.kind),
        }
    }

    /// The times of a list, with errors.
    fn list(
        self,
        simulated: &BallOnSurface,
        events: &[ImpactEvent],
        rng: &mut ChaCha8Rng,
    ) -> Vec<f64> {
        let sd_s = TIME_SD_S * (0.7 * normal(rng)).exp();
        let mut times_s: Vec<f64> = events
            .iter()
            .map(|it| it.time_s + sd_s * normal(rng))
            .collect();
        match self {
            Self::TwoImpacts => times_s.truncate(2),
            Self::CloseImpacts => {
                let place = rng.random_range(1..times_s.len());
                let close_s = times_s[place] + between((0.3e-3, 1.9e-3), rng);
                times_s.insert(place + 1, close_s);
            }
            Self::OtherSoundFirst => times_s.insert(0, -before_s(simulated, events, rng)),
            _ => {}
        }
        times_s
    }

    /// The sound of these impacts in a quiet room.
    fn recording(
        self,
        simulated: &BallOnSurface,
        events: &[ImpactEvent],
        missed: usize,
        rng: &mut ChaCha8Rng,
    ) -> Observed {
        let begin_s = match self {
            Self::LateStart => {
                // Somewhere in the flight before the first impact that is heard.
                let flight_s = events[missed].time_s - events[missed - 1].time_s;
                events[missed].time_s - flight_s * between((0.1, 0.8), rng)
            }
            _ => -between((1.5, 3.0), rng),
        };
        let end_s = events.last().map_or(0.0, |last| last.time_s) + TAIL_S;
        let mut samples = quiet(end_s - begin_s, LOUDEST * NOISE, rng);
        let ring = Ring::of(IMPACT_HZ, rng);
        let loudest_m_s = events[missed].speed_m_s;
        let amplitude = |speed_m_s: f64, rng: &mut ChaCha8Rng| {
            LOUDEST / 4.0 * speed_m_s / loudest_m_s * (0.15 * normal(rng)).exp()
        };
        for event in &events[missed..] {
            let amplitude = amplitude(event.speed_m_s, rng);
            ring.sound(event.time_s - begin_s, amplitude, &mut samples);
        }
        let other_s = -begin_s - before_s(simulated, events, rng);
        match self {
            Self::Click => {
                let amplitude = LOUDEST / 4.0 * log_between((0.1, 1.0), rng);
                Ring::of(CLICK_HZ, rng).sound(other_s, amplitude, &mut samples);
            }
            Self::EarlierDrop => {
                let amplitude = amplitude(between((0.3, 1.0), rng), rng);
                ring.sound(other_s, amplitude, &mut samples);
            }
            _ => {}
        }
        Observed::Sound(samples)
    }
}

/// How long before the drop another sound comes, so that it may be taken for its first impact: as the law would have it,
/// within some per cent.
fn before_s(simulated: &BallOnSurface, events: &[ImpactEvent], rng: &mut ChaCha8Rng) -> f64 {
    let first_flight_s = events[1].time_s - events[0].time_s;
    first_flight_s / simulated.law.at(events[0].speed_m_s) * (0.05 * normal(rng)).exp()
}
