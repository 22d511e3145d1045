import { fileName, rasterised, save, saveText } from '../../app/save.ts';
import { engineName, type FigureId } from '../../figures/all.ts';
import { request } from '../../state/analysing.ts';
import { analysed, chosenDrop, onBench } from '../../state/bench.ts';
import { engine } from '../../state/engine.ts';
import { overlay } from '../../state/simulating.ts';
import { texts } from '../../text/language.ts';
import { phrasebook } from '../../text/remarks.ts';

/** Saves a figure as the engine draws it: the picture of the command line, in the language of the page. */
export function SaveFigure({ id, log }: { readonly id: FigureId; readonly log: boolean }) {
  const words = texts.value.figures;
  const name = nameOf(id, log);
  if (name === undefined) return null;
  return (
    <span class="row tight small">
      <span class="soft">{words.save}:</span>
      <button type="button" class="quiet" onClick={() => void saveDrawn(name, 'svg')}>
        {words.saveSvg}
      </button>
      <button type="button" class="quiet" onClick={() => void saveDrawn(name, 'png')}>
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

async function saveDrawn(name: string, format: 'svg' | 'png'): Promise<void> {
  const asked = request();
  if (!asked) return;
  const drawn = await engine().figure(asked, name, phrasebook.peek(), overlay.peek());
  const file = `${fileName(onBench.peek()?.name ?? '')}-${drawn.name}`;
  if (format === 'svg') saveText(drawn.svg, 'image/svg+xml', `${file}.svg`);
  else save(await rasterised(drawn.svg, drawn.width_px, drawn.height_px), `${file}.png`);
}
