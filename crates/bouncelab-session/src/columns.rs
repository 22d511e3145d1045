//! The columns of the tables of a session and of one recording.

#![expect(
    clippy::type_complexity,
    reason = "an alias would fix the lifetime of the rows"
)]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use bouncelab::analysis::MeasuredFlight;
use bouncelab::groups::CurvePoint;
use bouncelab::restitution::ImpactRestitution;
use bouncelab::{Diagnostic, Options};
use bouncelab_report::file::Outputs;
use bouncelab_report::messages::Translator;

use crate::error::Result;
use crate::journal::Key;
use crate::metadata::{KnownRecording, Metadata};
use crate::record::{DropRecord, FitRecord, ImpactRecord, PosteriorRecord, Record};
use crate::results::Results;
use crate::study::{Outcome, SessionDrop, left_out};
use crate::table::{Cell, Column, Form, Kind, Schema, Table, TableWriter};

/// Of which drop a row is.
#[derive(Clone, Copy)]
struct Which<'a> {
    recording: &'a KnownRecording,
    drop: &'a SessionDrop,
}

/// What the other cells of a row of `drops` are made from.
struct DropRow<'a> {
    of: Which<'a>,
    key: &'a Key,
    record: &'a DropRecord,
    of_recording: &'a [Diagnostic],
    translator: &'a Translator,
    outlier_score: Option<f64>,
    common_speed_m_s: Option<f64>,
}

impl DropRow<'_> {
    fn metadata(&self) -> &Metadata {
        &self.of.recording.metadata
    }

    fn options(&self) -> &Options {
        self.of.recording.options()
    }

    /// The cells behind those that say which drop it is.
    fn cells(&self) -> Vec<Cell> {
        [
            cells(SETTINGS, self),
            cells(OF_A_DROP, self.record),
            cells(COMPARED, self),
            cells(MORE_OF_A_DROP, self.record),
            cells(REMARKS, self),
        ]
        .concat()
    }

    fn common(&self) -> Option<CurvePoint> {
        self.record
            .posterior
            .as_ref()?
            .curve
            .at(self.common_speed_m_s?)
    }

    /// The sentences of diagnostics, if there are any.
    fn sentences(&self, diagnostics: &[Diagnostic]) -> Option<String> {
        let sentences = diagnostics.iter().map(|it| self.translator.diagnostic(it));
        (!diagnostics.is_empty()).then(|| self.translator.in_one_line(sentences))
    }
}

impl DropRecord {
    fn known(&self) -> Option<&PosteriorRecord> {
        self.posterior.as_ref()
    }

    fn fit(&self) -> Option<&FitRecord> {
        self.log_linear_fit.as_ref()
    }
}

impl ImpactRecord {
    fn kept(&self) -> Option<&ImpactRestitution> {
        self.restitution.as_ref()
    }

    fn after(&self) -> Option<&MeasuredFlight> {
        self.flight.as_ref()
    }
}

/// A column that every session has: name, kind, unit, meaning, and its cell in a row.
type Fixed<C> = (&'static str, Kind, &'static str, &'static str, C);

/// Columns, one a line: the value is an `Option`, and may use `?`.
macro_rules! columns {
    (|$row:ident: $type:ty| $($name:ident: $kind:ident [$unit:literal] $about:literal = $value:expr;)*) => {
        &[$((stringify!($name), Kind::$kind, $unit, $about, |$row: &$type| {
            let value = || $value;
            Cell::$kind(value())
        })),*]
    };
}

const WHICH: &[Fixed<fn(&Which<'_>) -> Cell>] = columns! { |row: Which<'_>|
    recording: Text [""] "file, relative to the folder of the session"
        = Some(row.recording.name().to_owned());
    drop: Count [""] "number of the drop in its recording, 1 for the first" = Some(row.drop.number);
};

/// What was noted of a drop, and what it was analysed with.
const SETTINGS: &[Fixed<fn(&DropRow<'_>) -> Cell>] = columns! { |row: DropRow<'_>|
    noted_height_m: Number ["m"] "drop height as noted" = row.metadata().height_m;
    noted_temperature_k: Number ["K"] "temperature as noted" = row.metadata().temperature_k;
    ball_mass_kg: Number ["kg"] "mass of the ball, as noted or by its rules"
        = Some(row.options().ball.mass_kg());
    ball_diameter_m: Number ["m"] "diameter of the ball" = Some(row.options().ball.diameter_m());
    air_density_kg_m3: Number ["kg/m3"] "density of the air"
        = Some(row.options().environment.air.density_kg_m3());
    gravity_m_s2: Number ["m/s2"] "gravity" = Some(row.options().environment.gravity_m_s2);
    content_sha256: Text [""] "hash of the recording" = Some(row.key.content.to_string());
    settings_sha256: Text [""] "hash of the settings" = Some(row.key.settings.to_string());
};

/// The columns of a drop, up to its restitution.
const OF_A_DROP: &[Fixed<fn(&DropRecord) -> Cell>] = columns! { |row: DropRecord|
    start_s: Number ["s"] "time of the first impact detected" = Some(row.impacts.first()?.impact.time_s);
    impacts: Count [""] "impacts detected" = Some(row.impacts.len());
    probability: Number [""] "that it is a drop" = Some(row.probability);
    speed_m_s: Number ["m/s"] "impact speed of `restitution`: the middle of this drop"
        = Some(row.known()?.at_speed_m_s);
    restitution: Number [""] "restitution at that speed, by the inference"
        = Some(row.known()?.restitution.value);
    restitution_sd: Number [""] "its standard uncertainty" = row.known()?.restitution.known_sd();
};

/// What a drop says at the speed at which all are compared.
const COMPARED: &[Fixed<fn(&DropRow<'_>) -> Cell>] = columns! { |row: DropRow<'_>|
    common_speed_m_s: Number ["m/s"] "impact speed at which the drops of the session are compared"
        = row.common_speed_m_s;
    common_restitution: Number [""] "restitution at the common speed" = Some(row.common()?.value);
    common_restitution_own_sd: Number [""] "its standard uncertainty by what is this drop's own"
        = Some(row.common()?.own_sd);
    common_restitution_shared_sd: Number [""] "its standard uncertainty by inputs that drops share"
        = Some(row.common()?.shared_sd);
};

/// What else a drop says of itself.
const MORE_OF_A_DROP: &[Fixed<fn(&DropRecord) -> Cell>] = columns! { |row: DropRecord|
    drop_height_m: Number ["m"] "height of the fall, by the inference"
        = Some(row.known()?.drop_height_m.value);
    drop_height_sd_m: Number ["m"] "its standard uncertainty" = row.known()?.drop_height_m.known_sd();
    drag_coefficient: Number [""] "drag coefficient at the fastest impact"
        = Some(row.known()?.drag_coefficient?.value);
    drag_coefficient_sd: Number [""] "its standard uncertainty" = row.known()?.drag_coefficient?.known_sd();
    scatter: Number [""] "standard deviation of ln e from impact to impact"
        = Some(row.known()?.restitution_scatter.value);
    scatter_sd: Number [""] "its standard uncertainty" = row.known()?.restitution_scatter.known_sd();
    timing_s: Number ["s"] "root mean square error of the times" = Some(row.known()?.timing_s.value);
    missed_first: Count [""] "most probable number of impacts missed before the first one detected"
        = row.known()?.missed_first();
    converged: Flag [""] "whether the sampling can be trusted" = Some(row.known()?.converged);
    height_contradicts: Flag [""] "whether the noted height contradicts the flight times"
        = row.known().map(|_| row.height_contradicts());
    line_restitution: Number [""] "restitution by the log-linear fit, as if there were no air"
        = Some(row.fit()?.restitution.value);
    line_restitution_sd: Number [""] "its standard error" = row.fit()?.restitution.known_sd();
    line_drop_height_m: Number ["m"] "drop height by the log-linear fit"
        = Some(row.fit()?.drop_height_m.value);
    line_drop_height_sd_m: Number ["m"] "its standard error" = row.fit()?.drop_height_m.known_sd();
};

/// What is odd about a drop.
const REMARKS: &[Fixed<fn(&DropRow<'_>) -> Cell>] = columns! { |row: DropRow<'_>|
    outlier_score: Number [""] "how far it lies from its group, in robust standard deviations; empty unless it is an outlier"
        = row.outlier_score;
    left_out: Text [""] "why it is not in the study; empty if it is" = left_out(row.record, row.of.drop.by_hand, row.translator);
    no_estimate: Text [""] "why there is no inference" = Some(row.translator.diagnostic(row.record.no_posterior.as_ref()?));
    remarks: Text [""] "what is odd about it" = row.sentences(&row.record.diagnostics);
    warnings: Text [""] "what is odd about its recording" = row.sentences(row.of_recording);
};

const OF_AN_IMPACT: &[Fixed<fn(&ImpactRecord) -> Cell>] = columns! { |row: ImpactRecord|
    impact: Count [""] "number of the impact, 1 for the first known; a missed one leaves a gap"
        = Some(row.impact.number);
    time_s: Number ["s"] "time of the impact in its recording" = Some(row.impact.time_s);
    time_sd_s: Number ["s"] "its standard error" = row.impact.time_sd_s;
    probability: Number [""] "that it is an impact of this drop" = Some(row.impact.probability);
    level_db: Number ["dB"] "level relative to full scale" = row.impact.level_db;
    impact_speed_m_s: Number ["m/s"] "speed before the impact, corrected for drag"
        = Some(row.kept()?.impact_speed_m_s);
    restitution: Number [""] "speed after over speed before, corrected for drag" = Some(row.kept()?.restitution.value);
    restitution_sd: Number [""] "its standard error by timing" = row.kept()?.restitution.known_sd();
    plain_restitution: Number [""] "ratio of the flight times after and before" = Some(row.kept()?.flight_time_ratio);
    flight_time_s: Number ["s"] "time until the next impact" = Some(row.after()?.time_s);
    plain_height_m: Number ["m"] "g T^2/8 of the flight after it" = Some(row.after()?.drag_free_height_m);
    apex_m: Number ["m"] "apex of the flight after it, by the flight model" = row.after()?.apex_m;
    weight: Number [""] "weight in the inference, 1 for an impact as good as any" = row.weight;
};

const NUMBER: &[Fixed<fn(&usize) -> Cell>] = columns! { |row: usize|
    drop: Count [""] "number of the drop in its recording, 1 for the first" = Some(*row);
};

const OF_A_FLIGHT: &[Fixed<fn(&MeasuredFlight) -> Cell>] = columns! { |row: MeasuredFlight|
    flight: Count [""] "number of the impact with which it begins" = Some(row.number);
    time_s: Number ["s"] "time between the two impacts, contact included" = Some(row.time_s);
    in_fit: Flag [""] "whether it goes into the log-linear fit" = Some(row.in_fit);
    plain_height_m: Number ["m"] "apex by g T^2/8, without drag" = Some(row.drag_free_height_m);
    apex_m: Number ["m"] "apex by the flight model" = row.apex_m;
    apex_sd_m: Number ["m"] "its standard uncertainty by the times" = row.apex_sd_m;
    launch_speed_m_s: Number ["m/s"] "launch speed by the flight model" = row.launch_speed_m_s;
};

/// The tables of one recording: what a session's tables say of its drops and impacts, as far as it
/// takes no other recording, and the flights.
///
/// ```
/// use bouncelab::{Options, analyze_times};
/// use bouncelab_session::RecordingTables;
///
/// let options = Options::default().without_inference();
/// let result = analyze_times(&[0.0, 0.4605, 0.8877, 1.2854], &options);
/// let tables = RecordingTables::of(&result);
/// assert_eq!((tables.impacts.rows.len(), tables.flights.rows.len()), (4, 3));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RecordingTables {
    /// One row for each drop.
    pub drops: Table,
    /// One row for each impact.
    pub impacts: Table,
    /// One row for each flight.
    pub flights: Table,
}

impl RecordingTables {
    /// The tables of what a recording says.
    pub fn of(recording: &bouncelab::Recording) -> Self {
        let table = |name, schema, of: Vec<Column>| {
            Table::new(schema_of(name, schema, [fixed(NUMBER), of].concat()))
        };
        let of_drops = [fixed(OF_A_DROP), fixed(MORE_OF_A_DROP)].concat();
        let mut tables = Self {
            drops: table("drops", "bouncelab.drops/1", of_drops),
            impacts: table("impacts", "bouncelab.impacts/1", fixed(OF_AN_IMPACT)),
            flights: table("flights", "bouncelab.flights/1", fixed(OF_A_FLIGHT)),
        };
        for (number, drop) in (1..).zip(&recording.drops) {
            let record = DropRecord::from(drop);
            let row = |of: Vec<Cell>| [cells(NUMBER, &number), of].concat();
            let of_drop = [cells(OF_A_DROP, &record), cells(MORE_OF_A_DROP, &record)].concat();
            tables.drops.rows.push(row(of_drop));
            let impacts = record.impacts.iter();
            let impacts = impacts.map(|impact| row(cells(OF_AN_IMPACT, impact)));
            tables.impacts.rows.extend(impacts);
            let flights = drop.flights.iter();
            let flights = flights.map(|flight| row(cells(OF_A_FLIGHT, flight)));
            tables.flights.rows.extend(flights);
        }
        tables
    }
}

/// The schemas of the tables of drops and impacts.
fn schemas(results: &Results<'_>) -> [Schema; 2] {
    schemas_of(&[fixed(WHICH), noted(&fields(results))].concat())
}

/// The same with these columns at the beginning.
fn schemas_of(head: &[Column]) -> [Schema; 2] {
    let schema = |name, schema, of: Vec<Column>| schema_of(name, schema, [head, &of].concat());
    let of_drops = [
        fixed(SETTINGS),
        fixed(OF_A_DROP),
        fixed(COMPARED),
        fixed(MORE_OF_A_DROP),
        fixed(REMARKS),
    ];
    [
        schema("drops", "bouncelab.drops/1", of_drops.concat()),
        schema("impacts", "bouncelab.impacts/1", fixed(OF_AN_IMPACT)),
    ]
}

fn schema_of(name: &'static str, schema: &'static str, columns: Vec<Column>) -> Schema {
    Schema {
        name,
        schema,
        version: env!("CARGO_PKG_VERSION"),
        columns,
    }
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
    let [of_drops, of_impacts] = schemas(results);
    let mut drops = TableWriter::new(folder, &of_drops, forms, outputs)?;
    let mut impacts = TableWriter::new(folder, &of_impacts, forms, outputs)?;
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
pub fn tables(outcome: &Outcome<'_>, results: &Results<'_>) -> Result<[Table; 2]> {
    let [mut drops, mut impacts] = schemas(results).map(Table::new);
    let take = |table: &mut Table, row| {
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
    let english = Translator::english();
    let study = outcome.groups.study.as_ref().ok();
    let scores = outcome.outlier_scores();
    let has_drops = |place: usize| !outcome.drops_of(place).is_empty();
    results.each(has_drops, |place, key, record| {
        let recording = &results.recordings[place];
        for (place, drop_record) in std::iter::zip(outcome.drops_of(place), &record.drops) {
            let of = Which {
                recording,
                drop: &outcome.drops[place],
            };
            let factor =
                |field: &&String| Cell::Text(recording.metadata.factors.get(*field).cloned());
            let head = [cells(WHICH, &of), fields.iter().map(factor).collect()].concat();
            let row = DropRow {
                of,
                key,
                record: drop_record,
                of_recording: &record.diagnostics,
                translator: &english,
                outlier_score: scores.get(&place).copied(),
                common_speed_m_s: study.map(|study| study.at_speed_m_s),
            };
            of_drop([head.clone(), row.cells()].concat())?;
            for impact in &drop_record.impacts {
                of_impact([head.clone(), cells(OF_AN_IMPACT, impact)].concat())?;
            }
        }
        Ok(())
    })
}

/// The tables of drops and impacts of one recording, with the columns of those of a session but for its name
/// and what was noted. What takes other recordings is empty.
pub(crate) fn tables_of_one(recording: &KnownRecording, key: &Key, record: &Record) -> [Table; 2] {
    let [mut drops, mut impacts] = empty_tables_of_one();
    let english = Translator::english();
    for (number, drop_record) in (1..).zip(&record.drops) {
        let row = DropRow {
            of: Which {
                recording,
                drop: &SessionDrop {
                    recording: 0,
                    number,
                    name: "".into(),
                    by_hand: false,
                },
            },
            key,
            record: drop_record,
            of_recording: &record.diagnostics,
            translator: &english,
            outlier_score: None,
            common_speed_m_s: None,
        };
        let head = cells(NUMBER, &number);
        drops.rows.push([head.clone(), row.cells()].concat());
        for impact in &drop_record.impacts {
            let of_impact = cells(OF_AN_IMPACT, impact);
            impacts.rows.push([head.clone(), of_impact].concat());
        }
    }
    [drops, impacts]
}

/// The same without rows.
pub(crate) fn empty_tables_of_one() -> [Table; 2] {
    schemas_of(&fixed(NUMBER)).map(Table::new)
}

fn cells<R>(columns: &[Fixed<fn(&R) -> Cell>], row: &R) -> Vec<Cell> {
    columns.iter().map(|(.., cell)| cell(row)).collect()
}

fn fixed<C>(columns: &[Fixed<C>]) -> Vec<Column> {
    let column = |(name, kind, unit, about, _): &Fixed<C>| Column {
        name: (*name).to_owned(),
        kind: *kind,
        unit,
        about: (*about).to_owned(),
    };
    columns.iter().map(column).collect()
}

/// The columns of what was noted.
fn noted(fields: &BTreeSet<&String>) -> Vec<Column> {
    let taken = [
        fixed(WHICH),
        fixed(SETTINGS),
        fixed(OF_A_DROP),
        fixed(COMPARED),
        fixed(MORE_OF_A_DROP),
        fixed(REMARKS),
        fixed(OF_AN_IMPACT),
    ]
    .concat();
    let column = |field: &&String| Column {
        // A note may be called like a result.
        name: if taken.iter().any(|column| column.name == **field) {
            format!("noted_{field}")
        } else {
            (*field).clone()
        },
        kind: Kind::Text,
        unit: "",
        about: format!("{field} as noted"),
    };
    fields.iter().map(column).collect()
}
