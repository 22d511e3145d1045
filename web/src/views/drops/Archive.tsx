import { useState } from 'preact/hooks';
import { FaultNotice } from '../../app/FaultNotice.tsx';
import { FileButton } from '../../app/FileButton.tsx';
import { save } from '../../app/save.ts';
import { addArchive, archive, archiveFaultOf } from '../../state/archiving.ts';
import { faultOf } from '../../state/engine.ts';
import type { Fault } from '../../state/faults.ts';
import { kept } from '../../state/keeping.ts';
import { text } from '../../text/language.ts';

/** Saves everything that was kept as one file, and adds such a file. */
export function Archive() {
  const [said, say] = useState('');
  const [fault, setFault] = useState<Fault>();
  const [isBusy, setBusy] = useState(false);

  const work = async (
    beginning: string,
    task: () => Promise<string>,
    faultIn: (error: unknown) => Fault,
  ): Promise<void> => {
    setBusy(true);
    setFault(undefined);
    say(beginning);
    say(
      await task().catch((error: unknown) => {
        setFault(faultIn(error));
        return '';
      }),
    );
    setBusy(false);
  };
  const saveAll = async (): Promise<string> => {
    save(await archive(), 'bouncelab-drops.zip');
    return '';
  };
  const add = async (file: File): Promise<string> =>
    text('page-drops-added', { count: await addArchive(file) });

  return (
    <div class="stack">
      <div class="row">
        {kept.value.length > 0 && (
          <button
            type="button"
            class="quiet"
            disabled={isBusy}
            onClick={() => void work(text('page-drops-archiving'), saveAll, faultOf)}
          >
            {text('page-drops-archive')}
          </button>
        )}
        <FileButton
          label={text('page-drops-add-label')}
          accept=".zip,application/zip"
          disabled={isBusy}
          onFile={(file) =>
            void work(
              text('page-drops-adding', { name: file.name }),
              () => add(file),
              archiveFaultOf,
            )
          }
        >
          {text('page-drops-add')}
        </FileButton>
      </div>
      <p role="status" class="small">
        {said}
      </p>
      {fault && <FaultNotice fault={fault} />}
    </div>
  );
}
