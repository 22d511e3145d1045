//! What the fuzz targets do with their bytes. The tests of the workspace do the same with the
//! corpus (`crates/*/tests/corpus.rs`), so that a stable compiler checks it too.

pub mod decode;
pub mod listener;

/// Panics inside a third-party decoder are caught and become errors; only those that get out are
/// findings. libFuzzer's hook would end the process at each.
pub fn let_decoders_panic() {
    std::panic::set_hook(Box::new(|_| ()));
}
