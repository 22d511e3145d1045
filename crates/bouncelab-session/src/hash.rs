//! Hashes of the content of recordings, and of the settings.

use std::fmt;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use sha2::{Digest, Sha256};

use crate::error::{Error, Result};

/// Maximum length of a file in bytes: more than a recording of a day. A sparse file may be longer, and reading it would
/// take hours.
const MAX_LEN: u64 = 1 << 38;

/// A SHA-256 hash, shown and written as hexadecimal digits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Hash([u8; 32]);

/// The SHA-256 hash of bytes.
pub fn hash(bytes: &[u8]) -> Hash {
    Hash(Sha256::digest(bytes).into())
}

/// The hash of settings, by their JSON.
///
/// # Panics
/// If they cannot be written as JSON, such as a map whose keys are not texts.
pub fn hash_of(settings: &impl Serialize) -> Hash {
    hash(&serde_json::to_vec(settings).expect("settings are plain data"))
}

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
            0 => return Ok(Hash(sha.finalize().into())),
            length => sha.update(&piece[..length]),
        }
    }
}

impl Hash {
    /// Its first 128 bits, which two contents do not share by chance.
    pub(crate) fn half(&self) -> [u8; 16] {
        let mut half = [0; 16];
        half.copy_from_slice(&self.0[..16]);
        half
    }

    /// Its first 64 bits as a number, such as a seed.
    pub fn number(&self) -> u64 {
        let [a, b, c, d, e, f, g, h, ..] = self.0;
        u64::from_be_bytes([a, b, c, d, e, f, g, h])
    }
}

impl fmt::Display for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl fmt::Debug for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Serialize for Hash {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl std::str::FromStr for Hash {
    type Err = &'static str;

    fn from_str(digits: &str) -> std::result::Result<Self, Self::Err> {
        const WRONG: &str = "a SHA-256 hash has 64 hexadecimal digits";
        let mut hash = [0; 32];
        if digits.len() != 64 || !digits.is_ascii() {
            return Err(WRONG);
        }
        for (index, byte) in hash.iter_mut().enumerate() {
            let pair = &digits[2 * index..2 * index + 2];
            *byte = u8::from_str_radix(pair, 16).map_err(|_| WRONG)?;
        }
        Ok(Self(hash))
    }
}

impl<'de> Deserialize<'de> for Hash {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        let digits = String::deserialize(deserializer)?;
        digits.parse().map_err(de::Error::custom)
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

    /// FIPS 180-2, appendix B.1, and the empty file of FIPS 180-4's example programs.
    #[test]
    fn hashes_are_those_of_the_standard() {
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(hash(b"abc").to_string(), abc);
        assert_eq!(abc.parse(), Ok(hash(b"abc")));
        assert!(
            abc[1..].parse::<Hash>().is_err() && abc.replace('b', "g").parse::<Hash>().is_err()
        );
        assert_eq!(hash(b"abc").number(), 0xba78_16bf_8f01_cfea);
        let nothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
        let file = tempfile::NamedTempFile::new().unwrap();
        let of_file = || hash_of_file(file.path()).unwrap().to_string();
        assert_eq!(of_file(), nothing);
        fs::write(file.path(), "abc").unwrap();
        assert_eq!(of_file(), abc);
    }
}
