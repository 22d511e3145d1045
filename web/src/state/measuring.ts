/** Drops that are analysed concurrently with the workspace, to be kept. */
import type { Drop, DropMarks, Recording, Settings } from '../lab/index.ts';
import type { KeptDrop, Known } from '../store/drops.ts';
import { engine } from './engine.ts';

/** What is kept of an analysis. */
export type Measured = Pick<KeptDrop, 'ball' | 'restitution' | 'dropHeightM' | 'restitutions'> &
  Required<Pick<KeptDrop, 'comparable' | 'marks' | 'settings'>>;

/** Every drop of a recording, as it was detected or with other impacts. */
export async function measure(
  recording: Recording,
  settings: Settings,
  drops?: DropMarks[],
): Promise<readonly Measured[]> {
  const request = engine().request(recording, settings, drops);
  const { document, ball, comparable } = await engine().analyseBeside(request);
  return document.drops.flatMap((result, place) => {
    const marks = request.drops[place];
    if (!marks) return [];
    return { ...summaryOf(result), ball, settings, marks, comparable: comparable[place] ?? null };
  });
}

/** Drops of which only the impacts are known. */
export async function measureMarks(
  drops: DropMarks[],
  settings: Settings,
): Promise<readonly Measured[]> {
  const times = drops[0]?.impacts.map(({ time_s }) => time_s) ?? [];
  return measure(await engine().paste(times.join('\n')), settings, drops);
}

export function summaryOf(
  result: Drop,
): Pick<KeptDrop, 'restitution' | 'dropHeightM' | 'restitutions'> {
  const best = result.posterior;
  return {
    restitution: best && known(best.restitution),
    dropHeightM: best && known(best.drop_height_m),
    restitutions: (result.per_impact?.impacts ?? []).map(({ impact_speed_m_s, restitution }) => ({
      speedMS: impact_speed_m_s,
      value: restitution.value,
    })),
  };
}

const known = ({ value, sd }: Known): Known => ({ value, sd });
