//! Decodes packets of Opus.

use opus_pure::OpusDecoder;
use symphonia::core::errors::{Error, Result as SymphoniaResult};

use super::codec::runs;

/// Sample rate of the decoded sound in Hz, whatever the rate of the microphone was.
pub(super) const SAMPLE_RATE_HZ: u16 = 48_000;

/// Maximum number of frames in a packet: 120 ms (RFC 6716 section 3.2.5).
const MAX_FRAMES: usize = SAMPLE_RATE_HZ as usize * 120 / 1_000;

/// The identification header, RFC 7845 section 5.1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Head {
    pub(super) channels: usize,
    /// Frames at the start that only warm the decoder up.
    pub(super) pre_skip: u64,
    /// Linear gain for the whole stream.
    gain: f32,
}

impl Head {
    /// Parses the header; the error states why the sound cannot be decoded.
    pub(super) fn parse(header: &[u8]) -> Result<Self, String> {
        let fields = header
            .strip_prefix(b"OpusHead")
            .and_then(<[u8]>::first_chunk::<11>)
            .ok_or("the Opus header is incomplete")?;
        let [
            _version,
            channels,
            skip_low,
            skip_high,
            ..,
            gain_low,
            gain_high,
            family,
        ] = *fields;
        match (family, channels) {
            (0, 1 | 2) => Ok(Self {
                channels: usize::from(channels),
                pre_skip: u64::from(u16::from_le_bytes([skip_low, skip_high])),
                // Q7.8 decibels.
                gain: 10_f32.powf(f32::from(i16::from_le_bytes([gain_low, gain_high])) / 5120.0),
            }),
            _ => Err(format!(
                "Opus with {channels} channels in mapping family {family}"
            )),
        }
    }
}

/// A decoder for one stream.
pub(super) struct Decoder {
    inner: OpusDecoder,
    head: Head,
    interleaved: Vec<f32>,
    /// Number of frames of the latest packet, and number of successive packets of that length.
    latest: (usize, u32),
}

impl Decoder {
    pub(super) fn new(head: Head) -> Result<Self, String> {
        let inner = OpusDecoder::new(i32::from(SAMPLE_RATE_HZ), head.channels)
            .map_err(|e| e.to_string())?;
        Ok(Self {
            inner,
            head,
            interleaved: vec![0.0; MAX_FRAMES * head.channels],
            latest: (0, 0),
        })
    }

    /// Decodes one packet into one plane for each channel.
    pub(super) fn decode(
        &mut self,
        packet: &[u8],
        planes: &mut Vec<Vec<f32>>,
    ) -> SymphoniaResult<()> {
        // The decoder conceals a lost packet where it gets an empty one; in a file an empty packet is damage.
        if packet.is_empty() {
            return Err(Error::DecodeError("empty Opus packet"));
        }
        // Only padding, which the first two bytes announce (RFC 6716 section 3.2.5), is a run of zeros.
        let is_padded = packet[0] & 3 == 3 && packet.get(1).is_some_and(|count| count & 0x40 != 0);
        if runs(packet, &0) > 0 && !is_padded {
            return Err(Error::DecodeError("overwritten Opus packet"));
        }
        let channels = self.head.channels;
        let frames = self
            .inner
            .decode(packet, MAX_FRAMES, &mut self.interleaved)
            .map_err(|_| Error::DecodeError("damaged Opus packet"))?;
        self.check_length(frames)?;
        let samples = &self.interleaved[..frames * channels];
        planes.resize(channels, Vec::new());
        for (channel, plane) in planes.iter_mut().enumerate() {
            plane.clear();
            let own = samples.iter().skip(channel).step_by(channels);
            plane.extend(own.map(|sample| sample * self.head.gain));
        }
        Ok(())
    }

    /// Refuses a packet of another length than those before. The decoder accepts any bytes as a packet of some length,
    /// but recorders write packets of one length.
    fn check_length(&mut self, frames: usize) -> SymphoniaResult<()> {
        /// Minimum number of successive packets of equal length after which another length is damage.
        const MIN_EQUAL: u32 = 8;
        match &mut self.latest {
            (length, count) if *length == frames => *count += 1,
            (_, MIN_EQUAL..) => return Err(Error::DecodeError("Opus packet of another length")),
            latest => *latest = (frames, 1),
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(channels: u8, pre_skip: u16, gain: i16, family: u8) -> Vec<u8> {
        let mut header = b"OpusHead\x01".to_vec();
        header.push(channels);
        header.extend(pre_skip.to_le_bytes());
        header.extend(44_100_u32.to_le_bytes());
        header.extend(gain.to_le_bytes());
        header.push(family);
        header
    }

    #[test]
    fn gain_is_read_as_decibels_in_steps_of_one_256th() {
        let head = Head::parse(&header(2, 312, -6 * 256, 0)).unwrap();
        assert_eq!((head.channels, head.pre_skip), (2, 312));
        assert!(
            (head.gain - 0.501_187).abs() < 1e-6,
            "-6 dB is {}",
            head.gain
        );
    }

    #[test]
    fn surround_and_broken_headers_are_refused() {
        assert!(
            Head::parse(&header(6, 312, 0, 1))
                .unwrap_err()
                .contains("6 channels")
        );
        assert!(Head::parse(&header(2, 312, 0, 0)[..15]).is_err());
        assert!(Head::parse(b"").is_err());
    }
}
