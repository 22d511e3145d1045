import { useState } from 'preact/hooks';
import { heightsOf, lessonToParameters, listed } from '../../address/lesson.ts';
import { addressOf } from '../../address/route.ts';
import { HandOver } from '../../app/HandOver.tsx';
import { useAnswer } from '../../chart/Figure.tsx';
import { catalogue, engine } from '../../state/engine.ts';
import { text } from '../../text/language.ts';
import { ballName } from '../../text/names.ts';
import { Sheets } from './Sheets.tsx';

/** What a teacher gives a lesson: balls, surfaces and heights; it becomes one link for all pupils. */
export function LessonMaker() {
  const [balls, setBalls] = useState<readonly string[]>([]);
  const [surfaces, setSurfaces] = useState('');
  const [heights, setHeights] = useState('');
  const given = {
    balls,
    surfaces: listed(surfaces, ','),
    heightsM: heightsOf(heights.replaceAll(/,\s/g, ';')),
  };
  const parameters = balls.length > 0 ? lessonToParameters(given) : undefined;
  const address = addressOf('lab', parameters);
  const link = useAnswer(
    async () => (balls.length > 0 ? engine().qrCode(address) : undefined),
    address,
  );
  const toggle = (name: string): void =>
    setBalls(balls.includes(name) ? balls.filter((ball) => ball !== name) : [...balls, name]);
  return (
    <details class="lesson">
      <summary>{text('page-lesson-make')}</summary>
      <div class="stack">
        <p class="small soft">{text('page-lesson-make-hint')}</p>
        <fieldset class="ticks">
          <legend class="small">{text('page-lesson-balls')}</legend>
          {catalogue.value?.balls.map(({ name }) => (
            <label key={name} class="check">
              <input type="checkbox" checked={balls.includes(name)} onChange={() => toggle(name)} />
              {ballName(name)}
            </label>
          ))}
        </fieldset>
        <div class="measures">
          <Field
            id="surfaces"
            label={text('page-lesson-surfaces')}
            value={surfaces}
            set={setSurfaces}
          />
          <Field
            id="heights"
            label={text('page-lesson-heights')}
            value={heights}
            set={setHeights}
          />
        </div>
        {balls.length > 0 && link && <HandOver link={link} label={text('page-lesson-qr')} />}
        <Sheets address={address} />
      </div>
    </details>
  );
}

interface FieldProps {
  readonly id: string;
  readonly label: string;
  readonly value: string;
  readonly set: (value: string) => void;
}

function Field({ id, label, value, set }: FieldProps) {
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <input
        id={id}
        autocomplete="off"
        value={value}
        onInput={(event) => set(event.currentTarget.value)}
      />
    </div>
  );
}
