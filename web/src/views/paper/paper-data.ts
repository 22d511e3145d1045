import { signal } from '@preact/signals';
import type { VNode } from 'preact';
import { useEffect } from 'preact/hooks';
import type { PaperDocument } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';
import { messages } from '../../text/language.ts';

const document = signal<PaperDocument | null>(null);

/** What the engine computes of the paper, in the language of the page, only when it is looked at. */
export function Facts({ children }: { readonly children: (document: PaperDocument) => VNode }) {
  useEffect(() => {
    engine()
      .paper()
      .then(
        (paper) => {
          document.value = paper;
        },
        // The engine's own notice is on the page already.
        () => undefined,
      );
  }, [messages.value]);
  return document.value ? children(document.value) : null;
}
