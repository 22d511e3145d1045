//! What shells and `man` are told of the program.

use std::fs;

use assert_cmd::Command;
use predicates::str::contains;

fn bouncelab() -> Command {
    Command::new(env!("CARGO_BIN_EXE_bouncelab"))
}

#[test]
fn every_shell_gets_completions() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let printed = bouncelab().args(["completions", shell]).assert();
        printed.success().stdout(contains("which-ball"));
    }
}

/// A page for every command, which is written again over itself and over nothing else.
#[test]
fn every_command_has_a_page() {
    let folder = tempfile::tempdir().unwrap();
    let pages = folder.path().join("man1");
    for _ in 0..2 {
        bouncelab().arg("manual").arg(&pages).assert().success();
    }
    let page = fs::read_to_string(pages.join("bouncelab-analyze.1")).unwrap();
    assert!(
        page.contains(".TH") && page.contains("which\\-ball"),
        "{page}"
    );
    assert!(pages.join("bouncelab-rules-show.1").is_file());
    fs::write(pages.join("bouncelab.1"), "a page of another program").unwrap();
    let refused = bouncelab().arg("manual").arg(&pages).assert();
    refused.failure().stderr(contains("bouncelab.1"));
}
