import { later } from '../../app/later.tsx';
import { request } from '../../state/analysing.ts';
import { pupil } from '../../state/lesson.ts';
import { analysed } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

const Verdict = later(async () => (await import('../verdict/Verdict.tsx')).Verdict);

/** The drops of the recording held against a rule. */
export function Judged() {
  const asked = analysed.value && request();
  if (!asked || asked.drops.length === 0) return null;
  const { name, source, drops, settings } = asked;
  return (
    <details>
      <summary>{text('page-verdict-title')}</summary>
      <Verdict settings={settings} places={[{ name, source, drops, surface: pupil().surface }]} />
    </details>
  );
}
