//! Text of others stays text: names and notes that try to be commands, other lines or formulas.

use std::fs;
use std::path::PathBuf;

use assert_cmd::Command;
use tempfile::TempDir;

const TIMES: &str = "0\n0.4489\n0.8529\n1.2165\n1.5437\n1.8383\n2.1034\n";

/// Red, cleared, of another title, reversed, on another line.
#[cfg(unix)]
const NAME: &str = "=1\u{1b}[31m\u{9b}2J\u{7}\u{202e}txt.wav\nbouncelab: pass\u{2066}.txt";

/// What nothing that is shown may hold.
fn is_command(letter: char) -> bool {
    (letter.is_control() && letter != '\n') || matches!(letter, '\u{202e}' | '\u{2066}')
}

#[cfg(unix)]
fn run(folder: &TempDir, words: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::cargo_bin("bouncelab").unwrap();
    let output = command.args(words).current_dir(folder).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

#[cfg(unix)]
fn shown(text: &str) {
    assert!(!text.contains(is_command), "{text:?}");
    assert!(
        !text.lines().any(|line| line.starts_with("bouncelab: pass")),
        "{text}"
    );
}

/// All that is shown of a recording of this name, in the terminal and in files.
#[cfg(unix)]
#[test]
fn a_hostile_name_is_written_out_wherever_it_is_shown() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(NAME), TIMES).unwrap();
    let page = |ending: &str| {
        let report = format!("report.{ending}");
        let words = [
            "analyze",
            NAME,
            "--no-inference",
            "--report",
            &report,
            "--figures",
            "f",
        ];
        let (code, out, err) = run(&folder, &words);
        assert_eq!(code, Some(0), "{err}");
        assert!(
            out.contains(r"\u{1b}[31m\u{9b}2J\u{7}\u{202e}txt.wav\nbouncelab: pass\u{2066}.txt"),
            "{out}"
        );
        shown(&(out + &err));
        fs::read_to_string(folder.path().join(report)).unwrap()
    };
    shown(&page("html"));
    shown(&page("md"));
    let drawings = fs::read_dir(folder.path().join("f"))
        .unwrap()
        .map(|it| it.unwrap().path());
    for drawing in drawings.filter(|it| it.extension().is_some_and(|it| it == "svg")) {
        shown(&fs::read_to_string(drawing).unwrap());
    }
    let absent = format!("x{NAME}");
    for words in [
        &["analyze", &absent][..],
        &["analyze", NAME, "--report", &absent],
        &["session", &absent],
        &["verdict", "--rule", &absent, NAME],
    ] {
        let (code, out, err) = run(&folder, words);
        assert_ne!(code, Some(0));
        shown(&(out + &err));
    }
}

/// What a title, a ball and a field say comes from others too.
#[cfg(unix)]
#[test]
fn hostile_notes_are_written_out_wherever_they_are_shown() {
    const HOSTILE: &str = r"\u001b[31m\u0007\u202etxt\nbouncelab: pass\u2066";
    let folder = TempDir::new().unwrap();
    let notes = format!("title = \"{HOSTILE}\"\n[all]\nsurface = \"{HOSTILE}\"\n");
    fs::write(folder.path().join("session.toml"), notes).unwrap();
    fs::write(folder.path().join("one.wav"), "").unwrap();
    let times = ["one.txt", "two.txt"];
    for (name, by_s) in times.iter().zip([1.0, 1.01]) {
        let seconds = TIMES
            .lines()
            .map(|time| time.parse::<f64>().unwrap() * by_s);
        let scaled: Vec<String> = seconds.map(|time_s| format!("{time_s}\n")).collect();
        fs::write(folder.path().join(name), scaled.concat()).unwrap();
    }
    for ending in ["html", "md"] {
        let report = format!("report.{ending}");
        let words = format!(
            "session session.toml one.txt two.txt --output s --ball tennis --draws 100 --figures --details \
             --report {report}"
        );
        let words: Vec<&str> = words.split(' ').collect();
        let (code, out, err) = run(&folder, &words);
        assert_eq!(code, Some(0), "{err}");
        assert!(out.contains(r"\u{1b}[31m"), "{out}");
        shown(&(out + &err));
        let report = fs::read_to_string(folder.path().join(report)).unwrap();
        // Markdown escapes the rest once more.
        assert!(report.contains("u{1b}"), "{report}");
        shown(&report);
    }
    let made = fs::read_dir(folder.path().join("s")).unwrap();
    let drawings = made.map(|it| it.unwrap().path());
    for drawing in drawings.filter(|it| it.extension().is_some_and(|it| it == "svg")) {
        shown(&fs::read_to_string(drawing).unwrap());
    }
}

/// What is refused is named, in one line.
#[cfg(unix)]
#[test]
fn refusals_of_hostile_notes_and_rules_are_one_line() {
    const HOSTILE: &str = r"x\nbouncelab: pass";
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("a.wav"), "").unwrap();
    let rule = "schema = \"bouncelab.rules/2\"\n[[rule]]\nname = \"a\"\n";
    let whole = format!(
        "{rule}source = {{ publisher = \"us\", read = \"primary\" }}\ndrop = {{}}\nrebound = {{}}\n"
    );
    let broken = HOSTILE.replace(r"\n", "\n");
    let session = &["session", ".", "--ball", "tennis", "--no-inference"][..];
    let notes = &[session, &["--notes", "notes.csv"]].concat();
    let rules = &["rules", "show", "a", "--rules", "rules.toml"][..];
    let cases = [
        (
            session,
            "session.toml",
            format!("[recordings.\"{HOSTILE}\"]\n"),
        ),
        (
            session,
            "session.toml",
            format!("[all]\n\"{HOSTILE}\" = []\n"),
        ),
        (session, "session.toml", format!("\"{HOSTILE}\" = 1\n")),
        (
            session,
            "session.toml",
            format!("pattern = \"{{{HOSTILE}\"\n"),
        ),
        (
            session,
            "session.toml",
            format!("pattern = \"{{ball}}_{{{HOSTILE}}}_\"\n"),
        ),
        (
            session,
            "session.toml",
            format!("[all]\nball = \"b\"\n[balls.b]\n\"{HOSTILE}\" = 1\n"),
        ),
        (
            session,
            "session.toml",
            format!("[all]\nball = \"{HOSTILE}\"\n[balls.\"{HOSTILE}\"]\ncolour = 1\n"),
        ),
        (
            notes,
            "notes.csv",
            format!("recording,ball\n\"{broken}\",b\n"),
        ),
        (
            notes,
            "notes.csv",
            format!("recording,\na.wav,\"{broken}\"\n"),
        ),
        (
            notes,
            "notes.csv",
            format!("recording,\"height ({broken})\"\na.wav,1\n"),
        ),
        (
            rules,
            "rules.toml",
            format!("{whole}title = \"{HOSTILE}\"\n"),
        ),
        (
            rules,
            "rules.toml",
            format!("{whole}title = \"a\"\nsurface = \"{HOSTILE}\"\n"),
        ),
        (rules, "rules.toml", format!("{rule}\"{HOSTILE}\" = 1\n")),
        (
            rules,
            "rules.toml",
            whole.replace("\"a\"", &format!("\"{HOSTILE}\"")) + "title = \"a\"\n",
        ),
    ];
    for (words, name, content) in cases {
        let file = folder.path().join(name);
        fs::write(&file, &content).unwrap();
        let (_, out, err) = run(&folder, words);
        assert!(
            (out.clone() + &err).contains("bouncelab: pass"),
            "{content}: {out}{err}"
        );
        shown(&(out + &err));
        fs::remove_file(file).unwrap();
    }
}

#[cfg(unix)]
#[test]
fn a_spreadsheet_runs_nothing_unless_that_is_wanted() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("=1+2.txt"), TIMES).unwrap();
    let notes = "recording,ball,surface,@sum\n=1+2.txt,tennis,=HYPERLINK(\"\"x\"\"),\u{ff0b}1\n";
    fs::write(
        folder.path().join("notes.csv"),
        notes.replace("\"\"x\"\"", "x"),
    )
    .unwrap();
    let cells = |words: &[&str], file: Option<PathBuf>| {
        let (code, out, err) = run(&folder, words);
        assert_eq!(code, Some(0), "{err}");
        let text = file.map_or(out, |file| fs::read_to_string(file).unwrap());
        let cells = text.split([',', '\n']).map(str::to_owned);
        cells
            .filter(|cell| cell.starts_with(['=', '\u{ff0b}', '@']))
            .collect::<Vec<_>>()
    };
    let session = [
        "session",
        "=1+2.txt",
        "--notes",
        "notes.csv",
        "--no-inference",
        "--output",
        "s",
    ];
    let drops = || Some(folder.path().join("s/drops.csv"));
    assert_eq!(cells(&session, drops()), [""; 0]);
    let raw = [&session[..], &["--csv-raw"]].concat();
    assert_eq!(
        cells(&raw, drops()),
        ["@sum", "=1+2.txt", "\u{ff0b}1", "=HYPERLINK(x)"]
    );
    let analyze = ["analyze", "=1+2.txt", "--no-inference", "--format", "csv"];
    assert_eq!(cells(&analyze, None), [""; 0]);
    let raw = [&analyze[..], &["--csv-raw"]].concat();
    assert!(cells(&raw, None).iter().all(|cell| cell == "=1+2.txt"));
}
