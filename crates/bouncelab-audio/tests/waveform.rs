//! Sampled waveforms in text, as instruments and apps export them.

use bouncelab_audio::{Error, Input, TimesProblem};

const RATE_HZ: f64 = 44_100.0;

fn sample(n: usize) -> f32 {
    ((n * 37 % 101) as f32 - 50.0) / 100.0
}

/// A table of two thousand rows: heading, and how a row is written.
fn table(heading: &str, row: impl Fn(f64, f32) -> String) -> String {
    let rows = (0..2_000).map(|n| row(n as f64 / RATE_HZ, sample(n)));
    std::iter::once(heading.to_owned())
        .chain(rows)
        .collect::<Vec<_>>()
        .join("\n")
}

fn read(text: &str, name: &str) -> (u32, Vec<Vec<f32>>) {
    let Ok(Input::Sound(mut source)) = Input::from_bytes(text.as_bytes(), name) else {
        panic!("{text:.80} is no sound");
    };
    assert_eq!(source.format(), "waveform in text");
    let mut channels = vec![Vec::new(); source.channels()];
    while let Some(block) = source.next_block().unwrap() {
        for (number, channel) in channels.iter_mut().enumerate() {
            channel.extend_from_slice(block.channel(number));
        }
    }
    (source.sample_rate_hz(), channels)
}

fn refusal(text: &str) -> Error {
    Input::from_bytes(text.as_bytes(), "drop.csv")
        .map(drop)
        .unwrap_err()
}

#[test]
fn what_instruments_and_apps_export_is_sound() {
    let expected: Vec<f32> = (0..2_000).map(sample).collect();
    let comma = |number: String| number.replace('.', ",");
    for text in [
        table("time,amplitude", |t, a| format!("{t:.6},{a}")),
        table("\"Time (s)\",\"Recording (a.u.)\"", |t, a| {
            format!("{t:.9E},{a:E}")
        }),
        table("Time (ms)\tCH1", |t, a| format!("{:.4}\t{a}", t * 1e3)),
        table("Zeit (Millisekunden);Spannung (V)", |t, a| {
            comma(format!("{:.4};{a}", t * 1e3))
        }),
        table("time_us;ch 1", |t, a| comma(format!("{:.2};{a};", t * 1e6))),
        table("SoundReader,CH1\nSecond,Volt", |t, a| {
            format!("{:.7},{a}", t - 0.5)
        }),
        table("# of a logger", |t, a| format!("  {t:.6}   {a}")),
        // Too few digits, so that several rows have one time.
        table("t,a", |t, a| format!("{t:.4},{a}")),
    ] {
        let (rate_hz, channels) = read(&text, "drop.csv");
        assert!(
            (f64::from(rate_hz) / RATE_HZ - 1.0).abs() < 1.0 / 1_900.0,
            "{rate_hz}: {text:.60}"
        );
        assert_eq!(channels, std::slice::from_ref(&expected), "{text:.60}");
        assert_eq!(read(&text, "drop.txt").1.len(), 1);
    }
    let (_, channels) = read(
        &table("t,l,r", |t, a| format!("{t:.6},{a},{}", -2.0 * a)),
        "drop.csv",
    );
    assert_eq!(channels.len(), 2);
    assert!(channels[1].iter().all(|sample| sample.abs() <= 1.0));
}

/// Five seconds with times of two digits, whatever part of a digit is left at both ends, rounded or cut.
#[test]
fn a_clock_of_few_digits_is_exact_to_a_row() {
    const ROWS: u32 = 220_500;
    for part in 0..10 {
        let start_s = f64::from(part) * 0.001;
        for cut_s in [0.0, 0.005] {
            let rows = (0..ROWS).map(|n| {
                let time_s = start_s + f64::from(n) / RATE_HZ;
                format!("{:.2},0\n", time_s - cut_s)
            });
            let text = rows.collect::<Vec<_>>().concat();
            let (rate_hz, _) = read(&text, "drop.csv");
            // Rounded to a whole number, too.
            let most = RATE_HZ / f64::from(ROWS - 2_000) + 0.5;
            assert!(
                (f64::from(rate_hz) - RATE_HZ).abs() < most,
                "{part}: {rate_hz}"
            );
        }
    }
}

#[test]
fn a_waveform_that_is_too_slow_or_has_a_hole_is_refused() {
    let slow = table("time,a", |t, a| format!("{},{a}", t * 441.0));
    let refused = refusal(&slow).to_string();
    assert!(refused.contains("2000 samples, 100 a second"), "{refused}");
    for hole in [700..701, 700..1_200] {
        let rows = (0..2_000).filter(|n| !hole.contains(n));
        let rows = rows.map(|n| format!("{},0.5\n", f64::from(n) / RATE_HZ));
        let holed = std::iter::once("time,a\n".to_owned())
            .chain(rows)
            .collect::<Vec<_>>()
            .concat();
        let refused = refusal(&holed);
        assert!(refused.to_string().contains("equal distances"), "{refused}");
    }
}

#[test]
fn lists_of_impacts_stay_lists() {
    let truth = "time_s,speed_m_s,lost\n0.5,2.4,false\n0.93,2.2,false\n1.31,2.0,true\n";
    let bouncing = |ratio: f64, count: i32| {
        let rows =
            (0..count).map(|n| format!("{:.4},{n}\n", (1.0 - ratio.powi(n)) / (1.0 - ratio)));
        "time,n\n".to_owned() + &rows.collect::<String>()
    };
    // A steel ball, of which many flights nearly last as long as the one before.
    for text in [
        truth.to_owned(),
        bouncing(0.98, 100),
        bouncing(0.9, 5),
        bouncing(0.5, 6),
    ] {
        assert!(matches!(
            Input::from_bytes(text.as_bytes(), "drop.csv"),
            Ok(Input::Times(_))
        ));
    }
}

/// Whatever the number of its rows: a ball in a video, a sensor of distance, a short recording.
#[test]
fn times_at_equal_steps_are_samples() {
    let steady = |rows: u32, step_s: f64| {
        let rows = (0..rows).map(|n| format!("{:.5},{}\n", f64::from(n) * step_s, n % 7));
        "time,a\n".to_owned() + &rows.collect::<String>()
    };
    for (rows, step_s, rate) in [
        (4, 0.5, "4 samples, 2 a"),
        (78, 1.0 / 30.0, "78 samples, 30 a"),
        (999, 0.5, "999"),
    ] {
        let refused = refusal(&steady(rows, step_s)).to_string();
        assert!(
            refused.contains(rate) && refused.contains("list the times"),
            "{refused}"
        );
    }
    assert_eq!(read(&steady(480, 1.25e-4), "drop.csv").0, 8_000);
    // The same as a number in each row, of which the first column is the number.
    assert!(matches!(
        Input::from_bytes(
            &b"n,time_s\n1,0.5\n2,0.93\n3,1.31\n4,1.62\n"[..],
            "drop.csv"
        ),
        Ok(Input::Times(_))
    ));
}

#[test]
fn problems_of_a_waveform_are_reported_with_their_line() {
    let row = |n: u32| format!("{:.6},0.5", f64::from(n) / 8_000.0);
    let with = |odd: &str| {
        let rows = (0..2_000).map(|n| if n == 1_500 { odd.to_owned() } else { row(n) });
        let rows = rows.collect::<Vec<_>>().join("\n");
        refusal(&format!("time,amplitude\n\n{rows}\n")).to_string()
    };
    let later = format!("{:.6},0.5", 1_501.4 / 8_000.0);
    for (odd, reason) in [
        ("0.1875", "1 of 2 numbers"),
        ("0.1875,0.5,0.5", "3 columns"),
        ("0.1875,nan", "\"nan\" is not a number"),
        ("clipped", "\"clipped\" is not a number"),
        (&later, "equal distances"),
    ] {
        let refused = with(odd);
        assert!(
            refused.contains("line 1503") && refused.contains(reason),
            "{refused}"
        );
    }
}

#[test]
fn deep_json_is_refused() {
    let deep = "[".repeat(1_000_000);
    let refused = Input::from_bytes(deep.as_bytes(), "drop.json")
        .map(drop)
        .unwrap_err();
    assert!(matches!(
        refused,
        Error::Times {
            problem: TimesProblem::NotArray { .. },
            ..
        }
    ));
}

#[cfg(unix)]
#[test]
fn a_device_is_no_list() {
    let folder = std::env::temp_dir().join(format!("bouncelab-device-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let link = folder.join("drop.csv");
    std::os::unix::fs::symlink("/dev/zero", &link).unwrap();
    let refused = Input::open(&link).map(drop).unwrap_err();
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(matches!(
        refused,
        Error::Times {
            problem: TimesProblem::NotFile,
            ..
        }
    ));
}

/// One column that rises and falls has no times: its rate is stated, or it is refused. Few numbers are a list.
#[test]
fn one_column_of_samples_is_read_at_a_stated_rate() {
    let column: Vec<String> = (0..2_000).map(|n| sample(n).to_string()).collect();
    let column = column.join("\n");
    let samples = |text: &str| match Input::from_bytes(text.as_bytes(), "samples.txt") {
        Ok(Input::Samples(samples)) => samples,
        other => panic!("{text:.40}: {other:?}"),
    };
    let with_heading = format!("Recording (a.u.)\n{}", column.replace('.', ","));
    for text in [column, with_heading] {
        let mut source = samples(&text).at(Some(44_100)).unwrap();
        assert_eq!((source.sample_rate_hz(), source.channels()), (44_100, 1));
        let block = source.next_block().unwrap().unwrap();
        let expected: Vec<f32> = (0..block.frames()).map(sample).collect();
        assert_eq!(block.channel(0), &expected);
        assert!(matches!(
            samples(&text).at(Some(100)),
            Err(Error::UnsupportedLayout { .. })
        ));
        let rows = 2_000;
        let unstated = samples(&text).at(None).map(drop).unwrap_err();
        assert!(
            matches!(unstated, Error::Times { problem: TimesProblem::NoRate { rows: found }, .. } if found == rows)
        );
    }
    assert!(matches!(
        refusal("0.1\n0.3\n0.2\n"),
        Error::Times {
            problem: TimesProblem::NoOrder { .. },
            ..
        }
    ));
}
