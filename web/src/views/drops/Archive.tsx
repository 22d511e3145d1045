import { useState } from 'preact/hooks';
import { FaultNotice } from '../../app/FaultNotice.tsx';
import { save } from '../../app/save.ts';
import { archive } from '../../state/archiving.ts';
import { faultOf } from '../../state/engine.ts';
import type { Fault } from '../../state/faults.ts';
import { text } from '../../text/language.ts';

/** Saves everything that was kept as one file. */
export function Archive() {
  const [fault, setFault] = useState<Fault>();
  const [isBusy, setBusy] = useState(false);
  const saveAll = async (): Promise<void> => {
    setBusy(true);
    setFault(undefined);
    await archive().then(
      (file) => save(file, 'bouncelab-drops.zip'),
      (error: unknown) => setFault(faultOf(error)),
    );
    setBusy(false);
  };
  return (
    <div class="stack">
      <button type="button" class="quiet" disabled={isBusy} onClick={() => void saveAll()}>
        {text('page-drops-archive')}
      </button>
      <p role="status" class="small">
        {isBusy && text('page-drops-archiving')}
      </p>
      {fault && <FaultNotice fault={fault} />}
    </div>
  );
}
