import { focusPage, handFocusOn } from '../../app/focus.ts';
import { Pause, Play } from '../../app/icons.tsx';
import { fixed } from '../../format/quantity.ts';
import { playing, stop } from '../../sound/player.ts';
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
import { language, texts } from '../../text/language.ts';
import { ballName, nameIn } from '../../text/names.ts';

/** What can be done with a run. */
export function RunTools() {
  const words = texts.value.simulate;
  const ready = outcome.value !== null;
  return (
    <div class="stack">
      <div class="row tight">
        <button type="button" class="button primary" disabled={!ready} onClick={keepRun}>
          {words.keepRun}
        </button>
        <button
          type="button"
          class="button"
          disabled={!ready}
          aria-pressed={playing.value !== null}
          onClick={() => (playing.peek() ? stop() : void playRun())}
        >
          <span class="sign">{playing.value ? <Pause /> : <Play />}</span>
          {playing.value ? words.stop : words.hear}
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
          {words.analyse}
        </button>
        {drop.value && (
          <button type="button" class="quiet" disabled={!ready} onClick={layOver}>
            {words.lay}
          </button>
        )}
      </div>
      <p role="status" class="small">
        {overlay.value && <a href={labAddress.value}>{words.laid}</a>}
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
          {words.takeOff}
        </button>
      )}
      <p class="small soft">{words.address}</p>
    </div>
  );
}

function Runs() {
  const words = texts.value.simulate;
  if (runs.value.length === 0) return null;
  return (
    <ul class="runs" aria-label={words.runs}>
      {runs.value.map((run) => (
        <li key={run.number}>
          <span>
            <strong>{words.run(run.number)}</strong> <span class="small soft">{inWords(run)}</span>
          </span>
          <button
            type="button"
            class="quiet slim"
            aria-label={words.remove(words.run(run.number))}
            onClick={(event) => {
              handFocusOn(event.currentTarget, 'li');
              removeRun(run.number);
            }}
          >
            {texts.value.wave.remove}
          </button>
        </li>
      ))}
    </ul>
  );
}

function inWords({ setup }: Run): string {
  const spoken = language.value;
  const height = `${fixed(100 * setup.heightM, 1, spoken)} cm`;
  const world = nameIn(texts.value.simulate.worlds, setup.world);
  return `${ballName(setup.ball)}, ${height}, e ${fixed(setup.restitution, 4, spoken)}, ${world}`;
}
