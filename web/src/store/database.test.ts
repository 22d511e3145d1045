import 'fake-indexeddb/auto';
import { forceCloseDatabase } from 'fake-indexeddb';
import { afterEach, expect, test, vi } from 'vitest';
import { addDrops, allDrops, alterDrop, deleteDrop, type KeptDrop, putDrop } from './drops.ts';
import { addRecording, countBlocks, putBlock, samplesOf } from './recordings.ts';

const sound = (...samples: number[]) => Float32Array.from(samples);
const transactions = vi.spyOn(IDBDatabase.prototype, 'transaction');

/** The connection that was used last. */
const connection = () => transactions.mock.contexts.at(-1) as IDBDatabase;

afterEach(() => transactions.mockClear());

test('a database that the browser closed is opened again', async () => {
  await putBlock('closed', 0, sound(1));
  forceCloseDatabase(connection() as never);
  await putBlock('closed', 1, sound(2));
  expect(await samplesOf('closed')).toEqual([sound(1), sound(2)]);
});

test('a connection that was closed without a word is opened again', async () => {
  await putBlock('silent', 0, sound(1));
  connection().close();
  await putBlock('silent', 1, sound(2));
  expect(await countBlocks('silent')).toBe(2);
});

test('a write that the browser aborted is made once more', async () => {
  await putBlock('aborted', 0, sound(1));
  const put = vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementationOnce(function (
    this: IDBObjectStore,
    ...words
  ) {
    const request = this.add(...words);
    this.transaction.abort();
    return request;
  });
  await putBlock('aborted', 1, sound(2));
  put.mockRestore();
  expect(await countBlocks('aborted')).toBe(2);
});

test('a write is made once more as often as a clearing of the storage closes the database', async () => {
  const closing = () => {
    throw new DOMException('Force close delete origin', 'UnknownError');
  };
  await putBlock('closing', 0, sound(1));
  for (let number = 0; number < 3; number += 1) transactions.mockImplementationOnce(closing);
  await putBlock('closing', 1, sound(2));
  expect(await countBlocks('closing')).toBe(2);
});

test('a write of which a closed database tells nothing is made once more', async () => {
  await putBlock('untold', 0, sound(1));
  transactions.mockImplementationOnce(
    () => ({ objectStore: () => ({ put: () => ({}) }) }) as unknown as IDBTransaction,
  );
  const written = putBlock('untold', 1, sound(2));
  await vi.waitUntil(() => transactions.mock.calls.length > 1);
  forceCloseDatabase(connection() as never);
  await written;
  expect(await countBlocks('untold')).toBe(2);
});

test('the storage can be cleared while the page is open, and is used again', async () => {
  await putBlock('cleared', 0, sound(1));
  await new Promise((resolve, reject) => {
    const request = indexedDB.deleteDatabase('bouncelab');
    request.onsuccess = resolve;
    request.onblocked = reject;
  });
  await putBlock('cleared', 1, sound(2));
  expect(await countBlocks('cleared')).toBe(1);
});

test('what is written is on the disk before it counts as written', async () => {
  await putBlock('strict', 0, sound(1));
  expect(transactions).toHaveBeenLastCalledWith(['blocks'], 'readwrite', { durability: 'strict' });
});

const drop = (id: string, name: string) =>
  ({ id, name, keptAt: 0, marks: { probability: 1, impacts: [] } }) as unknown as KeptDrop;

test('two changes of a drop at once are both made, and a deleted drop stays deleted', async () => {
  await putDrop(drop('changed', 'before'));
  await Promise.all([
    alterDrop('changed', { name: 'after' }),
    alterDrop('changed', { surface: 'oak' }),
  ]);
  expect(await allDrops()).toMatchObject([{ name: 'after', surface: 'oak' }]);
  await deleteDrop('changed');
  await alterDrop('changed', { name: 'again' });
  expect(await allDrops()).toEqual([]);
});

test('what is added never takes the place of what is there', async () => {
  const recording = { id: 'a', name: 'mine', rateHz: 4, startedAt: 0, finished: true };
  await addRecording(recording, sound(1));
  await addRecording({ ...recording, name: 'theirs' }, sound(2));
  expect(await samplesOf('a')).toEqual([sound(1)]);

  await putDrop(drop('1', 'mine'));
  await addDrops([drop('1', 'theirs'), drop('2', 'new')]);
  expect((await allDrops()).map(({ name }) => name)).toEqual(['mine', 'new']);
});
