use bouncelab::analysis::Gap;
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
    /// Samples that are no numbers (NaN or infinite). Each was replaced by zero.
    NonFinite {
        /// How many samples, over all channels.
        samples: u64,
        /// Where the first one is.
        first_s: f64,
    },
    /// Sound was lost, in recording or by damage to the file. Silence of the same length stands in
    /// its place, so that all later times hold.
    Missing {
        /// In how many places.
        places: u64,
        /// Where the first one is.
        first_s: f64,
        /// How much is missing in all of them.
        missing_s: f64,
    },
    /// Sound was lost, and the file does not say how much: times before and after such a place do not
    /// belong together.
    ClockLost {
        /// In how many places.
        places: u64,
        /// Where the first one is.
        first_s: f64,
    },
    /// The sound is exactly zero for a while, and not elsewhere: it may have been lost or overwritten.
    Blank {
        /// In how many places.
        places: u64,
        /// Where the first one is.
        first_s: f64,
        /// How long all of them are.
        blank_s: f64,
    },
    /// The decoded sound is not that of which the file has the checksum: somewhere in all of it it is another.
    Altered {
        /// How long the sound is.
        read_s: f64,
    },
    /// The rate or the number of channels changes on the way; the sound after the change was not
    /// read.
    FormatChange {
        /// Where the change is.
        at_s: f64,
    },
    /// The header states a rate and, by its bytes a second, another.
    RateInDoubt {
        /// The rate that is used, in Hz.
        stated_hz: u32,
        /// The other, in Hz.
        implied_hz: f64,
    },
    /// The edit list plays parts of the sound out of order or at another speed. It was ignored:
    /// the sound is presented as recorded.
    EditsIgnored,
}

impl Warning {
    /// Adds a gap to those that are noted.
    pub(crate) fn note_gap(noted: &mut Vec<Self>, gap: Gap) {
        for warning in &mut *noted {
            match warning {
                Self::Missing {
                    places, missing_s, ..
                } if gap.certain => {
                    *places += 1;
                    *missing_s += gap.duration_s;
                    return;
                }
                Self::ClockLost { places, .. } if !gap.certain => {
                    *places += 1;
                    return;
                }
                _ => {}
            }
        }
        noted.push(if gap.certain {
            Self::Missing {
                places: 1,
                first_s: gap.start_s,
                missing_s: gap.duration_s,
            }
        } else {
            Self::ClockLost {
                places: 1,
                first_s: gap.start_s,
            }
        });
    }

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
            Self::NonFinite { samples, first_s } => new(Code::SamplesNotFinite)
                .with("samples", samples)
                .with("first_s", first_s),
            Self::Missing {
                places,
                first_s,
                missing_s,
            } => new(Code::SoundMissing)
                .with("places", places)
                .with("first_s", first_s)
                .with("missing_s", missing_s),
            Self::ClockLost { places, first_s } => new(Code::ClockLost)
                .with("places", places)
                .with("first_s", first_s),
            Self::Blank {
                places,
                first_s,
                blank_s,
            } => new(Code::SoundBlank)
                .with("places", places)
                .with("first_s", first_s)
                .with("blank_s", blank_s),
            Self::Altered { read_s } => new(Code::ChecksumWrong)
                .with("start_s", 0.0)
                .with("end_s", read_s),
            Self::FormatChange { at_s } => new(Code::FormatChanges).with("at_s", at_s),
            Self::RateInDoubt {
                stated_hz,
                implied_hz,
            } => new(Code::RateInDoubt)
                .with("stated_hz", f64::from(stated_hz))
                .with("implied_hz", implied_hz),
            Self::EditsIgnored => new(Code::EditListIgnored),
        }
    }
}
