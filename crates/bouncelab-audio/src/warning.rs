use std::fmt;

/// A fault in a recording that did not stop it from being read.
///
/// A [`Source`](crate::Source) gathers them while it is read; the list is complete once
/// [`next_block`](crate::Source::next_block) has returned `None`. Times are in seconds of the
/// presented sound, as everywhere in this crate.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The file ends before its own header says, or in the middle of something.
    Truncated {
        /// How much sound could be read.
        read_s: f64,
        /// How much was announced, where the file says so.
        expected_s: Option<f64>,
    },
    /// Packets that could not be decoded. Silence of the same length stands in their place, so
    /// that all later times hold.
    Damaged {
        /// How many packets.
        packets: u64,
        /// Where the first one starts.
        first_s: f64,
    },
    /// Samples that are no numbers (NaN or infinite). Each was replaced by zero.
    NonFinite {
        /// How many samples, over all channels.
        samples: u64,
        /// Where the first one is.
        first_s: f64,
    },
    /// The file's clock runs ahead of its samples: sound was lost while recording, and all times
    /// after the gap are too early.
    Gap {
        /// Where the sound is missing.
        at_s: f64,
        /// How much is missing.
        missing_s: f64,
    },
    /// The rate or the number of channels changes on the way; the sound after the change was not
    /// read.
    FormatChange {
        /// Where the change is.
        at_s: f64,
    },
    /// The edit list plays parts of the sound out of order or at another speed. It was ignored:
    /// the sound is presented as recorded.
    EditsIgnored,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Truncated {
                read_s,
                expected_s: Some(expected_s),
            } => write!(
                f,
                "the file is cut short: {read_s:.2} s of {expected_s:.2} s could be read"
            ),
            Self::Truncated {
                read_s,
                expected_s: None,
            } => {
                write!(
                    f,
                    "the file is cut short or damaged: it was read up to {read_s:.2} s"
                )
            }
            Self::Damaged { packets, first_s } => write!(
                f,
                "{packets} damaged {} replaced by silence, the first at {first_s:.2} s",
                if *packets == 1 {
                    "packet was"
                } else {
                    "packets were"
                }
            ),
            Self::NonFinite { samples, first_s } => write!(
                f,
                "{samples} {} replaced by zero, the first at {first_s:.4} s",
                if *samples == 1 {
                    "sample was not a number and"
                } else {
                    "samples were not numbers and"
                }
            ),
            Self::Gap { at_s, missing_s } => write!(
                f,
                "{missing_s:.2} s of sound are missing at {at_s:.2} s: later times are too early"
            ),
            Self::FormatChange { at_s } => write!(
                f,
                "the sound changes its rate or channels at {at_s:.2} s; it was read up to there"
            ),
            Self::EditsIgnored => f.write_str(
                "the file's edit list reorders or warps the sound; it was read as recorded",
            ),
        }
    }
}
