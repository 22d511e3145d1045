//! Sampled waveforms in text, as oscilloscopes, data loggers and phone apps export them: a column of times and
//! one for each channel.
//!
//! Lines in front of the numbers are headings. Cells are separated by commas, semicolons, tabs or spaces; if not by
//! commas, numbers may have a decimal comma. The unit of the times is that in their heading (`ms`, `us`), else the
//! second.

use std::cmp::Ordering;

use crate::error::{Error, Result};
use crate::problem::TimesProblem;
use crate::source::SoundReader;
use crate::times::heading::seconds;
use crate::wav::{SampleFormat, encode_wav};

/// Minimum number of rows: no list of impacts has so many at equal distances.
const MIN_ROWS: usize = 1_000;
/// Maximum number of samples of all channels, which are kept in memory.
const MAX_SAMPLES: usize = 1 << 23;
/// Maximum number of lines of headings: some instruments write a page of settings first.
const MAX_HEADINGS: usize = 200;
/// Maximum number of columns, that of the times included.
const MAX_COLUMNS: usize = 65;
/// Maximum distance of a time from that of its row at the mean rate, in sampling intervals or, if they are longer, in
/// steps of the last written digit. Rounding moves each time by up to half a step, the first and the last included, from
/// which the rate follows.
const MAX_OFFSET: f64 = 1.25;
/// Maximum distance of successive times, in the same unit.
const MAX_INTERVAL: f64 = 1.5;

/// A waveform that was read from a text.
#[derive(Debug, PartialEq)]
pub(crate) struct Waveform {
    sample_rate_hz: u32,
    channels: Vec<Vec<f32>>,
}

impl Waveform {
    /// The waveform in a text; `None` if the text is not a table of one: it has too few rows or columns.
    ///
    /// # Errors
    ///
    /// [`Error::Times`] with the line that does not belong to a waveform: it has a cell that is not a number, more or
    /// fewer cells, or a time at another distance.
    pub(crate) fn find(text: &str, name: &str) -> Result<Option<Self>> {
        let Some(table) = NumberTable::find(text) else {
            return Ok(None);
        };
        // Vectors that grow would take twice as much memory.
        let mut times = Vec::with_capacity(table.rows);
        let samples = || Vec::with_capacity(table.rows);
        let mut channels: Vec<Vec<f32>> = (1..table.columns).map(|_| samples()).collect();
        for (line, row) in lines(text).skip(table.headings) {
            let fail = |problem| Error::times(name, Some(line), problem);
            times.push(table.row(row, &mut channels).map_err(fail)?);
        }
        let Some(rate) = rate(&times) else {
            return Err(table.uneven(text, name, &times));
        };
        let rate_hz = rate / table.unit_s;
        let is_rate = (1.0..=f64::from(u32::MAX)).contains(&rate_hz);
        Ok(is_rate.then(|| Self {
            sample_rate_hz: rate_hz.round() as u32,
            channels,
        }))
    }

    /// The sound, scaled down to full scale if it is louder: the unit of a voltage or an app has no relation to it.
    pub(crate) fn source(mut self, name: &str) -> Result<SoundReader> {
        let samples = || self.channels.iter().flatten();
        let peak = samples().fold(1.0, |peak: f32, sample| peak.max(sample.abs()));
        for sample in self.channels.iter_mut().flatten() {
            *sample /= peak;
        }
        crate::check_layout(self.sample_rate_hz, self.channels.len(), name)?;
        let channels: Vec<&[f32]> = self.channels.iter().map(Vec::as_slice).collect();
        let wav = encode_wav(self.sample_rate_hz, SampleFormat::Float32, &channels)?;
        Ok(SoundReader::from_bytes(wav, name)?.described_as("waveform in text"))
    }
}

/// The position and layout of the rows of numbers in a text.
struct NumberTable {
    separator: char,
    columns: usize,
    /// The unit of the times, in seconds.
    unit_s: f64,
    /// Number of lines in front of the rows.
    headings: usize,
    rows: usize,
}

impl NumberTable {
    fn find(text: &str) -> Option<Self> {
        let mut heading = "";
        for (headings, (_, line)) in lines(text).take(MAX_HEADINGS).enumerate() {
            let Some((separator, columns)) = layout(line) else {
                heading = line;
                continue;
            };
            let rows = lines(text).skip(headings).count();
            let is_sound = rows >= MIN_ROWS && rows * (columns - 1) <= MAX_SAMPLES;
            return is_sound.then(|| Self {
                separator,
                columns,
                unit_s: unit_s(heading, separator),
                headings,
                rows,
            });
        }
        None
    }

    /// Reads a row: adds its samples to the channels, and returns its time.
    fn row(&self, row: &str, channels: &mut [Vec<f32>]) -> std::result::Result<f64, TimesProblem> {
        let not_sample = |text: &str| TimesProblem::NotSample {
            text: text.to_owned(),
        };
        let mut time = f64::NAN;
        let mut found = 0;
        for cell in cells(row, self.separator) {
            let number = number(cell, self.separator).ok_or_else(|| not_sample(cell))?;
            if found == 0 {
                time = number;
            } else if let Some(channel) = channels.get_mut(found - 1) {
                channel.push(number as f32);
            }
            found += 1;
        }
        let columns = self.columns;
        match found.cmp(&columns) {
            Ordering::Less => Err(TimesProblem::FewerColumns { found, columns }),
            Ordering::Equal => Ok(time),
            Ordering::Greater => Err(TimesProblem::MoreColumns { found, columns }),
        }
    }

    /// The error for times at unequal distances, with the first line at an unusual distance from the line before.
    fn uneven(&self, text: &str, name: &str, times: &[f64]) -> Error {
        let intervals = || times.windows(2).map(|pair| pair[1] - pair[0]);
        let mean = intervals().sum::<f64>() / (times.len() - 1) as f64;
        let deviation = |interval: f64| (interval - mean).abs();
        let max_deviation = intervals().map(deviation).fold(0.0, f64::max);
        // A wrong time makes two distances unusual, of which the second may deviate more.
        let first = (1..)
            .zip(intervals())
            .find(|(_, interval)| deviation(*interval) > 0.5 * max_deviation);
        let (row, interval) = first.unwrap_or_default();
        let line = lines(text).nth(self.headings + row).map(|(line, _)| line);
        let [interval_s, mean_s] = [interval, mean].map(|time| time * self.unit_s);
        Error::times(name, line, TimesProblem::Uneven { interval_s, mean_s })
    }
}

/// The lines that are not blank, with their numbers from 1.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = (1..).zip(text.lines());
    lines.filter(|(_, line)| !line.trim().is_empty())
}

/// Separator and number of columns of a row of numbers.
fn layout(line: &str) -> Option<(char, usize)> {
    let mut separators = [';', '\t', ',', ' '].into_iter();
    separators.find_map(|separator| {
        let cells = numbers(line, separator).take(MAX_COLUMNS + 1);
        let columns = cells.collect::<Option<Vec<f64>>>()?.len();
        (2..=MAX_COLUMNS)
            .contains(&columns)
            .then_some((separator, columns))
    })
}

/// The numbers of a row; `None` for a cell that is not a number.
fn numbers(line: &str, separator: char) -> impl Iterator<Item = Option<f64>> {
    cells(line, separator).map(move |cell| number(cell, separator))
}

/// The cells of a row that are not empty.
fn cells(line: &str, separator: char) -> impl Iterator<Item = &str> {
    let cells = line.trim().split(separator).map(str::trim);
    // Several spaces are one separator, and some programs end each row with a separator.
    cells.filter(|cell| !cell.is_empty())
}

fn number(cell: &str, separator: char) -> Option<f64> {
    let cell = cell.trim_matches('"');
    let number = if separator == ',' {
        cell.parse()
    } else {
        cell.replace(',', ".").parse()
    };
    number.ok().filter(|number: &f64| number.is_finite())
}

/// The unit of the times in seconds, by their heading: "Time (ms)", "`time_us`".
fn unit_s(heading: &str, separator: char) -> f64 {
    let of_times = heading
        .split(separator)
        .next()
        .unwrap_or_default()
        .to_lowercase();
    let mut words = of_times.split(|c: char| !c.is_alphabetic());
    words.find_map(seconds).unwrap_or(1.0)
}

/// Number of times in their unit, if they are at equal distances.
///
/// Times may have been written with too few digits: then several rows have the same time, and the distances between
/// others are steps of the last digit. The row at which the time changes is certain to one row, and so the rate is known
/// to one row in all.
fn rate(times: &[f64]) -> Option<f64> {
    let mut changes = (1..times.len()).filter(|&row| times[row] > times[row - 1]);
    let first = changes.next()?;
    let last = changes.next_back()?;
    let step = (times[last] - times[first]) / (last - first) as f64;
    let steps = || times.windows(2).map(|pair| pair[1] - pair[0]);
    let written = steps().filter(|step| *step > 0.0);
    let grid = step.max(written.fold(f64::INFINITY, f64::min));
    let is_in_place = |(row, time): (usize, &f64)| {
        let expected = times[first] + step * (row as f64 - first as f64);
        (time - expected).abs() <= MAX_OFFSET * grid
    };
    let is_even = step > 0.0
        && steps().all(|step| (0.0..=MAX_INTERVAL * grid).contains(&step))
        && times.iter().enumerate().all(is_in_place);
    is_even.then_some(1.0 / step)
}
