//! ALAC packets to samples. They have no checksum, and most damaged ones decode without complaint.

use symphonia::core::codecs::audio::AudioDecoder;
use symphonia::core::errors::{Error, Result};
use symphonia::core::packet::Packet;

use super::codec::{self, Layout, has_run};

/// A decoder for one stream.
pub(super) struct Alac {
    inner: Box<dyn AudioDecoder>,
    /// Whether a packet was used to its end.
    is_tight: bool,
}

impl Alac {
    pub(super) fn new(inner: Box<dyn AudioDecoder>) -> Self {
        Self {
            inner,
            is_tight: false,
        }
    }

    /// Decodes one packet into one plane for each channel.
    pub(super) fn decode(&mut self, packet: &Packet, planes: &mut Vec<Vec<f32>>) -> Result<Layout> {
        let needs_all = self.needs_all(packet);
        let layout = codec::decode(self.inner.as_mut(), packet, planes)?;
        if self.is_tight && !needs_all {
            return Err(Error::DecodeError("ALAC packet that ends early"));
        }
        self.is_tight |= needs_all;
        // Without silence there is no row of zeros in a packet but those that were written over it.
        let is_flat = planes.iter().all(|plane| has_run(plane, &0.0));
        if has_run(&packet.data, &0) && !is_flat {
            return Err(Error::DecodeError("overwritten ALAC packet"));
        }
        if self.has_run_away(packet, planes) {
            return Err(Error::DecodeError("ALAC packet whose predictor runs away"));
        }
        Ok(layout)
    }

    /// Whether the sound is noise of full scale, which could not have been compressed: a changed bit that alters no
    /// length still alters what follows, and each value is predicted from those before.
    fn has_run_away(&self, packet: &Packet, planes: &[Vec<f32>]) -> bool {
        /// Of successive values of such noise a quarter differ by more than half of their range.
        const JUMPS: f64 = 0.1;
        const HALF_RANGE: f32 = 1.0;
        const COMPRESSED: f64 = 0.9;
        let bits = self.inner.codec_params().bits_per_sample.unwrap_or(0);
        // Not every container says it; recordings have 16 or more.
        let bits = f64::from(bits.max(16));
        let values: usize = planes.iter().map(Vec::len).sum();
        let is_compressed = 8.0 * (packet.data.len() as f64) < COMPRESSED * bits * values as f64;
        let jumps = |plane: &Vec<f32>| {
            let pairs = plane.windows(2);
            let far = pairs.filter(|pair| (pair[1] - pair[0]).abs() > HALF_RANGE);
            far.count() as f64 > JUMPS * plane.len() as f64
        };
        is_compressed && planes.iter().any(jumps)
    }

    /// Whether the packet cannot be decoded without its end: behind the sound are no more than an end
    /// mark of three bits and seven to the next byte. A changed bit alters the lengths of all codes that
    /// follow.
    fn needs_all(&mut self, packet: &Packet) -> bool {
        const LESS: usize = 2;
        let shorter = packet.data.len().saturating_sub(LESS);
        let data = packet.data[..shorter].to_vec();
        let packet = Packet::new(packet.track_id, packet.pts, packet.dur, data);
        self.inner.decode(&packet).is_err()
    }
}
