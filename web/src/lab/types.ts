// The types that the laboratory's engine takes and gives, made from those in
// Rust (crates/bouncelab and bouncelab-wasm) by `cargo xtask web`. Do not edit.

/** What the impacts say. */
export type Analysed = {
/** The document of the program, `bouncelab.analysis/2`. */
document: AnalysisDocument,
/** The ball in words. */
ball: string,
/** Settings that look like mistakes of units. */
questions: Array<Diagnostic>,
/** Names of the figures that there are of each drop. */
figures: Array<Array<string>>, };

/** What one file says. */
export type AnalysisDocument = { schema: string,
/** Version of the program that made it. */
bouncelab: string, file: string, settings: SettingsUsed,
/** Where the impact times come from. */
source: Source,
/** The band in which the impacts stand out most, if it is sound with a drop. */
strongest_band: StrongestBand | null,
/** The drops, in order of time. */
drops: Array<Drop>,
/** Why there is none. */
no_drop: Diagnostic | null,
/** What is odd about the recording as a whole. */
diagnostics: Array<Diagnostic>, };

/** What to analyse. */
export type AnalysisRequest = {
/** Name of the recording, as it goes into the document. */
name: string,
/** Where its times come from. */
source: Source,
/** Where its impacts stand out most. */
strongest_band: StrongestBand | null,
/** What is odd about it. */
diagnostics: Array<Diagnostic>,
/** Why there was no drop in it. */
no_drop: Diagnostic | null,
/** The drops. */
drops: Array<DropMarks>,
/** Ball, air, gravity and what else is known. */
settings: Settings,
/** With the inference, or only what takes some milliseconds. */
inference: boolean, };

/** A bounce and the apex that it is to reach. */
export type ApexTarget = {
/** Number of the bounce, 1 for the first. */
bounce: number,
/** Apex of the flight after it, m. */
apex_m: number, };

/** An argument of a diagnostic. */
export type Argument = number | Array<number> | string;

/** An axis. */
export type Axis = {
/** The quantity. */
quantity: string,
/** Its unit; empty for none. */
unit: string,
/** Which values it shows. */
scale: Scale,
/** What of it is drawn. */
ticks: Ticks,
/** Names in place of numbers, one for each row of the height 1, the first on top. What follows a
 * line break is said below the name. */
names: Array<string>, };

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

/** The restitution law at one speed. */
export type BandPoint = {
/** Impact speed, m/s. */
speed_m_s: number,
/** Restitution there. */
restitution: Estimate, };

/** One bounce: an impact and the flight after it. */
export type Bounce = { drag: string, number: number, time_s: number, impact_speed_m_s: number, restitution: number, launch_speed_m_s: number, flight_time_s: number, apex_m: number, lost_to_surface_j: number, lost_to_air_j: number, };

/** The budget of the restitution and of the drop height, largest share first. */
export type Budget = {
/** Of the restitution at the stated speed. */
restitution: Array<Share>,
/** Of the drop height, m. */
drop_height_m: Array<Share>, };

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
usual_air: Conditions,
/** Standard gravity. */
standard_gravity_m_s2: number,
/** An impact below this probability counts as uncertain. */
sure: number, };

/** A chart. Without panels there is nothing to show, and the caption says why. */
export type Chart = {
/** The title. */
title: string,
/** One sentence that says what to see in it. */
caption: string,
/** Relative widths of the columns in which the panels stand. */
columns: Array<number>,
/** The panels. */
panels: Array<Panel>,
/** What stands between whole numbers and decimals in its language. */
decimal_separator: string, };

/** A drop that was kept, to be compared with others. */
export type ComparedDrop = {
/** Its name in the legend. */
name: string,
/** Its restitution, if it is known. */
restitution: number | null,
/** Standard deviation of that. */
restitution_sd: number | null,
/** Speed in m/s and restitution of each impact. */
impacts: Array<[number, number]>, };

/** The weather in the room. */
export type Conditions = {
/** Temperature in kelvin. */
temperature_k: number,
/** Pressure in pascal, as it is at the place (not reduced to sea level). */
pressure_pa: number,
/** Relative humidity from 0 (dry) to 1 (saturated). */
relative_humidity: number, };

/** Correlations between the quantities of interest. */
export type Correlations = {
/** What they are, in order: names as in [`Unknown`], and `restitution` and `drop-height`. */
quantities: Array<string>,
/** From -1 to 1, one row for each quantity. */
matrix: Array<Array<number>>, };

/** The dashes of a line. */
export type Dashes = "solid" | "dashed" | "dotted" | "long";

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

/** Something to know about a result. */
export type Diagnostic = {
/** What it is about. */
code: string,
/** How much it matters. */
severity: Severity,
/** The values that belong to it, by name. */
arguments: { readonly [name: string]: Argument },
/** The sentence for people. The science leaves it out; whoever shows the result adds it, in the
 * language of the reader. */
message?: string, };

/** A drag law. */
export type DragLawEntry = {
/** Name, as in settings. */
name: string,
/** Upper end of its range; `null` if it has none. */
max_reynolds: number | null, };

/** A figure as a picture. */
export type Drawn = {
/** Name, also of its file. */
name: string,
/** The picture. */
svg: string,
/** Its natural width. */
width_px: number,
/** Its natural height. */
height_px: number, };

/** What the impact times of one drop say.
 *
 * What cannot be told is an error in its own place (`null` in JSON), so that the rest remains: two
 * impacts have a flight and a height, but no log-linear fit. */
export type Drop = {
/** Probability that this is a drop; 1 for a list of times. */
probability: number,
/** The impacts, in order of time. */
impacts: Array<Impact>,
/** The flights between successive impacts. */
flights: Array<MeasuredFlight>,
/** The paper's straight line through the logarithms of the flight times. */
log_linear_fit: LogLinearFit | null,
/** Restitution of each impact, corrected for drag. */
per_impact: PerImpact | null,
/** What all of it says together. */
posterior: Posterior | null,
/** What is odd, and what to know before believing it. */
diagnostics: Array<Diagnostic>, };

/** The impacts of one drop, as they are to be analysed. */
export type DropMarks = {
/** Its impacts, in order of time. */
impacts: Array<Impact>,
/** Probability that it is a drop. */
probability: number,
/** Whether the reader has changed the impacts: then they are numbered anew. */
edited: boolean, };

/** A number found from data, with its uncertainty.
 *
 * ```
 * use bouncelab::Estimate;
 *
 * let height_m = Estimate::normal(0.305, 0.002);
 * assert!((height_m.interval95[1] - 0.3089).abs() < 1e-4);
 * assert_eq!(Estimate::unbounded(0.9).known_sd(), None);
 * ``` */
export type Estimate = {
/** The number: of a posterior, the median. */
value: number,
/** Standard uncertainty, in the same unit; infinite if the data leave nothing to judge it by
 * (`null` in JSON). */
sd: number | null,
/** The middle 68.27 %: what one standard deviation either way holds of a normal distribution. */
interval68: [number, number] | null,
/** The middle 95 %. */
interval95: [number, number] | null, };

/** An explanation whose restitution was chosen so that the straight line says e = 0.9375. */
export type Explanation = {
/** The restitution law: `constant`, `viscoelastic`, `linear`, `power` or `knee`. */
restitution_law: string,
/** The drag: `none`, `constant`, `sphere` (the curve of a sphere) or `all-of-air` (with buoyancy and
 * added mass too). */
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

/** An impact as known: of a recording, of a list of times, or set by hand.
 *
 * ```
 * use bouncelab::Impact;
 *
 * let impact = Impact::new(3, 1.2854).with_time_sd_s(5e-5);
 * assert_eq!(impact.probability, 1.0);
 * assert_eq!(impact.level_db, None);
 * ``` */
export type Impact = {
/** Number, 1 for the first impact known; a missed impact leaves a gap. */
number: number,
/** Time in seconds. */
time_s: number,
/** Standard uncertainty of the time in seconds, where it is known; the errors of different
 * impacts are independent. */
time_sd_s: number | null,
/** Probability that this is an impact of the drop; 1 if it was set by hand. */
probability: number,
/** Level in dB relative to full scale, if it was detected in sound. */
level_db: number | null, };

/** An impact heard, and the flight after it. */
export type ImpactPosterior = {
/** Its number. */
number: number,
/** Speed just before it, m/s. */
impact_speed_m_s: Estimate,
/** What it kept of the speed; unknown for the last, and where the next was missed. */
restitution: Estimate | null,
/** Apex of the flight after it, m. */
apex_m: Estimate | null,
/** Energy it took, J. */
lost_to_surface_j: Estimate | null,
/** Energy the air took in the flight after it, J. */
lost_to_air_j: Estimate | null,
/** How far it lies from what the impacts before it foretold, in standard deviations; unknown
 * for the last. */
standardised_residual: number | null,
/** Its weight in the fit: 1 for an impact as good as any, near 0 for an odd one. */
weight: number, };

/** What an impact between two timed flights kept of the speed of the ball. */
export type ImpactRestitution = {
/** Number of the impact. */
number: number,
/** Speed just before the impact, m/s. */
impact_speed_m_s: number,
/** Coefficient of restitution, with the standard error that the three times leave it. */
restitution: Estimate,
/** Ratio of the flight time after the impact to the one before it: the restitution if there
 * were no air. */
flight_time_ratio: number, };

/** An input that may be left to the data, as if nothing were known of it. */
export type Inferred = "gravity" | "drag" | "contact-time";

export type Kind = "linear" | "counting" | "log";

/** Something shown in a panel. */
export type Layer = {
/** Its name in the legend; empty if it has none. Layers of the same name share an entry. */
name: string,
/** What it shows, which decides its colour. */
meaning: string,
/** How much of the colour is mixed with that of the paper, 0 to 1. */
strength: number, } & ({ "kind": "line",
/** Its points in the order of drawing. */
points: [number | null, number | null][],
/** Width in figure pixels. */
width: number,
/** Its dashes. */
dashes: Dashes, } | { "kind": "points",
/** Where they lie. */
points: [number | null, number | null][],
/** Standard error of each vertical value; empty if none is known. */
errors: (number | null)[],
/** How they look. */
marker: Marker, } | { "kind": "band",
/** Horizontal value, lower and upper vertical one. */
points: [number | null, number | null, number | null][], } | { "kind": "boxes",
/** Left, right, bottom and top. */
boxes: [number | null, number | null, number | null, number | null][], } | { "kind": "rule",
/** Its value. */
at: number | null,
/** Whether it is upright, at a horizontal value. */
upright: boolean,
/** Width in figure pixels. */
width: number,
/** Its dashes. */
dashes: Dashes, } | { "kind": "labels",
/** The points. */
points: [number | null, number | null][],
/** A text for each. */
texts: Array<string>, } | { "kind": "marks",
/** The horizontal values, in ascending order. */
places: (number | null)[],
/** The number of each that may be written above it. */
numbers: Array<number>,
/** What may be written above all of them. */
group: string,
/** Whether they are filled. */
filled: boolean, });

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

/** The straight line through log flight time against bounce number, and what follows from it.
 *
 * Intervals are those of Student's t with as many degrees of freedom as there are flights beyond two;
 * with two flights the line is exact and nothing says how certain it is. */
export type LogLinearFit = {
/** How many flights went into it. */
flights: number,
/** Slope a of log₁₀ T<sub>n</sub> against n. */
slope: Estimate,
/** Intercept b of log₁₀ T<sub>n</sub> (T in s) at n = 0. */
intercept: Estimate,
/** Share of the variance of log₁₀ T<sub>n</sub> that the line explains; `None` if all flights
 * last equally long. */
r_squared: number | null,
/** Coefficient of restitution e = 10^a (Eq. 6).
 *
 * Noise can put it above 1, where it says that the flights do not shrink. */
restitution: Estimate,
/** Drop height h₀ = g (10^b)²/8 in m (Eq. 6; printed in the paper without the square). */
drop_height_m: Estimate,
/** Share of the energy that a bounce keeps, e². */
energy_kept: Estimate,
/** Total time from release to rest in s (Eq. 7); `None` if e is not below 1. */
total_time_s: Estimate | null,
/** Total length of the path from release to rest in m (Eq. 8); `None` if e is not below 1. */
total_path_m: Estimate | null,
/** What the line leaves of log₁₀ T<sub>n</sub>, in the order of the flights. */
residuals: Array<number>, };

/** What a file looks like that is not sound. */
export type LooksLike = "png" | "jpeg" | "gif" | "pdf" | "zip" | "gzip" | "riff" | "caf" | "zeros" | "text" | "unknown";

/** How a point looks. */
export type Marker = "dot" | "ring" | "triangle" | "open-triangle" | "speck";

/** A measured quantity. */
export type Measured = {
/** The value. */
value: number,
/** Its standard uncertainty, in the same unit. */
sd: number, };

/** The time between two impacts that follow each other. */
export type MeasuredFlight = {
/** Number of the impact with which it begins. */
number: number,
/** Time between the two impacts in seconds, contact included. */
time_s: number,
/** Whether it goes into the log-linear fit. */
in_fit: boolean,
/** Apex height in metres by g T²/8, without drag (paper Eq. 5). */
drag_free_height_m: number,
/** Apex height in metres by the flight model. */
apex_m: number | null,
/** Standard uncertainty of the apex from the times, in metres. */
apex_sd_m: number | null,
/** Launch speed by the flight model, m/s. */
launch_speed_m_s: number | null, };

/** What a file that is empty lacks. */
export type MissingContent = "content" | "sound" | "time";

/** A model and how it fared. */
export type Model = {
/** Restitution law. */
restitution_law: string,
/** Drag law, which has a scale. */
drag_law: string,
/** Its posterior probability, over all numbers of missed impacts. */
probability: number,
/** Logarithm of its evidence above that of the best. */
log_evidence: number,
/** The restitution if it is true; `None` if it is too improbable to have been sampled. */
restitution: Estimate | null,
/** The drop height if it is true, m. */
drop_height_m: Estimate | null, };

/** A region with two axes. */
export type Panel = {
/** What stands above it; empty for nothing. */
title: string,
/** Its row, from 0 at the top. */
row: number,
/** Its column, from 0 at the left. */
column: number,
/** Height of the region that holds the data, in figure pixels; rows of names take more if they
 * must. */
height: number,
/** The horizontal axis. */
x: Axis,
/** The vertical axis. */
y: Axis,
/** What it shows, the first layer below all others. */
layers: Array<Layer>, };

/** The paper as data for other programs. */
export type PaperDocument = { schema: string,
/** Version of the program that made it. */
bouncelab: string, facts: Array<PaperFact>,
/** What would make the straight line say what it says in the paper. */
puzzle: Array<Explanation>, };

export type PaperFact = {
/** What it is about, in words. */
chapter: string,
/** What it is, as a code that no other number has. */
code: string,
/** What it is, in words. */
quantity: string,
/** As the paper prints it, to its digits; `null` if it does not say. */
printed: string | null, computed: number, unit: string,
/** What the comparison says, as a code; `null` if the paper does not say. */
verdict: string | null,
/** What to know about it. */
note: string | null, };

/** Every flight and restitution that a list of impact times contains. */
export type PerImpact = {
/** The median over the impacts, with its standard error from their scatter: the restitution at the
 * typical speed of the drop. `None` with fewer than three impacts. */
restitution: Estimate | null,
/** The slowest impact with a restitution, m/s. */
slowest_m_s: number | null,
/** The fastest impact with a restitution, m/s. */
fastest_m_s: number | null,
/** Restitutions of impacts with a flight on both sides. */
impacts: Array<ImpactRestitution>, };

/** What the times of one drop say, all priors and models considered. */
export type Posterior = {
/** The impact speed of [`Self::restitution`], m/s. */
at_speed_m_s: number,
/** The restitution law at that speed. */
restitution: Estimate,
/** -d ln e/d ln v at that speed: by how many per cent restitution falls when speed grows by one. */
restitution_slope: Estimate,
/** Height of the fall: before the first impact if a height or release was given, else before
 * the first impact heard, m. */
drop_height_m: Estimate,
/** The drag coefficient at [`Self::drag_reynolds`], if there is drag. */
drag_coefficient: Estimate | null,
/** The Reynolds number of the drag coefficient: of the fastest impact, where drag shows most. */
drag_reynolds: number | null,
/** The drag coefficient before the data. */
drag_coefficient_prior: Measured | null,
/** The terminal speed, m/s, if there is drag and its law reaches it. */
terminal_speed_m_s: Estimate | null,
/** Gravity, m/s². */
gravity_m_s2: Estimate,
/** Standard deviation of ln e from impact to impact. */
restitution_scatter: Estimate,
/** Root mean square standard error of the times, s. */
timing_s: Estimate,
/** Contact time, s. */
contact_time_s: Estimate,
/** From the release until the ball rests, s. */
total_time_s: Estimate | null,
/** Path from the release until the ball rests, m. */
total_path_m: Estimate | null,
/** Probabilities of 0, 1, 2, ... impacts before the first one heard, if a height or a release
 * time tells. */
missed_first_impacts: Array<number> | null,
/** The answers to [`InferenceOptions::reach`](super::InferenceOptions::reach). */
predictions: Array<Prediction>,
/** The impacts heard. */
impacts: Array<ImpactPosterior>,
/** The models that were weighed, most probable first. */
models: Array<Model>,
/** How much the data narrowed what was known. */
prior_contraction: Array<PriorContraction>,
/** Correlations between the answers. */
correlations: Correlations,
/** Where the uncertainty comes from. */
budget: Budget,
/** Whether and how well the sampling worked. */
sampling: Sampling,
/** What was assumed before the data. */
priors: Array<Diagnostic>,
/** The restitution law over the impact speeds, from a little below the slowest to a little above
 * the fastest. */
band: Array<BandPoint>, };

/** The answer to a [`ApexTarget`]. */
export type Prediction = {
/** The drop height, m, with the restitution that the law expects; `None` if no height does. */
drop_height_m: Estimate | null,
/** Number of the bounce, 1 for the first. */
bounce: number,
/** Apex of the flight after it, m. */
apex_m: number, };

/** How much the data narrowed what was known of something. */
export type PriorContraction = {
/** Of what. */
unknown: Unknown,
/** Standard deviation after the data over the one before: 1 if they state nothing, 0 if all. */
remaining: number, };

/** What the straight line makes of a choice. */
export type PuzzleAnswer = {
/** The restitution that it says. */
restitution: number,
/** The drop height that it says, m. */
drop_height_m: number,
/** Whether both are those of the paper, to its digits. */
reproduces: boolean,
/** The drop height that the line finds against how many flights it is given, with and without air. */
chart: Chart, };

/** What a reader chooses: the truth, and how it is looked at. */
export type PuzzleChoice = {
/** Restitution at 1 m/s. */
restitution: number,
/** What it loses for each m/s. */
loss_per_speed_s_m: number,
/** Flights in the straight line. */
flights: number, };

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

/** What a recording, or a list of times, says. */
export type RecordingResult = {
/** Where the impact times come from. */
source: Source,
/** The band in which the impacts stand out most, if it is sound with a drop. */
strongest_band: StrongestBand | null,
/** The drops, in order of time. */
drops: Array<Drop>,
/** Why there is none. */
no_drop: Diagnostic | null,
/** What is odd about the recording as a whole. */
diagnostics: Array<Diagnostic>, };

/** Why something could not be done. */
export type Refusal = {
/** What kind of trouble it is. */
kind: RefusalKind,
/** What was wrong and what to do, in English. */
message: string,
/** The same as data, where the science refused something. */
diagnostic: Diagnostic | null,
/** The same as data, where a file was refused. */
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

/** How the sampling went. */
export type Sampling = {
/** Draws that count as independent. */
effective_draws: number,
/** Shape of the tail of the weights; the answer stands if it is below
 * [`GREATEST_PARETO_SHAPE`](super::GREATEST_PARETO_SHAPE). */
pareto_shape: number | null,
/** Whether it can be trusted. */
converged: boolean, };

/** Which values an axis shows, and how they lie on it. */
export type Scale = { kind: Kind, low: number, high: number, };

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
/** Whether the first impact detected is the first there was. */
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
reach?: Array<ApexTarget>, };

/** What was known or assumed. */
export type SettingsUsed = { ball_mass_kg: number, ball_diameter_m: number, contact_time_s: number, air_density_kg_m3: number, air_viscosity_pa_s: number, drag: string, buoyancy: boolean, added_mass: boolean, gravity_m_s2: number,
/** What of this nobody stated. */
assumptions: Array<Diagnostic>, };

/** How much a diagnostic matters. */
export type Severity = "info" | "warning" | "error";

/** What one source adds to the uncertainty of a quantity. */
export type Share = {
/** The source: a stable name. */
source: string,
/** The standard uncertainty that it alone would leave, in the unit of the quantity. */
sd: number,
/** Its share of the variance, from 0 to 1. */
share: number, };

export type Simulation = { drag: string, terminal_speed_m_s: number | null, total_time_s: number, total_path_m: number, initial_energy_j: number, lost_to_surface_j: number, lost_to_air_j: number, bounces: Array<Bounce>, };

/** Drops of the same ball under several drag laws. */
export type SimulationDocument = { schema: string,
/** Version of the program that made it. */
bouncelab: string, ball_mass_kg: number, ball_diameter_m: number, contact_time_s: number, air_density_kg_m3: number, gravity_m_s2: number, assumptions: Array<Diagnostic>, simulations: Array<Simulation>, };

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

/** A simulated drop to be compared with others. */
export type SimulationRun = {
/** Its name in the legend. */
name: string,
/** What is simulated. */
request: SimulationRequest, };

/** What was detected so far in a recording that is still going on. */
export type SoFar = {
/** How long it has been recording. */
duration_s: number,
/** The drop that goes on or was the last to end, without the inference; `null` if there is none
 * yet. */
drop: Drop | null,
/** How many drops were detected. */
drops: number,
/** When the ball will rest, or did, judging by the last impacts. */
rests_at_s: number | null,
/** Whether the ball rests: no more impacts of this drop will come. */
at_rest: boolean, };

/** Where impact times come from. */
export type Source = { "kind": "times" } | { "kind": "sound",
/** Format of the file, if it is one. */
format: string | null,
/** Samples a second. */
sample_rate_hz: number,
/** How many channels there are. */
channels: number,
/** The channel with the drops, the first being 1. */
channel: number,
/** Length in seconds. */
duration_s: number,
/** How many sounds stand out of the background. */
onsets: number, };

/** What was being done to a file when it turned out to be damaged. */
export type Stage = "header" | "codec" | "sound";

/** A band in which impacts stand out of the background. */
export type StrongestBand = {
/** Lower end in Hz. */
low_hz: number,
/** Upper end in Hz. */
high_hz: number,
/** Median level of the impacts above the background, in dB. */
above_background_db: number, };

/** What is drawn of an axis. */
export type Ticks = "labelled" | "grid" | "hidden";

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

/** Something that was not known before the data. */
export type Unknown = "drag" | "slope" | "scatter" | "timing" | "contact-time" | "gravity";

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
