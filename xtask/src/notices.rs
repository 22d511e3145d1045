//! The licences of the crates and packages that are compiled into what is published.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use crate::cargo::{cargo, root};
use crate::{Result, file_error};

/// What the file is called, wherever it goes.
pub(crate) const NAME: &str = "LICENSE-THIRD-PARTY.txt";

const HEAD: &str = "\
bouncelab is licensed under MIT OR Apache-2.0. It contains the work of others under the licences below, each with the names of
what it applies to. The source code of each is at its address; nothing of it was changed.
";

/// A crate or package of others.
struct Work {
    name: String,
    licence: String,
    address: String,
    folder: PathBuf,
}

/// Writes the file into a folder.
pub(crate) fn write(folder: &Path) -> Result {
    let path = folder.join(NAME);
    let works: Vec<Work> = crates()?.into_iter().chain(packages()).collect();
    fs::write(&path, text(&works)?).map_err(|reason| file_error(&path, &reason))
}

/// The crates of the program, the Python module and the page, for every kind of machine.
fn crates() -> Result<Vec<Work>> {
    let mut tree = cargo(["tree", "--prefix", "none", "--format", "{p}|{l}|{r}"]);
    tree.args(["--edges", "normal,no-proc-macro", "--target", "all"]);
    for package in ["bouncelab-cli", "bouncelab-python", "bouncelab-wasm"] {
        tree.args(["--package", package]);
    }
    tree.args(["--features", "bouncelab-cli/serve,bouncelab-cli/microphone"]);
    let listed = tree.output().map_err(|reason| reason.to_string())?;
    if !listed.status.success() {
        return Err(String::from_utf8_lossy(&listed.stderr).into_owned());
    }
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(std::env::home_dir()?.join(".cargo")));
    let sources = home.unwrap_or_default().join("registry/src");
    let registries: Vec<PathBuf> = entries(&sources)?;
    let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
    let mut works = Vec::new();
    for line in listed.lines() {
        let mut parts = line.trim_end_matches(" (*)").split('|');
        let (Some(package), Some(licence), Some(address)) =
            (parts.next(), parts.next(), parts.next())
        else {
            continue;
        };
        // Those of the project have a path behind the version.
        let Some((name, version)) = package.split_once(" v").filter(|(_, it)| !it.contains(' '))
        else {
            continue;
        };
        let folder = format!("{name}-{version}");
        let places = registries.iter().map(|registry| registry.join(&folder));
        works.push(Work {
            name: format!("{name} {version}"),
            licence: licence.to_owned(),
            address: address.to_owned(),
            folder: { places }
                .find(|it| it.is_dir())
                .ok_or_else(|| format!("{folder} is not in {}", sources.display()))?,
        });
    }
    Ok(works)
}

/// The packages of npm that the page contains, where they are installed.
fn packages() -> Vec<Work> {
    let web = root().join("web");
    let of = |path: &Path, key: &str| -> Option<String> {
        let text = fs::read_to_string(path.join("package.json")).ok()?;
        let value = text.split_once(&format!("\"{key}\": "))?.1.trim_start();
        Some(value.trim_start_matches('"').split('"').next()?.to_owned())
    };
    let listed = fs::read_to_string(web.join("package.json")).unwrap_or_default();
    let listed = listed
        .split_once("\"dependencies\": {")
        .map_or("", |it| it.1);
    let listed = listed.split('}').next().unwrap_or_default().lines();
    let names = listed.filter_map(|line| line.trim().strip_prefix('"')?.split('"').next());
    let work = |name: &str| {
        let folder = web.join("node_modules").join(name);
        Some(Work {
            name: format!("{name} {}", of(&folder, "version")?),
            licence: of(&folder, "license")?,
            address: format!("https://www.npmjs.com/package/{name}"),
            folder,
        })
    };
    names.filter_map(work).collect()
}

/// All works, then each text once.
fn text(works: &[Work]) -> Result<String> {
    let mut text = format!("{HEAD}\n");
    let mut texts: BTreeMap<String, (String, Vec<&str>)> = BTreeMap::new();
    let mut lines: Vec<String> = Vec::new();
    for work in works {
        lines.push(format!("{}: {}, {}", work.name, work.licence, work.address));
        for file in entries(&work.folder)?
            .into_iter()
            .filter(|it| is_licence(it))
        {
            let content = fs::read(&file).map_err(|reason| file_error(&file, &reason))?;
            let content = String::from_utf8_lossy(&content).into_owned();
            let words = content.split_whitespace().collect::<Vec<_>>().join(" ");
            let (_, names) = texts.entry(words).or_insert((content, Vec::new()));
            if !names.contains(&work.name.as_str()) {
                names.push(&work.name);
            }
        }
    }
    lines.sort();
    lines.dedup();
    text += &lines.join("\n");
    for (content, names) in texts.into_values() {
        let rule = "-".repeat(80);
        let names = names.join(", ");
        write!(
            text,
            "\n\n{rule}\n{names}\n{rule}\n\n{}",
            content.trim_end()
        )
        .expect("a text takes all that is written");
    }
    Ok(text + "\n")
}

fn is_licence(file: &Path) -> bool {
    let name = file
        .file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase();
    let starts = ["licen", "copying", "notice", "unlicense", "copyright"];
    file.is_file() && starts.iter().any(|start| name.starts_with(start))
}

/// What a folder holds, in the order of names.
fn entries(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).map_err(|reason| file_error(folder, &reason))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_crate_is_named_and_copyleft_has_its_text_and_address() {
        let works = crates().unwrap();
        assert!(works.len() > 100);
        let text = text(&works).unwrap();
        let named = |work: &&Work| !text.contains(&work.name);
        assert_eq!(works.iter().filter(named).count(), 0);
        assert!(text.contains("Mozilla Public License"));
        let line = text.lines().find(|line| line.starts_with("symphonia "));
        assert!(line.unwrap().contains("MPL-2.0, https://"), "{line:?}");
    }
}
