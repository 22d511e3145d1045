//! Decodes packets of ALAC. They have no checksum, and most damaged packets decode without an error; so damage is
//! recognised by what no encoder writes.

use symphonia::core::codecs::audio::AudioDecoder;
use symphonia::core::errors::{Error, Result};
use symphonia::core::packet::Packet;

use super::codec::{self, Layout, has_run};

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
        // Only silence is encoded as a run of zeros; other runs of zeros were written over the packet.
        let is_silent = planes.iter().all(|plane| has_run(plane, &0.0));
        if has_run(&packet.data, &0) && !is_silent {
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
