import { Rich } from '../../app/Rich.tsx';
import { Figure, useAnswer } from '../../chart/Figure.tsx';
import type { Sentence } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';
import { figureRequest } from '../../state/figures.ts';
import { analysed, chosenDrop } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** What neglecting the air gives, and why that matters: two paragraphs and a figure of this very drop. */
export function Why({ sentence }: { readonly sentence: Sentence }) {
  return (
    <details>
      <summary>{text('page-lab-why')}</summary>
      <div class="why">
        <p>
          <Rich parts={sentence} />
        </p>
        {[text('page-lab-why-air-1'), text('page-lab-why-air-2')].map((paragraph) => (
          <p key={paragraph}>{paragraph}</p>
        ))}
        {analysed.value && <SmallFigure />}
      </div>
    </details>
  );
}

function SmallFigure() {
  const result = analysed.value;
  const chart = useAnswer(async () => {
    const asked = result && figureRequest('restitution', result.inference);
    return asked ? engine().chart(asked) : undefined;
  }, [result, chosenDrop.value]);
  return <Figure chart={chart} see="" />;
}
