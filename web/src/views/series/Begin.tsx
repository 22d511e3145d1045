import { useState } from 'preact/hooks';
import { Choice } from '../../app/Choice.tsx';
import { NumberField } from '../../app/NumberField.tsx';
import { useAnswer } from '../../chart/Figure.tsx';
import { MAX_NUMBER } from '../../lab/engine/types.ts';
import { catalogue, engine } from '../../state/engine.ts';
import { begin } from '../../state/series.ts';
import { busy } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { ballName } from '../../text/names.ts';
import { Field } from './Field.tsx';

/** What is chosen when a test series begins. */
export function Begin() {
  const [rule, setRule] = useState('');
  const [name, setName] = useState('');
  const [places, setPlaces] = useState<number>();
  const [drops, setDrops] = useState<number>();
  const [ball, setBall] = useState('');
  const rules = useAnswer(() => engine().rules(), null) ?? [];
  const chosen = rules.find((choice) => choice.name === rule);
  const isReady = chosen && name.trim() !== '' && (chosen.has_ball || ball !== '');
  const whole = (number: number | undefined): number | null =>
    number === undefined ? null : Math.round(number);
  return (
    <form
      class="stack"
      aria-labelledby="new-series"
      onSubmit={(event) => {
        event.preventDefault();
        if (!isReady || busy.peek()) return;
        const settings = chosen.has_ball ? {} : { ball: { kind: ball } };
        void begin({ rule, name, places: whole(places), drops: whole(drops), settings });
      }}
    >
      <h2 id="new-series">{text('page-series-new')}</h2>
      <div class="measures">
        <Field label={text('page-series-name')} value={name} onChange={setName} />
        <Choice
          label={text('page-verdict-rule')}
          value={rule}
          options={[['', '…'], ...rules.map(({ name, title }) => [name, title] as const)]}
          onChange={setRule}
        />
        {chosen && !chosen.has_ball && (
          <Choice
            label={text('page-series-ball')}
            value={ball}
            options={[
              ['', '…'],
              ...(catalogue.value?.balls ?? []).map(({ name }) => [name, ballName(name)] as const),
            ]}
            onChange={setBall}
          />
        )}
        <NumberField
          label={text('page-series-places')}
          unit=""
          value={places}
          min={1}
          max={MAX_NUMBER}
          onChange={setPlaces}
        />
        <NumberField
          label={text('page-series-drops')}
          unit=""
          value={drops}
          min={1}
          max={MAX_NUMBER}
          onChange={setDrops}
        />
      </div>
      <p class="small soft">{text('page-series-as-the-rule')}</p>
      <div>
        <button type="submit" class="button primary" disabled={!isReady || busy.value}>
          {text('page-series-begin')}
        </button>
      </div>
    </form>
  );
}
