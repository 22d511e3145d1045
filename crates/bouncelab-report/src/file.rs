//! Writes files completely or not at all.
//!
//! A file is written beside its place under a hidden name, and renamed when it is on the disk. A reader
//! sees the old file or the new one, never a part, whatever interrupts the program.
//!
//! ```
//! use std::io::Write;
//! use bouncelab_report::file::{Draft, write_whole};
//!
//! # let folder = tempfile::tempdir()?;
//! let place = folder.path().join("notes.txt");
//! write_whole(&place, b"a ball fell")?;
//!
//! let draft = Draft::new(&place)?;
//! draft.file().write_all(b"a ball fell twice")?;
//! assert_eq!(std::fs::read(&place)?, b"a ball fell");
//! draft.finish()?;
//! assert_eq!(std::fs::read(&place)?, b"a ball fell twice");
//! # Ok::<(), std::io::Error>(())
//! ```

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

/// How names of drafts begin and end.
const NAME: (&str, &str) = (".bouncelab-", ".part");

/// A file that does not have its name yet. Dropped before [`Draft::finish`], it is removed.
#[derive(Debug)]
pub struct Draft {
    /// The name that it will have.
    path: PathBuf,
    file: NamedTempFile,
}

impl Draft {
    /// Begins a file, in the folder in which it will be, with the permissions of any new file. Where
    /// the place is a link, the file to which it leads is written, and the link remains.
    ///
    /// # Errors
    /// What the system reports if there is no such folder or it cannot be written into,
    /// [`io::ErrorKind::IsADirectory`] if a folder has the name, and [`io::ErrorKind::InvalidInput`]
    /// if a device or a pipe has it.
    pub fn new(path: &Path) -> io::Result<Self> {
        let path = match fs::canonicalize(path) {
            Ok(end) if path.is_symlink() => end,
            _ => path.to_owned(),
        };
        if path.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        // The rename would replace a device with a file.
        if path.exists() && !path.is_file() {
            let reason = "it is a device or a pipe, not a file";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, reason));
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(NAME.0).suffix(NAME.1);
        // Without this only the user could read it; the mask of the user still counts.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let file = builder.tempfile_in(path.parent().unwrap_or(Path::new("")))?;
        Ok(Self { path, file })
    }

    /// The file, to write into it.
    pub fn file(&self) -> &File {
        self.file.as_file()
    }

    /// Makes sure that all of it is on the disk and gives it its name, in the place of a file that has
    /// it already.
    ///
    /// # Errors
    /// What the system reports, as when the disk is full; a file of that name is then unchanged.
    pub fn finish(self) -> io::Result<()> {
        self.file().sync_all()?;
        self.file.persist(self.path)?;
        Ok(())
    }
}

/// Writes a file whole.
///
/// # Errors
/// Those of [`Draft::new`] and [`Draft::finish`].
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let draft = Draft::new(path)?;
    draft.file().write_all(bytes)?;
    draft.finish()
}

/// Removes the drafts that interrupted programs left in a folder. Nobody else may be writing there.
///
/// # Errors
/// What the system reports if the folder cannot be read or a draft not be removed.
pub fn remove_drafts(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with(NAME.0) && name.ends_with(NAME.1) {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}
