//! The table of impacts that the page saves.

use bouncelab::analysis::{ListOrigin, Source};
use bouncelab::settings::Settings;
use bouncelab::{Options, analyze_times};
use bouncelab_report::messages::Translator;
use bouncelab_wasm::analyst::Analyst;
use bouncelab_wasm::wire::{AnalysisRequest, DropMarks};

/// The name of a file may come from another person.
#[test]
fn no_spreadsheet_runs_the_name_of_a_recording() {
    let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568];
    let result = analyze_times(&times_s, &Options::default().without_inference());
    let request = AnalysisRequest {
        name: "=HYPERLINK(\"x\")".to_owned(),
        source: Source::Times(ListOrigin::default()),
        strongest_band: None,
        diagnostics: Vec::new(),
        no_drop: None,
        candidates: Vec::new(),
        drops: vec![DropMarks {
            impacts: result.drops[0].impacts.clone(),
            probability: 1.0,
            edited: false,
        }],
        settings: Settings::default(),
        inference: false,
    };
    let translator = Translator::english();
    let csv = Analyst::default()
        .analyse(&request, &translator)
        .unwrap()
        .csv();
    let rows: Vec<&str> = csv.lines().skip(1).collect();
    assert_eq!(rows.len(), times_s.len());
    for row in rows {
        assert!(row.starts_with("\"'=HYPERLINK"), "{row}");
    }
}
