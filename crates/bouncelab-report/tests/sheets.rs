//! The lesson sheets in `docs/lessons` say what the program computes.

use std::fs;
use std::path::Path;

use bouncelab_report::messages::{Translator, languages};
use bouncelab_report::sheets::{STYLE, Sheet, style};

#[test]
fn the_sheets_are_those_of_this_program() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/lessons");
    let check = |name: &str, content: String| {
        let written = fs::read_to_string(folder.join(name)).unwrap_or_default();
        assert!(
            written == content,
            "{name} is old: cargo run -p bouncelab-report --example sheets -- docs/lessons"
        );
    };
    check(STYLE, style());
    for language in languages() {
        let translator = Translator::new(language).unwrap();
        for sheet in Sheet::ALL {
            let name = format!("{}.{language}.html", sheet.name());
            check(&name, sheet.html(&translator).unwrap());
        }
    }
}
