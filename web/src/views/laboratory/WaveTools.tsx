import { All, Bin, Closer, Magnet, Pause, Play, Plus, Wider } from '../../app/icons.tsx';
import { Tool } from '../../app/Tool.tsx';
import { playing, SPEEDS, type Speed } from '../../sound/player.ts';
import * as editing from '../../state/editing.ts';
import { amplitude, playView, speed } from '../../state/sound.ts';
import { cursorS, selected, view, workspace } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';
import { AMPLITUDES, type Amplitude } from '../../wave/amplitude.ts';
import { whole, zoomed } from '../../wave/viewport.ts';
import { showSpectrogram } from './Spectrogram.tsx';

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
      <select
        class="tool"
        aria-label={text('page-wave-amplitude')}
        value={amplitude.value}
        onChange={(event) => {
          amplitude.value = event.currentTarget.value as Amplitude;
        }}
      >
        {AMPLITUDES.map((name) => (
          <option key={name} value={name}>
            {text(`page-wave-amplitude-${name}`)}
          </option>
        ))}
      </select>
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
    </div>
  );
}
