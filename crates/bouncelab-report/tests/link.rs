//! A drop as the end of a link: it comes back, or what was changed is refused.

use bouncelab::setup::Settings;
use bouncelab_report::Error;
use bouncelab_report::link::LinkedDrop;
use proptest::prelude::*;

/// Letters of a name that travel.
const MOST_LETTERS: usize = 60;

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
    (".{0,60}", height, times).prop_map(|(name, height_mm, times_s)| LinkedDrop {
        name: name.chars().take(MOST_LETTERS).collect(),
        settings: Settings {
            ball: Some("table-tennis-40".to_owned()),
            height_m: height_mm.map(|height| f64::from(height) / 1000.0),
            temperature_k: Some(293.15),
            ..Settings::default()
        },
        times_s,
    })
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

    /// Flights that have nothing to do with each other, which no drop has, and the longest name of ASCII.
    #[test]
    fn sixty_impacts_fit_a_qr_code(drop in drops(60)) {
        let named = LinkedDrop { name: "x".repeat(MOST_LETTERS), ..drop };
        prop_assert!(named.code().unwrap().len() <= 700);
    }

    #[test]
    fn no_text_is_a_panic(code in "[A-Za-z0-9_-]{0,80}") {
        prop_assert!(LinkedDrop::of_code(&code).is_err());
    }
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
            settings: Settings::default(),
            times_s,
        };
        assert!(matches!(drop.code(), Err(Error::Link { .. })), "{drop:?}");
    }
}
