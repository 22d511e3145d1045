//! `cargo xtask release` and the check `release`: all that is published of a version and can be made on this
//! machine.
//!
//! The check makes the same of what the other checks compiled, without optimisation, installs each in an empty folder
//! and runs the demo from there.

use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;

use crate::cargo::{
    MICROPHONE, built, cargo, copy_program, emptied, ensure_sound_headers, install, root,
    run as run_command, succeeds, target,
};
use crate::steps::skip;
use crate::{Result, book, file_error, notices, python, web};

pub(crate) const ABOUT: &str =
    "Make all that a release publishes and this machine can make, into target/release-artefacts";

/// All crates and packages have the same one.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What other programs read by a schema, with its name, besides the workflow files.
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

/// The time of all that is packed, in seconds of Unix, so that packing twice makes the same bytes: that which
/// [`tar::HeaderMode::Deterministic`] writes.
pub(crate) const EPOCH: &str = "1153704088";

/// The completions, by the shell and the names that the shells look for.
const COMPLETIONS: [(&str, &str); 4] = [
    ("bash", "bouncelab.bash"),
    ("zsh", "_bouncelab"),
    ("fish", "bouncelab.fish"),
    ("powershell", "_bouncelab.ps1"),
];

/// Where the Debian package has what is in the archive; the manual pages besides.
const IN_DEBIAN: [(&str, &str); 7] = [
    ("bouncelab", "bin/bouncelab"),
    (
        "completions/bouncelab.bash",
        "share/bash-completion/completions/bouncelab",
    ),
    (
        "completions/_bouncelab",
        "share/zsh/vendor-completions/_bouncelab",
    ),
    (
        "completions/bouncelab.fish",
        "share/fish/vendor_completions.d/bouncelab.fish",
    ),
    ("README.md", "share/doc/bouncelab/README.md"),
    (notices::NAME, "share/doc/bouncelab/LICENSE-THIRD-PARTY.txt"),
    ("CHANGELOG.md", "share/doc/bouncelab/changelog"),
];

const DESCRIPTION: &str = "\
Description: physics of a bouncing ball from its sound
 Estimates the coefficient of restitution, the drop height and the air drag of a
 bouncing ball from a sound recording or from the microphone, each with its
 uncertainty; also many drops, rules of sports, and simulations.
";

/// The task: everything, for this machine; `documents`, which are the same for all machines; or `target=TRIPLE`, the
/// program for one kind of machine. Only where everything is, a list of checksums makes sense.
pub(crate) fn run(words: &[String]) -> Result {
    let folder = target().join("release-artefacts");
    emptied(&folder)?;
    match words {
        [] => {
            make_page()?;
            let triple = published()?;
            program(&folder, &compile(&triple)?, &triple)?;
            wheel(&folder, python::released_wheel)?;
            documents(&folder)?;
            checksums(&folder)?;
        }
        [word] if word == "documents" => {
            web::build()?;
            documents(&folder)?;
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
            program(&folder, &compile(triple)?, triple)?;
        }
        _ => return Err(USAGE.into()),
    }
    println!("made in {}", folder.display());
    Ok(())
}

const USAGE: &str = "it takes at most one word, `documents` or target=TRIPLE";

/// The page is a part of the program where it can be built.
fn make_page() -> Result {
    if web::has_node() {
        return web::build();
    }
    skip("the page, without which `bouncelab serve` has nothing to serve: Node.js is missing");
    Ok(())
}

fn has_page() -> bool {
    web::web().join("dist/index.html").is_file()
}

/// The microphone needs a library of the system on Linux only, which not every machine has.
fn features(triple: &str) -> &'static [&'static str] {
    if triple.contains("linux") {
        &[]
    } else {
        &MICROPHONE
    }
}

/// The task `install`: the program with all that this machine can build into it.
pub(crate) fn install_program(words: &[String]) -> Result {
    make_page()?;
    let mut install = cargo(["install", "--locked", "--path", "crates/bouncelab-cli"]);
    if ensure_sound_headers() {
        install.args(MICROPHONE);
    } else {
        skip("the microphone, and with it `bouncelab listen`: the headers of ALSA are missing");
    }
    run_command(install.args(words))
}

pub(crate) const ABOUT_INSTALL: &str = "Install the program from the sources, with the page and the microphone where this machine can build them";

/// What this machine makes programs for: on Linux they are static, if the compiler can do that.
fn published() -> Result<String> {
    let host = host()?;
    let without_libraries = host.replace("-linux-gnu", "-linux-musl");
    let is_possible = without_libraries != host && web::has_target(&without_libraries);
    Ok(if is_possible { without_libraries } else { host })
}

/// Compiles the program; the folder in which it is then.
fn compile(triple: &str) -> Result<PathBuf> {
    let mut build = cargo(["build", "--release", "--bin", "bouncelab", "--target"]);
    run_command(build.arg(triple).args(features(triple)))?;
    Ok(target().join(triple).join("release"))
}

/// The wheel that this makes.
fn wheel(folder: &Path, make: fn() -> Result<PathBuf>) -> Result {
    if python::interpreters().is_empty() {
        skip(&format!("the wheel: {}", python::MISSING));
        return Ok(());
    }
    copy_into(folder, &make()?)
}

/// The page, its package, the sources of the Python package, the book, the bill of materials, and the text of the release.
fn documents(folder: &Path) -> Result {
    if has_page() {
        notices::write(&web::web().join("dist"))?;
        let name = format!("bouncelab-page-{VERSION}");
        archive(folder, &name, &web::web(), "dist")?;
        copy_into(folder, &web::package()?)?;
    } else {
        skip("the page, which was not built");
    }
    if python::interpreters().is_empty() {
        skip(&format!("the sources for PyPI: {}", python::MISSING));
    } else {
        copy_into(folder, &python::sources()?)?;
    }
    if python::program("mdbook").is_some() {
        book::build()?;
        let name = format!("bouncelab-book-{VERSION}");
        archive(folder, &name, &target(), "book")?;
    } else {
        skip("the book: mdBook is missing");
    }
    notices::write_materials(
        &folder.join(format!("bouncelab-{VERSION}.cdx.json")),
        VERSION,
    )?;
    let notes = notes(&read(&root().join("CHANGELOG.md"))?)?;
    write(&folder.join("release-notes.md"), &notes)
}

/// What the archive of the program and the folder in it are called; `cargo binstall` reads it in the `Cargo.toml` of the
/// program.
fn name_of(triple: &str) -> String {
    format!("bouncelab-{VERSION}-{triple}")
}

/// The archive of the program with its completions, manual pages and documents, and for Linux the Debian package of them.
fn program(folder: &Path, built: &Path, triple: &str) -> Result {
    let name = name_of(triple);
    let staged = target().join("release-staged");
    let contents = staged.join(&name);
    emptied(&contents)?;
    let program = copy_program(built, &contents)?;
    for document in DOCUMENTS {
        copy(&root().join(document), &contents.join(document))?;
    }
    notices::write(&contents)?;
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
    match triple.split_once("-unknown-linux-") {
        Some(("x86_64", library)) => debian(folder, &contents, "amd64", library),
        Some(("aarch64", library)) => debian(folder, &contents, "arm64", library),
        _ => Ok(()),
    }
}

/// The package for Debian and its kin.
fn debian(folder: &Path, contents: &Path, architecture: &str, library: &str) -> Result {
    if !succeeds(&["dpkg-deb", "--version"]) {
        skip("the Debian package: dpkg-deb is missing");
        return Ok(());
    }
    let tree = target().join("release-staged/debian");
    let control = tree.join("DEBIAN/control");
    emptied(&tree)?;
    emptied(&tree.join("DEBIAN"))?;
    let put = |file: &str, to: &str| {
        let mut install = Command::new("install");
        install.args(["-D", "--mode"]);
        install.arg(if file == "bouncelab" { "755" } else { "644" });
        install.arg(contents.join(file));
        run_command(install.arg(tree.join("usr").join(to)))
    };
    for (file, to) in IN_DEBIAN {
        put(file, to)?;
    }
    for page in files(&contents.join("man"))? {
        let name = page.file_name().unwrap_or_default().to_string_lossy();
        put(&format!("man/{name}"), &format!("share/man/man1/{name}"))?;
    }
    let documents = tree.join("usr/share/doc/bouncelab");
    let mut gzip = Command::new("gzip");
    gzip.arg("-9n").arg(documents.join("changelog"));
    run_command(gzip.args(files(&tree.join("usr/share/man/man1"))?))?;
    let terms = read(&contents.join("LICENSE-MIT"))?;
    let choice = "MIT, as below, or Apache-2.0 (/usr/share/common-licenses/Apache-2.0).\n\n";
    write(&documents.join("copyright"), &[choice, &terms].concat())?;
    let depends = match library {
        "musl" => String::new(),
        _ => libraries(&tree.join("usr/bin/bouncelab"))?,
    };
    // A version that precedes another sorts before it there with this sign.
    let version = VERSION.replace('-', "~");
    let fields = format!(
        "Package: bouncelab\nVersion: {version}\nArchitecture: {architecture}\n{depends}Section: science\n\
         Priority: optional\nMaintainer: The bouncelab developers\n{DESCRIPTION}"
    );
    write(&control, &fields)?;
    let mut package = Command::new("dpkg-deb");
    // The usual level takes five times as long to save a seventh.
    package.args(["-z1", "--root-owner-group", "--build"]);
    package.env("SOURCE_DATE_EPOCH", EPOCH);
    run_command(package.arg(tree).arg(folder))
}

/// Which packages have the libraries that a program is linked with, as a field of a Debian package.
fn libraries(program: &Path) -> Result<String> {
    let is_there = || succeeds(&["dpkg-shlibdeps", "--version"]);
    if !is_there() {
        install(&["dpkg-dev"], "the dependencies of the Debian package");
    }
    // It takes a folder with the sources of a package.
    let sources = target().join("release-staged/sources");
    emptied(&sources.join("debian"))?;
    let fields = "Source: bouncelab\n\nPackage: bouncelab\nArchitecture: any\n";
    write(&sources.join("debian/control"), fields)?;
    let mut ask = Command::new("dpkg-shlibdeps");
    let found = ask.arg("-O").arg(program).current_dir(sources).output();
    let found = found.map_err(|reason| format!("dpkg-shlibdeps: {reason}"))?;
    let list = String::from_utf8_lossy(&found.stdout).into_owned();
    let list = list.trim_end().strip_prefix("shlibs:Depends=");
    list.map(|list| format!("Depends: {list}\n"))
        .ok_or_else(|| String::from_utf8_lossy(&found.stderr).into_owned())
}

/// Packs a folder that lies in another: the same contents make the same bytes, whenever and by whomever it is packed.
fn archive(folder: &Path, name: &str, parent: &Path, contents: &str) -> Result {
    let path = folder.join(format!("{name}.tar.gz"));
    let pack = || -> io::Result<()> {
        let gzip = GzEncoder::new(fs::File::create(&path)?, Compression::best());
        let mut tar = tar::Builder::new(gzip);
        // Neither times nor owners.
        tar.mode(tar::HeaderMode::Deterministic);
        append(&mut tar, parent, Path::new(contents))?;
        tar.into_inner()?.finish()?.sync_all()
    };
    pack().map_err(|reason| file_error(&path, &reason))
}

/// Adds a file, or a folder with what it holds in the order of names.
fn append(tar: &mut tar::Builder<impl io::Write>, parent: &Path, name: &Path) -> io::Result<()> {
    let path = parent.join(name);
    if !path.is_dir() {
        return tar.append_path_with_name(path, name);
    }
    tar.append_dir(name, &path)?;
    let mut names: Vec<_> = fs::read_dir(&path)?
        .map(|entry| Ok(entry?.file_name()))
        .collect::<io::Result<_>>()?;
    names.sort();
    names
        .iter()
        .try_for_each(|it| append(tar, parent, &name.join(it)))
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
    if python::interpreters().is_empty() {
        skip(&format!(
            "workflow files, issue forms and how to cite: {}",
            python::MISSING
        ));
    } else {
        let workflows = files(&root().join(".github/workflows"))?;
        let workflows = workflows
            .into_iter()
            .map(|path| ("vendor.github-workflows", path));
        let by_schema = BY_SCHEMA.map(|(schema, document)| (schema, root().join(document)));
        python::validate(by_schema.into_iter().chain(workflows))?;
    }
    if let Some(audit) = python::program("zizmor") {
        let mut audit = Command::new(audit);
        audit.args(["--offline", "--quiet", "--min-severity", "medium"]);
        audit.args(["--min-confidence", "medium"]);
        run_command(audit.arg(root().join(".github/workflows")))?;
    }
    built("--bin", "bouncelab")?;
    let folder = target().join("release-check/artefacts");
    emptied(&folder)?;
    program(&folder, &target().join("debug"), &host()?)?;
    wheel(&folder, python::checked_wheel)?;
    documents(&folder)?;
    checksums(&folder)?;
    verify(&folder)?;
    makes_the_same_again(&folder)?;
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
            install_debian(&place, &path)?;
            demo(&place.join("usr/bin"))?;
            has_help(&place.join("usr/share"), &HELP_IN_DEBIAN)?;
        } else if name.starts_with("bouncelab-page") {
            unpack(&path, &place)?;
            read(&place.join("dist/index.html"))?;
        } else if name.starts_with("bouncelab-book") {
            unpack(&path, &place)?;
            read(&place.join("book/tutorial.html"))?;
        } else if name == format!("bouncelab-{VERSION}.tar.gz") {
            unpack(&path, &place)?;
            python::have_all_sources(&place.join(name.trim_end_matches(".tar.gz")))?;
        } else if name.ends_with(".tar.gz") {
            unpack(&path, &place)?;
            let program = place.join(name.trim_end_matches(".tar.gz"));
            demo(&program)?;
            has_help(&program, &HELP_IN_ARCHIVE)?;
        }
    }
    Ok(())
}

/// Whether the program, packed once more, is the same bytes.
fn makes_the_same_again(folder: &Path) -> Result {
    let again = target().join("release-check/again");
    emptied(&again)?;
    program(&again, &target().join("debug"), &host()?)?;
    for path in files(&again)? {
        let first = folder.join(path.file_name().unwrap_or_default());
        let read = |path: &Path| fs::read(path).map_err(|reason| file_error(path, &reason));
        if read(&first)? != read(&path)? {
            return Err(format!("{}: packed twice, it differs", first.display()));
        }
    }
    Ok(())
}

/// Installs a Debian package in a folder, as on a system with what this one has of the packages that it depends on.
fn install_debian(place: &Path, package: &Path) -> Result {
    let state = Path::new("var/lib/dpkg");
    for folder in ["info", "updates"] {
        emptied(&place.join(state).join(folder))?;
    }
    let answer = |ask: &mut Command| -> Result<String> {
        let answer = ask.output().map_err(|reason| reason.to_string())?;
        Ok(String::from_utf8_lossy(&answer.stdout).into_owned())
    };
    let mut ask = Command::new("dpkg-deb");
    let depends = answer(ask.arg("--field").arg(package).arg("Depends"))?;
    let names = depends
        .trim()
        .split(", ")
        .filter_map(|it| it.split(' ').next());
    let mut ask = Command::new("dpkg-query");
    let status = answer(ask.arg("--status").args(names))?;
    write(&place.join(state).join("status"), &status)?;
    let mut dpkg = Command::new("dpkg");
    dpkg.args(["--force-not-root", "--log=/dev/null", "--root"]);
    run_command(dpkg.arg(place).arg("--install").arg(package))
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
const HELP_IN_ARCHIVE: [&str; 5] = [
    "man/bouncelab-analyze.1",
    "completions/_bouncelab.ps1",
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
            let unpacked = unpacked.map_err(|reason| file_error(&path, &reason))?;
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
    let unpacked =
        fs::File::open(path).and_then(|file| tar::Archive::new(GzDecoder::new(file)).unpack(place));
    unpacked.map_err(|reason| file_error(path, &reason))
}

/// Runs the demo of a program from its own folder, with an empty home.
fn demo(folder: &Path) -> Result {
    let mut demo = Command::new(folder.join(format!("bouncelab{EXE_SUFFIX}")));
    demo.arg("demo").current_dir(folder).env("HOME", folder);
    // The program of the wheel is a script beside the package.
    demo.env("PYTHONPATH", folder.parent().unwrap_or(folder));
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

fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).map_err(|reason| file_error(folder, &reason))?;
    Ok(entries.flatten().map(|entry| entry.path()).collect())
}

fn copy_into(folder: &Path, file: &Path) -> Result {
    copy(file, &folder.join(file.file_name().unwrap_or_default()))
}

fn copy(from: &Path, to: &Path) -> Result {
    fs::copy(from, to)
        .map(drop)
        .map_err(|reason| file_error(from, &reason))
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).map_err(|reason| file_error(path, &reason))
}

fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|reason| file_error(path, &reason))
}

#[cfg(test)]
mod tests {
    use super::{VERSION, name_of, notes, read, root};

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

    /// `cargo release` writes them all; this finds what was written by hand.
    #[test]
    fn every_file_states_the_same_version() {
        for (file, line, count) in [
            ("CITATION.cff", format!("\nversion: {VERSION}\n"), 1),
            ("codemeta.json", format!("\"version\": \"{VERSION}\""), 1),
            (
                "Cargo.toml",
                format!("{{ version = \"{VERSION}\", path = "),
                5,
            ),
            ("web/package.json", format!("\"version\": \"{VERSION}\""), 1),
            ("conda/recipe.yaml", format!("version: \"{VERSION}\""), 1),
            (
                "web/package/package.json",
                format!("\"version\": \"{VERSION}\""),
                1,
            ),
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
