import { perCent } from '../../format/quantity.ts';
import type { Diagnostic, PriorContraction } from '../../lab/index.ts';
import { analysed, drop, refining } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';

/** The diagnostics of the drop and its recording, and what the drop can and cannot determine. */
export function Remarks() {
  const result = drop.value;
  if (!result) return null;
  // An error is why there is no answer, which stands in its place.
  const ofDrop = result.diagnostics.filter(({ severity }) => severity !== 'error');
  const all = [...ofDrop, ...(analysed.value?.document.diagnostics ?? [])];
  const warnings = all.filter(({ severity }) => severity === 'warning');
  const others = all.filter(({ severity }) => severity !== 'warning');
  const narrowed = result.posterior?.prior_contraction ?? [];
  return (
    <>
      {warnings.length > 0 && <Messages of={warnings} kind="notice" />}
      {/* It stays while the inference runs, unfolded if it was. */}
      {(result.posterior || others.length > 0 || refining.value) && (
        <details>
          <summary>{text('page-lab-tells')}</summary>
          <Messages of={others} kind="small" />
          {narrowed.length > 0 && <PriorContractions narrowed={narrowed} />}
        </details>
      )}
    </>
  );
}

interface MessagesProps {
  readonly of: readonly Diagnostic[];
  readonly kind: 'notice' | 'small';
}

function Messages({ of, kind }: MessagesProps) {
  return (
    <ul class={`remarks ${kind}`}>
      {of.map(({ message }) => (
        <li key={message}>{message}</li>
      ))}
    </ul>
  );
}

/** The posterior's standard uncertainty over the prior's, as bars: a short bar is a quantity that the data determine. */
function PriorContractions({ narrowed }: { readonly narrowed: readonly PriorContraction[] }) {
  return (
    <>
      <p class="small">{text('page-lab-narrowed-lead')}</p>
      <ul class="narrowed small">
        {narrowed.map(({ unknown, remaining }) => {
          const share = Math.min(1, Math.max(0, remaining));
          return (
            <li key={unknown}>
              <span>
                {text('page-lab-narrowed', {
                  unknown: analysed.value?.unknowns[unknown] ?? unknown,
                  share: perCent(share, language.value),
                })}
              </span>
              <meter min={0} max={1} value={share} aria-hidden="true" />
            </li>
          );
        })}
      </ul>
    </>
  );
}
