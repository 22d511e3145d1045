//! How do arrays become samples?

use std::ops::Range;

use pyo3::buffer::PyBuffer;
use pyo3::prelude::*;
use pyo3::types::PySlice;

use crate::failure::Result;

/// Number of samples copied at once: a few milliseconds of work, in 1 MB.
const MAX_COPIED: usize = 1 << 18;

/// An array of frames, each with a sample of every channel: 32-bit floats in the order of C. It is read in
/// blocks, so that it is never copied as a whole, and another thread that writes to it does no harm.
pub(crate) struct Frames {
    array: Py<PyAny>,
    pub(crate) length: usize,
    pub(crate) channels: usize,
}

impl Frames {
    pub(crate) fn new(array: &Bound<'_, PyAny>) -> Result<Self> {
        let (length, channels) = array.getattr("shape")?.extract()?;
        Ok(Self {
            array: array.clone().unbind(),
            length,
            channels,
        })
    }

    /// The blocks in which to read.
    pub(crate) fn blocks(&self) -> impl Iterator<Item = Range<usize>> + use<> {
        let length = self.length;
        let step = (MAX_COPIED / self.channels.max(1)).max(1);
        (0..length)
            .step_by(step)
            .map(move |start| start..length.min(start + step))
    }

    /// The samples of a block, one list for each channel.
    pub(crate) fn read(&self, py: Python<'_>, block: Range<usize>) -> Result<Vec<Vec<f32>>> {
        let part = self.interleaved(py, block)?;
        if self.channels == 1 {
            return Ok(vec![part]);
        }
        let of = |channel| self.of_channel(&part, channel);
        Ok((0..self.channels).map(of).collect())
    }

    /// The samples of a block in one channel.
    pub(crate) fn read_channel(
        &self,
        py: Python<'_>,
        block: Range<usize>,
        channel: usize,
    ) -> Result<Vec<f32>> {
        Ok(self.of_channel(&self.interleaved(py, block)?, channel))
    }

    fn interleaved(&self, py: Python<'_>, block: Range<usize>) -> Result<Vec<f32>> {
        let (start, end) = (block.start.cast_signed(), block.end.cast_signed());
        let part = PySlice::new(py, start, end, 1);
        Ok(PyBuffer::<f32>::get(&self.array.bind(py).get_item(part)?)?.to_vec(py)?)
    }

    fn of_channel(&self, part: &[f32], channel: usize) -> Vec<f32> {
        let own = part.iter().skip(channel).step_by(self.channels);
        own.copied().collect()
    }
}
