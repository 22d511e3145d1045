//! Files that appear whole or not at all.
//!
//! A file is written beside its place under a name that begins with a dot, and moved there when it is
//! on the disk. Whoever looks sees the old file or the new one, never half of one, whatever kills the
//! program meanwhile. Files get the permissions that any new file gets.
//!
//! ```
//! use std::io::Write;
//! use bouncelab_files::{Draft, write_whole};
//!
//! # let folder = tempfile::tempdir()?;
//! let place = folder.path().join("notes.txt");
//! write_whole(&place, b"a ball fell")?;
//!
//! let mut draft = Draft::new(&place)?;
//! draft.write_all(b"a ball fell twice")?;
//! assert_eq!(std::fs::read(&place)?, b"a ball fell");
//! draft.finish()?;
//! assert_eq!(std::fs::read(&place)?, b"a ball fell twice");
//! # Ok::<(), std::io::Error>(())
//! ```

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};

/// How names of drafts end.
const ENDING: &str = ".part";

/// A file that does not have its name yet. Dropped before [`Draft::finish`], it is gone.
#[derive(Debug)]
pub struct Draft {
    /// The name that it will have.
    path: PathBuf,
    part: Part,
    file: File,
}

/// The name that a draft has until then, which is removed with it.
#[derive(Debug)]
struct Part(PathBuf);

impl Drop for Part {
    fn drop(&mut self) {
        // It has another name by now, or nothing better can be done.
        let _ = fs::remove_file(&self.0);
    }
}

impl Draft {
    /// Begins a file, in the folder in which it will be. Where the place is a link, it is the file to
    /// which that leads, and the link remains.
    ///
    /// # Errors
    /// What the system says if there is no such folder or it cannot be written into,
    /// [`io::ErrorKind::IsADirectory`] if the place is taken by a folder, and
    /// [`io::ErrorKind::InvalidInput`] if it is taken by a device or a pipe.
    pub fn new(path: &Path) -> io::Result<Self> {
        let path = match fs::canonicalize(path) {
            Ok(end) if path.is_symlink() => end,
            _ => path.to_owned(),
        };
        if path.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        // Nobody wants a file in the place of a device.
        if path.exists() && !path.is_file() {
            let reason = "it is a device or a pipe, not a file";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, reason));
        }
        let part = path.with_file_name(part_name(&path));
        let file = File::create_new(&part)?;
        Ok(Self {
            path,
            part: Part(part),
            file,
        })
    }

    /// The file, for those who write into it by themselves.
    pub fn file(&self) -> &File {
        &self.file
    }

    /// Makes sure that all of it is on the disk and gives it its name, in the place of a file that has
    /// it already.
    ///
    /// # Errors
    /// What the system says, as when the disk is full; a file of that name is then as it was.
    pub fn finish(self) -> io::Result<()> {
        let Self { path, part, file } = self;
        file.sync_all()?;
        drop(file);
        fs::rename(&part.0, path)
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Writes a file whole.
///
/// # Errors
/// Those of [`Draft::new`] and [`Draft::finish`].
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut draft = Draft::new(path)?;
    draft.write_all(bytes)?;
    draft.finish()
}

/// Removes the drafts that killed programs left in a folder. Nobody else may be writing there.
///
/// # Errors
/// What the system says if the folder cannot be read or a draft not be removed.
pub fn remove_drafts(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name();
        if is_part_name(&name.to_string_lossy()) {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

/// Whether [`part_name`] makes such names; others may be somebody's own.
fn is_part_name(name: &str) -> bool {
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let numbers = name
        .strip_prefix('.')
        .and_then(|name| name.strip_suffix(ENDING))
        .and_then(|name| name.rsplit_once('.'))
        .and_then(|(_, numbers)| numbers.split_once('-'));
    numbers.is_some_and(|(process, draft)| is_number(process) && is_number(draft))
}

/// A hidden name that no other draft has, of this program or another.
fn part_name(path: &Path) -> OsString {
    static DRAFTS: AtomicU64 = AtomicU64::new(0);
    let number = DRAFTS.fetch_add(1, Ordering::Relaxed);
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}-{number}{ENDING}", process::id()));
    name
}
