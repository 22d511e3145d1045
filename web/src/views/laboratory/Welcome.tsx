import { lesson } from '../../state/lesson.ts';
import { isPhone } from '../../style/media.ts';
import { text } from '../../text/language.ts';
import { AtRest } from './AtRest.tsx';
import { ListenButton } from './ListenButton.tsx';
import { OtherWays } from './OtherWays.tsx';
import { Paste } from './Paste.tsx';
import { Pupil } from './Pupil.tsx';
import { pasting } from './pasting.ts';
import { SetUp } from './SetUp.tsx';
import { Troubles } from './Troubles.tsx';

/** Before the first drop: a sentence, a button, the balls, three quiet links and what to do at the end. */
export function Welcome() {
  return (
    <div class="welcome">
      <h1>{isPhone ? text('page-lab-invite-touch') : text('page-lab-invite')}</h1>
      <p class="soft">{text('page-lab-lead')}</p>
      <ListenButton />
      <Pupil />
      <OtherWays />
      {!lesson.value && <AtRest />}
      <Troubles />
      <SetUp />
      {pasting.value && <Paste />}
    </div>
  );
}
