//! A job as the page keeps it.

mod drops;

use std::collections::BTreeMap;

use bouncelab::settings::Settings;
use bouncelab_report::hash::hash;
use bouncelab_report::messages::Translator;
use bouncelab_report::report::verdict::MethodCheck;
use bouncelab_wasm::analyst::Analyst;
use bouncelab_wasm::job::{new, report, show};
use bouncelab_wasm::refusal::Reason;
use bouncelab_wasm::verdict::rebounds;
use bouncelab_wasm::wire::{JobChange, JobFiles, JobShown, NewJob, ReboundRequest};
use drops::place;

fn shown(files: &JobFiles, change: Option<JobChange>) -> JobShown {
    show(files.clone(), change, &Translator::english()).unwrap()
}

/// A job of a tennis ball: two places by two drops.
fn job() -> JobShown {
    let request = NewJob {
        rule: "itf-tennis".to_owned(),
        name: "Ball 7".to_owned(),
        places: Some(2),
        drops: Some(2),
        settings: Settings::default(),
    };
    let check = MethodCheck::run("2026-11-28".to_owned()).unwrap();
    shown(&new(&request).unwrap(), Some(JobChange::Checked { check }))
}

/// A drop from 2.54 m without air, as a recording of this name.
fn added(job: &JobShown, name: &str, restitution: f64) -> JobChange {
    let place = place(name, 2.54 * restitution * restitution, restitution);
    let request = ReboundRequest {
        rule: job.rule.clone(),
        settings: job.settings.clone(),
        place,
    };
    JobChange::Added {
        sha256: hash(name.as_bytes()),
        ending: "wav".to_owned(),
        given_as: name.to_owned(),
        operator: String::new(),
        added: "2026-11-28 10:00:00".to_owned(),
        rebounds: rebounds(&mut Analyst::default(), &request).unwrap(),
    }
}

fn stated(settings: Settings) -> JobChange {
    let fields = [("client", "A club"), ("equipment", "tape 7\nscale 2")];
    JobChange::Stated {
        fields: BTreeMap::from(fields.map(|(name, value)| (name.to_owned(), value.to_owned()))),
        kept: vec!["surface".to_owned()],
        settings,
    }
}

#[test]
fn drop_after_drop_is_counted_and_one_can_be_repeated() {
    let mut job = job();
    assert_eq!(job.next.as_deref(), Some("Place 1 of 2, drop 1 of 2"));
    assert!(job.so_far.is_none() && job.checks.len() == 1);
    for name in ["a", "b", "c"] {
        job = shown(&job.files, Some(added(&job, name, 0.74)));
    }
    assert_eq!(job.next.as_deref(), Some("Place 2 of 2, drop 2 of 2"));
    assert!(job.so_far.as_ref().unwrap().starts_with("So far 1"));
    // The same recording does not count twice.
    let again = added(&job, "b", 0.74);
    let refused = show(job.files.clone(), Some(again), &Translator::english()).unwrap_err();
    assert_eq!(
        refused.reason.as_deref(),
        Some(&Reason::Counted { number: 2 })
    );
    let reason = "a door slammed".to_owned();
    job = shown(&job.files, Some(JobChange::Repeated { number: 2, reason }));
    assert_eq!(job.next.as_deref(), Some("Place 1 of 2, drop 2 of 2"));
    assert!(!job.recordings[1].counts && job.recordings[1].words.contains("a door slammed"));
    for name in ["d", "e"] {
        job = shown(&job.files, Some(added(&job, name, 0.74)));
    }
    assert!(job.next.is_none() && job.places.iter().all(|place| place.is_done));
    assert_eq!(job.recordings[4].file, "sounds/005.wav");
    let check = MethodCheck::run("2026-11-28".to_owned()).unwrap();
    let page = report(job.files, check, false, &Translator::english()).unwrap();
    for words in [
        "Ball 7",
        "repeated: a door slammed",
        &hash(b"e").to_string(),
    ] {
        assert!(page.contains(words), "{words}");
    }
}

/// Rebounds hold for the settings with which they were computed.
#[test]
fn other_settings_ask_for_the_rebounds_again() {
    let job = job();
    let change = added(&job, "a", 0.74);
    let before = shown(&job.files, Some(change));
    assert!(before.recordings[0].is_known && before.so_far.is_some());
    let mut settings = Settings::default();
    settings.drop.height_m = Some(2.5);
    let job = shown(&before.files, Some(stated(settings)));
    let value = |name: &str| {
        let mut fields = job.fields.iter();
        fields
            .find(|field| field.name == name)
            .unwrap()
            .value
            .clone()
    };
    assert_eq!(
        (value("client"), value("equipment")),
        ("A club".into(), "tape 7\nscale 2".into())
    );
    assert!(!job.recordings[0].is_known && job.so_far.is_none());
    let JobChange::Added { rebounds, .. } = added(&job, "a", 0.74) else {
        unreachable!()
    };
    let number = 1;
    let job = shown(&job.files, Some(JobChange::Computed { number, rebounds }));
    assert!(job.recordings[0].is_known && job.so_far.is_some());
    // Back to those of before, nothing has to be computed.
    let job = shown(&job.files, Some(stated(Settings::default())));
    assert_eq!(
        (job.recordings[0].is_known, job.so_far),
        (true, before.so_far)
    );
}

/// A line that was cut off counts as never written, and is said.
#[test]
fn a_damaged_journal_keeps_its_whole_lines() {
    let job = job();
    let change = added(&job, "a", 0.74);
    let mut files = shown(&job.files, Some(change)).files;
    files.journal.pop();
    let job = shown(&files, None);
    assert_eq!((job.damaged, job.recordings.len()), (1, 1));
    assert!(!job.recordings[0].is_known);
}
