//! What the notes of recordings mean.

use std::collections::BTreeMap;
use std::sync::Arc;

use bouncelab::setup::Setup;

use crate::hash::{Hash, hash};
use crate::journal::Key;
use crate::record::RECORD;
use crate::recordings::Recording;

/// A recording and what is known of it.
#[derive(Debug, Clone)]
pub struct KnownRecording {
    /// The recording.
    pub recording: Recording,
    /// What its notes mean.
    pub metadata: Arc<Metadata>,
}

impl KnownRecording {
    /// What its result depends on: its content, and the settings of this version.
    pub fn key(&self, content: Hash) -> Key {
        let settings = &self.metadata.setup.settings;
        let text = format!("{RECORD} {} {settings:?}", env!("CARGO_PKG_VERSION"));
        Key {
            content,
            settings: hash(text.as_bytes()),
        }
    }

    /// What it is called in tables.
    pub fn name(&self) -> &str {
        &self.recording.name
    }
}

/// What the notes of a recording mean; recordings with the same notes share it.
#[derive(Debug)]
pub struct Metadata {
    /// Ball, air, gravity, priors, and what of them was assumed.
    pub setup: Setup,
    /// What its drops are compared by: "surface", "steel".
    pub factors: BTreeMap<String, String>,
    /// The drop height as noted, m.
    pub height_m: Option<f64>,
    /// The temperature as noted, K.
    pub temperature_k: Option<f64>,
}

impl Metadata {
    /// Whether there is to be an inference.
    pub fn asks_inference(&self) -> bool {
        self.setup.settings.inference.is_some()
    }
}
