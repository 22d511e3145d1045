import type { Signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { colour, dark } from '../style/colours.ts';
import { columnOf, levelFor, type Pyramid, peakOf } from './pyramid.ts';
import { panned, type Viewport, widthS } from './viewport.ts';

interface Props {
  readonly pyramid: Pyramid;
  readonly durationS: number;
  readonly view: Signal<Viewport>;
  readonly label: string;
}

/** The whole recording in a strip, with a window on what is seen; dragging moves it. */
export function Overview({ pyramid, durationS, view, label }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const seen = view.value;
  const isDark = dark.value;

  useEffect(() => {
    const element = canvas.current;
    if (!element) return undefined;
    const draw = (): void => paintOverview(element, pyramid, durationS, seen);
    const watcher = new ResizeObserver(draw);
    watcher.observe(element);
    draw();
    return () => watcher.disconnect();
  }, [pyramid, durationS, seen, isDark]);

  const goTo = (event: PointerEvent): void => {
    if (event.buttons === 0) return;
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const toS = ((event.clientX - box.left) / box.width) * durationS;
    const now = view.peek();
    view.value = panned(now, toS - (now.startS + now.endS) / 2, durationS);
  };

  // The keyboard moves on the waveform itself; this strip is a shortcut for pointers.
  return (
    <div
      class="wave-strip"
      title={label}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        goTo(event);
      }}
      onPointerMove={goTo}
    >
      <canvas ref={canvas} aria-hidden="true" />
    </div>
  );
}

function paintOverview(
  canvas: HTMLCanvasElement,
  pyramid: Pyramid,
  durationS: number,
  seen: Viewport,
): void {
  const context = canvas.getContext('2d');
  const { clientWidth: width, clientHeight: height } = canvas;
  if (!context || width === 0) return;
  const ratio = devicePixelRatio;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const x = (timeS: number): number => (timeS / durationS) * canvas.width;

  context.fillStyle = colour('measured-tint');
  const window = Math.max(3 * ratio, x(widthS(seen)));
  context.fillRect(x(seen.startS), 0, window, canvas.height);

  const perColumn = (durationS * pyramid.rateHz) / canvas.width;
  const level = levelFor(pyramid, perColumn);
  const peak = peakOf(pyramid);
  if (!level || peak === 0) return;
  const column = new Float32Array(2);
  context.fillStyle = colour('edge');
  for (let i = 0; i < canvas.width && i * perColumn < pyramid.frames; i += 1) {
    columnOf(level, i * perColumn, (i + 1) * perColumn, column, 0);
    const [low = 0, high = 0] = column;
    const tall = Math.max(1, ((high - low) / (2 * peak)) * canvas.height);
    context.fillRect(i, ((1 - high / peak) / 2) * canvas.height, 1, tall);
  }
}
