//! Zeros that were written over sound, or stand where a recorder lost some: nothing but a few stretches in
//! a recording whose noise is never silent.

/// A stretch that is this long is no chance, in frames.
const LONG: usize = 64;

/// With more stretches than this, or a greater share of the recording in them, silence belongs to it: of
/// a noise gate, or of a source without background noise.
const MOST: u64 = 3;
const MOST_SHARE: f64 = 0.1;

/// The stretches in which all channels are zero.
#[derive(Debug, Default)]
pub(super) struct Blanks {
    places: u64,
    first: u64,
    frames: u64,
    /// How many of the latest frames are zero.
    open: usize,
    /// How many frames were taken.
    all: u64,
}

impl Blanks {
    /// Takes the frames from this one on. A stretch has a frame at every step of its length, so that
    /// few frames are looked at.
    pub(super) fn take(&mut self, at: u64, planes: &[Vec<f32>]) {
        let len = planes.first().map_or(0, Vec::len);
        let is_zero = |frame: &usize| planes.iter().all(|plane| plane[*frame] == 0.0);
        let zeros_from = |frame: usize| (frame..len).take_while(is_zero).count();
        self.all = at + len as u64;
        let mut seen = zeros_from(0);
        self.open += seen;
        if seen == len {
            return;
        }
        self.close(at + seen as u64);
        while seen + LONG <= len {
            let probe = seen + LONG - 1;
            let before = (seen..=probe).rev().take_while(is_zero).count();
            seen = probe + 1;
            if before > 0 {
                self.open = before + zeros_from(seen);
                seen = probe + 1 + (self.open - before);
                if seen == len {
                    return;
                }
                self.close(at + seen as u64);
            }
        }
        self.open = (seen..len).rev().take_while(is_zero).count();
    }

    /// The stretch ends before this frame. One with which the recording begins is none.
    fn close(&mut self, end: u64) {
        let frames = std::mem::take(&mut self.open) as u64;
        let start = end - frames;
        if frames >= LONG as u64 && start > 0 {
            if self.places == 0 {
                self.first = start;
            }
            self.places += 1;
            self.frames += frames;
        }
    }

    /// How many stretches there are, where the first one begins, and how many frames are in them; `None`
    /// if there are none, or so many that they belong to the recording.
    pub(super) fn odd(&self) -> Option<(u64, u64, u64)> {
        let is_rare = (self.frames as f64) < MOST_SHARE * self.all as f64;
        let is_odd = is_rare && (1..=MOST).contains(&self.places);
        is_odd.then_some((self.places, self.first, self.frames))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is found in a sound of ones with these zeros, in blocks of this length.
    fn found(zeros: &[std::ops::Range<usize>], block: usize) -> Option<(u64, u64, u64)> {
        let mut sound = vec![1.0; 3_000];
        for range in zeros {
            sound[range.clone()].fill(0.0);
        }
        let mut blanks = Blanks::default();
        for (number, part) in sound.chunks(block).enumerate() {
            blanks.take((number * block) as u64, &[part.to_vec(), part.to_vec()]);
        }
        blanks.odd()
    }

    #[test]
    fn a_stretch_of_zeros_is_found_whatever_the_blocks() {
        for block in [1, 7, 64, 65, 100, 999, 3_000] {
            for start in [1, 63, 64, 200, 500] {
                let zeros = start..start + 64;
                let expected = Some((1, start as u64, 64));
                assert_eq!(
                    found(&[zeros], block),
                    expected,
                    "{start} in blocks of {block}"
                );
                let fewer = start..start + 63;
                assert_eq!(found(&[fewer], block), None);
            }
            assert_eq!(found(&[100..250, 400..470], block), Some((2, 100, 220)));
            // Silence at both ends is that of an editor.
            assert_eq!(found(&[0..100, 2_900..3_000], block), None);
            let gated = [100..180, 200..280, 300..380, 400..480];
            assert_eq!(found(&gated, block), None);
        }
    }
}
