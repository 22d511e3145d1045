import type { ComponentChildren } from 'preact';
import {
  All,
  Back,
  Bin,
  Closer,
  Forth,
  Magnet,
  Pause,
  Play,
  Plus,
  Wider,
} from '../../app/icons.tsx';
import { playing, SPEEDS, type Speed } from '../../sound/player.ts';
import * as editing from '../../state/editing.ts';
import { canRedo, canUndo } from '../../state/history.ts';
import { playView, speed } from '../../state/sound.ts';
import { cursorS, edited, present, selected, view, workspace } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';
import { whole, zoomed } from '../../wave/viewport.ts';
import { showSpectrogram } from './Spectrogram.tsx';

interface ToolProps {
  readonly do: () => void;
  readonly disabled?: boolean;
  readonly pressed?: boolean;
  readonly children: ComponentChildren;
}

function Tool({ do: act, disabled = false, pressed, children }: ToolProps) {
  return (
    // Not `disabled`: a button that has done its work would drop the keyboard.
    <button
      type="button"
      class="tool"
      aria-disabled={disabled}
      aria-pressed={pressed}
      onClick={() => {
        if (!disabled) act();
      }}
    >
      {children}
    </button>
  );
}

/** Buttons for the actions of the waveform, each of which has a key too. */
export function WaveTools() {
  return (
    <div class="wave-tools">
      {workspace.value?.pyramid && (
        <>
          <Zooming />
          <PlaybackTools />
        </>
      )}
      <Correcting />
    </div>
  );
}

function zoom(factor: number): void {
  const recording = workspace.peek();
  if (!recording) return;
  const now = view.peek();
  const at = cursorS.peek();
  const inside = at !== null && at >= now.startS && at <= now.endS;
  const around = inside ? at : (now.startS + now.endS) / 2;
  view.value = zoomed(now, factor, around, recording.durationS);
}

function Zooming() {
  return (
    <div class="group">
      <Tool do={() => zoom(2)}>
        <Closer />
        {text('page-wave-zoom-in')}
      </Tool>
      <Tool do={() => zoom(0.5)}>
        <Wider />
        {text('page-wave-zoom-out')}
      </Tool>
      <Tool
        do={() => {
          view.value = whole(workspace.peek()?.durationS ?? 1);
        }}
      >
        <All />
        {text('page-wave-all')}
      </Tool>
    </div>
  );
}

function PlaybackTools() {
  const sounding = playing.value !== null;
  return (
    <div class="group">
      <Tool do={() => void playView()} pressed={sounding}>
        {sounding ? <Pause /> : <Play />}
        {sounding ? text('page-wave-stop') : text('page-wave-play')}
      </Tool>
      <select
        class="tool"
        aria-label={text('page-wave-speed')}
        value={speed.value}
        onChange={(event) => {
          speed.value = Number(event.currentTarget.value) as Speed;
        }}
      >
        {SPEEDS.map((factor) => (
          <option key={factor} value={factor}>
            {text('page-wave-slower', { speed: factor.toLocaleString(language.value) })}
          </option>
        ))}
      </select>
      <Tool
        pressed={showSpectrogram.value}
        do={() => {
          showSpectrogram.value = !showSpectrogram.value;
        }}
      >
        {text('page-wave-spectrogram')}
      </Tool>
    </div>
  );
}

function Correcting() {
  const history = present.value;
  const chosen = selected.value;
  return (
    <div class="group">
      {workspace.value?.pyramid && (
        <Tool
          do={() => {
            const { startS, endS } = view.peek();
            void editing.add(cursorS.peek() ?? (startS + endS) / 2);
          }}
        >
          <Plus />
          {text('page-wave-add')}
        </Tool>
      )}
      <Tool
        disabled={chosen === null}
        do={() => {
          if (chosen !== null) editing.remove(chosen);
        }}
      >
        <Bin />
        {text('page-wave-remove')}
      </Tool>
      {workspace.value?.pyramid && (
        <Tool
          disabled={chosen === null}
          do={() => {
            if (chosen !== null) void editing.snap(chosen);
          }}
        >
          <Magnet />
          {text('page-wave-snap')}
        </Tool>
      )}
      <Tool disabled={!history || !canUndo(history)} do={editing.undo}>
        <Back />
        {text('page-app-undo')}
      </Tool>
      <Tool disabled={!history || !canRedo(history)} do={editing.redo}>
        <Forth />
        {text('page-app-redo')}
      </Tool>
      <Tool disabled={!edited.value} do={editing.restore}>
        {text('page-wave-restore')}
      </Tool>
    </div>
  );
}
