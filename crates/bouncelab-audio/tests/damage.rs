//! No damage to a file of any format makes a wrong result that looks like a right one. `cargo xtask damage`
//! tries every percent of each file, with the inference; here it is one place of each damage without.

use bouncelab::Options;
use bouncelab::analysis::Gap;
use bouncelab::diagnostic::Code;
use bouncelab_audio::{SoundReader, Warning};
use bouncelab_testkit::damage::{Damage, Verdict, analyse, files, is_warned, judge, words};

#[test]
fn no_damage_makes_a_wrong_result_that_looks_right() {
    let options = Options::default().without_inference();
    for (name, file) in files() {
        let whole = analyse(&file, &name, &options).expect(&name);
        assert_eq!(whole.drops.len(), 1, "{name}");
        assert!(!is_warned(&whole), "{name}: {:?}", whole.diagnostics);
        let places = [22, 45, 37, 81, 23, 50, 40, 41, 43, 60, 3];
        // Nothing counts the frames of these streams, and no checksum covers the packets of these codecs.
        let is_uncounted = name == "aac.aac" || name.contains("no-tag");
        let is_unchecked = [
            "aac",
            "opus.",
            "opus-",
            "alac",
            "constant.mkv",
            "vorbis.mkv",
        ];
        let is_unchecked = is_uncounted || is_unchecked.iter().any(|it| name.starts_with(it));
        for (damage, percent) in Damage::ALL.into_iter().zip(places) {
            let is_not_promised = match damage {
                Damage::Dropped | Damage::Repeated | Damage::Inserted => is_uncounted,
                Damage::Bits => is_unchecked,
                _ => false,
            };
            if is_not_promised {
                continue;
            }
            let damaged = analyse(&damage.at(percent, &file), &name, &options);
            let verdict = judge(&whole, damaged.as_ref().ok());
            let numbers = words(&damaged);
            assert_ne!(
                verdict,
                Verdict::Wrong,
                "{name}, {damage:?} at {percent} %: {numbers}"
            );
        }
    }
}

/// How long the sound of a file is, and where it lacks some.
fn read(file: &[u8], name: &str) -> (f64, Vec<Gap>) {
    let mut source = SoundReader::from_bytes(file, name).expect(name);
    let mut frames = 0;
    while let Some(block) = source.next_block().expect(name) {
        assert_eq!(block.start_frame(), frames, "{name}");
        frames += block.frames() as u64;
    }
    let duration_s = frames as f64 / f64::from(source.sample_rate_hz());
    (duration_s, source.gaps().to_vec())
}

/// Clocks that say where a packet belongs, and frames of constant length: times after a gap hold.
#[test]
fn where_the_length_is_known_silence_of_that_length_stands_in_the_gap() {
    let exact = [
        "sound.flac",
        "flac.ogg",
        "vorbis.ogg",
        "opus.ogg",
        "aac.m4a",
        "constant.mp3",
        "constant-no-tag.mp3",
    ];
    for (name, file) in files() {
        if !exact.contains(&name.as_str()) {
            continue;
        }
        let (whole_s, gaps) = read(&file, &name);
        assert_eq!(gaps, [], "{name}");
        let (damaged_s, gaps) = read(&Damage::Zeros.at(50, &file), &name);
        assert!(
            (damaged_s - whole_s).abs() < 2e-3,
            "{name}: {damaged_s} s of {whole_s} s"
        );
        let [gap] = gaps[..] else {
            panic!("{name}: {gaps:?}");
        };
        assert!(gap.certain, "{name}");
        // Half the bytes are not quite half the time: loud parts take more.
        let middle = 0.3 * whole_s..0.7 * whole_s;
        let is_there = gap.start_s < middle.end && middle.start < gap.end_s();
        assert!(is_there, "{name}: {gap:?} of {whole_s} s");
    }
}

/// Without a clock the number of frames in place of missing bytes is unknown.
#[test]
fn where_the_length_is_not_known_the_clock_is_another_one() {
    for (name, file) in files() {
        if ["aac.aac", "constant-no-tag.mp3", "variable-no-tag.mp3"].contains(&name.as_str()) {
            let (_, gaps) = read(&Damage::Removed.at(50, &file), &name);
            assert!(
                matches!(gaps[..], [Gap { certain: false, .. }]),
                "{name}: {gaps:?}"
            );
        }
    }
}

/// The demuxer in use gives up on one.
#[test]
fn an_early_page_of_ogg_that_is_damaged_costs_no_more_than_itself() {
    for (name, file) in files() {
        if name.contains("ogg") {
            let (whole_s, _) = read(&file, &name);
            let (damaged_s, gaps) = read(&Damage::Bit.at(15, &file), &name);
            assert!(
                (damaged_s - whole_s).abs() < 2e-3,
                "{name}: {damaged_s} s of {whole_s} s"
            );
            assert_eq!(gaps.len(), 1, "{name}: {gaps:?}");
        }
    }
}

#[test]
fn a_flac_with_a_wrong_checksum_is_reported_as_altered() {
    let (name, mut file) = files()
        .into_iter()
        .find(|(name, _)| name == "sound.flac")
        .unwrap();
    // The checksum is the end of the first block, which has 34 bytes behind marker and header.
    file[8 + 33] ^= 1;
    let mut source = SoundReader::from_bytes(file, &name).unwrap();
    while source.next_block().unwrap().is_some() {}
    let read_s = source.duration_s().unwrap();
    assert_eq!(source.warnings(), [Warning::Altered { read_s }]);
}

/// The sound of MP3 with a changed bit is not recognisable as damaged, but the tag has a checksum.
#[test]
fn an_mp3_with_a_wrong_checksum_is_reported_as_altered() {
    for name in ["constant.mp3", "variable.mp3"] {
        let mut file = files().into_iter().find(|it| it.0 == name).unwrap().1;
        let warnings = |file: &[u8]| {
            let mut source = SoundReader::from_bytes(file, name).unwrap();
            while source.next_block().unwrap().is_some() {}
            (source.warnings().to_vec(), source.duration_s().unwrap())
        };
        assert_eq!(warnings(&file).0, []);
        // Behind header and side information of a frame.
        file[5_552] ^= 2;
        let (warnings, read_s) = warnings(&file);
        assert_eq!(warnings, [Warning::Altered { read_s }]);
    }
}

/// It damages the first impact, which is found only because the others sound like it, and only the checksum of the whole stream
/// shows it.
#[test]
fn a_bit_that_damages_an_impact_puts_all_of_the_sound_in_doubt() {
    let name = "constant.mp3";
    let file = files().into_iter().find(|it| it.0 == name).unwrap().1;
    let options = Options::default().without_inference();
    let whole = analyse(&file, name, &options).unwrap();
    let damaged = analyse(&Damage::Bit.at(17, &file), name, &options).unwrap();
    let [before, after] = [&whole, &damaged].map(|it| &it.drops[0].impacts);
    assert_eq!(after.len(), before.len());
    assert!((after[0].time_s - before[0].time_s).abs() > 1e-6);
    assert_ne!(judge(&whole, Some(&damaged)), Verdict::Wrong);
    let doubt = damaged
        .diagnostics
        .iter()
        .find(|it| it.code == Code::ChecksumWrong);
    let [start_s, end_s] = ["start_s", "end_s"].map(|name| doubt.unwrap().number(name).unwrap());
    assert!(start_s <= 0.0 && end_s >= whole.drops[0].impacts.last().unwrap().time_s);
}

/// The first one has none before it that it would have to follow.
#[test]
fn a_first_part_of_mp4_that_cannot_be_read_is_missed() {
    let (name, mut file) = files()
        .into_iter()
        .find(|(name, _)| name == "aac-parts.mp4")
        .unwrap();
    let part = file.windows(4).position(|it| it == b"moof").unwrap();
    file[part] ^= 4;
    let options = Options::default().without_inference();
    assert!(analyse(&file, &name, &options).is_err());
}

/// Bits that alter no length of a code, so that the packet ends where it should.
#[test]
fn a_packet_of_alac_that_becomes_noise_is_missing() {
    let mut file = files().into_iter().find(|it| it.0 == "alac.caf").unwrap().1;
    assert_eq!(read(&file, "alac.caf").1, []);
    for percent in [13, 26] {
        file = Damage::Bit.at(percent, &file);
    }
    let (_, gaps) = read(&file, "alac.caf");
    assert_eq!(gaps.len(), 2, "{gaps:?}");
    for (gap, start_s) in gaps.iter().zip([0.512, 1.024]) {
        assert!((gap.start_s - start_s).abs() < 1e-3, "{gap:?}");
        assert!((gap.duration_s - 0.256).abs() < 1e-3, "{gap:?}");
    }
}

/// Of the tag's counts of frames and bytes both are others; where the frames do not fit together, the place is known.
#[test]
fn frames_of_mp3_that_are_missing_or_repeated_are_noticed_by_the_tag() {
    for name in ["constant.mp3", "variable.mp3"] {
        let file = files().into_iter().find(|it| it.0 == name).unwrap().1;
        for damage in [Damage::Dropped, Damage::Repeated, Damage::Joined] {
            for percent in (5..95).step_by(6) {
                let mut source = SoundReader::from_bytes(damage.at(percent, &file), name).unwrap();
                while source.next_block().unwrap().is_some() {}
                let is_noticed = source.warnings().iter().any(|warning| {
                    matches!(
                        warning,
                        Warning::Altered { .. }
                            | Warning::ClockLost { .. }
                            | Warning::Missing { .. }
                    )
                });
                let warnings = source.warnings();
                assert!(is_noticed, "{name}, {damage:?} at {percent}: {warnings:?}");
            }
        }
    }
}

/// Nothing counts the frames. A copy follows none; a missing frame shows where the sound of the next would begin within that of
/// the one before, or where their windows do not fit, as at an impact.
#[test]
fn frames_of_mp3_that_cannot_follow_each_other_are_noticed() {
    let noticed_s = |file: &[u8], name| {
        let (_, gaps) = read(file, name);
        gaps.first()
            .filter(|gap| !gap.certain)
            .map(|gap| gap.start_s)
    };
    for name in ["constant-no-tag.mp3", "variable-no-tag.mp3"] {
        let file = files().into_iter().find(|it| it.0 == name).unwrap().1;
        assert_eq!(read(&file, name).1, []);
        for percent in (2..98).step_by(3) {
            let found_s = noticed_s(&Damage::Repeated.at(percent, &file), name);
            let true_s = 4.06 * percent as f64 / 100.0;
            assert!(
                found_s.is_some_and(|it| (it - true_s).abs() < 0.1),
                "{name}: {percent}, {found_s:?}"
            );
        }
        // At impacts.
        for percent in [28, 38] {
            assert!(
                noticed_s(&Damage::Dropped.at(percent, &file), name).is_some(),
                "{name}: {percent}"
            );
        }
    }
}

/// Of a recording in parts of a second each the second part is missing, or lists other lengths than follow.
#[test]
fn parts_of_mp4_that_do_not_follow_each_other_end_the_recording() {
    let name = "aac-parts.mp4";
    let file = files().into_iter().find(|it| it.0 == name).unwrap().1;
    assert_eq!(read(&file, name).1, []);
    let parts: Vec<usize> = (0..file.len() - 4)
        .filter(|&at| &file[at..at + 4] == b"moof")
        .map(|at| at - 4)
        .collect();
    let without = [&file[..parts[1]], &file[parts[2]..]].concat();
    // The last byte of the length of a sample, in the list at the end of the part.
    let mut longer = file.clone();
    let sound = file[parts[1]..]
        .windows(4)
        .position(|it| it == b"mdat")
        .unwrap();
    longer[parts[1] + sound - 5] ^= 1;
    for damaged in [without, longer] {
        let mut source = SoundReader::from_bytes(damaged, name).unwrap();
        while source.next_block().unwrap().is_some() {}
        let [Warning::Truncated { read_s, .. }] = *source.warnings() else {
            panic!("{:?}", source.warnings())
        };
        assert!(
            (read_s - 1.0).abs() < 0.05 && source.gaps().is_empty(),
            "{read_s}"
        );
    }
}

/// Changed bits that no checksum covers hide the first impacts under noise, so that the drop seems to come from lower, or alter
/// the rate in one of the two places that state it.
#[test]
fn damage_that_no_checksum_covers_is_named() {
    let options = Options::default().without_inference();
    for (name, damage, places) in [
        ("opus.mp4", Damage::Bits, &[42, 50, 62, 74][..]),
        ("opus.webm", Damage::Bits, &[18]),
        ("alac.caf", Damage::Header, &[134]),
    ] {
        let file = files().into_iter().find(|it| it.0 == name).unwrap().1;
        let whole = analyse(&file, name, &options).unwrap();
        for &place in places {
            let damaged = analyse(&damage.at(place, &file), name, &options);
            let verdict = judge(&whole, damaged.as_ref().ok());
            assert_ne!(verdict, Verdict::Wrong, "{name}, {damage:?} at {place}");
        }
    }
}
