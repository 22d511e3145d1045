//! Figures as files.

use std::path::{Path, PathBuf};

use crate::chart::Chart;
use crate::error::{Error, Result};
use crate::file::{Outputs, create_folder};
use crate::mark::{self, Mark};

/// Width of a saved picture in pixels: sharp on a page, and small enough to send.
const PICTURE_WIDTH_PX: u32 = 1600;

/// Where a figure was saved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Saved {
    /// The drawing.
    pub svg: PathBuf,
    /// The picture, 1600 pixels wide.
    pub png: PathBuf,
    /// The drawing for papers and slides.
    pub pdf: PathBuf,
    /// The data.
    pub csv: PathBuf,
}

/// Writes a figure as `NAME.svg`, `NAME.png`, `NAME.pdf` and `NAME.csv` into a folder, which is made if needed.
///
/// Each file appears whole or not at all. `outputs` decides whether files of these names are replaced.
///
/// # Errors
///
/// [`Error::Name`] if the name could lead out of the folder or hide the file,
/// [`Error::Folder`] if the folder cannot be made, [`Error::Write`] if a file cannot be
/// written, [`Error::Picture`] if there is no picture to write.
pub fn save(chart: &Chart, folder: &Path, name: &str, outputs: &Outputs) -> Result<Saved> {
    let allowed = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.');
    if name.is_empty() || name.starts_with('.') || !name.chars().all(allowed) {
        let name = name.to_owned();
        return Err(Error::Name { name });
    }
    let (picture, page) = (chart.png(PICTURE_WIDTH_PX)?, chart.pdf()?);
    create_folder(folder).map_err(|source| Error::Folder {
        folder: folder.to_owned(),
        source,
    })?;
    let written = |ending: &str, mark: Mark, bytes: &[u8]| {
        let path = folder.join(format!("{name}.{ending}"));
        match outputs.write(&path, mark, bytes) {
            Ok(()) => Ok(path),
            Err(source) => Err(Error::Write { path, source }),
        }
    };
    Ok(Saved {
        svg: written("svg", mark::SVG, chart.svg().as_bytes())?,
        png: written("png", mark::PNG, &picture)?,
        pdf: written("pdf", mark::PDF, &page)?,
        csv: written("csv", mark::DATA, chart.csv().as_bytes())?,
    })
}
