//! A program that is interrupted leaves no half files. Alone in its program: no draft can be begun
//! afterwards.

use std::fs;
use std::io::Write;

use bouncelab_report::file::{Outputs, abandon_drafts};
use bouncelab_report::mark::Mark;

#[test]
fn an_interrupted_program_takes_its_drafts_along() {
    let folder = tempfile::tempdir().unwrap();
    let outputs = Outputs::default();
    outputs
        .write(&folder.path().join("whole.csv"), Mark::NONE, b"whole")
        .unwrap();
    let drafts = ["a.csv", "b.csv"].map(|name| {
        let draft = outputs
            .draft(&folder.path().join(name), Mark::NONE)
            .unwrap();
        draft.file().write_all(b"half").unwrap();
        draft
    });
    abandon_drafts();
    // As when a program exits: nothing else cleans up.
    drafts.into_iter().for_each(std::mem::forget);
    let left: Vec<_> = fs::read_dir(folder.path())
        .unwrap()
        .map(|it| it.unwrap().file_name())
        .collect();
    assert_eq!(left, ["whole.csv"]);
}
