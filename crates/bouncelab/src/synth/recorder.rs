//! Effects of the recorder: offset, clipping, rounding.

use super::scene::{BitDepth, Scene};

/// Adds the offset, clips, and rounds to the levels of the bit depth.
pub(super) fn record(recording: &mut [f32], scene: &Scene) {
    let offset = scene.dc_offset as f32;
    let limit = scene.clip_at.map_or(f32::INFINITY, |level| level as f32);
    let store = quantiser(scene.bit_depth);
    for sample in recording {
        *sample = store((*sample + offset).clamp(-limit, limit));
    }
}

/// Rounds to the nearest of the 2^bits levels k / 2^(bits - 1), k from -2^(bits - 1).
fn quantiser(depth: BitDepth) -> impl Fn(f32) -> f32 {
    let levels = depth.bits().map(|bits| f64::from(1_u32 << (bits - 1)));
    move |sample| match levels {
        None => sample,
        Some(half) => {
            let level = (f64::from(sample) * half).round().clamp(-half, half - 1.0);
            (level / half) as f32
        }
    }
}
