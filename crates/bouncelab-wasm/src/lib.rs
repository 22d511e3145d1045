//! bouncelab for the browser.
#![allow(missing_docs)]
pub mod wire;
#[cfg(target_family = "wasm")]
use wasm_bindgen::prelude::*;

#[cfg(target_family = "wasm")]
#[wasm_bindgen]
pub fn probe(bytes: Vec<u8>, name: &str) -> String {
    use bouncelab::analysis::{self, Impact, Settings};
    let Ok(mut source) = bouncelab_audio::Source::from_bytes(bytes, name) else {
        return String::new();
    };
    let mut listener = bouncelab::listen::Listener::new(source.sample_rate_hz(), source.channels());
    while let Ok(Some(block)) = source.next_block() {
        let slices: Vec<&[f32]> = (0..block.channels()).map(|i| block.channel(i)).collect();
        listener.push(&slices);
    }
    let heard = listener.finish();
    let settings = Settings::default();
    let drops: Vec<_> = heard
        .found
        .trains
        .iter()
        .map(|t| analysis::analyze(t.impacts().iter().map(Impact::from).collect(), &settings))
        .collect();
    let doc = bouncelab_report::document::Document::new(
        name,
        bouncelab_report::document::Origin::Times,
        &settings,
        vec![],
        &drops,
        vec![],
    );
    let figure = bouncelab_report::figure::height(&[], &[]);
    serde_json::to_string(&doc).unwrap_or_default() + &figure.svg()
}
