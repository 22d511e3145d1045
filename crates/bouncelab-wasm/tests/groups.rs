//! Kept drops as the page compares them.

use std::collections::BTreeMap;

use bouncelab::groups::CurveEvidence;
use bouncelab::inference::Measured;
use bouncelab_report::messages::Translator;
use bouncelab_report::report::Block;
use bouncelab_wasm::groups::{report, study};
use bouncelab_wasm::wire::{Comparable, Studied, StudiedDrop, StudyRequest};

fn drop(name: &str, ball: &str, restitution: f64) -> StudiedDrop {
    let sd = 0.001;
    let point = |speed_m_s| {
        (
            speed_m_s,
            Measured {
                value: restitution,
                sd,
            },
        )
    };
    StudiedDrop {
        name: name.to_owned(),
        factors: BTreeMap::from([("ball".to_owned(), ball.to_owned())]),
        comparable: Some(Comparable {
            evidence: CurveEvidence::measured(&[0.5, 1.0, 2.0].map(point)),
            scatter: 0.003,
        }),
        impacts: vec![[1.5, restitution], [1.2, restitution]],
    }
}

fn request(drops: Vec<StudiedDrop>) -> StudyRequest {
    StudyRequest {
        title: "Class 8b".to_owned(),
        drops,
        by: vec!["ball".to_owned()],
        made: None,
    }
}

fn class() -> Vec<StudiedDrop> {
    let golf = [0.820, 0.823, 0.818, 0.821].map(|e| drop("of golf", "golf", e));
    let tennis = [0.741, 0.739, 0.742, 0.738, 0.74].map(|e| drop("of tennis", "tennis", e));
    let outlier = drop("Ben", "golf", 0.6);
    [golf.to_vec(), vec![outlier], tennis.to_vec()].concat()
}

fn notes(studied: &Studied) -> String {
    let notes = studied.lead.iter().filter_map(|block| match block {
        Block::Note(words) => Some(words.as_str()),
        _ => None,
    });
    notes.collect::<Vec<_>>().join("\n")
}

#[test]
fn groups_have_their_means_and_outliers_their_names() {
    let translator = Translator::english();
    let studied = study(&request(class()), &translator).unwrap();
    assert!(notes(&studied).contains("Ben"), "{}", notes(&studied));
    let html = report(&request(class()), &translator).unwrap();
    for text in ["Class 8b", "golf", "0.7400", "Ben"] {
        assert!(html.contains(text), "{text}");
    }
}

#[test]
fn what_cannot_be_told_says_why() {
    let translator = Translator::english();
    let notes_of = |drops| notes(&study(&request(drops), &translator).unwrap());
    assert!(notes_of(Vec::new()).contains("no drop has an inference"));
    let one = vec![drop("Anna", "golf", 0.82)];
    assert!(notes_of(one.clone()).contains("One drop alone"));
    let two = [one, vec![drop("Ben", "golf", 0.83)]].concat();
    assert!(notes_of(two).contains("All drops are in one group"));
}

#[test]
fn a_drop_without_an_inference_is_named_and_the_others_count() {
    let unknown = StudiedDrop {
        comparable: None,
        ..drop("Cleo", "golf", 0.8)
    };
    let drops = [vec![unknown], class()].concat();
    let html = report(&request(drops), &Translator::english()).unwrap();
    assert!(html.contains("Cleo: it says nothing of the restitution curve"));
    assert!(html.contains("0.7400"));
}

#[test]
fn a_field_of_which_nothing_is_noted_makes_no_groups() {
    let request = StudyRequest {
        by: vec!["surface".to_owned()],
        ..request(class())
    };
    let studied = study(&request, &Translator::english()).unwrap();
    assert!(notes(&studied).contains("All drops are in one group"));
}
