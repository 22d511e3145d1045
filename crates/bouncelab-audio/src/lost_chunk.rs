//! The gaps of a recording as a chunk of a WAV file.
//!
//! [`Recorder`](crate::Recorder) writes the chunk `lost` in front of the samples, [`copy_with_cues`](crate::copy_with_cues)
//! behind them. For each gap it has three little-endian numbers of 64 bits: the frame with which the silence in its place
//! begins, the number of frames of silence, and 1 if that is certainly the number of missing frames, else 0. Other
//! programs skip chunks that they do not know.

use bouncelab::analysis::Gap;

use crate::wav::chunk;

/// The name of the chunk.
pub(crate) const NAME: [u8; 4] = *b"lost";

/// The length of one gap in bytes.
pub(crate) const GAP_LEN: usize = 24;

/// The chunk of these gaps; empty without gaps.
pub(crate) fn encode(gaps: &[Gap], sample_rate_hz: u32) -> Vec<u8> {
    let frames = |time_s: f64| (time_s * f64::from(sample_rate_hz)).round() as u64;
    let fields = gaps.iter().flat_map(|gap| {
        [
            frames(gap.start_s),
            frames(gap.duration_s),
            gap.certain.into(),
        ]
    });
    let content: Vec<u8> = fields.flat_map(u64::to_le_bytes).collect();
    if content.is_empty() {
        return content;
    }
    chunk(NAME, &content)
}

/// The gaps in the content of a chunk.
pub(crate) fn decode(content: &[u8], sample_rate_hz: u32) -> Vec<Gap> {
    let seconds = |frames: [u8; 8]| u64::from_le_bytes(frames) as f64 / f64::from(sample_rate_hz);
    let (fields, _) = content.as_chunks::<8>();
    let gaps = fields.chunks_exact(3).map(|gap| Gap {
        start_s: seconds(gap[0]),
        duration_s: seconds(gap[1]),
        certain: gap[2] == 1_u64.to_le_bytes(),
    });
    gaps.collect()
}
