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
import type { DocumentDrop, Posterior } from '../../lab/index.ts';
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
  const said = drop.value;
  if (!said) return null;
  const entries = entriesOf(said);
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

function entriesOf(said: DocumentDrop): Entry[] {
  return [...inferredEntries(said), ...lineEntries(said)];
}

function inferredEntries({ estimate }: DocumentDrop): Entry[] {
  if (!estimate) return [];
  const words = texts.value.quantities;
  const spoken = language.value;
  const entry = (name: string, posterior: Posterior | null, unit: Unit): Entry[] => {
    if (!posterior) return [];
    const { value, sd, interval95: ends } = posterior;
    // As the slope of a restitution that is surely constant: an interval would be of noughts only.
    if (ends[0] === ends[1]) {
      const only = plain(value, unit, 3, spoken);
      return [{ name, value: only, note: words.interval(only) }];
    }
    const note = words.interval(between(ends, sd, unit, texts.value.to, spoken));
    return [{ name, value: uncertain(value, sd, unit, spoken), note }];
  };
  const speed = plain(estimate.at_speed_m_s, METRE_PER_SECOND, 3, spoken);
  const height = estimate.drop_height_m;
  return [
    ...entry(`${words.restitution} ${words.atSpeed(speed)}`, estimate.restitution, PLAIN),
    ...entry(words.slope, estimate.restitution_slope, PLAIN),
    ...entry(words.dropHeight, height, lengthUnit(height.value)),
    ...entry(words.drag, estimate.drag_coefficient, PLAIN),
    ...entry(words.terminal, estimate.terminal_speed_m_s, METRE_PER_SECOND),
    ...entry(words.totalTime, estimate.total_time_s, SECOND),
    ...entry(words.totalPath, estimate.total_path_m, METRE),
    ...entry(words.scatter, estimate.restitution_scatter, PERCENT),
    ...entry(words.timing, estimate.timing_s, MILLISECOND),
    ...entry(words.contact, estimate.contact_time_s, MILLISECOND),
  ];
}

function lineEntries({ corrected, regression: line }: DocumentDrop): Entry[] {
  const words = texts.value.quantities;
  const spoken = language.value;
  const entries: Entry[] = [];
  if (corrected) {
    const { restitution, restitution_sd } = corrected;
    const value = uncertain(restitution, restitution_sd, PLAIN, spoken);
    entries.push({ name: words.corrected, value });
  }
  if (!line) return entries;
  const height = line.drop_height_m;
  return [
    ...entries,
    {
      name: words.lineRestitution,
      value: uncertain(line.restitution, line.restitution_sd, PLAIN, spoken),
    },
    {
      name: words.lineHeight,
      value: uncertain(height, line.drop_height_sd_m, lengthUnit(height), spoken),
    },
    {
      name: words.energyKept,
      value: uncertain(line.energy_kept, line.energy_kept_sd, PERCENT, spoken),
    },
    { name: words.lineFlights, value: fixed(line.flights, 0, spoken) },
  ];
}
