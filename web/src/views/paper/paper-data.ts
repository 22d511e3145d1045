import { signal } from '@preact/signals';
import type { VNode } from 'preact';
import { useEffect } from 'preact/hooks';
import type { PaperDocument } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';

const document = signal<PaperDocument | null>(null);

/** What the engine computes of the paper, asked once and only when it is looked at. */
export function Facts({ children }: { readonly children: (document: PaperDocument) => VNode }) {
  useEffect(() => {
    if (document.peek()) return;
    engine()
      .paper()
      .then(
        (paper) => {
          document.value = paper;
        },
        // The engine's own notice is on the page already.
        () => undefined,
      );
  }, []);
  return document.value ? children(document.value) : null;
}
