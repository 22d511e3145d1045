import { beforeEach, expect, test, vi } from 'vitest';
import { RecordingWriter } from './recording-writer.ts';
import { putBlock, putRecording } from './recordings.ts';

vi.mock('./recordings.ts', () => ({ putBlock: vi.fn(), putRecording: vi.fn() }));

const recording = { id: 'r', name: 'drop', rateHz: 4, startedAt: 0, finished: false };
const block = (...samples: number[]) => Float32Array.from(samples);

beforeEach(() => {
  vi.mocked(putBlock).mockReset().mockResolvedValue();
  vi.mocked(putRecording).mockReset().mockResolvedValue();
});

test('every sample goes to the disk, in order, about a second at a time', async () => {
  const keeper = new RecordingWriter(recording, () => undefined);
  for (const samples of [block(1, 2), block(3, 4), block(5)]) keeper.add(samples);
  expect(await keeper.finish()).toBe(true);
  expect(vi.mocked(putBlock).mock.calls).toEqual([
    ['r', 0, block(1, 2, 3, 4)],
    ['r', 1, block(5)],
  ]);
});

test('a recording counts as unfinished until it came to its end', async () => {
  const keeper = new RecordingWriter(recording, () => undefined);
  await keeper.finish();
  expect(vi.mocked(putRecording)).toHaveBeenLastCalledWith(recording);
  await keeper.close();
  expect(vi.mocked(putRecording)).toHaveBeenLastCalledWith({ ...recording, finished: true });
});

test('a full disk is reported once and stops nothing', async () => {
  vi.mocked(putBlock).mockRejectedValue(new DOMException('no room', 'QuotaExceededError'));
  const faults: string[] = [];
  const keeper = new RecordingWriter(recording, (fault) => faults.push(fault));
  for (let i = 0; i < 3; i += 1) keeper.add(block(1, 2, 3, 4));
  expect(await keeper.finish()).toBe(false);
  expect(faults).toEqual(['full']);
});
