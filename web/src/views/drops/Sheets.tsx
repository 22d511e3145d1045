import { saveText } from '../../app/save.ts';
import { engine } from '../../state/engine.ts';
import { language, sheetMessages, text } from '../../text/language.ts';

const SHEETS = ['bounciness', 'air', 'gravity'] as const;
const FORMS = ['html', 'markdown'] as const;

/** The lesson sheets in the language of the page, for pupils who use the page at this address. */
export function Sheets({ address }: { readonly address: string }) {
  return (
    <section class="stack small" aria-labelledby="sheets">
      <h2 id="sheets">{text('page-class-sheets')}</h2>
      <p class="soft">{text('page-class-sheets-hint')}</p>
      <ul>
        {SHEETS.map((name) => {
          const title = text(`page-class-sheet-${name}`);
          return (
            <li key={name}>
              {title}{' '}
              <span class="row tight">
                {FORMS.map((form) => (
                  <button
                    key={form}
                    type="button"
                    class="quiet slim"
                    aria-label={`${title} ${text(`page-class-sheet-${form}`)}`}
                    onClick={() => void saveSheet(name, form, address)}
                  >
                    {text(`page-class-sheet-${form}`)}
                  </button>
                ))}
              </span>
            </li>
          );
        })}
      </ul>
    </section>
  );
}

async function saveSheet(
  name: (typeof SHEETS)[number],
  form: (typeof FORMS)[number],
  address: string,
): Promise<void> {
  const isMarkdown = form === 'markdown';
  const content = await engine().sheet(name, isMarkdown, address, await sheetMessages());
  const stem = `${name}.${language.peek()}`;
  saveText(content, `text/${form}`, isMarkdown ? `${stem}.md` : `${stem}.html`);
}
