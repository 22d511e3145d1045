import { expect, test } from 'vitest';
import { CoalescingQueue } from './coalescing-queue.ts';

test('while one job runs, only the latest of the others waits', async () => {
  const done: number[] = [];
  const gates: (() => void)[] = [];
  const latest = new CoalescingQueue<number>(async (job) => {
    await new Promise<void>((open) => gates.push(open));
    done.push(job);
  });
  for (const job of [1, 2, 3, 4]) latest.ask(job);
  gates[0]?.();
  await new Promise((later) => setTimeout(later));
  gates[1]?.();
  await new Promise((later) => setTimeout(later));
  expect(done).toEqual([1, 4]);
});
