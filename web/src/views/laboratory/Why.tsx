import { useMemo } from 'preact/hooks';
import { Chart } from '../../chart/Chart.tsx';
import { Key } from '../../chart/Key.tsx';
import { restitutionChart } from '../../figures/restitution.ts';
import { drop } from '../../state/bench.ts';
import { texts } from '../../text/language.ts';

/** Why the air matters: two paragraphs and a small figure of this very drop. */
export function Why() {
  const words = texts.value.lab;
  return (
    <details>
      <summary>{texts.value.app.why}</summary>
      <div class="why">
        {words.whyAir.map((paragraph) => (
          <p key={paragraph}>{paragraph}</p>
        ))}
        <SmallFigure />
      </div>
    </details>
  );
}

function SmallFigure() {
  const said = drop.value;
  const words = texts.value;
  const spec = useMemo(
    () => (said ? { ...restitutionChart(said, words), heightRem: 12 } : undefined),
    [said, words],
  );
  if (!spec) return null;
  return (
    <>
      <Key spec={spec} />
      <Chart spec={spec} />
    </>
  );
}
