import { useEffect, useState } from 'preact/hooks';
import { Reported } from '../../app/Blocks.tsx';
import { Figure, useLatest } from '../../chart/Figure.tsx';
import { complete, FIELDS, fieldName, grouping, studyOf, toggle } from '../../state/comparing.ts';
import { engine } from '../../state/engine.ts';
import type { KeptDrop } from '../../store/drops.ts';
import { text } from '../../text/language.ts';
import { Comparison } from './Comparison.tsx';

/** The study of all drops by groups, as `session` of the program computes it. */
export function Groups({ drops }: { readonly drops: readonly KeptDrop[] }) {
  const [tried, setTried] = useState(false);
  const unknown = drops.filter(({ comparable }) => comparable === undefined).length;
  useEffect(() => void complete().finally(() => setTried(true)), [unknown]);
  const request = studyOf(drops, null);
  const isReady = tried || unknown === 0;
  const { answer: studied, isCurrent } = useLatest(
    async () => (isReady ? engine().study(request) : undefined),
    [isReady, request],
  );
  return (
    <div class="stack wide groups" aria-busy={!studied || !isCurrent}>
      <div class="row">
        <h2>{text('page-class-groups')}</h2>
        <fieldset class="ticks">
          <legend class="unseen">{text('page-class-by')}</legend>
          {FIELDS.map((field) => (
            <label key={field} class="check">
              <input
                type="checkbox"
                checked={grouping.value.has(field)}
                onChange={() => toggle(field)}
              />{' '}
              {fieldName(field)}
            </label>
          ))}
        </fieldset>
      </div>
      {studied && (
        <>
          {studied.figure && <Figure chart={studied.figure} />}
          <Reported
            {...studied}
            label={text('page-class-report')}
            name="bouncelab-drops"
            report={(made) => engine().studyReport(studyOf(drops, made))}
          >
            <Comparison drops={drops} />
          </Reported>
        </>
      )}
    </div>
  );
}
