import { airInWords, ballInWords, gravityInWords } from '../../app/set-up-words.ts';
import { settings } from '../../state/settings.ts';
import { refusedSettings } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { SettingsForm } from './SettingsForm.tsx';

/** Stated and assumed quantities in one line, which unfolds into a form. */
export function SettingsLine() {
  return (
    <section class="settings" aria-label={text('page-settings-title')}>
      {refusedSettings.value !== null && (
        <div class="notice" role="alert">
          <p>
            <strong>{text('page-settings-refused')}</strong> {refusedSettings.value}
          </p>
        </div>
      )}
      <details>
        <summary>
          <span>
            <span class="line">
              {ballInWords(settings.value)} · {airInWords(settings.value)} ·{' '}
              {gravityInWords(settings.value)}
            </span>{' '}
            {text('page-settings-change')}
          </span>
        </summary>
        <SettingsForm />
      </details>
    </section>
  );
}
