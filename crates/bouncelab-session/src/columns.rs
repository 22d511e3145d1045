//! The columns of the tables of a session.

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
use bouncelab_report::messages::Translator;

use crate::error::Result;
use crate::journal::Key;
use crate::metadata::{KnownRecording, Metadata};
use crate::record::{DropRecord, FitRecord, ImpactRecord, PosteriorRecord};
use crate::results::Results;
use crate::study::{Outcome, SessionDrop, left_out};
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

    fn posterior(&self) -> Option<&PosteriorRecord> {
        self.record.posterior.as_ref()
    }

    fn fit(&self) -> Option<&FitRecord> {
        self.record.log_linear_fit.as_ref()
    }

    fn common(&self) -> Option<CurvePoint> {
        self.posterior()?.curve.at(self.common_speed_m_s?)
    }

    /// The sentences of diagnostics, if there are any.
    fn sentences(&self, diagnostics: &[Diagnostic]) -> Option<String> {
        let sentences = diagnostics.iter().map(|it| self.translator.diagnostic(it));
        let sentences: Vec<String> = sentences.collect();
        (!sentences.is_empty()).then(|| sentences.join("; "))
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

const OF_A_DROP: &[Fixed<fn(&DropRow<'_>) -> Cell>] = columns! { |row: DropRow<'_>|
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
    start_s: Number ["s"] "time of the first impact detected" = Some(row.record.impacts.first()?.impact.time_s);
    impacts: Count [""] "impacts detected" = Some(row.record.impacts.len());
    probability: Number [""] "that it is a drop" = Some(row.record.probability);
    speed_m_s: Number ["m/s"] "impact speed of `restitution`: the middle of this drop"
        = Some(row.posterior()?.at_speed_m_s);
    restitution: Number [""] "restitution at that speed, by the inference"
        = Some(row.posterior()?.restitution.value);
    restitution_sd: Number [""] "its standard uncertainty" = row.posterior()?.restitution.known_sd();
    common_speed_m_s: Number ["m/s"] "impact speed at which the drops of the session are compared"
        = row.common_speed_m_s;
    common_restitution: Number [""] "restitution at the common speed" = Some(row.common()?.value);
    common_restitution_own_sd: Number [""] "its standard uncertainty by what is this drop's own"
        = Some(row.common()?.own_sd);
    common_restitution_shared_sd: Number [""] "its standard uncertainty by inputs that drops share"
        = Some(row.common()?.shared_sd);
    drop_height_m: Number ["m"] "height of the fall, by the inference"
        = Some(row.posterior()?.drop_height_m.value);
    drop_height_sd_m: Number ["m"] "its standard uncertainty" = row.posterior()?.drop_height_m.known_sd();
    drag_coefficient: Number [""] "drag coefficient at the fastest impact"
        = Some(row.posterior()?.drag_coefficient?.value);
    drag_coefficient_sd: Number [""] "its standard uncertainty" = row.posterior()?.drag_coefficient?.known_sd();
    scatter: Number [""] "standard deviation of ln e from impact to impact"
        = Some(row.posterior()?.restitution_scatter.value);
    scatter_sd: Number [""] "its standard uncertainty" = row.posterior()?.restitution_scatter.known_sd();
    timing_s: Number ["s"] "root mean square error of the times" = Some(row.posterior()?.timing_s.value);
    missed_first: Count [""] "most probable number of impacts missed before the first one detected"
        = row.posterior()?.missed_first();
    converged: Flag [""] "whether the sampling can be trusted" = Some(row.posterior()?.converged);
    height_contradicts: Flag [""] "whether the noted height contradicts the flight times"
        = row.posterior().map(|_| row.record.height_contradicts());
    line_restitution: Number [""] "restitution by the straight line, as if there were no air"
        = Some(row.fit()?.restitution.value);
    line_restitution_sd: Number [""] "its standard error" = row.fit()?.restitution.known_sd();
    line_drop_height_m: Number ["m"] "drop height by the straight line"
        = Some(row.fit()?.drop_height_m.value);
    line_drop_height_sd_m: Number ["m"] "its standard error" = row.fit()?.drop_height_m.known_sd();
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

/// Writes the tables of drops and impacts into a folder, one recording after the other; returns the
/// files. Sentences in them are English, whatever the language of the reader: tables are for programs.
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
    let english = Translator::english();
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
                of_recording: &record.diagnostics,
                translator: &english,
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
