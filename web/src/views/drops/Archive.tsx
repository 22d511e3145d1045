import { useRef, useState } from 'preact/hooks';
import { FaultNotice } from '../../app/FaultNotice.tsx';
import { save } from '../../app/save.ts';
import { addArchive, archive, archiveFaultOf } from '../../state/archiving.ts';
import { faultOf } from '../../state/engine.ts';
import type { Fault } from '../../state/faults.ts';
import { kept } from '../../state/keeping.ts';
import { text } from '../../text/language.ts';

/** Saves everything that was kept as one file, and adds such a file. */
export function Archive() {
  const input = useRef<HTMLInputElement>(null);
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
        <input
          ref={input}
          type="file"
          hidden
          aria-label={text('page-drops-add-label')}
          accept=".zip,application/zip"
          onChange={(event) => {
            const file = event.currentTarget.files?.[0];
            if (file) {
              const beginning = text('page-drops-adding', { name: file.name });
              void work(beginning, () => add(file), archiveFaultOf);
            }
            // The same file may be chosen again.
            event.currentTarget.value = '';
          }}
        />
        <button
          type="button"
          class="quiet"
          disabled={isBusy}
          onClick={() => input.current?.click()}
        >
          {text('page-drops-add')}
        </button>
      </div>
      <p role="status" class="small">
        {said}
      </p>
      {fault && <FaultNotice fault={fault} />}
    </div>
  );
}
