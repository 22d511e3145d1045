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
import { language, text } from '../../text/language.ts';

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
      <summary>{text('page-lab-more')}</summary>
      <p class="small soft">{text('page-words-restitution')}</p>
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
  const spoken = language.value;
  const entry = (name: string, estimate: Estimate | null, unit: Unit): Entry[] => {
    if (!estimate) return [];
    const { value, sd, interval95: ends } = estimate;
    if (sd === null || ends === null) return [];
    // As the slope of a restitution that is surely constant: an interval would be of noughts only.
    if (ends[0] === ends[1]) {
      const only = plain(value, unit, 3, spoken);
      return [{ name, value: only, note: text('page-quantities-interval', { range: only }) }];
    }
    const note = text('page-quantities-interval', {
      range: between(ends, sd, unit, text('page-to'), spoken),
    });
    return [{ name, value: uncertain(value, sd, unit, spoken), note }];
  };
  const speed = plain(posterior.at_speed_m_s, METRE_PER_SECOND, 3, spoken);
  const height = posterior.drop_height_m;
  return [
    ...entry(
      `${text('page-quantities-restitution')} ${text('page-quantities-at-speed', { speed })}`,
      posterior.restitution,
      PLAIN,
    ),
    ...entry(text('page-quantities-slope'), posterior.restitution_slope, PLAIN),
    ...entry(text('page-quantities-drop-height'), height, lengthUnit(height.value)),
    ...entry(text('page-quantities-drag'), posterior.drag_coefficient, PLAIN),
    ...entry(text('page-quantities-terminal'), posterior.terminal_speed_m_s, METRE_PER_SECOND),
    ...entry(text('page-quantities-total-time'), posterior.total_time_s, SECOND),
    ...entry(text('page-quantities-total-path'), posterior.total_path_m, METRE),
    ...entry(text('page-quantities-scatter'), posterior.restitution_scatter, PERCENT),
    ...entry(text('page-quantities-timing'), posterior.timing_s, MILLISECOND),
    ...entry(text('page-quantities-contact'), posterior.contact_time_s, MILLISECOND),
  ];
}

function lineEntries({ per_impact, log_linear_fit: line }: Drop): Entry[] {
  const spoken = language.value;
  const entry = (name: string, estimate: Estimate | null | undefined, unit: Unit): Entry[] =>
    estimate ? [{ name, value: uncertain(estimate.value, estimate.sd, unit, spoken) }] : [];
  const corrected = entry(text('page-quantities-corrected'), per_impact?.restitution, PLAIN);
  if (!line) return corrected;
  return [
    ...corrected,
    ...entry(text('page-quantities-line-restitution'), line.restitution, PLAIN),
    ...entry(
      text('page-quantities-line-height'),
      line.drop_height_m,
      lengthUnit(line.drop_height_m.value),
    ),
    ...entry(text('page-quantities-energy-kept'), line.energy_kept, PERCENT),
    { name: text('page-quantities-line-flights'), value: fixed(line.flights, 0, spoken) },
  ];
}
