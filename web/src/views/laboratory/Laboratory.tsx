import { busy, workspace } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { Answer } from './Answer.tsx';
import { AtRest } from './AtRest.tsx';
import { Explained } from './Explained.tsx';
import { FigureTabs } from './FigureTabs.tsx';
import { Judged } from './Judged.tsx';
import { Keep } from './Keep.tsx';
import { ListenBar } from './ListenBar.tsx';
import { LiveStrip } from './LiveStrip.tsx';
import { HandIn, Pupil } from './Pupil.tsx';
import { SettingsLine } from './SettingsLine.tsx';
import { Troubles } from './Troubles.tsx';
import { WaveEditor } from './WaveEditor.tsx';
import { Welcome } from './Welcome.tsx';

/** The laboratory: the answer, the way to the next drop, the waveform, the figures and all numbers. */
export function Laboratory() {
  if (!workspace.value && !busy.value) return <Welcome />;
  return (
    <div class="lab">
      <h1 class="unseen">{text('page-app-title')}</h1>
      <Troubles />
      {busy.value ? <LiveStrip /> : <Answer />}
      {!busy.value && <HandIn />}
      <ListenBar />
      {!busy.value && <Workspace />}
    </div>
  );
}

function Workspace() {
  return (
    <>
      <WaveEditor />
      <Pupil />
      <div class="workspace">
        <Explained />
        <FigureTabs />
        <div class="stack rest">
          <SettingsLine />
          <Judged />
          <AtRest />
          <Keep />
        </div>
      </div>
    </>
  );
}
