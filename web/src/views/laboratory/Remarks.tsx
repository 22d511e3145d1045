import { perCent } from '../../format/quantity.ts';
import { analysed, drop, refining } from '../../state/workspace.ts';
import { language, texts } from '../../text/language.ts';
import { sentence, translated } from '../../text/remarks.ts';

/** What is odd about the drop, and what the sound can and cannot tell. */
export function Remarks() {
  const said = drop.value;
  if (!said) return null;
  const recording = analysed.value?.document.warnings ?? [];
  const warnings = [...summary.warnings, ...recording];
  const estimate = said.estimate;
  return (
    <>
      {warnings.length > 0 && (
        <ul class="notice remarks">
          {warnings.map((warning) => (
            <li key={warning}>{sentence(warning)}</li>
          ))}
        </ul>
      )}
      {/* It stays while the inference runs, unfolded if it was. */}
      {(estimate || said.no_estimate || refining.value) && (
        <details>
          <summary>{texts.value.lab.tells}</summary>
          <ul class="remarks small">
            {estimate?.remarks.map((remark) => (
              <li key={remark}>{sentence(remark)}</li>
            ))}
            {said.no_estimate && <li>{sentence(said.no_estimate)}</li>}
          </ul>
          {estimate && estimate.narrowed.length > 0 && <Narrowed narrowed={estimate.narrowed} />}
        </details>
      )}
    </>
  );
}

/** How far the data narrowed what was known: the shorter the bar, the more was learnt. */
function Narrowed({
  narrowed,
}: {
  readonly narrowed: readonly { readonly unknown: string; readonly remaining: number }[];
}) {
  const words = texts.value.lab;
  return (
    <>
      <p class="small">{words.narrowedLead}</p>
      <ul class="narrowed small">
        {narrowed.map(({ unknown, remaining }) => {
          const share = Math.min(1, Math.max(0, remaining));
          return (
            <li key={unknown}>
              <span>{words.narrowed(translated(unknown), perCent(share, language.value))}</span>
              <meter min={0} max={1} value={share} aria-hidden="true" />
            </li>
          );
        })}
      </ul>
    </>
  );
}
