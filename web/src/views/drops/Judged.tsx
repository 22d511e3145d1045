import type { Source } from '../../lab/index.ts';
import type { KeptDrop } from '../../store/drops.ts';
import { text } from '../../text/language.ts';
import { Verdict } from '../verdict/Verdict.tsx';

/** Of a kept drop only the impacts are known. */
const TIMES: Source = {
  kind: 'times',
  program: null,
  by_threshold: false,
  of_intervals: false,
  notes: {},
};

/** Kept drops held against a rule: each is a place. */
export function Judged({ drops }: { readonly drops: readonly KeptDrop[] }) {
  const [first] = drops;
  if (!first) return null;
  const areOfOne = new Set(drops.map(({ settings }) => JSON.stringify(settings))).size === 1;
  const places = drops.map(({ name, marks, surface }) => ({
    name,
    surface,
    source: TIMES,
    drops: [marks],
  }));
  return (
    <details>
      <summary>{text('page-verdict-title')}</summary>
      {areOfOne ? (
        <Verdict settings={first.settings} places={places} />
      ) : (
        <p class="notice">{text('page-verdict-unlike')}</p>
      )}
    </details>
  );
}
