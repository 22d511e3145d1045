/** Mouse, pen and touch events on the waveform as actions. */
import { timeAt } from './painter.ts';
import type { Viewport } from './viewport.ts';

/** How near to a mark counts as on it, in CSS pixels. */
const REACH_MOUSE = 7;
const REACH_FINGER = 20;
/** Less movement than this is a tap. */
const STILL = 4;

export interface GestureTarget {
  view(): Viewport;
  width(): number;
  /** The mark at a place, if there is one. */
  markAt(timeS: number, reachS: number): { id: number; timeS: number } | undefined;
  isChosen(mark: number): boolean;
  onPan(view: Viewport): void;
  onZoom(factor: number, aroundS: number): void;
  onTap(timeS: number, mark: number | undefined): void;
  onDoubleTap(timeS: number): void;
  onDrag(mark: number, timeS: number): void;
  onDragEnd(mark: number): void;
  /** For the shape of the pointer. */
  onMode(mode: 'idle' | 'moving' | 'panning'): void;
}

interface Pointer {
  x: number;
  readonly downX: number;
  readonly downY: number;
}

type Hold =
  | { readonly kind: 'none' }
  | { readonly kind: 'mark'; readonly id: number; readonly offsetS: number; moved: boolean }
  | { readonly kind: 'pan'; readonly grabbedS: number; readonly over?: number; moved: boolean };

/** Listens on an element until the returned function is called. */
export function listenToGestures(element: HTMLElement, target: GestureTarget): () => void {
  const pointers = new Map<number, Pointer>();
  let hold: Hold = { kind: 'none' };
  let lastTap = { at: 0, x: 0 };

  const xIn = (event: MouseEvent): number => event.clientX - element.getBoundingClientRect().left;
  const time = (x: number): number => timeAt(x, target.view(), target.width());
  const markAt = (event: PointerEvent, x: number) => {
    const reach = event.pointerType === 'mouse' ? REACH_MOUSE : REACH_FINGER;
    return target.markAt(time(x), time(x + reach) - time(x));
  };

  /** Under a finger there is always some mark: it moves the one that was chosen, and else the sound. */
  const canDrag = ({ pointerType }: PointerEvent, mark: number): boolean =>
    pointerType === 'mouse' || target.isChosen(mark);

  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const x = xIn(event);
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x, downX: x, downY: event.clientY });
    if (pointers.size > 1) {
      endDrag();
      hold = { kind: 'none' };
      return;
    }
    const mark = markAt(event, x);
    if (mark && canDrag(event, mark.id)) {
      hold = { kind: 'mark', id: mark.id, offsetS: mark.timeS - time(x), moved: false };
    } else {
      hold = { kind: 'pan', grabbedS: time(x), moved: false, ...(mark && { over: mark.id }) };
    }
  };

  const move = (event: PointerEvent): void => {
    const x = xIn(event);
    const pointer = pointers.get(event.pointerId);
    if (!pointer) {
      if (pointers.size === 0) target.onMode(markAt(event, x) ? 'moving' : 'idle');
      return;
    }
    if (pointers.size === 2) {
      pinch(event.pointerId, x);
      return;
    }
    pointer.x = x;
    if (hold.kind === 'none') return;
    if (!hold.moved && Math.abs(x - pointer.downX) < STILL) return;
    hold.moved = true;
    if (hold.kind === 'mark') target.onDrag(hold.id, time(x) + hold.offsetS);
    else {
      target.onMode('panning');
      panTo(hold.grabbedS, x);
    }
  };

  const panTo = (grabbedS: number, x: number): void => {
    const by = grabbedS - time(x);
    const { startS, endS } = target.view();
    target.onPan({ startS: startS + by, endS: endS + by });
  };

  const pinch = (id: number, x: number): void => {
    const moving = pointers.get(id);
    const other = [...pointers].find(([key]) => key !== id)?.[1];
    if (!moving || !other) return;
    const before = Math.abs(moving.x - other.x);
    const grabbedS = time((moving.x + other.x) / 2);
    moving.x = x;
    const after = Math.abs(moving.x - other.x);
    if (before > 8 && after > 8) target.onZoom(after / before, grabbedS);
    panTo(grabbedS, (moving.x + other.x) / 2);
  };

  const up = (event: PointerEvent): void => {
    const pointer = pointers.get(event.pointerId);
    pointers.delete(event.pointerId);
    if (!pointer) return;
    const finished = hold;
    hold = { kind: 'none' };
    target.onMode('idle');
    if (finished.kind === 'none') return;
    if (finished.moved) {
      if (finished.kind === 'mark') target.onDragEnd(finished.id);
    } else if (Math.abs(event.clientY - pointer.downY) < 2 * STILL) {
      tap(pointer.x, event.timeStamp, finished.kind === 'mark' ? finished.id : finished.over);
    }
  };

  /** By the event's own time stamp: a busy page handles the event later. */
  const tap = (x: number, at: number, mark: number | undefined): void => {
    const twice = at - lastTap.at < 350 && Math.abs(x - lastTap.x) < 16;
    lastTap = { at: twice ? 0 : at, x };
    if (twice && mark === undefined) target.onDoubleTap(time(x));
    else target.onTap(time(x), mark);
  };

  /** The browser took the pointer over, as for scrolling: what was dragged stays where it is. */
  const cancel = (event: PointerEvent): void => {
    pointers.delete(event.pointerId);
    endDrag();
    hold = { kind: 'none' };
    target.onMode('idle');
  };

  const endDrag = (): void => {
    if (hold.kind === 'mark' && hold.moved) target.onDragEnd(hold.id);
  };

  const wheel = (event: WheelEvent): void => {
    const sideways = Math.abs(event.deltaX) > Math.abs(event.deltaY) || event.shiftKey;
    // A page is scrolled by the wheel; the waveform takes it once it was chosen.
    const chosen = element.contains(document.activeElement);
    if (!sideways && !chosen && !event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    if (sideways) {
      const by = (event.deltaX || event.deltaY) * pixels;
      panTo(time(by), 0);
    } else {
      target.onZoom(Math.exp((-event.deltaY * pixels) / 240), time(xIn(event)));
    }
  };

  const listeners = new AbortController();
  const { signal } = listeners;
  element.addEventListener('pointerdown', down, { signal });
  element.addEventListener('pointermove', move, { signal });
  element.addEventListener('pointerup', up, { signal });
  element.addEventListener('pointercancel', cancel, { signal });
  element.addEventListener('wheel', wheel, { signal, passive: false });
  return () => listeners.abort();
}
