//! `cargo xtask release` and the check `release`: all that is published of a version and can be made on this
//! machine.
//!
//! The check makes the same of what the other checks compiled, without optimisation, installs each in an empty folder
//! and runs the demo from there.

use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::cargo::{built, cargo, copy_program, root, run as run_command, succeeds, target};
use crate::tools::{CARGO_DEB, MDBOOK};
use crate::{Result, book, python, said, web};

pub(crate) const ABOUT: &str =
    "Make all that a release publishes and this machine can make, into target/release-artefacts";

/// All crates and packages have the same one.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What other programs read by a schema, with its name.
const BY_SCHEMA: [(&str, &str); 5] = [
    ("vendor.citation-file-format", "CITATION.cff"),
    ("vendor.dependabot", ".github/dependabot.yml"),
    (
        "vendor.github-issue-config",
        ".github/ISSUE_TEMPLATE/config.yml",
    ),
    (
        "vendor.github-issue-forms",
        ".github/ISSUE_TEMPLATE/fault.yml",
    ),
    (
        "vendor.github-issue-forms",
        ".github/ISSUE_TEMPLATE/recording.yml",
    ),
];

/// What lies beside the program in its archive.
const DOCUMENTS: [&str; 4] = ["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"];

/// The completions, by the shell and the names that the shells look for.
const COMPLETIONS: [(&str, &str); 3] = [
    ("bash", "bouncelab.bash"),
    ("zsh", "_bouncelab"),
    ("fish", "bouncelab.fish"),
];

/// The chore: for this machine, or `target=TRIPLE`, of which there is the program only.
pub(crate) fn run(words: &[String]) -> Result {
    let folder = target().join("release-artefacts");
    emptied(&folder)?;
    match words {
        [] => {
            let page = make_page()?;
            let mut build = cargo(["build", "--release", "--bin", "bouncelab"]);
            build.args(features(page, &host()?));
            run_command(&mut build)?;
            install_tools()?;
            make_all(&folder, "release")?;
        }
        [word] => {
            let triple = word.strip_prefix("target=").ok_or(USAGE)?;
            // The page is the same for all, so that machines need not build it that cannot.
            if !has_page() {
                return Err(
                    "the page is not built, which is a part of the program".to_owned()
                        + ": cargo xtask web",
                );
            }
            let mut build = cargo(["build", "--release", "--bin", "bouncelab", "--target"]);
            run_command(build.arg(triple).args(features(true, triple)))?;
            let built = target().join(triple).join("release");
            program(&folder, &built, triple)?;
        }
        _ => return Err(USAGE.into()),
    }
    checksums(&folder)?;
    println!("made in {}", folder.display());
    Ok(())
}

const USAGE: &str = "it takes at most one word, target=TRIPLE";

/// What makes the Debian package and the book; the check does without where they are missing.
fn install_tools() -> Result {
    MDBOOK.find_or_install()?;
    if cfg!(target_os = "linux") {
        CARGO_DEB.find_or_install()?;
    }
    Ok(())
}

/// The page is a part of the program where it can be built.
fn make_page() -> Result<bool> {
    if web::has_node() {
        web::build()?;
        return Ok(true);
    }
    println!("SKIPPED for want of Node.js: the page, and `bouncelab serve`");
    Ok(false)
}

fn has_page() -> bool {
    web::web().join("dist/index.html").is_file()
}

/// The microphone needs a library of the system on Linux only, which not every machine has.
fn features(page: bool, triple: &str) -> Vec<&'static str> {
    let mut features = Vec::new();
    if page {
        features.extend(["--features", "bouncelab-cli/serve"]);
    }
    if !triple.contains("linux") {
        features.extend(["--features", "bouncelab-cli/microphone"]);
    }
    features
}

/// Everything of a profile whose program was built.
fn make_all(folder: &Path, profile: &str) -> Result {
    let host = host()?;
    let built = target().join(if profile == "dev" { "debug" } else { profile });
    let contents = program(folder, &built, &host)?;
    debian(folder, &contents)?;
    if python::interpreters().is_empty() {
        println!("SKIPPED: the wheel; {}", python::MISSING);
    } else {
        let wheel = match profile {
            "dev" => python::checked_wheel()?,
            _ => python::released_wheel()?,
        };
        copy(&wheel, &folder.join(wheel.file_name().unwrap_or_default()))?;
    }
    if has_page() {
        let name = format!("bouncelab-page-{VERSION}");
        archive(folder, &name, &web::web(), "dist")?;
    } else {
        println!("SKIPPED: the page, which was not built");
    }
    if let Some(mdbook) = MDBOOK.find() {
        book::build(&mdbook)?;
        let name = format!("bouncelab-book-{VERSION}");
        archive(folder, &name, &target(), "book")?;
    } else {
        println!("SKIPPED for want of mdBook: the book");
    }
    let notes = notes(&read(&root().join("CHANGELOG.md"))?)?;
    write(&folder.join("release-notes.md"), &notes)
}

/// What the archive of the program and the folder in it are called; `cargo binstall` is told so in the `Cargo.toml` of the
/// program.
fn name_of(triple: &str) -> String {
    format!("bouncelab-{VERSION}-{triple}")
}

/// The archive of the program with its completions, manual pages and documents; returns the folder of its contents.
fn program(folder: &Path, built: &Path, triple: &str) -> Result<PathBuf> {
    let name = name_of(triple);
    let staged = target().join("release-staged");
    let contents = staged.join(&name);
    emptied(&contents)?;
    let program = copy_program(built, &contents)?;
    for document in DOCUMENTS {
        copy(&root().join(document), &contents.join(document))?;
    }
    let mut manual = Command::new(&program);
    manual.arg("manual").arg(contents.join("man"));
    run_command(&mut manual)?;
    emptied(&contents.join("completions"))?;
    for (shell, file) in COMPLETIONS {
        let script = Command::new(&program).args(["completions", shell]).output();
        let script = script.map_err(|reason| reason.to_string())?.stdout;
        let path = contents.join("completions").join(file);
        write(&path, &String::from_utf8_lossy(&script))?;
    }
    archive(folder, &name, &staged, &name)?;
    Ok(contents)
}

/// The package for Debian and its kin, by cargo-deb, whose list of files is in the `Cargo.toml` of the program.
fn debian(folder: &Path, contents: &Path) -> Result {
    let Some(cargo_deb) = CARGO_DEB.find().filter(|_| cfg!(target_os = "linux")) else {
        println!("SKIPPED for want of cargo-deb (cargo install cargo-deb): the Debian package");
        return Ok(());
    };
    // The list names one place, whatever is built.
    let listed = root().join("target/debian-package");
    emptied(&listed)?;
    fs::rename(contents, &listed).map_err(|reason| said(&listed, &reason))?;
    let mut package = Command::new(cargo_deb);
    package.args(["deb", "--package", "bouncelab-cli", "--no-build"]);
    package.args(["--no-strip", "--output"]).arg(folder);
    run_command(package.current_dir(root()))
}

/// Packs a folder that lies in another.
fn archive(folder: &Path, name: &str, parent: &Path, contents: &str) -> Result {
    let mut tar = Command::new("tar");
    tar.arg("-czf").arg(folder.join(format!("{name}.tar.gz")));
    run_command(tar.arg("-C").arg(parent).arg(contents))
}

/// `SHA256SUMS`, as `sha256sum --check` reads it.
fn checksums(folder: &Path) -> Result {
    let mut names: Vec<String> = files(folder)?
        .iter()
        .filter_map(|path| Some(path.file_name()?.to_str()?.to_owned()))
        .collect();
    names.sort();
    let sums = sha256(folder).args(names).output();
    let sums = sums.map_err(|reason| reason.to_string())?;
    if !sums.status.success() {
        return Err(String::from_utf8_lossy(&sums.stderr).into_owned());
    }
    write(
        &folder.join("SHA256SUMS"),
        &String::from_utf8_lossy(&sums.stdout),
    )
}

/// The program of GNU or that of Perl, which macOS has.
fn sha256(folder: &Path) -> Command {
    let mut sha256 = if succeeds(&["sha256sum", "--version"]) {
        Command::new("sha256sum")
    } else {
        let mut perl = Command::new("shasum");
        perl.args(["-a", "256"]);
        perl
    };
    sha256.current_dir(folder);
    sha256
}

/// The section of the change log of this version, or that of what is not released yet.
fn notes(changes: &str) -> Result<String> {
    let sections = || changes.split("\n## ").skip(1);
    let of = |heading: String| sections().find(|section| section.starts_with(&heading));
    let section = of(format!("[{VERSION}]")).or_else(|| of("[Unreleased]".to_owned()));
    let section = section.ok_or("CHANGELOG.md has no section of this version")?;
    let (_, text) = section.split_once('\n').unwrap_or((section, ""));
    Ok(text.trim().to_owned() + "\n")
}

/// The check.
pub(crate) fn check() -> Result {
    if web::has_node() {
        web::check_workflows()?;
    } else {
        println!("SKIPPED for want of Node.js: the check of the workflow files");
    }
    if python::interpreters().is_empty() {
        println!(
            "SKIPPED: how to cite and the issue forms; {}",
            python::MISSING
        );
    } else {
        python::validate(&BY_SCHEMA)?;
    }
    built("--bin", "bouncelab")?;
    let folder = target().join("release-check/artefacts");
    emptied(&folder)?;
    make_all(&folder, "dev")?;
    checksums(&folder)?;
    verify(&folder)?;
    let installed = target().join("release-check/installed");
    emptied(&installed)?;
    for path in files(&folder)? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let place = installed.join(&*name);
        emptied(&place)?;
        if name.ends_with(".whl") {
            python::install_into(&place, &path)?;
            demo(&place.join("bin"))?;
        } else if name.ends_with(".deb") {
            run_command(Command::new("dpkg-deb").arg("-x").arg(&path).arg(&place))?;
            demo(&place.join("usr/bin"))?;
            has_help(&place.join("usr/share"), &HELP_IN_DEBIAN)?;
        } else if name.starts_with("bouncelab-page") {
            unpack(&path, &place)?;
            read(&place.join("dist/index.html"))?;
        } else if name.starts_with("bouncelab-book") {
            unpack(&path, &place)?;
            read(&place.join("book/tutorial.html"))?;
        } else if name.ends_with(".tar.gz") {
            unpack(&path, &place)?;
            let program = place.join(name.trim_end_matches(".tar.gz"));
            demo(&program)?;
            has_help(&program, &HELP_IN_ARCHIVE)?;
        }
    }
    Ok(())
}

/// Whether what was published is all listed in `SHA256SUMS`, and is what is listed there.
fn verify(folder: &Path) -> Result {
    let listed = read(&folder.join("SHA256SUMS"))?.lines().count();
    let there = files(folder)?.len() - 1;
    if listed != there {
        return Err(format!("SHA256SUMS lists {listed} of {there} files"));
    }
    run_command(sha256(folder).args(["--check", "SHA256SUMS"]))
}

/// Where a shell and `man` find the option of a command: one manual page stands for all.
const HELP_IN_ARCHIVE: [&str; 4] = [
    "man/bouncelab-analyze.1",
    "completions/bouncelab.bash",
    "completions/_bouncelab",
    "completions/bouncelab.fish",
];

/// The same in the folder `usr/share` of the Debian package, whose manual pages are compressed.
const HELP_IN_DEBIAN: [&str; 4] = [
    "man/man1/bouncelab-analyze.1.gz",
    "bash-completion/completions/bouncelab",
    "zsh/vendor-completions/_bouncelab",
    "fish/vendor_completions.d/bouncelab.fish",
];

/// Whether completions and manual are there, and know the option `--cues`.
fn has_help(folder: &Path, names: &[&str]) -> Result {
    for name in names {
        let path = folder.join(name);
        let text = if path.extension().is_some_and(|ending| ending == "gz") {
            let unpacked = Command::new("gzip").arg("-dc").arg(&path).output();
            let unpacked = unpacked.map_err(|reason| said(&path, &reason))?;
            String::from_utf8_lossy(&unpacked.stdout).into_owned()
        } else {
            read(&path)?
        };
        if !text.contains("cues") {
            return Err(format!("{}: no word of --cues", path.display()));
        }
    }
    Ok(())
}

fn unpack(path: &Path, place: &Path) -> Result {
    run_command(
        Command::new("tar")
            .arg("-xzf")
            .arg(path)
            .arg("-C")
            .arg(place),
    )
}

/// Runs the demo of a program from its own folder, with an empty home.
fn demo(folder: &Path) -> Result {
    let mut demo = Command::new(folder.join(format!("bouncelab{EXE_SUFFIX}")));
    demo.arg("demo").current_dir(folder).env("HOME", folder);
    run_command(&mut demo)?;
    read(&folder.join("bouncelab-demo/demo-waveform.svg")).map(drop)
}

/// What this machine compiles for.
fn host() -> Result<String> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let about = Command::new(rustc).arg("-vV").output();
    let about = about.map_err(|reason| reason.to_string())?.stdout;
    let about = String::from_utf8_lossy(&about);
    let host = about.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned)
        .ok_or_else(|| "rustc names no host".to_owned())
}

/// Makes a folder, without what an earlier run left.
fn emptied(folder: &Path) -> Result {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|reason| said(folder, &reason))?;
    }
    fs::create_dir_all(folder).map_err(|reason| said(folder, &reason))
}

fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).map_err(|reason| said(folder, &reason))?;
    Ok(entries.flatten().map(|entry| entry.path()).collect())
}

fn copy(from: &Path, to: &Path) -> Result {
    fs::copy(from, to)
        .map(drop)
        .map_err(|reason| said(from, &reason))
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).map_err(|reason| said(path, &reason))
}

fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|reason| said(path, &reason))
}

#[cfg(test)]
mod tests {
    use super::{VERSION, features, name_of, notes, read, root};

    /// `cargo binstall` fills in these names.
    #[test]
    fn binstall_looks_for_the_archives_where_they_are_published() {
        let manifest = read(&root().join("crates/bouncelab-cli/Cargo.toml")).unwrap();
        let filled = |key: &str, triple: &str, ending: &str| {
            let value = manifest
                .lines()
                .find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "));
            let value = value.unwrap().trim_matches('"');
            [
                ("{ repo }", "REPO"),
                ("{ version }", VERSION),
                ("{ target }", triple),
                ("{ bin }", "bouncelab"),
                ("{ binary-ext }", ending),
            ]
            .iter()
            .fold(value.to_owned(), |text, (field, word)| {
                text.replace(field, word)
            })
        };
        for (triple, ending) in [
            ("x86_64-unknown-linux-musl", ""),
            ("x86_64-pc-windows-msvc", ".exe"),
        ] {
            let name = name_of(triple);
            assert_eq!(
                filled("pkg-url", triple, ending),
                format!("REPO/releases/download/v{VERSION}/{name}.tar.gz")
            );
            assert_eq!(
                filled("bin-dir", triple, ending),
                format!("{name}/bouncelab{ending}")
            );
        }
        // The tag that `cargo release` makes, and that starts the workflow.
        let release = read(&root().join("release.toml")).unwrap();
        assert!(release.contains("tag-name = \"v{{version}}\""));
        let workflow = read(&root().join(".github/workflows/release.yml")).unwrap();
        assert!(workflow.contains("tags: [\"v*\"]"));
    }

    #[test]
    fn what_is_published_has_the_page_and_the_microphone_where_it_takes_no_headers() {
        let serve = "bouncelab-cli/serve";
        let microphone = "bouncelab-cli/microphone";
        let has = |triple, feature: &&str| features(true, triple).contains(feature);
        for triple in ["aarch64-apple-darwin", "x86_64-pc-windows-msvc"] {
            assert!(has(triple, &serve) && has(triple, &microphone));
        }
        let triple = "x86_64-unknown-linux-musl";
        assert!(has(triple, &serve) && !has(triple, &microphone));
        assert!(!features(false, triple).contains(&serve));
    }

    /// `cargo release` writes them all; this finds what was written by hand.
    #[test]
    fn every_file_states_the_same_version() {
        for (file, line, count) in [
            ("CITATION.cff", format!("\nversion: {VERSION}\n"), 1),
            (
                "Cargo.toml",
                format!("{{ version = \"{VERSION}\", path = "),
                4,
            ),
            ("web/package.json", format!("\"version\": \"{VERSION}\""), 1),
            (
                "web/package-lock.json",
                format!("\"name\": \"bouncelab-web\",\n  \"version\": \"{VERSION}\""),
                1,
            ),
            (
                "fuzz/Cargo.lock",
                format!("name = \"bouncelab\"\nversion = \"{VERSION}\""),
                1,
            ),
        ] {
            let text = read(&root().join(file)).unwrap();
            assert_eq!(text.matches(&line).count(), count, "{file}: {line}");
        }
    }

    #[test]
    fn the_notes_are_the_section_of_the_version_or_of_what_comes() {
        let coming = "# Changelog\n\n## [Unreleased]\n\n### Added\n\n- this\n\n## [0.0.1] - 2020-01-01\n\n- that\n";
        assert_eq!(notes(coming).unwrap(), "### Added\n\n- this\n");
        let released = coming.replace("[0.0.1]", &format!("[{VERSION}]"));
        assert_eq!(notes(&released).unwrap(), "- that\n");
        assert!(notes("# Changelog\n").is_err());
    }
}
