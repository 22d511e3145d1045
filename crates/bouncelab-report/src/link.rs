//! A drop as the end of a link: its impact times, what was stated of it, its name and its surface.
//!
//! ```
//! use bouncelab::settings::Settings;
//! use bouncelab_report::link::LinkedDrop;
//!
//! let drop = LinkedDrop {
//!     name: "Anna, first try".to_owned(),
//!     surface: "wood".to_owned(),
//!     settings: Settings::of_ball("tennis"),
//!     times_s: vec![0.0, 0.4605, 0.8877, 1.2854],
//! };
//! let code = drop.code()?;
//! assert_eq!(LinkedDrop::of_code(&code)?, drop);
//! assert!(LinkedDrop::of_code(&code[1..]).is_err());
//! # Ok::<(), bouncelab_report::link::LinkProblem>(())
//! ```
//!
//! Times are counted in steps of 10 µs. Written is by how much each flight differs from the one before it: small
//! numbers, each in as few bytes as it takes. What was stated is JSON without what was
//! not. A CRC-32 over all of it detects changes on the way; the text is Base64 for addresses (RFC 4648, section 5).

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use bouncelab::settings::{AnalysisSettings, InferenceSettings, Settings};
use crc::{CRC_32_ISO_HDLC, Crc};
use serde::{Deserialize, Serialize, Serializer, ser};
use serde_json::Value;

/// Steps of the times in a second.
const STEPS_PER_S: f64 = 1e5;
/// The last time in steps: ten days, while a recording lasts one at most.
const LAST_STEP: i64 = 100_000_000_000;
/// A drop has fewer impacts, and a QR code holds no more.
const MAX_IMPACTS: usize = 1000;
/// Letters of a name and of a surface; the rest is left out.
const MAX_LETTERS: usize = 60;
/// The form of what is packed; another whenever it changes.
const VERSION: u8 = 3;

const CHECK: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);

/// A drop that is sent to others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct LinkedDrop {
    /// What it is called.
    pub name: String,
    /// On what it was dropped; empty if that was not given.
    pub surface: String,
    /// What was stated of ball, air, gravity and drop, the laws, inferred inputs and flights: what the form of the page offers.
    #[serde(serialize_with = "as_stated")]
    pub settings: Settings,
    /// The impact times, increasing.
    pub times_s: Vec<f64>,
}

/// A link, such as that of a drop, with its QR code.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct DropLink {
    /// The whole address.
    pub address: String,
    /// Modules on each side of its QR code.
    pub modules: u32,
    /// The dark modules, as a path of SVG.
    pub path: String,
}

/// Why there is no link of a drop, or no drop of a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, thiserror::Error)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum LinkProblem {
    /// It is not the whole text, or another.
    #[error("the link was changed, or is incomplete")]
    Changed,
    /// It was packed in another form.
    #[error("another version of the page made the link")]
    OtherVersion,
    /// Impact times that no drop has.
    #[error("a link holds 2 to 1000 impacts, each at least 10 µs after the one before")]
    Times,
    /// The link is too long for a QR code.
    #[error("the drop has too many impacts for a QR code")]
    TooLong,
}

/// What the text holds.
#[derive(Serialize, Deserialize)]
struct Packed<'a> {
    version: u8,
    name: &'a str,
    surface: &'a str,
    settings: &'a str,
    /// The differences of the differences of the times, in steps.
    steps: Vec<i64>,
}

impl LinkedDrop {
    /// The text at the end of a link: letters, digits, `-` and `_`.
    ///
    /// # Errors
    ///
    /// [`LinkProblem::Times`] if there are no times, too many, or some do not increase by at least 10 µs.
    ///
    /// # Panics
    ///
    /// Never: what is packed is plain data.
    pub fn code(&self) -> Result<String, LinkProblem> {
        let steps = self
            .times_s
            .iter()
            .map(|time_s| (time_s * STEPS_PER_S).round() as i64);
        let steps = train(steps.collect())?;
        let shortened = |text: &str| text.chars().take(MAX_LETTERS).collect::<String>();
        let (name, surface) = (shortened(&self.name), shortened(&self.surface));
        let settings = stated(&offered(&self.settings)).expect("settings are plain data");
        let settings = settings.to_string();
        let packed = Packed {
            version: VERSION,
            name: &name,
            surface: &surface,
            settings: &settings,
            steps: differences(&differences(&steps)),
        };
        let mut bytes = postcard::to_allocvec(&packed).expect("they are plain data");
        bytes.extend(CHECK.checksum(&bytes).to_be_bytes());
        Ok(URL_SAFE_NO_PAD.encode(bytes))
    }

    /// The drop of a text that [`code`](Self::code) made.
    ///
    /// # Errors
    ///
    /// [`LinkProblem`] if a letter of it was changed, added or lost, or another version made it.
    pub fn of_code(code: &str) -> Result<Self, LinkProblem> {
        use LinkProblem::{Changed, OtherVersion};
        let bytes = URL_SAFE_NO_PAD.decode(code).map_err(|_| Changed)?;
        let (packed, check) = bytes.split_last_chunk::<4>().ok_or(Changed)?;
        if CHECK.checksum(packed) != u32::from_be_bytes(*check) {
            return Err(Changed);
        }
        let packed: Packed = postcard::from_bytes(packed).map_err(|_| OtherVersion)?;
        if packed.version != VERSION {
            return Err(OtherVersion);
        }
        let steps = train(sums(&sums(&packed.steps)?)?)?;
        let settings: Settings = serde_json::from_str(packed.settings).map_err(|_| OtherVersion)?;
        if settings != offered(&settings) {
            return Err(OtherVersion);
        }
        Ok(Self {
            name: packed.name.to_owned(),
            surface: packed.surface.to_owned(),
            settings,
            times_s: steps
                .into_iter()
                .map(|step| step as f64 / STEPS_PER_S)
                .collect(),
        })
    }
}

/// The settings of a link. Others, such as the number of draws, are the reader's: a link could make them wait for minutes.
fn offered(settings: &Settings) -> Settings {
    Settings {
        ball: settings.ball.clone(),
        air: settings.air.clone(),
        gravity: settings.gravity.clone(),
        drop: settings.drop.clone(),
        analysis: AnalysisSettings {
            flights: settings.analysis.flights,
            ..AnalysisSettings::default()
        },
        inference: InferenceSettings {
            restitution_laws: settings.inference.restitution_laws.clone(),
            infer: settings.inference.infer.clone(),
            ..InferenceSettings::default()
        },
        ..Settings::default()
    }
}

/// The times of a drop, in steps, if they can be that.
fn train(steps: Vec<i64>) -> Result<Vec<i64>, LinkProblem> {
    let is_near = |step: &i64| (-LAST_STEP..=LAST_STEP).contains(step);
    let is_train = (2..=MAX_IMPACTS).contains(&steps.len())
        && steps.iter().all(is_near)
        && steps.is_sorted_by(|a, b| a < b);
    is_train.then_some(steps).ok_or(LinkProblem::Times)
}

/// The first number, and by how much each differs from the one before it.
fn differences(numbers: &[i64]) -> Vec<i64> {
    let before = std::iter::once(0).chain(numbers.iter().copied());
    numbers
        .iter()
        .zip(before)
        .map(|(number, before)| number - before)
        .collect()
}

/// The numbers with these differences.
fn sums(differences: &[i64]) -> Result<Vec<i64>, LinkProblem> {
    let sums = differences.iter().scan(0_i64, |sum, difference| {
        let next = sum.checked_add(*difference);
        *sum = next.unwrap_or_default();
        Some(next)
    });
    sums.collect::<Option<_>>().ok_or(LinkProblem::Times)
}

/// Settings as JSON, without what was not stated.
fn stated(settings: &Settings) -> serde_json::Result<Value> {
    let mut value = serde_json::to_value(settings)?;
    if let Some(groups) = value.as_object_mut() {
        groups.retain(|_, group| {
            group.as_object_mut().is_some_and(|fields| {
                fields.retain(|_, value| !value.is_null());
                !fields.is_empty()
            })
        });
    }
    Ok(value)
}

/// Settings without those that were not stated.
pub(crate) fn as_stated<S: Serializer>(
    settings: &Settings,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let stated = stated(settings).map_err(ser::Error::custom)?;
    stated.serialize(serializer)
}
