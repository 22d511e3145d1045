import { fixed, localised } from '../../format/quantity.ts';
import type { PaperFact } from '../../lab/index.ts';
import { language, text } from '../../text/language.ts';
import { nameIn } from '../../text/names.ts';

/** Every number of the paper next to the computed one. */
export function EveryNumber({ facts }: { readonly facts: readonly PaperFact[] }) {
  const chapters = [...new Set(facts.map(({ chapter }) => chapter))];
  return (
    <>
      {chapters.map((chapter) => (
        <details key={chapter}>
          <summary>{chapter}</summary>
          <Chapter facts={facts.filter((fact) => fact.chapter === chapter)} name={chapter} />
        </details>
      ))}
    </>
  );
}

interface ChapterProps {
  readonly facts: readonly PaperFact[];
  readonly name: string;
}

function Chapter({ facts, name }: ChapterProps) {
  return (
    <section class="scroll" tabIndex={0} aria-label={name}>
      <table class="wide">
        <thead>
          <tr>
            <th>{text('page-paper-six-quantity')}</th>
            <th class="figure">{text('page-paper-six-printed')}</th>
            <th class="figure">{text('page-paper-six-computed')}</th>
            <th>{text('page-paper-six-verdict')}</th>
          </tr>
        </thead>
        <tbody>
          {facts.map((fact) => (
            <tr key={fact.code}>
              <td>
                {fact.quantity}
                {fact.note && <small class="soft note">{fact.note}</small>}
              </td>
              <td class="figure">{fact.printed === null ? '' : withUnit(fact.printed, fact)}</td>
              <td class="figure">{withUnit(computed(fact), fact)}</td>
              <td>{fact.verdict && nameIn(`page-paper-verdicts-${fact.verdict}`, fact.verdict)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

const withUnit = (number: string, { unit }: PaperFact): string => {
  const shown = localised(number, language.value);
  return unit === '' ? shown : `${shown}\u00a0${raised(unit)}`;
};

/** Powers of ten as people write them: "10^-2 N" as "· 10⁻² N". */
const raised = (unit: string): string =>
  unit.replace(/10\^([-\d]+)/, (_, power: string) => {
    const digits = [...power].map((digit) => (digit === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]));
    return `·\u00a010${digits.join('')}`;
  });

/** With one digit more than the paper, but never fewer than four. */
function computed({ computed: value }: PaperFact): string {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential(3);
  const decimals = size === 0 ? 0 : Math.max(0, 3 - Math.floor(Math.log10(size)));
  return fixed(value, Math.min(decimals, 6), language.value);
}
