import { signal } from '@preact/signals';
import { useEffect, useRef, useState } from 'preact/hooks';
import { fixed } from '../../format/quantity.ts';
import type { Spectrogram as Picture } from '../../lab/index.ts';
import { view, workspace } from '../../state/workspace.ts';
import { colour, dark } from '../../style/colours.ts';
import { language, text } from '../../text/language.ts';

export const showSpectrogram = signal(false);

const ROWS = 128;
/** Delay after the last movement before the spectrogram is computed again, ms. */
const REST = 120;

/** The visible part as a spectrogram: an impact is a thin vertical line, a voice is horizontal. */
export function Spectrogram() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [topHz, setTopHz] = useState(0);
  const seen = view.value;
  const shown = showSpectrogram.value;
  const isDark = dark.value;

  useEffect(() => {
    const element = canvas.current;
    const loaded = workspace.peek();
    if (!element || !loaded) return undefined;
    const current = new AbortController();
    const waiting = setTimeout(async () => {
      const columns = Math.min(1200, Math.max(1, Math.round(element.clientWidth)));
      const picture = await loaded.recording
        .spectrogram(seen.startS, seen.endS, columns, ROWS, current.signal)
        .catch(() => null);
      if (current.signal.aborted || !picture) return;
      paintSpectrogram(element, picture);
      setTopHz(picture.topHz);
    }, REST);
    return () => {
      current.abort();
      clearTimeout(waiting);
    };
  }, [seen, shown, isDark]);

  if (!shown) return null;
  return (
    <div class="spectrogram">
      <canvas ref={canvas} role="img" aria-label={text('page-wave-spectrogram-label')} />
      {frequencies(topHz).map((kilohertz) => (
        <span
          key={kilohertz}
          class="small"
          style={{ insetBlockEnd: `${(1e5 * kilohertz) / topHz}%` }}
        >
          {fixed(kilohertz, 0, language.value)} kHz
        </span>
      ))}
    </div>
  );
}

/** Round frequencies along the axis, in kilohertz, about four of them. */
function frequencies(topHz: number): number[] {
  const step = [1, 2, 5, 10, 20, 50].find((round) => 4500 * round >= topHz) ?? 100;
  const count = Math.max(0, Math.ceil(topHz / 1000 / step) - 1);
  return Array.from({ length: count }, (_, index) => (index + 1) * step);
}

/** In shades of the text colour on the background, the lowest frequency at the bottom. */
function paintSpectrogram(canvas: HTMLCanvasElement, picture: Picture): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  const { columns, rows, cells } = picture;
  canvas.width = columns;
  canvas.height = rows;
  const [paper, ink] = [channels(colour('paper')), channels(colour('measured'))];
  const loudest = cells.reduce((most, cell) => Math.max(most, cell), 1);
  const image = context.createImageData(columns, rows);
  for (let column = 0; column < columns; column += 1) {
    for (let row = 0; row < rows; row += 1) {
      const share = Math.min(1, (cells[column * rows + row] ?? 0) / loudest);
      const at = 4 * ((rows - 1 - row) * columns + column);
      for (let part = 0; part < 3; part += 1) {
        const from = paper[part] ?? 0;
        image.data[at + part] = from + share * ((ink[part] ?? 0) - from);
      }
      image.data[at + 3] = 255;
    }
  }
  context.putImageData(image, 0, 0);
}

const channels = (css: string): number[] => (css.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number);
