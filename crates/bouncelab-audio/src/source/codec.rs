//! Decodes packets to samples, with one interface for all codecs.

use symphonia::core::audio::Channels;
use symphonia::core::codecs::audio::well_known::{
    CODEC_ID_AAC, CODEC_ID_AC3, CODEC_ID_ADPCM_IMA_QT, CODEC_ID_ADPCM_IMA_WAV, CODEC_ID_ADPCM_MS,
    CODEC_ID_ALAC, CODEC_ID_EAC3, CODEC_ID_FLAC, CODEC_ID_MP3, CODEC_ID_OPUS, CODEC_ID_PCM_ALAW,
    CODEC_ID_PCM_F32BE, CODEC_ID_PCM_F32LE, CODEC_ID_PCM_F64BE, CODEC_ID_PCM_F64LE,
    CODEC_ID_PCM_MULAW, CODEC_ID_PCM_S16LE, CODEC_ID_PCM_S24BE, CODEC_ID_PCM_S32BE,
    CODEC_ID_PCM_S32LE, CODEC_ID_VORBIS,
};
use symphonia::core::codecs::audio::{
    AudioCodecId, AudioCodecParameters, AudioDecoder, AudioDecoderOptions, CODEC_ID_NULL_AUDIO,
};
use symphonia::core::errors::{Error as SymphoniaError, Result as SymphoniaResult};
use symphonia::core::packet::Packet;

use super::alac::Alac;
use super::opus;

/// Maximum number of channels: more than any recorder has, and few enough to hold a block of each.
pub(super) const MAX_CHANNELS: usize = 64;

/// Maximum number of frames in a packet: no codec has more, but damaged headers ask for gigabytes.
pub(super) const MAX_PACKET_FRAMES: u64 = 1 << 16;

/// A decoder for one track.
pub(super) enum Decoder {
    Symphonia(Box<dyn AudioDecoder>, AudioCodecId),
    Alac(Alac),
    Opus(Box<opus::Decoder>),
    /// 16-bit samples with the low byte first, as most recorders write them. Decoding all samples of a packet in one
    /// loop is several times as fast as the general decoder.
    Pcm16(Layout),
}

/// Rate and channels of decoded sound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) sample_rate_hz: u32,
    pub(super) channels: usize,
}

/// Why a decoder could not be made.
pub(super) enum Refusal {
    /// The codec, or this use of it, is not supported.
    Codec(String),
    /// The parameters contradict themselves.
    Malformed(String),
}

impl Decoder {
    /// A decoder for this track.
    pub(super) fn new(params: &AudioCodecParameters) -> Result<Self, Refusal> {
        if params.codec == CODEC_ID_OPUS {
            let head = opus_head(params).map_err(Refusal::Codec)?;
            let decoder = opus::Decoder::new(head).map_err(Refusal::Malformed)?;
            return Ok(Self::Opus(Box::new(decoder)));
        }
        check_sizes(params)?;
        let mut params = params.clone();
        if matches!(params.codec, CODEC_ID_PCM_ALAW | CODEC_ID_PCM_MULAW) {
            // CAF states the bits of the coded sample, and the decoder expects those of the decoded one.
            (params.bits_per_sample, params.bits_per_coded_sample) = (None, None);
        }
        let params = &params;
        let codecs = symphonia::default::get_codecs();
        if codecs.get_audio_decoder(params.codec).is_none() {
            return Err(Refusal::Codec(name(params.codec).to_owned()));
        }
        // The decoder of Vorbis returns one packet less than it is given, which only its own trimming accounts for. All
        // other encoder delays are removed here, by what the container states: the trimming of
        // MP3 would also cut the end of files whose length is only estimated.
        let options = AudioDecoderOptions::default()
            .gapless(params.codec == CODEC_ID_VORBIS)
            .verify(params.codec == CODEC_ID_FLAC);
        match codecs.make_audio_decoder(params, &options) {
            Ok(decoder) if params.codec == CODEC_ID_ALAC => Ok(Self::Alac(Alac::new(decoder))),
            Ok(decoder) => Ok(match pcm16(params) {
                Some(layout) => Self::Pcm16(layout),
                None => Self::Symphonia(decoder, params.codec),
            }),
            Err(SymphoniaError::Unsupported(why)) => {
                Err(Refusal::Codec(format!("{} ({why})", name(params.codec))))
            }
            Err(fault) => Err(Refusal::Malformed(fault.to_string())),
        }
    }

    /// Decodes one packet into one plane for each channel. An empty result is not an error:
    /// some codecs need a packet to start.
    pub(super) fn decode(
        &mut self,
        packet: &Packet,
        planes: &mut Vec<Vec<f32>>,
    ) -> SymphoniaResult<Layout> {
        match self {
            Self::Symphonia(decoder, _) => decode(decoder.as_mut(), packet, planes),
            Self::Alac(decoder) => decoder.decode(packet, planes),
            Self::Pcm16(layout) => {
                decode_pcm16(&packet.data, layout.channels, planes);
                Ok(*layout)
            }
            Self::Opus(decoder) => {
                decoder.decode(&packet.data, planes)?;
                let frames = planes.first().map_or(0, Vec::len);
                let padding = packet.trim_end.get() as usize;
                for plane in planes.iter_mut() {
                    plane.truncate(frames.saturating_sub(padding));
                }
                Ok(Layout {
                    sample_rate_hz: u32::from(opus::SAMPLE_RATE_HZ),
                    channels: planes.len(),
                })
            }
        }
    }
}

impl Decoder {
    /// Resets the decoder where the next packet does not continue the one before.
    pub(super) fn forget(&mut self) {
        // Vorbis is not reset: the next packet would give no sound, since its overlap with the packet before is lost.
        if let Self::Symphonia(decoder, CODEC_ID_AAC | CODEC_ID_MP3) = self {
            decoder.reset();
        }
    }

    /// Whether sound that was decoded after a loss still depends on the lost packets, `warm_ups` being the number of
    /// packets since the loss that did.
    pub(super) fn is_cold(&self, planes: &[Vec<f32>], warm_ups: u32) -> bool {
        /// Maximum number of packets that depend on lost ones: a packet of MP3 refers to up to 511 bytes of earlier
        /// packets, and is silent where they are missing.
        const MAX_WARM_UPS: u32 = 4;
        let has_memory = match self {
            Self::Symphonia(_, codec) => {
                matches!(*codec, CODEC_ID_AAC | CODEC_ID_MP3 | CODEC_ID_VORBIS)
            }
            Self::Opus(_) => true,
            Self::Alac(_) | Self::Pcm16(_) => false,
        };
        let begins_silent = || planes.iter().all(|plane| plane.first() == Some(&0.0));
        has_memory && (warm_ups == 0 || warm_ups < MAX_WARM_UPS && begins_silent())
    }

    /// Whether a checksum shows that the decoded sound differs from the encoded sound.
    pub(super) fn is_altered(&mut self) -> bool {
        match self {
            Self::Symphonia(decoder, _) => decoder.finalize().verify_ok == Some(false),
            Self::Opus(_) | Self::Alac(_) | Self::Pcm16(_) => false,
        }
    }
}

/// Decodes one packet into one plane for each channel.
pub(super) fn decode(
    decoder: &mut dyn AudioDecoder,
    packet: &Packet,
    planes: &mut Vec<Vec<f32>>,
) -> SymphoniaResult<Layout> {
    let decoded = decoder.decode(packet)?;
    decoded.copy_to_vecs_planar(planes);
    let spec = decoded.spec();
    Ok(Layout {
        sample_rate_hz: spec.rate(),
        channels: spec.channels().count(),
    })
}

/// The layout of 16-bit samples with the low byte first, all of whose bits are used; `None` for other samples.
fn pcm16(params: &AudioCodecParameters) -> Option<Layout> {
    let all_count = |bits: Option<u32>| bits.is_none_or(|bits| bits == 16);
    let is_whole = all_count(params.bits_per_sample) && all_count(params.bits_per_coded_sample);
    if params.codec != CODEC_ID_PCM_S16LE || !is_whole {
        return None;
    }
    Some(Layout {
        sample_rate_hz: params.sample_rate?,
        channels: params.channels.as_ref()?.count(),
    })
}

/// Turns interleaved 16-bit samples into one plane for each channel. An incomplete frame at the end is left out.
fn decode_pcm16(data: &[u8], channels: usize, planes: &mut Vec<Vec<f32>>) {
    let value = |bytes: &[u8; 2]| f32::from(i16::from_le_bytes(*bytes)) / 32_768.0;
    let (samples, _) = data.as_chunks::<2>();
    planes.resize_with(channels, Vec::new);
    planes.iter_mut().for_each(Vec::clear);
    if let [plane] = &mut planes[..] {
        plane.extend(samples.iter().map(value));
        return;
    }
    for (channel, plane) in planes.iter_mut().enumerate() {
        let frames = samples.chunks_exact(channels);
        plane.extend(frames.map(|frame| value(&frame[channel])));
    }
}

/// Refuses headers that would make a decoder claim absurd amounts of memory.
fn check_sizes(params: &AudioCodecParameters) -> Result<(), Refusal> {
    let channels = params.channels.as_ref().map_or(0, Channels::count);
    if channels > MAX_CHANNELS {
        return Err(Refusal::Codec(format!(
            "{channels} channels, more than {MAX_CHANNELS}"
        )));
    }
    // The ALAC set-up starts with the frames in a packet.
    let alac_frames = match (params.codec, params.extra_data.as_deref()) {
        (CODEC_ID_ALAC, Some([a, b, c, d, ..])) => u32::from_be_bytes([*a, *b, *c, *d]),
        _ => 0,
    };
    let frames = params
        .max_frames_per_packet
        .unwrap_or(0)
        .max(u64::from(alac_frames));
    if frames > MAX_PACKET_FRAMES {
        return Err(Refusal::Malformed(format!("packets of {frames} frames")));
    }
    Ok(())
}

/// The header of an Opus track, which holds its delay and gain.
pub(super) fn opus_head(params: &AudioCodecParameters) -> Result<opus::Head, String> {
    opus::Head::parse(params.extra_data.as_deref().unwrap_or_default())
}

/// Number of runs of one value that are too long for the samples or bytes of noisy sound.
pub(super) fn runs<T: PartialEq>(values: &[T], value: &T) -> usize {
    /// Length of such a run, in values.
    const MIN_RUN: usize = 64;
    let runs = values.split(|other| other != value);
    runs.filter(|run| run.len() >= MIN_RUN).count()
}

/// Whether the codec is lossless and has no checksum that would show damage: PCM and ALAC.
pub(super) fn is_plain(codec: AudioCodecId) -> bool {
    codec == CODEC_ID_ALAC || is_pcm(codec)
}

/// Whether the codec stores one number for each sample.
pub(super) fn is_pcm(codec: AudioCodecId) -> bool {
    (CODEC_ID_PCM_S32LE..=CODEC_ID_PCM_F64BE).contains(&codec)
}

/// The usual name of a codec.
pub(super) fn name(codec: AudioCodecId) -> &'static str {
    match codec {
        CODEC_ID_AAC => "AAC",
        CODEC_ID_ALAC => "ALAC",
        CODEC_ID_FLAC => "FLAC",
        CODEC_ID_MP3 => "MP3",
        CODEC_ID_OPUS => "Opus",
        CODEC_ID_VORBIS => "Vorbis",
        CODEC_ID_AC3 => "AC-3",
        CODEC_ID_EAC3 => "E-AC-3",
        CODEC_ID_PCM_F32LE | CODEC_ID_PCM_F32BE => "32-bit float",
        CODEC_ID_PCM_F64LE | CODEC_ID_PCM_F64BE => "64-bit float",
        CODEC_ID_PCM_ALAW => "A-law",
        CODEC_ID_PCM_MULAW => "mu-law",
        CODEC_ID_ADPCM_MS | CODEC_ID_ADPCM_IMA_WAV | CODEC_ID_ADPCM_IMA_QT => "ADPCM",
        id if (CODEC_ID_PCM_S32LE..CODEC_ID_PCM_F32LE).contains(&id) => "PCM",
        CODEC_ID_NULL_AUDIO => "an unknown codec",
        _ => "another codec",
    }
}

/// The name of a codec that is not decoded, from the four letters of MP4 and its relatives.
pub(super) fn name_of_four_letters(letters: [u8; 4]) -> String {
    match &letters {
        b"samr" => "AMR".to_owned(),
        b"sawb" => "AMR-WB".to_owned(),
        b"sevc" => "EVRC".to_owned(),
        b"sqcp" => "QCELP".to_owned(),
        b"alaw" => name(CODEC_ID_PCM_ALAW).to_owned(),
        b"ulaw" => name(CODEC_ID_PCM_MULAW).to_owned(),
        b"ima4" => name(CODEC_ID_ADPCM_IMA_QT).to_owned(),
        b"ac-3" => name(CODEC_ID_AC3).to_owned(),
        b"ec-3" => name(CODEC_ID_EAC3).to_owned(),
        b"enca" => "encrypted sound".to_owned(),
        letters => format!("the codec {:?}", letters.escape_ascii().to_string()),
    }
}

/// The codec of samples with the high byte first, by the four letters of `QuickTime` that do not state which is first.
pub(super) fn high_byte_first(letters: [u8; 4]) -> Option<AudioCodecId> {
    match &letters {
        b"in24" => Some(CODEC_ID_PCM_S24BE),
        b"in32" => Some(CODEC_ID_PCM_S32BE),
        b"fl32" => Some(CODEC_ID_PCM_F32BE),
        b"fl64" => Some(CODEC_ID_PCM_F64BE),
        _ => None,
    }
}

/// The name of a codec by its number in WAV and AVI (`WAVEFORMATEX`).
pub(super) fn name_of_number(number: u16) -> String {
    let name = match number {
        1 => "PCM",
        2 | 0x11 => "ADPCM",
        3 => "floating point",
        6 => "A-law",
        7 => "mu-law",
        0x31 => "GSM",
        0x50 => "MP2",
        0x55 => "MP3",
        0xff => "AAC",
        0x160 | 0x161 => "WMA",
        0x2000 => "AC-3",
        0x2001 => "DTS",
        _ => return format!("the codec {number:#06x}"),
    };
    name.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Full scale is one, and half a frame at the end is left out, whatever the planes held before.
    #[test]
    fn samples_of_16_bits_are_shares_of_full_scale() {
        let samples: [i16; 5] = [0, i16::MIN, i16::MAX, 16_384, -1];
        let bytes: Vec<u8> = samples.iter().flat_map(|it| it.to_le_bytes()).collect();
        let shares = samples.map(|it| f32::from(it) / 32_768.0);
        let mut planes = vec![vec![7.0]; 3];
        decode_pcm16(&bytes[..9], 1, &mut planes);
        assert_eq!(planes, [&shares[..4]]);
        decode_pcm16(&bytes, 2, &mut planes);
        assert_eq!(planes, [[0.0, shares[2]], [-1.0, 0.5]]);
    }
}
