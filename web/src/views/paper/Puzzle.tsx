import { useState } from 'preact/hooks';
import { Paragraphs } from '../../app/Paragraphs.tsx';
import { Rich } from '../../app/Rich.tsx';
import { Slider } from '../../app/Slider.tsx';
import { Figure, useAnswer } from '../../chart/Figure.tsx';
import { fixed, LENGTH, rounded } from '../../format/quantity.ts';
import type { PuzzleChoice } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';
import { language, parts, text } from '../../text/language.ts';

const MAX_FLIGHTS = 40;
/** What a bounce loses for each m/s when ten flights reproduce the paper (`bouncelab paper`). */
const SOLVING_SLOPE = 0.02374;
const FIRST: PuzzleChoice = { restitution: 0.935, loss_per_speed_s_m: 0, flights: 10 };

/** The discrepancy of the paper: simulate a drop with air, apply the log-linear fit of the paper, compare. */
export function Puzzle() {
  const spoken = language.value;
  const [choice, setChoice] = useState<PuzzleChoice>(FIRST);
  const answer = useAnswer(() => engine().puzzleAnswer(choice), choice);
  const solve = async (loss_per_speed_s_m: number, flights: number): Promise<void> => {
    setChoice(await engine().puzzleSolution({ ...choice, loss_per_speed_s_m, flights }));
  };
  return (
    <section class="beside">
      <div class="words">
        <h2>{text('page-paper-four-title')}</h2>
        <Paragraphs of={[text('page-paper-four-text')]} />
        <Slider
          label={text('page-paper-four-e')}
          min={0.9}
          max={0.98}
          step={0.0005}
          value={choice.restitution}
          shown={fixed(choice.restitution, 4, spoken)}
          onInput={(restitution) => setChoice({ ...choice, restitution })}
        />
        <Slider
          label={text('page-paper-four-slope')}
          min={0}
          max={0.04}
          step={0.0005}
          value={choice.loss_per_speed_s_m}
          shown={fixed(choice.loss_per_speed_s_m, 4, spoken)}
          onInput={(loss_per_speed_s_m) => setChoice({ ...choice, loss_per_speed_s_m })}
        />
        <Slider
          label={text('page-paper-four-flights')}
          min={3}
          max={MAX_FLIGHTS}
          step={1}
          value={choice.flights}
          shown={fixed(choice.flights, 0, spoken)}
          onInput={(flights) => setChoice({ ...choice, flights })}
        />
        <div class="row">
          <button type="button" class="quiet" onClick={() => void solve(0, 10)}>
            {text('page-paper-four-solve-drag')}
          </button>
          <button type="button" class="quiet" onClick={() => void solve(0, 21)}>
            {text('page-paper-four-solve-many')}
          </button>
          <button type="button" class="quiet" onClick={() => void solve(SOLVING_SLOPE, 10)}>
            {text('page-paper-four-solve-slope')}
          </button>
        </div>
        {answer && (
          <p class="lead" role="status">
            <Rich
              parts={parts('page-paper-four-line-says', {
                e: fixed(answer.restitution, 4, spoken),
                h: rounded(answer.drop_height_m, 3, LENGTH, spoken),
              })}
            />{' '}
            {answer.reproduces && <strong>{text('page-paper-four-hit')}</strong>}
          </p>
        )}
        <p class="soft">
          {text('page-paper-four-paper-says')} {text('page-paper-four-truth')}
        </p>
      </div>
      <Figure chart={answer?.chart} see={text('page-paper-four-see')} />
    </section>
  );
}
