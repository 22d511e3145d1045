import { useEffect, useRef } from 'preact/hooks';
import { LENGTH, rounded, TIME } from '../format/quantity.ts';
import type { Drop, Simulation } from '../lab/index.ts';
import { media } from '../style/media.ts';
import { language, text } from '../text/language.ts';

/** From one impact to the next. */
export interface Hop {
  readonly fromS: number;
  readonly untilS: number;
  readonly apexM: number;
}

/** The hops of a measured drop: as high as the flight model says, or as flights without air are. */
export const hopsOf = ({ impacts, flights }: Drop): Hop[] =>
  flights.flatMap(({ flight_time_s, apex_m, drag_free_height_m }, place) => {
    const fromS = impacts[place]?.time_s;
    if (fromS === undefined) return [];
    return { fromS, untilS: fromS + flight_time_s, apexM: apex_m ?? drag_free_height_m };
  });

/** The hops of a simulated drop. */
export const hopsOfSimulation = ({ bounces }: Simulation): Hop[] =>
  bounces.map(({ time_s, flight_time_s, apex_m }) => ({
    fromS: time_s,
    untilS: time_s + flight_time_s,
    apexM: apex_m,
  }));

interface Props {
  readonly hops: readonly Hop[];
  /** How far the picture reaches at least, in seconds. */
  readonly leastS?: number;
  /** The moment since when a ball moves along it, by the clock of the page in milliseconds. */
  readonly since?: number | undefined;
}

const isStill = media('(prefers-reduced-motion: reduce)');

/** The height of the ball against time, hop by hop: the rise and fall of a hop are drawn as a parabola. */
export function HeightCurve({ hops, leastS = 0, since }: Props) {
  const startS = hops[0]?.fromS ?? 0;
  const lastsS = Math.max(leastS, (hops.at(-1)?.untilS ?? 0) - startS);
  const highestM = Math.max(0, ...hops.map(({ apexM }) => apexM));
  const x = (timeS: number): string => (((timeS - startS) / lastsS) * 100).toFixed(2);
  // A parabola rises to half of the height of its control point.
  const path = hops
    .map(({ fromS, untilS, apexM }) => {
      const top = (100 - (200 * apexM) / highestM).toFixed(2);
      return `M${x(fromS)} 100Q${x((fromS + untilS) / 2)} ${top} ${x(untilS)} 100`;
    })
    .join('');
  const length = rounded(highestM, 2, LENGTH, language.value);
  return (
    <div class="curve" role="img" aria-label={text('page-curve-label', { height: length })}>
      {highestM > 0 && <span class="small soft top">{length}</span>}
      <svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
        <path d="M0 100H100" class="floor" />
        {highestM > 0 && <path d={path} />}
      </svg>
      {since !== undefined && !isStill.value && (
        <Ball key={since} {...{ hops, startS, lastsS, highestM, since }} />
      )}
      {highestM > 0 && (
        <span class="small soft end">{rounded(lastsS, 2, TIME, language.value)}</span>
      )}
    </div>
  );
}

interface Path {
  readonly hops: readonly Hop[];
  readonly startS: number;
  readonly lastsS: number;
  readonly highestM: number;
  readonly since: number;
}

/** The ball itself, in its own time, once. */
function Ball({ hops, startS, lastsS, highestM, since }: Path) {
  const ball = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    let frame = 0;
    const step = (now: number): void => {
      const timeS = startS + Math.max(0, now - since) / 1000;
      const hop = hops.find(({ untilS }) => timeS < untilS);
      const share = hop ? (timeS - hop.fromS) / (hop.untilS - hop.fromS) : 0;
      const height = hop ? (4 * share * (1 - share) * hop.apexM) / highestM : 0;
      ball.current?.style.setProperty('left', `${Math.min(1, (timeS - startS) / lastsS) * 100}%`);
      ball.current?.style.setProperty('bottom', `${height * 100}%`);
      if (hop) frame = requestAnimationFrame(step);
    };
    frame = requestAnimationFrame(step);
    return () => cancelAnimationFrame(frame);
  }, [hops, since]);
  return <span ref={ball} class="moving" />;
}
