//! The decoders as JavaScript sees them, and what else few pages need.
//!
//! What is thrown is a [`Refusal`](crate::refusal::Refusal) as JSON.

// JavaScript gets the same refusals as the modules that are asked, whose documentation names them.
#![allow(clippy::missing_errors_doc)]

use bouncelab::Diagnostic;
use bouncelab_audio::times::TimeList;
use bouncelab_audio::{Input, SoundReader, Warning};
use bouncelab_report::figure::{self, DropSummary};
use bouncelab_report::hash::hash;
use bouncelab_report::link::LinkedDrop;
use bouncelab_report::paper::{self, lesson};
use bouncelab_report::sheets::Sheet;
use wasm_bindgen::prelude::*;

use crate::file::FileOfWorker;
use crate::groups;
use crate::job;
use crate::language::translator;
use crate::link;
use crate::refusal::{Refusal, Result};
use crate::verdict;
use crate::wire::{ComparedDrop, ReadList};

/// The content of a file: a list of times, or sound.
#[wasm_bindgen]
pub struct Opened(Input);

#[wasm_bindgen]
impl Opened {
    /// Opens the file of the worker, which has this length in bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(len: f64, name: &str) -> Result<Self> {
        Ok(Self(Input::from_reader(FileOfWorker::new(len), name)?))
    }

    /// The list of times, if it is one.
    pub fn list(&self) -> Result<Option<String>> {
        let Input::Times(TimeList { times_s, origin }) = &self.0 else {
            return Ok(None);
        };
        let list = ReadList {
            times_s: times_s.clone(),
            origin: origin.clone(),
        };
        Ok(Some(serde_json::to_string(&list)?))
    }

    /// The sound, if it is no list. The rate in Hz is that of samples whose file does not state it.
    pub fn decoder(self, rate_hz: Option<u32>) -> Result<Decoder> {
        let no_sound = |_| Refusal::fault("a list of times has no sound");
        let source = self.0.sound(rate_hz)?.map_err(no_sound)?;
        Ok(Decoder {
            samples: vec![Vec::new(); source.channels()],
            source,
        })
    }
}

/// A recording that is being decoded.
#[wasm_bindgen]
pub struct Decoder {
    source: SoundReader,
    samples: Vec<Vec<f32>>,
}

#[wasm_bindgen]
impl Decoder {
    /// Samples a second.
    #[wasm_bindgen(js_name = sampleRateHz)]
    pub fn sample_rate_hz(&self) -> u32 {
        self.source.sample_rate_hz()
    }

    /// How many channels it has.
    pub fn channels(&self) -> usize {
        self.source.channels()
    }

    /// The name of its format.
    pub fn format(&self) -> String {
        self.source.format()
    }

    /// Length in seconds, as far as the file states it.
    #[wasm_bindgen(js_name = durationS)]
    pub fn duration_s(&self) -> Option<f64> {
        self.source.duration_s()
    }

    /// Decodes about a second; `false` at the end.
    #[wasm_bindgen(js_name = decodeOn)]
    pub fn decode_on(&mut self) -> Result<bool> {
        let wanted = self.source.sample_rate_hz() as usize;
        while self.samples.first().is_some_and(|all| all.len() < wanted) {
            let Some(block) = self.source.next_block()? else {
                return Ok(false);
            };
            for (channel, all) in self.samples.iter_mut().enumerate() {
                all.extend_from_slice(block.channel(channel));
            }
        }
        Ok(true)
    }

    /// The samples of a channel, counted from 0, since they were last taken.
    #[wasm_bindgen(js_name = takeSamples)]
    pub fn take_samples(&mut self, channel: usize) -> Vec<f32> {
        let samples = self.samples.get_mut(channel);
        samples.map_or_else(Vec::new, std::mem::take)
    }

    /// The warnings about the file so far, as a list of diagnostics.
    pub fn warnings(&self) -> Result<String> {
        let warnings = self.source.warnings().iter();
        let warnings: Vec<Diagnostic> = warnings.map(Warning::diagnostic).collect();
        Ok(serde_json::to_string(&warnings)?)
    }

    /// Where sound was lost so far, as a list of gaps.
    pub fn gaps(&self) -> Result<String> {
        Ok(serde_json::to_string(self.source.gaps())?)
    }
}

/// A drop as a link to a page, and its QR code.
#[wasm_bindgen(js_name = dropLink)]
pub fn drop_link(drop: &str, page: &str) -> Result<String> {
    let link = link::link(&serde_json::from_str(drop)?, page)?;
    Ok(serde_json::to_string(&link)?)
}

/// Any other link with its QR code.
#[wasm_bindgen(js_name = qrCode)]
pub fn qr_code(address: String) -> Result<String> {
    Ok(serde_json::to_string(&link::qr_code(address)?)?)
}

/// The text of a QR code in a picture of these grey levels, row by row, if there is one.
#[wasm_bindgen(js_name = readQrCode)]
pub fn read_qr_code(grey: &[u8], width: usize) -> Option<String> {
    link::read_qr_code(grey, width)
}

/// The lesson sheet of this name for pupils who use the page at this address, as HTML or as Markdown.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen]
pub fn sheet(
    name: &str,
    is_markdown: bool,
    address: String,
    code: &str,
    sources: Vec<String>,
) -> Result<String> {
    let translator = translator(code, &sources)?;
    let sheet = Sheet::named(name).ok_or_else(|| Refusal::fault("there is no such sheet"))?;
    let page = Some(&link::qr_code(address)?);
    Ok(if is_markdown {
        sheet.markdown(page, &translator)?
    } else {
        sheet.html(page, &translator)?
    })
}

/// The drop of a link.
#[wasm_bindgen(js_name = linkedDrop)]
pub fn linked_drop(code: &str) -> Result<String> {
    Ok(serde_json::to_string(&LinkedDrop::of_code(code)?)?)
}

/// The rules by which drops can be judged, in a language by its code and its files.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen]
pub fn rules(code: &str, sources: Vec<String>) -> Result<String> {
    let choices = verdict::choices(&translator(code, &sources)?)?;
    Ok(serde_json::to_string(&choices)?)
}

/// The SHA-256 of the content of a file, in hexadecimal.
#[wasm_bindgen]
pub fn sha256(bytes: &[u8]) -> String {
    hash(bytes).to_string()
}

/// The files of a new job.
#[wasm_bindgen(js_name = newJob)]
pub fn new_job(request: &str) -> Result<String> {
    Ok(serde_json::to_string(&job::new(&serde_json::from_str(
        request,
    )?)?)?)
}

/// A job after a change, if there is one, in a language by its code and its files.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen(js_name = job)]
pub fn show_job(
    files: &str,
    change: Option<String>,
    code: &str,
    sources: Vec<String>,
) -> Result<String> {
    let change = change
        .map(|change| serde_json::from_str(&change))
        .transpose()?;
    let translator = translator(code, &sources)?;
    let shown = job::show(serde_json::from_str(files)?, change, &translator)?;
    Ok(serde_json::to_string(&shown)?)
}

/// The report of a job as one HTML file.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen(js_name = jobReport)]
pub fn job_report(
    files: &str,
    check: &str,
    one_page: bool,
    code: &str,
    sources: Vec<String>,
) -> Result<String> {
    let translator = translator(code, &sources)?;
    let (files, check) = (serde_json::from_str(files)?, serde_json::from_str(check)?);
    job::report(files, check, one_page, &translator)
}

/// The study of many drops, in a language by its code and its files.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen]
pub fn study(request: &str, code: &str, sources: Vec<String>) -> Result<String> {
    let studied = groups::study(
        &serde_json::from_str(request)?,
        &translator(code, &sources)?,
    )?;
    Ok(serde_json::to_string(&studied)?)
}

/// Charts that compare drops: the restitution of each, and that of their impacts against speed.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen(js_name = dropCharts)]
pub fn drop_charts(drops: &str, code: &str, sources: Vec<String>) -> Result<String> {
    let drops: Vec<ComparedDrop> = serde_json::from_str(drops)?;
    let drops: Vec<DropSummary> = drops.into_iter().map(DropSummary::from).collect();
    let translator = translator(code, &sources)?;
    let charts = [
        figure::drops(&drops, &translator),
        figure::drop_impacts(&drops, &translator),
    ];
    Ok(serde_json::to_string(&charts)?)
}

/// The report of it as one HTML file.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen(js_name = studyReport)]
pub fn study_report(request: &str, code: &str, sources: Vec<String>) -> Result<String> {
    groups::report(
        &serde_json::from_str(request)?,
        &translator(code, &sources)?,
    )
}

/// The paper's numbers, `bouncelab.paper/1`.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen(js_name = paperDocument)]
pub fn paper_document(code: &str, sources: Vec<String>) -> Result<String> {
    Ok(serde_json::to_string(&paper::Document::new(
        &paper::chapters()?,
        paper::explanations()?,
        &translator(code, &sources)?,
    ))?)
}

/// The charts of the lesson about the paper: the log-linear fit, drag, and heights.
#[expect(
    clippy::needless_pass_by_value,
    reason = "JavaScript hands over a vector"
)]
#[wasm_bindgen(js_name = lessonCharts)]
pub fn lesson_charts(code: &str, sources: Vec<String>) -> Result<String> {
    let charts = lesson::charts(&translator(code, &sources)?)?;
    Ok(serde_json::to_string(&charts)?)
}
