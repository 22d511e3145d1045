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
        Ok(layout)
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
