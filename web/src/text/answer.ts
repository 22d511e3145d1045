/** The answer of a drop: restitution and drop height with their uncertainties. */
import { estimated, LENGTH, PERCENT } from '../format/quantity.ts';
import type { Drop } from '../lab/index.ts';
import { language, text } from './language.ts';

/** What is known of the answer, in the manner of the language. */
export interface Answer {
  /** How much of its speed the ball kept. */
  readonly share: string | undefined;
  readonly height: string | undefined;
  /** The sentence that contains the height. */
  readonly heightSentence: 'page-lab-fell' | 'page-lab-stated';
}

/** By the inference once it is there. */
export function answerOf({ posterior, per_impact, log_linear_fit }: Drop): Answer {
  const e = (posterior ?? per_impact)?.restitution ?? log_linear_fit?.restitution;
  const height = (posterior ?? log_linear_fit)?.drop_height_m;
  const isStated = posterior?.priors.some(({ code }) => code === 'prior-height');
  const spoken = language.value;
  return {
    share: e && estimated(e.value, e.sd, PERCENT, spoken),
    height: height && estimated(height.value, height.sd, LENGTH, spoken),
    heightSentence: isStated ? 'page-lab-stated' : 'page-lab-fell',
  };
}

/** The answer for a voice, which may leave out a sign or stumble over a space that does not break. */
export function spokenAnswer(result: Drop): string {
  const { share, height, heightSentence } = answerOf(result);
  const sentences = [
    share === undefined ? text('page-lab-cannot-tell') : text('page-lab-kept', { share }),
    ...(height === undefined ? [] : [text(heightSentence, { height })]),
  ];
  return sentences
    .join(' ')
    .replaceAll('±', text('page-rest-plus-minus'))
    .replaceAll('\u00a0', ' ');
}
