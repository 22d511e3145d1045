//! What is seen of a file while it is written, and when that fails.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use bouncelab_report::file::{Draft, Outputs, remove_drafts};
use bouncelab_report::mark::Mark;

fn draft(path: &Path) -> io::Result<Draft> {
    Outputs::new([""; 0], true).draft(path, Mark::NONE)
}

fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    Outputs::new([""; 0], true).write(path, Mark::NONE, bytes)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

#[test]
fn a_draft_that_is_given_up_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("table.csv");
    let draft = draft(&place).unwrap();
    draft.file().write_all(b"half").unwrap();
    assert_eq!(names(folder.path()).len(), 1);
    drop(draft);
    assert!(names(folder.path()).is_empty());
}

#[test]
fn two_drafts_of_one_file_do_not_disturb_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("table.csv");
    let (first, second) = (draft(&place).unwrap(), draft(&place).unwrap());
    first.file().write_all(b"first").unwrap();
    second.file().write_all(b"second").unwrap();
    second.finish().unwrap();
    first.finish().unwrap();
    assert_eq!(fs::read(&place).unwrap(), b"first");
    assert_eq!(names(folder.path()), ["table.csv"]);
}

#[test]
fn the_place_of_a_folder_is_refused_before_anything_is_written() {
    let folder = tempfile::tempdir().unwrap();
    assert!(write_whole(folder.path(), b"").is_err());
    assert!(draft(&folder.path().join("nowhere/table.csv")).is_err());
    assert!(names(folder.path()).is_empty());
}

#[test]
fn drafts_of_a_killed_program_are_removed_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    for name in [".bouncelab-a1B2c3.part", ".film.part", ".hidden", "my.part"] {
        fs::write(folder.path().join(name), "").unwrap();
    }
    remove_drafts(folder.path()).unwrap();
    let mut left = names(folder.path());
    left.sort();
    assert_eq!(left, [".film.part", ".hidden", "my.part"]);
}

/// As the system makes any other file: who may read it is the business of the user's mask.
#[cfg(unix)]
#[test]
fn files_have_the_permissions_of_any_new_file() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let mode = |name: &str| {
        let about = fs::metadata(folder.path().join(name)).unwrap();
        about.permissions().mode()
    };
    fs::write(folder.path().join("ordinary"), "").unwrap();
    write_whole(&folder.path().join("whole"), b"").unwrap();
    assert_eq!(mode("whole"), mode("ordinary"));
}

#[cfg(unix)]
#[test]
fn a_link_remains_and_what_it_leads_to_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let (place, link) = (folder.path().join("table.csv"), folder.path().join("link"));
    fs::write(&place, "old").unwrap();
    std::os::unix::fs::symlink("table.csv", &link).unwrap();
    write_whole(&link, b"new").unwrap();
    assert_eq!(fs::read(&place).unwrap(), b"new");
    assert!(link.is_symlink());
}

/// A socket stands for all that is no file: moved into the place of a device, a file would take it
/// from the whole system.
#[cfg(unix)]
#[test]
fn the_place_of_a_device_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("socket");
    let _socket = std::os::unix::net::UnixListener::bind(&place).unwrap();
    assert!(write_whole(&place, b"").is_err());
    assert_eq!(names(folder.path()), ["socket"]);
}
