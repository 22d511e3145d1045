//! Every figure, with data as they come and as they should not come: it must be a drawing
//! that any program can read, with its axes named, its colours kept and nothing outside.

use bouncelab_report::figure::{
    self, BandPoint, BounceHeight, BounceLoss, Budget, CornerParameter, Curve, CutPoint, CutSeries,
    DragAxes, Envelope, Figure, GroupInterval, GroupLaw, GroupPoint, Judged, Line, Mark,
    ModelWeight, RankHistogram, Residual, Restitution, RunPoint, Source, TimedFlight,
};
use bouncelab_report::theme::{self, Meaning};
use proptest::prelude::*;

const LINE: Line = Line {
    slope: -0.0269,
    intercept: -0.3367,
};

fn flights(count: u32, used: u32) -> Vec<TimedFlight> {
    (1..=count)
        .map(|number| TimedFlight {
            number,
            time_s: 0.4605 * 0.94_f64.powf(f64::from(number)),
            standard_error_s: Some(0.0005),
            used: number <= used,
        })
        .collect()
}

fn marks(sure: bool) -> Vec<Mark> {
    let mark = |n: u16| Mark {
        time_s: 2.0 - 2.0 * 0.94_f64.powf(f64::from(n)),
        sure,
        drop: 1,
    };
    (0..60).map(mark).collect()
}

fn sound() -> Envelope {
    let samples: Vec<f32> = (0..20_000_u16)
        .map(|i| (f32::from(i) * 0.3).sin() * 0.9_f32.powf(f32::from(i % 2000) / 20.0))
        .collect();
    Envelope::from_samples(&samples, 10_000.0, 3000).unwrap()
}

fn curve(meaning: Meaning, name: &str) -> Curve {
    let point = |i: u16| (f64::from(i) / 10.0, (f64::from(i) / 94.0).powi(2));
    Curve {
        name: name.to_owned(),
        meaning,
        points: (0..100).map(point).collect(),
    }
}

fn impacts() -> Vec<Restitution> {
    let impact = |n: u16| Restitution {
        speed_m_s: 2.3 * 0.94_f64.powf(f64::from(n)),
        value: 0.94 + 0.002 * f64::from(n % 3),
        standard_error: Some(0.002),
        odd: false,
    };
    (1..30).map(impact).collect()
}

/// A figure with usual data, and words that it must show: the names of its axes, and others.
type Usual = (Figure, &'static [&'static str]);

/// Each figure once.
fn usual() -> Vec<Usual> {
    let all = [of_a_drop(), of_an_inference(), of_many_drops()];
    all.into_iter().flatten().collect()
}

fn of_a_drop() -> Vec<Usual> {
    let curves = [
        curve(Meaning::Drag, "constant 0.4"),
        curve(Meaning::NoDrag, "no air"),
    ];
    vec![
        (
            figure::waveform(&sound(), &marks(true)),
            &["time (s)", "amplitude, relative to full scale"],
        ),
        (
            figure::flight_times(&flights(38, 10), Some(LINE)),
            &[
                "flight time (s)",
                "number of the flight",
                "off the line (%)",
            ],
        ),
        (
            figure::drag(&curves, DragAxes::Linear, Some(2.4)),
            &["speed (m/s)", "drag / weight"],
        ),
        (
            figure::drag(&curves, DragAxes::Logarithmic, Some(2.4)),
            &["speed (m/s)", "drag / weight"],
        ),
        (
            figure::height(&curves, &[(0.5, 0.2), (1.0, 0.1)]),
            &["time (s)", "height (m)"],
        ),
        (
            figure::restitution(&impacts(), &impacts(), &[], Some(0.9375)),
            &[
                "speed at the impact (m/s)",
                "restitution: speed after / before",
            ],
        ),
        (
            figure::restitution(&impacts(), &odd_impacts(), &band(), Some(0.9375)),
            &["fitted law, 68 and 95 %", "odd, counts less"],
        ),
        (
            figure::bounce_heights(&bounce_heights()),
            &["bounce", "height (cm)"],
        ),
        (
            figure::bounce_energies(&bounce_losses()),
            &["bounce", "energy lost (mJ)", "the bounce"],
        ),
    ]
}

fn of_an_inference() -> Vec<Usual> {
    vec![
        (
            figure::corner(&parameters(800)),
            &["restitution", "height (cm)", "before the data"],
        ),
        (
            figure::residuals(&residuals()),
            &[
                "impact",
                "residual (standard deviations)",
                "odd, counts less",
            ],
        ),
        (
            figure::budget(&[shares(9)]),
            &["drop height: 30.4 \u{b1} 0.6 cm", "source 0", "all others"],
        ),
        (
            figure::models(&weights(), "drop height (cm)"),
            &["probability", "drop height (cm)", "law 0"],
        ),
        (
            figure::cut(
                &[cuts("straight line", 40.0), cuts("inference", 0.1)],
                "height (cm)",
                Some(30.5),
            ),
            &["flights used", "height (cm)", "truth"],
        ),
        (
            figure::calibration(&histograms()),
            &["clean", "e", "rank of the truth"],
        ),
    ]
}

fn of_many_drops() -> Vec<Usual> {
    vec![
        (
            figure::groups(&group_laws(14)),
            &[
                "speed at the impact (m/s)",
                "restitution: speed after / before",
            ],
        ),
        (
            figure::intervals("Groups", &group_intervals(12), "restitution at 1.41 m/s"),
            &["restitution at 1.41 m/s"],
        ),
        (verdict(), &["rebound (cm)", "drop 1"]),
        (
            figure::run_chart(&run_points(60), &names(3), Some(0.004)),
            &["drop, in order", "restitution less the median of the group"],
        ),
    ]
}

fn odd_impacts() -> Vec<Restitution> {
    let mut impacts = impacts();
    impacts[7].odd = true;
    impacts
}

fn band() -> Vec<BandPoint> {
    let point = |i: u8| BandPoint {
        speed_m_s: 0.1 * f64::from(i),
        value: 0.94,
        interval68: [0.938, 0.942],
        interval95: [0.936, 0.944],
    };
    (1..30).map(point).collect()
}

/// Three quantities of so many draws, two of them linked; a quasi-random walk takes the place of
/// chance.
fn parameters(draws: u32) -> Vec<CornerParameter> {
    let even = |i: u32, step: f64| (f64::from(i) * step).fract() - 0.5;
    let named = |name: &str, prior, value: &dyn Fn(u32) -> f64| CornerParameter {
        name: name.to_owned(),
        values: (0..draws).map(value).collect(),
        prior,
    };
    let (a, b) = (0.618_034, 0.414_214);
    vec![
        named("restitution", None, &|i| 0.95 + 0.002 * even(i, a)),
        named("drag coefficient", Some((0.4, 0.01)), &|i| {
            0.4 + 0.02 * even(i, b)
        }),
        named("height (cm)", None, &|i| 30.0 + even(i, a) + even(i, b)),
    ]
}

fn bounce_heights() -> Vec<BounceHeight> {
    let height = |number: u32| BounceHeight {
        number,
        height_m: 0.3 * 0.88_f64.powf(f64::from(number)),
        standard_error_m: Some(0.002),
    };
    (1..30).map(height).collect()
}

fn bounce_losses() -> Vec<BounceLoss> {
    let loss = |number: u32| BounceLoss {
        number,
        to_surface_j: 1e-3 * 0.88_f64.powf(f64::from(number)),
        to_air_j: 0.2e-3 * 0.8_f64.powf(f64::from(number)),
    };
    (1..30).map(loss).collect()
}

fn residuals() -> Vec<Residual> {
    let residual = |number: u32| Residual {
        number,
        standardised: if number == 9 {
            -11.0
        } else {
            f64::from(number % 5) - 2.0
        },
        odd: number == 9,
    };
    (1..30).map(residual).collect()
}

fn shares(count: u32) -> Budget {
    let source = |i: u32| Source {
        name: format!("source {i}"),
        share: 0.6 / f64::from(4_u32.pow(i)),
    };
    Budget {
        quantity: "drop height: 30.4 \u{b1} 0.6 cm".to_owned(),
        sources: (0..count).map(source).collect(),
    }
}

fn weights() -> Vec<ModelWeight> {
    let model = |i: u8| ModelWeight {
        name: format!("law {i}"),
        weight: 0.5 / f64::from(i + 1),
        value: (i != 2).then(|| (30.0 + f64::from(i), [29.0, 32.0])),
    };
    (0..4).map(model).collect()
}

fn cuts(name: &str, slope: f64) -> CutSeries {
    let point = |flights: u32| CutPoint {
        flights,
        value: 30.0 - slope * f64::from(flights) / 40.0,
        sd: 0.5,
    };
    CutSeries {
        name: name.to_owned(),
        meaning: Meaning::Measured,
        points: [6, 10, 20, 40].map(point).to_vec(),
    }
}

fn histograms() -> Vec<RankHistogram> {
    ["clean", "noisy"]
        .into_iter()
        .flat_map(|scenario| ["e", "h0", "C_D"].map(|quantity| (scenario, quantity)))
        .map(|(scenario, quantity)| RankHistogram {
            scenario: scenario.to_owned(),
            quantity: quantity.to_owned(),
            bins: (0..20).map(|bin| 200 + bin % 7).collect(),
        })
        .collect()
}

fn names(groups: u32) -> Vec<String> {
    (0..groups)
        .map(|group| format!("ball {group}, steel"))
        .collect()
}

fn group_laws(groups: u32) -> Vec<GroupLaw> {
    let law = |group: u32| {
        let value = 0.94 - 0.01 * f64::from(group);
        let speed = |place: u32| 0.5 + 0.2 * f64::from(place);
        GroupLaw {
            name: format!("ball {group}, steel"),
            impacts: (0..30)
                .map(|i| (speed(i % 9), value + 1e-4 * f64::from(i)))
                .collect(),
            law: (0..9)
                .map(|place| GroupPoint {
                    speed_m_s: speed(place),
                    value,
                    interval95: (place > 0).then_some([value - 0.002, value + 0.002]),
                })
                .collect(),
        }
    };
    (0..groups).map(law).collect()
}

fn verdict() -> Figure {
    let limits = [Some(24.0), Some(26.0)];
    let accepted = [Some(24.2), Some(25.8)];
    figure::limits("Verdict", &judged(5), limits, accepted, "rebound (cm)")
}

fn judged(drops: u32) -> Vec<Judged> {
    (0..drops)
        .map(|drop| {
            let value = 24.5 + 0.3 * f64::from(drop);
            Judged {
                name: format!("drop {drop}"),
                value,
                interval95: Some([value - 0.4, value + 0.4]),
                decides: drop == 0,
            }
        })
        .collect()
}

fn group_intervals(groups: u32) -> Vec<GroupInterval> {
    let interval = |group: u32| {
        let mean = 0.94 - 0.005 * f64::from(group);
        GroupInterval {
            name: format!("a ball with a rather long name, number {group}"),
            mean,
            interval95: (group > 0).then_some([mean - 0.002, mean + 0.002]),
            next95: (group > 1).then_some([mean - 0.006, mean + 0.006]),
            drops: (0..=group)
                .map(|i| (mean + 1e-3 * f64::from(i % 5), i == 3))
                .collect(),
        }
    };
    (0..groups).map(interval).collect()
}

fn run_points(drops: u32) -> Vec<RunPoint> {
    let point = |drop: u32| RunPoint {
        off: if drop == 17 {
            0.1
        } else {
            1e-3 * (f64::from(drop % 7) - 3.0)
        },
        standard_error: Some(5e-4),
        group: drop as usize % 3,
        outlier: drop == 17,
    };
    (0..drops).map(point).collect()
}

/// One drop far off does not flatten the others, and a thousand drops have no bars.
#[test]
fn a_run_chart_shows_the_bulk() {
    let with = figure::run_chart(&run_points(60), &names(3), Some(0.004));
    let ticks = texts(&with.svg());
    assert!(ticks.iter().any(|tick| tick == "0.002"), "{ticks:?}");
    let many = figure::run_chart(&run_points(1000), &names(3), None);
    assert!(!many.svg().contains(&theme::group(0).tint().to_string()));
}

/// Thousands of draws do not make a picture of thousands of shapes.
#[test]
fn a_corner_plot_stays_small() {
    let (few, many) = (
        figure::corner(&parameters(800)),
        figure::corner(&parameters(40_000)),
    );
    assert!(many.svg().len() < 100_000, "{}", many.svg().len());
    assert!(many.svg().len() < 3 * few.svg().len());
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

/// Well-formed, no number that is none, every text begins on the sheet, and nothing is cut off
/// at its rim: drawn as a picture, the outermost pixels are white.
fn check_drawing(figure: &Figure) -> Result<(), TestCaseError> {
    let svg = figure.svg();
    let parsed = roxmltree::Document::parse(&svg);
    prop_assert!(parsed.is_ok(), "{:?}: {svg}", parsed.err());
    let document = parsed.unwrap();
    let (width, height) = figure.size();
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
    prop_assert!(!figure.caption().is_empty());
    #[cfg(feature = "png")]
    prop_assert!(pictures::rim_is_white(figure), "{:?}", texts(&svg));
    Ok(())
}

#[test]
fn every_figure_is_well_formed_and_names_its_axes_with_units() {
    for (figure, axes) in usual() {
        check_drawing(&figure).unwrap();
        let texts = texts(&figure.svg());
        for axis in axes {
            assert!(texts.iter().any(|text| text == axis), "{axis}: {texts:?}");
        }
        assert!(texts.contains(&figure.title().to_owned()));
    }
}

#[test]
fn a_screen_reader_finds_the_title_and_the_caption() {
    for (figure, _) in usual() {
        let svg = figure.svg();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let text = |tag: &str| {
            let mut nodes = document.descendants();
            let node = nodes.find(|node| node.has_tag_name(tag)).unwrap();
            node.text().unwrap().to_owned()
        };
        assert_eq!(text("title"), figure.title());
        assert_eq!(text("desc"), figure.caption());
        assert_eq!(document.root_element().attribute("role"), Some("img"));
    }
}

#[test]
fn colours_keep_their_meaning() {
    let has =
        |figure: &Figure, meaning: Meaning| figure.svg().contains(&meaning.colour().to_string());
    let sure = figure::waveform(&sound(), &marks(true));
    assert!(has(&sure, Meaning::Measured) && !has(&sure, Meaning::Warning));
    let uncertain = figure::waveform(&sound(), &marks(false));
    assert!(has(&uncertain, Meaning::Warning));
    let line = figure::flight_times(&flights(10, 10), Some(LINE));
    assert!(has(&line, Meaning::Measured) && has(&line, Meaning::NoDrag));
    assert!(!has(&line, Meaning::Drag));
    let height = figure::height(&[curve(Meaning::Drag, "air")], &[]);
    assert!(has(&height, Meaning::Drag) && !has(&height, Meaning::Measured));
    let error = Meaning::Measured.colour().tint().to_string();
    assert!(line.svg().contains(&error), "the standard errors");
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
    let nothing = Curve {
        name: "nothing".to_owned(),
        meaning: Meaning::Drag,
        points: vec![(f64::NAN, 1.0)],
    };
    let no_sound = Envelope::from_samples(&[], 44_100.0, 100).unwrap();
    for figure in [
        figure::waveform(&no_sound, &[]),
        figure::flight_times(&[], Some(LINE)),
        figure::drag(std::slice::from_ref(&nothing), DragAxes::Linear, None),
        figure::drag(&[], DragAxes::Logarithmic, Some(1.0)),
        figure::height(&[nothing], &[]),
        figure::restitution(&[], &[], &[], Some(0.9)),
        figure::corner(&[]),
        figure::residuals(&[]),
        figure::bounce_heights(&[]),
        figure::bounce_energies(&[]),
        figure::budget(&[]),
        figure::models(&[], "drop height (cm)"),
        figure::cut(&[], "drop height (cm)", Some(0.3)),
        figure::calibration(&[]),
        figure::groups(&[]),
        figure::intervals("Groups", &[], "restitution"),
        figure::limits(
            "Verdict",
            &[],
            [Some(24.0), None],
            [None; 2],
            "rebound (cm)",
        ),
        figure::run_chart(&[], &[], Some(0.1)),
    ] {
        check_drawing(&figure).unwrap();
        let texts = texts(&figure.svg());
        assert_eq!(texts, [figure.title(), figure.caption()]);
        assert!(figure.caption().contains(" no "), "{}", figure.caption());
    }
}

#[test]
fn names_from_outside_cannot_break_the_drawing() {
    let name = "<b> & \"$x$\" \u{0} \u{1b}[31m".repeat(20);
    let figure = figure::height(&[curve(Meaning::Drag, &name)], &[]);
    check_drawing(&figure).unwrap();
    assert!(
        texts(&figure.svg())
            .iter()
            .any(|text| text.starts_with("<b> & \"$x$\""))
    );
}

#[test]
fn a_restitution_far_off_does_not_flatten_the_others() {
    let mut impacts = impacts();
    impacts[5].value = 40.0;
    let svg = figure::restitution(&impacts, &[], &[], None).svg();
    let ticks = texts(&svg);
    assert!(ticks.contains(&"0.940".to_owned()), "{ticks:?}");
}

#[test]
fn envelopes_must_fit_together() {
    let message = Envelope::new(0.0, 0.1, vec![0.0; 3], vec![0.0; 2])
        .unwrap_err()
        .to_string();
    assert!(message.contains("3 lowest and 2 highest"), "{message}");
    assert!(Envelope::new(0.0, 0.0, vec![], vec![]).is_err());
    assert!(Envelope::new(f64::NAN, 1.0, vec![], vec![]).is_err());
    assert!(Envelope::from_samples(&[0.5], 0.0, 10).is_err());
    assert!(Envelope::from_samples(&[0.5], 8000.0, 0).is_ok());
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
        let curve = |meaning| Curve { name: "any".to_owned(), meaning, points: numbers.clone() };
        let curves = [curve(Meaning::Drag), curve(Meaning::Drag)];
        let impacts: Vec<_> = numbers
            .iter()
            .map(|&(speed_m_s, value)| Restitution { speed_m_s, value, standard_error: errors, odd: false })
            .collect();
        let flights: Vec<_> = numbers
            .iter()
            .map(|&(time_s, other)| TimedFlight {
                number: other as u32,
                time_s,
                standard_error_s: errors,
                used: other > 0.0,
            })
            .collect();
        let marks: Vec<_> = numbers
            .iter()
            .map(|&(time_s, other)| Mark { time_s, sure: other > 0.0, drop: time_s as usize })
            .collect();
        let lows = numbers.iter().map(|n| n.0 as f32).collect();
        let highs = numbers.iter().map(|n| n.1 as f32).collect();
        let line = Line { slope: line.0, intercept: line.1 };
        check_drawing(&figure::height(&curves, &numbers))?;
        check_drawing(&figure::drag(&curves, DragAxes::Linear, errors))?;
        check_drawing(&figure::drag(&curves, DragAxes::Logarithmic, errors))?;
        check_drawing(&figure::restitution(&impacts, &impacts, &[], errors))?;
        check_drawing(&figure::flight_times(&flights, Some(line)))?;
        let points = numbers.iter().map(|&(speed_m_s, value)| GroupPoint {
            speed_m_s,
            value,
            interval95: errors.map(|error| [error, value]),
        });
        let law = GroupLaw { name: "any".to_owned(), impacts: numbers.clone(), law: points.collect() };
        check_drawing(&figure::groups(&[law]))?;
        let intervals: Vec<_> = numbers
            .iter()
            .map(|&(mean, end)| GroupInterval {
                name: "any".to_owned(),
                mean,
                interval95: Some([mean, end]),
                next95: errors.map(|error| [error, end]),
                drops: vec![(end, end > 0.0)],
            })
            .collect();
        check_drawing(&figure::intervals("Any", &intervals, "any"))?;
        let judged: Vec<_> = numbers
            .iter()
            .map(|&(value, end)| Judged {
                name: "any".to_owned(),
                value,
                interval95: errors.map(|error| [error, end]),
                decides: end > 0.0,
            })
            .collect();
        check_drawing(&figure::limits("Any", &judged, [errors, None], [None, errors], "any"))?;
        let run: Vec<_> = numbers
            .iter()
            .map(|&(off, other)| RunPoint {
                off,
                standard_error: errors,
                group: other as usize,
                outlier: other > 0.0,
            })
            .collect();
        check_drawing(&figure::run_chart(&run, &names(2), errors))?;
        if let Ok(sound) = Envelope::new(line.slope, line.intercept.abs(), lows, highs) {
            check_drawing(&figure::waveform(&sound, &marks))?;
        }
    }

    /// Any number of bounces, times from microseconds to hours.
    #[test]
    fn drops_of_any_length_are_drawn(count in 1_u32..200, first_s in 1e-6..1e4_f64, ratio in 0.3..0.999_f64) {
        let mut flights = flights(count, count / 2);
        for flight in &mut flights {
            flight.time_s = first_s * ratio.powf(f64::from(flight.number));
        }
        check_drawing(&figure::flight_times(&flights, Some(LINE)))?;
        let time = |n: u32| first_s * (1.0 - ratio.powf(f64::from(n)));
        let marks: Vec<_> = (0..count)
            .map(|n| Mark { time_s: time(n), sure: true, drop: 1 })
            .collect();
        let sound = Envelope::new(0.0, first_s / 500.0, vec![-0.5; 500], vec![0.5; 500]);
        check_drawing(&figure::waveform(&sound.unwrap(), &marks))?;
    }
}

#[cfg(feature = "png")]
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

    pub(super) fn rim_is_white(figure: &Figure) -> bool {
        let (width, height, pixels) = decode(&figure.png(320).unwrap());
        let columns = width as usize;
        let is_rim = |i: usize| {
            let (row, column) = (i / columns, i % columns);
            row < 2 || row + 2 >= height as usize || column < 2 || column + 2 >= columns
        };
        let mut numbered = pixels.iter().enumerate();
        numbered.all(|(i, pixel)| !is_rim(i) || pixel == &[255; 3])
    }

    #[test]
    fn a_picture_is_as_wide_as_asked_and_keeps_its_shape() {
        for (figure, _) in usual() {
            for asked in [120_u32, 333, 480, 1600] {
                let (width, height, pixels) = decode(&figure.png(asked).unwrap());
                assert_eq!(width, asked);
                let expected = f64::from(width) * figure.size().1 / figure.size().0;
                assert!((f64::from(height) - expected).abs() <= 1.0);
                let inked = pixels.iter().filter(|&pixel| pixel != &[255; 3]).count();
                assert!(inked > pixels.len() / 100, "hardly anything is drawn");
            }
        }
    }

    #[test]
    fn a_picture_has_a_sensible_width() {
        let figure = figure::restitution(&[], &[], &[], None);
        for width in [0, 119, 8001, u32::MAX] {
            let error = figure.png(width).unwrap_err();
            assert!(matches!(error, Error::PictureWidth { width_px } if width_px == width));
        }
        let message = figure.png(7).unwrap_err().to_string();
        assert_eq!(
            message,
            "a picture cannot be 7 pixels wide: give a width from 120 to 8000"
        );
    }

    #[test]
    fn a_saved_figure_is_two_whole_files_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("new/figures");
        let figure = figure::flight_times(&flights(5, 5), Some(LINE));
        let saved = save(&figure, &inner, "flight-times").unwrap();
        // Again: files of the same name are replaced.
        save(&figure, &inner, "flight-times").unwrap();
        assert_eq!(std::fs::read_to_string(&saved.svg).unwrap(), figure.svg());
        assert_eq!(
            std::fs::read(&saved.png).unwrap(),
            figure.png(1600).unwrap()
        );
        let mut names: Vec<_> = std::fs::read_dir(&inner)
            .unwrap()
            .map(|entry| entry.unwrap().file_name())
            .collect();
        names.sort();
        assert_eq!(names, ["flight-times.png", "flight-times.svg"]);
    }

    #[test]
    fn a_folder_that_cannot_be_used_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        std::fs::write(&file, "here").unwrap();
        let figure = figure::restitution(&[], &[], &[], None);
        let error = save(&figure, &file, "restitution").unwrap_err();
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
        let figure = figure::height(&[], &[]);
        let error = save(&figure, folder.path(), "height").unwrap_err();
        assert!(matches!(error, Error::Write { .. }), "{error}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_name_cannot_lead_out_of_the_folder() {
        let folder = tempfile::tempdir().unwrap();
        let figure = figure::height(&[], &[]);
        for name in ["", "..", "../x", "a/b", ".hidden", "a\\b", "a b\n"] {
            let error = save(&figure, folder.path(), name).unwrap_err();
            assert!(matches!(error, Error::Name { .. }), "{name}");
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}

/// A key of names that are three times as long takes more rows; the panel moves down by as much, so
/// that nothing lies over anything else, and the sheet grows.
#[test]
fn a_figure_grows_with_the_words_of_another_language() {
    let curve = |name: &str, meaning| Curve {
        name: name.to_owned(),
        meaning,
        points: vec![(0.0, 0.3), (1.0, 0.2)],
    };
    let curves = [
        curve("a law of drag", Meaning::Drag),
        curve("another one of them", Meaning::NoDrag),
    ];
    let english = figure::height(&curves, &[]);
    let mut longer = figure::height(&curves, &[]);
    longer.translate(&mut |text| {
        if text.parse::<f64>().is_ok() {
            text.replace('.', ",")
        } else {
            format!("{text} {text} {text}")
        }
    });
    let grown = longer.size().1 - english.size().1;
    assert!(grown > 0.0);
    let y_of = |figure: &Figure, text: &str| {
        let svg = figure.svg();
        let before = svg.split(&format!(">{text}<")).next().unwrap();
        let place = before.rsplit(" y=\"").next().unwrap();
        place.split('"').next().unwrap().parse::<f64>().unwrap()
    };
    let name = "height (cm)";
    let moved = y_of(&longer, &[name; 3].join(" ")) - y_of(&english, name);
    assert!((moved - grown).abs() < 1e-6, "{moved} {grown}");
    assert!(longer.svg().contains(">0,5<"));
    assert!(longer.caption().starts_with("The models start alike"));
}

/// The words of a figure as they stand in it, lines that were broken put together.
fn words_of(figure: &Figure) -> String {
    let svg = figure.svg();
    let texts = svg.split('>').filter_map(|part| part.split_once('<'));
    let texts = texts.map(|(text, _)| text.trim());
    let texts: Vec<&str> = texts.filter(|text| !text.is_empty()).collect();
    texts.join(" ")
}

/// A name that is cut off tells nobody which ball or law it is.
#[test]
fn long_names_are_broken_not_cut() {
    let group = "the old ball of the school, on the wooden floor in the gymnasium";
    let of_group = |mean| GroupInterval {
        name: group.to_owned(),
        mean,
        interval95: None,
        next95: None,
        drops: Vec::new(),
    };
    let judged = Judged {
        name: group.to_owned(),
        value: 0.25,
        interval95: None,
        decides: true,
    };
    let curve = Curve {
        name: [group; 2].join(", "),
        meaning: Meaning::Drag,
        points: vec![(0.0, 0.3), (1.0, 0.2)],
    };
    let drawn = [
        figure::intervals("Groups", &[of_group(0.9), of_group(0.91)], "restitution"),
        figure::limits("Limits", &[judged], [Some(0.24), None], [None, None], "m"),
        figure::height(&[curve], &[]),
    ];
    for figure in drawn {
        let words = words_of(&figure);
        assert!(words.contains(group), "{words}");
    }
    let mut models = weights();
    models[0].name = "viscoelastic, clift-grace-weber".to_owned();
    let mut in_german = figure::models(&models, "drop height (cm)");
    in_german.translate(&mut |text| text.replace("viscoelastic", "viskoelastisch"));
    let words = words_of(&in_german);
    assert!(
        words.contains("viskoelastisch, clift-grace-weber"),
        "{words}"
    );
}
