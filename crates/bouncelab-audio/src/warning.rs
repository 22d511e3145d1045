use bouncelab::diagnostic::{Code, Diagnostic};

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

impl Warning {
    /// The same as data, for those who show it.
    pub fn diagnostic(&self) -> Diagnostic {
        let new = Diagnostic::new;
        match *self {
            Self::Truncated { read_s, expected_s } => {
                let truncated = new(Code::FileTruncated).with("read_s", read_s);
                match expected_s {
                    Some(expected_s) => truncated.with("expected_s", expected_s),
                    None => truncated,
                }
            }
            Self::Damaged { packets, first_s } => new(Code::PacketsDamaged)
                .with("packets", packets)
                .with("first_s", first_s),
            Self::NonFinite { samples, first_s } => new(Code::SamplesNotFinite)
                .with("samples", samples)
                .with("first_s", first_s),
            Self::Gap { at_s, missing_s } => new(Code::SoundMissing)
                .with("at_s", at_s)
                .with("missing_s", missing_s),
            Self::FormatChange { at_s } => new(Code::FormatChanges).with("at_s", at_s),
            Self::EditsIgnored => new(Code::EditListIgnored),
        }
    }
}
