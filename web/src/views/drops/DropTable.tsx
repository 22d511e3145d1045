import { handFocusOn } from '../../app/focus.ts';
import { estimated, LENGTH, NUMBER, rounded } from '../../format/quantity.ts';
import { ballOf, presetOf } from '../../state/comparing.ts';
import { catalogue } from '../../state/engine.ts';
import { alter, kept, openKept, remove, stateBallOf, tick, ticked } from '../../state/keeping.ts';
import { spreadOf } from '../../state/spread.ts';
import { busy } from '../../state/workspace.ts';
import type { KeptDrop } from '../../store/drops.ts';
import { language, region, text } from '../../text/language.ts';
import { ballName } from '../../text/names.ts';

/** One row for each drop, and their mean and scatter. */
export function DropTable({ chosen }: { readonly chosen: readonly KeptDrop[] }) {
  return (
    <section class="scroll" tabIndex={0} aria-label={text('page-drops-title')}>
      <table class="wide">
        <thead>
          <tr>
            <th>{text('page-drops-compare')}</th>
            <th>{text('page-drops-name')}</th>
            <th class="figure">{text('page-drops-e')}</th>
            <th class="figure">{text('page-drops-h')}</th>
            <th>{text('page-drops-when')}</th>
            <th>{text('page-drops-ball')}</th>
            <th>{text('page-class-surface')}</th>
            <th>{text('page-class-student')}</th>
            <th class="figure">{text('page-drops-impacts')}</th>
            <th>{text('page-drops-actions')}</th>
          </tr>
        </thead>
        <tbody>
          {kept.value.map((drop) => (
            <Row key={drop.id} drop={drop} />
          ))}
        </tbody>
        {chosen.length > 1 && <Summary chosen={chosen} />}
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
        <input
          class="name"
          aria-label={text('page-drops-rename', { name: drop.name })}
          value={drop.name}
          maxLength={120}
          onChange={(event) => {
            const name = event.currentTarget.value.trim();
            // A drop always has a name: an empty one is replaced by the previous name.
            if (name === '') event.currentTarget.value = drop.name;
            else void alter(drop.id, { name });
          }}
        />
      </td>
      <td class="figure">{e ? estimated(e.value, e.sd, NUMBER, spoken) : ''}</td>
      <td class="figure">{h ? estimated(h.value, h.sd, LENGTH, spoken) : ''}</td>
      <td>
        {new Date(drop.keptAt).toLocaleString(region.value, {
          dateStyle: 'short',
          timeStyle: 'short',
        })}
      </td>
      <td>
        <Ball drop={drop} />
      </td>
      {(['surface', 'student'] as const).map((field) => (
        <td key={field}>
          <input
            class="noted"
            aria-label={text(`page-class-${field}-of`, { name: drop.name })}
            value={drop[field]}
            maxLength={60}
            onChange={({ currentTarget: { value } }) =>
              void alter(drop.id, { [field]: value.trim() })
            }
          />
        </td>
      ))}
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
        <th colSpan={2}>
          {text('page-drops-mean')} {text('page-drops-of-drops', { count: chosen.length })}
        </th>
        <td class="figure">{e && estimated(e.mean, e.meanSd, NUMBER, spoken)}</td>
        <td class="figure">{h && estimated(h.mean, h.meanSd, LENGTH, spoken)}</td>
        <td colSpan={6} />
      </tr>
      <tr>
        <th colSpan={2}>{text('page-drops-scatter')}</th>
        <td class="figure">{e?.scatter != null && rounded(e.scatter, 2, NUMBER, spoken)}</td>
        <td class="figure">{h?.scatter != null && rounded(h.scatter, 2, LENGTH, spoken)}</td>
        <td colSpan={6} />
      </tr>
    </tfoot>
  );
}
