import { perCent } from '../../format/quantity.ts';
import type { Diagnostic, PriorContraction, Unknown } from '../../lab/index.ts';
import { analysed, drop, refining } from '../../state/workspace.ts';
import { language, texts } from '../../text/language.ts';
import type { Texts } from '../../text/texts.ts';

/** What is odd about the drop and its recording, and what it can and cannot determine. */
export function Remarks() {
  const result = drop.value;
  if (!result) return null;
  const all = [...result.diagnostics, ...(analysed.value?.document.diagnostics ?? [])];
  const warnings = all.filter(({ severity }) => severity === 'warning');
  const others = all.filter(({ severity }) => severity !== 'warning');
  const narrowed = result.posterior?.prior_contraction ?? [];
  return (
    <>
      {warnings.length > 0 && <Messages of={warnings} kind="notice" />}
      {/* It stays while the inference runs, unfolded if it was. */}
      {(result.posterior || others.length > 0 || refining.value) && (
        <details>
          <summary>{texts.value.lab.tells}</summary>
          <Messages of={others} kind="small" />
          {narrowed.length > 0 && <Narrowed narrowed={narrowed} />}
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

/** What may be unknown before the data, by the names of the quantities. */
const UNKNOWNS: Readonly<Record<Unknown, (words: Texts) => string>> = {
  drag: ({ quantities }) => quantities.drag,
  slope: ({ quantities }) => quantities.slope,
  scatter: ({ quantities }) => quantities.scatter,
  timing: ({ quantities }) => quantities.timing,
  'contact-time': ({ quantities }) => quantities.contact,
  gravity: ({ settings }) => settings.gravity,
};

/** How far the data narrowed what was known: the shorter the bar, the more was learnt. */
function Narrowed({ narrowed }: { readonly narrowed: readonly PriorContraction[] }) {
  const words = texts.value.lab;
  return (
    <>
      <p class="small">{words.narrowedLead}</p>
      <ul class="narrowed small">
        {narrowed.map(({ unknown, remaining }) => {
          const share = Math.min(1, Math.max(0, remaining));
          return (
            <li key={unknown}>
              <span>
                {words.narrowed(UNKNOWNS[unknown](texts.value), perCent(share, language.value))}
              </span>
              <meter min={0} max={1} value={share} aria-hidden="true" />
            </li>
          );
        })}
      </ul>
    </>
  );
}
