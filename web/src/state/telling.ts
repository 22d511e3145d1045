/** What the page does when the ball rests, if the reader wants it: it vibrates and speaks the answer. */
import { effect } from '@preact/signals';
import { spokenAnswer } from '../text/answer.ts';
import { region } from '../text/language.ts';
import { Option } from './option.ts';
import { headline, refining, workspace } from './workspace.ts';

const VIBRATION_MS = 300;

export const speech = new Option('speech', 'speechSynthesis' in globalThis);
export const vibration = new Option('vibration', 'vibrate' in navigator);

/** Says that the ball rests, before anything is computed. */
export function vibrate(): void {
  if (vibration.isOn) navigator.vibrate(VIBRATION_MS);
}

/** Speaks the answer of what lies in the workspace as soon as it is there, unless something else lies there by then. */
export function tellAnswer(): void {
  if (!speech.isOn) return;
  const asked = workspace.peek();
  effect(function () {
    const isGone = workspace.value !== asked;
    if (!isGone && refining.value) return;
    this.dispose();
    const answer = headline.peek();
    if (isGone || !answer) return;
    const utterance = new SpeechSynthesisUtterance(spokenAnswer(answer));
    utterance.lang = region.peek();
    speechSynthesis.speak(utterance);
  });
}

/** Ends what is spoken: the microphone would hear it. */
export function hush(): void {
  if (speech.offered) speechSynthesis.cancel();
}
