import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { SOUND_FORMATS } from '../lab/engine/types.ts';
import type { Fault } from '../state/faults.ts';
import { text } from '../text/language.ts';
import { reasonText } from '../text/reason.ts';

interface Props {
  readonly fault: Fault;
  /** What can be done about it here. */
  readonly children?: ComponentChildren;
}

/** What happened and what to do, where the eye is. */
export function FaultNotice({ fault, children }: Props) {
  const reason = fault.reason && reasonText(fault.reason);
  const notice = useRef<HTMLDivElement>(null);
  useEffect(() => notice.current?.scrollIntoView({ block: 'nearest' }), [fault]);
  return (
    <div ref={notice} class="notice" role="alert">
      <p>
        {fault.about !== undefined && <span class="soft">{fault.about}: </span>}
        <strong>{text(`page-faults-${fault.key}-what`)}</strong>
      </p>
      <p>{text(`page-faults-${fault.key}-do`, { formats: SOUND_FORMATS })}</p>
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
