import { language, text } from '../../text/language.ts';

const SHEETS = ['bounciness', 'air', 'gravity'] as const;

/** The lesson sheets in the language of the page, to print. */
export function Sheets() {
  return (
    <section class="stack" aria-labelledby="sheets">
      <h2 id="sheets">{text('page-class-sheets')}</h2>
      <ul>
        {SHEETS.map((name) => (
          <li key={name}>
            <a href={`lessons/${name}.${language.value}.html`} target="_blank" rel="noreferrer">
              {text(`page-class-sheet-${name}`)}
            </a>
          </li>
        ))}
      </ul>
    </section>
  );
}
