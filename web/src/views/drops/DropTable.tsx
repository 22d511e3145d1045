import { computed, signal } from '@preact/signals';
import { Choice } from '../../app/Choice.tsx';
import { handFocusOn } from '../../app/focus.ts';
import { statedInWords } from '../../app/set-up-words.ts';
import { useTyped } from '../../app/typed.ts';
import { estimated, LENGTH, NUMBER, rounded } from '../../format/quantity.ts';
import { areAlike, ballOf, presetOf } from '../../state/comparing.ts';
import { catalogue } from '../../state/engine.ts';
import { alter, kept, openKept, remove, stateBallOf, tick, ticked } from '../../state/keeping.ts';
import { unusualOf } from '../../state/settings.ts';
import { spreadOf } from '../../state/spread.ts';
import { busy } from '../../state/workspace.ts';
import type { KeptDrop } from '../../store/drops.ts';
import { language, region, text } from '../../text/language.ts';
import { ballName } from '../../text/names.ts';

/** The columns that the table can be sorted by, and what of a drop counts. */
const SORTED = {
  name: (drop: KeptDrop) => drop.name,
  e: (drop: KeptDrop) => drop.restitution?.value ?? Number.NEGATIVE_INFINITY,
  h: (drop: KeptDrop) => drop.dropHeightM?.value ?? Number.NEGATIVE_INFINITY,
  when: (drop: KeptDrop) => drop.keptAt,
  ball: ballOf,
  surface: (drop: KeptDrop) => drop.surface,
  student: (drop: KeptDrop) => drop.student,
} as const;
type Column = keyof typeof SORTED;

/** The column that it is sorted by, and whether from its end; as it was kept at first. */
const order = signal<{ readonly column: Column; readonly isReversed: boolean }>({
  column: 'when',
  isReversed: false,
});

const sorted = computed(() => {
  const { column, isReversed } = order.value;
  const keyOf = SORTED[column];
  const compare = (a: string | number, b: string | number): number =>
    typeof a === 'string'
      ? a.localeCompare(String(b), language.value, { numeric: true })
      : a - Number(b);
  const rows = kept.value.toSorted((a, b) => compare(keyOf(a), keyOf(b)));
  return isReversed ? rows.reverse() : rows;
});

function Head({ column, id, figure = false }: { column: Column; id: string; figure?: boolean }) {
  const isChosen = order.value.column === column;
  const direction = order.value.isReversed ? 'descending' : 'ascending';
  return (
    <th class={figure ? 'figure' : undefined} aria-sort={isChosen ? direction : undefined}>
      <button
        type="button"
        class="sort"
        onClick={() => {
          order.value = { column, isReversed: isChosen && !order.value.isReversed };
        }}
      >
        {text(id)}
        {isChosen && <span aria-hidden="true">{order.value.isReversed ? ' ↓' : ' ↑'}</span>}
      </button>
    </th>
  );
}

/** One row for each drop, and their mean and scatter. */
export function DropTable({ chosen }: { readonly chosen: readonly KeptDrop[] }) {
  return (
    <section class="scroll kept" tabIndex={0} aria-label={text('page-drops-title')}>
      <table class="wide">
        <thead>
          <tr>
            <th>{text('page-drops-compare')}</th>
            <Head column="name" id="page-drops-name" />
            <Head column="ball" id="page-drops-ball" />
            <Head column="surface" id="page-class-surface" />
            <Head column="e" id="page-drops-e" figure />
            <Head column="h" id="page-drops-h" figure />
            <Head column="student" id="page-class-student" />
            <Head column="when" id="page-drops-when" />
            <th class="figure">{text('page-drops-impacts')}</th>
            <th>{text('page-drops-actions')}</th>
          </tr>
        </thead>
        <tbody>
          {sorted.value.map((drop) => (
            <Row key={drop.id} drop={drop} />
          ))}
        </tbody>
        {chosen.length > 1 && areAlike(chosen) && <Summary chosen={chosen} />}
      </table>
    </section>
  );
}

function Row({ drop }: { readonly drop: KeptDrop }) {
  const spoken = language.value;
  const { restitution: e, dropHeightM: h } = drop;
  return (
    <tr>
      <td>
        <input
          type="checkbox"
          aria-label={text('page-drops-choose', { name: drop.name })}
          checked={ticked.value.has(drop.id)}
          onChange={() => tick(drop.id)}
        />
      </td>
      <td>
        <Name drop={drop} />
        <Unusual drop={drop} />
      </td>
      <td>
        <Ball drop={drop} />
      </td>
      <Noted drop={drop} field="surface" />
      <td class="figure">{e ? estimated(e.value, e.sd, NUMBER, spoken) : ''}</td>
      <td class="figure">{h ? estimated(h.value, h.sd, LENGTH, spoken) : ''}</td>
      <Noted drop={drop} field="student" />
      <td class="when">
        {new Date(drop.keptAt).toLocaleString(region.value, {
          dateStyle: 'short',
          timeStyle: 'short',
        })}
      </td>
      <td class="figure">{drop.marks.impacts.length}</td>
      <td>
        <span class="row tight">
          <button
            type="button"
            class="quiet slim"
            aria-label={text('page-drops-open-one', { name: drop.name })}
            disabled={busy.value}
            onClick={() => void openKept(drop)}
          >
            {text('page-drops-open')}
          </button>
          <button
            type="button"
            class="quiet slim"
            aria-label={text('page-drops-delete-one', { name: drop.name })}
            onClick={(event) => {
              handFocusOn(event.currentTarget, 'tr');
              void remove([drop]);
            }}
          >
            {text('page-drops-delete')}
          </button>
        </span>
      </td>
    </tr>
  );
}

/** What few drops have and the drop states: a file or link of somebody else may state anything. */
function Unusual({ drop }: { readonly drop: KeptDrop }) {
  const words = statedInWords(unusualOf(drop.settings));
  return words === '' ? null : <span class="small soft">{words}</span>;
}

/** A drop always has a name: an empty one is replaced by the previous name. */
function Name({ drop }: { readonly drop: KeptDrop }) {
  const typed = useTyped(drop.name, async (written) => {
    const name = written.trim();
    if (name !== '') await alter(drop.id, { name });
  });
  const label = text('page-drops-rename', { name: drop.name });
  return <input class="name" aria-label={label} maxLength={120} {...typed} />;
}

interface NotedProps {
  readonly drop: KeptDrop;
  readonly field: 'surface' | 'student';
}

/** What a person writes about a drop. */
function Noted({ drop, field }: NotedProps) {
  const typed = useTyped(drop[field], (written) => alter(drop.id, { [field]: written.trim() }));
  const label = text(`page-class-${field}-of`, { name: drop.name });
  return (
    <td>
      <input class="noted" aria-label={label} maxLength={60} {...typed} />
    </td>
  );
}

/** The ball of a drop, to be corrected: it decides the drag, so the drop is analysed again. */
function Ball({ drop }: { readonly drop: KeptDrop }) {
  const preset = presetOf(drop);
  const balls = catalogue.value?.balls ?? [];
  return (
    <select
      aria-label={text('page-class-ball-of', { name: drop.name })}
      value={preset ?? ''}
      onChange={({ currentTarget: { value } }) => void stateBallOf(drop, value)}
    >
      {!balls.some(({ name }) => name === preset) && (
        <option value={preset ?? ''}>{ballOf(drop)}</option>
      )}
      {balls.map(({ name }) => (
        <option key={name} value={name}>
          {ballName(name)}
        </option>
      ))}
    </select>
  );
}

function Summary({ chosen }: { readonly chosen: readonly KeptDrop[] }) {
  const spoken = language.value;
  const e = spreadOf(chosen.map(({ restitution }) => restitution));
  const h = spreadOf(chosen.map(({ dropHeightM }) => dropHeightM));
  return (
    <tfoot>
      <tr>
        <th colSpan={4}>
          {text('page-drops-mean')} {text('page-drops-of-drops', { count: chosen.length })}
        </th>
        <td class="figure">{e && estimated(e.mean, e.meanSd, NUMBER, spoken)}</td>
        <td class="figure">{h && estimated(h.mean, h.meanSd, LENGTH, spoken)}</td>
        <td colSpan={4} />
      </tr>
      <tr>
        <th colSpan={4}>{text('page-drops-scatter')}</th>
        <td class="figure">{e?.scatter != null && rounded(e.scatter, 2, NUMBER, spoken)}</td>
        <td class="figure">{h?.scatter != null && rounded(h.scatter, 2, LENGTH, spoken)}</td>
        <td colSpan={4} />
      </tr>
    </tfoot>
  );
}

/** States ball and surface of all ticked drops at once. */
export function Bulk() {
  const chosen = kept.value.filter(({ id }) => ticked.value.has(id));
  if (chosen.length === 0) return null;
  return (
    <div class="measures">
      <Choice
        label={text('page-class-all-balls', { count: chosen.length })}
        value=""
        options={[
          ['', '…'],
          ...(catalogue.value?.balls ?? []).map(({ name }) => [name, ballName(name)] as const),
        ]}
        onChange={async (ball) => {
          if (ball !== '') for (const drop of chosen) await stateBallOf(drop, ball);
        }}
      />
      <div class="field">
        <label for="all-surfaces">
          {text('page-class-all-surfaces', { count: chosen.length })}
        </label>
        <input
          id="all-surfaces"
          maxLength={60}
          onChange={async ({ currentTarget: { value } }) => {
            for (const { id } of chosen) await alter(id, { surface: value.trim() });
          }}
        />
      </div>
    </div>
  );
}
