//! Requests and responses between the page and the science, as data.
//!
//! Everything is SI with the unit in the name, and an unknown value is `null`. The page has the
//! same types in `web/src/lab/engine/types.ts`, which is made from these.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
#[cfg(not(target_family = "wasm"))]
use ts_rs::TS;

use bouncelab::air::Conditions;
use bouncelab::analysis::{Drop, DropCandidate, ListOrigin, Source, StrongestBand, renumbered};
use bouncelab::groups::CurveEvidence;
use bouncelab::inference::Posterior;
use bouncelab::rulebook::{Rebound, Rule};
use bouncelab::settings::Settings;
use bouncelab::{Diagnostic, Impact};
use bouncelab_report::Chart;
use bouncelab_report::document::Document;
use bouncelab_report::figure::DropSummary;
use bouncelab_report::hash::Hash;
use bouncelab_report::quantities::{Headline, QuantityList};
use bouncelab_report::report::verdict::{MethodCheck, NoteField};
use bouncelab_report::report::{Block, Section};

/// The choices that a page can offer.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Catalogue {
    /// Version of the program.
    pub version: String,
    /// Balls by name, the first being the usual one.
    pub balls: Vec<BallPreset>,
    /// Drag laws with an example of their numbers, the first being the usual one.
    pub drag_laws: Vec<String>,
    /// Restitution laws, for the inference and for simulations.
    pub restitution_laws: Vec<RestitutionLawEntry>,
    /// What an impact can sound like.
    pub voices: Vec<String>,
    /// Bodies on which a ball may be dropped.
    pub bodies: Vec<Body>,
    /// The air that is assumed.
    pub usual_air: Conditions,
    /// Standard gravity.
    pub standard_gravity_m_s2: f64,
}

/// A restitution law.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct RestitutionLawEntry {
    /// Name, as in settings.
    pub name: String,
    /// The law with numbers, as a simulation takes it.
    pub example: String,
}

/// A ball that can be stated by name.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct BallPreset {
    /// Name, as in settings.
    pub name: String,
    /// Name for people.
    pub label: String,
    /// Mass.
    pub mass_kg: f64,
    /// Diameter.
    pub diameter_m: f64,
    /// Typical time of contact.
    pub contact_time_s: f64,
    /// Where mass and diameter come from.
    pub source: String,
}

/// Gravity and air of a celestial body.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Body {
    /// Name, as a key for translation.
    pub name: String,
    /// Gravity at its surface.
    pub gravity_m_s2: f64,
    /// Density of its air there.
    pub air_density_kg_m3: f64,
    /// Viscosity of its air there; `null` in vacuum.
    pub air_viscosity_pa_s: Option<f64>,
}

/// What was detected so far in a recording that is still going on.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct SoFar {
    /// How long it has been recording.
    pub duration_s: f64,
    /// The drop that goes on or was the last to end, without the inference; `null` before the first.
    pub drop: Option<Drop>,
    /// How many drops were detected.
    pub drops: usize,
    /// Whether the ball rests: no more impacts of this drop will come.
    pub at_rest: bool,
}

/// The impacts of one drop, as they are to be analysed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct DropMarks {
    /// Its impacts, in order of time.
    pub impacts: Vec<Impact>,
    /// Probability that it is a drop.
    pub probability: f64,
    /// Whether the reader has changed the impacts: then they are numbered anew.
    pub edited: bool,
}

impl DropMarks {
    pub(crate) fn candidate(&self) -> DropCandidate {
        let impacts = self.impacts.clone();
        DropCandidate {
            impacts: if self.edited {
                renumbered(impacts)
            } else {
                impacts
            },
            probability: self.probability,
        }
    }
}

/// What to analyse.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct AnalysisRequest {
    /// Name of the recording, as it goes into the document.
    pub name: String,
    /// Where its times come from.
    pub source: Source,
    /// Where its impacts stand out most.
    pub strongest_band: Option<StrongestBand>,
    /// Its warnings.
    pub diagnostics: Vec<Diagnostic>,
    /// Why there was no drop in it.
    pub no_drop: Option<Diagnostic>,
    /// What may be another drop in it.
    pub candidates: Vec<DropCandidate>,
    /// The drops.
    pub drops: Vec<DropMarks>,
    /// Ball, air, gravity and other settings.
    pub settings: Settings,
    /// With the inference, or only what takes some milliseconds.
    pub inference: bool,
}

/// The result of an analysis.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Analysed<'a> {
    /// The document of the program, `bouncelab.analysis/3`.
    pub document: Document<'a>,
    /// The name of the ball.
    pub ball: String,
    /// Settings that look like mistakes of units.
    pub questions: Vec<Diagnostic>,
    /// What to read first of each drop, in the language of the request.
    pub headlines: Vec<Headline>,
    /// The reported quantities of each drop, in the language of the request.
    pub quantities: Vec<Vec<QuantityList>>,
    /// Names of the unknowns whose priors the data may contract, by [`PriorContraction::unknown`].
    ///
    /// [`PriorContraction::unknown`]: bouncelab::inference::PriorContraction::unknown
    pub unknowns: BTreeMap<&'static str, String>,
    /// The numbers of the impacts of each drop whose restitution would mislead.
    pub doubtful_restitutions: Vec<Vec<usize>>,
    /// The figures that there are of each drop.
    pub figures: Vec<Vec<FigureTab>>,
    /// What each drop adds to a study of many; `null` without an inference.
    pub comparable: Vec<Option<Comparable>>,
}

/// A figure that a drop has.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct FigureTab {
    /// Its name in requests.
    pub name: &'static str,
    /// The text of its tab, in the language of the request.
    pub tab: String,
}

/// What a drop adds to a study of many.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Comparable {
    /// What it says of the restitution curve.
    pub evidence: CurveEvidence,
    /// Scatter of ln e from impact to impact.
    pub scatter: f64,
}

impl Comparable {
    /// `None` if its draws say nothing of a curve.
    pub fn of(posterior: &Posterior) -> Option<Self> {
        Some(Self {
            evidence: posterior.evidence()?,
            scatter: posterior.restitution_scatter.value,
        })
    }
}

/// Drops that are to be compared, in the order in which they were made.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct StudyRequest {
    /// What they are called together.
    pub title: String,
    /// The drops.
    pub drops: Vec<StudiedDrop>,
    /// The fields that make groups, none for a single one; one of which nothing is noted makes none.
    pub by: Vec<String>,
    /// The day on which a report is made, if it states one.
    pub made: Option<String>,
}

/// A drop that is to be compared with others.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct StudiedDrop {
    /// What it is called.
    pub name: String,
    /// What it is compared by: field and level.
    pub factors: BTreeMap<String, String>,
    /// What it adds; `null` if unknown.
    pub comparable: Option<Comparable>,
    /// Speed in m/s and restitution of each impact.
    pub impacts: Vec<[f64; 2]>,
}

/// The study of many drops.
#[derive(Debug, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Studied {
    /// The answer in sentences.
    pub lead: Vec<Block>,
    /// Each drop by its group, and the intervals of the groups; `null` if there is no study.
    pub figure: Option<Chart>,
    /// Tables and the other figures.
    pub sections: Vec<Section>,
}

/// A rule by which drops can be judged.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct RuleChoice {
    /// What a request hands over.
    #[cfg_attr(not(target_family = "wasm"), ts(type = "unknown"))]
    pub rule: Rule,
    /// Its name.
    pub name: String,
    /// Its title, in the language of the request.
    pub title: String,
    /// Whether it is for a known ball, which the settings need not state then.
    pub has_ball: bool,
    /// Whether it compares with a reference surface.
    pub needs_reference: bool,
}

/// Drops that are to be judged by a rule.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct VerdictRequest {
    /// The rule.
    #[cfg_attr(not(target_family = "wasm"), ts(type = "unknown"))]
    pub rule: Rule,
    /// What was kept of its procedure, of the [parts that a person states](Judged::stated).
    pub kept: Vec<String>,
    /// Ball, air, gravity and other settings of all drops.
    pub settings: Settings,
    /// The drops on the surface.
    pub surface: Vec<JudgedPlace>,
    /// Those on the reference surface, for a rule that compares.
    pub reference: Vec<JudgedPlace>,
    /// The day on which a report is made, if it states one.
    pub made: Option<String>,
}

/// A place of a surface.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct JudgedPlace {
    /// What it is called.
    pub name: String,
    /// Where the times come from.
    pub source: Source,
    /// Its drops.
    pub drops: Vec<DropMarks>,
}

/// A verdict.
#[derive(Debug, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Judged {
    /// The verdict in sentences, and its figure.
    pub lead: Vec<Block>,
    /// What it rests on.
    pub sections: Vec<Section>,
    /// The parts of the procedure that neither a recording nor a setting shows.
    pub stated: Vec<StatedPart>,
}

/// The rebounds that are wanted of the drops of a recording, by a rule.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct ReboundRequest {
    /// The rule.
    #[cfg_attr(not(target_family = "wasm"), ts(type = "unknown"))]
    pub rule: Rule,
    /// Ball, air, gravity and other settings of all drops.
    pub settings: Settings,
    /// The recording.
    pub place: JudgedPlace,
}

/// What is chosen when a job begins.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct NewJob {
    /// Name of the rule.
    pub rule: String,
    /// What it is called.
    pub name: String,
    /// How many places are tested; as many as the rule asks for if left out.
    pub places: Option<usize>,
    /// How many drops in each place; as many as the rule asks for if left out.
    pub drops: Option<usize>,
    /// The ball, if the rule names none.
    pub settings: Settings,
}

/// The files of a job, but for its recordings: those of a job of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct JobFiles {
    /// `job.toml`.
    pub notes: String,
    /// `journal.jsonl`.
    pub journal: String,
}

/// A change of a job.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
#[serde(tag = "change", rename_all = "kebab-case")]
#[expect(clippy::large_enum_variant, reason = "one at a time, from a person")]
pub enum JobChange {
    /// What a person states.
    Stated {
        /// Parts of the notes that the report shows, by their names.
        fields: BTreeMap<String, String>,
        /// What was kept of the procedure.
        kept: Vec<String>,
        /// Ball, height, air and other settings of all drops.
        settings: Settings,
    },
    /// The method was checked.
    Checked {
        /// What came out.
        #[cfg_attr(not(target_family = "wasm"), ts(type = "unknown"))]
        check: MethodCheck,
    },
    /// A recording counts from now on, in the next place.
    Added {
        /// Its SHA-256.
        #[cfg_attr(not(target_family = "wasm"), ts(type = "string"))]
        sha256: Hash,
        /// The ending of the name of its file.
        ending: String,
        /// The name under which it was given.
        given_as: String,
        /// Who dropped the ball.
        operator: String,
        /// Date and time.
        added: String,
        /// The rebounds of its drops.
        #[cfg_attr(not(target_family = "wasm"), ts(type = "unknown[]"))]
        rebounds: Vec<Rebound>,
    },
    /// The rebounds in a recording under the settings of now.
    Computed {
        /// Its number.
        number: usize,
        /// The rebounds of its drops.
        #[cfg_attr(not(target_family = "wasm"), ts(type = "unknown[]"))]
        rebounds: Vec<Rebound>,
    },
    /// A recording counts no more.
    Repeated {
        /// Its number.
        number: usize,
        /// Why.
        reason: String,
    },
}

/// A job, to be shown.
#[derive(Debug, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct JobShown {
    /// Its files.
    pub files: JobFiles,
    /// What it is called.
    pub name: String,
    /// The title of its rule.
    pub title: String,
    /// What the rebounds of a recording are asked for with.
    #[cfg_attr(not(target_family = "wasm"), ts(type = "unknown"))]
    pub rule: Rule,
    /// The same.
    pub settings: Settings,
    /// Where the next drop belongs, in words; `null` if every place has its drops.
    pub next: Option<String>,
    /// Each place with its drops, in words.
    pub places: Vec<JobPlace>,
    /// All recordings, also those that were repeated.
    pub recordings: Vec<JobRecording>,
    /// The result so far in a sentence; `null` before the first drop, and while rebounds are missing.
    pub so_far: Option<String>,
    /// The verdict so far; `null` likewise.
    pub judged: Option<Judged>,
    /// What the report states.
    pub fields: Vec<NoteField>,
    /// What was kept of the procedure, as stated.
    pub kept: Vec<String>,
    /// The checks of the method at the start.
    pub checks: Vec<String>,
    /// How many lines of the journal are damaged, and do not count.
    pub damaged: usize,
}

/// A place of a job.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct JobPlace {
    /// Its number; 0 is the reference.
    pub place: usize,
    /// Where it is, as in "place 2 of 5, drop 3 of 5".
    pub words: String,
    /// Whether it has its drops.
    pub is_done: bool,
}

/// A recording of a job.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct JobRecording {
    /// Its number.
    pub number: usize,
    /// Its file, in the folder of the job.
    pub file: String,
    /// What is known of it.
    pub words: String,
    /// Its SHA-256.
    pub sha256: String,
    /// Whether it counts.
    pub counts: bool,
    /// Whether its rebounds under the settings of now are known.
    pub is_known: bool,
}

/// A part of a procedure that a person states to have been kept.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct StatedPart {
    /// Its name in requests.
    pub name: &'static str,
    /// What the rule asks, in the language of the request.
    pub label: String,
}

/// A figure as a picture, and as data.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Drawn {
    /// Name, also of its file.
    pub name: String,
    /// The picture.
    pub svg: String,
    /// The data, for other programs.
    pub csv: String,
    /// Its natural width.
    pub width_px: f64,
    /// Its natural height.
    pub height_px: f64,
}

/// How a simulated drop begins, bounces and ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
#[cfg_attr(not(target_family = "wasm"), ts(optional_fields))]
pub struct SimulationRequest {
    /// Ball, air, gravity and drag.
    pub settings: Settings,
    /// Height of release.
    pub height_m: f64,
    /// Restitution, or a law of it with its numbers, such as `power:0.9,1,0.25`.
    pub restitution: String,
    /// Simulate with these drag laws too.
    #[serde(default)]
    pub compare: Option<Vec<String>>,
    /// Stop when the ball no longer rises above this height; 1 mm if left out.
    #[serde(default)]
    pub until_m: Option<f64>,
    /// Stop after this number of bounces.
    #[serde(default)]
    pub bounces: Option<u32>,
}

/// A simulated drop to be compared with others.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct SimulationRun {
    /// Its name in the legend.
    pub name: String,
    /// What is simulated.
    pub request: SimulationRequest,
}

/// A drop that was kept, to be compared with others.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct ComparedDrop {
    /// Its name in the legend.
    pub name: String,
    /// Its restitution, if it has one.
    pub restitution: Option<f64>,
    /// Standard deviation of that.
    pub restitution_sd: Option<f64>,
    /// Speed in m/s and restitution of each impact.
    pub impacts: Vec<[f64; 2]>,
}

impl From<ComparedDrop> for DropSummary {
    fn from(kept: ComparedDrop) -> Self {
        let sd = kept.restitution_sd.unwrap_or(f64::NAN);
        Self {
            name: kept.name,
            restitution: kept.restitution.map(|value| (value, sd)),
            impacts: kept.impacts,
        }
    }
}

/// A list of times between the module that reads it and the one that analyses it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReadList {
    /// Impact times in seconds, increasing.
    pub times_s: Vec<f64>,
    /// Where they come from.
    pub origin: ListOrigin,
}

/// How a simulated drop sounds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
#[cfg_attr(not(target_family = "wasm"), ts(optional_fields))]
#[serde(default)]
pub struct SceneRequest {
    /// What an impact sounds like.
    pub voice: String,
    /// Level of the first impact above the noise, in dB; without noise if left out.
    pub snr_db: Option<f64>,
    /// Samples a second.
    pub sample_rate_hz: u32,
    /// Seed of everything random.
    pub seed: u32,
    /// Time before the release.
    pub lead_in_s: f64,
    /// Time after the last impact.
    pub tail_s: f64,
}

impl Default for SceneRequest {
    fn default() -> Self {
        Self {
            voice: "table-tennis".to_owned(),
            snr_db: Some(40.0),
            sample_rate_hz: 44_100,
            seed: 1,
            lead_in_s: 0.5,
            tail_s: 0.5,
        }
    }
}

/// A made-up drop to try things with.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(not(target_family = "wasm"), derive(TS))]
pub struct Demo {
    /// Name of the recording.
    pub name: String,
    /// The settings that a person would state.
    pub settings: Settings,
    /// Restitution with which it was made.
    pub restitution: f64,
    /// Height from which it was made to fall.
    pub drop_height_m: f64,
}
