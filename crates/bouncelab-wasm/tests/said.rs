//! What the science says in English, gathered for those who translate it.
//!
//! `web/src/text/said.txt` holds an example of everything that reaches a reader of the page: every text
//! of reports and figures, remarks, warnings, and why settings are refused. A test of the page compares
//! it with the templates of each language. Numbers are no part of what is said: texts that differ in
//! nothing else are one.
//!
//! Run with `BOUNCELAB_UPDATE_SAID=1` to write it.

#![cfg(not(target_family = "wasm"))]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use bouncelab::analysis;
use bouncelab::ball;
use bouncelab::detection::Envelope;
use bouncelab::inference::{LawKind, Remark, Unknown};
use bouncelab::train::{NoDrop, Regular};
use bouncelab_audio::Warning;
use bouncelab_report::document::Origin;
use bouncelab_report::paper;
use bouncelab_wasm::analyst::Analyst;
use bouncelab_wasm::simulator;
use bouncelab_wasm::sound::{Ear, Label};
use bouncelab_wasm::wire::{
    AnalysisRequest, DropMarks, Effort, HeightCurve, Inferred, Mark, Reach, RestitutionLaw,
    Settings, SimulationRequest,
};

const FILE: &str = "../../web/src/text/said.txt";

/// Texts by their shape.
#[derive(Default)]
struct Said(BTreeMap<String, String>);

impl Said {
    /// Keeps a text unless one of the same shape is there, or it has no words.
    fn hear(&mut self, text: &str) {
        if text.chars().any(char::is_alphabetic) {
            self.0.entry(shape(text)).or_insert_with(|| text.to_owned());
        }
    }

    fn hear_all<T: ToString>(&mut self, texts: impl IntoIterator<Item = T>) {
        for text in texts {
            self.hear(&text.to_string());
        }
    }

    /// Analyses, draws and reports all there is to it.
    fn hear_request(&mut self, request: &AnalysisRequest, sound: Option<&Envelope>) {
        let mut analyst = Analyst::default();
        let analysed = match analyst.analyse(request) {
            Ok(analysed) => analysed,
            Err(refusal) => return self.hear(&refusal.message),
        };
        let over = HeightCurve::default();
        let mut say = |text: &str| {
            self.hear(text);
            text.to_owned()
        };
        for name in &analysed.figures {
            // A drop too short to be cut has no such figure.
            analyst.figure(request, name, Some(&over), &mut say).ok();
        }
        if let Some(sound) = sound {
            analyst.waveform(request, sound, &mut say).unwrap();
        }
        let made = Some("2026-01-02".to_owned());
        let language = ("en", &mut say as &mut _);
        analyst.report(request, sound, made, language).unwrap();
    }
}

/// A text with a nought for each number, however it begins and ends: as a sentence or within one. One of
/// something is said differently from many.
fn shape(text: &str) -> String {
    let text = text.strip_suffix('.').unwrap_or(text);
    let mut shape = String::new();
    let rest = text.strip_prefix("1 ").inspect(|_| shape.push_str("1 "));
    for letter in rest.unwrap_or(text).chars() {
        let digit = letter.is_ascii_digit();
        let fraction = digit && shape.ends_with("0.");
        if fraction {
            shape.pop();
        } else if !(digit && shape.ends_with('0')) {
            shape.push(if digit { '0' } else { letter });
        }
    }
    let (first, rest) = shape.split_at(shape.chars().next().map_or(0, char::len_utf8));
    first.to_lowercase() + rest
}

fn mark(number: u32, time_s: f64) -> Mark {
    Mark {
        number,
        time_s,
        sigma_s: None,
        probability: 1.0,
        level_db: None,
    }
}

/// Impacts of a ball that keeps this share of its speed, without air.
fn marks(count: u32, ratio: f64) -> Vec<Mark> {
    let mut time_s = 0.3;
    let mut flight_s = 0.46;
    let next = |number| {
        let mark = mark(number, time_s);
        time_s += flight_s;
        flight_s *= ratio;
        mark
    };
    (1..=count).map(next).collect()
}

fn request(drops: Vec<Vec<Mark>>, settings: Settings) -> AnalysisRequest {
    let drops = drops.into_iter().map(|impacts| DropMarks {
        impacts,
        edited: false,
    });
    AnalysisRequest {
        // Names are not translated; one without letters shows that none of it is.
        name: "1".to_owned(),
        source: Origin::Times,
        warnings: Vec::new(),
        no_drop: None,
        drops: drops.collect(),
        settings,
        effort: Effort::Full,
    }
}

fn of_ball(name: &str) -> Settings {
    Settings {
        ball: Some(name.to_owned()),
        ..Settings::default()
    }
}

/// The demo as it was heard, and the picture of its sound.
fn demo() -> (AnalysisRequest, Envelope) {
    let (demo, sound) = simulator::demo(1).unwrap();
    let mut ear = Ear::new(sound.sample_rate_hz, 1, None).unwrap();
    ear.push(&[&sound.samples]);
    let (heard, _) = ear.finish(Label {
        name: "1".to_owned(),
        format: "WAV".to_owned(),
        warnings: Vec::new(),
    });
    let drops = heard.drops.into_iter().map(|drop| drop.impacts).collect();
    let request = AnalysisRequest {
        source: heard.source,
        ..request(drops, demo.settings)
    };
    let step = 256;
    let ends = |piece: &[f32]| {
        let samples = piece.iter();
        samples.fold((0.0_f32, 0.0_f32), |(low, high), &sample| {
            (low.min(sample), high.max(sample))
        })
    };
    let (least, greatest) = sound.samples.chunks(step).map(ends).unzip();
    let step_s = step as f64 / f64::from(sound.sample_rate_hz);
    (request, Envelope::of_steps(step_s, least, greatest))
}

/// What is heard in recordings: few impacts and many, sure and unsure ones, several drops, none.
fn of_recordings(said: &mut Said) {
    let (demo, sound) = demo();
    said.hear_request(&demo, Some(&sound));
    for unsure in 1..=2 {
        let mut doubtful = demo.clone();
        for mark in &mut doubtful.drops[0].impacts[..unsure] {
            mark.probability = 0.6;
        }
        doubtful.settings = Settings::default();
        said.hear_request(&doubtful, Some(&sound));
    }
    let mut measured = demo.clone();
    measured.settings.height_m = Some(0.305);
    said.hear_request(&measured, Some(&sound));
    let mut single = demo.clone();
    single.drops[0].impacts.truncate(1);
    said.hear_request(&single, Some(&sound));
    let mut several = demo.clone();
    several.drops.push(DropMarks {
        impacts: demo.drops[0].impacts[..2].to_vec(),
        edited: false,
    });
    said.hear_request(&several, Some(&sound));
    for unsure in 0..=1 {
        several.drops[unsure].impacts[0].probability = 0.6;
        said.hear_request(&several, Some(&sound));
    }
    if let Origin::Sound {
        channels, format, ..
    } = &mut several.source
    {
        *channels = 2;
        "microphone".clone_into(format);
    }
    said.hear_request(&several, Some(&sound));
    let mut nothing = demo;
    nothing.drops.clear();
    said.hear_request(&nothing, Some(&sound));
    nothing.no_drop = Some(NoDrop::NoSound.to_string());
    said.hear_request(&nothing, Some(&sound));
}

/// What lists of times say: of all lengths, and of what no ball does.
fn of_times(said: &mut Said) {
    for count in [1, 2, 3, 4, 12, 24] {
        said.hear_request(
            &request(vec![marks(count, 0.93)], Settings::default()),
            None,
        );
    }
    let times = |times: &[f64]| {
        let marks = times.iter().zip(1..).map(|(&time, n)| mark(n, time));
        request(vec![marks.collect()], Settings::default())
    };
    // Flights that grow, too long ones, and impossible ones.
    said.hear_request(&times(&[0.0, 0.3, 0.7, 1.3, 2.2]), None);
    said.hear_request(&times(&[0.0, 460.0, 890.0, 1290.0]), None);
    said.hear_request(&times(&[0.0, 0.46, 0.46, 0.9]), None);
    said.hear_request(&times(&[0.0, 0.5, 1.0, 1.5]), None);
    let mut missed = marks(8, 0.93);
    missed.remove(3);
    said.hear_request(&request(vec![missed.clone()], Settings::default()), None);
    missed.drain(2..6);
    missed[2].number = 40;
    said.hear_request(&request(vec![missed], Settings::default()), None);
    // Without the inference, as far as it goes at once.
    for count in [1, 2, 3, 12] {
        let quick = AnalysisRequest {
            effort: Effort::Quick,
            ..request(vec![marks(count, 0.93)], Settings::default())
        };
        said.hear_request(&quick, None);
    }
    // Hardly any loss, and one impact beside its time.
    said.hear_request(&request(vec![marks(9, 0.9999)], Settings::default()), None);
    let mut odd = marks(16, 0.93);
    odd[7].time_s += 0.004;
    said.hear_request(&request(vec![odd], Settings::default()), None);
}

/// What settings add: balls, air, gravity, laws, and what else was measured.
fn of_settings(said: &mut Said) {
    let plain = Settings::default;
    let mut all: Vec<Settings> = ball::presets()
        .iter()
        .map(|preset| of_ball(preset.name))
        .chain(["steel:0.01", "glass:0.016"].map(of_ball))
        .collect();
    all.extend(["none", "constant:0.4", "morrison"].map(|drag| Settings {
        drag: Some(drag.to_owned()),
        buoyancy: Some(false),
        ..plain()
    }));
    all.extend(LawKind::ALL.map(|law| Settings {
        restitution_laws: Some(vec![law.name().to_owned()]),
        added_mass: Some(false),
        ..plain()
    }));
    all.push(Settings {
        mass_kg: Some(0.0027),
        diameter_m: Some(0.04),
        contact_time_s: Some(0.001),
        temperature_k: Some(300.0),
        latitude_deg: Some(48.0),
        height_m: Some(0.3),
        at_speed_m_s: Some(1.0),
        reach: Some(vec![Reach {
            bounce: 2,
            apex_m: 0.1,
        }]),
        ..plain()
    });
    all.push(Settings {
        release_s: Some(0.05),
        ..plain()
    });
    all.push(Settings {
        air_density_kg_m3: Some(0.0),
        gravity_m_s2: Some(1.62),
        buoyancy: Some(false),
        added_mass: Some(false),
        first_heard: Some(true),
        height_m: Some(3.0),
        ..plain()
    });
    all.push(Settings {
        infer: Some(vec![
            Inferred::Gravity,
            Inferred::Drag,
            Inferred::ContactTime,
        ]),
        height_m: Some(0.3),
        ..plain()
    });
    for settings in all {
        let effort = if settings.ball.is_some() {
            Effort::Quick
        } else {
            Effort::Full
        };
        let impacts = vec![marks(7, 0.93)];
        said.hear_request(
            &AnalysisRequest {
                effort,
                ..request(impacts, settings)
            },
            None,
        );
    }
}

/// What is refused, one setting at a time.
fn of_refusals(said: &mut Said) {
    type Change = fn(&mut Settings, f64);
    let numbers: [Change; 16] = [
        |of, x| (of.mass_kg, of.diameter_m) = (Some(x), Some(0.04)),
        |of, x| (of.mass_kg, of.diameter_m) = (Some(0.003), Some(x)),
        |of, x| of.contact_time_s = Some(x),
        |of, x| of.drag = Some(format!("constant:{x}")),
        |of, x| of.temperature_k = Some(x),
        |of, x| of.pressure_pa = Some(x),
        |of, x| of.relative_humidity = Some(x),
        |of, x| of.air_density_kg_m3 = Some(x),
        |of, x| (of.air_density_kg_m3, of.air_viscosity_pa_s) = (Some(1.2), Some(x)),
        |of, x| of.gravity_m_s2 = Some(x),
        |of, x| of.latitude_deg = Some(x),
        |of, x| (of.latitude_deg, of.altitude_m) = (Some(48.0), Some(x)),
        |of, x| of.height_m = Some(x),
        |of, x| (of.height_m, of.height_sd_m) = (Some(0.3), Some(x)),
        |of, x| (of.release_s, of.release_sd_s) = (Some(0.1), Some(x)),
        |of, x| of.at_speed_m_s = Some(x),
    ];
    let others: [Change; 8] = [
        |of, _| of.mass_kg = Some(0.003),
        |of, _| of.ball = Some("tenis".to_owned()),
        |of, _| of.ball = Some("steel:x".to_owned()),
        |of, _| of.drag = Some("stoke".to_owned()),
        |of, _| of.restitution_laws = Some(vec!["lin".to_owned()]),
        |of, _| (of.mass_kg, of.diameter_m) = (Some(1e-5), Some(0.1)),
        |of, _| (of.drag, of.flights) = (Some("stokes".to_owned()), Some((5, 2))),
        |of, _| of.flights = Some((50, 60)),
    ];
    for wrong in [-1.0, 1e9] {
        for change in numbers.iter().chain(&others) {
            let mut settings = Settings::default();
            change(&mut settings, wrong);
            said.hear_request(&request(vec![marks(7, 0.93)], settings), None);
        }
    }
}

/// What cannot be simulated.
fn of_simulations(said: &mut Said) {
    let constant = |restitution| RestitutionLaw::Constant { restitution };
    let power = |exponent| RestitutionLaw::Power {
        restitution: 0.9,
        at_speed_m_s: 1.0,
        exponent,
    };
    let mut hear = |height_m, restitution, settings| {
        let refused = simulator::simulate(&SimulationRequest {
            settings,
            height_m,
            restitution,
            compare: None,
            until_m: None,
            bounces: None,
        });
        said.hear_all(refused.err().map(|refusal| refusal.message));
    };
    hear(0.3, constant(1.2), Settings::default());
    let endless = Settings {
        air_density_kg_m3: Some(0.0),
        ..Settings::default()
    };
    hear(0.3, constant(0.999_999_9), endless);
    hear(0.3, power(-9.0), Settings::default());
    hear(-0.3, constant(0.9), Settings::default());
    let stokes = Settings {
        drag: Some("schiller-naumann".to_owned()),
        ..Settings::default()
    };
    hear(3.0, constant(0.9), stokes);
}

/// Remarks and warnings, each as it is, also those that no recording here makes.
fn of_remarks(said: &mut Said) {
    said.hear_all([
        Remark::NotConverged(0.93),
        Remark::FewImpacts(2),
        Remark::FewImpacts(3),
        Remark::FewImpacts(4),
        Remark::Odd(vec![3]),
        Remark::Odd(vec![3, 5]),
        Remark::Odd((1..30).collect()),
        Remark::HeightContradicts {
            measured_m: 0.5,
            heard_m: 0.3,
            gravity_m_s2: 16.3,
        },
        Remark::MissedFirst(0.9),
        Remark::HeightIsOfFirstHeard,
        Remark::DragFromPrior,
        Remark::DragOrSlope,
        Remark::NoLawWins,
        Remark::NeverRests,
    ]);
    for seen in [1, 3] {
        let law = LawKind::Knee;
        said.hear(&Remark::TooFewFor { law, seen }.to_string());
    }
    said.hear_all([
        analysis::Warning::Missed(1),
        analysis::Warning::Missed(2),
        analysis::Warning::Gains(vec![4]),
        analysis::Warning::Gains(vec![4, 6]),
        analysis::Warning::Doubtful(1),
        analysis::Warning::Doubtful(2),
        analysis::Warning::Grows(3),
        analysis::Warning::Milliseconds,
    ]);
    let regular = Regular {
        start_s: 0.1,
        interval_s: 0.5,
        count: 9,
    };
    said.hear_all([
        NoDrop::Silence,
        NoDrop::NoSound,
        NoDrop::TooFew(1),
        NoDrop::TooFew(2),
        NoDrop::Regular(regular),
        NoDrop::NoPattern(20),
    ]);
    said.hear_all([
        Unknown::Drag,
        Unknown::Slope,
        Unknown::Scatter,
        Unknown::Timing,
        Unknown::ContactTime,
        Unknown::Gravity,
    ]);
    said.hear(analysis::TOO_FEW_TIMES);
}

/// What is odd about files.
fn of_files(said: &mut Said) {
    let truncated = |expected_s| Warning::Truncated {
        read_s: 1.5,
        expected_s,
    };
    let damaged = |packets| Warning::Damaged {
        packets,
        first_s: 0.5,
    };
    let non_finite = |samples| Warning::NonFinite {
        samples,
        first_s: 0.5,
    };
    said.hear_all([
        truncated(Some(3.0)),
        truncated(None),
        damaged(1),
        damaged(2),
        non_finite(1),
        non_finite(2),
        Warning::Gap {
            at_s: 1.0,
            missing_s: 0.2,
        },
        Warning::FormatChange { at_s: 1.0 },
        Warning::EditsIgnored,
    ]);
    said.hear("a far fainter ball was heard from 1.00 s to 2.00 s (9 impacts) and left out");
    said.hear("12 samples are clipped: the recorder was too loud; times suffer little, levels do");
}

/// The numbers of the paper.
fn of_the_paper(said: &mut Said) {
    for chapter in paper::chapters().unwrap() {
        said.hear(chapter.title);
        for fact in &chapter.facts {
            said.hear(fact.quantity);
            said.hear(fact.note);
        }
    }
}

fn said() -> Said {
    let mut said = Said::default();
    of_recordings(&mut said);
    of_times(&mut said);
    of_settings(&mut said);
    of_refusals(&mut said);
    of_simulations(&mut said);
    of_remarks(&mut said);
    of_files(&mut said);
    of_the_paper(&mut said);
    said
}

/// Those who translate know what is said now.
#[test]
fn translators_know_all_that_is_said() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE);
    let said = said().0;
    if std::env::var_os("BOUNCELAB_UPDATE_SAID").is_some() {
        let lines: Vec<&str> = said.values().map(String::as_str).collect();
        fs::write(&file, lines.join("\n") + "\n").unwrap();
    }
    let known = fs::read_to_string(&file).unwrap_or_default();
    let known: Vec<String> = known.lines().map(shape).collect();
    let new: Vec<&String> = said.keys().filter(|shape| !known.contains(shape)).collect();
    let gone: Vec<&String> = known
        .iter()
        .filter(|shape| !said.contains_key(*shape))
        .collect();
    assert!(
        new.is_empty() && gone.is_empty(),
        "web/src/text/said.txt lacks {new:#?} and has {gone:#?}, which nothing says; write it anew \
         with BOUNCELAB_UPDATE_SAID=1 cargo test -p bouncelab-wasm --test said"
    );
}
