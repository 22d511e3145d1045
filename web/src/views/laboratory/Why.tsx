import { Figure, useAnswer } from '../../chart/Figure.tsx';
import { engine } from '../../state/engine.ts';
import { figureRequest } from '../../state/figures.ts';
import { analysed, chosenDrop } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** Why the air matters: two paragraphs and a figure of this very drop. */
export function Why() {
  return (
    <details>
      <summary>{text('page-app-why')}</summary>
      <div class="why">
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
