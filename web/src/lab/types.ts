// The types that the laboratory's engine takes and gives, made from those in
// crates/bouncelab-wasm/src (wire.rs, refusal.rs) by `cargo xtask web`. Do not edit.

/** What the impacts say. */
export type Analysed = {
/** The command line's document, `bouncelab.analysis/1`. */
document: AnalysisDocument,
/** How far it went. */
effort: Effort,
/** The ball in words. */
ball: string,
/** For the charts, one for each drop of the document. */
series: Array<Series>,
/** Drag against speed; empty if there is none. */
drag: Array<DragCurve>,
/** Names of the figures that can be drawn of it. */
figures: Array<string>, };

/** What one file says. */
export type AnalysisDocument = { schema: string,
/** Version of the program that made it. */
bouncelab: string, file: string, source: Origin | null, settings: SettingsUsed | null, drops: Array<DocumentDrop>,
/** Why there is no drop, in words. */
no_drop: string | null, warnings: Array<string>, };

/** What to analyse. */
export type AnalysisRequest = {
/** Name of the recording, as in [`Heard`]. */
name: string,
/** Where its times come from. */
source: Origin,
/** What is odd about it. */
warnings: Array<string>,
/** Why there was no drop in it. */
no_drop: string | null,
/** The drops. */
drops: Array<DropMarks>,
/** Ball, air, gravity and what else is known. */
settings: Settings,
/** How far to go. */
effort: Effort, };

/** A ball whose rules fix mass and size. */
export type BallPreset = {
/** Name, as in settings. */
name: string,
/** Name for people. */
label: string,
/** Mass. */
mass_kg: number,
/** Diameter. */
diameter_m: number,
/** Typical time of contact. */
contact_time_s: number,
/** Where mass and diameter come from. */
source: string, };

export type BandPoint = { speed_m_s: number, restitution: Posterior, };

/** One bounce: an impact and the flight after it. */
export type Bounce = { drag: string, number: number, time_s: number, impact_speed_m_s: number, restitution: number, launch_speed_m_s: number, flight_time_s: number, apex_m: number, lost_to_surface_j: number, lost_to_air_j: number, };

export type Budget = { restitution: Array<Share>, drop_height_m: Array<Share>, };

/** The choices that a page can offer. */
export type Catalogue = {
/** Version of the program. */
version: string,
/** Balls by name, the first being the one that is assumed. */
balls: Array<BallPreset>,
/** Drag laws by name; besides there are `none` and `constant:0.4`. */
drag_laws: Array<DragLawEntry>,
/** The drag law that is assumed. */
usual_drag_law: string,
/** Families of restitution laws that the inference weighs. */
restitution_laws: Array<string>,
/** What an impact can sound like. */
voices: Array<string>,
/** Where one may drop a ball. */
worlds: Array<World>,
/** The air that is assumed. */
usual_air: MoistAir,
/** Standard gravity. */
standard_gravity_m_s2: number,
/** An impact below this probability counts as uncertain. */
sure: number, };

export type CorrectedSummary = {
/** Median over the impacts. */
restitution: number, restitution_sd: number | null, impacts: number, slowest_m_s: number, fastest_m_s: number, };

export type Correlations = { quantities: Array<string>, matrix: Array<Array<number>>, };

/** A made-up drop to try things with. */
export type Demo = {
/** Name of the recording. */
name: string,
/** What a person would say of it. */
settings: Settings,
/** Restitution with which it was made. */
restitution: number,
/** Height from which it was made to fall. */
drop_height_m: number, };

export type DocumentDrop = { impacts: Array<DocumentImpact>, flights: Array<DocumentFlight>, regression: StraightLine | null, corrected: CorrectedSummary | null, estimate: Inference | null,
/** Why there is no estimate. */
no_estimate: string | null, warnings: Array<string>, };

export type DocumentFlight = { number: number, time_s: number, in_regression: boolean,
/** g T^2/8, without drag (paper, Eq. 5). */
plain_height_m: number,
/** Apex and launch speed by the flight model. */
apex_m: number | null, apex_sd_m: number | null, launch_speed_m_s: number | null, };

export type DocumentImpact = { number: number, time_s: number, sigma_s: number | null, probability: number, level_db: number | null,
/** Speed before the impact, drag-corrected; unknown for the first and last. */
impact_speed_m_s: number | null, restitution: number | null, restitution_sd: number | null,
/** The ratio of the flights after and before: restitution if there were no air. */
plain_restitution: number | null, };

/** Drag over weight against speed. */
export type DragCurve = {
/** The drag law. */
law: string,
/** Whether it is the law of the settings; else it is a constant coefficient to compare with. */
chosen: boolean,
/** Speeds. */
speed_m_s: Array<number>,
/** Drag over weight at each. */
drag_over_weight: Array<number>, };

/** A drag law. */
export type DragLawEntry = {
/** Name, as in settings. */
name: string,
/** Upper end of its range; `null` if it has none. */
max_reynolds: number | null, };

/** A figure. */
export type Drawn = {
/** Name, also of its file. */
name: string,
/** Title. */
title: string,
/** One sentence on what to see in it. */
caption: string,
/** The picture. */
svg: string,
/** Its natural width. */
width_px: number,
/** Its natural height. */
height_px: number, };

/** Equally likely values of the answers; those with the same index belong together. */
export type Draws = {
/** Restitution at the stated speed. */
restitution: Array<number>,
/** Drag coefficient; empty if there is no drag. */
drag_coefficient: Array<number>,
/** Drop height. */
drop_height_m: Array<number>, };

/** The impacts of one drop, as they are to be analysed. */
export type DropMarks = {
/** Its impacts, in order of time. */
impacts: Array<Mark>,
/** Whether a hand has changed them: then they are numbered anew. */
edited: boolean, };

/** How far to go. */
export type Effort = "quick" | "full";

/** What became of the energy at an impact and in the flight before it. */
export type Energy = {
/** Number of the impact. */
number: number,
/** Kinetic energy just before it. */
before_j: number,
/** What the surface took. */
lost_to_surface_j: number,
/** What the air took in the flight after it. */
lost_to_air_j: number, };

/** An explanation whose restitution was chosen so that the straight line says e = 0.9375. */
export type Explanation = {
/** The restitution law. */
restitution_law: string,
/** The drag. */
drag: string,
/** Flights in the straight line. */
flights: number,
/** Restitution at the first impact. */
restitution_at_first: number,
/** Restitution at 0.5 m/s. */
restitution_at_slow: number,
/** The height that the straight line gives, m. */
drop_height_m: number,
/** Whether that is the paper's, to its digits. */
reproduces: boolean, };

/** What was heard in a recording, or read from a list of times. */
export type Heard = {
/** Name, as it goes into the document. */
name: string,
/** Where the times come from. */
source: Origin,
/** The drops, in order of time. */
drops: Array<HeardDrop>,
/** Why there is none. */
no_drop: string | null,
/** What is odd about the recording. */
warnings: Array<string>, };

/** The impacts of one drop. */
export type HeardDrop = {
/** How sure it is that this is a drop. */
probability: number,
/** Its impacts, in order of time. */
impacts: Array<Mark>, };

/** Height against time. */
export type HeightCurve = {
/** Times. */
time_s: Array<number>,
/** Height of the lowest point of the ball at each. */
height_m: Array<number | null>, };

/** What the times of a drop say, all priors and models considered. */
export type Inference = { restitution: Posterior,
/** The impact speed of `restitution`. */
at_speed_m_s: number,
/** -d ln e/d ln v there. */
restitution_slope: Posterior, drop_height_m: Posterior, drag_coefficient: Posterior | null,
/** The Reynolds number of `drag_coefficient`. */
drag_reynolds: number | null, drag_coefficient_prior: Prior | null, terminal_speed_m_s: Posterior | null, gravity_m_s2: Posterior,
/** Standard deviation of ln e from impact to impact. */
restitution_scatter: Posterior, timing_s: Posterior, contact_time_s: Posterior, total_time_s: Posterior | null, total_path_m: Posterior | null, missed_first_impacts: Array<number> | null, predictions: Array<Prediction>, impacts: Array<InferredImpact>,
/** The restitution law over the impact speed. */
band: Array<BandPoint>, models: Array<ModelWeight>, narrowed: Array<Narrowed>, correlations: Correlations, budget: Budget, sampling: Sampling, priors: Array<string>, remarks: Array<string>, };

/** What may be left to the data. */
export type Inferred = "gravity" | "drag" | "contact-time";

export type InferredImpact = { number: number, impact_speed_m_s: Posterior, restitution: Posterior | null, apex_m: Posterior | null, lost_to_surface_j: Posterior | null, lost_to_air_j: Posterior | null, standardised_residual: number | null, weight: number, };

/** Why sound that can be decoded is of no use. */
export type LayoutProblem = { "code": "too-slow",
/** Samples a second. */
sample_rate_hz: number,
/** The fewest that are of use. */
least_hz: number, } | { "code": "too-fast",
/** Samples a second. */
sample_rate_hz: number,
/** The most that are read. */
most_hz: number, } | { "code": "too-many-channels",
/** How many. */
channels: number,
/** The most that are read. */
most: number, };

/** What a file looks like that is not sound. */
export type LooksLike = "png" | "jpeg" | "gif" | "pdf" | "zip" | "gzip" | "riff" | "caf" | "zeros" | "text" | "unknown";

/** An impact as heard, or as set by hand. */
export type Mark = {
/** Number, 1 for the first impact known; a missed one leaves a gap. */
number: number,
/** Time. */
time_s: number,
/** Standard error of the time; `null` if set by hand. */
sigma_s: number | null,
/** Probability that it is an impact of this drop; 1 if set by hand. */
probability: number,
/** Level relative to full scale; `null` if it was not heard. */
level_db: number | null, };

/** What a file that is empty lacks. */
export type MissingContent = "content" | "sound" | "time";

export type ModelWeight = { restitution_law: string, drag_law: string, probability: number, log_evidence: number, restitution: Posterior | null, drop_height_m: Posterior | null, };

/** Air by temperature, pressure and humidity. */
export type MoistAir = {
/** Temperature. */
temperature_k: number,
/** Pressure. */
pressure_pa: number,
/** Relative humidity, 0 to 1. */
relative_humidity: number, };

export type Narrowed = { unknown: string,
/** Width after the data over width before. */
remaining: number, };

/** An onset near a time. */
export type OnsetFound = {
/** Time. */
time_s: number,
/** Its standard error. */
sigma_s: number,
/** Level relative to full scale. */
level_db: number, };

/** Where the impact times come from. */
export type Origin = { "kind": "times" } | { "kind": "sound",
/** Format in words. */
format: string,
/** Samples a second. */
sample_rate_hz: number,
/** How many channels the file has. */
channels: number,
/** The channel that was believed, the first being 1. */
channel: number,
/** Length in seconds. */
duration_s: number,
/** How many sounds stand out of the background. */
onsets: number, };

/** The paper as data for other programs. */
export type PaperDocument = { schema: string,
/** Version of the program that made it. */
bouncelab: string, facts: Array<PaperFact>,
/** What would make the straight line say what it says in the paper. */
puzzle: Array<Explanation>, };

export type PaperFact = { chapter: string, quantity: string,
/** As the paper prints it, to its digits; `null` if it does not say. */
printed: string | null, computed: number, unit: string, verdict: string, note: string, };

/** The posterior of one quantity. */
export type Posterior = {
/** The median. */
value: number,
/** Standard deviation. */
sd: number, interval68: [number, number], interval95: [number, number], };

export type Prediction = { bounce: number, apex_m: number, drop_height_m: Posterior | null, };

export type Prior = { value: number, sd: number, };

/** A bounce and the apex that it is to reach. */
export type Reach = {
/** Number of the bounce, 1 for the first. */
bounce: number,
/** Apex of the flight after it. */
apex_m: number, };

/** What exactly is wrong with a file. The page has words for each in every language. */
export type Reason = { "code": "empty",
/** What is missing. */
what: MissingContent, } | { "code": "not-sound",
/** What it looks like. */
looks_like: LooksLike, } | { "code": "malformed",
/** The container, for example "MP4". */
format: string,
/** What was being done. */
stage: Stage,
/** The complaint of the reader or decoder, in English. */
detail: string, } | { "code": "no-audio-track",
/** The container. */
format: string, } | { "code": "unsupported-codec",
/** The container. */
format: string,
/** The codec, and what about it is not supported, in English. */
codec: string, } | { "code": "unsupported-layout",
/** Why. */
problem: LayoutProblem, } | { "code": "times",
/** The line, counted from 1. */
line: number | null,
/** What is wrong. */
problem: TimesProblem, };

/** Why something could not be done. */
export type Refusal = {
/** What kind of trouble it is. */
kind: RefusalKind,
/** What was wrong and what to do, in English. */
message: string,
/** The same for other languages, where it is of a kind that they know. */
reason: Reason | null, };

/** Kinds of trouble that a page may want to tell apart. */
export type RefusalKind = "empty" | "unsupported" | "damaged" | "times" | "setting" | "too-long" | "fault";

/** A restitution law with its numbers. */
export type RestitutionLaw = { "law": "constant",
/** The restitution. */
restitution: number, } | { "law": "linear",
/** Restitution at speed zero. */
at_rest: number,
/** What it loses for each m/s. */
loss_per_speed_s_m: number, } | { "law": "power",
/** Restitution at the reference speed. */
restitution: number,
/** The reference speed. */
at_speed_m_s: number,
/** -d ln e/d ln v. */
exponent: number, } | { "law": "viscoelastic",
/** Restitution at the reference speed. */
restitution: number,
/** The reference speed. */
at_speed_m_s: number, } | { "law": "knee",
/** Restitution below the knee. */
below: number,
/** Speed of the knee. */
knee_speed_m_s: number,
/** What it loses for each m/s above. */
loss_per_speed_s_m: number, };

export type Sampling = { effective_draws: number, pareto_shape: number | null, converged: boolean, };

/** How a simulated drop sounds. */
export type SceneRequest = {
/** What an impact sounds like. */
voice: string,
/** How far the first impact stands above the noise, in dB; without noise if left out. */
snr_db?: number,
/** Samples a second. */
sample_rate_hz: number,
/** Seed of everything random. */
seed: number,
/** Time before the release. */
lead_in_s: number,
/** Time after the last impact. */
tail_s: number, };

/** Points of one drop for the charts, besides those in the document. */
export type Series = {
/** Height against time by the flight model, from impact to impact; `null` parts flights with
 * a missed impact between them. */
measured: HeightCurve,
/** The drop that the best fit would make, from its release; empty without inference. */
simulated: HeightCurve,
/** Time and height of each apex, in the same way. */
apexes: HeightCurve,
/** Energies at each impact with a flight on both sides. */
energies: Array<Energy>,
/** The posterior; empty without inference. */
draws: Draws, };

/** What a person says of ball, air, gravity and drop; what is left out is assumed. */
export type Settings = {
/** Name of a preset, or `steel:0.01` or `glass:0.016` with the diameter in metres. */
ball?: string,
/** Mass of the ball; goes with the diameter, in place of a name. */
mass_kg?: number,
/** Diameter of the ball. */
diameter_m?: number,
/** How long the ball touches the surface. */
contact_time_s?: number,
/** `none`, `constant:0.4` or the name of a drag law. */
drag?: string,
/** Temperature of the air. */
temperature_k?: number,
/** Pressure of the air. */
pressure_pa?: number,
/** Relative humidity of the air, 0 to 1. */
relative_humidity?: number,
/** Density of the air, in place of temperature, pressure and humidity; 0 is vacuum. */
air_density_kg_m3?: number,
/** Viscosity of the air; goes with the density. */
air_viscosity_pa_s?: number,
/** Whether the ball floats in air, if only a little. Usually it does. */
buoyancy?: boolean,
/** Whether air moves with the ball. Usually it does. */
added_mass?: boolean,
/** Gravity. */
gravity_m_s2?: number,
/** Latitude in degrees, north positive, from which gravity follows. */
latitude_deg?: number,
/** Height above the sea; goes with the latitude. */
altitude_m?: number,
/** Measured drop height, surface to lowest point of the ball. */
height_m?: number,
/** Its standard uncertainty; 2 mm if left out. */
height_sd_m?: number,
/** When the ball was released, in the time of the recording. */
release_s?: number,
/** Its standard uncertainty; 5 ms if left out. */
release_sd_s?: number,
/** Whether the first impact heard is the first there was. */
first_heard?: boolean,
/** Families of restitution laws to consider; all that the impacts can tell apart if left out. */
restitution_laws?: Array<string>,
/** What to leave to the data, as if nothing were known of it. */
infer?: Array<Inferred>,
/** First and last flight for the straight line. */
flights?: [number, number],
/** Impact speed at which to state the restitution. */
at_speed_m_s?: number,
/** From which height does a bounce reach an apex? */
reach?: Array<Reach>, };

/** What was known or assumed. */
export type SettingsUsed = { ball_mass_kg: number, ball_diameter_m: number, contact_time_s: number, air_density_kg_m3: number, air_viscosity_pa_s: number, drag: string, buoyancy: boolean, added_mass: boolean, gravity_m_s2: number,
/** What of this nobody stated, in words. */
assumptions: Array<string>, };

export type Share = { source: string, sd: number, share: number, };

/** Simulated drops. */
export type Simulated = {
/** The command line's document, `bouncelab.simulation/1`. */
document: SimulationDocument,
/** Height against time of each simulation in the document. */
curves: Array<HeightCurve>, };

export type Simulation = { drag: string, terminal_speed_m_s: number | null, total_time_s: number, total_path_m: number, initial_energy_j: number, lost_to_surface_j: number, lost_to_air_j: number, bounces: Array<Bounce>, };

/** Drops of the same ball under several drag laws. */
export type SimulationDocument = { schema: string,
/** Version of the program that made it. */
bouncelab: string, ball_mass_kg: number, ball_diameter_m: number, contact_time_s: number, air_density_kg_m3: number, gravity_m_s2: number, assumptions: Array<string>, simulations: Array<Simulation>, };

/** How a simulated drop begins, bounces and ends. */
export type SimulationRequest = {
/** Ball, air, gravity and drag. */
settings: Settings,
/** Height of release. */
height_m: number,
/** What a bounce keeps. */
restitution: RestitutionLaw,
/** Simulate with these drag laws too. */
compare?: Array<string>,
/** Stop when the ball no longer rises above this height; 1 mm if left out. */
until_m?: number,
/** Stop after so many bounces. */
bounces?: number, };

/** What has been heard so far in a recording that is still going on. */
export type SoFar = {
/** How long it has been recording. */
duration_s: number,
/** The drop that goes on or was the last to end; `null` if there is none yet. */
drop: HeardDrop | null,
/** How many drops have been heard. */
drops: number,
/** Best restitution so far, by the straight line. */
restitution: number | null,
/** When the ball will rest, or did, judging by the last impacts. */
rests_at_s: number | null,
/** Whether the ball rests: nothing more will be heard of this drop. */
at_rest: boolean, };

/** What was being done to a file when it turned out to be damaged. */
export type Stage = "header" | "codec" | "sound";

/** The paper's straight line (Eqs. 4 to 8). */
export type StraightLine = { flights: number, slope: number, slope_sd: number | null, intercept: number, intercept_sd: number | null, r_squared: number | null, restitution: number, restitution_sd: number | null, drop_height_m: number, drop_height_sd_m: number | null, energy_kept: number, energy_kept_sd: number | null, total_time_s: number | null, total_path_m: number | null,
/** log10 residuals of the flights that went into it, in order. */
residuals: Array<number>, };

/** What is wrong with a list of impact times, or with one of its lines. */
export type TimesProblem = { "code": "ending" } | { "code": "not-text" } | { "code": "not-table",
/** The complaint of the reader. */
detail: string, } | { "code": "not-array",
/** The complaint of the reader. */
detail: string, } | { "code": "no-time-column",
/** The names that are there. */
found: string, } | { "code": "nameless-columns",
/** How many. */
columns: number, } | { "code": "missing" } | { "code": "not-number",
/** What stands there. */
text: string, } | { "code": "not-later",
/** The time that does not follow. */
time_s: number,
/** The one before it. */
before_s: number, };

/** Gravity and air of a world. */
export type World = {
/** Name, as a key for translation. */
name: string,
/** Gravity at its surface. */
gravity_m_s2: number,
/** Density of its air there. */
air_density_kg_m3: number,
/** Viscosity of its air there; `null` in vacuum. */
air_viscosity_pa_s: number | null, };
