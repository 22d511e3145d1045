/** What comes from other people, checked whole before it is kept: what the page shows, it uses without asking. */
import type { KeptDrop } from './drops.ts';
import type { StoredRecording } from './recordings.ts';

type Check = (value: unknown) => boolean;

const isNumber: Check = Number.isFinite;
const isFlag: Check = (value) => typeof value === 'boolean';
/** Of more than anybody writes, less is shown than waited for. */
const MAX_LETTERS = 1000;
export const isText = (value: unknown): value is string =>
  typeof value === 'string' && value.length <= MAX_LETTERS;
export const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const optional =
  (check: Check): Check =>
  (value) =>
    value === undefined || check(value);
const orNull =
  (check: Check): Check =>
  (value) =>
    value === null || check(value);
const object =
  (fields: Record<string, Check>): Check =>
  (value) =>
    isObject(value) && Object.entries(fields).every(([field, check]) => check(value[field]));
const listOf =
  (check: Check, most: number): Check =>
  (value) =>
    Array.isArray(value) && value.length <= most && value.every(check);

/** As many onsets as the detector remembers: no drop has more impacts. */
const MAX_IMPACTS = 4000;

const isPositive: Check = (value) => isNumber(value) && Number(value) >= 0;
const isKnown = orNull(object({ value: isNumber, sd: orNull(isPositive) }));
/** In milliseconds since 1970, as far as dates go. */
const isTime: Check = (value) =>
  isNumber(value) && !Number.isNaN(new Date(Number(value)).getTime());

const isImpact = object({
  number: isNumber,
  time_s: isNumber,
  time_sd_s: optional(orNull(isPositive)),
  sigma_s: optional(orNull(isPositive)),
  probability: isNumber,
  level_db: optional(orNull(isNumber)),
  quiet_before_s: optional(orNull(isNumber)),
  ln_alike: optional(orNull(isNumber)),
});

/** The fields of a group, each of which may be left out. */
const group = (check: Check, fields: readonly string[]): Record<string, Check> =>
  Object.fromEntries(fields.map((field) => [field, optional(check)]));

/** Anything that a setting of no other group is: the engine refuses what it does not know. */
const isSetting: Check = (value) =>
  isNumber(value) ||
  isText(value) ||
  isFlag(value) ||
  listOf(isSetting, MAX_IMPACTS)(value) ||
  isGroup(value);
const isGroup: Check = (value) => isObject(value) && Object.values(value).every(isSetting);

const isSettings = object({
  ball: optional(
    object({
      ...group(isText, ['kind']),
      ...group(isNumber, ['mass_kg', 'diameter_m', 'contact_time_s']),
    }),
  ),
  air: optional(
    object({
      ...group(isText, ['drag']),
      ...group(isNumber, ['temperature_k', 'pressure_pa', 'relative_humidity']),
      ...group(isNumber, ['density_kg_m3', 'viscosity_pa_s']),
      ...group(isFlag, ['buoyancy', 'added_mass']),
    }),
  ),
  gravity: optional(object(group(isNumber, ['gravity_m_s2', 'latitude_deg', 'altitude_m']))),
  drop: optional(
    object({
      ...group(isNumber, ['height_m', 'height_sd_m', 'release_s', 'release_sd_s']),
      ...group(isFlag, ['first_detected']),
    }),
  ),
  ...group(isGroup, ['detection', 'edits', 'analysis', 'inference']),
});

const isWholeRecording = object({
  id: isText,
  name: isText,
  rateHz: isPositive,
  startedAt: isTime,
  gaps: optional(listOf(object({ start_s: isNumber, duration_s: isPositive }), MAX_IMPACTS)),
});

const isWholeDrop = object({
  id: isText,
  name: isText,
  ball: isText,
  keptAt: isTime,
  student: optional(isText),
  surface: optional(isText),
  recording: orNull(isText),
  restitution: isKnown,
  dropHeightM: isKnown,
  restitutions: listOf(object({ speedMS: isNumber, value: isNumber }), MAX_IMPACTS),
  settings: isSettings,
  marks: object({
    edited: isFlag,
    probability: optional(isNumber),
    impacts: listOf(isImpact, MAX_IMPACTS),
  }),
});

export const isRecording = (value: unknown): value is StoredRecording => isWholeRecording(value);

/** Whether the page could have kept it. */
export const isDrop = (value: unknown): value is KeptDrop => isWholeDrop(value);
