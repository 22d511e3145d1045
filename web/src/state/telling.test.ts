import { batch } from '@preact/signals';
import { beforeEach, expect, test, vi } from 'vitest';

/** What the page spoke and how long it vibrated. */
const told = vi.hoisted(() => {
  const told = { spoken: [] as string[], vibrations: [] as number[], stored: new Map() };
  Object.assign(globalThis, {
    SpeechSynthesisUtterance: class {
      lang = '';
      constructor(readonly text: string) {}
    },
    speechSynthesis: {
      speak: ({ lang, text }: SpeechSynthesisUtterance) => told.spoken.push(`${lang}: ${text}`),
      cancel: () => undefined,
    },
    localStorage: {
      getItem: (key: string) => told.stored.get(key) ?? null,
      setItem: (key: string, value: string) => told.stored.set(key, value),
      removeItem: (key: string) => told.stored.delete(key),
    },
  });
  Object.defineProperty(globalThis, 'navigator', {
    value: { languages: ['en-GB'], vibrate: (ms: number) => told.vibrations.push(ms) },
    configurable: true,
  });
  return told;
});

import { Option } from './option.ts';
import { speech, tellAnswer, vibrate, vibration } from './telling.ts';
import { type Answer, analysed, refining, type Workspace, workspace } from './workspace.ts';

const ANSWER =
  'en-GB: The ball keeps 93.00 plus or minus 0.15 % of its speed. It fell from 30.5 plus or minus 0.3 cm.';

/** Puts a recording into the workspace, whose inference runs. */
function put(name: string): void {
  batch(() => {
    workspace.value = { name } as Workspace;
    analysed.value = null;
    refining.value = true;
  });
}

function answer(): void {
  const sentences = [
    ['The ball keeps ', '93.00\u00a0±\u00a00.15\u00a0%', ' of its speed.'],
    ['It fell from ', '30.5\u00a0±\u00a00.3\u00a0cm', '.'],
  ];
  batch(() => {
    analysed.value = {
      headlines: [{ sentences }],
      places: [0],
    } as unknown as Answer;
    refining.value = false;
  });
}

beforeEach(() => {
  told.spoken = [];
  told.vibrations = [];
  for (const option of [speech, vibration]) option.choose(false);
});

test('by default nothing is spoken and nothing vibrates', () => {
  put('a drop');
  vibrate();
  tellAnswer();
  answer();
  expect(told.spoken).toEqual([]);
  expect(told.vibrations).toEqual([]);
});

test('the answer is spoken once, when the inference is done, in words for a voice', () => {
  speech.choose(true);
  put('a drop');
  tellAnswer();
  expect(told.spoken).toEqual([]);
  answer();
  expect(told.spoken).toEqual([ANSWER]);
  refining.value = true;
  refining.value = false;
  expect(told.spoken).toEqual([ANSWER]);
});

test('the answer of a drop that is gone is not spoken', () => {
  speech.choose(true);
  put('a drop');
  tellAnswer();
  put('another');
  answer();
  expect(told.spoken).toEqual([]);
});

test('a choice is remembered, and holds only where the browser can do it', () => {
  vibration.choose(true);
  vibrate();
  expect(told.vibrations).toHaveLength(1);
  expect(new Option('vibration', true).isOn).toBe(true);
  expect(new Option('vibration', false).isOn).toBe(false);
  vibration.choose(false);
  expect(new Option('vibration', true).isOn).toBe(false);
});
