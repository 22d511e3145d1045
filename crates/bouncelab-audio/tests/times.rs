//! Lists of impact times: what is read, and which line is blamed when it is not.

use std::fs;

use bouncelab_audio::{Error, Input, times};

fn parse(text: &str, name: &str) -> Vec<f64> {
    times::parse(text.as_bytes(), name).unwrap()
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
fn semicolons_separate_tables_with_decimal_commas() {
    assert_eq!(
        parse("n;time_s\n1;0,10\n2;0,45\n", "excel.csv"),
        [0.10, 0.45]
    );
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
    let (line, message) = blame("0.1\n\n# no\n0,45\n", "a.txt");
    assert_eq!(line, Some(4));
    assert!(
        message.starts_with("a.txt, line 4: \"0,45\" is not a time"),
        "{message}"
    );
    assert_eq!(blame("time_s,n\n0.1,1\n,2\n", "a.csv").0, Some(3));
    assert_eq!(blame("n,time_s\n1,0.1\n2\n", "a.csv").0, Some(3));
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
    assert!(matches!(Input::open(&path), Ok(Input::Times(times)) if times == [0.1, 0.4]));
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
