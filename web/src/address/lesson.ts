/** A lesson as part of the address: what its pupils drop, on what, and from which height. */
import { readNumber, tidy } from './settings.ts';

export interface Lesson {
  /** Balls by the names of the engine. */
  readonly balls: readonly string[];
  readonly surfaces: readonly string[];
  readonly heightsM: readonly number[];
}

/** The parameter with the balls; where it is, there is a lesson. */
const BALLS = 'lesson';
const SURFACES = 'surfaces';
const HEIGHTS = 'heights_cm';

/** As many choices as a pupil looks through, and letters of a surface. */
const MOST = 12;
const LETTERS = 40;

export function lessonToParameters({ balls, surfaces, heightsM }: Lesson): URLSearchParams {
  const parameters = new URLSearchParams({ [BALLS]: balls.join('.') });
  if (surfaces.length > 0) parameters.set(SURFACES, surfaces.join(';'));
  if (heightsM.length > 0) parameters.set(HEIGHTS, heightsM.map((m) => tidy(100 * m)).join(';'));
  return parameters;
}

/** The lesson of an address; what is not valid in it is left out. */
export function lessonFromParameters(parameters: URLSearchParams): Lesson | null {
  const balls = parameters.get(BALLS);
  if (balls === null) return null;
  return {
    balls: listed(balls, '.').filter((name) => /^[\w:-]{1,40}$/.test(name)),
    surfaces: listed(parameters.get(SURFACES) ?? '', ';').map((name) => name.slice(0, LETTERS)),
    heightsM: heightsOf(parameters.get(HEIGHTS) ?? ''),
  };
}

/** Different entries of a list, none of which is empty. */
export function listed(text: string, between: string): readonly string[] {
  const entries = text.split(between).map((entry) => entry.trim());
  return [...new Set(entries.filter((entry) => entry !== ''))].slice(0, MOST);
}

/** Heights of a list in centimetres, in metres. */
export const heightsOf = (text: string): readonly number[] =>
  listed(text, ';').flatMap((entry) => {
    const cm = readNumber(entry);
    return cm !== undefined && cm > 0 && cm < 1e4 ? [Number((cm / 100).toPrecision(10))] : [];
  });
