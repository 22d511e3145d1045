//! SHA-256 hashes, of contents and of settings.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use sha2::{Digest, Sha256};

/// A SHA-256 hash, shown and written as hexadecimal digits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Hash([u8; 32]);

impl From<[u8; 32]> for Hash {
    fn from(digest: [u8; 32]) -> Self {
        Self(digest)
    }
}

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

impl Hash {
    /// Its first 128 bits, which two contents do not share by chance.
    pub fn half(&self) -> [u8; 16] {
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
        assert_eq!(hash(b"").to_string(), nothing);
    }
}
