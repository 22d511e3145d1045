//! Containers that nothing in the project writes: WAV files of long recordings, AIFF and CAF.
//!
//! The layouts are those of EBU Tech 3306 (RF64), ITU-R BS.2088 (BW64), Sonic Foundry's description of
//! Wave64, and Apple's specifications of AIFF 1.3 and of the Core Audio Format. Each takes the sound of a WAV file as
//! [`bouncelab_audio::encode_wav`] makes it of integers.

/// Where the description of the sound of such a WAV file lies, and where its samples begin.
const FORMAT: std::ops::Range<usize> = 20..36;
const SOUND: usize = 44;

/// A chunk with another size than its own.
fn chunk(name: &[u8], size: u32, content: &[u8]) -> Vec<u8> {
    [name, &size.to_le_bytes(), content].concat()
}

/// RF64 or BW64, by the marker, with the size of the sound that is announced, and what follows the sound.
pub fn rf64(marker: [u8; 4], wav: &[u8], announced: u64, tail: &[u8]) -> Vec<u8> {
    let sizes = [0, announced, 0].map(u64::to_le_bytes).concat();
    let sizes = [sizes, vec![0; 4]].concat();
    let chunks = [
        b"WAVE".to_vec(),
        chunk(b"ds64", 28, &sizes),
        chunk(b"fmt ", 16, &wav[FORMAT]),
        chunk(b"data", u32::MAX, &wav[SOUND..]),
        tail.to_vec(),
    ];
    chunk(&marker, u32::MAX, &chunks.concat())
}

/// W64, with the size that its sound announces, which counts its own header of 24 bytes.
pub fn w64(wav: &[u8], announced: u64, tail: &[u8]) -> Vec<u8> {
    let rest = b"\xf3\xac\xd3\x11\x8c\xd1\x00\xc0\x4f\x8e\xdb\x8a";
    let chunk = |name: &[u8], size: u64, content: &[u8]| {
        [name, rest, &size.to_le_bytes(), content].concat()
    };
    let file = b"riff\x2e\x91\xcf\x11\xa5\xd6\x28\xdb\x04\xc1\x00\x00";
    [
        file.to_vec(),
        0_u64.to_le_bytes().to_vec(),
        [b"wave", &rest[..]].concat(),
        // Of odd length: what follows begins at the next multiple of eight.
        chunk(b"note", 24 + 3, &[1; 8]),
        chunk(b"fmt ", 24 + 16, &wav[FORMAT]),
        chunk(b"data", announced, &wav[SOUND..]),
        tail.to_vec(),
    ]
    .concat()
}

/// CAF with the samples of a WAV file of one channel of 16 bits.
pub fn caf(wav: &[u8], sample_rate_hz: u32) -> Vec<u8> {
    const LITTLE_ENDIAN: u32 = 2;
    let chunk = |name: &[u8], content: &[u8]| {
        [name, &(content.len() as u64).to_be_bytes(), content].concat()
    };
    // Flags, bytes and frames of a packet, channels, bits.
    let numbers = [LITTLE_ENDIAN, 2, 1, 1, 16].map(u32::to_be_bytes).concat();
    let description = [
        &f64::from(sample_rate_hz).to_be_bytes()[..],
        b"lpcm",
        &numbers,
    ];
    let edits = [0; 4];
    [
        b"caff\x00\x01\x00\x00".to_vec(),
        chunk(b"desc", &description.concat()),
        chunk(b"data", &[&edits[..], &wav[SOUND..]].concat()),
    ]
    .concat()
}

/// AIFF with the samples of a WAV file of one channel of 16 bits.
pub fn aiff(wav: &[u8], sample_rate_hz: u32) -> Vec<u8> {
    let chunk = |name: &[u8], content: &[u8]| {
        [name, &(content.len() as u32).to_be_bytes(), content].concat()
    };
    let (samples, _) = wav[SOUND..].as_chunks::<2>();
    let sound: Vec<u8> = samples
        .iter()
        .flat_map(|&[low, high]| [high, low])
        .collect();
    // The rate has 80 bits: an exponent, then the number with its highest bit in front.
    let shift = sample_rate_hz.leading_zeros();
    let exponent = (16_383 + 31 - shift) as u16;
    let description = [
        &1_u16.to_be_bytes()[..],
        &(samples.len() as u32).to_be_bytes(),
        &16_u16.to_be_bytes(),
        &exponent.to_be_bytes(),
        &(sample_rate_hz << shift).to_be_bytes(),
        &[0; 4],
    ];
    let chunks = [
        b"AIFF".to_vec(),
        chunk(b"COMM", &description.concat()),
        chunk(b"SSND", &[&[0; 8][..], &sound].concat()),
    ];
    chunk(b"FORM", &chunks.concat())
}
