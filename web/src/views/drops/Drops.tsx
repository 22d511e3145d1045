import { useEffect } from 'preact/hooks';
import { focusPage } from '../../app/focus.ts';
import { Lasting } from '../../app/Lasting.tsx';
import { Rich } from '../../app/Rich.tsx';
import { CommaTick } from '../../app/Tick.tsx';
import { estimated, PERCENT, rounded } from '../../format/quantity.ts';
import { areAlike } from '../../state/comparing.ts';
import {
  bringBack,
  canKeep,
  compared,
  deleted,
  kept,
  loadKept,
  remove,
} from '../../state/keeping.ts';
import { labAddress } from '../../state/settings.ts';
import { spreadOf } from '../../state/spread.ts';
import { language, parts, text } from '../../text/language.ts';
import { Archive } from './Archive.tsx';
import { Bulk, DropTable } from './DropTable.tsx';
import { saveDropsCsv, saveDropsJson } from './export.ts';
import { Gather } from './Gather.tsx';
import { Groups } from './Groups.tsx';
import { Judged } from './Judged.tsx';
import { LessonMaker } from './LessonMaker.tsx';

/** The drops that were kept, side by side. */
export function Drops() {
  const chosen = compared.value;
  const isEmpty = kept.value.length === 0;
  // Another window may have kept one meanwhile.
  useEffect(() => void loadKept(), []);
  return (
    <div class="stack wide drops">
      <div class="row">
        <h1>{text('page-drops-title')}</h1>
        <LessonMaker />
      </div>
      {!canKeep.value && <p class="notice">{text('page-drops-unavailable')}</p>}
      <Undo />
      <div class={isEmpty ? 'stack' : 'pairs'}>
        <div class="stack">
          {canKeep.value && <Gather />}
          {isEmpty ? (
            <>
              <p class="lead soft">{text('page-drops-empty')}</p>
              <div>
                <a class="button primary" href={labAddress.value}>
                  {text('page-drops-to-lab')}
                </a>
              </div>
            </>
          ) : (
            <>
              <Scatter />
              <DropTable chosen={chosen} />
              <Bulk />
            </>
          )}
        </div>
        {!isEmpty && <Groups drops={chosen} />}
      </div>
      {!isEmpty && <Judged drops={chosen} />}
      {!isEmpty && <Saving />}
    </div>
  );
}

/** The table as files, and how long the browser keeps it. */
function Saving() {
  return (
    <>
      <div class="row">
        <button type="button" class="quiet" onClick={() => saveDropsCsv(kept.peek())}>
          {text('page-drops-csv')}
        </button>
        <button type="button" class="quiet" onClick={() => saveDropsJson(kept.peek())}>
          {text('page-drops-json')}
        </button>
        <button
          type="button"
          class="quiet"
          onClick={() => {
            focusPage();
            void remove(kept.peek());
          }}
        >
          {text('page-drops-delete-all')}
        </button>
      </div>
      <CommaTick />
      <Archive />
      <p class="small soft">
        <Lasting />
      </p>
    </>
  );
}

/** The way back after a deletion. */
function Undo() {
  const gone = deleted.value;
  const name = gone[0]?.name ?? '';
  return (
    <div role="status">
      {gone.length > 0 && (
        <p class="notice">
          {gone.length === 1
            ? text('page-drops-deleted', { name })
            : text('page-drops-deleted-all', { count: gone.length })}{' '}
          <button
            type="button"
            class="quiet slim"
            onClick={() => {
              focusPage();
              void bringBack();
            }}
          >
            {text('page-app-undo')}
          </button>
        </p>
      )}
    </div>
  );
}

/** Mean and scatter in words: the first thing a teacher wants to see. */
function Scatter() {
  const spoken = language.value;
  const chosen = compared.value;
  // The mean of unlike balls is that of none.
  if (!areAlike(chosen)) return null;
  const spread = spreadOf(chosen.map(({ restitution }) => restitution));
  if (!spread || spread.scatter === null) return null;
  const points = (value: number): string => rounded(value, 2, PERCENT, spoken);
  return (
    <p class="lead">
      <Rich
        parts={parts('page-drops-scatter-sentence', {
          mean: estimated(spread.mean, spread.meanSd, PERCENT, spoken),
          scatter: points(spread.scatter),
          inside: spread.claimed === null ? '?' : points(spread.claimed),
        })}
      />
    </p>
  );
}
