import type { ComponentChildren } from 'preact';
import type { Fault } from '../state/faults.ts';
import { texts } from '../text/language.ts';

interface Props {
  readonly fault: Fault;
  /** What can be done about it here. */
  readonly children?: ComponentChildren;
}

/** What happened and what to do, where the eye is. */
export function FaultNotice({ fault, children }: Props) {
  const words = texts.value.faults[fault.key];
  const reason = fault.reason && texts.value.reason(fault.reason);
  return (
    <div class="notice" role="alert">
      <p>
        {fault.about !== undefined && <span class="soft">{fault.about}: </span>}
        <strong>{words.what}</strong>
      </p>
      <p>{words.do}</p>
      {reason !== undefined && <p class="small soft">{reason}</p>}
      {fault.detail !== undefined && (
        <p class="small soft" lang="en">
          {fault.detail}
        </p>
      )}
      {children}
    </div>
  );
}
