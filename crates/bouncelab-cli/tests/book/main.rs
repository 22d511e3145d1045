//! The book in `docs`: its commands run and print the quoted output, its links resolve, and its reference and pictures are
//! those that the program makes. The commands of `README.md` run too; its numbers are those of a real recording.
//!
//! With `BOUNCELAB_BOOK=write` (`cargo xtask book`) pictures and reference are written instead of compared.

#![cfg(unix)]

mod measured;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::process::{Command, Output};

use bouncelab_audio::SoundReader;
use bouncelab_testkit::damage;
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use tempfile::TempDir;

/// Why this test does not run a command.
enum Elsewhere {
    /// This check of `cargo xtask test` runs it, or one that does the same.
    Check(&'static str),
    /// No check runs it, for this reason.
    Never(&'static str),
}

use Elsewhere::{Check, Never};

/// The check runs it on less than the page does, which takes hours.
const MEASURED: Elsewhere = Check("measurements");

/// The beginnings of commands that this test does not run. The first match counts.
const ELSEWHERE: [(&str, Elsewhere); 24] = [
    ("bouncelab listen --devices", Check("card")),
    ("bouncelab listen --ball tennis --save", Check("card")),
    ("bouncelab session --from", Check("cluster")),
    ("cargo binstall ", Never("it takes a release")),
    ("cargo build --release -p bouncelab-bench", MEASURED),
    ("cargo run --release -- demo", Check("fresh")),
    ("cargo xtask damage step=2", MEASURED),
    ("cargo xtask detection", MEASURED),
    (
        "cargo xtask install",
        Never("the checks `web` and `fresh` make the page and the program, in less time"),
    ),
    ("cargo xtask laboratory /tmp/laboratory 10000", MEASURED),
    ("cargo xtask laboratory target/laboratory 240", MEASURED),
    ("cargo xtask wheel", Check("python")),
    ("pip install target/wheels/", Check("python")),
    ("python -m bouncelab analyze ", Check("python")),
    ("spark-submit ", Check("cluster")),
    // The check unpacks the package and runs what is in it.
    ("sudo apt install ./bouncelab_", Check("release")),
    // Where they are missing.
    ("sudo apt install libasound2-dev", Check("clippy")),
    ("uvx --from target/wheels/", Check("python")),
    (
        "/usr/bin/time -v bouncelab session /tmp/laboratory",
        MEASURED,
    ),
    ("cd crates/bouncelab-python", Check("python")),
    ("python=../../target/", Check("python")),
    (
        "../../target/python3.11-venv/bin/uv pip install",
        Check("python"),
    ),
    ("$python benchmarks/measure.py", Check("python")),
    // A test compares the same tables of fewer recordings.
    ("BOUNCELAB_LABORATORY=", Check("python")),
];

/// The recordings that the pages assume: beginnings of their names, and options of `synth`.
const RECORDINGS: [(&str, &str); 4] = [
    ("drop", "--height 30.5cm --restitution 0.91"),
    (
        "floor",
        "--ball basketball --voice basketball --height 1.8m --restitution 0.76",
    ),
    (
        "concrete",
        "--ball basketball --voice basketball --height 1.8m --restitution 0.80",
    ),
    (
        "recordings/tennis_wood_1m_",
        "--ball tennis --voice tennis --height 1m --restitution 0.74",
    ),
];

/// Encoded drops of the test kit, and their names on the pages.
const ENCODED: [(&str, &str); 3] = [
    ("aac.m4a", "sounds/phone.m4a"),
    ("aac.m4a", "drop.m4a"),
    ("opus-stream.webm", "sounds/browser.webm"),
];

/// A page of the book.
struct Page {
    /// Relative to the folder of the book.
    path: PathBuf,
    text: String,
}

/// A block of code.
struct Block {
    language: String,
    code: String,
    /// Whether it directly follows the block before it.
    follows: bool,
}

impl Page {
    fn read(path: PathBuf) -> Self {
        let text = fs::read_to_string(docs().join(&path));
        let text = text.unwrap_or_else(|reason| panic!("{}: {reason}", name(&path)));
        Self { path, text }
    }

    fn events(&self) -> Parser<'_> {
        Parser::new_ext(&self.text, Options::ENABLE_TABLES)
    }

    fn blocks(&self) -> Vec<Block> {
        let mut blocks: Vec<Block> = Vec::new();
        let (mut inside, mut follows) = (false, false);
        for event in self.events() {
            match event {
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                    let (language, code) = (language.to_string(), String::new());
                    blocks.push(Block {
                        language,
                        code,
                        follows,
                    });
                    inside = true;
                }
                Event::End(TagEnd::CodeBlock) => (inside, follows) = (false, true),
                Event::Text(text) if inside => blocks.last_mut().unwrap().code += &text,
                Event::Text(_) => follows = false,
                _ => {}
            }
        }
        blocks
    }

    /// The targets of its links and pictures.
    fn links(&self) -> Vec<String> {
        let links = self.events().filter_map(|event| match event {
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                Some(dest_url.to_string())
            }
            _ => None,
        });
        links.collect()
    }

    /// The names of its headings in addresses, as mdBook and GitHub make them.
    fn anchors(&self) -> BTreeSet<String> {
        let mut anchors = BTreeSet::new();
        let mut heading = None;
        for event in self.events() {
            match event {
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::Text(text) | Event::Code(text) => {
                    if let Some(heading) = &mut heading {
                        heading.push_str(&text);
                    }
                }
                Event::End(TagEnd::Heading(_)) => {
                    anchors.extend(heading.take().map(|text| anchor(&text)));
                }
                _ => {}
            }
        }
        anchors
    }
}

fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept
        .chars()
        .filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

fn name(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// A path without `..`; `None` if it leaves the folder in which it begins.
fn tidy(path: &Path) -> Option<PathBuf> {
    let mut tidy = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => tidy.pop().then_some(())?,
            part => tidy.push(part),
        }
    }
    Some(tidy)
}

/// The pages in the order of the book.
fn pages() -> Vec<Page> {
    let summary = Page::read("SUMMARY.md".into());
    let listed = summary.links().into_iter();
    listed.map(|link| Page::read(link.into())).collect()
}

/// The files below a folder of the book with this ending.
fn files(folder: &Path, ending: &str) -> BTreeSet<PathBuf> {
    let mut found = BTreeSet::new();
    for entry in fs::read_dir(docs().join(folder)).unwrap() {
        let entry = entry.unwrap();
        let path = folder.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|is| is == ending) {
            found.insert(path);
        }
    }
    found
}

fn is_written() -> bool {
    std::env::var_os("BOUNCELAB_BOOK").is_some_and(|word| word == "write")
}

/// Compares a file of the book with the output of the program, or writes it.
fn made(path: &Path, content: &[u8]) {
    let file = docs().join(path);
    if is_written() {
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(&file, content).unwrap();
    }
    let is_current = fs::read(&file).is_ok_and(|there| there == content);
    assert!(
        is_current,
        "{} is out of date: cargo xtask book",
        name(path)
    );
}

#[test]
fn every_page_is_in_the_summary() {
    let listed: BTreeSet<PathBuf> = pages().into_iter().map(|page| page.path).collect();
    let mut there = files(Path::new(""), "md");
    there.remove(Path::new("SUMMARY.md"));
    assert_eq!(listed, there);
}

/// Readers look for a symptom by the sentence that the program prints, so it is that of the diagnostic.
#[test]
fn symptoms_quote_the_diagnostics() {
    let symptoms = Page::read("how-to/symptoms.md".into()).text;
    let printed = Page::read("diagnostics.md".into()).text;
    let heading = symptoms
        .lines()
        .skip_while(|line| !line.starts_with("| what is printed |"));
    let quotes: Vec<&str> = heading
        .skip(2)
        .map_while(|line| line.strip_prefix("| ")?.split(" | ").next())
        .collect();
    assert!(!quotes.is_empty());
    for part in quotes.iter().flat_map(|quote| quote.split('…')) {
        assert!(printed.contains(part.trim()), "no diagnostic says {part:?}");
    }
}

#[test]
fn every_link_within_the_book_leads_somewhere() {
    let mut broken = Vec::new();
    for page in pages() {
        for link in page
            .links()
            .into_iter()
            .filter(|link| !link.contains("://"))
        {
            let (path, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target = match path {
                "" => Some(page.path.clone()),
                path => tidy(&page.path.with_file_name(path)),
            };
            let target = target.filter(|target| docs().join(target).is_file());
            let leads = target.is_some_and(|target| {
                anchor.is_empty() || Page::read(target).anchors().contains(anchor)
            });
            if !leads {
                broken.push(format!("{}: {link}", name(&page.path)));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

/// The documents outside of the book.
const OTHERS: [&str; 6] = [
    "../ARCHITECTURE.md",
    "../CHANGELOG.md",
    "../CONTRIBUTING.md",
    "../README.md",
    "../SECURITY.md",
    "../benchmarks/README.md",
];

#[test]
fn every_link_of_the_other_documents_leads_somewhere() {
    let mut broken = Vec::new();
    for page in OTHERS.map(|path| Page::read(path.into())) {
        let links = page.links().into_iter();
        for link in links.filter(|link| !link.contains("://")) {
            let (path, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let file = docs().join(&page.path).with_file_name(path);
            let leads =
                file.exists() && (anchor.is_empty() || Page::read(file).anchors().contains(anchor));
            if !leads {
                broken.push(format!("{}: {link}", name(&page.path)));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

/// A folder with the files that the pages assume, and the program on the path.
struct Scene(TempDir);

impl Scene {
    fn set() -> Self {
        let scene = Self(TempDir::new().unwrap());
        for folder in ["recordings", "sounds"] {
            fs::create_dir(scene.0.path().join(folder)).unwrap();
        }
        for (name, drop) in RECORDINGS {
            for number in 1..=3 {
                scene.run(&format!(
                    "bouncelab synth {name}{number}.wav {drop} --seed {number}"
                ));
            }
        }
        scene.run("bouncelab synth drop.wav --height 30.5cm --seed 4");
        scene.run(
            "bouncelab synth low.wav --ball tennis --voice tennis --height 3cm --restitution 0.75",
        );
        scene.export();
        for (name, file) in damage::files() {
            for (_, copy) in ENCODED.iter().filter(|(of, _)| *of == name) {
                fs::write(scene.0.path().join(copy), &file).unwrap();
            }
        }
        scene
    }

    /// Writes drops as `PicoScope` exports them, as Graphical Analysis of Vernier does where numbers have decimal
    /// commas, and as phyphox does, half a second from a low height.
    fn export(&self) {
        let rows = |name: &str, row: &dyn Fn(usize, f64, f32) -> Option<String>| {
            let mut source = SoundReader::open(self.0.path().join(name)).unwrap();
            let step_s = 1.0 / f64::from(source.sample_rate_hz());
            let mut samples = Vec::new();
            while let Some(block) = source.next_block().unwrap() {
                samples.extend_from_slice(block.channel(0));
            }
            let numbered = samples.into_iter().enumerate();
            let rows = numbered.filter_map(|(n, sample)| row(n, n as f64 * step_s, sample));
            rows.collect::<String>()
        };
        let scope = rows("drop1.wav", &|_, time_s, sample| {
            Some(format!("{:.8},{:.8}\n", 1e3 * time_s, 2.0 * sample))
        });
        let scope = ["Time,Channel A\n(ms),(V)\n\n", &scope].concat();
        fs::write(self.0.path().join("picoscope.csv"), scope).unwrap();
        // A quarter of the samples, as slow as such a logger.
        let logger = rows("floor1.wav", &|n, time_s, sample| {
            let row = format!("{time_s:.6};{:.5}\n", 2.0 * sample);
            (n % 4 == 0).then(|| row.replace('.', ","))
        });
        let logger = ["Latest: Time (s);Latest: Potential (V)\n", &logger].concat();
        fs::write(self.0.path().join("vernier.csv"), logger).unwrap();
        let phone = rows("low.wav", &|_, time_s, sample| {
            let time_ms = 1e3 * (time_s - 0.53);
            let row = format!("{time_ms:.9E},{sample:.9E}\n");
            (0.0..=500.0).contains(&time_ms).then_some(row)
        });
        let phone = ["\"Time (ms)\",\"Recording (a.u.)\"\n", &phone].concat();
        fs::write(self.0.path().join("phyphox.csv"), phone).unwrap();
    }

    /// Runs a command and returns its output, whatever a verdict says.
    fn run(&self, command: &str) -> String {
        let program = Path::new(env!("CARGO_BIN_EXE_bouncelab")).parent().unwrap();
        let paths = std::env::var_os("PATH").unwrap_or_default();
        let paths = std::iter::once(program.to_owned()).chain(std::env::split_paths(&paths));
        let mut shell = Command::new("sh");
        shell
            .args(["-c", command])
            .current_dir(&self.0)
            .env("LC_ALL", "C.UTF-8");
        shell.env("PATH", std::env::join_paths(paths).unwrap());
        let Output {
            status,
            stdout,
            stderr,
        } = shell.output().unwrap();
        let verdicts: &[i32] = if ["verdict", "job show"]
            .iter()
            .any(|judges| command.contains(judges))
        {
            &[0, 3, 4, 5]
        } else {
            &[0]
        };
        let errors = String::from_utf8_lossy(&stderr);
        assert!(
            verdicts.contains(&status.code().unwrap()),
            "{command}: {errors}"
        );
        String::from_utf8(stdout).unwrap()
    }

    /// Runs the commands of a page in their order. A text right after them is a part of their output, a block of TOML is
    /// the file that its first line names, or else `own.toml`, and a picture that they draw is that of the book.
    fn follow(&self, page: &Page) {
        let mut printed = String::new();
        for block in page.blocks() {
            match block.language.as_str() {
                "toml" => {
                    let first = block.code.lines().next().unwrap_or_default();
                    let name = first.strip_prefix("# ").unwrap_or("own.toml");
                    fs::write(self.0.path().join(name), &block.code).unwrap();
                }
                "sh" => {
                    printed = commands(&block.code)
                        .map(|command| self.run(&command))
                        .collect();
                }
                "text" if block.follows => has_lines(&printed, &block.code, &page.path),
                _ => {}
            }
        }
        for link in page.links() {
            let drawn = tidy(&page.path.with_file_name(&link));
            if let Some((path, Ok(content))) =
                drawn.map(|path| (path.clone(), fs::read(self.0.path().join(path))))
            {
                made(&path, &content);
            }
        }
    }
}

/// The commands of a block.
fn lines(code: &str) -> Vec<String> {
    let code = code.replace("\\\n", " ");
    let lines = code.lines().filter(|line| !line.trim().is_empty());
    lines.map(str::to_owned).collect()
}

/// The index in `ELSEWHERE` of a command that does not run here.
fn elsewhere(command: &str) -> Option<usize> {
    ELSEWHERE
        .iter()
        .position(|(start, _)| command.starts_with(start))
}

/// Whether a command is of this program, makes files for it or shows one.
fn is_ours(command: &str) -> bool {
    let programs = ["bouncelab ", "printf ", "head ", "mkdir ", "cp ", "for "];
    programs.iter().any(|program| command.starts_with(program))
}

/// The commands of a block that run here.
fn commands(code: &str) -> impl Iterator<Item = String> {
    let lines = lines(code).into_iter();
    lines.filter(|line| is_ours(line) && elsewhere(line).is_none())
}

/// Every line of an excerpt is printed, in this order.
fn has_lines(printed: &str, excerpt: &str, page: &Path) {
    let mut lines = printed.lines().map(str::trim_end);
    for line in excerpt.lines().filter(|line| !line.trim().is_empty()) {
        assert!(
            lines.any(|printed| printed == line),
            "{}: \"{line}\" is not printed:\n{printed}",
            name(page)
        );
    }
}

#[test]
fn the_tutorial_quotes_the_output() {
    let scene = Scene::set();
    scene.follow(&Page::read("tutorial.md".into()));
}

#[test]
fn the_commands_of_all_other_pages_run() {
    for page in pages() {
        let has_commands = page
            .blocks()
            .iter()
            .any(|block| commands(&block.code).next().is_some());
        if has_commands && page.path != Path::new("tutorial.md") {
            Scene::set().follow(&page);
        }
    }
}

#[test]
fn the_commands_of_the_readme_run() {
    let scene = Scene::set();
    for block in readme().blocks().iter().filter(|it| it.language == "sh") {
        commands(&block.code).for_each(|command| drop(scene.run(&command)));
    }
}

#[test]
fn the_readme_counts_the_built_in_rules() {
    let scene = Scene(TempDir::new().unwrap());
    let list = scene.run("bouncelab rules list");
    // Below the heading and a line.
    let count = list.lines().count() - 2;
    let words = format!("by {count} rules of sports");
    assert!(readme().text.contains(&words), "README.md: {words}");
}

#[test]
fn the_readme_quotes_the_output_for_a_real_recording() {
    let Some(folder) = std::env::var_os("BOUNCELAB_RECORDINGS") else {
        println!("SKIPPED: BOUNCELAB_RECORDINGS names no folder of real recordings");
        return;
    };
    let recording = Path::new(&folder).join("pingpong-long.wav");
    let scene = Scene(TempDir::new().unwrap());
    fs::copy(recording, scene.0.path().join("drop.wav")).unwrap();
    let page = readme();
    let blocks = page.blocks();
    let excerpt = blocks.iter().find(|block| block.language == "text");
    let printed = scene.run("bouncelab analyze drop.wav --ball table-tennis-40");
    has_lines(&printed, &excerpt.unwrap().code, &page.path);
}

fn readme() -> Page {
    Page::read("../README.md".into())
}

#[test]
fn every_command_runs_here_or_is_listed_as_run_elsewhere() {
    let mut used = BTreeSet::new();
    for page in pages().into_iter().chain([readme()]) {
        let blocks = page.blocks().into_iter();
        for command in blocks
            .filter(|block| block.language == "sh")
            .flat_map(|block| lines(&block.code))
        {
            let found = elsewhere(&command);
            used.extend(found);
            let is_known = found.is_some() || is_ours(&command);
            assert!(is_known, "{}: nothing runs \"{command}\"", name(&page.path));
            if let Some(rest) = command.strip_prefix("cargo xtask ") {
                let task = rest.split(' ').next().unwrap_or_default();
                assert!(is_task(task), "there is no task {task}: {command}");
            }
        }
    }
    for (index, (start, reason)) in ELSEWHERE.iter().enumerate() {
        assert!(used.contains(&index), "no page has a command \"{start}\"");
        match reason {
            Check(check) => assert!(is_named("test", check), "there is no check {check}"),
            Never(reason) => assert!(!reason.is_empty(), "{start}"),
        }
    }
}

#[test]
fn commands_and_options_within_sentences_exist() {
    let reference = Page::read("reference/commands.md".into()).text;
    let sections: Vec<&str> = reference.split("\n## `").skip(1).collect();
    // Options on pages of a cluster are those of its job.
    let job = "../crates/bouncelab-python/python/bouncelab/spark_job.py";
    let all = reference.clone() + &fs::read_to_string(docs().join(job)).unwrap();
    for page in pages().into_iter().chain([readme()]) {
        let codes = page.events().filter_map(|event| match event {
            Event::Code(code) => Some(code),
            _ => None,
        });
        for code in codes {
            let words: Vec<&str> = code.split_whitespace().collect();
            let wrong = format!("{}: \"{code}\"", name(&page.path));
            let help = match words.as_slice() {
                ["cargo", "xtask", task, ..] => {
                    assert!(is_task(task), "{wrong}");
                    continue;
                }
                ["bouncelab", "help" | "COMMAND", ..] | ["bouncelab"] | [] => continue,
                ["bouncelab", ..] => {
                    let of = |count: usize| {
                        let heading = words.get(..count)?.join(" ") + "`\n";
                        sections.iter().find(|it| it.starts_with(&heading))
                    };
                    of(3).or_else(|| of(2)).unwrap_or_else(|| panic!("{wrong}"))
                }
                [first, ..] if first.starts_with("--") => all.as_str(),
                _ => continue,
            };
            let is_of_option = |c: char| c.is_alphanumeric() || c == '-';
            for word in words.iter().filter(|word| word.starts_with("--")) {
                let option = word.split(|c| !is_of_option(c)).next().unwrap();
                let mut known = help.split(|c| !is_of_option(c));
                assert!(known.any(|it| it == option), "{wrong}: {option}");
            }
        }
    }
}

/// Whether `cargo xtask` has a task or a measuring program of this name.
fn is_task(name: &str) -> bool {
    ["main", "measure"]
        .iter()
        .any(|module| is_named(module, name))
}

/// Whether a module of the tasks has an entry of this name in its table.
fn is_named(module: &str, name: &str) -> bool {
    let file = format!("../../xtask/src/{module}.rs");
    let code = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
    code.contains(&format!("name: \"{name}\","))
}

/// The reference has all commands, so it is compared where all are built in.
#[cfg(feature = "serve")]
#[test]
fn the_reference_is_the_help_of_the_program() {
    let mut page = "# Commands\n\nWhat `bouncelab COMMAND --help all` prints.\n".to_owned();
    describe(&[], &mut page);
    made(Path::new("reference/commands.md"), page.as_bytes());
}

/// Adds the help of a command, then those of its own commands.
#[cfg(feature = "serve")]
fn describe(words: &[&str], page: &mut String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_bouncelab"));
    command
        .args(words)
        .args(["--help", "all"])
        .env_remove("COLUMNS");
    let help = String::from_utf8(command.output().unwrap().stdout).unwrap();
    let lines = help
        .lines()
        .map(str::trim_end)
        .collect::<Vec<_>>()
        .join("\n");
    let title = [&["bouncelab"], words].concat().join(" ");
    *page += &["\n## `", &title, "`\n\n```text\n", &lines, "\n```\n"].concat();
    let (_, list) = help.split_once("\nCommands:\n").unwrap_or_default();
    let (list, _) = list.split_once("\n\n").unwrap_or((list, ""));
    // The rest of a long description is indented further.
    let own = list
        .lines()
        .filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    for name in own.filter(|name| !name.is_empty() && *name != "help") {
        describe(&[words, &[name]].concat(), page);
    }
}
