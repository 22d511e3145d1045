import { fileName, pictured, rasterised, save, saveText } from '../../app/save.ts';
import { engineName, type FigureId } from '../../figures/all.ts';
import { request } from '../../state/analysing.ts';
import { analysed, chosenDrop, onBench } from '../../state/bench.ts';
import { engine } from '../../state/engine.ts';
import { texts } from '../../text/language.ts';

/**
 * Saves a figure as the engine draws it, the same picture as that of the command line; or, where it has
 * none, the picture on the screen.
 */
export function SaveFigure({ id, log }: { readonly id: FigureId; readonly log: boolean }) {
  const words = texts.value.figures;
  const name = nameOf(id, log);
  return (
    <span class="row tight small">
      <span class="soft">{words.save}:</span>
      {name !== undefined && (
        <button type="button" class="quiet" onClick={() => void saveDrawn(name, 'svg')}>
          {words.saveSvg}
        </button>
      )}
      <button
        type="button"
        class="quiet"
        onClick={() => void (name === undefined ? saveShown(id) : saveDrawn(name, 'png'))}
      >
        {words.savePng}
      </button>
    </span>
  );
}

/** The name by which the engine draws it; with several drops it begins with the drop. */
function nameOf(id: FigureId, log: boolean): string | undefined {
  const wanted = engineName(id, log);
  const names = analysed.value?.figures ?? [];
  return (
    names.find((name) => name === `drop${chosenDrop.value + 1}-${wanted}`) ??
    names.find((name) => name === wanted)
  );
}

const fileOf = (figure: string): string => `${fileName(onBench.peek()?.name ?? '')}-${figure}`;

async function saveDrawn(name: string, format: 'svg' | 'png'): Promise<void> {
  const asked = request();
  if (!asked) return;
  const drawn = await engine().figure(asked, name);
  const file = fileOf(drawn.name);
  if (format === 'svg') saveText(drawn.svg, 'image/svg+xml', `${file}.svg`);
  else save(await rasterised(drawn.svg, drawn.width_px, drawn.height_px), `${file}.png`);
}

async function saveShown(id: FigureId): Promise<void> {
  const canvas = document.querySelector<HTMLCanvasElement>('#figure canvas');
  if (canvas) save(await pictured(canvas), `${fileOf(id)}.png`);
}
