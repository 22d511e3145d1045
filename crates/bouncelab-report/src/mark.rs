//! The mark of figures and reports, where it is not seen: files that have it may be replaced.
//!
//! Each kind of file has it at a place of its own, so that a text about bouncelab is not taken for one of its
//! files: a mark with a `^` in front is the beginning of the file, another is near one of its ends.

/// What the mark says.
pub(crate) const MARK: &str = "made by bouncelab";

/// In a page.
pub const HTML: &str = r#"<meta name="generator" content="made by bouncelab"#;
/// In a report for a notebook.
pub const MARKDOWN: &str = "<!-- made by bouncelab -->";
/// In a figure.
pub const SVG: &str = "<metadata>made by bouncelab</metadata>";
/// In a picture.
pub const PNG: &str = "tEXtSoftware\0made by bouncelab";
/// In a figure for print.
pub const PDF: &str = "/Producer (made by bouncelab)";
/// In the data of a figure.
pub const DATA: &str = "^panel,x_axis,y_axis,layer,kind,";
/// In a figure, by the ending of its file.
pub const FIGURES: [(&str, &str); 3] = [("svg", SVG), ("png", PNG), ("pdf", PDF)];
/// The first line of a page of the manual.
pub const MANUAL: &str = ".\\\" made by bouncelab";
