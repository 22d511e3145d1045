import type { ReadonlySignal, Signal } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { fixed } from '../format/quantity.ts';
import { dark, fontOf } from '../style/colours.ts';
import { language, text } from '../text/language.ts';
import { type Amplitude, heightOf } from './amplitude.ts';
import { type GestureTarget, listenToGestures } from './gestures.ts';
import { type Action, actionOf } from './keys.ts';
import { beside, CERTAIN, type Mark, nearest } from './mark.ts';
import { paint, palette, type Scene, type Surface } from './painter.ts';
import type { Part, Pyramid } from './pyramid.ts';
import { clamped, revealing, type Viewport, whole, widthS, zoomed } from './viewport.ts';

/** What the reader does to the impacts. */
export interface WaveformEdits {
  add(timeS: number): void;
  /** Selects a mark and brings it into sight. */
  choose(mark: Mark): void;
  /** While a mark is dragged. */
  drag(id: number, timeS: number): void;
  dragEnd(id: number): void;
  nudge(id: number, byS: number): void;
  remove(id: number): void;
  snap(id: number): void;
  undo(): void;
  redo(): void;
}

export interface WaveformProps {
  readonly pyramid: Pyramid;
  readonly part: ReadonlySignal<Part | null>;
  readonly durationS: number;
  readonly marks: readonly Mark[];
  readonly view: Signal<Viewport>;
  readonly amplitude: Signal<Amplitude>;
  readonly selected: Signal<number | null>;
  readonly cursorS: Signal<number | null>;
  readonly edits: WaveformEdits;
  /** The moment that is played now, if any. */
  readonly playheadS: () => number | null;
  readonly isPlaying: Signal<unknown>;
  readonly onPlay: () => void;
}

/** The waveform as a slider: the reader moves a cursor along it and reads what lies there. */
export function Waveform(props: WaveformProps) {
  const stage = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const latest = useRef(props);
  latest.current = props;
  const painter = useMemo(() => new Painter(latest), []);

  useEffect(() => {
    const element = stage.current;
    const picture = canvas.current;
    if (!element || !picture) return undefined;
    const detach = painter.attach(picture);
    const ignore = listenToGestures(element, gestureTarget(latest, element));
    return () => {
      ignore();
      detach();
    };
  }, [painter]);

  // Whatever of these changes, the picture is painted once, with the next frame.
  const { view, amplitude, selected, cursorS, isPlaying, marks, pyramid, durationS } = props;
  const [isDark, now, scale, chosen, cursor, sounding, part] = [
    dark.value,
    view.value,
    amplitude.value,
    selected.value,
    cursorS.value,
    isPlaying.value,
    props.part.value,
  ];
  useEffect(
    () => painter.request(),
    [now, scale, chosen, cursor, sounding, marks, pyramid, part, isDark],
  );
  useEffect(() => painter.forgetColours(), [isDark]);

  const at = cursor ?? now.startS;
  return (
    <div
      ref={stage}
      class="wave-stage"
      role="slider"
      tabIndex={0}
      aria-label={text('page-wave-label')}
      aria-describedby="wave-keys"
      aria-valuemin={0}
      aria-valuemax={Number(durationS.toFixed(3))}
      aria-valuenow={Number(at.toFixed(4))}
      aria-valuetext={spoken(at, marks, chosen)}
      onKeyDown={(event) => {
        const action = actionOf(event);
        if (!action) return;
        event.preventDefault();
        act(action, latest.current);
      }}
    >
      <canvas ref={canvas} aria-hidden="true" />
    </div>
  );
}

/** What a screen reader says of the place of the cursor. */
function spoken(atS: number, marks: readonly Mark[], selected: number | null): string {
  const seconds = text('page-wave-seconds', { value: fixed(atS, 4, language.value) });
  const index = marks.findIndex((mark) => mark.id === selected);
  const mark = marks[index];
  if (!mark) return seconds;
  return text('page-wave-impact-at', {
    number: index + 1,
    seconds,
    certain: mark.probability >= CERTAIN ? 'yes' : 'no',
  });
}

/** The step of the cursor as a share of what is seen. */
const STEP = 1 / 40;
const FINE_STEP = 1 / 800;

function act(action: Action, props: WaveformProps): void {
  const { view, cursorS, selected, marks, edits, durationS } = props;
  const now = view.value;
  const at = cursorS.value ?? now.startS;
  switch (action.kind) {
    case 'cursor':
      moveCursor(props, at + action.by * widthS(now) * (action.fine ? FINE_STEP : STEP));
      return;
    case 'edge':
      moveCursor(props, action.end ? durationS : 0);
      return;
    case 'beside': {
      const mark = beside(marks, at, action.by);
      if (mark) edits.choose(mark);
      return;
    }
    case 'nudge':
      if (selected.value !== null) {
        edits.nudge(selected.value, action.by * widthS(now) * FINE_STEP);
      }
      return;
    case 'zoom':
      view.value = zoomed(
        now,
        action.closer ? 1.5 : 1 / 1.5,
        cursorS.value ?? (now.startS + now.endS) / 2,
        durationS,
      );
      return;
    case 'whole':
      view.value = whole(durationS);
      return;
    case 'add':
      edits.add(at);
      return;
    case 'delete':
      if (selected.value !== null) edits.remove(selected.value);
      return;
    case 'snap':
      if (selected.value !== null) edits.snap(selected.value);
      return;
    case 'play':
      props.onPlay();
      return;
    case 'leave':
      selected.value = null;
      return;
    default:
      edits[action.kind]();
  }
}

function moveCursor({ cursorS, view, selected, durationS, marks }: WaveformProps, to: number) {
  const at = Math.min(Math.max(to, 0), durationS);
  cursorS.value = at;
  view.value = revealing(view.value, at, durationS);
  selected.value = nearest(marks, at, widthS(view.value) * FINE_STEP * 2)?.id ?? null;
}

function gestureTarget(
  latest: { readonly current: WaveformProps },
  element: HTMLElement,
): GestureTarget {
  return {
    view: () => latest.current.view.value,
    width: () => element.clientWidth,
    markAt: (timeS, reachS) => nearest(latest.current.marks, timeS, reachS),
    isChosen: (id) => latest.current.selected.value === id,
    onPan: (view) => {
      const { durationS } = latest.current;
      latest.current.view.value = clamped(view, durationS);
    },
    onZoom: (factor, aroundS) => {
      const { view, durationS } = latest.current;
      view.value = zoomed(view.value, factor, aroundS, durationS);
    },
    onTap: (timeS, id) => {
      const { marks, cursorS, selected } = latest.current;
      element.focus({ preventScroll: true });
      const mark = marks.find((candidate) => candidate.id === id);
      cursorS.value = mark?.timeS ?? timeS;
      selected.value = mark?.id ?? null;
    },
    onDoubleTap: (timeS) => latest.current.edits.add(timeS),
    onDrag: (id, timeS) => {
      const { selected, edits, cursorS, durationS } = latest.current;
      const to = Math.min(Math.max(timeS, 0), durationS);
      selected.value = id;
      cursorS.value = to;
      edits.drag(id, to);
    },
    onDragEnd: (id) => latest.current.edits.dragEnd(id),
    onMode: (mode) => {
      element.classList.toggle('moving', mode === 'moving');
      element.classList.toggle('panning', mode === 'panning');
    },
  };
}

/** Paints at most once a frame, and goes on by itself while a sound is played. */
class Painter {
  #surface: Surface | undefined;
  #frame = 0;

  constructor(private readonly latest: { readonly current: WaveformProps }) {}

  attach(canvas: HTMLCanvasElement): () => void {
    const watcher = new ResizeObserver(() => this.#resize(canvas));
    watcher.observe(canvas);
    return () => {
      watcher.disconnect();
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    };
  }

  request(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#paint());
  }

  forgetColours(): void {
    if (this.#surface) this.#surface = { ...this.#surface, palette: palette() };
    this.request();
  }

  #resize(canvas: HTMLCanvasElement): void {
    const context = canvas.getContext('2d');
    if (!context) return;
    const ratio = globalThis.devicePixelRatio;
    const { clientWidth: width, clientHeight: height } = canvas;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const font = fontOf(0.75);
    const scale = Number.parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;
    this.#surface = { context, width, height, ratio, scale, font, palette: palette() };
    this.#paint();
  }

  #paint(): void {
    this.#frame = 0;
    if (!this.#surface || this.#surface.width === 0) return;
    const { pyramid, part, view, amplitude, marks, selected, cursorS, playheadS } =
      this.latest.current;
    const playhead = playheadS();
    const scene: Scene = {
      pyramid,
      part: part.value,
      view: view.value,
      heightOf: heightOf(amplitude.value, pyramid, view.value),
      marks,
      selected: selected.value,
      cursorS: cursorS.value,
      playheadS: playhead,
      seconds: (value, decimals) => `${fixed(value, decimals, language.value)} s`,
    };
    paint(this.#surface, scene);
    if (playhead !== null) this.request();
  }
}
