//! The one schema of tables: what has a row of drops, impacts and flights, and every column once.
//!
//! `bouncelab analyze --format csv`, the page and the tables of Python show these columns; a session adds what
//! was noted of a recording, and what only many drops have.
//!
//! A column has the name of its field in the schema [`bouncelab.analysis`](crate::document): the path behind the
//! last list, its parts joined by `_`, without `posterior` and `value`; `sd` stands before the unit. So
//! `drops[].log_linear_fit.drop_height_m.sd` is `log_linear_fit_drop_height_sd_m`. A list of a drop is its length.
//! Columns that follow from several fields have names of their own.
//!
//! ```
//! use bouncelab::{Options, analyze_times};
//! use bouncelab_report::columns::TableKind;
//! use bouncelab_report::data_table::Formulas;
//!
//! let options = Options::default().without_inference();
//! let result = analyze_times(&[0.0, 0.4605, 0.8877, 1.2854], &options);
//! let flights = TableKind::Flights.table("drop.txt", &result);
//! let csv = flights.csv(Formulas::Guarded);
//! assert!(csv.starts_with("recording,drop,number,flight_time_s,"));
//! assert!(csv.lines().nth(1).unwrap().starts_with("drop.txt,1,1,0.4605,true,"));
//! ```

mod record;

use std::sync::LazyLock;

use bouncelab::analysis::MeasuredFlight;
use bouncelab::restitution::ImpactRestitution;
use bouncelab::synth::{Rendered, SynthImpact};
use bouncelab::{Diagnostic, Estimate, Recording};

use crate::data_table::{Cell, CellOf, Column, DataTable, Definition, Kind, cells, columns};
use crate::define_columns;
use crate::document::simulation::{Bounce, Run};
use crate::messages::Translator;
use crate::quantities::{self, Tabulated};

pub use record::{DropRecord, ImpactRecord, PosteriorRecord};

/// The language of texts in tables, whatever that of the reader: tables are for programs.
pub static ENGLISH: LazyLock<Translator> = LazyLock::new(Translator::english);

/// Diagnostics as text in a cell; `None` without a diagnostic.
pub fn sentences(diagnostics: &[Diagnostic]) -> Option<String> {
    let sentences = diagnostics.iter().map(|it| ENGLISH.diagnostic(it));
    (!diagnostics.is_empty()).then(|| ENGLISH.in_one_line(sentences))
}

/// The columns that say to which drop a row belongs: the name of its recording, and its number there.
#[expect(
    clippy::type_complexity,
    reason = "an alias would fix the lifetime of the rows"
)]
pub const WHICH: &[Definition<fn(&(&str, usize)) -> Cell>] = define_columns! { |row: (&str, usize)|
    recording: Text [""] "the recording: its file, in a session relative to the folder" = Some(row.0.to_owned());
    drop: Count [""] "number of the drop in its recording, 1 for the first" = Some(row.1);
};

/// The columns of `drops` before those of the [reported quantities](crate::quantities).
const DROPS: &[Definition<CellOf<DropRecord>>] = define_columns! { |row: DropRecord|
    start_s: Number ["s"] "time of the first impact detected" = Some(row.impacts.first()?.impact.time_s);
    impacts: Count [""] "number of impacts detected" = Some(row.impacts.len());
    probability: Number [""] "probability that it is a drop" = Some(row.probability);
    at_speed_m_s: Number ["m/s"] "impact speed of `restitution`: that of the first impact detected, or the one asked for"
        = Some(row.posterior.as_ref()?.at_speed_m_s);
    first_speed_m_s: Number ["m/s"] "speed of the first impact detected, that of `energy_kept`"
        = Some(row.posterior.as_ref()?.first_speed_m_s);
    round_speed_m_s: Number ["m/s"] "impact speed of `round_speed_restitution`"
        = row.posterior.as_ref()?.round_speed_m_s;
};

/// The columns of `drops` behind them.
const DROPS_BEHIND: &[Definition<CellOf<DropRecord>>] = define_columns! { |row: DropRecord|
    missed_first_impacts_mode: Count [""] "most probable number of impacts missed before the first one detected"
        = row.posterior.as_ref()?.missed_first_impacts_mode();
    height_contradicts: Flag [""] "whether the stated height contradicts the flight times"
        = row.posterior.as_ref().map(|_| row.height_contradicts());
    no_posterior: Text [""] "why there is no inference" = Some(ENGLISH.diagnostic(row.no_posterior.as_ref()?));
    diagnostics: Text [""] "warnings on the drop" = sentences(&row.diagnostics);
};

/// The reported quantities as columns, each with its standard uncertainty behind it.
fn quantity_columns() -> Vec<Column> {
    let of_quantity = |Tabulated { name, unit, about }: Tabulated| {
        let (end, symbol) = unit.in_columns();
        let stem = name.strip_suffix(end).unwrap_or(&name);
        let column = |name: String, about: String| Column {
            name: name.into(),
            kind: Kind::Number,
            unit: symbol.into(),
            about: about.into(),
        };
        let sd = column(
            format!("{stem}_sd{end}"),
            "its standard uncertainty".to_owned(),
        );
        [column(name, about), sd]
    };
    quantities::tabulated().flat_map(of_quantity).collect()
}

/// The cells of [`quantity_columns`].
fn quantity_cells(drop: &DropRecord) -> impl Iterator<Item = Cell> {
    quantities::tabulated().flat_map(|Tabulated { name, .. }| {
        let estimate = drop.quantities.get(&name);
        let sd = estimate.and_then(Estimate::known_sd);
        [Cell::Number(estimate.map(|it| it.value)), Cell::Number(sd)]
    })
}

/// The columns of `impacts`.
const IMPACTS: &[Definition<CellOf<ImpactRecord>>] = define_columns! { |row: ImpactRecord|
    number: Count [""] "number of the impact, 1 for the first known; a missed one leaves a gap"
        = Some(row.impact.number);
    time_s: Number ["s"] "time of the impact in its recording" = Some(row.impact.time_s);
    time_sd_s: Number ["s"] "its standard error" = row.impact.time_sd_s;
    probability: Number [""] "probability that it is an impact of this drop" = Some(row.impact.probability);
    level_db: Number ["dB"] "level relative to full scale" = row.impact.level_db;
    impact_speed_m_s: Number ["m/s"] "speed before the impact, corrected for drag"
        = Some(row.corrected()?.impact_speed_m_s);
    restitution: Number [""] "speed after over speed before, corrected for drag"
        = Some(row.corrected()?.restitution.value);
    restitution_sd: Number [""] "its standard error by timing" = row.corrected()?.restitution.known_sd();
    flight_time_ratio: Number [""] "ratio of the flight times after and before: restitution neglecting the air"
        = Some(row.corrected()?.flight_time_ratio);
    flight_time_s: Number ["s"] "time until the next impact" = Some(row.after()?.flight_time_s);
    drag_free_height_m: Number ["m"] "g T^2/8 of the flight after it" = Some(row.after()?.drag_free_height_m);
    apex_m: Number ["m"] "apex of the flight after it, by the flight model" = row.after()?.apex_m;
    weight: Number [""] "weight in the inference, 1 for an impact as good as any" = row.weight;
};

/// The columns of `flights`.
const FLIGHTS: &[Definition<CellOf<MeasuredFlight>>] = define_columns! { |row: MeasuredFlight|
    number: Count [""] "number of the impact with which it begins" = Some(row.number);
    flight_time_s: Number ["s"] "time between the two impacts, contact included" = Some(row.flight_time_s);
    in_fit: Flag [""] "whether it goes into the log-linear fit" = Some(row.in_fit);
    drag_free_height_m: Number ["m"] "apex by g T^2/8, without drag" = Some(row.drag_free_height_m);
    apex_m: Number ["m"] "apex by the flight model" = row.apex_m;
    apex_sd_m: Number ["m"] "its standard uncertainty by the times" = row.apex_sd_m;
    launch_speed_m_s: Number ["m/s"] "launch speed by the flight model" = row.launch_speed_m_s;
};

/// The columns of the bounces of a simulation: the fields of [`bouncelab.simulation`](crate::document::simulation).
const BOUNCES: &[Definition<CellOf<Bounce>>] = define_columns! { |row: Bounce|
    drag: Text [""] "the drag law" = Some(row.drag.clone());
    number: Count [""] "number of the bounce, 1 for the first" = Some(row.number);
    time_s: Number ["s"] "time of the impact" = Some(row.time_s);
    impact_speed_m_s: Number ["m/s"] "speed before it" = Some(row.impact_speed_m_s);
    restitution: Number [""] "speed after over speed before" = Some(row.restitution);
    launch_speed_m_s: Number ["m/s"] "speed after it" = Some(row.launch_speed_m_s);
    flight_time_s: Number ["s"] "time until the next impact" = Some(row.flight_time_s);
    apex_m: Number ["m"] "apex of the flight after it" = Some(row.apex_m);
    lost_to_surface_j: Number ["J"] "energy that the surface took" = Some(row.lost_to_surface_j);
    lost_to_air_j: Number ["J"] "energy that the air took in the flight after it" = Some(row.lost_to_air_j);
};

/// The columns of the true impacts of a synthesised recording.
const TRUTH: &[Definition<CellOf<SynthImpact>>] = define_columns! { |row: SynthImpact|
    time_s: Number ["s"] "time of the impact in the recording" = Some(row.time_s);
    impact_speed_m_s: Number ["m/s"] "speed before it" = Some(row.speed_m_s);
    snr_db: Number ["dB"] "level above the noise" = Some(row.snr_db);
    lost: Flag [""] "whether it was left out of the sound" = Some(row.lost);
};

/// What has a row in a table of recordings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TableKind {
    /// Each drop.
    Drops,
    /// Each impact, with the flight after it.
    Impacts,
    /// Each flight between two impacts that follow each other.
    Flights,
}

impl TableKind {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::Drops, Self::Impacts, Self::Flights];

    /// The name of the table.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Drops => "drops",
            Self::Impacts => "impacts",
            Self::Flights => "flights",
        }
    }

    /// Name and version of its schema.
    pub const fn schema(self) -> &'static str {
        match self {
            Self::Drops => "bouncelab.drops/2",
            Self::Impacts => "bouncelab.impacts/2",
            Self::Flights => "bouncelab.flights/2",
        }
    }

    /// Its columns behind [`WHICH`].
    pub fn columns(self) -> Vec<Column> {
        match self {
            Self::Drops => [columns(DROPS), quantity_columns(), columns(DROPS_BEHIND)].concat(),
            Self::Impacts => columns(IMPACTS),
            Self::Flights => columns(FLIGHTS),
        }
    }

    /// The rows of a drop, with a cell for each of these columns.
    pub fn rows(self, drop: &DropRecord) -> Vec<Vec<Cell>> {
        let impacts = drop.impacts.iter();
        match self {
            Self::Drops => {
                let quantities = quantity_cells(drop).collect();
                vec![[cells(DROPS, drop), quantities, cells(DROPS_BEHIND, drop)].concat()]
            }
            Self::Impacts => impacts.map(|impact| cells(IMPACTS, impact)).collect(),
            Self::Flights => impacts
                .filter_map(|impact| impact.flight.as_ref())
                .map(|flight| cells(FLIGHTS, flight))
                .collect(),
        }
    }

    /// The table of a recording of this name.
    pub fn table(self, name: &str, recording: &Recording) -> DataTable {
        let mut table = DataTable::new([columns(WHICH), self.columns()].concat());
        for (drop, number) in recording.drops.iter().zip(1..) {
            let which = cells(WHICH, &(name, number));
            let rows = self.rows(&DropRecord::from(drop)).into_iter();
            table
                .rows
                .extend(rows.map(|row| [which.clone(), row].concat()));
        }
        table
    }
}

/// The bounces of simulated drops as a table.
pub fn bounces<'a>(runs: impl IntoIterator<Item = &'a Run>) -> DataTable {
    DataTable::of(BOUNCES, runs.into_iter().flat_map(Run::bounces))
}

/// The true impacts of a synthesised recording as a table.
pub fn truth(sound: &Rendered) -> DataTable {
    DataTable::of(TRUTH, &sound.impacts)
}

impl ImpactRecord {
    const fn corrected(&self) -> Option<&ImpactRestitution> {
        self.restitution.as_ref()
    }

    const fn after(&self) -> Option<&MeasuredFlight> {
        self.flight.as_ref()
    }
}
