import { playheadS, playing } from '../../sound/player.ts';
import * as editing from '../../state/editing.ts';
import { amplitude, part, playView } from '../../state/sound.ts';
import { cursorS, marks, selected, view, workspace } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { Overview } from '../../wave/Overview.tsx';
import { Waveform, type WaveformEdits } from '../../wave/Waveform.tsx';
import { DropChoice } from './DropChoice.tsx';
import { History } from './History.tsx';
import { ImpactTable } from './ImpactTable.tsx';
import { Spectrogram } from './Spectrogram.tsx';
import { WaveTools } from './WaveTools.tsx';

const edits: WaveformEdits = {
  add: (timeS) => void editing.add(timeS),
  choose: editing.choose,
  drag: editing.drag,
  dragEnd: (id) => void editing.dragEnd(id),
  nudge: editing.nudge,
  remove: editing.remove,
  snap: (id) => void editing.snap(id),
  undo: editing.undo,
  redo: editing.redo,
};

/** The sound with its impacts, to look at and to correct. */
export function WaveEditor() {
  const recording = workspace.value;
  if (!recording) return null;
  const { durationS } = recording;
  const pyramid = recording.pyramid;
  return (
    <section class="wave" aria-label={text('page-wave-title')}>
      <DropChoice />
      {pyramid ? (
        <>
          <Waveform
            pyramid={pyramid}
            part={part}
            durationS={durationS}
            marks={marks.value}
            view={view}
            amplitude={amplitude}
            selected={selected}
            cursorS={cursorS}
            edits={edits}
            playheadS={playheadS}
            isPlaying={playing}
            onPlay={() => void playView()}
          />
          <Spectrogram />
          <Overview
            pyramid={pyramid}
            durationS={durationS}
            view={view}
            label={text('page-wave-overview')}
          />
          <p id="wave-keys" class="unseen">
            {text('page-wave-keys')}
          </p>
        </>
      ) : (
        <p class="soft">{text('page-wave-times')}</p>
      )}
      <History />
      <WaveTools />
      <ImpactTable />
    </section>
  );
}
