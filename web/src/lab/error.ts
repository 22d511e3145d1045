import type { Reason, Refusal, RefusalKind } from './engine/types.ts';

/**
 * Why the laboratory did not do what was asked: what the science refuses, and what can happen to
 * it on the way.
 *
 * - `superseded`: a newer request took its place; nothing to report.
 * - `cancelled`: the page called it off.
 */
export type LabErrorKind = RefusalKind | 'superseded' | 'cancelled';

/** What exactly is wrong with a file: what the science finds, and what is too much for a browser. */
export type LabReason =
  | Reason
  | { code: 'too-long'; minutes: number; channels: number }
  | { code: 'no-memory' }
  | { code: 'breaks-decoder' };

/** A refusal as it comes out of a worker. */
export type LabRefusal = Omit<Refusal, 'reason'> & { reason: LabReason | null };

export class LabError extends Error {
  readonly kind: LabErrorKind;
  /** The message as data, to be worded in other languages; `null` where there is only the message. */
  readonly reason: LabReason | null;

  constructor(
    kind: LabErrorKind,
    message: string,
    options: ErrorOptions & { reason?: LabReason | null } = {},
  ) {
    super(message, options);
    this.name = 'LabError';
    this.kind = kind;
    this.reason = options.reason ?? null;
  }

  static of({ kind, message, reason }: LabRefusal): LabError {
    return new LabError(kind, message, { reason });
  }

  /** Whether this is no trouble, only a request that no longer matters. */
  static isMoot(error: unknown): boolean {
    return error instanceof LabError && (error.kind === 'superseded' || error.kind === 'cancelled');
  }
}
