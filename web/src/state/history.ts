/** A value with its past and its undone future. Immutable: each step is a new history. */
export interface History<T> {
  readonly past: readonly T[];
  readonly present: T;
  readonly future: readonly T[];
}

/** Steps that are kept, besides the very first; older ones are forgotten. */
const DEPTH = 200;

export function begin<T>(present: T): History<T> {
  return { past: [], present, future: [] };
}

/** A new present; what was undone is gone. */
export function advance<T>(history: History<T>, present: T): History<T> {
  if (present === history.present) return history;
  const [first, ...steps] = [...history.past, history.present];
  const past = [first as T, ...steps.slice(-DEPTH)];
  return { past, present, future: [] };
}

/** A new present that does not count as a step of its own, as between the steps of a drag. */
export function replace<T>(history: History<T>, present: T): History<T> {
  return { ...history, present };
}

export function undo<T>(history: History<T>): History<T> {
  const present = history.past.at(-1);
  if (present === undefined) return history;
  return {
    past: history.past.slice(0, -1),
    present,
    future: [history.present, ...history.future],
  };
}

export function redo<T>(history: History<T>): History<T> {
  const [present, ...future] = history.future;
  if (present === undefined) return history;
  return { past: [...history.past, history.present], present, future };
}

export const canUndo = <T>(history: History<T>): boolean => history.past.length > 0;
export const canRedo = <T>(history: History<T>): boolean => history.future.length > 0;
