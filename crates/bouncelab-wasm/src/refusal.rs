//! Why was it not done?

use crate::wire::{Refusal, RefusalKind};

/// A result for the page.
pub type Result<T> = std::result::Result<T, Refusal>;

impl From<bouncelab::Error> for Refusal {
    fn from(error: bouncelab::Error) -> Self {
        Self {
            kind: RefusalKind::Setting,
            message: error.to_string(),
        }
    }
}

impl From<bouncelab_report::Error> for Refusal {
    fn from(error: bouncelab_report::Error) -> Self {
        Self {
            kind: RefusalKind::Fault,
            message: error.to_string(),
        }
    }
}

impl From<bouncelab_audio::Error> for Refusal {
    fn from(error: bouncelab_audio::Error) -> Self {
        use bouncelab_audio::Error;
        let kind = match error {
            Error::Empty { .. } => RefusalKind::Empty,
            Error::NotSound { .. }
            | Error::NoAudioTrack { .. }
            | Error::UnsupportedCodec { .. }
            | Error::UnsupportedLayout { .. } => RefusalKind::Unsupported,
            Error::Times { .. } => RefusalKind::Times,
            Error::Malformed { .. } | Error::Io { .. } => RefusalKind::Damaged,
            _ => RefusalKind::Fault,
        };
        Self {
            kind,
            message: error.to_string(),
        }
    }
}

impl From<serde_json::Error> for Refusal {
    fn from(error: serde_json::Error) -> Self {
        Self {
            kind: RefusalKind::Fault,
            message: format!("the page and the science do not understand each other: {error}"),
        }
    }
}

/// A refusal as it is thrown.
#[cfg(target_family = "wasm")]
impl From<Refusal> for wasm_bindgen::JsValue {
    fn from(refusal: Refusal) -> Self {
        let json = serde_json::to_string(&refusal);
        Self::from_str(&json.unwrap_or(refusal.message))
    }
}
