import { CENTIMETRE, fixed, plain } from '../../format/quantity.ts';
import type { Explanation } from '../../lab/index.ts';
import { language, texts } from '../../text/language.ts';

/** Which balls and which lines make the paper's numbers. */
export function Resolution({ puzzle }: { readonly puzzle: readonly Explanation[] }) {
  const words = texts.value.paper;
  const head = words.five;
  const spoken = language.value;
  return (
    <section class="scroll" tabIndex={0} aria-label={head.caption}>
      <table>
        <caption>{head.caption}</caption>
        <thead>
          <tr>
            <th>{head.law}</th>
            <th>{head.drag}</th>
            <th class="figure">{head.flights}</th>
            <th class="figure">{head.first}</th>
            <th class="figure">{head.slow}</th>
            <th class="figure">{head.height}</th>
            <th>{head.same}</th>
          </tr>
        </thead>
        <tbody>
          {puzzle.map((way) => (
            <tr key={`${way.restitution_law} ${way.drag} ${way.flights}`}>
              <td>{words.lawNames[way.restitution_law] ?? way.restitution_law}</td>
              <td>{words.airNames[way.drag] ?? way.drag}</td>
              <td class="figure">{way.flights}</td>
              <td class="figure">{fixed(way.restitution_at_first, 4, spoken)}</td>
              <td class="figure">{fixed(way.restitution_at_slow, 4, spoken)}</td>
              <td class="figure">{plain(way.drop_height_m, CENTIMETRE, 4, spoken)}</td>
              <td>{way.reproduces ? <strong>{head.yes}</strong> : head.no}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
