//! Problems of files as data, so that a page can state them in any language; the texts here are English.

use std::fmt;

use serde::Serialize;

use crate::times;

/// What is missing in an empty file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum MissingContent {
    /// The file has no bytes, or only those of tags.
    Content,
    /// The file has a header and nothing behind it.
    Sound,
    /// The file is a list without a time.
    Time,
}

impl fmt::Display for MissingContent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Content => "the file has no content",
            Self::Sound => "there is a header but no sound",
            Self::Time => "there is no time in it",
        })
    }
}

/// The kind of a file that is not sound, as far as its first bytes show it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum LooksLike {
    /// A PNG picture.
    Png,
    /// A JPEG picture.
    Jpeg,
    /// A GIF picture.
    Gif,
    /// A PDF document.
    Pdf,
    /// A ZIP archive, which office documents are too.
    Zip,
    /// A gzip archive.
    Gzip,
    /// RIFF without sound.
    Riff,
    /// Nothing but zeros.
    Zeros,
    /// Text.
    Text,
    /// None of these.
    Unknown,
}

impl fmt::Display for LooksLike {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Png => "a PNG picture",
            Self::Jpeg => "a JPEG picture",
            Self::Gif => "a GIF picture",
            Self::Pdf => "a PDF document",
            Self::Zip => "a ZIP archive or an office document",
            Self::Gzip => "a gzip archive",
            Self::Riff => "a RIFF file without sound, such as AVI or WebP",
            Self::Zeros => "nothing but zeros",
            Self::Text => "text",
            Self::Unknown => "data of an unknown kind",
        })
    }
}

/// The stage of reading at which a file turned out to be damaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Stage {
    /// Reading the container's header.
    Header,
    /// Reading the set-up of the codec.
    Codec,
    /// Decoding the sound.
    Sound,
}

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Header => "read the header",
            Self::Codec => "set up the decoder",
            Self::Sound => "decode any sound",
        })
    }
}

/// Why sound that can be decoded is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "code", rename_all = "kebab-case")]
pub enum LayoutProblem {
    /// Too few samples a second.
    #[error(
        "{sample_rate_hz} samples a second are too few to time an impact (at least \
         {min_hz} are needed); record again at 44100 if you can"
    )]
    TooSlow {
        /// Samples a second.
        sample_rate_hz: u32,
        /// The minimum.
        min_hz: u32,
    },
    /// More samples a second than any recorder takes.
    #[error(
        "the header claims {sample_rate_hz} samples a second (at most {max_hz} are read); export it again"
    )]
    TooFast {
        /// Samples a second.
        sample_rate_hz: u32,
        /// The maximum.
        max_hz: u32,
    },
    /// More channels than any recorder has.
    #[error("{channels} channels (at most {max} are read)")]
    TooManyChannels {
        /// Number of channels.
        channels: usize,
        /// The maximum.
        max: usize,
    },
}

/// What is wrong with a list of impact times or a sampled waveform in text, or with one of its lines.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "code", rename_all = "kebab-case")]
pub enum TimesProblem {
    /// The name has none of the endings of lists.
    #[error(
        "not a list of times: the name ends in none of .{}",
        times::endings().collect::<Vec<_>>().join(", .")
    )]
    Ending,
    /// The path is that of a device or a pipe.
    #[error("not a file; save the list in one")]
    NotFile,
    /// The file is longer than any list.
    #[error("more than {max_mb} MB of text; save the sound as WAV")]
    TooLong {
        /// The maximum, in MB.
        max_mb: u64,
    },
    /// A cell of a sampled waveform is not a number.
    #[error("{text:?} is not a number; below its headings a sampled waveform has numbers alone")]
    NotSample {
        /// The text of the cell.
        text: String,
    },
    /// A row of a sampled waveform is too short.
    #[error(
        "{found} of {columns} numbers; a sampled waveform has one for the time and one for each channel in \
         every row"
    )]
    FewerColumns {
        /// Number of columns in the line.
        found: usize,
        /// Number of columns in the first row.
        columns: usize,
    },
    /// The times of a sampled waveform are not at equal distances.
    #[error(
        "it is {interval_s:.7} s after the row before, but rows are {mean_s:.7} s apart on average; the times of a \
         sampled waveform have equal distances"
    )]
    Uneven {
        /// From the row before, in seconds.
        interval_s: f64,
        /// From row to row on average, in seconds.
        mean_s: f64,
    },
    /// A table of samples that are too slow for sound.
    #[error(
        "a table of {rows} samples, {rate_hz} a second, and no list of impact times; sound needs at least {min_hz} a \
         second; list the times of the impacts"
    )]
    Sampled {
        /// Number of samples.
        rows: usize,
        /// Samples a second.
        rate_hz: f64,
        /// The minimum of sound.
        min_hz: u32,
    },
    /// One column of samples.
    #[error(
        "{rows} samples without times, and no list of impact times; state their rate, as in --rate 44100"
    )]
    NoRate {
        /// Number of samples.
        rows: usize,
    },
    /// A table of positions over time.
    #[error(
        "positions over time, and no list of impact times (columns: {found}); analyze the recording, or list the times \
         of the impacts"
    )]
    Positions {
        /// The headings.
        found: String,
    },
    /// Times of several drops, in columns or rows.
    #[error(
        "several columns of times and {rows} rows (columns: {found}); a list has one drop: one column of times, or one \
         row of stops"
    )]
    SeveralDrops {
        /// The headings.
        found: String,
        /// Number of rows below them.
        rows: usize,
    },
    /// A table of results, which names recordings.
    #[error(
        "a table about recordings (it has a column recording), and no list of impact times; analyze the recordings"
    )]
    OfRecordings,
    /// None of the tables of a file is a list.
    #[error(
        "none of its tables is a list of impact times (it holds: {found}); open a recording by itself, and recordings of \
         a class with session"
    )]
    NoList {
        /// The names of the tables.
        found: String,
    },
    /// Two tables of a file hold times of different drops.
    #[error("the tables {first} and {second} hold different times; keep one of them")]
    TablesDisagree {
        /// The name of the fuller one.
        first: String,
        /// The name of the other one.
        second: String,
    },
    /// Numbers without a heading are in no order.
    #[error(
        "{number} after {before}: numbers without a heading are impact times, which increase, or intervals, which \
         decrease; write time_s or interval_s above them; samples need a column of times"
    )]
    NoOrder {
        /// The number that is out of order.
        number: f64,
        /// The number before it.
        before: f64,
    },
    /// An interval is not positive.
    #[error(
        "{text} is no interval from one impact to the next; expected a number above 0, in seconds"
    )]
    NotInterval {
        /// The interval.
        text: String,
    },
    /// The file is not a layer of Sonic Visualiser with a sample rate.
    #[error(
        "not a layer of Sonic Visualiser with a model and points; export it again (File > Export Annotation Layer)"
    )]
    NotLayer,
    /// The content is not text.
    #[error("not text; save the list as text, CSV or a sheet")]
    NotText,
    /// The file is not a table.
    #[error("{detail}")]
    NotTable {
        /// The error of the parser.
        detail: String,
    },
    /// The file is not an array of JSON.
    #[error("expected an array of numbers, [0.1, 0.45]: {detail}")]
    NotArray {
        /// The error of the parser.
        detail: String,
    },
    /// The file is not a `TextGrid` of Praat, or only the beginning of one.
    #[error("not a TextGrid of Praat, or not all of one; save it from Praat again")]
    NotTextGrid,
    /// The `TextGrid` has no point tier.
    #[error(
        "no tier has points; those there have intervals: {found}. In Praat add a tier (Tier > Add point \
         tier...) with a point at each impact"
    )]
    NoPointTier {
        /// The names of the tiers, or a dash.
        found: String,
    },
    /// The `TextGrid` has several point tiers.
    #[error("several tiers have points: {found}; in Praat name that of the impacts \"impacts\"")]
    WhichPointTier {
        /// The names of the point tiers.
        found: String,
    },
    /// The first line names columns, none of which holds times.
    #[error(
        "no heading has a word for time or impact with a unit, such as time_s, time_ms, Time (s) or interval_s; found: {found}"
    )]
    NoTimeColumn {
        /// The names that are there.
        found: String,
    },
    /// There are several columns without names.
    #[error("{columns} columns; name the one with the times in a first line: time_s")]
    NamelessColumns {
        /// Number of columns in the line.
        columns: usize,
    },
    /// A line has cells in columns that the first line does not name.
    #[error(
        "{found} columns, but the first line has {columns}; where commas are decimal, separate columns \
         with semicolons"
    )]
    MoreColumns {
        /// Number of columns in the line.
        found: usize,
        /// Number of columns in the first line.
        columns: usize,
    },
    /// A line is too short.
    #[error("the time is missing")]
    Missing,
    /// A cell is not a number.
    #[error("{text:?} is not a time in seconds; expected a number such as 0.125")]
    NotNumber {
        /// The text of the cell.
        text: String,
    },
    /// The times do not increase.
    #[error("{time_s} is not later than {before_s} before it; list impacts in order")]
    NotLater {
        /// The time that is not later.
        time_s: f64,
        /// The time before it.
        before_s: f64,
    },
}
