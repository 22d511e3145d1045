//! A drop as the end of a link: it comes back, or what was changed is refused.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use bouncelab::restitution::LawKind;
use bouncelab::settings::{
    AirSettings, AnalysisSettings, BallSettings, DetectionSettings, DropSettings, EditSettings,
    GravitySettings, InferenceSettings, Inferred, Settings,
};
use bouncelab_report::link::{LinkProblem, LinkedDrop};
use crc::{CRC_32_ISO_HDLC, Crc};
use proptest::prelude::*;

/// Letters of a name that travel.
const MAX_LETTERS: usize = 60;

fn drops(impacts: impl Into<proptest::collection::SizeRange>) -> impl Strategy<Value = LinkedDrop> {
    let flights = proptest::collection::vec(1..250_000_i64, impacts);
    let height = proptest::option::of(1..5000_u32);
    let times = (0..10_000_000_i64, flights).prop_map(|(mut step, flights)| {
        let steps = flights.into_iter().map(|flight| {
            step += flight;
            step as f64 / 1e5
        });
        steps.collect::<Vec<_>>()
    });
    (".{0,60}", ".{0,20}", height, times).prop_map(|(name, surface, height_mm, times_s)| {
        LinkedDrop {
            name: name.chars().take(MAX_LETTERS).collect(),
            surface,
            settings: Settings {
                air: AirSettings {
                    temperature_k: Some(293.15),
                    ..AirSettings::default()
                },
                drop: DropSettings {
                    height_m: height_mm.map(|height| f64::from(height) / 1000.0),
                    ..DropSettings::default()
                },
                ..Settings::of_ball("table-tennis-40")
            },
            times_s,
        }
    })
}

/// Every setting of a link that goes with the others, in numbers as people state them: the longest drop that is sent.
/// Digits that nobody states make it longer.
fn all_stated() -> Settings {
    Settings {
        ball: BallSettings {
            kind: Some("table-tennis-40".to_owned()),
            mass_kg: Some(0.002_72),
            diameter_m: Some(0.040_12),
            contact_time_s: Some(0.000_9),
        },
        air: AirSettings {
            drag: Some("standard".to_owned()),
            temperature_k: Some(21.5 + 273.15),
            pressure_pa: Some(98_750.0),
            relative_humidity: Some(0.47),
            density_kg_m3: None,
            viscosity_pa_s: None,
            buoyancy: Some(false),
            added_mass: Some(false),
        },
        gravity: GravitySettings {
            gravity_m_s2: None,
            latitude_deg: Some(48.137_43),
            altitude_m: Some(519.5),
        },
        drop: DropSettings {
            height_m: Some(0.3048),
            height_sd_m: Some(0.001_5),
            release_s: Some(0.123_45),
            release_sd_s: Some(0.005),
            first_detected: Some(false),
        },
        // The times of a link are those that were detected and edited.
        detection: DetectionSettings::default(),
        edits: EditSettings::default(),
        analysis: AnalysisSettings {
            flights: Some((10, 59)),
            ..AnalysisSettings::default()
        },
        inference: InferenceSettings {
            restitution_laws: Some(LawKind::ALL.map(|law| law.name().to_owned()).into()),
            infer: Some(Inferred::ALL.to_vec()),
            ..InferenceSettings::default()
        },
    }
}

proptest! {
    #[test]
    fn every_drop_comes_back(drop in drops(2..200)) {
        prop_assert_eq!(LinkedDrop::of_code(&drop.code().unwrap()).unwrap(), drop);
    }

    #[test]
    fn a_changed_letter_is_refused(drop in drops(2..30), at in any::<prop::sample::Index>(), letter in "[A-Za-z0-9_-]") {
        let code = drop.code().unwrap();
        let at = at.index(code.len());
        let changed = [&code[..at], &letter, &code[at + 1..]].concat();
        prop_assert!(changed == code || LinkedDrop::of_code(&changed).is_err());
        prop_assert!(LinkedDrop::of_code(&code[..at]).is_err());
    }

    /// Flights that have nothing to do with each other, which no drop has, all that can be stated, and the longest name in
    /// letters of three bytes.
    #[test]
    fn sixty_impacts_with_all_that_can_be_stated_fit_a_link(drop in drops(60)) {
        const ADDRESS: &str = "https://physics.example.org/bouncelab/#lab?drop=";
        let named = LinkedDrop { name: "\u{6f22}".repeat(MAX_LETTERS), settings: all_stated(), ..drop };
        let code = named.code().unwrap();
        prop_assert!(ADDRESS.len() + code.len() <= 1600, "{}", code.len());
        prop_assert_eq!(LinkedDrop::of_code(&code).unwrap(), named);
    }

    #[test]
    fn no_text_is_a_panic(code in "[A-Za-z0-9_-]{0,80}") {
        prop_assert!(LinkedDrop::of_code(&code).is_err());
    }
}

/// What makes the reader wait, or changes results without being shown, is not sent; nor accepted, if another program sends it.
#[test]
fn a_link_states_only_what_the_form_offers() {
    let stated = Settings {
        inference: InferenceSettings {
            draws: Some(100_000),
            restitution_prior: Some("normal:1=0.5:0.001".to_owned()),
            ..InferenceSettings::default()
        },
        ..all_stated()
    };
    let drop = LinkedDrop {
        name: String::new(),
        surface: String::new(),
        settings: stated,
        times_s: vec![0.0, 1.0],
    };
    let code = drop.code().unwrap();
    let sent = LinkedDrop::of_code(&code).unwrap();
    assert_eq!(sent.settings.inference.draws, None);
    assert_eq!(sent.settings.inference.restitution_prior, None);
    assert_eq!(sent.settings.ball, drop.settings.ball);
    // A name with the text of settings in its place, of the same length.
    let draws = r#"{"inference":{"draws":100000}}"#;
    let named = LinkedDrop {
        name: draws.to_owned(),
        settings: Settings::of_ball("basketball1234"),
        ..drop
    };
    let bytes = URL_SAFE_NO_PAD.decode(named.code().unwrap()).unwrap();
    let (packed, _) = bytes.split_last_chunk::<4>().unwrap();
    let ball = r#"{"ball":{"kind":"basketball1234"}}"#;
    let place = packed
        .windows(ball.len())
        .position(|it| it == ball.as_bytes());
    let forged = format!("{draws:34}");
    let mut forged = [
        &packed[..place.unwrap()],
        forged.as_bytes(),
        &packed[place.unwrap() + ball.len()..],
    ]
    .concat();
    let check = Crc::<u32>::new(&CRC_32_ISO_HDLC).checksum(&forged);
    forged.extend(check.to_be_bytes());
    let forged = URL_SAFE_NO_PAD.encode(forged);
    assert_eq!(LinkedDrop::of_code(&forged), Err(LinkProblem::OtherVersion));
}

#[test]
fn what_is_no_drop_is_refused() {
    for times_s in [
        vec![],
        vec![1.0],
        vec![1.0, 1.0],
        vec![2.0, 1.0],
        vec![0.0, f64::NAN],
        vec![0.0, 1e300],
    ] {
        let drop = LinkedDrop {
            name: String::new(),
            surface: String::new(),
            settings: Settings::default(),
            times_s,
        };
        assert_eq!(drop.code(), Err(LinkProblem::Times), "{drop:?}");
    }
}
