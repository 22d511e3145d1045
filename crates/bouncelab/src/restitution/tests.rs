use std::collections::HashSet;

use super::*;
use crate::error::Error;

#[test]
#[expect(clippy::float_cmp, reason = "the ends of the range are exact")]
fn restitution_stays_a_fraction() {
    let line = Restitution::linear(0.9, 0.1).unwrap();
    assert_eq!(line.at(0.0), 0.9);
    assert_eq!(line.at(100.0), 0.0);
    assert_eq!(Restitution::linear(0.9, -0.1).unwrap().at(100.0), 1.0);
    let power = Restitution::power(0.9, 1.0, 0.25).unwrap();
    assert_eq!(power.at(1e-9), 1.0);
}

#[test]
fn absurd_laws_are_refused() {
    for restitution in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
        assert!(Restitution::constant(restitution).is_err());
        assert!(Restitution::power(restitution, 1.0, 0.1).is_err());
        assert!(Restitution::knee(restitution, 1.0, 0.1).is_err());
        assert!(Restitution::viscoelastic_through(restitution, 1.0).is_err());
    }
    assert!(Restitution::linear(2.1, 0.0).is_err());
    assert!(Restitution::linear(0.9, f64::NAN).is_err());
    assert!(Restitution::power(0.9, 0.0, 0.1).is_err());
    assert!(Restitution::viscoelastic(-1.0).is_err());
    assert!(Restitution::smooth(0.9, [1.0, 1.0, 2.0], [0.0; 5]).is_err());
    assert!(Restitution::smooth(0.9, [0.5, 1.0, 2.0], [0.0, 0.0, f64::NAN, 0.0, 0.0]).is_err());
    assert!(Restitution::knee(0.9, 1.0, f64::INFINITY).is_err());
}

/// The logarithm of e by the logarithm of the speed, of every law, beyond its bounds too.
#[test]
fn logarithms_are_those_of_the_law() {
    let laws = [
        Restitution::constant(0.9).unwrap(),
        Restitution::linear(0.95, 0.03).unwrap(),
        Restitution::linear(0.9, -0.1).unwrap(),
        Restitution::power(0.9, 2.0, 0.1).unwrap(),
        Restitution::viscoelastic_through(0.9, 2.0).unwrap(),
        Restitution::knee(0.9, 1.5, 0.1).unwrap(),
        Restitution::smooth(0.9, [0.5, 1.0, 2.0], [0.0, -0.05, 0.02, 0.03, 0.1]).unwrap(),
    ];
    for law in laws {
        for v in [1e-4_f64, 0.1, 0.7, 1.0, 1.6, 4.0, 9.0] {
            let (e, log_slope) = law.at_with_log_slope(v);
            let of_logarithm = Restitutions::of(&[law]);
            let (Lanes([ln_e]), Lanes([slope])) =
                of_logarithm.ln_at_with_log_slope(Lanes([v.ln()]));
            assert!((ln_e - e.ln()).abs() < 1e-14, "{law:?} {v}: {ln_e}");
            assert!((slope - log_slope).abs() < 1e-12, "{law:?} {v}: {slope}");
        }
    }
    let beyond = Restitutions::of(&[Restitution::linear(0.9, 0.1).unwrap()]);
    assert!(beyond.ln_at_with_log_slope(Lanes([3.0])).0.0[0].is_nan());
}

/// C1 = 1.15344 and C2 = 3/5 C1² of the viscoelastic series (T. Schwager, T. Pöschel, Phys.
/// Rev. E 57, 650, 1998), for a dissipation so small that the next term is below 1e-6.
#[test]
fn the_pade_form_begins_as_the_series() {
    let (a, v) = (1e-3_f64, 2.0_f64);
    let law = Restitution::viscoelastic(a).unwrap();
    let z = a * v.powf(0.2);
    let (c1, c2) = (1.15344, 0.6 * 1.15344 * 1.15344);
    assert!((law.at(v) - (1.0 - c1 * z + c2 * z * z)).abs() < 1e-6);
}

#[test]
fn a_viscoelastic_ball_goes_through_its_point() {
    for e in [0.01, 0.1, 0.5, 0.9, 0.99, 0.999_999] {
        let law = Restitution::viscoelastic_through(e, 1.7).unwrap();
        assert!((law.at(1.7) / e - 1.0).abs() < 1e-12, "{e}");
    }
    let lossless = Restitution::viscoelastic_through(1.0, 1.7).unwrap();
    assert!((lossless.at(5.0) - 1.0).abs() < 1e-15);
}

/// The slope of each law against a central difference.
#[test]
fn log_slopes_are_the_derivatives() {
    let laws = [
        Restitution::constant(0.9),
        Restitution::linear(0.95, 0.01),
        Restitution::power(0.9, 2.0, 0.05),
        Restitution::viscoelastic_through(0.9, 2.0),
        Restitution::knee(0.95, 1.5, 0.02),
        Restitution::smooth(0.9, [1.0, 1.5, 2.0], [0.03, 0.05, -0.02, -0.07, -0.1]),
    ];
    for law in laws.map(crate::error::Result::unwrap) {
        for v in [0.5, 1.4, 1.6, 3.0_f64] {
            let h = 1e-5;
            let (above, below) = (law.at(v * (1.0 + h)).ln(), law.at(v * (1.0 - h)).ln());
            let expected = (above - below) / (2.0 * h);
            assert!((law.log_slope(v) - expected).abs() < 1e-8, "{law:?} at {v}");
        }
    }
}

#[test]
fn a_knee_is_flat_below_and_straight_above() {
    let law = Restitution::knee(0.95, 1.5, 0.02).unwrap();
    assert!((law.at(0.5) - 0.95).abs() < 1e-5);
    assert!((law.at(3.0) - (0.95 - 0.02 * 1.5)).abs() < 1e-5);
}

/// The list is what all front ends offer.
#[test]
fn each_law_of_the_list_has_a_name_an_example_and_random_numbers_of_its_own() {
    let names: HashSet<&str> = LawKind::ALL.iter().map(|law| law.name()).collect();
    let streams: HashSet<u64> = LawKind::ALL.iter().map(|law| law.random_stream()).collect();
    assert_eq!(names.len(), LawKind::ALL.len());
    assert_eq!(streams.len(), LawKind::ALL.len());
    for law in LawKind::ALL {
        assert_eq!(law.name().parse(), Ok(law));
        let example: Restitution = law.example().parse().unwrap();
        assert!(law.example().starts_with(law.name()), "{law}");
        assert!(example.at(1.0) > 0.8 && example.at(1.0) <= 0.96, "{law}");
    }
}

/// Results with a seed depend on these numbers: a law keeps its own for ever.
#[test]
fn random_numbers_belong_to_the_name() {
    let streams = LawKind::ALL.map(|law| (law.name(), law.random_stream()));
    for stream in [
        ("constant", 0),
        ("linear", 1),
        ("power", 2),
        ("viscoelastic", 3),
        ("knee", 4),
        ("smooth", 5),
    ] {
        assert!(streams.contains(&stream), "{stream:?}");
    }
}

#[test]
fn a_law_as_text_is_its_name_with_its_numbers() {
    assert_eq!("0.9".parse(), Restitution::constant(0.9));
    assert_eq!(
        "power: 0.9, 2, 0.1".parse(),
        Restitution::power(0.9, 2.0, 0.1)
    );
    let law = |text: &str| text.parse::<Restitution>();
    for text in [
        "",
        "power",
        "power:0.9",
        "power:0.9,x,0.1",
        "knee:1,2,3,4",
        "powr:0.9,1,0.1",
    ] {
        assert!(
            matches!(law(text), Err(Error::UnknownName { .. })),
            "{text}"
        );
    }
    for text in ["1.1", "NaN", "linear:3,0", "smooth:0.9,2,1,3,0,0,0,0,0"] {
        assert!(matches!(law(text), Err(Error::OutOfRange { .. })), "{text}");
    }
    let nearest = law("powr:0.9").unwrap_err().diagnostic();
    assert_eq!(
        nearest.arguments["nearest"],
        LawKind::Power.example().into()
    );
}

/// The prior of each law begins with its restitution at the reference speed, and a search that starts from a slope starts
/// from a law with that slope.
#[test]
fn laws_of_the_prior_have_their_restitution_and_their_slope() {
    let speeds = SpeedRange {
        reference_m_s: 1.7,
        slowest_m_s: 0.6,
        fastest_m_s: 3.1,
    };
    for kind in LawKind::ALL {
        let law = kind.of_normals(0.9, [0.0; MAX_SHAPES], &speeds).unwrap();
        let at_reference = if kind == LawKind::Knee {
            law.at(speeds.slowest_m_s)
        } else {
            law.at(speeds.reference_m_s)
        };
        // The corner of a knee is rounded.
        assert!((at_reference - 0.9).abs() < 1e-4, "{kind}: {at_reference}");
        let mut normals = [0.0; MAX_SHAPES];
        normals[0] = 0.8;
        let sloped = kind.of_normals(0.9, normals, &speeds).unwrap();
        let log_slope = sloped.log_slope(speeds.reference_m_s);
        let normal = kind.normal_of_slope(log_slope, &speeds, true);
        assert_eq!(normal.is_some(), kind.has_slope());
        assert!(
            normal.is_none_or(|normal| (normal - normals[0]).abs() < 1e-9),
            "{kind}"
        );
    }
}
