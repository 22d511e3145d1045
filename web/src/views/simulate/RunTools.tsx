import { focusPage, handFocusOn } from '../../app/focus.ts';
import { Pause, Play } from '../../app/icons.tsx';
import { fixed, LENGTH, rounded } from '../../format/quantity.ts';
import { playing, stop } from '../../sound/player.ts';
import { show } from '../../state/figures.ts';
import { labAddress } from '../../state/settings.ts';
import {
  analyseRun,
  keepRun,
  layOver,
  outcome,
  overlay,
  playRun,
  type Run,
  removeRun,
  runs,
  takeOff,
} from '../../state/simulating.ts';
import { busy, drop } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';
import { ballName, nameIn } from '../../text/names.ts';

/** What can be done with a run. */
export function RunTools() {
  const ready = outcome.value !== null;
  return (
    <div class="stack">
      <div class="row tight">
        <button type="button" class="button primary" disabled={!ready} onClick={keepRun}>
          {text('page-simulate-keep-run')}
        </button>
        <button
          type="button"
          class="button"
          disabled={!ready}
          aria-pressed={playing.value !== null}
          onClick={() => (playing.peek() ? stop() : void playRun())}
        >
          <span class="sign">{playing.value ? <Pause /> : <Play />}</span>
          {playing.value ? text('page-simulate-stop') : text('page-simulate-hear')}
        </button>
      </div>
      <Runs />
      <div class="row">
        <button
          type="button"
          class="quiet"
          disabled={!ready || busy.value}
          onClick={() => void analyseRun()}
        >
          {text('page-simulate-analyse')}
        </button>
        {drop.value && (
          <button type="button" class="quiet" disabled={!ready} onClick={compare}>
            {text('page-simulate-lay')}
          </button>
        )}
      </div>
      <p role="status" class="small">
        {overlay.value && <a href={labAddress.value}>{text('page-simulate-laid')}</a>}
      </p>
      {overlay.value && (
        <button
          type="button"
          class="quiet small"
          onClick={() => {
            focusPage();
            takeOff();
          }}
        >
          {text('page-simulate-take-off')}
        </button>
      )}
      <p class="small soft">{text('page-simulate-address')}</p>
    </div>
  );
}

function Runs() {
  if (runs.value.length === 0) return null;
  return (
    <ul class="runs" aria-label={text('page-simulate-runs')}>
      {runs.value.map((run) => (
        <li key={run.number}>
          <span>
            <strong>{text('page-simulate-run', { index: run.number })}</strong>{' '}
            <span class="small soft">{inWords(run)}</span>
          </span>
          <button
            type="button"
            class="quiet slim"
            aria-label={text('page-simulate-remove', {
              name: text('page-simulate-run', { index: run.number }),
            })}
            onClick={(event) => {
              handFocusOn(event.currentTarget, 'li');
              removeRun(run.number);
            }}
          >
            {text('page-wave-remove')}
          </button>
        </li>
      ))}
    </ul>
  );
}

function inWords({ setup }: Run): string {
  const spoken = language.value;
  const height = rounded(setup.heightM, setup.heightM < 1 ? 3 : 4, LENGTH, spoken);
  const body = nameIn(`page-simulate-bodies-${setup.body}`, setup.body);
  const law = setup.law || fixed(setup.restitution, 4, spoken);
  return `${ballName(setup.ball)}, ${height}, e ${law}, ${body}`;
}

/** The figure with the comparison is what the way back to the laboratory leads to. */
function compare(): void {
  layOver();
  show('comparison');
}
