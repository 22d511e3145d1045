//! The tables of a session: what their columns are, and what stands in them.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use bouncelab::analysis::Options;
use bouncelab::groups::CurvePoint;

use crate::error::Result;
use crate::journal::Key;
use crate::metadata::{KnownRecording, Metadata};
use crate::record::{DropRecord, EstimateRecord, ImpactRecord, LineRecord};
use crate::results::Results;
use crate::study::{Outcome, SessionDrop};
use crate::table::{Cell, Column, Form, Kind, Schema, TableWriter};

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
    warnings: &'a [String],
    outlier_score: Option<f64>,
    common_speed_m_s: Option<f64>,
}

impl DropRow<'_> {
    fn metadata(&self) -> &Metadata {
        &self.of.recording.metadata
    }

    fn settings(&self) -> &Options {
        &self.metadata().setup.settings
    }

    fn found(&self) -> Option<&EstimateRecord> {
        self.record.estimate.as_ref()
    }

    fn line(&self) -> Option<&LineRecord> {
        self.record.line.as_ref()
    }

    fn common(&self) -> Option<CurvePoint> {
        self.found()?.law().at(self.common_speed_m_s?)
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

const OF_A_DROP: &[Fixed<fn(&DropRow<'_>) -> Cell>] = columns! { |row: DropRow<'_>|
    noted_height_m: Number ["m"] "drop height as noted" = row.metadata().height_m;
    noted_temperature_k: Number ["K"] "temperature as noted" = row.metadata().temperature_k;
    ball_mass_kg: Number ["kg"] "mass of the ball, as noted or by its rules"
        = Some(row.settings().ball.mass_kg());
    ball_diameter_m: Number ["m"] "diameter of the ball" = Some(row.settings().ball.diameter_m());
    air_density_kg_m3: Number ["kg/m3"] "density of the air"
        = Some(row.settings().environment.air.density_kg_m3());
    gravity_m_s2: Number ["m/s2"] "gravity" = Some(row.settings().environment.gravity_m_s2);
    content_sha256: Text [""] "hash of the recording" = Some(row.key.content.to_string());
    settings_sha256: Text [""] "hash of the settings" = Some(row.key.settings.to_string());
    start_s: Number ["s"] "time of the first impact heard" = Some(row.record.impacts.first()?.time_s);
    impacts: Count [""] "impacts heard" = Some(row.record.impacts.len());
    probability: Number [""] "that it is a drop" = Some(row.record.probability);
    speed_m_s: Number ["m/s"] "impact speed of `restitution`: the middle of this drop"
        = Some(row.found()?.at_speed_m_s);
    restitution: Number [""] "restitution at that speed, by the inference"
        = Some(row.found()?.restitution.value);
    restitution_sd: Number [""] "its standard uncertainty" = row.found()?.restitution.sd;
    common_speed_m_s: Number ["m/s"] "impact speed at which the drops of the session are compared"
        = row.common_speed_m_s;
    common_restitution: Number [""] "restitution at the common speed" = Some(row.common()?.value);
    common_restitution_own_sd: Number [""] "its standard uncertainty by what is this drop's own"
        = Some(row.common()?.own_sd);
    common_restitution_shared_sd: Number [""] "its standard uncertainty by inputs that drops share"
        = Some(row.common()?.shared_sd);
    drop_height_m: Number ["m"] "height of the fall, by the inference"
        = Some(row.found()?.drop_height_m.value);
    drop_height_sd_m: Number ["m"] "its standard uncertainty" = row.found()?.drop_height_m.sd;
    drag_coefficient: Number [""] "drag coefficient at the fastest impact"
        = Some(row.found()?.drag_coefficient?.value);
    drag_coefficient_sd: Number [""] "its standard uncertainty" = row.found()?.drag_coefficient?.sd;
    scatter: Number [""] "standard deviation of ln e from impact to impact"
        = Some(row.found()?.scatter.value);
    scatter_sd: Number [""] "its standard uncertainty" = row.found()?.scatter.sd;
    timing_s: Number ["s"] "root mean square error of the times" = Some(row.found()?.timing_s.value);
    missed_first: Count [""] "most probable number of impacts missed before the first one heard"
        = row.found()?.missed_first;
    converged: Flag [""] "whether the sampling can be trusted" = Some(row.found()?.converged);
    height_contradicts: Flag [""] "whether the noted height contradicts the flight times"
        = Some(row.found()?.height_contradicts);
    line_restitution: Number [""] "restitution by the straight line, as if there were no air"
        = Some(row.line()?.restitution.value);
    line_restitution_sd: Number [""] "its standard error" = row.line()?.restitution.sd;
    line_drop_height_m: Number ["m"] "drop height by the straight line"
        = Some(row.line()?.drop_height_m.value);
    line_drop_height_sd_m: Number ["m"] "its standard error" = row.line()?.drop_height_m.sd;
    outlier_score: Number [""] "how far it lies from its group, in robust standard deviations; empty unless it is an outlier"
        = row.outlier_score;
    left_out: Text [""] "why it is not in the study; empty if it is" = row.of.drop.left_out.clone();
    no_estimate: Text [""] "why there is no inference" = row.record.no_estimate.clone();
    remarks: Text [""] "what is odd about it" = sentences(&row.record.remarks);
    warnings: Text [""] "what is odd about its recording" = sentences(row.warnings);
};

const OF_AN_IMPACT: &[Fixed<fn(&ImpactRecord) -> Cell>] = columns! { |row: ImpactRecord|
    impact: Count [""] "number of the impact, 1 for the first known; a missed one leaves a gap"
        = Some(row.number);
    time_s: Number ["s"] "time of the impact in its recording" = Some(row.time_s);
    time_sd_s: Number ["s"] "its standard error" = row.sigma_s;
    probability: Number [""] "that it is an impact of this drop" = Some(row.probability);
    level_db: Number ["dB"] "level relative to full scale" = row.level_db;
    impact_speed_m_s: Number ["m/s"] "speed before the impact, corrected for drag"
        = row.impact_speed_m_s;
    restitution: Number [""] "speed after over speed before, corrected for drag" = row.restitution;
    restitution_sd: Number [""] "its standard error by timing" = row.restitution_sd;
    plain_restitution: Number [""] "ratio of the flight times after and before" = row.plain_restitution;
    flight_time_s: Number ["s"] "time until the next impact" = row.flight_time_s;
    plain_height_m: Number ["m"] "g T^2/8 of the flight after it" = row.plain_height_m;
    apex_m: Number ["m"] "apex of the flight after it, by the flight model" = row.apex_m;
    weight: Number [""] "weight in the inference, 1 for an impact as good as any" = row.weight;
};

fn sentences(sentences: &[String]) -> Option<String> {
    (!sentences.is_empty()).then(|| sentences.join("; "))
}

/// Writes the tables of drops and impacts into a folder, one recording after the other; returns the
/// files.
///
/// # Errors
/// [`Error::Output`](crate::Error::Output) and [`Error::Table`](crate::Error::Table) if they cannot be
/// written, and those of [`Results::read`].
pub fn write_tables(
    outcome: &Outcome<'_>,
    results: &Results<'_>,
    folder: &Path,
    forms: &[Form],
) -> Result<Vec<PathBuf>> {
    let recordings = results.recordings.iter();
    let fields: BTreeSet<&String> = recordings
        .flat_map(|recording| recording.metadata.factors.keys())
        .collect();
    let schema = |name, schema, of: Vec<Column>| Schema {
        name,
        schema,
        version: env!("CARGO_PKG_VERSION"),
        columns: [fixed(WHICH), noted(&fields), of].concat(),
    };
    let of_drops = schema("drops", "bouncelab.drops/1", fixed(OF_A_DROP));
    let of_impacts = schema("impacts", "bouncelab.impacts/1", fixed(OF_AN_IMPACT));
    let mut drops = TableWriter::new(folder, &of_drops, forms)?;
    let mut impacts = TableWriter::new(folder, &of_impacts, forms)?;
    let study = outcome.study.as_ref().ok();
    let mut place = 0;
    while let Some(first) = outcome.drops.get(place) {
        let recording = &results.recordings[first.recording];
        let (key, record) = results.read(first.recording)?;
        for of_drop in &record.drops {
            let of = Which {
                recording,
                drop: &outcome.drops[place],
            };
            let factor =
                |field: &&String| Cell::Text(recording.metadata.factors.get(*field).cloned());
            let head = [cells(WHICH, &of), fields.iter().map(factor).collect()].concat();
            let row = DropRow {
                of,
                key: &key,
                record: of_drop,
                warnings: &record.warnings,
                outlier_score: outcome.outlier_score(place),
                common_speed_m_s: study.map(|study| study.at_speed_m_s),
            };
            drops.row(&[head.clone(), cells(OF_A_DROP, &row)].concat())?;
            for impact in &of_drop.impacts {
                impacts.row(&[head.clone(), cells(OF_AN_IMPACT, impact)].concat())?;
            }
            place += 1;
        }
    }
    Ok([drops.finish()?, impacts.finish()?].concat())
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
    let taken = [fixed(WHICH), fixed(OF_A_DROP), fixed(OF_AN_IMPACT)].concat();
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
