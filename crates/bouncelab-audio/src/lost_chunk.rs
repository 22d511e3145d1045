//! Where a recorder lost sound, as a chunk of its WAV file.
//!
//! The chunk `lost` is in front of the samples, in a copy behind them. For each gap it has three numbers of 64 bits,
//! little-endian: the frame with which the silence in its place begins, how many frames of silence there are, and 1 if
//! that is the length of what is missing, else 0. Other programs skip what they do not know.

use bouncelab::analysis::Gap;

use crate::cues::chunk;

/// The name of the chunk.
pub(crate) const NAME: [u8; 4] = *b"lost";

/// The length of one gap in bytes.
pub(crate) const GAP_LEN: usize = 24;

/// The chunk of these gaps; nothing without any.
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

/// The gaps of the content of a chunk.
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
