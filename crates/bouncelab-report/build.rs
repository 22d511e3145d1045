//! Makes the message files part of the crate, and the letters that figures need: every folder in `messages/` is
//! a language.
//!
//! What the page in a browser says by itself, it reads by itself. The engine in a browser gets English
//! only, without what a terminal or a lesson sheet says; the page loads those of sheets and the other languages when a reader
//! chooses them.

#![expect(clippy::disallowed_methods, reason = "names of files of the project")]

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

const OF_PAGE: &str = "page.ftl";
/// What the engine in a browser never says.
const NOT_OF_ENGINE: [&str; 2] = ["sheets.ftl", "terminal.ftl"];

fn main() -> io::Result<()> {
    let out = env::var_os("OUT_DIR").expect("cargo names it");
    messages(Path::new(&out))?;
    #[cfg(feature = "pictures")]
    fonts::write(Path::new(&out))?;
    Ok(())
}

fn messages(out: &Path) -> io::Result<()> {
    println!("cargo::rerun-if-changed=messages");
    let folder =
        Path::new(&env::var("CARGO_MANIFEST_DIR").expect("cargo names it")).join("messages");
    let browser = env::var("CARGO_CFG_TARGET_FAMILY").is_ok_and(|family| family == "wasm");
    let mut code = "&[".to_owned();
    for language in sorted(&folder)? {
        let name = file_name(&language);
        if browser && name != "en" {
            continue;
        }
        write!(code, "({name:?}, &[").expect("a string takes all");
        for file in sorted(&language)? {
            let name = file_name(&file);
            if name != OF_PAGE && !(browser && NOT_OF_ENGINE.contains(&name)) {
                write!(code, "include_str!(r#\"{}\"#), ", file.display())
                    .expect("a string takes all");
            }
        }
        code.push_str("]), ");
    }
    code.push(']');
    fs::write(out.join("messages.rs"), code)
}

fn sorted(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths = fs::read_dir(folder)?
        .map(|entry| Ok(entry?.path()))
        .collect::<io::Result<Vec<_>>>()?;
    paths.sort();
    Ok(paths)
}

fn file_name(path: &Path) -> &str {
    path.file_name()
        .and_then(|name| name.to_str())
        .expect("names of languages and files are plain")
}

/// Whole, the fonts would be a tenth of the program.
#[cfg(feature = "pictures")]
mod fonts {
    use std::fs;
    use std::io;
    use std::ops::RangeInclusive;
    use std::path::Path;

    use subsetter::GlyphRemapper;
    use ttf_parser::Face;

    /// The letters of living languages in Latin, Greek and Cyrillic, punctuation, and the signs of mathematics.
    const LETTERS: [RangeInclusive<char>; 11] = [
        ' '..='~',
        '\u{a0}'..='\u{17f}',
        '\u{1a0}'..='\u{1b0}',
        '\u{218}'..='\u{21b}',
        '\u{300}'..='\u{328}',
        '\u{384}'..='\u{3ce}',
        '\u{400}'..='\u{45f}',
        '\u{490}'..='\u{4bb}',
        '\u{1e80}'..='\u{1ef9}',
        '\u{2010}'..='\u{22ff}',
        '\u{25a0}'..='\u{25ff}',
    ];

    /// What stands in titles, most of the time.
    const BOLD_LETTERS: [RangeInclusive<char>; 3] =
        [' '..='~', '\u{a0}'..='\u{17f}', '\u{2010}'..='\u{2044}'];

    /// Each font as `NAME.ttf`, and as `NAME.rs` its letters with the numbers of their glyphs, in order.
    pub(super) fn write(out: &Path) -> io::Result<()> {
        let fonts = [
            ("regular", dejavu::sans::regular(), LETTERS.as_slice()),
            ("bold", dejavu::sans::bold(), BOLD_LETTERS.as_slice()),
        ];
        for (name, font, letters) in fonts {
            let face = Face::parse(font, 0).map_err(io::Error::other)?;
            let mut kept = GlyphRemapper::new();
            let letters: Vec<(u32, u16)> = letters
                .iter()
                .cloned()
                .flatten()
                .filter_map(|letter| {
                    let glyph = kept.remap(face.glyph_index(letter)?.0);
                    Some((u32::from(letter), glyph))
                })
                .collect();
            let subset = subsetter::subset(font, 0, &kept).map_err(io::Error::other)?;
            fs::write(out.join(name).with_extension("ttf"), subset)?;
            fs::write(out.join(name).with_extension("rs"), format!("&{letters:?}"))?;
        }
        Ok(())
    }
}
