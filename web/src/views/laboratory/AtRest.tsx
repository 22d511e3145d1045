import { Tick } from '../../app/Tick.tsx';
import { speech, vibration } from '../../state/telling.ts';
import { text } from '../../text/language.ts';

/** What the page shall do when the ball rests, as far as the browser can. */
export function AtRest() {
  if (!speech.offered && !vibration.offered) return null;
  return (
    <details class="at-rest no-print">
      <summary>{text('page-rest-title')}</summary>
      <div class="row">
        <Tick option={speech} label={text('page-rest-speech')} />
        <Tick option={vibration} label={text('page-rest-vibration')} />
      </div>
    </details>
  );
}
