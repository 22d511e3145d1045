//! Sampled waveforms in text, as oscilloscopes, data loggers and phone apps export them: a column of times and
//! one for each channel.
//!
//! Lines in front of the numbers are headings. Cells are separated by commas, semicolons, tabs or spaces; if not by
//! commas, numbers may have a decimal comma. The unit of the times is that in their heading (`ms`, `us`), else the
//! second.

use std::cmp::Ordering;

use crate::error::{Error, Result};
use crate::problem::TimesProblem;
use crate::source::{MIN_SAMPLE_RATE_HZ, SoundReader};
use crate::times::heading::{is_of_times, seconds};
use crate::times::table::{number, separator};
use crate::wav::{SampleFormat, encode_wav};

/// Minimum number of rows with equal distances.
const MIN_ROWS: usize = 4;
/// Minimum number of rows of a waveform of which some are missing or damaged.
const MIN_DAMAGED_ROWS: usize = 20;
/// Minimum share of equal distances in such a waveform.
const MIN_EQUAL: f64 = 0.9;
/// Maximum relative deviation of an equal distance from the median.
const MAX_DEVIATION: f64 = 0.02;
/// Maximum relative difference of the mean distances in the first and in the last third of the rows: those of a list of
/// impacts fall.
const MAX_TREND: f64 = 0.01;
/// Maximum number of samples of all channels, which are kept in memory.
const MAX_SAMPLES: usize = 1 << 23;
/// Minimum number of samples in one column without times: a quarter of a second at the lowest rate. No drop has as many impacts.
const MIN_SAMPLES: usize = 1_000;
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

/// Samples of a sound in a table without times: the file does not state their rate.
#[derive(Debug)]
pub struct Samples {
    name: String,
    column: Vec<f32>,
}

impl Samples {
    /// The samples in a text that is one column of many numbers, which rise and fall.
    pub(crate) fn find(text: &str, name: &str) -> Option<Self> {
        let numbers = || lines(text).map(|(_, line)| number(line.trim().trim_matches('"'), ','));
        let headings = numbers().take(MAX_HEADINGS).position(|it| it.is_some())?;
        let column: Option<Vec<f32>> = numbers()
            .skip(headings)
            .map(|it| Some(it? as f32))
            .collect();
        let column = column.filter(|it| (MIN_SAMPLES..=MAX_SAMPLES).contains(&it.len()))?;
        let falls = column.windows(2).any(|pair| pair[1] < pair[0]);
        let rises = column.windows(2).any(|pair| pair[1] > pair[0]);
        let name = name.to_owned();
        (falls && rises).then_some(Self { name, column })
    }

    /// The sound of these samples at a rate in Hz, which the caller knows.
    ///
    /// # Errors
    ///
    /// [`Error::Times`](crate::Error::Times) without a rate, [`Error::UnsupportedLayout`](crate::Error::UnsupportedLayout) if it is no
    /// rate of sound.
    pub fn at(self, rate_hz: Option<u32>) -> Result<SoundReader> {
        let Some(sample_rate_hz) = rate_hz else {
            return Err(self.without_rate());
        };
        let channels = vec![self.column];
        let waveform = Waveform {
            sample_rate_hz,
            channels,
        };
        waveform.source(&self.name)
    }

    /// What to say without a rate.
    pub(crate) fn without_rate(&self) -> Error {
        let rows = self.column.len();
        Error::times(&self.name, None, TimesProblem::NoRate { rows })
    }
}

impl Waveform {
    /// The waveform in a text; `None` if the text is not a table with times at equal distances.
    ///
    /// # Errors
    ///
    /// The line that does not belong to a waveform: it has a cell that is not a number, more or fewer cells, or a time at
    /// another distance. Samples that are too slow for sound.
    pub(crate) fn find(
        text: &str,
        is_csv: bool,
    ) -> std::result::Result<Option<Self>, (Option<usize>, TimesProblem)> {
        let Some(table) = NumberTable::find(text, is_csv) else {
            return Ok(None);
        };
        // Vectors that grow would take twice as much memory.
        let mut times = Vec::with_capacity(table.rows);
        let samples = || Vec::with_capacity(table.rows);
        let mut channels: Vec<Vec<f32>> = (1..table.columns).map(|_| samples()).collect();
        let mut fault = None;
        for (line, row) in lines(text).skip(table.headings) {
            match table.row(row, &mut channels) {
                Ok(time) => times.push(time),
                Err(problem) => fault = fault.or(Some((Some(line), problem))),
            }
        }
        let Some(step) = step(&times).or_else(|| usual_step(&times)) else {
            return Ok(None);
        };
        let rate_hz = 1.0 / (step * table.unit_s);
        let is_sound = rate_hz >= f64::from(MIN_SAMPLE_RATE_HZ);
        if !is_sound && !table.has_times {
            return Ok(None);
        }
        let waveform = Self {
            sample_rate_hz: rate_hz.round() as u32,
            channels,
        };
        if let Some(fault) = fault {
            Err(fault)
        } else if self::step(&times).is_none() {
            Err(table.uneven(text, &times))
        } else if is_sound {
            Ok(Some(waveform))
        } else {
            Err((None, waveform.sampled()))
        }
    }

    /// What to say where it cannot be used: it is no list of impacts.
    pub(crate) fn sampled(&self) -> TimesProblem {
        TimesProblem::Sampled {
            rows: self.channels.first().map_or(0, Vec::len),
            rate_hz: f64::from(self.sample_rate_hz),
            min_hz: MIN_SAMPLE_RATE_HZ,
        }
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
    /// Whether the heading of the first column is one of times.
    has_times: bool,
    /// Number of lines in front of the rows.
    headings: usize,
    rows: usize,
}

impl NumberTable {
    fn find(text: &str, is_csv: bool) -> Option<Self> {
        let mut heading = "";
        let mut has_times = false;
        for (headings, (_, line)) in lines(text).take(MAX_HEADINGS).enumerate() {
            let Some((separator, columns)) = layout(heading, line, is_csv) else {
                // A single number is a row of one column.
                if number(line, ',').is_none() {
                    heading = line;
                    has_times |= is_of_times(line);
                }
                continue;
            };
            let rows = lines(text).skip(headings).count();
            let is_sound = rows >= MIN_ROWS && rows * (columns - 1) <= MAX_SAMPLES;
            return is_sound.then(|| Self {
                separator,
                columns,
                unit_s: unit_s(heading, separator),
                has_times,
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
            let number =
                number(cell, decimal_sign(self.separator)).ok_or_else(|| not_sample(cell))?;
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

    /// The first line at an unusual distance from the line before.
    fn uneven(&self, text: &str, times: &[f64]) -> (Option<usize>, TimesProblem) {
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
        (line, TimesProblem::Uneven { interval_s, mean_s })
    }
}

/// The lines that are not blank, with their numbers from 1.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = (1..).zip(text.lines());
    lines.filter(|(_, line)| !line.trim().is_empty())
}

/// Separator and number of columns of a row of numbers below a heading.
fn layout(heading: &str, line: &str, is_csv: bool) -> Option<(char, usize)> {
    let mut separators = separator(&[heading, line], is_csv)
        .map(char::from)
        .into_iter()
        .chain([' ']);
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
    cells(line, separator).map(move |cell| number(cell, decimal_sign(separator)))
}

/// The cells of a row that are not empty.
fn cells(line: &str, separator: char) -> impl Iterator<Item = &str> {
    let cells = line
        .trim()
        .split(separator)
        .map(|cell| cell.trim().trim_matches('"'));
    // Several spaces are one separator, and some programs end each row with a separator.
    cells.filter(|cell| !cell.is_empty())
}

/// The decimal sign besides the point.
fn decimal_sign(separator: char) -> char {
    if separator == ',' { '.' } else { ',' }
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

/// The distance of the times, if it is the same from the first to the last.
///
/// Times may have been written with too few digits: then several rows have the same time, and the distances between
/// others are steps of the last digit. The row at which the time changes is certain to one row, and so the rate is known
/// to one row in all.
fn step(times: &[f64]) -> Option<f64> {
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
    let is_even = times.len() >= MIN_ROWS
        && step > 0.0
        && steps().all(|step| (0.0..=MAX_INTERVAL * grid).contains(&step))
        && times.iter().enumerate().all(is_in_place)
        && is_steady(
            times,
            if steps().any(|step| step == 0.0) {
                grid
            } else {
                0.0
            },
        );
    is_even.then_some(step)
}

/// Whether rows are as far apart at the end as at the beginning; each time is rounded by up to half of `rounding`.
fn is_steady(times: &[f64], rounding: f64) -> bool {
    let third = (times.len() - 1) / 3;
    let last = times.len() - 1;
    let early = times[third] - times[0];
    let late = times[last] - times[last - third];
    let mean = (times[last] - times[0]) * third as f64 / last as f64;
    (late - early).abs() <= MAX_TREND * mean + 2.0 * rounding
}

/// The distance that nearly all of many times have.
fn usual_step(times: &[f64]) -> Option<f64> {
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    let usual = *steps.get(steps.len() / 2)?;
    let is_equal = |step: &&f64| (*step / usual - 1.0).abs() <= MAX_DEVIATION;
    let equal = steps.iter().filter(is_equal).count();
    let is_usual = times.len() >= MIN_DAMAGED_ROWS && usual > 0.0;
    (is_usual && equal as f64 >= MIN_EQUAL * steps.len() as f64).then_some(usual)
}
