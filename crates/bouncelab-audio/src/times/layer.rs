//! Layers of Sonic Visualiser: XML with a model, whose points have frames of its sample rate, as its source documents.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::{Entry, Result};
use crate::problem::TimesProblem;

/// The times of the points of a layer.
pub(super) fn points(text: &str) -> Result<Vec<Entry>> {
    let mut reader = Reader::from_str(text);
    let mut rate_hz = None;
    let mut frames = Vec::new();
    loop {
        let event = reader.read_event().map_err(|fault| damaged(&fault))?;
        match event {
            Event::Start(element) | Event::Empty(element) => match element.local_name().as_ref() {
                "model" => rate_hz = rate_hz.or(attribute(&element, "sampleRate")),
                "point" => frames.extend(attribute(&element, "frame")),
                _ => {}
            },
            Event::Eof => break,
            _ => {}
        }
    }
    let rate_hz = rate_hz.filter(|&rate_hz| rate_hz > 0.0);
    let rate_hz = rate_hz.ok_or((None, TimesProblem::NotLayer))?;
    Ok(frames
        .into_iter()
        .map(|frame| (None, frame / rate_hz))
        .collect())
}

fn attribute(element: &BytesStart<'_>, name: &str) -> Option<f64> {
    let attribute = element.try_get_attribute(name).ok()??;
    attribute.value.parse().ok()
}

fn damaged(fault: &quick_xml::Error) -> (Option<usize>, TimesProblem) {
    let detail = fault.to_string();
    (None, TimesProblem::NotTable { detail })
}
