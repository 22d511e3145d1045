import { FaultNotice } from '../../app/FaultNotice.tsx';
import { ProcessingNotice } from '../../app/ProcessingNotice.tsx';
import { save } from '../../app/save.ts';
import { orphans } from '../../state/orphans.ts';
import { countInterrupted, keepAgain, open, unkept } from '../../state/series.ts';
import { busy, fault } from '../../state/workspace.ts';
import { region, text } from '../../text/language.ts';

/** What went wrong, and what can be done about it here. */
export function Trouble() {
  const file = unkept.value;
  return (
    <>
      {fault.value && (
        <FaultNotice fault={fault.value}>
          {file && !busy.value && (
            <div class="row">
              <button type="button" class="quiet" onClick={() => void keepAgain()}>
                {text('page-series-keep-again')}
              </button>
              <button type="button" class="quiet" onClick={() => save(file, file.name)}>
                {text('page-series-save-sound')}
              </button>
            </div>
          )}
        </FaultNotice>
      )}
      <ProcessingNotice />
      {open.value && !busy.value && <Interrupted />}
    </>
  );
}

/** Recordings that were cut short, as by a crash: they may be of this series. */
function Interrupted() {
  const cut = orphans.value.filter(({ finished }) => !finished);
  return (
    <>
      {cut.map((recording) => {
        const date = new Date(recording.startedAt).toLocaleString(region.value);
        return (
          <div class="notice" key={recording.id}>
            <p>{text('page-lab-interrupted-title', { date })}</p>
            <button type="button" class="quiet" onClick={() => void countInterrupted(recording)}>
              {text('page-series-count-interrupted')}
            </button>
          </div>
        );
      })}
    </>
  );
}
