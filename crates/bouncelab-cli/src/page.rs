//! `bouncelab page`: the browser laboratory as files, for any web server.

use std::fs;
use std::path::{Path, PathBuf};

use bouncelab::Plain;
use clap::Args;

use crate::failure::Failure;
use crate::language::text_with;
use crate::serve;
use crate::terminal::print;

/// Write the browser laboratory into a folder, for any web server
///
/// The files are static and work in any folder of a server. Browsers give the microphone only to
/// pages that are served by https. Files of the page that are in the folder are replaced, others
/// stay.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Folder to write into; it is made if it does not exist
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab page public_html/bounce";

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let files = serve::files()?;
    let folder = &arguments.folder;
    // The page begins with the file that the others are needed for.
    let (last, others): (Vec<_>, Vec<_>) = files.iter().partition(|(name, _)| name == "index.html");
    for (name, content) in others.into_iter().chain(last) {
        write(&folder.join(name), content)?;
    }
    let of = [
        ("files", files.len().into()),
        ("folder", String::from(Plain::path(folder)).into()),
    ];
    print(format_args!("{}\n", text_with("page-written", &of)))?;
    Ok(())
}

fn write(path: &Path, content: &[u8]) -> Result<(), Failure> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder).map_err(|reason| Failure::unwritable(folder, &reason))?;
    fs::write(path, content).map_err(|reason| Failure::unwritable(path, &reason))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_has_every_file_of_the_page_or_is_not_made() {
        let place = tempfile::tempdir().unwrap();
        let folder = place.path().join("public/bounce");
        let arguments = Arguments {
            folder: folder.clone(),
        };
        let written = run(&arguments);
        let Ok(files) = serve::files() else {
            let reason = written.unwrap_err().to_string();
            assert!(reason.contains("cargo xtask install"), "{reason}");
            assert!(!folder.exists());
            return;
        };
        written.unwrap();
        for (name, content) in files {
            assert_eq!(fs::read(folder.join(&name)).unwrap(), content, "{name}");
        }
    }
}
