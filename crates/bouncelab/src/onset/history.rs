//! The latest samples of a stream, in pieces whose memory is reused.

use super::parameters::PIECE_FRAMES;
use std::collections::VecDeque;
use std::ops::Range;
use std::sync::Arc;

/// Remembers samples by their number in the stream. A frame lies in one piece. A clone shares the pieces
/// that are complete.
#[derive(Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct History {
    frame: usize,
    pieces: VecDeque<Arc<Vec<f32>>>,
    /// Number of the first sample of the first piece.
    first: u64,
    /// Number of samples so far.
    end: u64,
    #[cfg_attr(feature = "serde", serde(skip))]
    spare: Vec<Vec<f32>>,
}

impl History {
    pub(super) fn new(frame: usize) -> Self {
        Self {
            frame,
            pieces: VecDeque::new(),
            first: 0,
            end: 0,
            spare: Vec::new(),
        }
    }

    /// Number of samples so far.
    pub(crate) fn end(&self) -> u64 {
        self.end
    }

    /// Takes as many of these samples as fit into the last piece; returns how many.
    pub(super) fn push(&mut self, samples: &[f32]) -> usize {
        let size = PIECE_FRAMES * self.frame;
        let is_full = |piece: &Arc<Vec<f32>>| piece.len() == size;
        if self.pieces.back().is_none_or(is_full) {
            let spare = self.spare.pop();
            let empty = spare.unwrap_or_else(|| Vec::with_capacity(size));
            self.pieces.push_back(Arc::new(empty));
        }
        let Some(last) = self.pieces.back_mut() else {
            return 0;
        };
        let piece = Arc::make_mut(last);
        let taken = samples.len().min(size - piece.len());
        piece.extend_from_slice(&samples[..taken]);
        self.end += taken as u64;
        taken
    }

    /// The frame of this number, which must be complete and remembered.
    #[inline]
    pub(super) fn frame(&self, number: u64) -> &[f32] {
        let at = (number * self.frame as u64 - self.first) as usize;
        let size = PIECE_FRAMES * self.frame;
        &self.pieces[at / size][at % size..][..self.frame]
    }

    /// The samples of this range that are remembered, and the number of the first of them.
    pub(crate) fn read(&self, range: Range<u64>, samples: &mut Vec<f32>) -> u64 {
        samples.clear();
        let size = (PIECE_FRAMES * self.frame) as u64;
        let start = range.start.max(self.first);
        let end = range.end.min(self.end);
        samples.reserve_exact(end.saturating_sub(start) as usize);
        let mut at = start;
        while at < end {
            let piece = &self.pieces[((at - self.first) / size) as usize];
            let from = ((at - self.first) % size) as usize;
            let length = (end - at).min(size - from as u64) as usize;
            samples.extend_from_slice(&piece[from..from + length]);
            at += length as u64;
        }
        start
    }

    /// Forgets whole pieces that lie before this sample.
    pub(crate) fn forget_before(&mut self, sample: u64) {
        let size = (PIECE_FRAMES * self.frame) as u64;
        while self.first + size <= sample.min(self.end)
            && let Some(piece) = self.pieces.pop_front()
        {
            if let Some(mut piece) = Arc::into_inner(piece) {
                piece.clear();
                self.spare.push(piece);
            }
            self.first += size;
        }
    }
}

impl Clone for History {
    fn clone(&self) -> Self {
        let mut pieces = self.pieces.clone();
        if let Some(last) = pieces.back_mut() {
            // Both copies append to their last piece.
            let mut copy = Vec::with_capacity(PIECE_FRAMES * self.frame);
            copy.extend_from_slice(last);
            *last = Arc::new(copy);
        }
        Self {
            frame: self.frame,
            pieces,
            first: self.first,
            end: self.end,
            spare: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clone_shares_complete_pieces_and_continues_by_itself() {
        let mut history = History::new(4);
        let samples: Vec<f32> = (0..300_u16).map(f32::from).collect();
        let push = |history: &mut History, mut rest: &[f32]| {
            while !rest.is_empty() {
                rest = &rest[history.push(rest)..];
            }
        };
        push(&mut history, &samples);
        let mut clone = history.clone();
        assert!(Arc::ptr_eq(&history.pieces[0], &clone.pieces[0]));
        push(&mut history, &[-1.0]);
        push(&mut clone, &[-2.0]);
        let mut read = Vec::new();
        history.read(299..400, &mut read);
        assert_eq!(read, [299.0, -1.0]);
        clone.read(299..400, &mut read);
        assert_eq!(read, [299.0, -2.0]);
    }

    #[test]
    fn the_samples_that_were_pushed_are_remembered() {
        let mut history = History::new(4);
        let samples: Vec<f32> = (0..1000_u16).map(f32::from).collect();
        let mut rest = samples.as_slice();
        for length in (1..90).cycle() {
            let taken = history.push(&rest[..length.min(rest.len())]);
            rest = &rest[taken..];
            if rest.is_empty() {
                break;
            }
        }
        assert_eq!(history.end(), 1000);
        assert_eq!(history.frame(33), &samples[132..136]);
        history.forget_before(400);
        let mut read = Vec::new();
        assert_eq!(history.read(0..2000, &mut read), 384);
        assert_eq!(read, &samples[384..]);
        assert_eq!(history.read(500..700, &mut read), 500);
        assert_eq!(read, &samples[500..700]);
    }
}
