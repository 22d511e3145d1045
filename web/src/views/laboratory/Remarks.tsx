import { computed } from '@preact/signals';
import { perCent } from '../../format/quantity.ts';
import type { Diagnostic, PriorContraction } from '../../lab/index.ts';
import { analysed, drop, refining } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';

/** Warnings that describe the ball and its surface: nothing is to be done about them. */
const DESCRIPTIONS = new Set(['impacts-odd', 'scatter-exceeds-prior', 'never-rests']);

/** The diagnostics of the drop and its recording; an error is why there is no answer, which stands in its place. */
const diagnostics = computed(() => {
  const ofDrop = drop.value?.diagnostics.filter(({ severity }) => severity !== 'error') ?? [];
  return [...ofDrop, ...(drop.value ? (analysed.value?.document.diagnostics ?? []) : [])];
});
const isWarning = ({ severity, code }: Diagnostic): boolean =>
  severity === 'warning' && !DESCRIPTIONS.has(code);

/** What the reader should look at or do, beside the answer. */
export function Warnings() {
  const warnings = diagnostics.value.filter(isWarning);
  return warnings.length === 0 ? null : <Messages of={warnings} kind="notice" />;
}

/** The other diagnostics, and what the drop can and cannot determine. */
export function Remarks() {
  const others = diagnostics.value.filter((diagnostic) => !isWarning(diagnostic));
  const posterior = drop.value?.posterior;
  const narrowed = posterior?.prior_contraction ?? [];
  // It stays while the inference runs, unfolded if it was.
  if (!posterior && others.length === 0 && !refining.value) return null;
  return (
    <details>
      <summary>{text('page-lab-tells')}</summary>
      <Messages of={others} kind="small" />
      {narrowed.length > 0 && <PriorContractions narrowed={narrowed} />}
    </details>
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
