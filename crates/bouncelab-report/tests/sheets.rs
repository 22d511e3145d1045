//! The lesson sheets: those in `docs/lessons` say what the program computes, those of a page have its address.

use std::fs;
use std::path::Path;

use bouncelab_report::link::DropLink;
use bouncelab_report::messages::{Translator, languages};
use bouncelab_report::sheets::Sheet;

#[test]
fn the_sheets_are_those_of_this_program() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/lessons");
    for (name, translator, sheet) in all() {
        let written = fs::read_to_string(folder.join(&name)).unwrap_or_default();
        assert!(
            written == sheet.html(None, &translator).unwrap(),
            "{name} is old: cargo run -p bouncelab-report --example sheets -- docs/lessons"
        );
    }
}

#[test]
fn the_first_page_has_the_address_and_all_work_of_the_pupils_and_no_results() {
    let page = DropLink {
        address: "https://school.example/#lab?balls=tennis".to_owned(),
        modules: 21,
        path: "M0 0h1v1h-1z".to_owned(),
    };
    for (name, translator, sheet) in all() {
        let html = sheet.html(Some(&page), &translator).unwrap();
        let text = sheet.markdown(Some(&page), &translator).unwrap();
        let text = text.replace('\\', "");
        for (form, content) in [("HTML", html), ("Markdown", text)] {
            let of_teacher = translator.text("sheet-teacher");
            let (pupils, teacher) = content.split_once(&of_teacher).unwrap();
            let headings = ["sheet-work", "sheet-talk"].map(|id| translator.text(id));
            for part in headings.iter().chain([&page.address]) {
                assert!(pupils.contains(part), "{name}, {form}: {part}");
            }
            let expected = translator.text("sheet-expected");
            assert!(teacher.contains(&expected) && !pupils.contains(&expected));
            assert!(
                !content.contains("sheet-"),
                "{name}, {form}: a message is missing"
            );
        }
    }
}

/// Each sheet in each language, with the name of its file.
fn all() -> impl Iterator<Item = (String, Translator, Sheet)> {
    languages().flat_map(|language| {
        Sheet::ALL.map(|sheet| {
            let translator = Translator::new(language).unwrap();
            (
                format!("{}.{language}.html", sheet.name()),
                translator,
                sheet,
            )
        })
    })
}
