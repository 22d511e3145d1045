//! The letters of pictures, which need no font of the system.

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, FaceParsingError, GlyphId, OutlineBuilder};

use super::canvas::{Anchor, Style};
use super::clip::Position;

/// Both weights in which figures are written.
pub(super) struct Fonts {
    regular: Font,
    bold: Font,
}

impl Fonts {
    pub(super) fn parse() -> Result<Self, FaceParsingError> {
        Ok(Self {
            regular: Font::parse(
                include_bytes!(concat!(env!("OUT_DIR"), "/regular.ttf")),
                include!(concat!(env!("OUT_DIR"), "/regular.rs")),
            )?,
            bold: Font::parse(
                include_bytes!(concat!(env!("OUT_DIR"), "/bold.ttf")),
                include!(concat!(env!("OUT_DIR"), "/bold.rs")),
            )?,
        })
    }

    /// The outlines of a text, unless all of it is empty.
    pub(super) fn outline(&self, (x, y): Position, words: &str, style: Style) -> Option<Path> {
        let glyphs = words.chars().map(|letter| self.glyph(letter, style.bold));
        let scale = |face: &Face| f64::from(style.size) / f64::from(face.units_per_em());
        let advance = |(face, glyph): (&Face, GlyphId)| {
            scale(face) * f64::from(face.glyph_hor_advance(glyph).unwrap_or(0))
        };
        let before = match style.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        };
        let width: f64 = glyphs.clone().map(advance).sum();
        let mut letters = Letters {
            path: PathBuilder::new(),
            origin: ((x - before * width) as f32, y as f32),
            scale: 1.0,
        };
        for (face, glyph) in glyphs {
            letters.scale = scale(face) as f32;
            face.outline_glyph(glyph, &mut letters);
            letters.origin.0 += advance((face, glyph)) as f32;
        }
        letters.path.finish()
    }

    /// The glyph of a letter: a regular one where there is no bold one, and where there is neither, the sign of the
    /// font for what it lacks, which is its first.
    fn glyph(&self, letter: char, bold: bool) -> (&Face<'static>, GlyphId) {
        let fonts = [bold.then_some(&self.bold), Some(&self.regular)];
        let mut found = fonts
            .into_iter()
            .flatten()
            .filter_map(|font| font.glyph(letter));
        found.next().unwrap_or((&self.regular.face, GlyphId(0)))
    }
}

/// A font that has only the letters of figures, and by the number of each letter that of its glyph.
struct Font {
    face: Face<'static>,
    glyphs: &'static [(u32, u16)],
}

impl Font {
    fn parse(file: &'static [u8], glyphs: &'static [(u32, u16)]) -> Result<Self, FaceParsingError> {
        let face = Face::parse(file, 0)?;
        Ok(Self { face, glyphs })
    }

    fn glyph(&self, letter: char) -> Option<(&Face<'static>, GlyphId)> {
        let of_letter = |&(known, _): &(u32, u16)| known;
        let position = self
            .glyphs
            .binary_search_by_key(&u32::from(letter), of_letter)
            .ok()?;
        Some((&self.face, GlyphId(self.glyphs[position].1)))
    }
}

/// Outlines of letters, in the units of a font with its vertical axis upwards, as a path.
struct Letters {
    path: PathBuilder,
    origin: (f32, f32),
    scale: f32,
}

impl Letters {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (
            self.origin.0 + self.scale * x,
            self.origin.1 - self.scale * y,
        )
    }
}

impl OutlineBuilder for Letters {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2)) = (self.at(x1, y1), self.at(x2, y2));
        let (x, y) = self.at(x, y);
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;
    use crate::theme;

    /// A figure shows a box in place of a letter that its font lacks.
    #[test]
    fn the_fonts_have_the_letters_of_all_messages_and_the_signs_of_numbers() {
        let fonts = Fonts::parse().unwrap();
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("messages");
        let languages = fs::read_dir(folder).unwrap();
        let files = languages.flat_map(|language| fs::read_dir(language.unwrap().path()).unwrap());
        let texts = files.map(|file| fs::read_to_string(file.unwrap().path()).unwrap());
        let texts: Vec<String> = texts
            .chain(["−±×·⁻⁰¹²³⁴⁵⁶⁷⁸⁹µ°…ΔρσČЖ□".to_owned()])
            .collect();
        assert!(texts.len() > 4);
        let letters = texts.iter().flat_map(|text| text.chars());
        for letter in letters.filter(|letter| !letter.is_control()) {
            assert!(fonts.regular.glyph(letter).is_some(), "{letter:?}");
        }
        assert!(fonts.regular.glyph('漢').is_none());
    }

    #[test]
    fn letters_without_a_bold_form_are_regular() {
        let fonts = Fonts::parse().unwrap();
        let width = |words, bold| {
            let style = Style::new(16, theme::INK, Anchor::Start);
            let path = fonts.outline((0.0, 0.0), words, Style { bold, ..style });
            f64::from(path.unwrap().bounds().width())
        };
        assert!(width("Coefficient", true) > 1.05 * width("Coefficient", false));
        assert!((width("ЖΩ漢", true) - width("ЖΩ漢", false)).abs() < 1e-9);
    }
}
