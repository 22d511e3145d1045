//! Small files that claim much.

use crate::checksum::{FLAC_FRAME, FLAC_HEADER};

/// Samples of each channel in a frame of [`flac`]: the most that a frame can hold.
const FRAME: u16 = u16::MAX;

/// A FLAC of the frames of these numbers, each of 65,535 samples, each channel constant within a frame and another in
/// the next.
pub fn flac(sample_rate_hz: u32, channels: u8, frames: impl IntoIterator<Item = u32>) -> Vec<u8> {
    let mut file = b"fLaC\x80\0\0\x22".to_vec();
    file.extend(FRAME.to_be_bytes());
    file.extend(FRAME.to_be_bytes());
    // Sizes of frames, unknown.
    file.extend([0; 6]);
    // 20 bits of rate, 3 of channels, 5 of bits less one, 36 of samples, unknown.
    let layout = u64::from(sample_rate_hz) << 44 | u64::from(channels - 1) << 41 | 15 << 36;
    file.extend(layout.to_be_bytes());
    // No MD5.
    file.extend([0; 16]);
    for number in frames {
        file.extend(frame(channels, number));
    }
    file
}

fn frame(channels: u8, number: u32) -> Vec<u8> {
    // A fixed size of blocks, 16 bits of size less one at the end, the rate of the head, 16 bits a sample.
    let mut frame = vec![0xff, 0xf8, 0x70, (channels - 1) << 4 | 0x08];
    let mut digits = [0; 4];
    let number_as_text = char::from_u32(number).expect("so few frames");
    frame.extend(number_as_text.encode_utf8(&mut digits).bytes());
    frame.extend((FRAME - 1).to_be_bytes());
    frame.push(FLAC_HEADER.checksum(&frame));
    for channel in 0..u32::from(channels) {
        // A constant.
        frame.push(0);
        let sample = (number * 7_919 + channel * 104_729) % 60_000;
        frame.extend((sample as u16).wrapping_sub(30_000).to_be_bytes());
    }
    frame.extend(FLAC_FRAME.checksum(&frame).to_be_bytes());
    frame
}
