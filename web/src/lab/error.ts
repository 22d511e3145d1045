import type { Refusal, RefusalKind } from './types.ts';

/**
 * Why the laboratory did not do what was asked: what the science refuses, and what can happen to
 * it on the way.
 *
 * - `superseded`: a newer request took its place; nothing to tell anyone.
 * - `cancelled`: the page called it off.
 */
export type LabErrorKind = RefusalKind | 'superseded' | 'cancelled';

export class LabError extends Error {
  readonly kind: LabErrorKind;

  constructor(kind: LabErrorKind, message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = 'LabError';
    this.kind = kind;
  }

  static of({ kind, message }: Refusal): LabError {
    return new LabError(kind, message);
  }

  /** Whether this is no trouble, only a request that no longer matters. */
  static isMoot(error: unknown): boolean {
    return error instanceof LabError && (error.kind === 'superseded' || error.kind === 'cancelled');
  }
}
