import { signal } from '@preact/signals';
import type { ComponentType } from 'preact';
import { useEffect } from 'preact/hooks';
import { broken, messageOf } from '../state/engine.ts';

/** A view whose code is loaded when it is first shown, so that the page itself loads less. */
export function later<P extends object>(load: () => Promise<ComponentType<P>>): ComponentType<P> {
  const loaded = signal<{ readonly View: ComponentType<P> } | null>(null);
  return function Later(properties: P) {
    useEffect(() => {
      load().then(
        (View) => {
          loaded.value = { View };
        },
        (error: unknown) => {
          broken.value = messageOf(error);
        },
      );
    }, []);
    if (loaded.value) return <loaded.value.View {...properties} />;
    return broken.value === null && <div aria-busy="true" />;
  };
}
