import { fileName, rasterised, save, saveText } from '../../app/save.ts';
import { saveCsv } from '../../app/saveCsv.ts';
import { engine } from '../../state/engine.ts';
import { figureRequest } from '../../state/figures.ts';
import { workspace } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

const FORMATS = ['svg', 'png', 'csv'] as const;

/** Saves a figure as the engine draws it: picture or data of the command line, in the language of the page. */
export function SaveFigure({ name }: { readonly name: string }) {
  return (
    <span class="row tight small">
      <span class="soft">{text('page-figures-save')}:</span>
      {FORMATS.map((format) => (
        <button
          type="button"
          class="quiet"
          key={format}
          onClick={() => void saveDrawn(name, format)}
        >
          {text(`page-figures-save-${format}`)}
        </button>
      ))}
    </span>
  );
}

async function saveDrawn(name: string, format: (typeof FORMATS)[number]): Promise<void> {
  const asked = figureRequest(name, true);
  if (!asked) return;
  const drawn = await engine().figure(asked);
  const file = `${fileName(workspace.peek()?.name ?? '')}-${drawn.name}`;
  if (format === 'svg') saveText(drawn.svg, 'image/svg+xml', `${file}.svg`);
  else if (format === 'csv') saveCsv(drawn.csv, `${file}.csv`);
  else save(await rasterised(drawn.svg, drawn.width_px, drawn.height_px), `${file}.png`);
}
