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

/// Bash offers the names that an argument knows, of balls, drag laws, restitution laws and rules.
#[test]
fn completions_offer_names() {
    let offered = [
        ("analyze", "--ball", "ten", "tennis"),
        ("analyze", "--drag", "stan", "standard"),
        ("analyze", "--law", "visc", "viscoelastic"),
        ("simulate", "--drag", "no", "none"),
        ("verdict", "--rule", "ittf-b", "ittf-ball"),
        ("synth", "--voice", "bask", "basketball"),
    ];
    let printed = bouncelab().args(["completions", "bash"]).assert();
    let script = String::from_utf8(printed.get_output().stdout.clone()).unwrap();
    for (command, option, begun, name) in offered {
        let question = format!(
            "{script}\nCOMP_WORDS=(bouncelab {command} {option} {begun}); COMP_CWORD=3\n\
             _bouncelab bouncelab {begun} {option}; echo \"${{COMPREPLY[*]}}\""
        );
        let answer = Command::new("bash").args(["-c", &question]).assert();
        answer.success().stdout(contains(name));
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
