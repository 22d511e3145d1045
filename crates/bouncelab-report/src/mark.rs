//! Marks that identify files of bouncelab, which may be replaced.
//!
//! Each kind of file has its mark where it is not seen, and at a position of its own, so that a text about bouncelab is
//! not taken for one of its files.

/// What identifies the files of one kind.
///
/// ```
/// use bouncelab_report::mark::Mark;
///
/// // A table that begins with two columns and has a third.
/// const TABLE: Mark = Mark::first("drop,impact,").and_near_an_end(",restitution,");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mark {
    pub(crate) first: &'static str,
    pub(crate) near_an_end: &'static str,
}

impl Mark {
    /// That of no file: none is replaced unasked.
    pub const NONE: Self = Self::first("");

    /// How the file begins.
    pub const fn first(text: &'static str) -> Self {
        Self {
            first: text,
            near_an_end: "",
        }
    }

    /// A text within 4 kB of one of its ends.
    pub const fn near_an_end(text: &'static str) -> Self {
        Self::NONE.and_near_an_end(text)
    }

    /// The text near an end of the file.
    pub const fn text(&self) -> &'static str {
        self.near_an_end
    }

    /// The same, of files that have this within 4 kB of one of their ends too.
    #[must_use]
    pub const fn and_near_an_end(self, text: &'static str) -> Self {
        Self {
            near_an_end: text,
            ..self
        }
    }
}

/// The text of most marks.
pub(crate) const MARK: &str = "made by bouncelab";

/// A comment in a report for a notebook.
pub(crate) const COMMENT: &str = "<!-- made by bouncelab -->";
/// The first line of a page of the manual.
pub const MANUAL_LINE: &str = ".\\\" made by bouncelab";

/// That of a page.
pub const HTML: Mark = Mark::near_an_end(r#"<meta name="generator" content="made by bouncelab"#);
/// That of a report for a notebook.
pub const MARKDOWN: Mark = Mark::near_an_end(COMMENT);
/// That of a figure.
pub const SVG: Mark = Mark::near_an_end("<metadata>made by bouncelab</metadata>");
/// That of a picture.
pub const PNG: Mark = Mark::near_an_end("tEXtSoftware\0made by bouncelab");
/// That of a figure for print.
pub const PDF: Mark = Mark::near_an_end("/Producer (made by bouncelab)");
/// That of the data of a figure.
pub const DATA: Mark = Mark::first("panel,x_axis,y_axis,layer,kind,");
/// Those of figures, by the ending of the file.
pub const FIGURES: [(&str, Mark); 3] = [("svg", SVG), ("png", PNG), ("pdf", PDF)];
/// That of a page of the manual.
pub const MANUAL: Mark = Mark::first(MANUAL_LINE);

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;

    #[test]
    fn the_mark_is_where_the_format_has_it() {
        const FIRST: Mark = Mark::first("recording,drop,");
        const BOTH: Mark = FIRST.and_near_an_end(",restitution_sd,");
        let table = b"recording,drop,height,restitution_sd,remarks\n".to_vec();
        let long = [table.clone(), vec![b'x'; 10_000]].concat();
        for (content, mark, own) in [
            (table.clone(), FIRST, true),
            (table.clone(), BOTH, true),
            (long, BOTH, true),
            (b"recording,drop,time".to_vec(), BOTH, false),
            ([b" ", &table[..]].concat(), FIRST, false),
            ([&[b'x'; 9_000], &table[..]].concat(), FIRST, false),
            (table.repeat(1_000), FIRST, true),
            (COMMENT.repeat(1_000).into_bytes(), MARKDOWN, true),
            (table, Mark::NONE, false),
            (
                [&[b'x'; 9_000][..], COMMENT.as_bytes()].concat(),
                MARKDOWN,
                true,
            ),
            (
                [COMMENT.as_bytes(), &[b'x'; 9_000]].concat(),
                MARKDOWN,
                true,
            ),
            (vec![b'x'; 9_000], MARKDOWN, false),
            (b"made by bouncelab".to_vec(), MARKDOWN, false),
        ] {
            let mut file = tempfile::tempfile().unwrap();
            file.write_all(&content).unwrap();
            assert_eq!(mark.is_in(&file).unwrap(), own, "{mark:?}");
        }
    }
}
