import { busy, onBench } from '../../state/bench.ts';
import { texts } from '../../text/language.ts';
import { FigureTabs } from './FigureTabs.tsx';
import { Keep } from './Keep.tsx';
import { ListenBar } from './ListenBar.tsx';
import { LiveStrip } from './LiveStrip.tsx';
import { Said } from './Said.tsx';
import { SettingsLine } from './SettingsLine.tsx';
import { Troubles } from './Troubles.tsx';
import { WaveBench } from './WaveBench.tsx';
import { Welcome } from './Welcome.tsx';

/** The laboratory: from a button, downwards, to everything the bounces say. */
export function Laboratory() {
  if (!onBench.value && !busy.value) return <Welcome />;
  return (
    <div class="lab">
      <h1 class="unseen">{texts.value.app.title}</h1>
      <ListenBar />
      <Troubles />
      {busy.value ? <LiveStrip /> : <Bench />}
    </div>
  );
}

function Bench() {
  return (
    <>
      <WaveBench />
      <div class="bench">
        <Said />
        <FigureTabs />
        <div class="stack rest">
          <SettingsLine />
          <Keep />
        </div>
      </div>
    </>
  );
}
