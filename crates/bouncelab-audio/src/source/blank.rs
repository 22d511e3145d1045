//! Zeros in place of sound: written over it, or where a recorder lost some. They are a few runs of zeros in a recording
//! whose noise is never silent otherwise.

/// Minimum length of a run, in frames: noise has no such run by chance.
const MIN_RUN: usize = 64;

/// Maximum number of runs. In a recording with more of them silence belongs to the sound: that of a noise gate, or of
/// a source without background noise.
const MAX_RUNS: u64 = 3;
/// Maximum share of the recording in runs, for the same reason.
const MAX_SHARE: f64 = 0.1;

/// The runs of frames in which all channels are zero.
#[derive(Debug, Default)]
pub(super) struct Blanks {
    /// Number of runs.
    runs: u64,
    /// Frame with which the first run begins.
    first: u64,
    /// Number of frames in all runs.
    frames: u64,
    /// Length of the run at the end of what was taken, which may go on.
    open: usize,
    /// Number of frames that were taken.
    all: u64,
}

impl Blanks {
    /// Takes the next frames, of which the first has the number `at`.
    ///
    /// A run of `MIN_RUN` frames contains one of any frames that are `MIN_RUN` apart, so only one frame in `MIN_RUN` is
    /// examined, and its neighbours only if it is zero.
    pub(super) fn take(&mut self, at: u64, planes: &[Vec<f32>]) {
        let len = planes.first().map_or(0, Vec::len);
        let is_zero = |frame: &usize| planes.iter().all(|plane| plane[*frame] == 0.0);
        let zeros_from = |frame: usize| (frame..len).take_while(is_zero).count();
        self.all = at + len as u64;
        // The run at the end of the frames before may go on here.
        let mut seen = zeros_from(0);
        self.open += seen;
        if seen == len {
            return;
        }
        self.close(at + seen as u64);
        while seen + MIN_RUN <= len {
            let probe = seen + MIN_RUN - 1;
            let before = (seen..=probe).rev().take_while(is_zero).count();
            seen = probe + 1;
            if before > 0 {
                // A run contains the probe: it began `before` frames ago, and may go on behind the probe.
                self.open = before + zeros_from(seen);
                seen = probe + 1 + (self.open - before);
                if seen == len {
                    return;
                }
                self.close(at + seen as u64);
            }
        }
        // A run shorter than `MIN_RUN` so far may begin behind the last probe.
        self.open = (seen..len).rev().take_while(is_zero).count();
    }

    /// Ends the run before frame `end`. A run at the very start is not counted.
    fn close(&mut self, end: u64) {
        let frames = std::mem::take(&mut self.open) as u64;
        let start = end - frames;
        if frames >= MIN_RUN as u64 && start > 0 {
            if self.runs == 0 {
                self.first = start;
            }
            self.runs += 1;
            self.frames += frames;
        }
    }

    /// Number of runs, first frame of the first run, and number of frames in all runs; `None` if there is no run, or if
    /// silence belongs to the recording.
    pub(super) fn suspect(&self) -> Option<(u64, u64, u64)> {
        let is_rare = (self.frames as f64) < MAX_SHARE * self.all as f64;
        let is_suspect = is_rare && (1..=MAX_RUNS).contains(&self.runs);
        is_suspect.then_some((self.runs, self.first, self.frames))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The runs in a sound of ones with these zeros, in blocks of this length.
    fn runs(zeros: &[std::ops::Range<usize>], block: usize) -> Option<(u64, u64, u64)> {
        let mut sound = vec![1.0; 3_000];
        for range in zeros {
            sound[range.clone()].fill(0.0);
        }
        let mut blanks = Blanks::default();
        for (number, part) in sound.chunks(block).enumerate() {
            blanks.take((number * block) as u64, &[part.to_vec(), part.to_vec()]);
        }
        blanks.suspect()
    }

    #[test]
    fn a_run_of_zeros_is_found_whatever_the_blocks() {
        for block in [1, 7, 64, 65, 100, 999, 3_000] {
            for start in [1, 63, 64, 200, 500] {
                let zeros = start..start + 64;
                let expected = Some((1, start as u64, 64));
                assert_eq!(
                    runs(&[zeros], block),
                    expected,
                    "{start} in blocks of {block}"
                );
                let fewer = start..start + 63;
                assert_eq!(runs(&[fewer], block), None);
            }
            assert_eq!(runs(&[100..250, 400..470], block), Some((2, 100, 220)));
            // Silence at both ends is that of an editor.
            assert_eq!(runs(&[0..100, 2_900..3_000], block), None);
            let gated = [100..180, 200..280, 300..380, 400..480];
            assert_eq!(runs(&gated, block), None);
        }
    }
}
