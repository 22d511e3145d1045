import { fileName, rasterised, save, saveText } from '../../app/save.ts';
import { engine } from '../../state/engine.ts';
import { figureRequest } from '../../state/figures.ts';
import { workspace } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** Saves a figure as the engine draws it: the picture of the command line, in the language of the page. */
export function SaveFigure({ name }: { readonly name: string }) {
  return (
    <span class="row tight small">
      <span class="soft">{text('page-figures-save')}:</span>
      <button type="button" class="quiet" onClick={() => void saveDrawn(name, 'svg')}>
        {text('page-figures-save-svg')}
      </button>
      <button type="button" class="quiet" onClick={() => void saveDrawn(name, 'png')}>
        {text('page-figures-save-png')}
      </button>
    </span>
  );
}

async function saveDrawn(name: string, format: 'svg' | 'png'): Promise<void> {
  const asked = figureRequest(name, true);
  if (!asked) return;
  const drawn = await engine().figure(asked);
  const file = `${fileName(workspace.peek()?.name ?? '')}-${drawn.name}`;
  if (format === 'svg') saveText(drawn.svg, 'image/svg+xml', `${file}.svg`);
  else save(await rasterised(drawn.svg, drawn.width_px, drawn.height_px), `${file}.png`);
}
