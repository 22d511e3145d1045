//! Writes files: completely or not at all, and never over what a person would miss.
//!
//! A file is written in its folder under a hidden name, and renamed when it is on the disk. A reader
//! sees the old file or the new one, never a part, whatever interrupts the program. [`Outputs`] decides
//! which files may be replaced: never an input nor another output of the command, and only files of bouncelab, identified by a
//! mark in them, unless replacing was asked for.
//!
//! ```
//! use bouncelab_report::file::Outputs;
//! use bouncelab_report::mark::Mark;
//!
//! const MINE: Mark = Mark::near_an_end("made by me");
//! # let folder = tempfile::tempdir()?;
//! let notes = folder.path().join("notes.txt");
//! std::fs::write(&notes, "a ball fell")?;
//! let outputs = Outputs::new([&notes], false);
//!
//! // An input is never replaced, by whatever name, nor is what something else wrote.
//! assert!(outputs.write(&notes, MINE, b"").is_err());
//!
//! let report = folder.path().join("report.txt");
//! outputs.write(&report, MINE, b"made by me: first")?;
//! // Of one command two outputs are two files; the next may replace them.
//! assert!(outputs.write(&report, MINE, b"made by me: second").is_err());
//! Outputs::new([&notes], false).write(&report, MINE, b"made by me: second")?;
//! assert_eq!(std::fs::read(&report)?, b"made by me: second");
//! # Ok::<(), std::io::Error>(())
//! ```

use std::collections::HashSet;
use std::fs::{self, File};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use file_id::FileId;
use tempfile::NamedTempFile;

use crate::mark::Mark;

/// The content of a file of notes: at most `max_mb` MB, and no device or pipe, which may be endless.
///
/// # Errors
///
/// The reason of the system, or that it is no such file.
///
/// ```
/// use bouncelab_report::file::read_noted;
///
/// assert!(read_noted(std::path::Path::new("."), 1).unwrap_err().to_string().contains("is no file"));
/// ```
pub fn read_noted(path: &Path, max_mb: u64) -> io::Result<Vec<u8>> {
    let about = fs::metadata(path)?;
    if !about.is_file() || about.len() > max_mb << 20 {
        let problem =
            format!("it is no file of notes: a device, a pipe, a folder, or more than {max_mb} MB");
        return Err(io::Error::new(io::ErrorKind::InvalidInput, problem));
    }
    let mut content = Vec::new();
    // It may grow meanwhile.
    File::open(path)?
        .take(max_mb << 20)
        .read_to_end(&mut content)?;
    Ok(content)
}

/// Which files a command may write.
#[derive(Debug)]
pub struct Outputs {
    /// What it reads, by the position on the disk: a file may have several names.
    inputs: HashSet<FileId>,
    /// What it has written, which another output of it does not replace.
    written: Written,
    /// Whether files of others may be replaced too.
    force: bool,
    /// What a person writes to ask for that.
    option: &'static str,
}

impl Default for Outputs {
    /// Of a command that reads no files, without `force`.
    fn default() -> Self {
        Self::new([""; 0], false)
    }
}

impl Outputs {
    /// What a command may write that reads these files. With `force` it may replace any other.
    pub fn new(inputs: impl IntoIterator<Item = impl AsRef<Path>>, force: bool) -> Self {
        let ids = inputs
            .into_iter()
            .filter_map(|it| file_id::get_file_id(it).ok());
        Self {
            inputs: ids.collect(),
            written: Written::default(),
            force,
            option: "--force",
        }
    }

    /// The same where a person asks otherwise than with `--force` for files of others to be replaced.
    #[must_use]
    pub fn asked_with(self, option: &'static str) -> Self {
        Self { option, ..self }
    }

    /// Whether a file may be written; one that is there must have the mark.
    ///
    /// # Errors
    /// [`io::ErrorKind::AlreadyExists`] if it may not be replaced, [`io::ErrorKind::IsADirectory`] if a
    /// folder has the name, [`io::ErrorKind::InvalidInput`] if a device or a pipe has it, and what the
    /// system reports if it cannot be read.
    pub fn check(&self, path: &Path, mark: Mark) -> io::Result<()> {
        let about = match fs::metadata(path) {
            Err(reason) if is_absent(&reason) => return Ok(()),
            about => about?,
        };
        if about.is_dir() {
            let reason = "it is a folder; name a file in it";
            return Err(io::Error::new(io::ErrorKind::IsADirectory, reason));
        }
        // The rename would replace a device with a file.
        if !about.is_file() {
            let reason = "it is a device or a pipe, not a file";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, reason));
        }
        self.check_unused(path)?;
        if self.force || about.len() == 0 || mark.is_in(&File::open(path)?)? {
            return Ok(());
        }
        let option = self.option;
        let reason = format!(
            "it exists, and bouncelab did not write it; name another file, or replace it with {option}"
        );
        Err(io::Error::new(io::ErrorKind::AlreadyExists, reason))
    }

    /// Whether a file is neither an input, which no command may write, nor another output.
    ///
    /// # Errors
    /// [`io::ErrorKind::AlreadyExists`] if it is one, and what the system reports if it cannot be read.
    pub fn check_unused(&self, path: &Path) -> io::Result<()> {
        let id = match file_id::get_file_id(path) {
            Err(reason) if is_absent(&reason) => return Ok(()),
            id => id?,
        };
        let use_of_it = if self.inputs.contains(&id) {
            "an input"
        } else if self.written.files().contains(&id) {
            "another output"
        } else {
            return Ok(());
        };
        let reason = format!("it is {use_of_it} of this command; name another file");
        Err(io::Error::new(io::ErrorKind::AlreadyExists, reason))
    }

    /// Begins a file that may be written.
    ///
    /// # Errors
    /// Those of [`Self::check`], and what the system reports if there is no such folder or it cannot be
    /// written into.
    pub fn draft(&self, path: &Path, mark: Mark) -> io::Result<Draft> {
        self.check(path, mark)?;
        Draft::new(path, &self.written)
    }

    /// Writes a file whole. One with the same content is left as it is.
    ///
    /// # Errors
    /// Those of [`Self::draft`] and [`Draft::finish`].
    pub fn write(&self, path: &Path, mark: Mark, bytes: &[u8]) -> io::Result<()> {
        if has_content(path, bytes) {
            return self.written.add(path);
        }
        let draft = self.draft(path, mark)?;
        draft.file().write_all(bytes)?;
        draft.finish()
    }

    /// As [`Self::write`], for a content that is too long for the memory: `fill` writes it.
    ///
    /// # Errors
    /// Those of [`Self::write`] and of `fill`.
    pub fn fill(
        &self,
        path: &Path,
        mark: Mark,
        fill: impl FnOnce(&File) -> io::Result<()>,
    ) -> io::Result<()> {
        let draft = Draft::new(path, &self.written)?;
        fill(draft.file())?;
        if are_alike(draft.file.path(), path)? {
            return self.written.add(path);
        }
        self.check(path, mark)?;
        draft.finish()
    }
}

/// Files by their position on the disk.
#[derive(Clone, Debug, Default)]
struct Written(Arc<Mutex<HashSet<FileId>>>);

impl Written {
    fn add(&self, path: &Path) -> io::Result<()> {
        let id = file_id::get_file_id(path)?;
        self.files().insert(id);
        Ok(())
    }

    fn files(&self) -> MutexGuard<'_, HashSet<FileId>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Whether two files have the same content.
fn are_alike(one: &Path, other: &Path) -> io::Result<bool> {
    let length = fs::metadata(one)?.len();
    if !fs::metadata(other).is_ok_and(|about| about.is_file() && about.len() == length) {
        return Ok(false);
    }
    let bytes = |path| File::open(path).map(|file| BufReader::new(file).bytes());
    let mut pairs = std::iter::zip(bytes(one)?, bytes(other)?);
    Ok(pairs.all(|pair| matches!(pair, (Ok(a), Ok(b)) if a == b)))
}

/// Whether there is no such file, which leaves it to the writing to say what is in the way.
fn is_absent(reason: &io::Error) -> bool {
    matches!(
        reason.kind(),
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory
    )
}

fn has_content(path: &Path, bytes: &[u8]) -> bool {
    let is_as_long = |about: fs::Metadata| about.is_file() && about.len() == bytes.len() as u64;
    fs::metadata(path).is_ok_and(is_as_long) && fs::read(path).is_ok_and(|found| found == bytes)
}

/// How names of drafts begin and end.
const NAME: (&str, &str) = (".bouncelab-", ".part");

/// The drafts of this program that are not finished.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all drafts of this program, which is about to end: no draft can be begun or finished after
/// it.
pub fn abandon_drafts() {
    let drafts = unfinished();
    for draft in drafts.iter() {
        // There is no caller left to report it to.
        let _ = fs::remove_file(draft);
    }
    std::mem::forget(drafts);
}

/// A file that does not have its name yet. Dropped before [`Draft::finish`], it is removed.
#[derive(Debug)]
pub struct Draft {
    /// The name that it will have.
    path: PathBuf,
    file: NamedTempFile,
    /// Where it is noted when it is finished.
    written: Written,
    /// Only for its end.
    _listed: Listed,
}

/// A draft in the list of those that are not finished.
#[derive(Debug)]
struct Listed(PathBuf);

impl Drop for Listed {
    fn drop(&mut self) {
        unfinished().retain(|draft| *draft != self.0);
    }
}

impl Draft {
    /// Begins a file, in the folder in which it will be, with the permissions of any new file. Where
    /// the path is a link, the file to which it leads is written, and the link remains.
    fn new(path: &Path, written: &Written) -> io::Result<Self> {
        let path = match fs::canonicalize(path) {
            Ok(end) if path.is_symlink() => end,
            _ => path.to_owned(),
        };
        let mut builder = tempfile::Builder::new();
        builder.prefix(NAME.0).suffix(NAME.1);
        // Without this only the user could read it; the mask of the user still counts.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut drafts = unfinished();
        let file = builder.tempfile_in(folder_of(&path))?;
        drafts.push(file.path().to_owned());
        let listed = Listed(file.path().to_owned());
        Ok(Self {
            path,
            file,
            written: written.clone(),
            _listed: listed,
        })
    }

    /// The file, to write into it.
    pub fn file(&self) -> &File {
        self.file.as_file()
    }

    /// Makes sure that all of it is on the disk and gives it its name, in the place of a file that has
    /// it already; when this returns, the name is on the disk too.
    ///
    /// # Errors
    /// What the system reports, as when the disk is full; a file of that name is then unchanged.
    pub fn finish(self) -> io::Result<()> {
        self.file().sync_all()?;
        let path = self.path;
        self.file.persist(&path)?;
        self.written.add(&path)?;
        sync_name(&path)
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Makes sure that the name of a file or folder is on the disk. Windows does so by itself.
///
/// # Errors
/// What the system reports.
pub fn sync_name(path: &Path) -> io::Result<()> {
    if cfg!(unix) {
        File::open(folder_of(path))?.sync_all()?;
    }
    Ok(())
}

/// Makes a folder, and those in which it lies, if they are not there; their names are on the disk when this
/// returns.
///
/// # Errors
/// What the system reports.
///
/// ```
/// # let folder = tempfile::tempdir()?;
/// let inner = folder.path().join("results/monday");
/// bouncelab_report::file::create_folder(&inner)?;
/// assert!(inner.is_dir());
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn create_folder(folder: &Path) -> io::Result<()> {
    let outwards = folder.ancestors().filter(|it| !it.as_os_str().is_empty());
    let made: Vec<&Path> = outwards.take_while(|it| !it.exists()).collect();
    fs::create_dir_all(folder)?;
    made.into_iter().try_for_each(sync_name)
}

/// Removes the drafts that interrupted programs left in a folder, in which no other program may be writing.
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

/// Bytes searched at each end of a file.
const ENDS: u64 = 4096;

impl Mark {
    /// Whether a file has it.
    pub(crate) fn is_in(self, file: &File) -> io::Result<bool> {
        if self == Self::NONE {
            return Ok(false);
        }
        let length = file.metadata()?.len();
        let beginning = part(file, 0)?;
        let end = part(file, length.saturating_sub(ENDS))?;
        Ok(beginning.starts_with(self.first.as_bytes())
            && [beginning, end]
                .iter()
                .any(|part| holds(part, self.near_an_end.as_bytes())))
    }
}

/// The content of a file from a position on, 4 kB at most.
fn part(mut file: &File, start: u64) -> io::Result<Vec<u8>> {
    let mut part = Vec::new();
    file.seek(SeekFrom::Start(start))?;
    file.take(ENDS).read_to_end(&mut part)?;
    Ok(part)
}

fn holds(part: &[u8], text: &[u8]) -> bool {
    text.is_empty() || part.windows(text.len()).any(|window| window == text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mark::{COMMENT, MARKDOWN};

    const CONTENT: &[u8] = b"<!-- made by bouncelab -->, and more";

    fn file_with(content: &[u8]) -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file.md");
        fs::write(&path, content).unwrap();
        (folder, path)
    }

    #[test]
    fn a_file_of_somebody_else_is_replaced_only_on_request() {
        let (_folder, path) = file_with(b"my notes");
        let mention = file_with(b"The figures were made by bouncelab.");
        assert!(Outputs::default().check(&mention.1, MARKDOWN).is_err());
        let refusal = Outputs::default()
            .write(&path, MARKDOWN, CONTENT)
            .unwrap_err();
        assert!(refusal.to_string().contains("--force"), "{refusal}");
        assert_eq!(fs::read(&path).unwrap(), b"my notes");
        let force = Outputs::new([""; 0], true);
        force.write(&path, MARKDOWN, CONTENT).unwrap();
        assert_eq!(fs::read(&path).unwrap(), CONTENT);
        Outputs::default()
            .write(&path, MARKDOWN, b"<!-- made by bouncelab --> again")
            .unwrap();
        assert!(
            Outputs::default()
                .write(&path, Mark::NONE, b"no mark")
                .is_err()
        );
    }

    #[cfg(unix)]
    #[test]
    fn an_input_is_never_replaced_by_whatever_name() {
        let (folder, path) = file_with(CONTENT);
        let at = |name: &str| folder.path().join(name);
        std::os::unix::fs::symlink(&path, at("link")).unwrap();
        std::os::unix::fs::symlink("link", at("link-to-link")).unwrap();
        fs::hard_link(&path, at("hard")).unwrap();
        for input in [path.clone(), at("link-to-link")] {
            let outputs = Outputs::new([input], true);
            for output in [
                path.clone(),
                at("link"),
                at("link-to-link"),
                at("hard"),
                at("./file.md"),
            ] {
                let refusal = outputs
                    .write(&output, MARKDOWN, COMMENT.as_bytes())
                    .unwrap_err();
                assert!(refusal.to_string().contains("input"), "{refusal}");
            }
        }
        assert_eq!(fs::read(&path).unwrap(), CONTENT);
    }

    #[test]
    fn an_output_is_not_replaced_by_another_of_the_same_command() {
        let (folder, path) = file_with(b"");
        let outputs = Outputs::new([""; 0], true);
        outputs.write(&path, MARKDOWN, CONTENT).unwrap();
        let same = folder.path().join("./file.md");
        for _ in 0..2 {
            let refusal = outputs.write(&same, Mark::NONE, b"other").unwrap_err();
            assert!(refusal.to_string().contains("another output"), "{refusal}");
            assert_eq!(fs::read(&path).unwrap(), CONTENT);
            // What stays as it is was written too.
            outputs.write(&path, MARKDOWN, CONTENT).unwrap();
        }
        let again = Outputs::new([""; 0], true);
        again.write(&path, Mark::NONE, b"other").unwrap();
    }

    #[test]
    fn a_draft_that_is_dropped_leaves_nothing_behind() {
        let (folder, path) = file_with(b"");
        drop(Outputs::default().draft(&path, MARKDOWN).unwrap());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(
            !unfinished()
                .iter()
                .any(|draft| draft.starts_with(folder.path()))
        );
    }
}
