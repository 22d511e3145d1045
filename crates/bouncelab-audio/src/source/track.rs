//! The one audio track of a file that is read: packets in, decoded frames out.

use std::io::{self, SeekFrom};

use symphonia::core::codecs::CodecParameters;
use symphonia::core::codecs::audio::AudioCodecParameters;
use symphonia::core::codecs::audio::well_known::{CODEC_ID_MP3, CODEC_ID_OPUS};
use symphonia::core::errors::Error as SymphoniaError;
use symphonia::core::formats::{FormatReader, Track as TrackInfo, TrackFlags, TrackType};
use symphonia::core::io::MediaSource;
use symphonia::core::meta::RawValue;
use symphonia::core::packet::Packet;
use symphonia::core::units::{Duration, TimeBase};

use super::codec::{self, Decoder, Layout, MAX_PACKET_FRAMES, Refusal};
use super::contain::{contain, is_panic};
use super::container::Container;
use super::edits::{self, Edit};
use super::presentation::Presentation;
use crate::error::{Error, Result};
use crate::problem::{MissingContent, Stage};

/// Packets that follow each other further apart than this have lost sound between them. Browsers
/// write whole milliseconds, and packets last 20 ms.
const GAP_S: f64 = 0.015;

pub(super) struct Track {
    container: Container,
    reader: Box<dyn FormatReader>,
    info: TrackInfo,
    params: AudioCodecParameters,
    decoder: Decoder,
    edits: Vec<Edit>,
    itunes: Option<Presentation>,
    clock: Clock,
    /// How many frames the latest packet held.
    packet_frames: u64,
}

/// What came of the next packet.
pub(super) enum Step {
    /// It was decoded. `missing_s` of sound were lost in front of it.
    Sound {
        layout: Layout,
        missing_s: Option<f64>,
    },
    /// It could not be decoded, and would have held about so many frames.
    Damaged { frames: u64, detail: String },
    /// There are no more. Whether there should be is told by what the container announced.
    End,
    /// There are more, but they cannot be read.
    Broken { detail: String },
}

/// How much sound the container announces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Announced {
    pub(super) frames: u64,
    /// Whether it is counted, not estimated from the size of the file.
    pub(super) exact: bool,
}

impl Track {
    /// Opens a container and chooses its track: the default one among those that can be decoded,
    /// else the first of them.
    pub(super) fn open(
        container: Container,
        mut source: Box<dyn MediaSource>,
        name: &str,
    ) -> Result<Self> {
        let mut edits = Vec::new();
        if container.has_edit_lists() {
            edits = edits::read(&mut source);
            source
                .seek(SeekFrom::Start(0))
                .map_err(|reason| Error::io(name, reason))?;
        }
        let mut reader = open_reader(container, source, name)?;
        let (info, params, decoder) = choose(reader.tracks(), container, name)?;
        let edits = edits.into_iter().find(|track| track.track_id == info.id);
        Ok(Self {
            container,
            itunes: itunes_gapless(reader.as_mut()),
            reader,
            edits: edits.map_or_else(Vec::new, |track| track.edits),
            info,
            params,
            decoder,
            clock: Clock::default(),
            packet_frames: 0,
        })
    }

    /// A description for people, for example "AAC in MOV" or "16-bit WAV".
    pub(super) fn format(&self) -> String {
        let container = self.container.name();
        match (codec::name(self.params.codec), self.params.bits_per_sample) {
            ("PCM", Some(bits)) => format!("{bits}-bit {container}"),
            (codec, _) if codec == container => codec.to_owned(),
            (codec, _) if codec.ends_with("float") => format!("{codec} {container}"),
            (codec, _) => format!("{codec} in {container}"),
        }
    }

    /// Which decoded frames are heard; `None` if the edit list cannot be followed.
    pub(super) fn presentation(&self, layout: Layout) -> Option<Presentation> {
        let rate = f64::from(layout.sample_rate_hz);
        if self.edits.is_empty() {
            return Some(self.unedited());
        }
        if self.edits.iter().any(|edit| edit.warped) {
            return None;
        }
        let frames = |seconds: f64| (seconds * rate).round() as u64;
        let stretch = |edit: &Edit| {
            let end = edit
                .duration_s
                .map_or(u64::MAX, |length| frames(edit.start_s + length));
            frames(edit.start_s)..end
        };
        Presentation::stretches(self.edits.iter().map(stretch).collect())
    }

    /// Which decoded frames are heard according to anything but edits.
    pub(super) fn unedited(&self) -> Presentation {
        if self.params.codec == CODEC_ID_OPUS {
            let head = codec::opus_head(&self.params);
            return Presentation::from_frame(head.map_or(0, |head| head.pre_skip));
        }
        if let Some(itunes) = &self.itunes {
            return itunes.clone();
        }
        match (self.params.codec, self.info.delay, self.info.num_frames) {
            // The tag of an MP3 file gives both ends.
            (CODEC_ID_MP3, Some(delay), Some(frames)) => {
                let delay = u64::from(delay);
                Presentation::only(delay..delay.saturating_add(frames))
                    .unwrap_or_else(|| Presentation::from_frame(delay))
            }
            _ => Presentation::from_frame(0),
        }
    }

    /// How much presented sound the container announces.
    pub(super) fn announced(&self, layout: Layout, presented: &Presentation) -> Option<Announced> {
        let media = self.reader.media_info();
        let frames = match self.container {
            // Counted in presented time.
            Container::Mpeg | Container::Adts => self.info.num_frames,
            Container::WebM | Container::Matroska => {
                frames_lasting(layout, media.time_base, media.duration)
            }
            // Counted in decoded time.
            _ => self
                .info
                .num_frames
                .or_else(|| frames_lasting(layout, self.info.time_base, self.info.duration))
                .map(|decoded| presented.count(decoded)),
        };
        let exact = match self.container {
            Container::Mpeg => self.info.delay.is_some(),
            Container::Adts => false,
            _ => true,
        };
        // A file written as a stream announces nothing, which some readers turn into zero.
        frames
            .filter(|frames| *frames > 0)
            .map(|frames| Announced { frames, exact })
    }

    /// The error for a track that ended before anything was decoded, with the last complaint.
    pub(super) fn undecodable(&self, name: &str, complaint: Option<String>) -> Error {
        match complaint {
            Some(detail) => malformed(self.container, name, Stage::Sound, detail),
            None => Error::Empty {
                name: name.to_owned(),
                what: MissingContent::Sound,
            },
        }
    }

    /// Reads and decodes the next packet into the planes.
    ///
    /// # Errors
    ///
    /// Only [`Error::Io`]: the system failed to read.
    pub(super) fn step(&mut self, name: &str, planes: &mut Vec<Vec<f32>>) -> Result<Step> {
        let packet = loop {
            match contain(|| self.reader.next_packet()) {
                Ok(Some(packet)) if packet.track_id == self.info.id => break packet,
                Ok(Some(_)) => {}
                // The last page of an Ogg file is marked, and tells the length.
                Ok(None) if self.container == Container::Ogg && self.info.num_frames.is_none() => {
                    let detail = "the last page is missing".to_owned();
                    return Ok(Step::Broken { detail });
                }
                Ok(None) => return Ok(Step::End),
                // Files that were written as a stream just stop, in the view of some readers.
                Err(SymphoniaError::IoError(fault))
                    if fault.kind() == io::ErrorKind::UnexpectedEof =>
                {
                    return Ok(Step::End);
                }
                // Readers report damage as made-up system errors too; the real ones have a number.
                Err(SymphoniaError::IoError(fault)) if fault.raw_os_error().is_some() => {
                    return Err(Error::io(name, fault));
                }
                Err(fault) => {
                    return Ok(Step::Broken {
                        detail: fault.to_string(),
                    });
                }
            }
        };
        match contain(|| self.decoder.decode(&packet, planes)) {
            Ok(layout) => {
                let frames = planes.first().map_or(0, Vec::len);
                self.packet_frames = frames as u64;
                let missing_s = self.clock.advance(&self.info, &packet, frames, layout);
                let missing_s = missing_s.filter(|_| self.container.has_clock());
                Ok(Step::Sound { layout, missing_s })
            }
            Err(fault) if is_panic(&fault) => Ok(Step::Broken {
                detail: fault.to_string(),
            }),
            Err(fault) => {
                self.clock = Clock::default();
                let frames = self.frames_in(&packet);
                Ok(Step::Damaged {
                    frames,
                    detail: fault.to_string(),
                })
            }
        }
    }

    /// How many frames a packet holds that cannot be decoded: as the container has it, or, as
    /// Matroska seldom says, as many as the one before.
    fn frames_in(&self, packet: &Packet) -> u64 {
        let base = self.info.time_base;
        let seconds = base.and_then(|base| base.calc_duration(packet.block_dur()));
        let rate = f64::from(self.params.sample_rate.unwrap_or(0));
        let frames = seconds.map_or(0.0, |seconds| (seconds.as_secs_f64() * rate).round());
        if frames > 0.0 {
            (frames as u64).min(MAX_PACKET_FRAMES)
        } else {
            self.packet_frames
        }
    }
}

/// Compares the container's clock with the count of frames.
#[derive(Default)]
struct Clock {
    /// When the next packet is due.
    due_s: Option<f64>,
}

impl Clock {
    /// Takes note of a decoded packet; how much sound is missing in front of it, if any.
    fn advance(
        &mut self,
        info: &TrackInfo,
        packet: &Packet,
        frames: usize,
        layout: Layout,
    ) -> Option<f64> {
        let time_s = info.time_base?.calc_time(packet.pts)?.as_secs_f64();
        let missing_s = self
            .due_s
            .map(|due_s| time_s - due_s)
            .filter(|gap| *gap > GAP_S);
        self.due_s = Some(time_s + frames as f64 / f64::from(layout.sample_rate_hz.max(1)));
        missing_s
    }
}

fn frames_lasting(
    layout: Layout,
    base: Option<TimeBase>,
    duration: Option<Duration>,
) -> Option<u64> {
    let seconds = base?.calc_duration(duration?)?.as_secs_f64();
    Some((seconds * f64::from(layout.sample_rate_hz)).round() as u64)
}

fn open_reader(
    container: Container,
    source: Box<dyn MediaSource>,
    name: &str,
) -> Result<Box<dyn FormatReader>> {
    contain(|| container.reader(source)).map_err(|fault| match fault {
        SymphoniaError::IoError(reason) if reason.raw_os_error().is_some() => {
            Error::io(name, reason)
        }
        fault => malformed(container, name, Stage::Header, fault.to_string()),
    })
}

/// What the iTunSMPB tag, which iTunes and others write instead of an edit list, says is heard.
fn itunes_gapless(reader: &mut dyn FormatReader) -> Option<Presentation> {
    let mut metadata = reader.metadata();
    let tags = &metadata.skip_to_latest()?.media.tags;
    let tag = tags.iter().find(|tag| tag.raw.key.ends_with("iTunSMPB"))?;
    let RawValue::String(text) = &tag.raw.value else {
        return None;
    };
    parse_itunes_gapless(text)
}

/// Hexadecimal fields: zero, delay, padding, frames that are heard, and more.
fn parse_itunes_gapless(text: &str) -> Option<Presentation> {
    let mut fields = text.split_ascii_whitespace().skip(1);
    let mut field = || u64::from_str_radix(fields.next()?, 16).ok();
    let (delay, _padding, heard) = (field()?, field()?, field()?);
    Presentation::only(delay..delay.checked_add(heard)?)
}

/// The best track that can be decoded, with its decoder.
fn choose(
    tracks: &[TrackInfo],
    container: Container,
    name: &str,
) -> Result<(TrackInfo, AudioCodecParameters, Decoder)> {
    let mut audio: Vec<_> = tracks
        .iter()
        .filter(|track| track.track_type() == Some(TrackType::Audio))
        .collect();
    audio.sort_by_key(|track| !track.flags.contains(TrackFlags::DEFAULT));
    let mut first_refusal = None;
    for info in audio {
        let Some(CodecParameters::Audio(params)) = &info.codec_params else {
            continue;
        };
        let made = contain(|| Ok(Decoder::new(params)))
            .unwrap_or_else(|fault| Err(Refusal::Malformed(fault.to_string())));
        match made {
            Ok(decoder) => return Ok((info.clone(), params.clone(), decoder)),
            Err(refusal) => first_refusal = first_refusal.or(Some(refusal)),
        }
    }
    Err(match first_refusal {
        Some(Refusal::Codec(codec)) => Error::UnsupportedCodec {
            name: name.to_owned(),
            format: container.name(),
            codec,
        },
        Some(Refusal::Malformed(detail)) => malformed(container, name, Stage::Codec, detail),
        None => Error::NoAudioTrack {
            name: name.to_owned(),
            format: container.name(),
        },
    })
}

fn malformed(container: Container, name: &str, stage: Stage, detail: String) -> Error {
    Error::Malformed {
        name: name.to_owned(),
        format: container.name(),
        stage,
        detail,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lost_sound_shows_as_a_jump_of_the_clock() {
        // Matroska: milliseconds, rounded; packets of 960 frames at 48 kHz last 20 ms.
        let mut info = TrackInfo::new(1);
        info.with_time_base(TimeBase::try_new(1, 1_000).unwrap());
        let layout = Layout {
            sample_rate_hz: 48_000,
            channels: 1,
        };
        let mut clock = Clock::default();
        let mut missing_before = |time_ms: i64| {
            let packet = Packet::new(1, time_ms.into(), Duration::new(20), Vec::new());
            clock.advance(&info, &packet, 960, layout)
        };
        for time_ms in [-7, 13, 34, 53] {
            assert_eq!(missing_before(time_ms), None, "{time_ms} ms");
        }
        let missing_s = missing_before(133).unwrap();
        assert!((missing_s - 0.06).abs() < 1e-9, "{missing_s} s");
        assert_eq!(missing_before(153), None);
    }

    #[test]
    fn the_itunes_tag_gives_both_ends() {
        // As written for a sound of 52920 frames behind 2112 of priming.
        let text = " 00000000 00000840 000000F8 000000000000CEB8 00000000 00000000";
        assert_eq!(parse_itunes_gapless(text), Presentation::only(2112..55_032));
        assert_eq!(parse_itunes_gapless(" 00000000 00000840"), None);
        assert_eq!(
            parse_itunes_gapless(" 0 FFFFFFFFFFFFFFFF 0 FFFFFFFFFFFFFFFF"),
            None
        );
    }
}
