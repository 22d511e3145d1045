import { statedInWords } from '../../app/set-up-words.ts';
import { decide, offered, resetUnusual, settings, unusualOf } from '../../state/settings.ts';
import { text } from '../../text/language.ts';

/** What a link states and the reader did not, and what of the set-up few drops have, each with the way out. */
export function SetUp() {
  const link = offered.value;
  const unusual = statedInWords(unusualOf(settings.value));
  return (
    <>
      {link && (
        <div class="notice">
          <p>
            {text('page-setup-offered', { what: statedInWords(link) || text('page-setup-laws') })}
          </p>
          <div class="row">
            <button type="button" class="quiet" onClick={() => decide(true)}>
              {text('page-setup-take')}
            </button>
            <button type="button" class="quiet" onClick={() => decide(false)}>
              {text('page-setup-leave')}
            </button>
          </div>
        </div>
      )}
      {unusual !== '' && (
        <div class="notice">
          <p>{text('page-setup-unusual', { what: unusual })}</p>
          <div class="row">
            <button type="button" class="quiet" onClick={resetUnusual}>
              {text('page-setup-reset')}
            </button>
          </div>
        </div>
      )}
    </>
  );
}
