import {
  between,
  fixed,
  lengthUnit,
  METRE,
  METRE_PER_SECOND,
  MILLISECOND,
  PERCENT,
  PLAIN,
  plain,
  SECOND,
  type Unit,
  uncertain,
} from '../../format/quantity.ts';
import type { Drop, Estimate } from '../../lab/index.ts';
import { drop } from '../../state/workspace.ts';
import { language, texts } from '../../text/language.ts';

/** A quantity in the list. */
interface Entry {
  readonly name: string;
  readonly value: string;
  readonly note?: string | undefined;
}

/** Every number with its uncertainty, interval and unit. */
export function Numbers() {
  const result = drop.value;
  if (!result) return null;
  const entries = entriesOf(result);
  if (entries.length === 0) return null;
  return (
    <details>
      <summary>{texts.value.lab.more}</summary>
      <p class="small soft">{texts.value.words.restitution}</p>
      <dl class="facts">
        {entries.map((entry) => (
          <>
            <dt>{entry.name}</dt>
            <dd>
              {entry.value}
              {entry.note !== undefined && <small>{entry.note}</small>}
            </dd>
          </>
        ))}
      </dl>
    </details>
  );
}

function entriesOf(result: Drop): Entry[] {
  return [...inferredEntries(result), ...lineEntries(result)];
}

function inferredEntries({ posterior }: Drop): Entry[] {
  if (!posterior) return [];
  const words = texts.value.quantities;
  const spoken = language.value;
  const entry = (name: string, estimate: Estimate | null, unit: Unit): Entry[] => {
    if (!estimate) return [];
    const { value, sd, interval95: ends } = estimate;
    if (sd === null || ends === null) return [];
    // As the slope of a restitution that is surely constant: an interval would be of noughts only.
    if (ends[0] === ends[1]) {
      const only = plain(value, unit, 3, spoken);
      return [{ name, value: only, note: words.interval(only) }];
    }
    const note = words.interval(between(ends, sd, unit, texts.value.to, spoken));
    return [{ name, value: uncertain(value, sd, unit, spoken), note }];
  };
  const speed = plain(posterior.at_speed_m_s, METRE_PER_SECOND, 3, spoken);
  const height = posterior.drop_height_m;
  return [
    ...entry(`${words.restitution} ${words.atSpeed(speed)}`, posterior.restitution, PLAIN),
    ...entry(words.slope, posterior.restitution_slope, PLAIN),
    ...entry(words.dropHeight, height, lengthUnit(height.value)),
    ...entry(words.drag, posterior.drag_coefficient, PLAIN),
    ...entry(words.terminal, posterior.terminal_speed_m_s, METRE_PER_SECOND),
    ...entry(words.totalTime, posterior.total_time_s, SECOND),
    ...entry(words.totalPath, posterior.total_path_m, METRE),
    ...entry(words.scatter, posterior.restitution_scatter, PERCENT),
    ...entry(words.timing, posterior.timing_s, MILLISECOND),
    ...entry(words.contact, posterior.contact_time_s, MILLISECOND),
  ];
}

function lineEntries({ per_impact, log_linear_fit: line }: Drop): Entry[] {
  const words = texts.value.quantities;
  const spoken = language.value;
  const entry = (name: string, estimate: Estimate | null | undefined, unit: Unit): Entry[] =>
    estimate ? [{ name, value: uncertain(estimate.value, estimate.sd, unit, spoken) }] : [];
  const corrected = entry(words.corrected, per_impact?.restitution, PLAIN);
  if (!line) return corrected;
  return [
    ...corrected,
    ...entry(words.lineRestitution, line.restitution, PLAIN),
    ...entry(words.lineHeight, line.drop_height_m, lengthUnit(line.drop_height_m.value)),
    ...entry(words.energyKept, line.energy_kept, PERCENT),
    { name: words.lineFlights, value: fixed(line.flights, 0, spoken) },
  ];
}
