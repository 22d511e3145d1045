//! Names the build by the sources on which results depend, for the keys of the journal.

#![expect(clippy::disallowed_methods, reason = "names of files of the project")]

use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// What results depend on, as seen from this crate. In a package only the first is there; then the
/// versions of the libraries say all.
const SOURCES: [&str; 4] = [
    "src",
    "../bouncelab/src",
    "../bouncelab-audio/src",
    "../../Cargo.lock",
];

fn main() -> io::Result<()> {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let mut hasher = DefaultHasher::new();
    for source in SOURCES.map(|source| here.join(source)) {
        println!("cargo:rerun-if-changed={}", source.display());
        add(&source, &mut hasher)?;
    }
    println!("cargo:rustc-env=BOUNCELAB_BUILD={:016x}", hasher.finish());
    Ok(())
}

/// Adds a file, or all files of a folder in the order of their names.
fn add(path: &Path, hasher: &mut DefaultHasher) -> io::Result<()> {
    if path.is_dir() {
        let mut inside: Vec<PathBuf> = fs::read_dir(path)?
            .map(|entry| entry.map(|entry| entry.path()))
            .collect::<io::Result<_>>()?;
        inside.sort();
        return inside.iter().try_for_each(|path| add(path, hasher));
    }
    if path.is_file() {
        hasher.write(path.file_name().unwrap_or_default().as_encoded_bytes());
        hasher.write(&fs::read(path)?);
    }
    Ok(())
}
