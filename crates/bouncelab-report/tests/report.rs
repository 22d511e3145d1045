//! Reports as files: whole, self-contained, and safe whatever a name contains.

use std::collections::{BTreeMap, BTreeSet};

use bouncelab::analyze_times;
use bouncelab::diagnostic::{Code, Diagnostic};
use bouncelab::groups::CurveEvidence;
use bouncelab::inference::Measured;
use bouncelab::settings::{Settings, Setup};
use bouncelab_report::groups::{self, About, GroupStudy, NotedDrop, Question, Reason};
use bouncelab_report::messages::Translator;
use bouncelab_report::report::{self, Markdown, Page, Provenance, ReportInput};

/// A name that tries everything at once.
const HOSTILE: &str = "a\"><script>alert('1')</script><img src=x onerror=alert(2)>--> ](javascript:x) `| $x$ & \n# b.wav";

fn setup() -> Setup {
    let mut settings = Settings::of_ball("table-tennis-40");
    settings.inference.draws = Some(1000);
    settings.resolve().unwrap()
}

/// As many drops as wished, each ten flights of the paper's ball, recomputed with drag.
fn drops(count: usize) -> bouncelab::Recording {
    let flights = [
        0.4605, 0.4272, 0.3977, 0.3714, 0.3477, 0.3263, 0.3067, 0.2887, 0.2722, 0.2569,
    ];
    let mut time_s = 0.3;
    let mut times_s = vec![time_s];
    for flight in flights {
        time_s += flight;
        times_s.push(time_s);
    }
    let mut result = analyze_times(&times_s, &setup().options);
    result.drops = vec![result.drops[0].clone(); count];
    result
}

fn page(name: &str, count: usize) -> Page {
    page_in(&Translator::english(), name, count)
}

fn page_in(language: &Translator, name: &str, count: usize) -> Page {
    let recording = ReportInput {
        name,
        setup: &setup(),
        result: &drops(count),
    };
    let provenance = Provenance {
        command: Some(format!("bouncelab analyze '{name}'")),
        files: vec![(name.to_owned(), "00ff".to_owned())],
        made: Some(name.to_owned()),
    };
    report::of_recording(&recording, &provenance, language)
}

/// The parts of a page between angle brackets.
fn tags(html: &str) -> Vec<&str> {
    html.split('<')
        .skip(1)
        .filter_map(|piece| piece.split_once('>').map(|(tag, _)| tag))
        .collect()
}

#[test]
fn a_hostile_name_is_shown_and_does_nothing() {
    let html = page(HOSTILE, 1).html();
    assert!(html.contains("&lt;script&gt;"));
    for tag in tags(&html) {
        assert!(
            !tag.starts_with("script") && !tag.starts_with("img"),
            "{tag}"
        );
        assert!(!tag.contains("onerror"), "{tag}");
    }
    let Markdown { text, .. } = page(HOSTILE, 1).markdown("f");
    // Outside code, which shows everything as it is, every sign is escaped.
    let outside: String = text.split("\n```").step_by(2).collect();
    assert!(outside.contains(r"\<script\>"));
    let bare = without_escapes(&outside);
    assert!(!bare.contains("<script"), "{bare}");
    assert!(!bare.contains("](javascript"));
    assert!(!outside.lines().any(|line| line == "# b.wav"));
}

/// Leaves out every backslash with the sign after it.
fn without_escapes(text: &str) -> String {
    let mut signs = text.chars();
    let mut bare = String::new();
    while let Some(sign) = signs.next() {
        if sign == '\\' {
            signs.next();
        } else {
            bare.push(sign);
        }
    }
    bare
}

#[test]
fn a_page_asks_nothing_of_the_network() {
    let html = page("drop.wav", 1).html();
    for tag in tags(&html) {
        assert!(!tag.starts_with("script"), "{tag}");
        for attribute in ["src=\"", "href=\"", "url("] {
            if let Some((_, target)) = tag.split_once(attribute) {
                assert!(
                    target.starts_with("data:") || target.starts_with('#'),
                    "{tag}"
                );
            }
        }
    }
    assert!(html.contains("default-src 'none'"));
    assert!(!html.contains("@import") && !html.contains("url(http"));
}

#[test]
fn names_within_a_page_are_unique() {
    let html = page("two.wav", 2).html();
    let ids: Vec<&str> = tags(&html)
        .iter()
        .filter_map(|tag| tag.split_once(" id=\"")?.1.split('"').next())
        .collect();
    let unique: BTreeSet<&str> = ids.iter().copied().collect();
    assert!(ids.len() > 20, "{ids:?}");
    assert_eq!(unique.len(), ids.len());
    assert!(html.contains("Drop 2 of 2"));
}

/// The drop was simulated with a constant restitution of 0.9529.
#[test]
fn the_answer_comes_first_in_words() {
    let html = page("drop.txt", 1).html();
    let first = html.split("class=\"first\">").nth(1).unwrap();
    let sentence = first.split("</p>").next().unwrap();
    assert!(sentence.contains("keeps 95."), "{sentence}");
    assert!(sentence.contains("\u{a0}% of its speed"), "{sentence}");
}

#[test]
fn details_are_folded_unless_asked_for() {
    let page = page("drop.txt", 1);
    let (short, details) = (page.sections.len(), page.details.len());
    assert!(short < details, "{short} sections, {details} folded");
    let folded = page.html();
    let (shown, hidden) = folded.split_once("<details>").unwrap();
    assert!(shown.contains("<h2 id=\"section-1\">The drop</h2>"));
    assert!(hidden.contains("<h3 id=\"section-5\">The impacts</h3>"));
    let unfolded = Page {
        unfolded: true,
        ..page
    };
    assert_eq!(
        unfolded.html(),
        folded.replace("<details>", "<details open>")
    );
    let Markdown { text, .. } = unfolded.markdown("f");
    assert!(text.contains("\n## Details\n\n### The impacts\n"));
}

#[test]
fn a_page_of_many_drops_shows_the_first_hundred() {
    let html = page("long.wav", 120).html();
    assert!(html.contains("The first 100 drops have sections of their own"));
    assert!(html.contains("Drop 100 of 120") && !html.contains("Drop 101 of 120"));
    let rows = html.split("<table").nth(1).unwrap().matches("<tr").count();
    assert_eq!(rows, 121);
    assert!(!page("short.wav", 3).html().contains("The first 100"));
}

#[test]
fn a_notebook_refers_to_its_figures() {
    let markdown = page("two.wav", 2).markdown("two-figures");
    let names: BTreeSet<&String> = markdown.figures.iter().map(|(name, _)| name).collect();
    assert_eq!(names.len(), markdown.figures.len(), "a name came twice");
    for (name, svg) in &markdown.figures {
        assert!(svg.starts_with("<svg"));
        assert!(markdown.text.contains(&format!("](<two-figures/{name}>)")));
    }
    assert!(markdown.text.contains("$$\nh_n = "));
    assert!(
        markdown.text.contains("| impact | time s |"),
        "{}",
        markdown.text
    );
}

#[test]
fn a_recording_without_a_drop_says_why() {
    let mut result = drops(0);
    result.no_drop = Some(Diagnostic::new(Code::NoSound));
    let recording = ReportInput {
        name: "silence.wav",
        setup: &setup(),
        result: &result,
    };
    let html =
        report::of_recording(&recording, &Provenance::default(), &Translator::english()).html();
    assert!(html.contains("No drop was found: No sound stands out from the background."));
}

/// The text of an HTML file without its head, its code and the title.
fn said_in(html: &str) -> String {
    let body = html.split_once("</h1>").unwrap().1;
    let mut said = String::new();
    for piece in body.split('<') {
        let (tag, text) = piece.split_once('>').unwrap_or_default();
        if !tag.starts_with("code") && !tag.starts_with('m') {
            said.push_str(text);
        }
        for label in tag.split("aria-label=\"").skip(1) {
            said.push_str(label.split('"').next().unwrap_or_default());
        }
    }
    said
}

/// A language in which every message is the same sign.
fn silent() -> Translator {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/messages/en");
    let mut source = String::new();
    for file in std::fs::read_dir(folder).unwrap() {
        let english = std::fs::read_to_string(file.unwrap().path()).unwrap();
        let ids = english.lines().filter_map(|line| line.split_once(" ="));
        let ids = ids.filter(|(id, _)| !id.starts_with(['#', ' ', '[']));
        source.extend(ids.map(|(id, _)| format!("{id} = \u{f8}\n")));
    }
    Translator::of_sources("de", &[&source]).unwrap()
}

/// What is not silent is no message.
#[test]
fn everything_on_a_page_is_a_message() {
    let html = page_in(&silent(), "1", 2).html();
    // Works are cited by their names.
    let cited = html
        .split("<ul>")
        .find(|list| list.contains("JCGM"))
        .unwrap();
    assert_silent(&html.replace(cited.split("</ul>").next().unwrap(), ""));
}

#[test]
fn everything_on_a_page_of_groups_is_a_message() {
    for (drops, speed_m_s) in [(6, None), (6, Some(9.0)), (0, None)] {
        assert_silent(&group_page(drops, speed_m_s, &silent()).html());
    }
    // Of six drops with the same trouble some are named.
    let german = Translator::new("de").unwrap();
    let html = group_page(6, None, &german).html();
    assert!(html.contains("0, 1, 2, 3 und 2 weitere: 7"), "{html}");
}

/// `drops` drops of each of two balls, compared at a speed, and six with remarks.
fn group_page(drops: usize, at_speed_m_s: Option<f64>, translator: &Translator) -> Page {
    let point = |value| move |speed_m_s| (speed_m_s, Measured { value, sd: 0.001 });
    let balls = ["1", "2"].map(|ball| BTreeMap::from([("0".to_owned(), ball.to_owned())]));
    let noted = (0..2 * drops).map(|place| NotedDrop {
        name: place.to_string().into(),
        factors: &balls[place % 2],
        evidence: CurveEvidence::measured(&[0.5, 1.0, 2.0].map(point(0.8 + 0.001 * place as f64))),
        scatter: None,
    });
    let troubles = (0..6).map(|place| Reason {
        name: place.to_string(),
        reason: "7".to_owned(),
    });
    let troubles: Vec<Reason> = troubles.collect();
    let about = About {
        recordings: 2 * drops + 6,
        drops: 2 * drops,
        without_drop: troubles.clone(),
        failed: troubles.clone(),
        duplicates: troubles.clone(),
        left_out: troubles.clone(),
        odd: troubles,
        remarks: vec!["8".to_owned()],
        assumptions: vec!["9".to_owned()],
        ..About::default()
    };
    let question = Question {
        at_speed_m_s,
        ..Question::default()
    };
    let groups = GroupStudy::of(about, noted.collect(), &question, translator).unwrap();
    let charts = groups::figures(&groups, vec![Vec::new(); 2], translator);
    let provenance = Provenance::default();
    let to_repeat = report::repeat(&provenance, translator);
    groups::page(&groups, &charts, &provenance, to_repeat, translator)
}

/// No word is seen but those of messages, all of which are the same sign.
fn assert_silent(html: &str) {
    assert!(html.contains("<html lang=\"de\">"));
    let said = said_in(html);
    assert!(said.contains('\u{f8}'));
    let english: Vec<&str> = said
        .split(|letter: char| !letter.is_ascii_alphabetic())
        .filter(|word| word.len() > 2)
        .collect();
    assert_eq!(english, Vec::<&str>::new());
}
