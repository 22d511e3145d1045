import { texts } from '../../text/language.ts';
import { ListenButton } from './ListenButton.tsx';
import { OtherWays } from './OtherWays.tsx';
import { Paste } from './Paste.tsx';
import { pasting } from './pasting.ts';
import { Troubles } from './Troubles.tsx';

const handheld = globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;

/** Before the first drop: a sentence, a button and three quiet links. */
export function Welcome() {
  const words = texts.value.lab;
  return (
    <div class="welcome">
      <h1>{handheld ? words.inviteTouch : words.invite}</h1>
      <ListenButton />
      <OtherWays />
      <Troubles />
      {pasting.value && <Paste />}
    </div>
  );
}
