import { Paragraphs } from '../../app/Paragraphs.tsx';
import { labAddress } from '../../state/settings.ts';
import { text } from '../../text/language.ts';
import { EveryNumber } from './EveryNumber.tsx';
import { Puzzle } from './Puzzle.tsx';
import { Facts } from './paper-data.ts';
import { Resolution } from './Resolution.tsx';
import { DragFigure, HeightFigure, RulerFigure } from './Sections.tsx';

/** The paper's argument, its figures and numbers computed while it is read. */
export function Paper() {
  return (
    <article class="article">
      <header class="words">
        <h1>{text('page-paper-title')}</h1>
        <p class="small soft">
          <cite>{text('page-paper-source')}</cite>
        </p>
        <p class="lead">{text('page-paper-lead')}</p>
      </header>
      <section class="beside">
        <div class="words">
          <h2>{text('page-paper-one-title')}</h2>
          <Paragraphs of={[text('page-paper-one-text-1'), text('page-paper-one-text-2')]} />
          <Equation of={text('page-paper-one-title')}>{text('page-paper-one-equation')}</Equation>
        </div>
        <RulerFigure />
      </section>
      <section class="narrow">
        <h2>{text('page-paper-two-title')}</h2>
        <Paragraphs of={[text('page-paper-two-text-1'), text('page-paper-two-text-2')]} />
      </section>
      <section class="beside">
        <div class="words">
          <h2>{text('page-paper-three-title')}</h2>
          <Paragraphs of={[text('page-paper-three-text')]} />
          <Equation of={text('page-paper-three-title')}>
            {text('page-paper-three-equation')}
          </Equation>
        </div>
        <div class="stack wide">
          <DragFigure />
          <HeightFigure />
        </div>
      </section>
      <Puzzle />
      <section>
        <h2>{text('page-paper-five-title')}</h2>
        <Paragraphs
          of={[
            text('page-paper-five-text-1'),
            text('page-paper-five-text-2'),
            text('page-paper-five-text-3'),
          ]}
        />
        <Facts>{(document) => <Resolution puzzle={document.puzzle} />}</Facts>
      </section>
      <section>
        <h2>{text('page-paper-six-title')}</h2>
        <p>{text('page-paper-six-lead')}</p>
        <Facts>{(document) => <EveryNumber facts={document.facts} />}</Facts>
      </section>
      <p>
        <a class="button primary" href={labAddress.value}>
          {text('page-paper-try-it')}
        </a>
      </p>
    </article>
  );
}

interface EquationProps {
  /** The heading above it, which names it. */
  readonly of: string;
  readonly children: string;
}

/** One that is wider than the screen moves sideways, also by the keyboard. */
function Equation({ of, children }: EquationProps) {
  return (
    <section class="equation scroll" tabIndex={0} aria-label={of}>
      {children}
    </section>
  );
}
