import { computed, signal } from '@preact/signals';
import { handFocusOn } from '../../app/focus.ts';
import { estimated, fixed, NUMBER, rounded, TIME } from '../../format/quantity.ts';
import { choose, remove } from '../../state/editing.ts';
import { analysed, drop, marks, place, selected, workspace } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';
import { CERTAIN, type Mark } from '../../wave/mark.ts';

/** Whether the list is unfolded; the words of the result can ask for it. */
export const listed = signal(false);

/** The impacts as a table: the content of the waveform for screen readers, and with digits. */
export function ImpactTable() {
  return (
    <details
      open={listed.value}
      onToggle={(event) => {
        listed.value = event.currentTarget.open;
      }}
    >
      <summary>{text('page-wave-list')}</summary>
      {listed.value && (
        <>
          {workspace.value?.pyramid && (
            <div class="small soft">
              <p>{text('page-wave-pointer')}</p>
              <p class="mouse">{text('page-wave-keys')}</p>
            </div>
          )}
          <section class="impacts" tabIndex={0} aria-label={text('page-wave-list')}>
            <table>
              <thead>
                <tr>
                  <th class="figure">{text('page-wave-number')}</th>
                  <th class="figure">{text('page-wave-time')}</th>
                  <th class="figure">{text('page-wave-flight')}</th>
                  <th class="figure">{text('page-wave-probability')}</th>
                  <th class="figure">{text('page-wave-level')}</th>
                  <th class="figure">{text('page-wave-restitution')}</th>
                  <th>{text('page-wave-actions')}</th>
                </tr>
              </thead>
              <tbody>
                {marks.value.map((mark, index) => (
                  <Row key={mark.id} mark={mark} index={index} />
                ))}
              </tbody>
            </table>
          </section>
        </>
      )}
    </details>
  );
}

/** Restitutions by the index of their impact, without those in doubt. */
const restitutions = computed(() => {
  const doubtful = analysed.value?.doubtful_restitutions[place.value] ?? [];
  const { impacts = [], per_impact } = drop.value ?? {};
  const places = new Map(impacts.map(({ number }, index) => [number, index]));
  return new Map(
    per_impact?.impacts
      .filter(({ number }) => !doubtful.includes(number))
      .map(({ number, restitution }) => [places.get(number), restitution]),
  );
});

function Row({ mark, index }: { readonly mark: Mark; readonly index: number }) {
  const spoken = language.value;
  const restitution = restitutions.value.get(index);
  const next = marks.value[index + 1];
  const sure = `${fixed(100 * mark.probability, 0, spoken)} %`;
  return (
    <tr class={mark.id === selected.value ? 'chosen' : undefined}>
      <td class="figure">
        <button
          type="button"
          class="quiet slim"
          aria-label={text('page-wave-select', { number: index + 1 })}
          aria-pressed={mark.id === selected.value}
          onClick={() => choose(mark)}
        >
          {index + 1}
        </button>
      </td>
      <td class="figure">{fixed(mark.timeS, 4, spoken)} s</td>
      <td class="figure">{next ? rounded(next.timeS - mark.timeS, 4, TIME, spoken) : ''}</td>
      <td class="figure">
        {mark.probability >= CERTAIN ? sure : <span class="doubt">{sure} ?</span>}
      </td>
      <td class="figure">{mark.levelDb === null ? '' : `${fixed(mark.levelDb, 0, spoken)} dB`}</td>
      <td class="figure">
        {restitution && estimated(restitution.value, restitution.sd, NUMBER, spoken)}
      </td>
      <td>
        <button
          type="button"
          class="quiet slim"
          aria-label={text('page-wave-remove-one', { number: index + 1 })}
          onClick={(event) => {
            handFocusOn(event.currentTarget, 'tr');
            remove(mark.id);
          }}
        >
          {text('page-wave-remove')}
        </button>
      </td>
    </tr>
  );
}
