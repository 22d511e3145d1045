import type { TargetedEvent } from 'preact';
import { useState } from 'preact/hooks';

/**
 * A text field that is taken when the reader leaves it or presses Enter: its attributes. Until then, and until what takes it has
 * ended, it shows what was typed, however often the page around it is drawn.
 */
export function useTyped(value: string, take: (typed: string) => unknown) {
  const [typed, setTyped] = useState<string>();
  type Event = TargetedEvent<HTMLInputElement>;
  return {
    value: typed ?? value,
    onInput: ({ currentTarget: { value: text } }: Event) =>
      setTyped(text === value ? undefined : text),
    onChange: async ({ currentTarget: { value: text } }: Event) => {
      try {
        await take(text);
      } finally {
        setTyped((now) => (now === text ? undefined : now));
      }
    },
  };
}
