//! The crates and packages of others that are compiled into what is published: their licences, and the list of them
//! as a bill of materials (`CycloneDX`).

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::cargo::{cargo, root};
use crate::{Result, file_error};

/// What the file of licences is called, wherever it goes.
pub(crate) const NAME: &str = "LICENSE-THIRD-PARTY.txt";

const HEAD: &str = "\
bouncelab is licensed under MIT OR Apache-2.0. It contains the work of others under the licences below, each with the names of
what it applies to. The source code of each is at its address; nothing of it was changed.
";

/// A crate or package of others.
struct Work {
    /// Which registry has it, as in a package URL.
    registry: &'static str,
    name: String,
    version: String,
    licence: String,
    address: String,
    folder: PathBuf,
}

impl Work {
    fn title(&self) -> String {
        format!("{} {}", self.name, self.version)
    }
}

/// Writes the file of licences into a folder.
pub(crate) fn write(folder: &Path) -> Result {
    let path = folder.join(NAME);
    fs::write(&path, text(&works()?)?).map_err(|reason| file_error(&path, &reason))
}

/// Writes the bill of materials of a version.
pub(crate) fn write_materials(path: &Path, version: &str) -> Result {
    let document = materials(&works()?, version);
    fs::write(path, format!("{document:#}\n")).map_err(|reason| file_error(path, &reason))
}

fn works() -> Result<Vec<Work>> {
    Ok(crates()?.into_iter().chain(packages()?).collect())
}

/// The bill of materials after `CycloneDX` 1.6. It has no serial number and no time, so that the same works make the
/// same bytes.
fn materials(works: &[Work], version: &str) -> Value {
    let component = |work: &Work| {
        let url = format!("pkg:{}/{}@{}", work.registry, work.name, work.version);
        // Old manifests separate alternatives by a slash, which is no expression of SPDX.
        let licence = work.licence.replace(" / ", "/").replace('/', " OR ");
        json!({
            "type": "library",
            "bom-ref": url,
            "name": work.name,
            "version": work.version,
            "licenses": [{ "expression": licence }],
            "purl": url,
        })
    };
    let components: BTreeMap<String, Value> = { works.iter() }
        .map(|work| (work.title(), component(work)))
        .collect();
    json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": { "component": {
            "type": "application",
            "bom-ref": "bouncelab",
            "name": "bouncelab",
            "version": version,
            "licenses": [{ "expression": "MIT OR Apache-2.0" }],
        } },
        "components": components.into_values().collect::<Vec<_>>(),
    })
}

/// The crates of the program, the Python module and the page, for every kind of machine.
fn crates() -> Result<Vec<Work>> {
    let mut tree = cargo(["tree", "--prefix", "none", "--format", "{p}|{l}|{r}"]);
    tree.args(["--edges", "normal,no-proc-macro", "--target", "all"]);
    for package in ["bouncelab-cli", "bouncelab-python", "bouncelab-wasm"] {
        tree.args(["--package", package]);
    }
    tree.args(["--features", "bouncelab-cli/microphone"]);
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
            registry: "cargo",
            name: name.to_owned(),
            version: version.to_owned(),
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
fn packages() -> Result<Vec<Work>> {
    let web = root().join("web");
    let listed = manifest(&web)?;
    let names = listed["dependencies"].as_object().into_iter().flatten();
    let folders = names.map(|(name, _)| (name, web.join("node_modules").join(name)));
    let installed = folders.filter(|(_, folder)| folder.is_dir());
    let work = |(name, folder): (&String, PathBuf)| {
        let manifest = manifest(&folder)?;
        let of = |key: &str| manifest[key].as_str().unwrap_or_default().to_owned();
        Ok(Work {
            registry: "npm",
            name: name.clone(),
            version: of("version"),
            licence: of("license"),
            address: format!("https://www.npmjs.com/package/{name}"),
            folder,
        })
    };
    installed.map(work).collect()
}

/// What a package of npm says of itself.
fn manifest(folder: &Path) -> Result<Value> {
    let path = folder.join("package.json");
    let text = fs::read(&path).map_err(|reason| file_error(&path, &reason))?;
    serde_json::from_slice(&text).map_err(|reason| format!("{}: {reason}", path.display()))
}

/// All works, then each text once.
fn text(works: &[Work]) -> Result<String> {
    let mut text = format!("{HEAD}\n");
    let mut texts: BTreeMap<String, (String, Vec<String>)> = BTreeMap::new();
    let mut lines: Vec<String> = Vec::new();
    for work in works {
        let title = work.title();
        lines.push(format!("{title}: {}, {}", work.licence, work.address));
        for file in entries(&work.folder)?
            .into_iter()
            .filter(|it| is_licence(it))
        {
            let content = fs::read(&file).map_err(|reason| file_error(&file, &reason))?;
            let content = String::from_utf8_lossy(&content).into_owned();
            let words = content.split_whitespace().collect::<Vec<_>>().join(" ");
            let (_, names) = texts.entry(words).or_insert((content, Vec::new()));
            if !names.contains(&title) {
                names.push(title.clone());
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
        let is_missing = |work: &&Work| !text.contains(&work.title());
        assert_eq!(works.iter().filter(is_missing).count(), 0);
        assert!(text.contains("Mozilla Public License"));
        let line = text.lines().find(|line| line.starts_with("symphonia "));
        assert!(line.unwrap().contains("MPL-2.0, https://"), "{line:?}");
    }

    #[test]
    fn the_bill_of_materials_has_every_crate_once_with_an_expression() {
        let works = works().unwrap();
        let document = materials(&works, "1.2.3");
        let components = document["components"].as_array().unwrap();
        let mut titles: Vec<String> = works.iter().map(Work::title).collect();
        titles.sort();
        titles.dedup();
        assert_eq!(components.len(), titles.len());
        for component in components {
            let licence = component["licenses"][0]["expression"].as_str().unwrap();
            assert!(!licence.is_empty() && !licence.contains('/'), "{component}");
        }
        let symphonia = components
            .iter()
            .find(|it| it["name"] == "symphonia")
            .unwrap();
        assert_eq!(symphonia["licenses"][0]["expression"], "MPL-2.0");
    }
}
