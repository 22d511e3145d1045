//! The tables of a session: what their columns are, and what stands in them.

use std::collections::BTreeSet;

use bouncelab_session::journal::Key;
use bouncelab_session::table::{Cell, Column, Kind, Schema};

use super::gather::{Drop, left_out};
use super::notes::Setup;
use super::outcome::Outcome;
use super::record::{DropRecord, ImpactRecord, Value};

/// Name, kind, unit and meaning of a column.
type Row = (&'static str, Kind, &'static str, &'static str);

use Kind::{Count, Flag, Number, Text};

const WHICH: [Row; 2] = [
    (
        "recording",
        Text,
        "",
        "file, relative to the folder of the session",
    ),
    (
        "drop",
        Count,
        "",
        "number of the drop in its recording, 1 for the first",
    ),
];

const SET_UP: [Row; 8] = [
    ("noted_height_m", Number, "m", "drop height as noted"),
    ("noted_temperature_k", Number, "K", "temperature as noted"),
    (
        "ball_mass_kg",
        Number,
        "kg",
        "mass of the ball, as noted or by its rules",
    ),
    ("ball_diameter_m", Number, "m", "diameter of the ball"),
    ("air_density_kg_m3", Number, "kg/m3", "density of the air"),
    ("gravity_m_s2", Number, "m/s2", "gravity"),
    ("content_sha256", Text, "", "hash of the recording"),
    ("settings_sha256", Text, "", "hash of the settings"),
];

const OF_A_DROP: [Row; 29] = [
    ("start_s", Number, "s", "time of the first impact heard"),
    ("impacts", Count, "", "impacts heard"),
    ("probability", Number, "", "that it is a drop"),
    (
        "speed_m_s",
        Number,
        "m/s",
        "impact speed of `restitution`: the middle of this drop",
    ),
    (
        "restitution",
        Number,
        "",
        "restitution at that speed, by the inference",
    ),
    ("restitution_sd", Number, "", "its standard uncertainty"),
    (
        "common_speed_m_s",
        Number,
        "m/s",
        "impact speed at which the drops of the session are compared",
    ),
    (
        "common_restitution",
        Number,
        "",
        "restitution at the common speed",
    ),
    (
        "common_restitution_own_sd",
        Number,
        "",
        "its standard uncertainty by what is this drop's own",
    ),
    (
        "common_restitution_shared_sd",
        Number,
        "",
        "its standard uncertainty by inputs that drops share",
    ),
    (
        "drop_height_m",
        Number,
        "m",
        "height of the fall, by the inference",
    ),
    ("drop_height_sd_m", Number, "m", "its standard uncertainty"),
    (
        "drag_coefficient",
        Number,
        "",
        "drag coefficient at the fastest impact",
    ),
    (
        "drag_coefficient_sd",
        Number,
        "",
        "its standard uncertainty",
    ),
    (
        "scatter",
        Number,
        "",
        "standard deviation of ln e from impact to impact",
    ),
    ("scatter_sd", Number, "", "its standard uncertainty"),
    (
        "timing_s",
        Number,
        "s",
        "root mean square error of the times",
    ),
    (
        "missed_first",
        Count,
        "",
        "most probable number of impacts missed before the first one heard",
    ),
    ("converged", Flag, "", "whether the sampling can be trusted"),
    (
        "height_contradicts",
        Flag,
        "",
        "whether the noted height contradicts the flight times",
    ),
    (
        "line_restitution",
        Number,
        "",
        "restitution by the straight line, as if there were no air",
    ),
    ("line_restitution_sd", Number, "", "its standard error"),
    (
        "line_drop_height_m",
        Number,
        "m",
        "drop height by the straight line",
    ),
    ("line_drop_height_sd_m", Number, "m", "its standard error"),
    (
        "outlier_score",
        Number,
        "",
        "how far it lies from its group, in robust standard deviations; empty unless it is an outlier",
    ),
    (
        "left_out",
        Text,
        "",
        "why it is not in the study; empty if it is",
    ),
    ("no_estimate", Text, "", "why there is no inference"),
    ("remarks", Text, "", "what is odd about it"),
    ("warnings", Text, "", "what is odd about its recording"),
];

const OF_AN_IMPACT: [Row; 13] = [
    (
        "impact",
        Count,
        "",
        "number of the impact, 1 for the first known; a missed one leaves a gap",
    ),
    ("time_s", Number, "s", "time of the impact in its recording"),
    ("time_sd_s", Number, "s", "its standard error"),
    (
        "probability",
        Number,
        "",
        "that it is an impact of this drop",
    ),
    ("level_db", Number, "dB", "level relative to full scale"),
    (
        "impact_speed_m_s",
        Number,
        "m/s",
        "speed before the impact, corrected for drag",
    ),
    (
        "restitution",
        Number,
        "",
        "speed after over speed before, corrected for drag",
    ),
    ("restitution_sd", Number, "", "its standard error by timing"),
    (
        "plain_restitution",
        Number,
        "",
        "ratio of the flight times after and before",
    ),
    ("flight_time_s", Number, "s", "time until the next impact"),
    (
        "plain_height_m",
        Number,
        "m",
        "g T^2/8 of the flight after it",
    ),
    (
        "apex_m",
        Number,
        "m",
        "apex of the flight after it, by the flight model",
    ),
    (
        "weight",
        Number,
        "",
        "weight in the inference, 1 for an impact as good as any",
    ),
];

/// The two tables of a session, whose columns of what was noted differ from session to session.
pub(super) struct Tables {
    pub(super) drops: Schema,
    pub(super) impacts: Schema,
    /// The fields noted, in the order of their columns.
    fields: Vec<String>,
}

impl Tables {
    pub(super) fn new(recordings: &[Setup]) -> Self {
        let fields: BTreeSet<&String> = recordings
            .iter()
            .flat_map(|setup| setup.set_up.factors.keys())
            .collect();
        let fields: Vec<String> = fields.into_iter().cloned().collect();
        let fixed = |rows: &[Row]| -> Vec<Column> {
            rows.iter()
                .map(|&(name, kind, unit, about)| Column {
                    name: name.to_owned(),
                    kind,
                    unit,
                    about: about.to_owned(),
                })
                .collect()
        };
        let taken = |name: &str| {
            let all = WHICH
                .iter()
                .chain(&SET_UP)
                .chain(&OF_A_DROP)
                .chain(&OF_AN_IMPACT);
            all.into_iter().any(|row| row.0 == name)
        };
        let noted = fields.iter().map(|field| Column {
            // A note may be called like a result.
            name: if taken(field) {
                format!("noted_{field}")
            } else {
                field.clone()
            },
            kind: Text,
            unit: "",
            about: format!("{field} as noted"),
        });
        let noted: Vec<Column> = noted.collect();
        let schema = |name, schema, rows: &[&[Row]]| Schema {
            name,
            schema,
            version: env!("CARGO_PKG_VERSION"),
            columns: [
                fixed(&WHICH),
                noted.clone(),
                rows.iter().flat_map(|rows| fixed(rows)).collect(),
            ]
            .concat(),
        };
        Self {
            drops: schema("drops", "bouncelab.drops/1", &[&SET_UP, &OF_A_DROP]),
            impacts: schema("impacts", "bouncelab.impacts/1", &[&OF_AN_IMPACT]),
            fields,
        }
    }

    fn head(&self, drop: &Drop, setup: &Setup) -> Vec<Cell> {
        let mut cells = vec![Cell::Text(setup.recording.name.clone()), count(drop.number)];
        let noted = self.fields.iter();
        cells.extend(
            noted.map(|field| Cell::text(setup.set_up.factors.get(field).map(String::as_str))),
        );
        cells
    }

    /// The row of a drop.
    pub(super) fn drop(
        &self,
        outcome: &Outcome<'_>,
        place: usize,
        setup: &Setup,
        key: &Key,
        (record, warnings): (&DropRecord, &[String]),
    ) -> Vec<Cell> {
        let drop = &outcome.drops[place];
        let physics = &setup.set_up.physics.settings;
        let mut cells = self.head(drop, setup);
        cells.extend([
            Cell::number(setup.set_up.height_m),
            Cell::number(setup.set_up.temperature_k),
            Cell::Number(physics.ball.mass_kg()),
            Cell::Number(physics.ball.diameter_m()),
            Cell::Number(physics.environment.air.density_kg_m3()),
            Cell::Number(physics.environment.gravity_m_s2),
            Cell::Text(key.content.to_string()),
            Cell::Text(key.settings.to_string()),
        ]);
        cells.extend([
            Cell::number(record.impacts.first().map(|impact| impact.time_s)),
            count(record.impacts.len()),
            Cell::Number(record.probability),
        ]);
        let found = record.estimate.as_ref();
        cells.push(Cell::number(found.map(|found| found.at_speed_m_s)));
        cells.extend(value(found.map(|found| found.restitution)));
        let common = outcome.study.as_ref().ok().map(|study| study.at_speed_m_s);
        let at_common = common.and_then(|speed| found?.law().at(speed));
        cells.extend([
            Cell::number(common),
            Cell::number(at_common.map(|point| point.value)),
            Cell::number(at_common.map(|point| point.own_sd)),
            Cell::number(at_common.map(|point| point.shared_sd)),
        ]);
        cells.extend(value(found.map(|found| found.drop_height_m)));
        cells.extend(value(found.and_then(|found| found.drag_coefficient)));
        cells.extend(value(found.map(|found| found.scatter)));
        cells.push(Cell::number(found.map(|found| found.timing_s.value)));
        let missed = found.and_then(|found| found.missed_first);
        cells.push(missed.map_or(Cell::Empty, count));
        let flag = |value: Option<bool>| value.map_or(Cell::Empty, Cell::Flag);
        cells.push(flag(found.map(|found| found.converged)));
        cells.push(flag(found.map(|found| found.height_contradicts)));
        let line = record.line.as_ref();
        cells.extend(value(line.map(|line| line.restitution)));
        cells.extend(value(line.map(|line| line.drop_height_m)));
        cells.push(Cell::number(score(outcome, place)));
        cells.push(Cell::text(left_out(record, drop.by_hand).as_deref()));
        cells.push(Cell::text(record.no_estimate.as_deref()));
        cells.push(sentences(&record.remarks));
        cells.push(sentences(warnings));
        cells
    }

    /// The row of an impact.
    pub(super) fn impact(&self, drop: &Drop, setup: &Setup, impact: &ImpactRecord) -> Vec<Cell> {
        let mut cells = self.head(drop, setup);
        cells.push(count(impact.number));
        cells.push(Cell::Number(impact.time_s));
        cells.push(Cell::number(impact.sigma_s));
        cells.push(Cell::Number(impact.probability));
        let rest = [
            impact.level_db,
            impact.impact_speed_m_s,
            impact.restitution,
            impact.restitution_sd,
            impact.plain_restitution,
            impact.flight_time_s,
            impact.plain_height_m,
            impact.apex_m,
            impact.weight,
        ];
        cells.extend(rest.map(Cell::number));
        cells
    }
}

fn count(count: usize) -> Cell {
    i64::try_from(count).map_or(Cell::Empty, Cell::Count)
}

/// Value and uncertainty.
fn value(value: Option<Value>) -> [Cell; 2] {
    [
        Cell::number(value.map(|value| value.value)),
        Cell::number(value.and_then(|value| value.sd)),
    ]
}

/// The outlier score of a drop, by its place among all drops.
fn score(outcome: &Outcome<'_>, place: usize) -> Option<f64> {
    let studied = outcome.studied.binary_search(&place).ok()?;
    let study = outcome.study.as_ref().ok()?;
    let outlier = study
        .outliers
        .iter()
        .find(|outlier| outlier.drop == studied)?;
    Some(outlier.score)
}

fn sentences(sentences: &[String]) -> Cell {
    if sentences.is_empty() {
        Cell::Empty
    } else {
        Cell::Text(sentences.join("; "))
    }
}
