import { beforeAll, beforeEach, expect, test, vi } from 'vitest';

/** What the worklet hands over: samples, or how many frames are missing. */
let handed: (Float32Array | number)[] = [];
let feed: (channels: Float32Array[]) => boolean;
let makeTap: () => { process(inputs: Float32Array[][]): boolean };

beforeAll(async () => {
  // The audio thread, as far as the worklet knows it: blocks of 256 frames.
  vi.stubGlobal('sampleRate', 20 * 256);
  vi.stubGlobal(
    'AudioWorkletProcessor',
    class {
      readonly port = { postMessage: (what: Float32Array | number) => handed.push(what) };
    },
  );
  vi.stubGlobal('registerProcessor', (_: string, Tap: new () => ReturnType<typeof makeTap>) => {
    makeTap = () => new Tap();
  });
  // @ts-expect-error It is no module of the page: the audio thread loads it.
  await import('./tap.worklet.js');
});

beforeEach(() => {
  handed = [];
  const tap = makeTap();
  let frame = 1280;
  feed = (channels) => {
    vi.stubGlobal('currentFrame', frame);
    frame += 128;
    return tap.process([channels]);
  };
});

const sound = (value: number) => [new Float32Array(128).fill(value)];

test('every sample is handed over, in order', () => {
  for (const value of [1, 2, 3, 4]) expect(feed(sound(value))).toBe(true);
  expect(handed).toEqual([
    Float32Array.from([...(sound(1)[0] ?? []), ...(sound(2)[0] ?? [])]),
    Float32Array.from([...(sound(3)[0] ?? []), ...(sound(4)[0] ?? [])]),
  ]);
});

test('frames without a channel, or without samples, are counted where they are missing', () => {
  feed(sound(1));
  for (const nothing of [[], [new Float32Array()], []]) expect(feed(nothing)).toBe(true);
  feed(sound(2));
  feed(sound(3));
  expect(handed).toEqual([
    ...sound(1),
    3 * 128,
    Float32Array.from([...(sound(2)[0] ?? []), ...(sound(3)[0] ?? [])]),
  ]);
});

test('before the first sound nothing is missing', () => {
  feed([]);
  feed(sound(1));
  feed(sound(2));
  expect(handed).toHaveLength(1);
});
