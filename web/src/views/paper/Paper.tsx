import { Paragraphs } from '../../app/Paragraphs.tsx';
import { labAddress } from '../../state/settings.ts';
import { texts } from '../../text/language.ts';
import { EveryNumber } from './EveryNumber.tsx';
import { Puzzle } from './Puzzle.tsx';
import { Facts } from './paper-data.ts';
import { Resolution } from './Resolution.tsx';
import { DragFigure, HeightFigure, RulerFigure } from './Sections.tsx';

/** The paper's argument, its figures and numbers computed while it is read. */
export function Paper() {
  const words = texts.value.paper;
  return (
    <article class="article">
      <header class="words">
        <h1>{words.title}</h1>
        <p class="small soft">
          <cite>{words.source}</cite>
        </p>
        <p class="lead">{words.lead}</p>
      </header>
      <section class="beside">
        <div class="words">
          <h2>{words.one.title}</h2>
          <Paragraphs of={words.one.text} />
          <Equation of={words.one.title}>{words.one.equation}</Equation>
        </div>
        <RulerFigure />
      </section>
      <section class="narrow">
        <h2>{words.two.title}</h2>
        <Paragraphs of={words.two.text} />
      </section>
      <section class="beside">
        <div class="words">
          <h2>{words.three.title}</h2>
          <Paragraphs of={words.three.text} />
          <Equation of={words.three.title}>{words.three.equation}</Equation>
        </div>
        <div class="stack wide">
          <DragFigure />
          <HeightFigure />
        </div>
      </section>
      <Puzzle />
      <section>
        <h2>{words.five.title}</h2>
        <Paragraphs of={words.five.text} />
        <Facts>{(document) => <Resolution puzzle={document.puzzle} />}</Facts>
      </section>
      <section>
        <h2>{words.six.title}</h2>
        <p>{words.six.lead}</p>
        <Facts>{(document) => <EveryNumber facts={document.facts} />}</Facts>
      </section>
      <p>
        <a class="button primary" href={labAddress.value}>
          {words.tryIt}
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
