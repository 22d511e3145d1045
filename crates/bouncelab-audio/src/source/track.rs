//! The audio track of a file that is read: packets in, decoded frames out.

use std::collections::VecDeque;
use std::io::{self, SeekFrom};

use symphonia::core::codecs::CodecParameters;
use symphonia::core::codecs::audio::AudioCodecParameters;
use symphonia::core::codecs::audio::CODEC_ID_NULL_AUDIO;
use symphonia::core::codecs::audio::well_known::{CODEC_ID_ALAC, CODEC_ID_MP3, CODEC_ID_OPUS};
use symphonia::core::errors::Error as SymphoniaError;
use symphonia::core::formats::{FormatReader, Track as TrackInfo, TrackFlags, TrackType};
use symphonia::core::io::MediaSource;
use symphonia::core::meta::RawValue;
use symphonia::core::packet::Packet;
use symphonia::core::units::{Duration, TimeBase};

use super::codec::{self, Decoder, Layout, MAX_PACKET_FRAMES, Refusal};
use super::framing::{Framing, Missing};
use super::lost::{Clock, Lost};
use super::movie::{self, Edit, MovieTrack};
use super::presentation::Presentation;
use crate::contain::{contain_decoder, is_panic};
use crate::error::{Error, Result};
use crate::formats::{Length, SoundFormat};
use crate::problem::{MissingContent, Stage};

pub(super) struct Track {
    container: SoundFormat,
    reader: Box<dyn FormatReader>,
    info: TrackInfo,
    params: AudioCodecParameters,
    decoder: Decoder,
    edits: Vec<Edit>,
    /// What the tag of iTunes states in place of edits.
    itunes: Option<Presentation>,
    clock: Clock,
    framing: Framing,
    /// Packets that were read but not yet decoded.
    ahead: VecDeque<Pulled>,
    /// Number of packets that the decoder was given.
    packets: u64,
    /// Number of frames of the latest packet.
    packet_frames: u64,
    /// Whether sound was lost so far.
    has_lost: bool,
    /// The last error of demuxer or decoder.
    fault: Option<String>,
}

/// The next sound of a track.
pub(super) struct Step {
    /// The sound that was lost in front of it.
    pub(super) lost: Option<Lost>,
    pub(super) next: Next,
}

/// What follows in a track.
pub(super) enum Next {
    /// Sound of this layout.
    Sound(Layout),
    /// The end. Whether the file should be longer follows from the length that its container announces.
    End,
    /// Packets that cannot be read.
    Broken,
    /// The end of sound that differs from the encoded sound.
    Altered,
}

/// What the demuxer returned.
enum Pulled {
    Packet(Packet),
    End,
    Broken,
}

/// How much sound the container announces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Announced {
    pub(super) frames: u64,
    /// By how many seconds the sound may be shorter before it counts as cut short; `None` if the length is only estimated
    /// from the size of the file.
    pub(super) tolerance_s: Option<f64>,
}

impl Track {
    /// Opens a container and chooses its track: the default one among those that can be decoded,
    /// else the first of them.
    pub(super) fn open(
        container: SoundFormat,
        mut source: Box<dyn MediaSource>,
        mut framing: Framing,
        name: &str,
    ) -> Result<Self> {
        let mut movie = Vec::new();
        if container.has_edit_lists() {
            movie = movie::read(&mut source);
            source
                .seek(SeekFrom::Start(0))
                .map_err(|reason| Error::io(name, reason))?;
        }
        let mut reader = open_reader(container, source, name)?;
        let (info, params, decoder) = choose(reader.tracks(), container, &movie, name)?;
        let own_edits = movie.into_iter().find(|track| track.track_id == info.id);
        let is_own = |track: Option<u32>| track.is_none_or(|track| track == info.id);
        framing.breaks.retain(|missing| is_own(missing.track));
        // They are taken from the end of the list.
        framing.breaks.reverse();
        Ok(Self {
            container,
            itunes: itunes_gapless(reader.as_mut()),
            reader,
            edits: own_edits.map_or_else(Vec::new, |track| track.edits),
            info,
            clock: Clock::of(container, &params),
            params,
            decoder,
            framing,
            ahead: VecDeque::new(),
            packets: 0,
            packet_frames: 0,
            has_lost: false,
            fault: None,
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

    /// Whether the codec is lossless and has no checksum that would show damage.
    pub(super) fn is_plain(&self) -> bool {
        codec::is_plain(self.params.codec)
    }

    /// Whether frames of a stream differ from the encoded ones although none is missing.
    pub(super) fn is_altered(&self) -> bool {
        self.framing.is_altered
    }

    /// The decoded frames that are presented; `None` if the edit list cannot be followed.
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

    /// The decoded frames that are presented according to anything but edits.
    pub(super) fn unedited(&self) -> Presentation {
        if self.params.codec == CODEC_ID_OPUS {
            let head = codec::opus_head(&self.params);
            return Presentation::from_frame(head.map_or(0, |head| head.pre_skip));
        }
        if let Some(itunes) = &self.itunes {
            return itunes.clone();
        }
        // The tag of an MP3 file gives both ends, and so does the packet table of a CAF file.
        let has_ends = self.params.codec == CODEC_ID_MP3 || self.container == SoundFormat::Caf;
        match (self.info.delay, self.info.num_frames) {
            (Some(delay), Some(frames)) if has_ends => {
                let delay = u64::from(delay);
                Presentation::only(delay..delay.saturating_add(frames))
                    .unwrap_or_else(|| Presentation::from_frame(delay))
            }
            _ => Presentation::from_frame(0),
        }
    }

    /// How much presented sound the container announces.
    pub(super) fn announced(&self, layout: Layout, presented: &Presentation) -> Option<Announced> {
        /// Tolerance in seconds, where headers count packets or milliseconds.
        const COARSE_S: f64 = 0.05;
        let media = self.reader.media_info();
        let length = self.container.length();
        let frames = match length {
            Length::Tag | Length::Estimate => self.info.num_frames,
            Length::Duration => frames_lasting(layout, media.time_base, media.duration),
            Length::Exact | Length::Packets | Length::Coarse => self
                .info
                .num_frames
                .or_else(|| frames_lasting(layout, self.info.time_base, self.info.duration))
                .map(|decoded| presented.count(decoded)),
        };
        let tolerance_s = match length {
            Length::Exact => Some(0.0),
            Length::Packets => Some(self.packet_s()),
            Length::Coarse | Length::Duration => Some(COARSE_S),
            // Only the tag states a delay.
            Length::Tag => self.info.delay.map(|_| COARSE_S),
            Length::Estimate => None,
        };
        // A file that was written as a stream announces no length, for which some demuxers return zero.
        let frames = frames.filter(|frames| *frames > 0)?;
        Some(Announced {
            frames,
            tolerance_s,
        })
    }

    /// Length of a packet in seconds, zero for PCM: some encoders count the last packet as a whole one.
    fn packet_s(&self) -> f64 {
        let frames = self.params.max_frames_per_packet.unwrap_or(0);
        let rate_hz = f64::from(self.params.sample_rate.unwrap_or(0).max(1));
        if codec::is_pcm(self.params.codec) {
            0.0
        } else {
            frames as f64 / rate_hz
        }
    }

    /// The error for a track that ended before anything was decoded.
    pub(super) fn undecodable(&self, name: &str) -> Error {
        match self.fault.clone() {
            Some(detail) => malformed(self.container, name, Stage::Sound, detail),
            None => Error::Empty {
                name: name.to_owned(),
                what: MissingContent::Sound,
            },
        }
    }

    /// Reads and decodes up to the next sound and writes it into the planes.
    ///
    /// Sound that is lost on the way is added up: packets that are missing, that cannot be decoded, and that decode to
    /// wrong sound since they depend on missing ones.
    ///
    /// # Errors
    ///
    /// Only [`Error::Io`]: the system failed to read.
    pub(super) fn step(&mut self, name: &str, planes: &mut Vec<Vec<f32>>) -> Result<Step> {
        let mut lost: Option<Lost> = None;
        let mut warm_ups = 0;
        let has_clock = self.container.has_clock();
        loop {
            let packet = match self.pull(name)? {
                Pulled::Packet(packet) => packet,
                Pulled::End => return Ok(self.ended(lost)),
                Pulled::Broken => {
                    return Ok(Step {
                        lost,
                        next: Next::Broken,
                    });
                }
            };
            if let Some(more) = self.lost_before(&packet, lost.is_some(), name)? {
                lost = Some(more.after(lost));
                self.decoder.forget();
            }
            self.has_lost |= lost.is_some();
            match contain_decoder(|| self.decoder.decode(&packet, planes)) {
                Ok(layout) => {
                    let frames = planes.first().map_or(0, Vec::len) as u64;
                    if let (Some(lost), 0, false) = (&mut lost, frames, has_clock) {
                        // The first packet of Vorbis behind a loss gives no sound.
                        lost.frames += self.frames_in(&packet);
                    }
                    self.packet_frames = frames;
                    self.clock.advance(&self.info, &packet, frames, layout);
                    match &mut lost {
                        _ if frames == 0 => {}
                        // This sound depends on lost packets, so it is lost too.
                        Some(lost) if self.decoder.is_cold(planes, warm_ups) => {
                            lost.frames += frames;
                            warm_ups += 1;
                        }
                        _ => {
                            return Ok(Step {
                                lost,
                                next: Next::Sound(layout),
                            });
                        }
                    }
                }
                Err(fault) => {
                    self.fault = Some(fault.to_string());
                    if is_panic(&fault) {
                        return Ok(Step {
                            lost,
                            next: Next::Broken,
                        });
                    }
                    // With a clock, the time of the next packet gives the length of this one.
                    let frames = if has_clock {
                        0
                    } else {
                        self.frames_in(&packet)
                    };
                    lost = Some(Lost::certain(frames).after(lost));
                    warm_ups = 0;
                }
            }
        }
    }

    fn ended(&mut self, lost: Option<Lost>) -> Step {
        let next = if self.framing.is_cut {
            Next::Broken
        } else if lost.is_none() && !self.has_lost && self.decoder.is_altered() {
            Next::Altered
        } else {
            Next::End
        };
        Step { lost, next }
    }

    /// The next packet of the track.
    fn pull(&mut self, name: &str) -> Result<Pulled> {
        match self.ahead.pop_front() {
            Some(pulled) => Ok(pulled),
            None => self.read_on(name),
        }
    }

    fn read_on(&mut self, name: &str) -> Result<Pulled> {
        let fault = loop {
            match contain_decoder(|| self.reader.next_packet()) {
                Ok(Some(packet)) if packet.track_id == self.info.id => {
                    return Ok(Pulled::Packet(packet));
                }
                Ok(Some(_)) => {}
                Ok(None) => return Ok(self.ends()),
                // To some demuxers a file that was written as a stream ends unexpectedly.
                Err(SymphoniaError::IoError(fault))
                    if fault.kind() == io::ErrorKind::UnexpectedEof =>
                {
                    return Ok(self.ends());
                }
                // Demuxers report damage as system errors too; only those of the system have a number.
                Err(SymphoniaError::IoError(fault)) if fault.raw_os_error().is_some() => {
                    return Err(Error::io(name, fault));
                }
                Err(fault) => break fault,
            }
        };
        self.fault = Some(fault.to_string());
        Ok(Pulled::Broken)
    }

    /// The end of the packets. The last page of an Ogg file is marked, and the length follows from it: without a length
    /// that page is missing.
    fn ends(&self) -> Pulled {
        if self.container == SoundFormat::Ogg && self.info.num_frames.is_none() {
            Pulled::Broken
        } else {
            Pulled::End
        }
    }

    /// What was lost directly before this packet; `is_pending` if packets before it were lost already.
    fn lost_before(
        &mut self,
        packet: &Packet,
        is_pending: bool,
        name: &str,
    ) -> Result<Option<Lost>> {
        if self.container.has_clock() {
            return Ok(self.clock.lost_before(&self.info, packet, is_pending));
        }
        let packets = self.packets;
        self.packets += 1;
        let breaks = &mut self.framing.breaks;
        let Some(next) = breaks.pop_if(|next| next.packet <= packets) else {
            return Ok(None);
        };
        Ok(Some(match next.missing {
            Missing::Packets { count, certain } => Lost {
                frames: count * self.packet_frames,
                certain,
            },
            Missing::Ticks {
                passed,
                page_packets,
            } => {
                // The packets of the page are present; the rest of the time passed is missing.
                let ticks = ticks(packet) + self.ticks_ahead(page_packets - 1, name)?;
                Lost::certain(passed.saturating_sub(ticks))
            }
        }))
    }

    /// Length in ticks of the next packets, which are read ahead.
    fn ticks_ahead(&mut self, packets: u64, name: &str) -> Result<u64> {
        while (self.ahead.len() as u64) < packets {
            let pulled = self.read_on(name)?;
            let is_packet = matches!(pulled, Pulled::Packet(_));
            self.ahead.push_back(pulled);
            if !is_packet {
                break;
            }
        }
        let packets = self.ahead.iter().take(packets as usize);
        let ticks = packets.map(|pulled| match pulled {
            Pulled::Packet(packet) => ticks(packet),
            _ => 0,
        });
        Ok(ticks.sum())
    }

    /// Number of frames of a packet that cannot be decoded: that of the container or, where the container does not
    /// state it, as often in Matroska, that of the packet before.
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

/// Length in ticks of a packet of Ogg. The clock of its page counts what is trimmed from its start, too.
fn ticks(packet: &Packet) -> u64 {
    packet.dur.saturating_add(packet.trim_start).get()
}

/// Number of frames of a duration.
fn frames_lasting(
    layout: Layout,
    base: Option<TimeBase>,
    duration: Option<Duration>,
) -> Option<u64> {
    let seconds = base?.calc_duration(duration?)?.as_secs_f64();
    Some((seconds * f64::from(layout.sample_rate_hz)).round() as u64)
}

fn open_reader(
    container: SoundFormat,
    source: Box<dyn MediaSource>,
    name: &str,
) -> Result<Box<dyn FormatReader>> {
    contain_decoder(|| container.reader(source)).map_err(|fault| match fault {
        SymphoniaError::IoError(reason) if reason.raw_os_error().is_some() => {
            Error::io(name, reason)
        }
        // Other demuxers say this of damage too.
        SymphoniaError::Unsupported(what) if container.has_chunks() => Error::UnsupportedCodec {
            name: name.to_owned(),
            format: container.name(),
            codec: what.to_owned(),
        },
        fault => malformed(container, name, Stage::Header, fault.to_string()),
    })
}

/// The presented frames according to the tag iTunSMPB, which iTunes and others write in place of an edit list.
fn itunes_gapless(reader: &mut dyn FormatReader) -> Option<Presentation> {
    let mut metadata = reader.metadata();
    let tags = &metadata.skip_to_latest()?.media.tags;
    let tag = tags.iter().find(|tag| tag.raw.key.ends_with("iTunSMPB"))?;
    let RawValue::String(text) = &tag.raw.value else {
        return None;
    };
    parse_itunes_gapless(text)
}

/// Parses its hexadecimal fields: zero, delay, padding, number of presented frames, and more.
fn parse_itunes_gapless(text: &str) -> Option<Presentation> {
    let mut fields = text.split_ascii_whitespace().skip(1);
    let mut field = || u64::from_str_radix(fields.next()?, 16).ok();
    let (delay, _padding, presented) = (field()?, field()?, field()?);
    Presentation::only(delay..delay.checked_add(presented)?)
}

/// The best track that can be decoded, with its decoder.
fn choose(
    tracks: &[TrackInfo],
    container: SoundFormat,
    movie: &[MovieTrack],
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
        let mut params = params.clone();
        let entry = movie.iter().find(|track| track.track_id == info.id);
        let entry = entry.and_then(|track| track.sound.as_ref());
        if let Some(setup) = entry.and_then(|entry| entry.alac.as_ref())
            && params.codec == CODEC_ID_NULL_AUDIO
        {
            params.codec = CODEC_ID_ALAC;
            params.extra_data = Some(setup.clone().into());
        }
        if entry.is_some_and(|entry| entry.is_high_first)
            && let Some(codec) = entry.and_then(|entry| codec::high_byte_first(entry.codec))
        {
            // The demuxer takes the low byte to be first.
            params.codec = codec;
        }
        let made = contain_decoder(|| Ok(Decoder::new(&params)))
            .unwrap_or_else(|fault| Err(Refusal::Malformed(fault.to_string())));
        match made {
            Ok(decoder) => return Ok((info.clone(), params, decoder)),
            Err(refusal) => first_refusal = first_refusal.or(Some(refusal)),
        }
    }
    let is_unknown = match &first_refusal {
        Some(Refusal::Codec(codec)) => codec == codec::name(CODEC_ID_NULL_AUDIO),
        Some(Refusal::Malformed(_)) => false,
        None => true,
    };
    if let Some(entry) = movie.iter().find_map(|track| track.sound.as_ref())
        && is_unknown
    {
        first_refusal = Some(Refusal::Codec(codec::name_of_four_letters(entry.codec)));
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

fn malformed(container: SoundFormat, name: &str, stage: Stage, detail: String) -> Error {
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
