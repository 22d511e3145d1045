//! The engine as JavaScript sees it: data as JSON, samples as arrays.
//!
//! What is thrown is a [`Refusal`](crate::refusal::Refusal) as JSON.

// JavaScript gets the same refusals as the modules that are asked, whose documentation names them.
#![allow(clippy::missing_errors_doc)]

use bouncelab::detection::Envelope;
use bouncelab_audio::{SampleFormat, encode_wav, note_gaps};
use bouncelab_report::Chart;
use bouncelab_report::messages::Translator;
use bouncelab_report::paper::lesson::PuzzleChoice;
use bouncelab_report::report::verdict::MethodCheck;
use serde::Serialize;
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::*;

use crate::analyst::{self, Analyst};
use crate::catalogue::catalogue;
use crate::detector::{self, RecordingDetector};
use crate::language::translator;
use crate::pyramid::Level;
use crate::refusal::Result;
use crate::simulator;
use crate::spectrogram::{self, FLOOR_DB};
use crate::verdict;
use crate::wire::SimulationRequest;

fn json<T: Serialize>(value: &T) -> Result<String> {
    Ok(serde_json::to_string(value)?)
}

fn read<T: DeserializeOwned>(json: &str) -> Result<T> {
    Ok(serde_json::from_str(json)?)
}

/// Balls, laws, voices, and bodies with their gravity and air.
#[wasm_bindgen(js_name = catalogue)]
pub fn js_catalogue() -> Result<String> {
    json(&catalogue()?)
}

/// A list of times, as [`decoders`](crate::decoders) read it, as a recording.
#[wasm_bindgen(js_name = listed)]
pub fn listed(list: &str) -> Result<String> {
    json(&detector::of_list(&read(list)?))
}

fn samples_per_bin(levels: &[Level]) -> Vec<u32> {
    let levels = levels.iter();
    levels.map(|level| level.samples_per_bin as u32).collect()
}

fn take_level(levels: &mut [Level], level: usize) -> Vec<f32> {
    levels
        .get_mut(level)
        .map_or_else(Vec::new, |level| std::mem::take(&mut level.extremes))
}

/// Detects drops in samples as they come.
#[wasm_bindgen(js_name = Detector)]
pub struct JsDetector {
    detector: Option<RecordingDetector>,
    /// What came of each channel and is not yet processed.
    waiting: Vec<Vec<f32>>,
    levels: Vec<Level>,
}

#[wasm_bindgen(js_class = Detector)]
impl JsDetector {
    /// For `channels` channels; `channel`, counted from 1, is the only one that is used.
    #[wasm_bindgen(constructor)]
    pub fn new(sample_rate_hz: u32, channels: usize, channel: Option<usize>) -> Result<Self> {
        Ok(Self {
            detector: Some(RecordingDetector::new(sample_rate_hz, channels, channel)?),
            waiting: vec![Vec::new(); channels],
            levels: Vec::new(),
        })
    }

    /// Takes the next samples of one channel, counted from 0; with those of the last channel all are
    /// processed.
    pub fn push(&mut self, channel: usize, samples: Vec<f32>) {
        let last = self.waiting.len() - 1;
        if let Some(waiting) = self.waiting.get_mut(channel) {
            *waiting = samples;
        }
        if channel == last {
            let frames = self.waiting.iter().map(Vec::len).min().unwrap_or(0);
            let slices: Vec<&[f32]> = self.waiting.iter().map(|all| &all[..frames]).collect();
            if let Some(detector) = &mut self.detector {
                detector.push(&slices);
            }
        }
    }

    /// Notes gaps of lost sound, a list of them; silence is pushed instead.
    pub fn lose(&mut self, gaps: &str) -> Result<()> {
        let gaps = read(gaps)?;
        if let Some(detector) = &mut self.detector {
            detector.lose(gaps);
        }
        Ok(())
    }

    /// What was detected so far.
    #[wasm_bindgen(js_name = soFar)]
    pub fn so_far(&mut self) -> Result<String> {
        json(&self.detector.as_mut().map(RecordingDetector::so_far))
    }

    /// Ends the recording: what was detected. The format, and the warnings, a list of diagnostics, are
    /// those of its file.
    pub fn finish(&mut self, format: &str, warnings: &str) -> Result<String> {
        let warnings = read(warnings)?;
        let result = self.detector.take().map(|detector| {
            let (recording, levels) = detector.finish(format, warnings);
            self.levels = levels;
            recording
        });
        json(&result)
    }

    /// Samples in a bin of each level, fine to coarse, once it is finished.
    #[wasm_bindgen(js_name = samplesPerBin)]
    pub fn samples_per_bin(&self) -> Vec<u32> {
        samples_per_bin(&self.levels)
    }

    /// Least and greatest of each bin of a level.
    #[wasm_bindgen(js_name = takeLevel)]
    pub fn take_level(&mut self, level: usize) -> Vec<f32> {
        take_level(&mut self.levels, level)
    }
}

/// The messages of a language.
#[wasm_bindgen(js_name = Translator)]
pub struct JsTranslator(Translator);

#[wasm_bindgen(js_class = Translator)]
impl JsTranslator {
    /// Of a language by its code and its files; English without any.
    #[expect(
        clippy::needless_pass_by_value,
        reason = "JavaScript hands over a vector"
    )]
    #[wasm_bindgen(constructor)]
    pub fn new(code: &str, sources: Vec<String>) -> Result<Self> {
        Ok(Self(translator(code, &sources)?))
    }

    /// The sentence of a diagnostic.
    pub fn diagnostic(&self, diagnostic: &str) -> Result<String> {
        Ok(self.0.diagnostic(&read(diagnostic)?))
    }
}

/// Analyses drops.
#[wasm_bindgen(js_name = Analyst)]
#[derive(Default)]
pub struct JsAnalyst(Analyst);

#[wasm_bindgen(js_class = Analyst)]
impl JsAnalyst {
    /// One that remembers nothing yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Analyses every drop of a request.
    pub fn analyse(&mut self, request: &str, translator: &JsTranslator) -> Result<String> {
        let request = read(request)?;
        let analysis = self.0.analyse(&request, &translator.0)?;
        json(&analysis.numbers())
    }

    /// A figure of the drop of this index as a chart, compared with a simulation if one is given.
    pub fn chart(
        &mut self,
        request: &str,
        drop: usize,
        name: &str,
        simulation: Option<String>,
        translator: &JsTranslator,
    ) -> Result<String> {
        json(&self.find(request, (drop, name), simulation, translator)?)
    }

    /// The same as a picture.
    pub fn figure(
        &mut self,
        request: &str,
        drop: usize,
        name: &str,
        simulation: Option<String>,
        translator: &JsTranslator,
    ) -> Result<String> {
        let chart = self.find(request, (drop, name), simulation, translator)?;
        json(&analyst::drawn(name, &chart))
    }

    /// Draws the waveform from least and greatest sample of each step, one after the other.
    pub fn waveform(
        &mut self,
        request: &str,
        extremes: &[f32],
        step_s: f64,
        translator: &JsTranslator,
    ) -> Result<String> {
        let request = read(request)?;
        let analysis = self.0.analyse(&request, &translator.0)?;
        let chart = analysis.waveform(&envelope(extremes, step_s));
        json(&analyst::drawn("waveform", &chart))
    }

    /// The report as HTML; without extremes there is no sound.
    pub fn report(
        &mut self,
        request: &str,
        extremes: &[f32],
        step_s: f64,
        made: Option<String>,
        translator: &JsTranslator,
    ) -> Result<String> {
        let sound = (!extremes.is_empty()).then(|| envelope(extremes, step_s));
        let request = read(request)?;
        let analysis = self.0.analyse(&request, &translator.0)?;
        Ok(analysis.report(sound, made))
    }

    /// Judges drops by a rule.
    pub fn judge(&mut self, request: &str, translator: &JsTranslator) -> Result<String> {
        json(&verdict::judge(
            &mut self.0,
            &read(request)?,
            &translator.0,
        )?)
    }

    /// The rebounds of the drops of a recording, by a rule.
    pub fn rebounds(&mut self, request: &str) -> Result<String> {
        json(&verdict::rebounds(&mut self.0, &read(request)?)?)
    }

    /// The report of a verdict as HTML.
    #[wasm_bindgen(js_name = verdictReport)]
    pub fn verdict_report(&mut self, request: &str, translator: &JsTranslator) -> Result<String> {
        verdict::report(&mut self.0, &read(request)?, &translator.0)
    }

    /// The impacts as CSV.
    pub fn csv(&mut self, request: &str, translator: &JsTranslator) -> Result<String> {
        let request = read(request)?;
        Ok(self.0.analyse(&request, &translator.0)?.csv())
    }
}

impl JsAnalyst {
    fn find(
        &mut self,
        request: &str,
        (drop, name): (usize, &str),
        simulation: Option<String>,
        translator: &JsTranslator,
    ) -> Result<Chart> {
        let simulation: Option<SimulationRequest> =
            simulation.map(|simulation| read(&simulation)).transpose()?;
        let request = read(request)?;
        let analysis = self.0.analyse(&request, &translator.0)?;
        analysis.chart(drop, name, simulation.as_ref())
    }
}

fn envelope(extremes: &[f32], step_s: f64) -> Envelope {
    let (least, greatest) = extremes
        .chunks_exact(2)
        .map(|pair| (pair[0], pair[1]))
        .unzip();
    Envelope::of_steps(step_s, least, greatest)
}

/// The check of the method on a synthesised recording, on this day.
#[wasm_bindgen(js_name = methodCheck)]
pub fn method_check(day: String) -> Result<String> {
    json(&MethodCheck::run(day)?)
}

/// The onset nearest to a time.
#[wasm_bindgen(js_name = onsetNear)]
pub fn onset_near(
    samples: &[f32],
    sample_rate_hz: u32,
    start_s: f64,
    time_s: f64,
) -> Result<String> {
    json(&detector::onset_near(
        samples,
        sample_rate_hz,
        start_s,
        time_s,
    ))
}

/// A spectrogram as cells, column after column.
#[wasm_bindgen(js_name = Spectrogram)]
pub struct JsSpectrogram(spectrogram::Spectrogram);

#[wasm_bindgen(js_class = Spectrogram)]
impl JsSpectrogram {
    /// Of these samples, the first and the last `margin` of which are not shown.
    #[wasm_bindgen(constructor)]
    pub fn new(
        samples: &[f32],
        margin: usize,
        sample_rate_hz: f64,
        columns: usize,
        rows: usize,
    ) -> Self {
        Self(spectrogram::spectrogram(
            samples,
            margin,
            sample_rate_hz,
            columns,
            rows,
        ))
    }

    /// Frequency at the top.
    #[wasm_bindgen(js_name = topHz)]
    pub fn top_hz(&self) -> f64 {
        self.0.top_hz
    }

    /// Level of an empty cell.
    #[wasm_bindgen(js_name = floorDb)]
    pub fn floor_db(&self) -> f64 {
        FLOOR_DB
    }

    /// Levels in half decibels above the floor.
    #[wasm_bindgen(js_name = takeCells)]
    pub fn take_cells(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.0.cells)
    }
}

/// Samples as a WAV file of 32-bit floating point, with a list of gaps; the second channel may be empty.
#[wasm_bindgen]
pub fn wav(left: &[f32], right: &[f32], sample_rate_hz: u32, gaps: &str) -> Result<Vec<u8>> {
    let channels = [left, right];
    let count = if right.is_empty() { 1 } else { 2 };
    let format = SampleFormat::Float32;
    let mut wav = encode_wav(sample_rate_hz, format, &channels[..count])?;
    note_gaps(&mut wav, sample_rate_hz, &read::<Vec<_>>(gaps)?);
    Ok(wav)
}

/// Simulates a drop.
#[wasm_bindgen]
pub fn simulate(request: &str, translator: &JsTranslator) -> Result<String> {
    json(&simulator::simulate(&read(request)?, &translator.0)?)
}

/// A made-up recording.
#[wasm_bindgen]
pub struct Rendering {
    samples: Vec<f32>,
    sample_rate_hz: u32,
    about: String,
}

#[wasm_bindgen]
impl Rendering {
    /// The sound of a simulated drop.
    pub fn synthesise(request: &str, scene: &str) -> Result<Self> {
        let sound = simulator::synthesise(&read(request)?, &read(scene)?)?;
        Ok(Self {
            samples: sound.samples,
            sample_rate_hz: sound.sample_rate_hz,
            about: String::new(),
        })
    }

    /// The demo.
    pub fn demo(seed: u32) -> Result<Self> {
        let (demo, sound) = simulator::demo(u64::from(seed))?;
        Ok(Self {
            samples: sound.samples,
            sample_rate_hz: sound.sample_rate_hz,
            about: json(&demo)?,
        })
    }

    /// Its settings, if it is the demo.
    pub fn about(&self) -> String {
        self.about.clone()
    }

    /// Samples a second.
    #[wasm_bindgen(js_name = sampleRateHz)]
    pub fn sample_rate_hz(&self) -> u32 {
        self.sample_rate_hz
    }

    /// The samples.
    #[wasm_bindgen(js_name = takeSamples)]
    pub fn take_samples(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.samples)
    }
}

/// Charts that compare simulated drops, the last of which is the present one: height against time,
/// and flight times.
#[wasm_bindgen(js_name = simulationCharts)]
pub fn simulation_charts(runs: &str, translator: &JsTranslator) -> Result<String> {
    json(&simulator::charts(&read::<Vec<_>>(runs)?, &translator.0)?)
}

/// What the log-linear fit of the paper makes of a choice of the reader.
#[wasm_bindgen(js_name = puzzleAnswer)]
pub fn puzzle_answer(choice: &str, translator: &JsTranslator) -> Result<String> {
    json(&read::<PuzzleChoice>(choice)?.answer(&translator.0)?)
}

/// The choice with the restitution with which the line gives the result of the paper.
#[wasm_bindgen(js_name = puzzleSolution)]
pub fn puzzle_solution(choice: &str) -> Result<String> {
    json(&read::<PuzzleChoice>(choice)?.solved()?)
}
