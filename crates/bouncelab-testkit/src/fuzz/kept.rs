//! Bytes as what the project itself wrote: links, records of recordings, rows of a batch, the journal of a session.

use std::fs;

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use bouncelab::analyze_times;
use bouncelab_report::link::LinkedDrop;
use bouncelab_report::messages::Translator;
use bouncelab_session::batch::Batch;
use bouncelab_session::hash::hash;
use bouncelab_session::journal::{JOURNAL, Journal, Key};
use bouncelab_session::{
    Done, Outcome, Record, Result, Results, Store, StudyOptions, figures, tables,
};
use crc::{CRC_32_ISO_HDLC, Crc};

use super::mend;
use super::notes::{folder, gather};

/// Opens the drop of a link with the right checksum, and sends it on.
pub(super) fn read_link(bytes: &[u8]) {
    let check = Crc::<u32>::new(&CRC_32_ISO_HDLC).checksum(bytes);
    let code = URL_SAFE_NO_PAD.encode([bytes, &check.to_be_bytes()].concat());
    let Ok(drop) = LinkedDrop::of_code(&code) else {
        return;
    };
    let again = drop.code().and_then(|code| LinkedDrop::of_code(&code));
    let again = again.expect("what came can be sent on");
    assert_eq!(again.times_s, drop.times_s);
    if let Ok(setup) = drop.settings.without_inference().resolve() {
        let recording = analyze_times(&drop.times_s, &setup.options);
        serde_json::to_string(&recording).expect("a document");
    }
}

/// Studies recordings of which all say the same.
pub(super) fn read_record(bytes: &[u8]) {
    const RECORDINGS: [&str; 4] = ["wood_1.wav", "wood_2.wav", "steel_1.wav", "steel_2.wav"];
    let Ok(record) = serde_json::from_slice::<Record>(bytes) else {
        return;
    };
    let folder = folder(&RECORDINGS);
    let pattern = Some("{surface}_{}".to_owned());
    let recordings = gather(vec![folder.path().to_owned()], None, pattern);
    let recordings = recordings.expect("names that fit the pattern");
    let journal = Journal::open(folder.path()).expect("a new journal");
    let done = recordings.iter().map(|recording| {
        let content = hash(recording.name().as_bytes());
        let key = recording.key(content);
        let kept = journal.append(recording.name(), &key, &record);
        kept.expect("a file in an own folder");
        Done {
            content: Ok(content),
            kept: true,
            without_drop: record.drops.is_empty(),
        }
    });
    let results = Results {
        done: &done.collect::<Vec<_>>(),
        recordings: &recordings,
        store: Store::Journal(&journal),
    };
    study(&results).expect("results that are there");
}

/// Studies the rows of a Parquet file.
pub(super) fn read_rows(bytes: &[u8]) {
    let folder = folder(&[]);
    let file = folder.path().join("rows.parquet");
    fs::write(&file, bytes).expect("a file in an own folder");
    let studied = Batch::open(&file).and_then(|batch| study(&batch.results()));
    if let Err(problem) = studied {
        assert!(!problem.to_string().is_empty());
    }
}

/// Everything that is made of the results of a session.
fn study(results: &Results) -> Result<()> {
    let words = Translator::english();
    let outcome = Outcome::of(results, &StudyOptions::default(), &words)?;
    tables(&outcome, results)?;
    figures(&outcome, results, &words)?;
    serde_json::to_string(&outcome.document()).expect("a document");
    Ok(())
}

/// Goes on with a journal, as it is and with the right checksums.
pub(super) fn read_journal(bytes: &[u8]) {
    for bytes in [bytes, &mend::journal(bytes)] {
        let folder = tempfile::tempdir().expect("an own folder");
        fs::write(folder.path().join(JOURNAL), bytes).expect("a file in an own folder");
        let Ok(journal) = Journal::open(folder.path()) else {
            let left = fs::read(folder.path().join(JOURNAL)).expect("the file");
            assert_eq!(left, bytes, "what is no journal is left alone");
            continue;
        };
        let key = Key {
            content: hash(b"content"),
            settings: hash(b"settings"),
        };
        // It may be a record, or not be one.
        let found = journal.read::<Record>("drop.wav", &key);
        assert!(journal.has("drop.wav", &key) || matches!(found, Ok(None)));
        let own = Record {
            failure: Some("of this run".to_owned()),
            ..Record::default()
        };
        journal
            .append("own.wav", &key, &own)
            .expect("a file in an own folder");
        drop(journal);
        let journal = Journal::open(folder.path()).expect("what was one before");
        let kept = journal.read::<Record>("own.wav", &key);
        assert_eq!(kept.ok().flatten(), Some(own), "what follows is kept");
    }
}
