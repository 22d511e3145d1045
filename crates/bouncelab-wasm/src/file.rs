//! A file of the browser, read part by part: it is never in memory as a whole.

use std::io::{self, Read, Seek, SeekFrom};

use bouncelab_audio::position_after;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Fills `into` with the bytes of the worker's file from a position on; the number of bytes, zero at the end.
    #[wasm_bindgen(catch, js_name = readPart)]
    fn read_part(position: f64, into: &mut [u8]) -> std::result::Result<u32, JsValue>;
}

/// The number of the error that Unix systems give if a device fails: decoders report errors with a number as such,
/// others as damage of the file.
const INPUT_OUTPUT_ERROR: i32 = 5;

/// The one file that the worker has open.
pub(crate) struct FileOfWorker {
    position: u64,
    len: u64,
}

impl FileOfWorker {
    /// From its beginning; its length in bytes.
    pub(crate) fn new(len: f64) -> Self {
        Self {
            position: 0,
            len: len as u64,
        }
    }
}

impl Read for FileOfWorker {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let count = read_part(self.position as f64, into)
            .map_err(|_| io::Error::from_raw_os_error(INPUT_OUTPUT_ERROR))?;
        self.position += u64::from(count);
        Ok(count as usize)
    }
}

impl Seek for FileOfWorker {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.position = position_after(to, self.position, self.len)?;
        Ok(self.position)
    }
}
