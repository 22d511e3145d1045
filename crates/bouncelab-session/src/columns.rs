//! The tables of a session: [the columns of drops and impacts](bouncelab_report::columns), with what was noted and
//! what only many drops have.

#![expect(
    clippy::type_complexity,
    reason = "an alias would fix the lifetime of the rows"
)]

use std::collections::{BTreeMap, BTreeSet};
use std::iter;
use std::path::{Path, PathBuf};

use bouncelab::groups::Study;
use bouncelab::inference::Measured;
use bouncelab::{Diagnostic, Estimate, Options};
use bouncelab_report::columns::{DropRecord, ENGLISH, TableKind, WHICH, sentences};
use bouncelab_report::data_table::{Cell, Column, DataTable, Definition, Kind, cells, columns};
use bouncelab_report::define_columns;
use bouncelab_report::file::Outputs;

use crate::error::Result;
use crate::journal::Key;
use crate::metadata::{KnownRecording, Metadata};
use crate::record::Record;
use crate::results::Results;
use crate::study::{Outcome, left_out};
use crate::table::{Form, Schema, TableWriter};

/// What the columns of a session are made from.
struct DropRow<'a> {
    recording: &'a KnownRecording,
    key: &'a Key,
    record: &'a DropRecord,
    of_recording: &'a [Diagnostic],
    by_hand: bool,
    outlier_score: Option<f64>,
    compared: Option<Compared>,
}

/// A drop as the study compares it.
#[derive(Clone, Copy)]
struct Compared {
    speed_m_s: f64,
    restitution: Option<Measured>,
    shared_sd: Option<f64>,
    height_m: Option<Estimate>,
}

impl DropRow<'_> {
    fn metadata(&self) -> &Metadata {
        &self.recording.metadata
    }

    fn options(&self) -> &Options {
        self.recording.options()
    }

    /// The cells of the table of drops behind those that say which drop it is.
    fn cells(&self) -> Vec<Cell> {
        let of_drop = TableKind::Drops.rows(self.record).into_iter().flatten();
        of_drop.chain(cells(IN_A_SESSION, self)).collect()
    }
}

/// What a session adds to a drop: how it was analysed, what was noted, and its comparison with the others.
const IN_A_SESSION: &[Definition<fn(&DropRow<'_>) -> Cell>] = define_columns! { |row: DropRow<'_>|
    recording_diagnostics: Text [""] "warnings on the recording" = sentences(row.of_recording);
    ball_mass_kg: Number ["kg"] "mass of the ball, as noted or by its rules"
        = Some(row.options().ball.mass_kg());
    ball_diameter_m: Number ["m"] "diameter of the ball" = Some(row.options().ball.diameter_m());
    air_density_kg_m3: Number ["kg/m3"] "density of the air"
        = Some(row.options().environment.air.density_kg_m3());
    settings_gravity_m_s2: Number ["m/s2"] "gravity, as noted or assumed" = Some(row.options().environment.gravity_m_s2);
    noted_height_m: Number ["m"] "drop height as noted" = row.metadata().height_m;
    noted_temperature_k: Number ["K"] "temperature as noted" = row.metadata().temperature_k;
    content_sha256: Text [""] "hash of the recording" = Some(row.key.content.to_string());
    settings_sha256: Text [""] "hash of the settings" = Some(row.key.settings.to_string());
    common_speed_m_s: Number ["m/s"] "impact speed at which the drops of the session are compared"
        = Some(row.compared?.speed_m_s);
    common_restitution: Number [""] "restitution at the common speed, by the curve of its group and its own level"
        = Some(row.compared?.restitution?.value);
    common_restitution_own_sd: Number [""] "its standard uncertainty from this drop alone"
        = Some(row.compared?.restitution?.sd);
    common_restitution_shared_sd: Number [""] "standard uncertainty of its group that all drops share"
        = row.compared?.shared_sd;
    common_drop_height_m: Number ["m"] "drop height by the curve of its group"
        = Some(row.compared?.height_m?.value);
    common_drop_height_sd_m: Number ["m"] "its standard uncertainty" = Some(row.compared?.height_m?.sd);
    outlier_score: Number [""] "distance from its group, in robust standard deviations; empty unless it is an outlier"
        = row.outlier_score;
    left_out: Text [""] "why it is not in the study; empty if it is"
        = left_out(row.record, row.by_hand, &ENGLISH);
};

/// The columns of both tables behind the given ones.
fn columns_behind(head: &[Column]) -> [Vec<Column>; 2] {
    [
        [head, &TableKind::Drops.columns(), &columns(IN_A_SESSION)].concat(),
        [head, &TableKind::Impacts.columns()].concat(),
    ]
}

/// The columns of the tables of a session.
fn columns_of(results: &Results<'_>) -> [Vec<Column>; 2] {
    columns_behind(&[columns(WHICH), noted(&fields(results))].concat())
}

/// What was noted of some recording.
fn fields<'a>(results: &Results<'a>) -> BTreeSet<&'a String> {
    let recordings = results.recordings.iter();
    recordings
        .flat_map(|recording| recording.metadata.factors.keys())
        .collect()
}

/// Writes the tables of drops and impacts into a folder, one recording after the other; returns the
/// files. Sentences in them are English, whatever the language of the reader: tables are for programs.
///
/// # Errors
/// [`Error::Output`](crate::Error::Output) and [`Error::Table`](crate::Error::Table) if they cannot be
/// written, and those of [`Results::each`].
pub fn write_tables(
    outcome: &Outcome<'_>,
    results: &Results<'_>,
    folder: &Path,
    forms: &[Form],
    outputs: &Outputs,
) -> Result<Vec<PathBuf>> {
    let [of_drops, of_impacts] = columns_of(results);
    let writer = |kind: TableKind, columns| {
        let schema = Schema {
            name: kind.name(),
            schema: kind.schema(),
            version: env!("CARGO_PKG_VERSION"),
            columns,
        };
        TableWriter::new(folder, &schema, forms, outputs)
    };
    let mut drops = writer(TableKind::Drops, of_drops)?;
    let mut impacts = writer(TableKind::Impacts, of_impacts)?;
    each_row(
        outcome,
        results,
        |row| drops.row(&row),
        |row| impacts.row(&row),
    )?;
    Ok([drops.finish()?, impacts.finish()?].concat())
}

/// The tables of drops and impacts that [`write_tables`] writes, in memory.
///
/// # Errors
/// Those of [`Results::each`].
pub fn tables(outcome: &Outcome<'_>, results: &Results<'_>) -> Result<[DataTable; 2]> {
    let [mut drops, mut impacts] = columns_of(results).map(DataTable::new);
    let take = |table: &mut DataTable, row| {
        table.rows.push(row);
        Ok(())
    };
    each_row(
        outcome,
        results,
        |row| take(&mut drops, row),
        |row| take(&mut impacts, row),
    )?;
    Ok([drops, impacts])
}

/// Hands on every row of both tables, one recording after the other.
fn each_row(
    outcome: &Outcome<'_>,
    results: &Results<'_>,
    mut of_drop: impl FnMut(Vec<Cell>) -> Result<()>,
    mut of_impact: impl FnMut(Vec<Cell>) -> Result<()>,
) -> Result<()> {
    let fields = fields(results);
    let study = outcome.groups.study.as_ref().ok();
    let scores = outcome.outlier_scores();
    let studied: BTreeMap<usize, usize> = iter::zip(outcome.studied.iter().copied(), 0..).collect();
    let has_drops = |place: usize| !outcome.drops_of(place).is_empty();
    results.each(has_drops, |place, key, record| {
        let recording = &results.recordings[place];
        for (place, drop_record) in iter::zip(outcome.drops_of(place), &record.drops) {
            let drop = &outcome.drops[place];
            let factor =
                |field: &&String| Cell::Text(recording.metadata.factors.get(*field).cloned());
            let which = cells(WHICH, &(recording.name(), drop.number));
            let head = [which, fields.iter().map(factor).collect()].concat();
            let row = DropRow {
                recording,
                key,
                record: drop_record,
                of_recording: &record.diagnostics,
                by_hand: drop.by_hand,
                outlier_score: scores.get(&place).copied(),
                compared: study.and_then(|study| compared(study, *studied.get(&place)?)),
            };
            of_drop([head.clone(), row.cells()].concat())?;
            for impact in TableKind::Impacts.rows(drop_record) {
                of_impact([head.clone(), impact].concat())?;
            }
        }
        Ok(())
    })
}

/// A drop of a study, by its index there.
fn compared(study: &Study, drop: usize) -> Option<Compared> {
    let fitted = study.drops[drop]?;
    Some(Compared {
        speed_m_s: study.at_speed_m_s,
        restitution: study.restitution_of(drop),
        shared_sd: study.groups[fitted.group].shared_sd,
        height_m: fitted.height_m,
    })
}

/// The tables of drops and impacts of one recording, with the columns of those of a session but for its name
/// and what was noted. What takes other recordings is empty.
pub(crate) fn tables_of_one(
    recording: &KnownRecording,
    key: &Key,
    record: &Record,
) -> [DataTable; 2] {
    let [mut drops, mut impacts] = empty_tables_of_one();
    for (number, drop_record) in (1..).zip(&record.drops) {
        let row = DropRow {
            recording,
            key,
            record: drop_record,
            of_recording: &record.diagnostics,
            by_hand: false,
            outlier_score: None,
            compared: None,
        };
        let head = cells(NUMBER, &(recording.name(), number));
        drops.rows.push([head.clone(), row.cells()].concat());
        let of_impacts = TableKind::Impacts.rows(drop_record).into_iter();
        impacts
            .rows
            .extend(of_impacts.map(|impact| [head.clone(), impact].concat()));
    }
    [drops, impacts]
}

/// The column that says which drop of a recording it is.
const NUMBER: &[Definition<fn(&(&str, usize)) -> Cell>] = WHICH.split_at(1).1;

/// The same without rows.
pub(crate) fn empty_tables_of_one() -> [DataTable; 2] {
    columns_behind(&columns(NUMBER)).map(DataTable::new)
}

/// The columns of what was noted.
fn noted(fields: &BTreeSet<&String>) -> Vec<Column> {
    let taken = columns_behind(&columns(WHICH)).concat();
    let column = |field: &&String| Column {
        // A note may be called like a result.
        name: if taken.iter().any(|column| column.name == **field) {
            format!("noted_{field}").into()
        } else {
            (*field).clone().into()
        },
        kind: Kind::Text,
        unit: "".into(),
        about: format!("{field} as noted").into(),
    };
    fields.iter().map(column).collect()
}
