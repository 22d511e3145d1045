//! Every figure, with data as they come and as they should not come: it must be a drawing
//! that any program can read, with its axes named, its colours kept and nothing outside.

use bouncelab::Estimate;
use bouncelab::detection::Envelope;
use bouncelab::groups::CurvePoint;
use bouncelab_report::figure::{
    self, Curve, Detection, DragAxes, EvaluatedValue, GroupCurve, GroupInterval, Line, Mark,
    RunPoint, TimedFlight,
};
use bouncelab_report::file::Outputs;
use bouncelab_report::messages::Translator;
use bouncelab_report::theme::{self, Meaning};
use bouncelab_report::{Chart, messages};
use charts::{LINE, flights, hops, names, run_points};
use proptest::prelude::*;

mod charts;

fn english() -> Translator {
    Translator::english()
}

/// One drop far off does not flatten the others, and a thousand drops have no bars.
#[test]
fn a_run_chart_shows_the_bulk() {
    let with = figure::run_chart(&run_points(60), &names(3), Some(0.004), &english());
    let ticks = texts(&with.svg());
    assert!(ticks.iter().any(|tick| tick == "0.002"), "{ticks:?}");
    let many = figure::run_chart(&run_points(1000), &names(3), None, &english());
    let error = Meaning::Group(0).colour().tint().to_string();
    assert!(with.svg().contains(&error) && !many.svg().contains(&error));
}

/// Thousands of draws do not make a picture of thousands of shapes.
#[test]
fn the_posterior_stays_small() {
    let all = charts::all(&english());
    let (_, chart, _) = all.iter().find(|(name, ..)| name == "posterior").unwrap();
    let size = chart.svg().len();
    assert!((10_000..100_000).contains(&size), "{size}");
}

fn text_of(node: roxmltree::Node) -> String {
    let parts = node.descendants().filter(roxmltree::Node::is_text);
    parts.filter_map(|part| part.text()).collect()
}

fn texts(svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let nodes = document.descendants();
    nodes
        .filter(|node| node.has_tag_name("text"))
        .map(text_of)
        .collect()
}

/// The drawing is well-formed, no number is NaN, every text begins in the drawing, and nothing is cut off
/// at its rim: drawn as a picture, the outermost pixels are white.
fn check_drawing(chart: &Chart) -> Result<(), TestCaseError> {
    let svg = chart.svg();
    let parsed = roxmltree::Document::parse(&svg);
    prop_assert!(parsed.is_ok(), "{:?}: {svg}", parsed.err());
    let document = parsed.unwrap();
    let (width, height) = chart.size();
    for node in document.descendants() {
        for attribute in node.attributes() {
            let value = attribute.value();
            prop_assert!(!value.contains("NaN") && !value.contains("inf"), "{value}");
        }
        if !node.has_tag_name("text") {
            continue;
        }
        let number = |name| node.attribute(name).unwrap().parse::<f64>().unwrap();
        prop_assert!((8.0..width).contains(&number("x")), "{node:?}");
        prop_assert!((10.0..height).contains(&number("y")), "{node:?}");
    }
    prop_assert!(!chart.caption.is_empty());
    prop_assert!(serde_json::to_string(chart).is_ok());
    #[cfg(feature = "pictures")]
    prop_assert!(pictures::rim_is_white(chart), "{:?}", texts(&svg));
    Ok(())
}

#[test]
fn every_figure_is_well_formed_and_names_its_axes_with_units() {
    for (name, chart, words) in charts::all(&english()) {
        check_drawing(&chart).unwrap();
        let texts = texts(&chart.svg());
        for word in words {
            // A quick analysis has fewer layers, and a law that always holds no prior.
            if !name.ends_with("-quick") {
                assert!(
                    texts.iter().any(|text| text == word),
                    "{name}: {word}: {texts:?}"
                );
            }
        }
        assert!(texts.contains(&chart.title), "{name}");
    }
}

/// In the font of pictures, which is wider than those of most systems.
#[cfg(feature = "pictures")]
#[test]
fn no_text_is_cut_or_lies_over_another_in_any_language() {
    for language in messages::languages() {
        for (name, chart, _) in charts::all(&Translator::new(language).unwrap()) {
            let texts = widths::boxes(&chart.svg());
            let (width, height) = chart.size();
            let cut: Vec<_> = texts
                .iter()
                .filter(|text| text.is_cut(width, height))
                .collect();
            assert!(cut.is_empty(), "{language} {name}: {cut:?}");
            for (index, text) in texts.iter().enumerate() {
                let over = texts[index + 1..]
                    .iter()
                    .find(|other| text.lies_over(other));
                assert!(over.is_none(), "{language} {name}: {text:?} and {over:?}");
            }
        }
    }
}

/// Every text of every figure comes from the messages of its language, and numbers have the sign of
/// that language between whole numbers and decimals.
#[test]
fn figures_speak_every_language() {
    for language in messages::languages() {
        let translator = Translator::new(language).unwrap();
        for (name, chart, _) in charts::all(&translator) {
            let texts = texts(&chart.svg());
            let is_id = |text: &String| text.contains("figure-") || text.contains("axis-");
            let missing: Vec<&String> = texts.iter().filter(|text| is_id(text)).collect();
            assert!(missing.is_empty(), "{language} {name}: {missing:?}");
            let point = translator.number("0.5").replace(['0', '5'], "");
            let has_other = |text: &String| {
                let number: Option<f64> = text.replace('−', "-").parse().ok();
                number.is_some() && point != "." && text.contains('.')
            };
            assert!(!texts.iter().any(has_other), "{language} {name}: {texts:?}");
        }
    }
}

#[test]
fn a_screen_reader_finds_the_title_and_the_caption() {
    for (_, chart, _) in charts::all(&english()) {
        let svg = chart.svg();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let text = |tag: &str| {
            let mut nodes = document.descendants();
            let node = nodes.find(|node| node.has_tag_name(tag)).unwrap();
            node.text().unwrap().to_owned()
        };
        assert_eq!(text("title"), chart.title);
        assert_eq!(text("desc"), chart.caption);
        assert_eq!(document.root_element().attribute("role"), Some("img"));
    }
}

fn marks(sure: bool) -> Vec<Mark> {
    let mark = |n: u16| Mark {
        time_s: 2.0 - 2.0 * 0.94_f64.powf(f64::from(n)),
        sure,
        drop: 1,
    };
    (0..60).map(mark).collect()
}

#[test]
fn colours_keep_their_meaning() {
    let has = |chart: &Chart, meaning: Meaning| chart.svg().contains(&meaning.colour().to_string());
    let sound = charts::sound(&[0.1, 0.5], 2.0);
    let sure = figure::waveform(&sound, &marks(true), &english());
    assert!(has(&sure, Meaning::Measured) && !has(&sure, Meaning::Warning));
    let uncertain = figure::waveform(&sound, &marks(false), &english());
    assert!(has(&uncertain, Meaning::Warning));
    let line = figure::flight_times(&flights(10, 10), Some(LINE), &english());
    assert!(has(&line, Meaning::Measured) && has(&line, Meaning::Plain));
    assert!(!has(&line, Meaning::Drag));
    let curve = hops("air", Meaning::Drag, 0.3, 0.9);
    let height = figure::height("height", &[curve], &[], &english());
    assert!(has(&height, Meaning::Drag) && !has(&height, Meaning::Measured));
}

/// Contrast as in the Web Content Accessibility Guidelines 2.1: texts need 4.5 to 1.
#[test]
fn texts_can_be_read_on_paper() {
    let luminance = |colour: theme::Colour| {
        let linear = colour.rgb.map(|part| {
            let part = f64::from(part) / 255.0;
            if part <= 0.04045 {
                part / 12.92
            } else {
                ((part + 0.055) / 1.055).powf(2.4)
            }
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    };
    for ink in [theme::INK, theme::SOFT_INK, Meaning::Measured.colour()] {
        let contrast = (luminance(theme::PAPER) + 0.05) / (luminance(ink) + 0.05);
        assert!(contrast >= 4.5, "{ink}: {contrast}");
    }
}

#[test]
fn without_data_a_figure_says_so() {
    let english = english();
    let nothing = Curve {
        name: "nothing".to_owned(),
        meaning: Meaning::Drag,
        points: vec![[f64::NAN, 1.0]],
    };
    let no_sound = Envelope::of_steps(0.01, Vec::new(), Vec::new());
    let nothings = std::slice::from_ref(&nothing);
    for chart in [
        figure::waveform(&no_sound, &[], &english),
        figure::flight_times(&[], Some(LINE), &english),
        figure::drag(nothings, DragAxes::Linear, None, &english),
        figure::drag(&[], DragAxes::Logarithmic, Some(1.0), &english),
        figure::height("height", nothings, &[], &english),
        figure::detection(Detection::Late, nothings, &english),
        figure::calibration(&[], &english),
        figure::groups(&[], &english),
        figure::intervals(&[], 1.0, &english),
        figure::limits(
            &[],
            [Some(24.0), None],
            [None; 2],
            ("m".to_owned(), ""),
            &english,
        ),
        figure::run_chart(&[], &[], Some(0.1), &english),
    ] {
        check_drawing(&chart).unwrap();
        let texts = texts(&chart.svg());
        assert_eq!(texts, [&*chart.title, &*chart.caption]);
        assert!(chart.caption.contains(" no"), "{}", chart.caption);
    }
}

#[test]
fn names_from_outside_cannot_break_the_drawing() {
    let name = "<b> & \"$x$\" \u{0} \u{1b}[31m".repeat(20);
    let curve = hops(&name, Meaning::Drag, 0.3, 0.9);
    let chart = figure::height("height", &[curve], &[], &english());
    check_drawing(&chart).unwrap();
    assert!(
        texts(&chart.svg())
            .iter()
            .any(|text| text.starts_with("<b> & \"$x$\""))
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Numbers of any kind and size: a drawing all the same.
    #[test]
    fn no_numbers_break_a_drawing(
        numbers in proptest::collection::vec((any::<f64>(), any::<f64>()), 0..12),
        errors: Option<f64>,
        line in (any::<f64>(), any::<f64>()),
    ) {
        let english = english();
        let points: Vec<[f64; 2]> = numbers.iter().map(|&(x, y)| [x, y]).collect();
        let curve = |meaning| Curve { name: "any".to_owned(), meaning, points: points.clone() };
        let curves = [curve(Meaning::Drag), curve(Meaning::Drag)];
        let flights: Vec<_> = numbers
            .iter()
            .map(|&(time_s, other)| TimedFlight {
                number: other as usize,
                time_s,
                used: other > 0.0,
            })
            .collect();
        let marks: Vec<_> = numbers
            .iter()
            .map(|&(time_s, other)| Mark {
                time_s,
                sure: other > 0.0,
                // No recording has more drops.
                drop: usize::from(time_s as u16),
            })
            .collect();
        let lows = numbers.iter().map(|n| n.0 as f32).collect();
        let highs = numbers.iter().map(|n| n.1 as f32).collect();
        let line = Line { slope: line.0, intercept: line.1 };
        check_drawing(&figure::height("height", &curves, &points, &english))?;
        check_drawing(&figure::drag(&curves, DragAxes::Linear, errors, &english))?;
        check_drawing(&figure::drag(&curves, DragAxes::Logarithmic, errors, &english))?;
        check_drawing(&figure::flight_times(&flights, Some(line), &english))?;
        let curve = numbers.iter().map(|&(speed_m_s, value)| CurvePoint {
            speed_m_s,
            restitution: Estimate::normal(value, errors.unwrap_or(1.0)),
        });
        let group = GroupCurve {
            name: "any".to_owned(),
            impacts: points.clone(),
            curve: curve.collect(),
        };
        check_drawing(&figure::groups(&[group], &english))?;
        let intervals: Vec<_> = numbers
            .iter()
            .map(|&(mean, end)| GroupInterval {
                name: "any".to_owned(),
                restitution: Estimate { interval95: [mean, end], ..Estimate::normal(mean, 1.0) },
                next95: errors.map(|error| [error, end]),
                drops: vec![(end, end > 0.0)],
            })
            .collect();
        check_drawing(&figure::intervals(&intervals, line.slope, &english))?;
        let evaluated: Vec<_> = numbers
            .iter()
            .map(|&(value, end)| EvaluatedValue {
                name: "any".to_owned(),
                value,
                interval95: errors.map(|error| [error, end]),
                decides: end > 0.0,
            })
            .collect();
        let any = ("any".to_owned(), "");
        check_drawing(&figure::limits(&evaluated, [errors, None], [None, errors], any, &english))?;
        let run: Vec<_> = numbers
            .iter()
            .map(|&(off, other)| RunPoint {
                off,
                standard_error: errors,
                group: other as usize,
                outlier: other > 0.0,
            })
            .collect();
        check_drawing(&figure::run_chart(&run, &names(2), errors, &english))?;
        let sound = Envelope::of_steps(line.intercept.abs(), lows, highs);
        check_drawing(&figure::waveform(&sound, &marks, &english))?;
    }

    /// Any number of bounces, times from microseconds to hours.
    #[test]
    fn drops_of_any_length_are_drawn(count in 1_usize..200, first_s in 1e-6..1e4_f64, ratio in 0.3..0.999_f64) {
        let mut flights = flights(count, count / 2);
        for flight in &mut flights {
            flight.time_s = first_s * ratio.powf(flight.number as f64);
        }
        check_drawing(&figure::flight_times(&flights, Some(LINE), &english()))?;
        let time = |n: usize| first_s * (1.0 - ratio.powf(n as f64));
        let marks: Vec<_> = (0..count)
            .map(|n| Mark { time_s: time(n), sure: true, drop: 1 })
            .collect();
        let sound = Envelope::of_steps(first_s / 500.0, vec![-0.5; 500], vec![0.5; 500]);
        check_drawing(&figure::waveform(&sound, &marks, &english()))?;
    }
}

/// Where the texts of a drawing are.
#[cfg(feature = "pictures")]
mod widths {
    use roxmltree::{Document, Node};
    use ttf_parser::Face;

    #[derive(Debug)]
    pub(super) struct Text {
        words: String,
        left: f64,
        right: f64,
        baseline: f64,
        size: f64,
    }

    impl Text {
        /// Outside of the drawing, or shortened.
        pub(super) fn is_cut(&self, width: f64, height: f64) -> bool {
            let top = self.baseline - self.size;
            let is_outside =
                self.left < 0.0 || self.right > width || top < 0.0 || self.baseline > height;
            is_outside || self.words.contains('…')
        }

        pub(super) fn lies_over(&self, other: &Self) -> bool {
            let beside = self.right.min(other.right) - self.left.max(other.left);
            let apart = (self.baseline - other.baseline).abs();
            beside > 1.0 && apart < 0.75 * self.size.min(other.size)
        }
    }

    pub(super) fn boxes(svg: &str) -> Vec<Text> {
        let fonts = [dejavu::sans::regular(), dejavu::sans::bold()];
        let faces = fonts.map(|font| Face::parse(font, 0).unwrap());
        let document = Document::parse(svg).unwrap();
        let texts = document.descendants();
        let texts = texts.filter(|node| node.has_tag_name("text"));
        texts.map(|node| text(&node, &faces)).collect()
    }

    fn text(node: &Node, [regular, bold]: &[Face; 2]) -> Text {
        let number = |name| node.attribute(name).unwrap().parse::<f64>().unwrap();
        let face = node.attribute("font-weight").map_or(regular, |_| bold);
        let words = super::text_of(*node);
        let size = number("font-size");
        let scale = size / f64::from(face.units_per_em());
        let advance = |letter| face.glyph_hor_advance(face.glyph_index(letter)?);
        let width: f64 = words
            .chars()
            .filter_map(advance)
            .map(f64::from)
            .sum::<f64>()
            * scale;
        let before = match node.attribute("text-anchor") {
            Some("middle") => 0.5,
            Some("end") => 1.0,
            _ => 0.0,
        };
        let left = number("x") - before * width;
        Text {
            words,
            left,
            right: left + width,
            baseline: number("y"),
            size,
        }
    }
}

#[cfg(feature = "pictures")]
mod pictures {
    use super::*;
    use bouncelab_report::{Error, save};

    /// Width and height in pixels, and the pixels as red, green, blue.
    fn decode(bytes: &[u8]) -> (u32, u32, Vec<[u8; 3]>) {
        let decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        let mut reader = decoder.read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut bytes).unwrap();
        let pixels = bytes.as_chunks().0.to_vec();
        (frame.width, frame.height, pixels)
    }

    pub(super) fn rim_is_white(chart: &Chart) -> bool {
        let (width, height, pixels) = decode(&chart.png(320).unwrap());
        let columns = width as usize;
        let is_rim = |i: usize| {
            let (row, column) = (i / columns, i % columns);
            row < 2 || row + 2 >= height as usize || column < 2 || column + 2 >= columns
        };
        let mut numbered = pixels.iter().enumerate();
        numbered.all(|(i, pixel)| !is_rim(i) || pixel == &[255; 3])
    }

    fn empty() -> Chart {
        figure::height("height", &[], &[], &english())
    }

    #[test]
    fn a_picture_is_as_wide_as_asked_and_keeps_its_shape() {
        for (_, chart, _) in charts::all(&english()) {
            for asked in [120_u32, 480] {
                let (width, height, pixels) = decode(&chart.png(asked).unwrap());
                assert_eq!(width, asked);
                let expected = f64::from(width) * chart.size().1 / chart.size().0;
                assert!((f64::from(height) - expected).abs() <= 1.0);
                let inked = pixels.iter().filter(|&pixel| pixel != &[255; 3]).count();
                assert!(inked > pixels.len() / 100, "hardly anything is drawn");
            }
        }
    }

    /// What is painted, as the operators of a PDF: all in numbers, and as many fills as there are texts and more.
    #[test]
    fn a_pdf_is_a_page_of_the_size_of_the_chart() {
        for (name, chart, _) in charts::all(&english()) {
            let pdf = chart.pdf().unwrap();
            let text = String::from_utf8_lossy(&pdf);
            assert!(
                text.starts_with("%PDF-1.") && text.ends_with("%%EOF"),
                "{name}"
            );
            let (width, height) = chart.size();
            let size = format!("/MediaBox [0 0 {} {}]", 0.75 * width, 0.75 * height);
            assert!(text.contains(&size), "{name}: {size}");
            let start = pdf.windows(7).position(|at| at == b"stream\n").unwrap() + 7;
            let painted = miniz_oxide::inflate::decompress_to_vec_zlib(&pdf[start..]).unwrap();
            let painted = String::from_utf8(painted).unwrap();
            let is_sound = |word: &str| word.parse().is_ok_and(f64::is_finite) || word.len() <= 2;
            assert!(
                painted.split_whitespace().all(is_sound),
                "{name}: {painted}"
            );
            let fills = painted.lines().filter(|&line| line == "f").count();
            assert!(fills >= texts(&chart.svg()).len(), "{name}: {fills}");
        }
    }

    #[test]
    fn a_picture_has_a_sensible_width() {
        let chart = empty();
        for width in [0, 119, 8001, u32::MAX] {
            let error = chart.png(width).unwrap_err();
            assert!(matches!(error, Error::PictureWidth { width_px } if width_px == width));
        }
        let message = chart.png(7).unwrap_err().to_string();
        assert_eq!(
            message,
            "a picture cannot be 7 pixels wide: give a width from 120 to 8000"
        );
    }

    #[test]
    fn a_saved_chart_is_four_whole_files_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("new/figures");
        let chart = figure::flight_times(&flights(5, 5), Some(LINE), &english());
        let saved = save(&chart, &inner, "flight-times", &Outputs::default()).unwrap();
        // Again: files of the same name are replaced.
        save(&chart, &inner, "flight-times", &Outputs::default()).unwrap();
        assert_eq!(std::fs::read_to_string(&saved.svg).unwrap(), chart.svg());
        assert_eq!(std::fs::read(&saved.png).unwrap(), chart.png(1600).unwrap());
        assert_eq!(std::fs::read(&saved.pdf).unwrap(), chart.pdf().unwrap());
        assert_eq!(std::fs::read_to_string(&saved.csv).unwrap(), chart.csv());
        let mut names: Vec<_> = std::fs::read_dir(&inner)
            .unwrap()
            .map(|entry| entry.unwrap().file_name())
            .collect();
        names.sort();
        assert_eq!(
            names,
            [
                "flight-times.csv",
                "flight-times.pdf",
                "flight-times.png",
                "flight-times.svg"
            ]
        );
    }

    #[test]
    fn the_data_of_a_chart_are_a_table() {
        let chart = figure::flight_times(&flights(5, 5), Some(LINE), &english());
        let table = chart.csv();
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines.len(), 1 + chart.rows().len());
        let first = flights(5, 5)[0].time_s;
        let axes = "0,number of the flight,flight time (s)";
        let point = format!("{axes},measured flights,points,1,,{first},,,");
        assert!(lines.contains(&point.as_str()), "{table}");
    }

    #[test]
    fn a_folder_that_cannot_be_used_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        std::fs::write(&file, "here").unwrap();
        let error = save(&empty(), &file, "restitution", &Outputs::default()).unwrap_err();
        assert!(matches!(error, Error::Folder { .. }), "{error}");
        assert!(
            error.to_string().contains(file.to_str().unwrap()),
            "{error}"
        );
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "here");
    }

    #[test]
    fn a_failed_write_leaves_nothing_behind() {
        let folder = tempfile::tempdir().unwrap();
        // A folder of that name cannot be replaced by a file.
        std::fs::create_dir(folder.path().join("height.svg")).unwrap();
        let error = save(&empty(), folder.path(), "height", &Outputs::default()).unwrap_err();
        assert!(matches!(error, Error::Write { .. }), "{error}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_name_cannot_lead_out_of_the_folder() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["", "..", "../x", "a/b", ".hidden", "a\\b", "a b\n"] {
            let error = save(&empty(), folder.path(), name, &Outputs::default()).unwrap_err();
            assert!(matches!(error, Error::Name { .. }), "{name}");
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}

/// A legend of names that are three times as long takes more rows; the panel moves down by as much, so
/// that nothing lies over anything else, and the drawing grows.
#[test]
fn a_figure_grows_with_longer_names() {
    let curves = |words: usize| {
        [
            ("a law of drag ", Meaning::Drag),
            ("another one of them ", Meaning::Plain),
        ]
        .map(|(name, meaning)| hops(&name.repeat(words), meaning, 0.3, 0.9))
    };
    let chart = |words| figure::height("height", &curves(words), &[], &english());
    let (short, long) = (chart(1), chart(3));
    let grown = long.size().1 - short.size().1;
    assert!(grown > 0.0);
    let y_of = |chart: &Chart| {
        let svg = chart.svg();
        let before = svg.split(">height (cm)<").next().unwrap();
        let place = before.rsplit(" y=\"").next().unwrap();
        place.split('"').next().unwrap().parse::<f64>().unwrap()
    };
    let moved = y_of(&long) - y_of(&short);
    assert!((moved - grown).abs() < 1e-6, "{moved} {grown}");
}

/// A name that is cut off tells nobody which ball or law it is.
#[test]
fn long_names_are_broken_not_cut() {
    let group = "the old ball of the school, on the wooden floor in the gymnasium";
    let of_group = |mean| GroupInterval {
        name: group.to_owned(),
        restitution: Estimate::normal(mean, 0.01),
        next95: None,
        drops: Vec::new(),
    };
    let evaluated = EvaluatedValue {
        name: group.to_owned(),
        value: 0.25,
        interval95: None,
        decides: true,
    };
    let curve = hops(&[group; 2].join(", "), Meaning::Drag, 0.3, 0.9);
    let (limits, metres) = ([Some(0.24), None], ("rebound".to_owned(), "m"));
    let drawn = [
        figure::intervals(&[of_group(0.9), of_group(0.91)], 1.0, &english()),
        figure::limits(&[evaluated], limits, [None, None], metres, &english()),
        figure::height("height", &[curve], &[], &english()),
    ];
    for chart in drawn {
        let words = texts(&chart.svg()).join(" ");
        assert!(words.contains(group), "{words}");
    }
}
