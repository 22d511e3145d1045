//! Sheets and archives with lists of times, made here in the layout of phyphox.

use std::io::{Cursor, Write};

use bouncelab_audio::{Input, times};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// The events of a run.
const TIMES_S: [f64; 5] = [0.8, 1.4, 1.94, 2.426, 2.8634];

/// A table: its name, and its rows of cells.
type Table = (&'static str, Vec<Vec<String>>);

fn texts(cells: &[&str]) -> Vec<String> {
    cells.iter().map(|&cell| cell.to_owned()).collect()
}

fn numbers(cells: &[f64]) -> Vec<String> {
    cells.iter().map(f64::to_string).collect()
}

/// The tables of the acoustic stopwatch.
fn stopwatch() -> Vec<Table> {
    let stops = ["Start (s)", "Stop 1 (s)", "Stop 2 (s)"];
    let mut all = vec![texts(&["Event time (s)", "Interval (s)"])];
    all.extend(
        TIMES_S
            .windows(2)
            .map(|pair| numbers(&[pair[0], pair[1] - pair[0]])),
    );
    vec![
        (
            "Simple",
            vec![
                texts(&["Start (s)", "Stop (s)", "Difference (s)"]),
                numbers(&[0.8, 1.4, 0.6]),
            ],
        ),
        ("Multiple", vec![texts(&stops), numbers(&TIMES_S[..3])]),
        ("All", all),
        (
            "Metadata Device",
            vec![
                texts(&["property", "value"]),
                texts(&["deviceModel", "Seven"]),
                texts(&["deviceBrand", "Acme"]),
            ],
        ),
        (
            "Metadata Time",
            vec![
                texts(&[
                    "event",
                    "experiment time",
                    "system time",
                    "system time text",
                ]),
                texts(&["START", "0", "1700000000", "2023-11-14 23:13:20"]),
            ],
        ),
    ]
}

fn zip(files: &[(String, String)]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in files {
        writer
            .start_file(name, SimpleFileOptions::default())
            .unwrap();
        writer.write_all(content.as_bytes()).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// An archive of texts; cells are quoted if they are words.
fn archive(tables: &[Table], separator: &str, point: char) -> Vec<u8> {
    let cell = |cell: &String| match cell.parse::<f64>() {
        Ok(number) => format!("{number:.9E}").replace('.', &point.to_string()),
        Err(_) => format!("\"{cell}\""),
    };
    let files = tables.iter().map(|(name, rows)| {
        let name = match *name {
            "Metadata Device" => "meta/device".to_owned(),
            "Metadata Time" => "meta/time".to_owned(),
            name => name.to_owned(),
        };
        let rows = rows
            .iter()
            .map(|row| row.iter().map(cell).collect::<Vec<_>>().join(separator) + "\n");
        (name + ".csv", rows.collect())
    });
    zip(&files.collect::<Vec<_>>())
}

/// A minimal Office Open XML workbook with texts in its cells (ECMA-376, part 1, 18.3).
fn xlsx(tables: &[Table]) -> Vec<u8> {
    let types = "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"/>";
    let relations = |body: String| {
        format!(
            "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">{body}</Relationships>"
        )
    };
    let kind = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let sheets = |each: &dyn Fn(usize, &str) -> String| {
        tables
            .iter()
            .enumerate()
            .map(|(index, (name, _))| each(index + 1, name))
            .collect::<String>()
    };
    let book = format!(
        "<workbook xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\" xmlns:r=\"{kind}\"><sheets>{}</sheets></workbook>",
        sheets(&|n, name| format!("<sheet name=\"{name}\" sheetId=\"{n}\" r:id=\"r{n}\"/>"))
    );
    let mut files = vec![
        ("[Content_Types].xml".to_owned(), types.to_owned()),
        (
            "_rels/.rels".to_owned(),
            relations(format!(
                "<Relationship Id=\"b\" Type=\"{kind}/officeDocument\" Target=\"xl/workbook.xml\"/>"
            )),
        ),
        ("xl/workbook.xml".to_owned(), book),
        (
            "xl/_rels/workbook.xml.rels".to_owned(),
            relations(sheets(&|n, _| {
                format!(
                    "<Relationship Id=\"r{n}\" Type=\"{kind}/worksheet\" Target=\"worksheets/{n}.xml\"/>"
                )
            })),
        ),
    ];
    for (index, (_, rows)) in tables.iter().enumerate() {
        let cell = |cell: &String| match cell.parse::<f64>() {
            Ok(number) => format!("<c><v>{number}</v></c>"),
            Err(_) => format!("<c t=\"inlineStr\"><is><t>{cell}</t></is></c>"),
        };
        let row = |row: &Vec<String>| {
            [
                "<row>".to_owned(),
                row.iter().map(cell).collect(),
                "</row>".to_owned(),
            ]
            .concat()
        };
        let rows: String = rows.iter().map(row).collect();
        let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
        files.push((
            format!("xl/worksheets/{}.xml", index + 1),
            format!("<worksheet xmlns=\"{main}\"><sheetData>{rows}</sheetData></worksheet>"),
        ));
    }
    zip(&files)
}

/// A minimal `OpenDocument` spreadsheet, with the empty rows and columns that `LibreOffice` adds (version 1.3, part 3, 9).
fn ods(tables: &[Table]) -> Vec<u8> {
    let cell = |cell: &String| match cell.parse::<f64>() {
        Ok(number) => format!(
            "<table:table-cell office:value-type=\"float\" office:value=\"{number}\"><text:p>{number:.1}</text:p></table:table-cell>"
        ),
        Err(_) => format!("<table:table-cell><text:p>{cell}</text:p></table:table-cell>"),
    };
    let row = |row: &Vec<String>| {
        let cells: String = row.iter().map(cell).collect();
        format!(
            "<table:table-row>{cells}<table:table-cell table:number-columns-repeated=\"16380\"/></table:table-row>"
        )
    };
    let tables = tables.iter().map(|(name, rows)| {
        let rows: String = rows.iter().map(row).collect();
        format!(
            "<table:table table:name=\"{name}\">{rows}<table:table-row table:number-rows-repeated=\"1048570\"><table:table-cell/></table:table-row></table:table>"
        )
    });
    let tables: String = tables.collect();
    zip(&[(
        "content.xml".to_owned(),
        format!("<office:document-content>{tables}</office:document-content>"),
    )])
}

/// A minimal workbook of records (MS-XLS, 2.4): start of the book, names of the sheets, shared texts, sheets.
fn xls(tables: &[Table]) -> Vec<u8> {
    let words = |words: &[u16]| {
        words
            .iter()
            .flat_map(|word| word.to_le_bytes())
            .collect::<Vec<u8>>()
    };
    let record =
        |kind: u16, data: &[u8]| [words(&[kind, data.len() as u16]), data.to_vec()].concat();
    let text = |text: &str, length: Vec<u8>| [length, vec![0], text.as_bytes().to_vec()].concat();
    let start = |kind| record(0x0809, &words(&[0x0600, kind, 0, 0, 0, 0, 0, 0]));
    let mut shared: Vec<&str> = Vec::new();
    let mut sheets = Vec::new();
    for (_, rows) in tables {
        let mut sheet = start(0x0010);
        for (row, cells) in rows.iter().enumerate() {
            for (column, cell) in cells.iter().enumerate() {
                let place = words(&[row as u16, column as u16, 0]);
                if let Ok(number) = cell.parse::<f64>() {
                    sheet.extend(record(
                        0x0203,
                        &[place, number.to_le_bytes().to_vec()].concat(),
                    ));
                } else {
                    let index = (shared.len() as u32).to_le_bytes().to_vec();
                    sheet.extend(record(0x00fd, &[place, index].concat()));
                    shared.push(cell);
                }
            }
        }
        sheet.extend(record(0x000a, &[]));
        sheets.push(sheet);
    }
    let count = (shared.len() as u32).to_le_bytes();
    let mut strings = [count, count].concat();
    for shared in shared {
        strings.extend(text(shared, (shared.len() as u16).to_le_bytes().to_vec()));
    }
    let named = |at: usize, name: &str| {
        let head = [(at as u32).to_le_bytes().to_vec(), vec![0, 0]].concat();
        record(0x0085, &[head, text(name, vec![name.len() as u8])].concat())
    };
    let globals = |places: &[usize]| {
        let names = places
            .iter()
            .zip(tables)
            .flat_map(|(at, (name, _))| named(*at, name));
        [
            start(0x0005),
            names.collect(),
            record(0x00fc, &strings),
            record(0x000a, &[]),
        ]
        .concat()
    };
    let first = globals(&vec![0; tables.len()]).len();
    let places: Vec<usize> = sheets
        .iter()
        .scan(first, |at, sheet| {
            *at += sheet.len();
            Some(*at - sheet.len())
        })
        .collect();
    compound(&[globals(&places), sheets.concat()].concat())
}

/// A compound file with a workbook.
fn compound(book: &[u8]) -> Vec<u8> {
    let mut file = cfb::CompoundFile::create(Cursor::new(Vec::new())).unwrap();
    file.create_stream("/Workbook")
        .unwrap()
        .write_all(book)
        .unwrap();
    file.flush().unwrap();
    file.into_inner().into_inner()
}

fn refusal(content: &[u8], name: &str) -> String {
    times::parse(content, name).unwrap_err().to_string()
}

#[test]
fn the_fullest_table_of_a_stopwatch_is_read_from_every_form_of_export() {
    let tables = stopwatch();
    for (content, name) in [
        (archive(&tables, ",", '.'), "comma.zip"),
        (archive(&tables, ";", '.'), "semicolon.zip"),
        (archive(&tables, "\t", ','), "tabs.zip"),
        (xlsx(&tables), "drop.xlsx"),
        (ods(&tables), "drop.ods"),
        (xls(&tables), "drop.xls"),
        // The first bytes count, not the ending.
        (xlsx(&tables), "drop.csv"),
    ] {
        let list = times::parse(&content, name).unwrap();
        let nearly = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-8;
        assert!(
            list.times_s.len() == 5 && list.times_s.iter().zip(&TIMES_S).all(nearly),
            "{name}: {list:?}"
        );
        assert_eq!(
            list.origin.program.as_deref(),
            Some("phyphox acoustic stopwatch"),
            "{name}"
        );
        assert!(list.origin.by_threshold, "{name}");
        assert_eq!(list.origin.notes["device"], "Acme Seven", "{name}");
        assert_eq!(list.origin.notes["time"], "2023-11-14 23:13:20", "{name}");
    }
}

#[test]
fn a_sheet_with_a_title_and_notes_beside_the_times_is_read() {
    let rows = vec![
        texts(&["Golf ball, 80 cm"]),
        Vec::new(),
        texts(&["# of bounce", "Zeit t / ms"]),
        numbers(&[1.0, 100.5]),
        numbers(&[2.0, 450.0]),
    ];
    let notes = (
        "Notes",
        vec![texts(&["pupil", "class"]), texts(&["Ada", "7b"])],
    );
    let tables = [("Drop", rows), notes];
    for (content, name) in [
        (xlsx(&tables), "a.xlsx"),
        (ods(&tables), "a.ods"),
        (xls(&tables), "a.xls"),
    ] {
        assert_eq!(
            times::parse(&content, name).unwrap().times_s,
            [0.1005, 0.45],
            "{name}"
        );
    }
}

#[test]
fn a_waveform_in_an_archive_is_sound() {
    let rows = (0..480).map(|n| numbers(&[f64::from(n) / 48.0, f64::from(n % 7) - 3.0]));
    let rows = std::iter::once(texts(&["Time (ms)", "Recording (a.u.)"]))
        .chain(rows)
        .collect();
    let tables = [("Audio data", rows), stopwatch().remove(3)];
    for (content, name) in [
        (archive(&tables, ",", '.'), "scope.zip"),
        (xlsx(&tables), "scope.xlsx"),
    ] {
        let Ok(Input::Sound(sound)) = Input::from_bytes(content, name) else {
            panic!("{name} is no sound");
        };
        assert_eq!(sound.sample_rate_hz(), 48_000, "{name}");
    }
}

#[test]
fn wrong_and_mixed_files_are_refused_with_the_reason() {
    let mut mixed = stopwatch();
    mixed[1].1[1] = numbers(&[0.8, 1.5, 1.94]);
    for content in [xlsx(&mixed), xls(&mixed), archive(&mixed, ",", '.')] {
        let refused = refusal(&content, "mixed.zip");
        assert!(
            refused.contains("All")
                && refused.contains("Multiple")
                && refused.contains("different times"),
            "{refused}"
        );
    }
    let sound = zip(&[("a/drop.wav".to_owned(), "RIFF".to_owned())]);
    let refused = refusal(&sound, "class.zip");
    assert!(
        refused.contains("it holds: a/drop.wav") && refused.contains("with session"),
        "{refused}"
    );
    let headings = [("All", vec![texts(&["Event time (s)", "Interval (s)"])])];
    assert!(refusal(&xlsx(&headings), "a.xlsx").contains("there is no time in it"));
    let mut faulty = stopwatch();
    faulty[2].1[2][0] = "oops".to_owned();
    let refused = refusal(&xlsx(&faulty), "a.xlsx");
    assert!(
        refused.starts_with("a.xlsx (All), line 3: \"oops\""),
        "{refused}"
    );
}

/// A few bytes that stand for gigabytes.
#[test]
fn what_would_not_fit_into_memory_is_refused() {
    let zeros = vec![0; 30 << 20];
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for name in ["[Content_Types].xml", "a.csv"] {
        writer
            .start_file(name, SimpleFileOptions::default())
            .unwrap();
        writer.write_all(&zeros).unwrap();
    }
    assert!(
        refusal(&writer.finish().unwrap().into_inner(), "bomb.xlsx").contains("more than 24 MB")
    );
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for name in ["a.csv", "b.csv", "c.csv"] {
        writer
            .start_file(name, SimpleFileOptions::default())
            .unwrap();
        writer.write_all(&zeros).unwrap();
    }
    assert!(
        refusal(&writer.finish().unwrap().into_inner(), "bomb.zip").contains("more than 64 MB")
    );
    let content = "<o><table:table><table:table-row table:number-rows-repeated=\"1048576\"><table:table-cell \
                   table:number-columns-repeated=\"16384\" office:value=\"1\"><text:p>1</text:p></table:table-cell>\
                   </table:table-row></table:table></o>";
    let bomb = zip(&[("content.xml".to_owned(), content.to_owned())]);
    assert!(refusal(&bomb, "bomb.ods").contains("more than"));
    let far: Vec<Vec<String>> = (0..60_000)
        .map(|n| {
            if n % 59_999 == 0 {
                numbers(&[1.0; 200])
            } else {
                Vec::new()
            }
        })
        .collect();
    assert!(refusal(&xls(&[("far", far)]), "bomb.xls").contains("more than"));
}

#[test]
fn damaged_sheets_and_archives_do_not_panic() {
    let tables = stopwatch();
    for (content, name) in [
        (archive(&tables, ",", '.'), "a.zip"),
        (xlsx(&tables), "a.xlsx"),
        (ods(&tables), "a.ods"),
        (xls(&tables), "a.xls"),
    ] {
        for at in (0..content.len()).step_by(7) {
            let mut damaged = content.clone();
            damaged[at] ^= 0x55;
            if let Ok(list) = times::parse(&damaged, name) {
                assert!(
                    list.times_s.iter().all(|time_s| time_s.is_finite())
                        && list.times_s.is_sorted()
                );
            }
            drop(times::parse(&content[..at], name));
        }
    }
}
