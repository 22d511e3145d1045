/** What a key does on the waveform; the same list is shown to the reader. */
export type Action =
  | { readonly kind: 'cursor'; readonly by: 1 | -1; readonly fine: boolean }
  | { readonly kind: 'beside'; readonly by: 1 | -1 }
  | { readonly kind: 'nudge'; readonly by: 1 | -1 }
  | { readonly kind: 'edge'; readonly end: boolean }
  | { readonly kind: 'zoom'; readonly closer: boolean }
  | {
      readonly kind: 'whole' | 'add' | 'delete' | 'snap' | 'play' | 'undo' | 'redo' | 'leave';
    };

/** The parts of a keyboard event that decide. */
export interface Key {
  readonly key: string;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
}

export function actionOf(event: Key): Action | undefined {
  if (event.ctrlKey || event.metaKey) return withControl(event);
  switch (event.key) {
    case 'ArrowLeft':
    case 'ArrowRight': {
      const by = event.key === 'ArrowRight' ? 1 : -1;
      return event.altKey ? { kind: 'nudge', by } : { kind: 'cursor', by, fine: event.shiftKey };
    }
    case ',':
    case '.':
      return { kind: 'nudge', by: event.key === '.' ? 1 : -1 };
    case 'PageDown':
    case 'PageUp':
      return { kind: 'beside', by: event.key === 'PageDown' ? 1 : -1 };
    case 'Home':
    case 'End':
      return { kind: 'edge', end: event.key === 'End' };
    case '+':
    case '=':
    case 'ArrowUp':
      return { kind: 'zoom', closer: true };
    case '-':
    case 'ArrowDown':
      return { kind: 'zoom', closer: false };
    case '0':
      return { kind: 'whole' };
    case 'Enter':
    case 'Insert':
      return { kind: 'add' };
    case 'Delete':
    case 'Backspace':
      return { kind: 'delete' };
    case 's':
      return { kind: 'snap' };
    case ' ':
      return { kind: 'play' };
    case 'Escape':
      return { kind: 'leave' };
    default:
      return undefined;
  }
}

function withControl(event: Key): Action | undefined {
  switch (event.key.toLowerCase()) {
    case 'z':
      return { kind: event.shiftKey ? 'redo' : 'undo' };
    case 'y':
      return { kind: 'redo' };
    default:
      return undefined;
  }
}
