//! Checksums of sound files.

use crc::{CRC_8_SMBUS, CRC_16_UMTS, Crc};

/// That of the header of a FLAC frame (RFC 9639, section 9.1.8).
pub(crate) const FLAC_HEADER: Crc<u8> = Crc::<u8>::new(&CRC_8_SMBUS);
/// That of a whole FLAC frame (RFC 9639, section 9.3).
pub(crate) const FLAC_FRAME: Crc<u16> = Crc::<u16>::new(&CRC_16_UMTS);
/// That of an Ogg page (RFC 3533, section 6).
#[cfg(feature = "fuzz")]
pub(crate) const OGG_PAGE: Crc<u32> = Crc::<u32>::new(&crc::Algorithm {
    width: 32,
    poly: 0x04c1_1db7,
    init: 0,
    refin: false,
    refout: false,
    xorout: 0,
    check: 0x89a1_897f,
    residue: 0,
});
