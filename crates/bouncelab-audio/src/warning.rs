use bouncelab::analysis::Gap;
use bouncelab::diagnostic::{Code, Diagnostic};

/// Damage in a recording that could be read nevertheless.
///
/// A [`SoundReader`](crate::SoundReader) collects warnings while it is read; the list is complete once
/// [`next_block`](crate::SoundReader::next_block) has returned `None`. Times are in seconds of the
/// presented sound, as everywhere in this crate.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The file ends earlier than its header announces, or within a packet.
    Truncated {
        /// Duration of the sound that could be read.
        read_s: f64,
        /// Announced duration, if the file states one.
        expected_s: Option<f64>,
    },
    /// Samples are not numbers (NaN or infinite). Each was replaced by zero.
    NonFinite {
        /// Number of samples, in all channels together.
        samples: u64,
        /// Time of the first one.
        first_s: f64,
    },
    /// Sound was lost during recording or by damage to the file. It was replaced by silence of the same length, so
    /// that all later times are right.
    Missing {
        /// Number of places.
        places: u64,
        /// Time of the first one.
        first_s: f64,
        /// Duration that is missing in all of them together.
        missing_s: f64,
    },
    /// Sound was lost, and the file does not state how much: differences between times before and after such a place
    /// are unknown.
    ClockLost {
        /// Number of places.
        places: u64,
        /// Time of the first one.
        first_s: f64,
    },
    /// The sound is exactly zero in few places only: there it may have been lost or overwritten.
    Blank {
        /// Number of places.
        places: u64,
        /// Time of the first one.
        first_s: f64,
        /// Duration of all of them together.
        blank_s: f64,
    },
    /// Samples jump by a power of two and back: bits of the file were flipped.
    Flipped {
        /// Number of samples, in all channels together.
        samples: u64,
        /// Time of the first one.
        first_s: f64,
    },
    /// The checksum of the file is not that of the decoded sound: somewhere it differs from the encoded sound.
    Altered {
        /// Duration of the sound.
        read_s: f64,
    },
    /// The sample rate or the number of channels changes within the recording; the sound behind the change was not
    /// read.
    FormatChange {
        /// Time of the change.
        at_s: f64,
    },
    /// The sample rate in the header contradicts the number of bytes per second in it, or is unusual and nothing
    /// confirms it.
    RateInDoubt {
        /// The stated rate, which is used, in Hz.
        stated_hz: u32,
        /// The rate that follows from the bytes per second, in Hz, if the header has them.
        implied_hz: Option<f64>,
    },
    /// The edit list plays parts of the sound out of order or at another speed. It was ignored:
    /// the sound is presented as recorded.
    EditsIgnored,
}

impl Warning {
    /// Adds a gap to the warnings.
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

    /// The warning as a diagnostic.
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
            Self::Flipped { samples, first_s } => new(Code::BitsFlipped)
                .with("samples", samples)
                .with("first_s", first_s),
            Self::Altered { read_s } => new(Code::ChecksumWrong)
                .with("start_s", 0.0)
                .with("end_s", read_s),
            Self::FormatChange { at_s } => new(Code::FormatChanges).with("at_s", at_s),
            Self::RateInDoubt {
                stated_hz,
                implied_hz,
            } => {
                let doubt = new(Code::RateInDoubt).with("stated_hz", f64::from(stated_hz));
                match implied_hz {
                    Some(implied_hz) => doubt.with("implied_hz", implied_hz),
                    None => doubt,
                }
            }
            Self::EditsIgnored => new(Code::EditListIgnored),
        }
    }
}
