//! Lists of impact times: what is read, and which line is blamed when it is not.

use std::fs;

use bouncelab_audio::{Error, Input, times};

fn parse(text: &str, name: &str) -> Vec<f64> {
    times::parse(text.as_bytes(), name).unwrap().times_s
}

/// The line that is blamed, and the whole message.
fn blame(text: &str, name: &str) -> (Option<usize>, String) {
    match times::parse(text.as_bytes(), name) {
        Err(error @ Error::Times { line, .. }) => (line, error.to_string()),
        other => panic!("{other:?}"),
    }
}

#[test]
fn text_has_one_time_a_line_with_comments_and_blank_lines() {
    let text = "# ball 3\r\n\r\n 0.10 \r\n4.5e-1\r\n  # the third is faint\n0.72";
    assert_eq!(parse(text, "a.txt"), [0.10, 0.45, 0.72]);
}

#[test]
fn a_table_without_header_has_one_column() {
    assert_eq!(parse("0.1\n0.45\n", "a.csv"), [0.1, 0.45]);
}

#[test]
fn a_column_is_found_by_its_name() {
    for header in ["time", "time_s", "TIME_S", "\"time\""] {
        let text = format!("impact,{header},note\n1,0.1,\"loud, near\"\n2,0.45,\n");
        assert_eq!(parse(&text, "a.csv"), [0.1, 0.45], "{header}");
    }
}

#[test]
fn a_heading_states_the_unit() {
    let milliseconds = "n;Zeit in ms\n1;100,5\n2;450\n";
    assert_eq!(parse(milliseconds, "a.csv"), [0.1005, 0.45]);
    for name in ["a.txt", "a.csv"] {
        assert_eq!(
            parse("Time (ms)\n100,5\n450\n", name),
            [0.1005, 0.45],
            "{name}"
        );
        assert_eq!(
            parse("# of ball 3\ntime_s\n0.1\n0.45\n", name),
            [0.1, 0.45],
            "{name}"
        );
    }
    let (line, message) = blame("n,time (h)\n1,0.1\n", "a.csv");
    assert_eq!(line, Some(1));
    assert!(message.contains("time_ms"), "{message}");
}

/// The comma of a number is no separator of columns: what stood behind it would be lost.
#[test]
fn decimal_commas_among_commas_are_refused() {
    let (line, message) = blame("n,time_s\n1,10,5\n2,11,7\n", "a.csv");
    assert_eq!(line, Some(2));
    assert!(message.contains("semicolons"), "{message}");
    // An empty cell at the end is nothing.
    assert_eq!(parse("n,time_s\n1,10.5,\n2,11.7,\n", "a.csv"), [10.5, 11.7]);
}

#[test]
fn semicolons_separate_tables_with_decimal_commas() {
    assert_eq!(
        parse("n;time_s\n1;0,10\n2;0,45\n", "excel.csv"),
        [0.10, 0.45]
    );
}

#[test]
fn what_is_pasted_from_a_spreadsheet_may_have_decimal_commas_and_tabs() {
    assert_eq!(parse("0,10\n0,45\n", "pasted.txt"), [0.10, 0.45]);
    let table = "n\ttime_s\tnote\n1\t0,10\tloud, near\n2\t0,45\t\n";
    for name in ["pasted.txt", "pasted.csv"] {
        assert_eq!(parse(table, name), [0.10, 0.45], "{name}");
    }
    // Which of the columns holds the times?
    let (line, message) = blame("1\t0,10\t3\n2\t0,45\t4\n", "pasted.txt");
    assert_eq!(line, Some(1));
    assert!(message.contains("3 columns"), "{message}");
}

/// By the grammar of the Audacity manual: points, a region, an empty text, selected frequencies.
#[test]
fn a_label_track_of_audacity_is_a_list() {
    let track = "0.100000\t0.100000\t1\n0.450000\t0.470000\tsecond, loud\n\\\t200.0\t4000.0\n\
                 0.720000\t0.720000\t\n";
    assert_eq!(parse(track, "Label Track.txt"), [0.10, 0.45, 0.72]);
    assert_eq!(
        parse(&track.replace('.', ","), "old.txt"),
        [0.10, 0.45, 0.72]
    );
    let (line, _) = blame("0.5\t0.5\ta\n0.1\t0.1\tb\n", "disordered.txt");
    assert_eq!(line, Some(2));
}

/// A tier of intervals and one of points, as Praat 6.3 writes them.
const LONG: &str = r#"File type = "ooTextFile"
Object class = "TextGrid"

xmin = 0 
xmax = 1.5 
tiers? <exists> 
size = 2 
item []: 
    item [1]:
        class = "IntervalTier" 
        name = "voice" 
        xmin = 0 
        xmax = 1.5 
        intervals: size = 1 
        intervals [1]:
            xmin = 0 
            xmax = 1.5 
            text = "she said ""go"" 3 2" 
    item [2]:
        class = "TextTier" 
        name = "taps" 
        xmin = 0 
        xmax = 1.5 
        points: size = 2 
        points [1]:
            number = 0.1 
            mark = "1" 
        points [2]:
            number = 0.45 
            mark = "" 
"#;

#[test]
fn a_point_tier_of_praat_is_a_list() {
    assert_eq!(parse(LONG, "drop.TextGrid"), [0.1, 0.45]);
    let short = "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\n0\n1.5\n<exists>\n1\n\
                 \"TextTier\"\n\"taps\"\n0 ! a comment 7\n1.5\n2\n0.1\n\"1\"\n0.45\n\"2\"\n";
    assert_eq!(parse(short, "drop.textgrid"), [0.1, 0.45]);
    for to_bytes in [u16::to_be_bytes, u16::to_le_bytes] {
        let units = "\u{feff}".encode_utf16().chain(LONG.encode_utf16());
        let wide: Vec<u8> = units.flat_map(to_bytes).collect();
        assert_eq!(
            times::parse(&wide, "wide.TextGrid").unwrap().times_s,
            [0.1, 0.45]
        );
    }
}

#[test]
fn a_text_grid_without_its_impacts_is_refused() {
    let (_, message) = blame(&LONG.replace("TextTier", "IntervalTier"), "a.TextGrid");
    assert!(message.contains("not a TextGrid of Praat"), "{message}");
    let intervals = "\"ooTextFile\" \"TextGrid\" 0 1 <exists> 2 \"IntervalTier\" \"words\" 0 1 1 0 1 \"\" \
                     \"IntervalTier\" \"sounds\" 0 1 0";
    let (_, message) = blame(intervals, "a.TextGrid");
    assert!(message.contains("intervals: words, sounds"), "{message}");
    assert!(message.contains("Add point tier"), "{message}");
    let (line, message) = blame(&LONG[..LONG.len() - 20], "cut.TextGrid");
    assert_eq!(line, Some(LONG.lines().count()));
    assert!(message.contains("not all of one"), "{message}");
    let none = "\"ooTextFile\" \"TextGrid\" 0 1 <absent>";
    assert!(blame(none, "a.TextGrid").1.contains("intervals: -"));
    let two = "\"ooTextFile\" \"TextGrid\" 0 1 <exists> 2 \"TextTier\" \"left\" 0 1 0 \
               \"TextTier\" \"right\" 0 1 1 0.5 \"\"";
    let (_, message) = blame(two, "a.TextGrid");
    assert!(
        message.contains("several tiers have points: left, right"),
        "{message}"
    );
    assert_eq!(parse(&two.replace("right", "impacts"), "a.TextGrid"), [0.5]);
    assert_eq!(blame("plain", "a.TextGrid").0, Some(1));
}

#[test]
fn a_byte_order_mark_is_skipped() {
    assert_eq!(parse("\u{feff}time_s\n0.1\n", "excel.csv"), [0.1]);
}

#[test]
fn json_is_an_array_of_numbers() {
    assert_eq!(parse("[0, 0.45,\n 1e0]", "a.JSON"), [0.0, 0.45, 1.0]);
    let (line, message) = blame("[0.1,\n\"0.45\"]", "a.json");
    assert_eq!(line, Some(2));
    assert!(message.contains("array of numbers"), "{message}");
}

#[test]
fn the_line_with_the_fault_is_named() {
    let (line, message) = blame("0.1\n\n# no\n0.45 s\n", "a.txt");
    assert_eq!(line, Some(4));
    assert!(
        message.starts_with("a.txt, line 4: \"0.45 s\" is not a time"),
        "{message}"
    );
    assert_eq!(blame("time_s,n\n0.1,1\n,2\n0.3,3\n", "a.csv").0, Some(3));
    assert_eq!(blame("n,time_s\n1,0.1\n2\n3,0.3", "a.csv").0, Some(3));
    // A column may end before others do.
    assert_eq!(parse("time_s,n\n0.1,1\n,2\n,3\n", "a.csv"), [0.1]);
    assert_eq!(blame("0.1\nnan\n", "a.txt").0, Some(2));
    assert_eq!(blame("0.1\ninf\n", "a.csv").0, Some(2));
}

#[test]
fn times_beyond_all_clocks_are_none() {
    let (line, message) = blame("0.1\n1e300\n", "a.txt");
    assert_eq!(line, Some(2));
    assert!(message.contains("\"1e300\" is not a time"), "{message}");
    assert!(blame("[1e12]", "a.json").1.contains("1e12"));
    // Seconds since 1970 are a clock.
    assert!(times::parse(b"1700000000.1\n1700000000.6\n", "a.txt").is_ok());
}

#[test]
fn times_must_increase() {
    let (line, message) = blame("0.1\n0.72\n0.45\n", "a.txt");
    assert_eq!(line, Some(3));
    assert!(message.contains("0.45 after 0.72"), "{message}");
    let (line, message) = blame("time_s\n0.1\n0.72\n0.45\n", "a.txt");
    assert_eq!(line, Some(4));
    assert!(message.contains("0.45 is not later than 0.72"), "{message}");
    assert_eq!(blame("[0.1, 0.1]", "a.json").0, None);
}

#[test]
fn tables_that_leave_a_choice_are_refused() {
    let (_, message) = blame("1,0.1\n2,0.45\n", "a.csv");
    assert!(message.contains("2 columns"), "{message}");
    let (_, message) = blame("n,when\n1,0.1\n", "a.csv");
    assert!(message.contains("found: n, when"), "{message}");
}

/// Impacts of a drop with flights of 0.6 s × 0.9ⁿ, written by `row` from its number and time.
fn drop_of(count: i32, row: impl Fn(i32, f64) -> String) -> String {
    (0..count)
        .map(|n| row(n, 0.8 + 6.0 * (1.0 - 0.9_f64.powi(n))) + "\n")
        .collect()
}

/// The times that [`drop_of`] writes with four digits.
fn rounded(count: i32) -> Vec<f64> {
    drop_of(count, |_, time_s| format!("{time_s:.4}"))
        .lines()
        .map(|line| line.parse().unwrap())
        .collect()
}

#[test]
fn headings_of_four_languages_name_the_column_of_times() {
    let comma = |time_s: f64| format!("{time_s:.4}").replace('.', ",");
    for text in [
        "Bounce,Time of impact (s)\n".to_owned() + &drop_of(9, |n, t| format!("{n},{t:.4}")),
        "Zeit t / s;Nr.\n".to_owned() + &drop_of(9, |n, t| format!("{};{n}", comma(t))),
        "My drop\n\nTemps d’impact (ms)\tremarque\n".to_owned()
            + &drop_of(9, |_, t| format!("{:.1}\tfort", t * 1e3)),
        "n;Tiempo del bote\n;(s)\n".to_owned() + &drop_of(9, |n, t| format!("{n};{}", comma(t))),
        "time_s\tspeed_m_s\n".to_owned() + &drop_of(9, |_, t| format!("{t:.4e}\t1.5")),
        "sep=;\r\nTime (s)\r\n".to_owned() + &drop_of(9, |_, t| comma(t)),
    ] {
        for name in ["drop.csv", "drop.txt", "drop.tsv"] {
            let read = parse(&text, name);
            let nearly = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-4;
            assert!(
                read.len() == 9 && read.iter().zip(&rounded(9)).all(nearly),
                "{name}: {text}"
            );
        }
    }
}

#[test]
fn a_text_in_latin_1_or_utf_16_or_with_old_ends_of_lines_is_read() {
    let text = "Aufschläge;t / µs\n1;100,5\n2;450000\n";
    let nearly = |list: times::TimeList| {
        assert!(
            (list.times_s[0] - 100.5e-6).abs() < 1e-12 && (list.times_s[1] - 0.45).abs() < 1e-12,
            "{list:?}"
        );
    };
    let latin: Vec<u8> = text.chars().map(|letter| letter as u8).collect();
    nearly(times::parse(&latin, "a.csv").unwrap());
    let old_ends = text.replace('\n', "\r");
    nearly(times::parse(old_ends.as_bytes(), "a.csv").unwrap());
    let wide: Vec<u8> = "\u{feff}"
        .encode_utf16()
        .chain(text.encode_utf16())
        .flat_map(u16::to_le_bytes)
        .collect();
    nearly(times::parse(&wide, "a.csv").unwrap());
    let binary = [0xe4, 0x00, 0x01, 0x31];
    assert!(
        times::parse(&binary, "a.csv")
            .unwrap_err()
            .to_string()
            .contains("not text")
    );
}

#[test]
fn intervals_are_summed_to_times() {
    let list = |text: &str| times::parse(text.as_bytes(), "a.txt").unwrap();
    let expected = [0.0, 0.5, 0.9, 1.2];
    for text in [
        "0.5\n0.4\n0.3\n",
        "Interval (s)\n0.5\n0.4\n0.3\n",
        "Flugzeit in ms\tNr.\n500\t1\n400\t2\n300\t3\n",
        "Interval 1 (s)\tInterval 2 (s)\tInterval 3 (s)\n0.5\t0.4\t0.3\n",
        "0,5 0,4 0,3",
        "[0.5, 0.4, 0.3]",
    ] {
        let read = list(text);
        let nearly = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-12;
        assert!(
            read.times_s.len() == 4 && read.times_s.iter().zip(&expected).all(nearly),
            "{text}: {read:?}"
        );
        assert!(read.origin.of_intervals, "{text}");
    }
    assert!(!list("0.3\n0.5\n0.6\n").origin.of_intervals);
    let (line, message) = blame("interval_s\n0.5\n0\n", "a.txt");
    assert_eq!(line, Some(3));
    assert!(message.contains("0 is no interval"), "{message}");
}

#[test]
fn numbers_side_by_side_are_a_list() {
    for text in [
        "0.1, 0.45 0.72",
        "0.1 0.45 0.72",
        "0,1 0,45 0,72",
        "0.1, 0.45, 0.72",
        "0,1\r\n0,45\r\n0,72\r\n",
        "0,1 0,45; 0,72\n",
        "0,1, 0,45, 0,72",
        "0.1,0.45,0.72",
    ] {
        assert_eq!(parse(text, "a.txt"), [0.1, 0.45, 0.72], "{text}");
    }
}

/// The layouts of the stopwatch and of the inelastic collision of phyphox.
#[test]
fn exports_of_phyphox_are_measured_by_a_threshold() {
    let read = |text: &str| times::parse(text.as_bytes(), "All.csv").unwrap();
    let all = read("\"Event time (s)\",\"Interval (s)\"\n8.0E-01,6.0E-01\n1.4E+00,5.4E-01\n");
    assert_eq!(all.times_s, [0.8, 1.4, 1.94]);
    let simple =
        read("\"Start (s)\"\t\"Stop (s)\"\t\"Difference (s)\"\n8,0E-01\t1,4E+00\t6,0E-01\n");
    assert_eq!(simple.times_s, [0.8, 1.4]);
    let stops =
        read("\"Start (s)\";\"Stop 1 (s)\";\"Stop 2 (s)\";\"Stop 3 (s)\"\n0.8;1.4;1.94;NaN\n");
    assert_eq!(stops.times_s, [0.8, 1.4, 1.94]);
    let collision = read(
        "\"Bounce 0 (s)\",\"Height 0 (m)\",\"Bounce 1 (s)\",\"Height 1 (m)\",\"Energy 1\"\n0.8,0.44,1.4,0.36,0.81\n",
    );
    assert_eq!(collision.times_s, [0.8, 1.4]);
    assert_eq!(
        collision.origin.program.as_deref(),
        Some("phyphox inelastic collision")
    );
    assert!(
        [all, simple, stops, collision]
            .iter()
            .all(|list| list.origin.by_threshold && !list.origin.of_intervals)
    );
    assert!(
        !read("Time (s),Interval (s)\n0.8,0.6\n1.4,0\n")
            .origin
            .by_threshold
    );
}

/// An interval stands beside the time at which it begins, or at which it ends.
#[test]
fn the_interval_after_the_last_time_is_one_more_impact() {
    let forward = "Time (s),Interval (s)\n0.8,0.6\n1.4,0.54\n1.94,0.486\n";
    let read = parse(forward, "a.csv");
    assert!(
        read.len() == 4 && (read[3] - 2.426).abs() < 1e-9,
        "{read:?}"
    );
    for text in [
        "Time (s),Interval (s)\n0.8,0\n1.4,0.6\n1.94,0.54\n",
        "Time (s),Interval (s)\n0.8,0.6\n1.4,0.54\n1.94,0\n",
        "Time (s),Interval (s)\n0.8,0.6\n1.4,0.54\n1.94,\n",
    ] {
        assert_eq!(parse(text, "a.csv"), [0.8, 1.4, 1.94], "{text}");
    }
}

#[test]
fn what_is_no_list_of_one_drop_is_refused() {
    for (text, reason) in [
        (
            "t,x,y\n0,0,0.1\n0.018,0,0.2\n0.036,0,0.1\n0.05,0,0.0\n",
            "positions over time",
        ),
        (
            "Start (s),Stop 1 (s)\n0.1,0.5\n2.1,2.6\n",
            "several columns of times and 2 rows",
        ),
        (
            "recording,drop,impact,time_s\na.wav,1,1,0.5\na.wav,1,2,0.9\n",
            "a table about recordings",
        ),
        (
            "0.1\n0.3\n0.2\n",
            "impact times, which increase, or intervals, which decrease",
        ),
    ] {
        let (_, message) = blame(text, "a.csv");
        assert!(message.contains(reason), "{message}");
    }
}

/// The layer as it is saved, and what its menu exports as CSV.
#[test]
fn a_layer_of_sonic_visualiser_is_a_list() {
    let layer = r#"<?xml version="1.0" encoding="UTF-8"?><!DOCTYPE sonic-visualiser><sv><data>
        <model id="1" name="" sampleRate="44100" type="sparse" dimensions="1" resolution="1" dataset="0"/>
        <dataset id="0" dimensions="1"><point frame="4410" label="1"/><point frame="22050" label="2"/></dataset>
        </data><display><layer id="2" type="timeinstants" model="1"/></display></sv>"#;
    assert_eq!(parse(layer, "impacts.svl"), [0.1, 0.5]);
    assert_eq!(
        parse("0.100000000,New Point\n0.500000000,loud\n", "impacts.csv"),
        [0.1, 0.5]
    );
    let without_rate = layer.replace("sampleRate", "rate");
    assert!(
        blame(&without_rate, "a.svl")
            .1
            .contains("not a layer of Sonic Visualiser")
    );
}

#[test]
fn a_list_without_times_is_empty() {
    for (text, name) in [
        ("# none\n", "a.txt"),
        ("time_s\n", "a.csv"),
        ("[]", "a.json"),
        ("", "a.json"),
    ] {
        let result = times::parse(text.as_bytes(), name);
        assert!(
            matches!(result, Err(Error::Empty { .. })),
            "{name}: {result:?}"
        );
    }
}

#[test]
fn the_extension_decides_between_list_and_sound() {
    let folder = std::env::temp_dir().join(format!("bouncelab-times-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("drop.TXT");
    fs::write(&path, "0.1\n0.4\n").unwrap();
    assert!(matches!(Input::open(&path), Ok(Input::Times(list)) if list.times_s == [0.1, 0.4]));
    assert!(matches!(
        times::read(folder.join("no.txt")),
        Err(Error::NotFound { .. })
    ));
    assert!(matches!(times::read(&folder), Err(Error::Directory { .. })));
    fs::remove_dir_all(&folder).unwrap();
    let wav = include_bytes!("fixtures/pcm16.wav").to_vec();
    assert!(matches!(
        Input::from_bytes(wav, "drop.wav"),
        Ok(Input::Sound(_))
    ));
}
