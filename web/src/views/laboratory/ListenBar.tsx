import { busy } from '../../state/workspace.ts';
import { ListenButton } from './ListenButton.tsx';
import { OtherWays } from './OtherWays.tsx';
import { Paste } from './Paste.tsx';
import { pasting } from './pasting.ts';

/** The way to the next drop; on a phone within reach of the thumb. */
export function ListenBar() {
  return (
    <>
      <div class="again">
        <ListenButton small />
        <OtherWays />
      </div>
      {pasting.value && !busy.value && <Paste />}
    </>
  );
}
