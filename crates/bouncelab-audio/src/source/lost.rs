//! How much sound is missing, by the times of packets.

use symphonia::core::codecs::audio::AudioCodecParameters;
use symphonia::core::formats::Track as TrackInfo;
use symphonia::core::packet::Packet;

use super::codec::Layout;
use crate::formats::SoundFormat;

/// Sound that is missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lost {
    /// Number of frames, as far as it is known.
    pub(super) frames: u64,
    /// Whether that number is certain.
    pub(super) certain: bool,
}

impl Lost {
    pub(super) fn certain(frames: u64) -> Self {
        Self {
            frames,
            certain: true,
        }
    }

    pub(super) fn unknown() -> Self {
        Self {
            frames: 0,
            certain: false,
        }
    }

    /// This loss together with the one directly before it.
    pub(super) fn after(self, before: Option<Self>) -> Self {
        let before = before.unwrap_or(Self::certain(0));
        Self {
            frames: self.frames.saturating_add(before.frames),
            certain: self.certain && before.certain,
        }
    }
}

/// Compares the container's clock with the count of frames.
pub(super) struct Clock {
    /// Time at which the next packet should begin, in seconds.
    due_s: Option<f64>,
    /// Whether no packet was taken yet.
    is_first: bool,
    /// Whether the clock counts frames, so that times are exact.
    is_exact: bool,
    /// A packet that is later than this has lost sound in front of it, in seconds.
    tolerance_s: f64,
    rate_hz: f64,
}

/// Maximum lateness of a packet without a loss, as a share of the length of the packet before. A lost packet makes the
/// next one late by its whole length.
const MAX_LATENESS: f64 = 0.6;
/// Maximum lateness without a loss, in seconds: packets that browsers write are late by some milliseconds.
const MAX_TOLERANCE_S: f64 = 0.015;
/// Minimum of the tolerance, in seconds: the distance of two times in whole milliseconds is uncertain by one.
const MIN_TOLERANCE_S: f64 = 0.0015;

/// Maximum length of a loss, in seconds: a clock that jumps further is damaged itself.
const MAX_LOSS_S: f64 = 600.0;

/// Maximum time of the first packet with a loss in front of it, in seconds: a recording that begins later was cut out
/// of a longer one.
const MAX_START_S: f64 = 1.0;

impl Clock {
    pub(super) fn of(container: SoundFormat, params: &AudioCodecParameters) -> Self {
        // A frame of FLAC states the number of its first sample, which is 0 for the first frame.
        let is_exact = container == SoundFormat::Flac;
        Self {
            due_s: is_exact.then_some(0.0),
            is_first: true,
            is_exact,
            tolerance_s: if is_exact { 0.0 } else { MAX_TOLERANCE_S },
            rate_hz: f64::from(params.sample_rate.unwrap_or(0)),
        }
    }

    /// What was lost directly before this packet; `is_pending` if packets before it were lost already.
    pub(super) fn lost_before(
        &self,
        info: &TrackInfo,
        packet: &Packet,
        is_pending: bool,
    ) -> Option<Lost> {
        let late_s = time_s(info, packet)? - self.due_s?;
        // Behind a loss that is known already, any lateness belongs to it.
        let tolerance_s = if is_pending { 0.0 } else { self.tolerance_s };
        let frames = (late_s * self.rate_hz).round();
        if self.is_first && late_s > MAX_START_S {
            None
        } else if !(-MAX_TOLERANCE_S..=MAX_LOSS_S).contains(&late_s) {
            Some(Lost::unknown())
        } else {
            (late_s > tolerance_s && frames > 0.0).then(|| Lost::certain(frames as u64))
        }
    }

    /// Advances by a packet of `frames` frames.
    pub(super) fn advance(
        &mut self,
        info: &TrackInfo,
        packet: &Packet,
        frames: u64,
        layout: Layout,
    ) {
        self.is_first = false;
        self.rate_hz = f64::from(layout.sample_rate_hz.max(1));
        let length_s = frames as f64 / self.rate_hz;
        self.due_s = time_s(info, packet).map(|time_s| time_s + length_s);
        if frames > 0 && !self.is_exact {
            self.tolerance_s = (MAX_LATENESS * length_s).clamp(MIN_TOLERANCE_S, MAX_TOLERANCE_S);
        }
    }
}

fn time_s(info: &TrackInfo, packet: &Packet) -> Option<f64> {
    Some(info.time_base?.calc_time(packet.pts)?.as_secs_f64())
}

#[cfg(test)]
mod tests {
    use symphonia::core::units::{Duration, TimeBase};

    use super::*;

    /// What is lost before each packet of `frames` frames at 48 kHz, by its time.
    ///
    /// The clock is that of Matroska: milliseconds, rounded.
    fn lost_before(frames: u64) -> impl FnMut(i64) -> Option<Lost> {
        let mut info = TrackInfo::new(1);
        info.with_time_base(TimeBase::try_new(1, 1_000).unwrap());
        let layout = Layout {
            sample_rate_hz: 48_000,
            channels: 1,
        };
        let mut clock = Clock::of(SoundFormat::WebM, &AudioCodecParameters::new());
        move |time_ms: i64| {
            let packet = Packet::new(1, time_ms.into(), Duration::new(20), Vec::new());
            let lost = clock.lost_before(&info, &packet, false);
            clock.advance(&info, &packet, frames, layout);
            lost
        }
    }

    /// Opus has packets of 2.5 to 60 ms.
    #[test]
    fn one_lost_packet_of_any_length_is_noticed() {
        for frames in [120, 240, 480, 960, 1_920, 2_880] {
            for lost in 1..20_u64 {
                let mut lost_before = lost_before(frames);
                let time_ms = |number: u64| (number * frames / 48).cast_signed();
                for number in (0..20).filter(|&number| number != lost) {
                    let found = lost_before(time_ms(number));
                    assert_eq!(found.is_some(), number == lost + 1, "{frames}: {number}");
                    // To a millisecond.
                    let missing = found.map_or(frames, |found| found.frames);
                    assert!(missing.abs_diff(frames) <= 48, "{frames}: {missing}");
                }
            }
        }
    }

    #[test]
    fn lost_sound_shows_as_a_jump_of_the_clock() {
        // Packets of 20 ms.
        let mut lost_before = lost_before(960);
        for time_ms in [-7, 13, 34, 53] {
            assert_eq!(lost_before(time_ms), None, "{time_ms} ms");
        }
        assert_eq!(lost_before(133), Some(Lost::certain(2_880)));
        assert_eq!(lost_before(153), None);
        // Back, or by hours: the clock is damaged.
        assert_eq!(lost_before(53), Some(Lost::unknown()));
        assert_eq!(lost_before(10_000_000), Some(Lost::unknown()));
    }
}
