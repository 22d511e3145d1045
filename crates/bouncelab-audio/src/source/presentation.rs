//! Which of the decoded frames are presented.
//!
//! Lossy encoders write frames in front of the sound that only prepare the decoder (priming), and fill the
//! last packet (padding). Containers state how many; the rest is the *presented* sound, whose first
//! frame is time zero.

use std::ops::Range;

/// The presented stretches of the decoded frames, in order and apart from each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Presentation {
    stretches: Vec<Range<u64>>,
}

impl Presentation {
    /// All frames from this one on.
    pub(super) fn from_frame(start: u64) -> Self {
        Self {
            stretches: std::iter::once(start..u64::MAX).collect(),
        }
    }

    /// One stretch; `None` if it is empty.
    pub(super) fn only(stretch: Range<u64>) -> Option<Self> {
        Self::stretches(std::iter::once(stretch).collect())
    }

    /// These stretches; `None` unless they are in order, apart, and none is empty.
    pub(super) fn stretches(stretches: Vec<Range<u64>>) -> Option<Self> {
        let in_order = stretches
            .windows(2)
            .all(|pair| pair[0].end <= pair[1].start);
        let none_empty = stretches.iter().all(|stretch| stretch.start < stretch.end);
        (in_order && none_empty && !stretches.is_empty()).then_some(Self { stretches })
    }

    /// One past the last decoded frame that is presented.
    pub(super) fn end(&self) -> u64 {
        self.stretches.last().map_or(0, |last| last.end)
    }

    /// The first presented stretch within these decoded frames.
    pub(super) fn first_within(&self, decoded: &Range<u64>) -> Option<Range<u64>> {
        let overlap =
            |stretch: &Range<u64>| stretch.start.max(decoded.start)..stretch.end.min(decoded.end);
        self.stretches
            .iter()
            .map(overlap)
            .find(|part| part.start < part.end)
    }

    /// Number of presented frames among the first `decoded` frames.
    pub(super) fn count(&self, decoded: u64) -> u64 {
        let len = |stretch: &Range<u64>| stretch.end.min(decoded).saturating_sub(stretch.start);
        self.stretches.iter().map(len).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decoded_frames_are_cut_at_every_stretch() {
        let presentation = Presentation::stretches(vec![10..20, 30..40]).unwrap();
        assert_eq!(presentation.first_within(&(0..10)), None);
        assert_eq!(presentation.first_within(&(0..35)), Some(10..20));
        assert_eq!(presentation.first_within(&(20..35)), Some(30..35));
        assert_eq!(presentation.first_within(&(40..99)), None);
        assert_eq!((presentation.count(35), presentation.count(1000)), (15, 20));
        assert_eq!(presentation.end(), 40);
    }

    #[test]
    fn stretches_that_go_back_are_refused() {
        assert_eq!(Presentation::stretches(vec![10..20, 15..30]), None);
        assert_eq!(Presentation::only(10..10), None);
        assert_eq!(Presentation::stretches(vec![]), None);
    }
}
