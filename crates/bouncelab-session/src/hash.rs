//! Hashes of the content of recordings, and of the settings.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

pub use bouncelab_report::hash::{Hash, hash, hash_of};
use sha2::{Digest, Sha256};

use crate::error::{Error, Result};

/// Maximum length of a file in bytes: more than a recording of a day. A sparse file may be longer, and reading it would
/// take hours.
const MAX_LEN: u64 = 1 << 38;

/// The hash of the content of a file, read in pieces.
///
/// # Errors
/// [`Error::Read`] if it cannot be read, or is a device or a pipe, which may have no end.
pub fn hash_of_file(path: &Path) -> Result<Hash> {
    open(path).and_then(hash_of_all).map_err(Error::read(path))
}

/// Opens a file; refuses devices and pipes, which may have no end.
pub(crate) fn open(path: &Path) -> io::Result<File> {
    let about = fs::metadata(path)?;
    let problem = match about.len() {
        _ if !about.is_file() => "it is a folder, a device or a pipe",
        ..=MAX_LEN => return File::open(path),
        _ => "it is larger than 256 GB; cut it into parts",
    };
    Err(io::Error::new(io::ErrorKind::InvalidInput, problem))
}

/// The hash of everything that a reader returns, read in pieces.
pub(crate) fn hash_of_all(mut reader: impl Read) -> io::Result<Hash> {
    /// Length of a piece in bytes.
    const PIECE: usize = 1 << 16;
    let mut sha = Sha256::new();
    let mut piece = vec![0; PIECE];
    loop {
        match reader.read(&mut piece)? {
            0 => return Ok(Hash::from(<[u8; 32]>::from(sha.finalize()))),
            length => sha.update(&piece[..length]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn what_has_no_end_is_refused() {
        let refused = hash_of_file(Path::new("/dev/zero"))
            .unwrap_err()
            .to_string();
        assert!(refused.contains("a device"), "{refused}");
        let file = tempfile::NamedTempFile::new().unwrap();
        file.as_file().set_len(MAX_LEN + 1).unwrap();
        let refused = hash_of_file(file.path()).unwrap_err().to_string();
        assert!(refused.contains("256 GB"), "{refused}");
    }

    #[test]
    fn the_hash_of_a_file_is_that_of_its_content() {
        let file = tempfile::NamedTempFile::new().unwrap();
        for content in ["", "abc"] {
            fs::write(file.path(), content).unwrap();
            assert_eq!(hash_of_file(file.path()).unwrap(), hash(content.as_bytes()));
        }
    }
}
