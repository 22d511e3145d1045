import { Term } from '../../app/Term.tsx';
import { unbroken } from '../../format/quantity.ts';
import type { QuantityList, Reported } from '../../lab/index.ts';
import { quantities } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** Every reported quantity with its uncertainty, interval and unit, method by method. */
export function Numbers() {
  const main = listsWith(({ level }) => level !== 'details');
  const details = listsWith(({ level }) => level === 'details');
  if (main.length === 0) return null;
  return (
    <details>
      <summary>{text('page-lab-more')}</summary>
      <Term word="uncertainty">±</Term>
      <Lists lists={main} />
      {details.length > 0 && (
        <details>
          <summary>{text('page-lab-other-quantities')}</summary>
          <Lists lists={details} />
        </details>
      )}
    </details>
  );
}

/** The lists with the rows that are wanted, without those that have none. */
function listsWith(isWanted: (row: Reported) => boolean): QuantityList[] {
  return quantities.value
    .map((list) => ({ ...list, rows: list.rows.filter(isWanted) }))
    .filter(({ rows }) => rows.length > 0);
}

function Lists({ lists }: { readonly lists: readonly QuantityList[] }) {
  return (
    <>
      {lists.map(({ method, heading, rows }) => (
        // No landmark: two lists may be of the same method.
        <div key={method}>
          <p class="small listed">{heading}</p>
          <dl class="facts">
            {rows.map((row) => (
              <Row key={`${row.id} ${row.name}`} row={row} />
            ))}
          </dl>
        </div>
      ))}
    </>
  );
}

function Row({ row: { name, symbol, value, note } }: { readonly row: Reported }) {
  return (
    <>
      <dt>{`${name} ${symbol}`.trimEnd()}</dt>
      <dd>
        {unbroken(value)}
        {note !== null && <small>{note.replaceAll(' %', '\u00a0%')}</small>}
      </dd>
    </>
  );
}
