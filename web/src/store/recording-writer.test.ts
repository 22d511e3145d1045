import { beforeEach, expect, test, vi } from 'vitest';
import { RecordingWriter } from './recording-writer.ts';
import { countBlocks, putBlock, putRecording } from './recordings.ts';

vi.mock('./recordings.ts', () => ({
  countBlocks: vi.fn(),
  putBlock: vi.fn(),
  putRecording: vi.fn(),
}));

const recording = { id: 'r', name: 'drop', rateHz: 4, startedAt: 0, finished: false };
const block = (...samples: number[]) => Float32Array.from(samples);

const gap = { start_s: 1, duration_s: 0.5, certain: true };
const silent = { fault: () => undefined, saved: () => undefined };

beforeEach(() => {
  vi.mocked(putBlock).mockReset().mockResolvedValue();
  vi.mocked(putRecording).mockReset().mockResolvedValue();
  vi.mocked(countBlocks)
    .mockReset()
    .mockImplementation(async () => vi.mocked(putBlock).mock.calls.length);
});

test('every sample goes to the disk, in order, about a second at a time', async () => {
  let saved = 0;
  const keeper = new RecordingWriter(recording, {
    ...silent,
    saved: (samples) => {
      saved += samples;
    },
  });
  for (const samples of [block(1, 2), block(3, 4), block(5)]) keeper.add(samples);
  expect(await keeper.finish()).toBe(true);
  expect(vi.mocked(putBlock).mock.calls).toEqual([
    ['r', 0, block(1, 2, 3, 4)],
    ['r', 1, block(5)],
  ]);
  expect(saved).toBe(5);
});

test('a recording counts as unfinished until it came to its end', async () => {
  const keeper = new RecordingWriter(recording, silent);
  await keeper.finish();
  expect(vi.mocked(putRecording)).toHaveBeenLastCalledWith(recording);
  await keeper.close();
  expect(vi.mocked(putRecording)).toHaveBeenLastCalledWith({ ...recording, finished: true });
});

test('a full disk is reported once and stops nothing', async () => {
  vi.mocked(putBlock).mockRejectedValue(
    new DOMException('the quota is used up', 'QuotaExceededError'),
  );
  const faults: string[] = [];
  const keeper = new RecordingWriter(recording, {
    ...silent,
    fault: (fault) => faults.push(fault),
  });
  for (let i = 0; i < 3; i += 1) keeper.add(block(1, 2, 3, 4));
  expect(await keeper.finish()).toBe(false);
  expect(faults).toEqual(['full']);
});

test('where sound was lost is noted with the recording, to its end', async () => {
  const keeper = new RecordingWriter(recording, silent);
  keeper.lose(gap);
  keeper.add(block(1, 2, 3, 4));
  await keeper.finish();
  expect(vi.mocked(putRecording)).toHaveBeenLastCalledWith({ ...recording, gaps: [gap] });
  await keeper.close();
  const finished = { ...recording, gaps: [gap], finished: true };
  expect(vi.mocked(putRecording)).toHaveBeenLastCalledWith(finished);
});

test('a recording of which the browser deleted a part does not count as stored', async () => {
  const keeper = new RecordingWriter(recording, silent);
  for (let i = 0; i < 3; i += 1) keeper.add(block(1, 2, 3, 4));
  vi.mocked(countBlocks).mockResolvedValue(2);
  expect(await keeper.finish()).toBe(false);
});
