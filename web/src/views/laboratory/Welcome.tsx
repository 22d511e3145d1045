import { signal } from '@preact/signals';
import { texts } from '../../text/language.ts';
import { Troubles } from './Laboratory.tsx';
import { ListenButton } from './ListenButton.tsx';
import { OtherWays } from './OtherWays.tsx';
import { Paste } from './Paste.tsx';

/** Whether the box for times is unfolded. */
export const pasting = signal(false);

const handheld = globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;

/** Before the first drop: a sentence, a button and three quiet links. */
export function Welcome() {
  const words = texts.value.lab;
  return (
    <div class="welcome">
      <h1>{handheld ? words.inviteTouch : words.invite}</h1>
      <ListenButton />
      <OtherWays />
      {pasting.value && <Paste />}
      <Troubles />
    </div>
  );
}
