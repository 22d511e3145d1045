//! Tables say the same in every form, and are whole or not there.

use std::fs::{self, File};
use std::path::Path;

use bouncelab_report::data_table::{Cell, Column, Kind};
use bouncelab_report::file::Outputs;
use bouncelab_session::table::{Form, Schema, TableWriter};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use tempfile::TempDir;

fn schema() -> Schema {
    let column = |name: &'static str, kind, unit: &'static str, about: &'static str| Column {
        name: name.into(),
        kind,
        unit: unit.into(),
        about: about.into(),
    };
    Schema {
        name: "drops",
        schema: "bouncelab.drops/2",
        version: "0.0.0",
        columns: vec![
            column("recording", Kind::Text, "", "the file"),
            column("height_m", Kind::Number, "m", "drop height"),
            column("impacts", Kind::Count, "", "how many"),
            column("converged", Kind::Flag, "", "whether"),
        ],
    }
}

fn rows() -> Vec<[Cell; 4]> {
    let row = |text: Option<&str>, number, count, flag| {
        [
            Cell::Text(text.map(str::to_owned)),
            Cell::Number(number),
            Cell::Count(count),
            Cell::Flag(flag),
        ]
    };
    vec![
        row(Some("a, \"b\".wav"), Some(0.1 + 0.2), Some(38), Some(true)),
        row(Some("ü\n.wav"), Some(f64::NAN), None, Some(false)),
        row(None, Some(-1e-300), Some(0), None),
    ]
}

fn write(folder: &Path, repeats: usize) -> Vec<std::path::PathBuf> {
    let mut writer = TableWriter::new(folder, &schema(), &Form::ALL, &Outputs::default()).unwrap();
    for _ in 0..repeats {
        for row in rows() {
            writer.row(&row).unwrap();
        }
    }
    writer.finish().unwrap()
}

#[test]
fn parquet_holds_every_cell_and_its_unit() {
    let folder = TempDir::new().unwrap();
    let files = write(folder.path(), 1);
    let reader = SerializedFileReader::new(File::open(&files[0]).unwrap()).unwrap();
    let about = reader.metadata().file_metadata();
    let value = |key: &str| {
        let entries = about.key_value_metadata().unwrap();
        let entry = entries.iter().find(|entry| entry.key == key).unwrap();
        entry.value.clone().unwrap()
    };
    assert_eq!(value("bouncelab.schema"), "bouncelab.drops/2");
    assert_eq!(value("bouncelab.units"), "{\"height_m\":\"m\"}");
    assert!(value("bouncelab.about").contains("drop height"));
    assert_eq!(about.created_by(), Some("bouncelab 0.0.0"));
    let found: Vec<Vec<Field>> = reader
        .get_row_iter(None)
        .unwrap()
        .map(|row| {
            row.unwrap()
                .into_columns()
                .into_iter()
                .map(|(_, f)| f)
                .collect()
        })
        .collect();
    let expected = vec![
        vec![
            Field::Str("a, \"b\".wav".to_owned()),
            Field::Double(0.1 + 0.2),
            Field::Long(38),
            Field::Bool(true),
        ],
        vec![
            Field::Str("ü\n.wav".to_owned()),
            Field::Null,
            Field::Null,
            Field::Bool(false),
        ],
        vec![
            Field::Null,
            Field::Double(-1e-300),
            Field::Long(0),
            Field::Null,
        ],
    ];
    assert_eq!(found, expected);
}

#[test]
fn text_forms_hold_the_same() {
    let folder = TempDir::new().unwrap();
    let files = write(folder.path(), 1);
    let mut reader = csv::Reader::from_path(&files[1]).unwrap();
    let records: Vec<Vec<String>> = reader
        .records()
        .map(|record| record.unwrap().iter().map(str::to_owned).collect())
        .collect();
    assert_eq!(
        records[0],
        ["a, \"b\".wav", "0.30000000000000004", "38", "true"]
    );
    assert_eq!(records[1], ["ü\n.wav", "", "", "false"]);
    assert_eq!(
        records[2][1].parse::<f64>().unwrap().to_bits(),
        (-1e-300_f64).to_bits()
    );
    let text = fs::read_to_string(&files[2]).unwrap();
    let lines: Vec<serde_json::Value> = text
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(lines[0]["height_m"], 0.1 + 0.2);
    assert!(lines[1]["height_m"].is_null() && lines[2]["recording"].is_null());
}

/// More rows than are held back at once; the same rows give the same bytes.
#[test]
fn long_tables_are_whole_and_repeatable() {
    let (one, two) = (TempDir::new().unwrap(), TempDir::new().unwrap());
    let files = write(one.path(), 15_000);
    let reader = SerializedFileReader::new(File::open(&files[0]).unwrap()).unwrap();
    assert_eq!(reader.metadata().file_metadata().num_rows(), 45_000);
    assert!(reader.metadata().num_row_groups() > 1);
    for (a, b) in files.iter().zip(write(two.path(), 15_000)) {
        assert_eq!(fs::read(a).unwrap(), fs::read(b).unwrap());
    }
}

#[test]
fn a_table_that_was_not_finished_leaves_nothing() {
    let folder = TempDir::new().unwrap();
    let mut writer =
        TableWriter::new(folder.path(), &schema(), &Form::ALL, &Outputs::default()).unwrap();
    writer.row(&rows()[0]).unwrap();
    assert!(
        writer
            .row(&rows()[0][..2])
            .unwrap_err()
            .to_string()
            .contains("2 cells")
    );
    drop(writer);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    assert!(
        TableWriter::new(
            &folder.path().join("nowhere"),
            &schema(),
            &Form::ALL,
            &Outputs::default()
        )
        .is_err()
    );
}
