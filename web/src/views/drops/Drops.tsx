import { useEffect } from 'preact/hooks';
import { focusPage } from '../../app/focus.ts';
import { Rich } from '../../app/Rich.tsx';
import { PERCENT, plain, uncertain } from '../../format/quantity.ts';
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
import { language, texts } from '../../text/language.ts';
import { Comparison } from './Comparison.tsx';
import { DropTable } from './DropTable.tsx';
import { saveDropsCsv, saveDropsJson } from './export.ts';

/** The drops that were kept, side by side. */
export function Drops() {
  const words = texts.value.drops;
  const chosen = compared.value;
  // Another window may have kept one meanwhile.
  useEffect(() => void loadKept(), []);
  return (
    <div class="stack wide drops">
      <h1>{words.title}</h1>
      {!canKeep.value && <p class="notice">{words.unavailable}</p>}
      <Undo />
      {kept.value.length === 0 ? (
        <>
          <p class="lead soft">{words.empty}</p>
          <div>
            <a class="button primary" href={labAddress.value}>
              {words.toLab}
            </a>
          </div>
        </>
      ) : (
        <>
          <Scatter />
          <DropTable chosen={chosen} />
          <div class="row">
            <button type="button" class="quiet" onClick={() => saveDropsCsv(kept.peek())}>
              {words.csv}
            </button>
            <button type="button" class="quiet" onClick={() => saveDropsJson(kept.peek())}>
              {words.json}
            </button>
            <button
              type="button"
              class="quiet"
              onClick={() => {
                focusPage();
                void remove(kept.peek());
              }}
            >
              {words.deleteAll}
            </button>
          </div>
          <Comparison drops={chosen} />
        </>
      )}
    </div>
  );
}

/** The way back after a deletion. */
function Undo() {
  const words = texts.value.drops;
  const gone = deleted.value;
  const name = gone[0]?.name ?? '';
  return (
    <div role="status">
      {gone.length > 0 && (
        <p class="notice">
          {gone.length === 1 ? words.deleted(name) : words.deletedAll(gone.length)}{' '}
          <button
            type="button"
            class="quiet slim"
            onClick={() => {
              focusPage();
              void bringBack();
            }}
          >
            {texts.value.app.undo}
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
  const spread = spreadOf(chosen.map(({ restitution }) => restitution));
  if (!spread || spread.scatter === null) return null;
  const points = (value: number): string => plain(value, PERCENT, 2, spoken);
  return (
    <p class="lead">
      <Rich
        parts={texts.value.drops.scatterSentence(
          uncertain(spread.mean, spread.meanSd, PERCENT, spoken),
          points(spread.scatter),
          spread.claimed === null ? '?' : points(spread.claimed),
        )}
      />
    </p>
  );
}
