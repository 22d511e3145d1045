//! Decodes packets of ALAC. They have no checksum, and most damaged packets decode without an error; so damage is
//! recognised by what no encoder writes.

use symphonia::core::codecs::audio::AudioDecoder;
use symphonia::core::errors::{Error, Result};
use symphonia::core::packet::Packet;

use super::codec::{self, Layout, runs};

/// The set-up of ALAC within a description of sound; its last four bytes are the rate.
pub(super) fn alac_setup(description: &[u8]) -> Option<&[u8]> {
    /// Its header: its size of 36 bytes, its name, version and flags.
    const HEADER: &[u8] = b"\0\0\0\x24alac\0\0\0\0";
    /// Bytes of the set-up behind that.
    const LEN: usize = 24;
    let at = description
        .windows(HEADER.len())
        .position(|it| it == HEADER)?;
    description[at + HEADER.len()..].get(..LEN)
}

/// A decoder for one stream.
pub(super) struct Alac {
    inner: Box<dyn AudioDecoder>,
    /// Whether an earlier packet could not be decoded without its last bytes, as packets of this encoder should.
    needs_last_bytes: bool,
}

impl Alac {
    pub(super) fn new(inner: Box<dyn AudioDecoder>) -> Self {
        Self {
            inner,
            needs_last_bytes: false,
        }
    }

    /// Decodes one packet into one plane for each channel.
    pub(super) fn decode(&mut self, packet: &Packet, planes: &mut Vec<Vec<f32>>) -> Result<Layout> {
        let needs_last_bytes = self.needs_last_bytes(packet);
        let layout = codec::decode(self.inner.as_mut(), packet, planes)?;
        if self.needs_last_bytes && !needs_last_bytes {
            return Err(Error::DecodeError("ALAC packet that ends early"));
        }
        self.needs_last_bytes |= needs_last_bytes;
        // Only silence is encoded as a run of zeros, and so are low bytes; other runs of zeros were written over the packet.
        let is_silent = planes.iter().all(|plane| runs(plane, &0.0) > 0);
        if runs(&packet.data, &0) > low_bytes(packet, planes) && !is_silent {
            return Err(Error::DecodeError("overwritten ALAC packet"));
        }
        if self.has_run_away(packet, planes) {
            return Err(Error::DecodeError("ALAC packet whose predictor runs away"));
        }
        Ok(layout)
    }

    /// Whether the sound is noise at full scale although the packet is compressed, which noise cannot be.
    ///
    /// Each sample is predicted from those before it. So a changed bit, even one that alters no code length, disturbs
    /// all samples behind it, until the predictor runs away.
    fn has_run_away(&self, packet: &Packet, planes: &[Vec<f32>]) -> bool {
        /// Minimum share of successive samples that differ by more than half of the range. In noise at full scale,
        /// uniform over the range, it is a quarter.
        const MIN_JUMPS: f64 = 0.1;
        /// Half of the range -1 to 1 of samples.
        const HALF_RANGE: f32 = 1.0;
        /// Maximum size of a compressed packet, as a share of its samples without compression.
        const MAX_COMPRESSED: f64 = 0.9;
        let stated_bits = self.inner.codec_params().bits_per_sample.unwrap_or(0);
        // Not every container states the number of bits; recordings have at least 16.
        let bits = f64::from(stated_bits.max(16));
        let values: usize = planes.iter().map(Vec::len).sum();
        let is_compressed =
            8.0 * (packet.data.len() as f64) < MAX_COMPRESSED * bits * values as f64;
        let jumps = |plane: &Vec<f32>| {
            let pairs = plane.windows(2);
            let far = pairs.filter(|pair| (pair[1] - pair[0]).abs() > HALF_RANGE);
            far.count() as f64 > MIN_JUMPS * plane.len() as f64
        };
        is_compressed && planes.iter().any(jumps)
    }

    /// Whether the packet cannot be decoded without its last bytes.
    ///
    /// In an intact packet only an end mark of three bits and up to seven bits of padding follow the sound. A changed
    /// bit alters the lengths of all codes behind it, so that the sound ends earlier.
    fn needs_last_bytes(&mut self, packet: &Packet) -> bool {
        /// More bytes than end mark and padding take.
        const LAST_BYTES: usize = 2;
        let shorter = packet.data.len().saturating_sub(LAST_BYTES);
        let data = packet.data[..shorter].to_vec();
        let packet = Packet::new(packet.track_id, packet.pts, packet.dur, data);
        self.inner.decode(&packet).is_err()
    }
}

/// Number of runs of zeros that are the low bytes of samples with no more than 16 bits in a stream of more.
///
/// An element of one or two channels stores its low bytes without compression, one sample after the other. How many bytes
/// these are of each sample stands behind 20 bits of the packet.
fn low_bytes(packet: &Packet, planes: &[Vec<f32>]) -> usize {
    const HALF_RANGE_16: f32 = 32_768.0;
    let has_low_bytes = packet.data.get(2).is_some_and(|byte| byte >> 2 & 3 > 0);
    let mut samples = planes.iter().flatten();
    let are_zero = has_low_bytes && samples.all(|it| (it * HALF_RANGE_16).fract() == 0.0);
    if are_zero {
        planes.len().div_ceil(2)
    } else {
        0
    }
}

#[cfg(test)]
mod tests {
    use symphonia::core::codecs::audio::well_known::CODEC_ID_ALAC;
    use symphonia::core::codecs::audio::{AudioCodecParameters, AudioDecoderOptions};
    use symphonia::core::units::{Duration, Timestamp};

    use super::*;

    /// Number of samples of a packet.
    const FRAMES: u32 = 4_096;
    /// What the set-up states of the length of codes: how fast it follows the sound, its start, and its maximum.
    const FOLLOW: u32 = 40;
    const START: u32 = 10;
    const MAX_LENGTH: u32 = 14;

    /// Bits, the first one highest.
    #[derive(Default)]
    struct Bits(Vec<bool>);

    impl Bits {
        fn push(&mut self, value: u32, count: u32) {
            self.0
                .extend((0..count).rev().map(|bit| value >> bit & 1 == 1));
        }

        fn bytes(&self) -> Vec<u8> {
            let byte = |bits: &[bool]| {
                let set = bits.iter().zip(0_u8..).filter(|(bit, _)| **bit);
                set.map(|(_, place)| 0x80_u8 >> place).sum()
            };
            self.0.chunks(8).map(byte).collect()
        }
    }

    /// A packet of one channel of 24 bits, whose low bytes are these, without prediction.
    fn packet(sound: impl Fn(u32) -> i32, low_byte: impl Fn(u32) -> u32) -> Vec<u8> {
        let mut bits = Bits::default();
        // Element, its number, unused, whole length, one low byte, compressed.
        for (value, count) in [(0, 3), (0, 4), (0, 12), (0, 1), (1, 2), (0, 1)] {
            bits.push(value, count);
        }
        // Mixing of channels, then mode, shift, factor of the codes, and no coefficient.
        for (value, count) in [(0, 16), (0, 4), (9, 4), (4, 3), (0, 5)] {
            bits.push(value, count);
        }
        (0..FRAMES).for_each(|frame| bits.push(low_byte(frame), 8));
        // The adaptive codes of Golomb and Rice (Apple's reference, `ag_enc.c`), for sound that is never near zero.
        let mut mean = START;
        for frame in 0..FRAMES {
            let value = sound(frame);
            let folded = 2 * value.unsigned_abs() - u32::from(value < 0);
            let length = ((mean >> 9) + 3).ilog2().min(MAX_LENGTH);
            let divisor = (1 << length) - 1;
            let (ones, rest) = (folded / divisor, folded % divisor);
            if ones >= 9 {
                bits.push(0x1ff, 9);
                bits.push(folded, 16);
            } else {
                bits.push((1 << ones) - 1, ones);
                bits.push(0, 1);
                if rest == 0 {
                    bits.push(0, length - 1);
                } else {
                    bits.push(rest + 1, length);
                }
            }
            mean = mean + FOLLOW * folded - ((FOLLOW * mean) >> 9);
        }
        bits.push(7, 3);
        bits.bytes()
    }

    fn decode(data: Vec<u8>) -> Result<Vec<f32>> {
        let mut setup = FRAMES.to_be_bytes().to_vec();
        setup.extend([
            0,
            24,
            FOLLOW as u8,
            START as u8,
            MAX_LENGTH as u8,
            1,
            0,
            255,
        ]);
        setup.extend([0, 0, 44_100].map(u32::to_be_bytes).concat());
        let mut params = AudioCodecParameters::new();
        params
            .for_codec(CODEC_ID_ALAC)
            .with_extra_data(setup.into());
        let codecs = symphonia::default::get_codecs();
        let decoder = codecs.make_audio_decoder(&params, &AudioDecoderOptions::default())?;
        let packet = Packet::new(0, Timestamp::new(0), Duration::new(4_096), data);
        let mut planes = Vec::new();
        Alac::new(decoder).decode(&packet, &mut planes)?;
        Ok(planes.remove(0))
    }

    /// Between 500 and 999 of either sign.
    fn sound(frame: u32) -> i32 {
        let value = (500 + frame * 37 % 500).cast_signed();
        if frame.is_multiple_of(3) {
            -value
        } else {
            value
        }
    }

    #[test]
    fn sound_of_16_bits_in_24_bits_is_not_damaged() {
        let samples = decode(packet(sound, |_| 0)).unwrap();
        for (frame, sample) in (0..FRAMES).zip(samples) {
            let expected = sound(frame) as f32 / 32_768.0;
            assert!((sample - expected).abs() < 1e-9, "{frame}: {sample}");
        }
    }

    /// Among the low bytes.
    #[test]
    fn zeros_over_sound_of_24_bits_are_damage() {
        let noise = |frame: u32| frame * 91 % 251 + 1;
        assert!(decode(packet(sound, noise)).is_ok());
        let mut low = packet(sound, noise);
        low[1_000..1_300].fill(0);
        assert!(decode(low).is_err());
    }
}
