import { FaultNotice } from '../../app/FaultNotice.tsx';
import { ProcessingNotice } from '../../app/ProcessingNotice.tsx';
import { unreadable } from '../../state/settings.ts';
import { busy, fault } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { Orphans } from './Orphans.tsx';
import { RateForm } from './RateForm.tsx';
import { SaveSound } from './SaveSound.tsx';

/** What went wrong or needs attention. */
export function Troubles() {
  return (
    <>
      {fault.value && (
        <FaultNotice fault={fault.value}>
          {(fault.value.key === 'full' || fault.value.key === 'unavailable') && <SaveSound />}
          {fault.value.key === 'rate' && <RateForm />}
        </FaultNotice>
      )}
      <ProcessingNotice />
      {unreadable.value.length > 0 && (
        <p class="notice">
          {text('page-app-unreadable-link', { parts: unreadable.value.join(', ') })}
        </p>
      )}
      {!busy.value && <Orphans />}
    </>
  );
}
