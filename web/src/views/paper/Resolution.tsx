import { fixed, LENGTH, rounded } from '../../format/quantity.ts';
import type { Explanation } from '../../lab/index.ts';
import { language, text } from '../../text/language.ts';

/** Which balls and which lines make the paper's numbers. */
export function Resolution({ puzzle }: { readonly puzzle: readonly Explanation[] }) {
  const spoken = language.value;
  return (
    <section class="scroll" tabIndex={0} aria-label={text('page-paper-five-caption')}>
      <table>
        <caption>{text('page-paper-five-caption')}</caption>
        <thead>
          <tr>
            <th>{text('page-paper-five-law')}</th>
            <th>{text('page-paper-five-drag')}</th>
            <th class="figure">{text('page-paper-five-flights')}</th>
            <th class="figure">{text('page-paper-five-first')}</th>
            <th class="figure">{text('page-paper-five-slow')}</th>
            <th class="figure">{text('page-paper-five-height')}</th>
            <th>{text('page-paper-five-same')}</th>
          </tr>
        </thead>
        <tbody>
          {puzzle.map((way) => (
            <tr key={`${way.restitution_law} ${way.drag} ${way.flights}`}>
              <td>{text(`restitution-law-${way.restitution_law}`)}</td>
              <td>{text(`page-paper-air-names-${way.drag}`)}</td>
              <td class="figure">{way.flights}</td>
              <td class="figure">{fixed(way.restitution_at_first, 4, spoken)}</td>
              <td class="figure">{fixed(way.restitution_at_slow, 4, spoken)}</td>
              <td class="figure">{rounded(way.drop_height_m, 4, LENGTH, spoken)}</td>
              <td>
                {way.reproduces ? (
                  <strong>{text('page-paper-five-yes')}</strong>
                ) : (
                  text('page-paper-five-no')
                )}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
