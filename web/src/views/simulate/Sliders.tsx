import { useId } from 'preact/hooks';
import { SLIDERS, type Slider as SliderName } from '../../address/simulation.ts';
import { Choice } from '../../app/Choice.tsx';
import { Slider } from '../../app/Slider.tsx';
import { useTyped } from '../../app/typed.ts';
import { fixed, LENGTH, PERCENT, rounded } from '../../format/quantity.ts';
import { catalogue } from '../../state/engine.ts';
import { move, setup } from '../../state/simulating.ts';
import { language, text } from '../../text/language.ts';
import { ballName, lawChoices, nameIn } from '../../text/names.ts';

/** What can be moved. */
export function Sliders() {
  const spoken = language.value;
  const now = setup.value;
  const offered = catalogue.value;
  const body = offered?.bodies.find(({ name }) => name === now.body);
  const slider = (name: SliderName) => {
    const { min, max, step } = SLIDERS[name];
    return {
      min,
      max,
      step,
      value: now[name],
      onInput: (value: number) => move({ [name]: value }),
    };
  };
  return (
    <div class="sliders">
      <Slider
        label={text('page-simulate-height')}
        shown={rounded(now.heightM, now.heightM < 1 ? 3 : 4, LENGTH, spoken)}
        {...slider('heightM')}
      />
      <Slider
        label={text('page-simulate-restitution')}
        shown={fixed(now.restitution, 4, spoken)}
        disabled={now.law !== ''}
        {...slider('restitution')}
      />
      <Slider
        label={text('page-simulate-slope')}
        hint={text('page-simulate-slope-hint')}
        shown={fixed(now.slope, 4, spoken)}
        disabled={now.law !== ''}
        {...slider('slope')}
      />
      <Law />
      <Choice
        label={text('page-simulate-ball')}
        value={now.ball}
        options={(offered?.balls ?? []).map(({ name }) => [name, ballName(name)] as const)}
        onChange={(ball) => move({ ball })}
      />
      <Choice
        label={text('page-simulate-body')}
        value={now.body}
        options={(offered?.bodies ?? []).map(
          ({ name }) => [name, nameIn(`page-simulate-bodies-${name}`, name)] as const,
        )}
        onChange={(where) => move({ body: where })}
      />
      <Slider
        label={text('page-simulate-pressure')}
        shown={rounded(now.air, 3, PERCENT, spoken)}
        disabled={body?.air_density_kg_m3 === 0}
        {...slider('air')}
      />
      <Choice
        label={text('page-simulate-drag')}
        value={now.drag}
        options={lawChoices(now.drag)}
        onChange={(drag) => move({ drag })}
      />
    </div>
  );
}

/** Any restitution law that the engine lists: an example to begin with, and its numbers to change. */
function Law() {
  const id = useId();
  const { law } = setup.value;
  const typed = useTyped(law, (written) => move({ law: written.replaceAll(' ', '') }));
  const laws = catalogue.value?.restitution_laws ?? [];
  const example = laws.find(({ name }) => name === law.split(':')[0])?.example ?? '';
  return (
    <>
      <Choice
        label={text('page-simulate-law')}
        value={example}
        options={[
          ['', text('page-simulate-law-of-sliders')],
          ...laws.map(
            ({ name, example }) => [example, nameIn(`restitution-law-${name}`, name)] as const,
          ),
        ]}
        onChange={(chosen) => move({ law: chosen })}
      />
      {law !== '' && (
        <div class="field">
          <label for={id}>{text('page-simulate-law-numbers')}</label>
          <input id={id} {...typed} />
        </div>
      )}
    </>
  );
}
