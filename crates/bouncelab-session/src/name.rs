//! File names as text, for any bytes.

use std::fmt::Write as _;
use std::path::Path;

use bouncelab::Plain;

/// A path as text, different for different paths: bytes that are not UTF-8 are written as `\xff`, invisible
/// characters as [`Plain`] writes them, and folders are separated by `/`.
///
/// ```
/// use std::path::Path;
/// assert_eq!(bouncelab_session::name(Path::new("monday/drop.wav")), "monday/drop.wav");
/// ```
pub fn name(path: &Path) -> String {
    let parts: Vec<String> = path
        .components()
        .map(|part| escaped(part.as_os_str().as_encoded_bytes()))
        .collect();
    parts.join("/").replace("//", "/")
}

/// A path in a message; that of the current folder is a dot.
pub(crate) fn shown(path: &Path) -> String {
    let text = name(path);
    if text.is_empty() {
        ".".to_owned()
    } else {
        text
    }
}

fn escaped(bytes: &[u8]) -> String {
    let mut text = String::new();
    for chunk in bytes.utf8_chunks() {
        // A backslash of the name itself is doubled, which distinguishes it from an escape.
        let doubled = chunk.valid().replace('\\', "\\\\");
        text.push_str(&String::from(Plain::of(&doubled)));
        for byte in chunk.invalid() {
            // Writing to a String cannot fail.
            let _ = write!(text, "\\x{byte:02x}");
        }
    }
    text
}

/// A message without the path of the recording with which it may begin, for a context that names the recording.
pub(crate) fn without_name<'a>(message: &'a str, name: &str) -> &'a str {
    match message.split_once(": ") {
        Some((path, rest)) if path.ends_with(name) => rest,
        _ => message,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinary_names_stay_as_they_are() {
        for path in ["drop.wav", "a/b/ü ñ.wav", "/tmp/x.wav"] {
            assert_eq!(name(Path::new(path)), path);
        }
        assert_eq!(name(Path::new("a\nb")), r"a\nb");
        assert_eq!(name(Path::new(r"a\nb")), r"a\\nb");
    }

    #[cfg(unix)]
    #[test]
    fn bytes_that_are_not_text_are_escaped_and_differ() {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt;
        let of = |bytes: &[u8]| name(Path::new(OsStr::from_bytes(bytes)));
        assert_eq!(of(b"drop\xff.wav"), "drop\\xff.wav");
        assert_ne!(of(b"drop\xff.wav"), of(b"drop\\xff.wav"));
    }
}
