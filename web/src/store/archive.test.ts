import {
  BlobReader,
  BlobWriter,
  TextReader,
  ZipWriter,
} from '@zip.js/zip.js/lib/zip-core-custom.js';
import { expect, test } from 'vitest';
import { dropsOfList, filesIn, pack, unpack } from './archive.ts';

/** One channel of 32-bit floats at 48 kHz, with a chunk of no interest before the samples. */
function wav(...samples: number[]): Blob {
  const head = new DataView(new ArrayBuffer(36));
  head.setUint32(4, 16, true);
  head.setUint16(8, 3, true);
  head.setUint16(10, 1, true);
  head.setUint32(12, 48_000, true);
  head.setUint16(22, 32, true);
  head.setUint32(28, 1, true);
  const size = new Uint32Array([4 * samples.length]);
  const format = [head.buffer.slice(4, 24), 'LIST', head.buffer.slice(28, 32), '..'];
  return new Blob(['RIFF....WAVEfmt ', ...format, 'data', size, Float32Array.from(samples)]);
}

const drop = {
  id: 'd',
  name: 'Anna’s “first”',
  keptAt: 1,
  ball: 'tennis',
  restitution: { value: 0.75, sd: null },
  dropHeightM: null,
  restitutions: [{ speedMS: 1, value: 0.75 }],
  settings: { drop: { height_m: 0.5 } },
  marks: { edited: false, probability: 1, impacts: [] },
  recording: 'r',
  student: 'Anna',
  surface: 'wood',
};
const gaps = [{ start_s: 1, duration_s: 0.5, certain: true }];
const recording = { id: 'r', name: 'r', rateHz: 48_000, startedAt: 0, finished: true, gaps };
const packed = (drops = [drop]) =>
  pack({ drops, recordings: [recording] }, async () => wav(0.5, -0.25));

async function contents(file: Blob) {
  const { drops, sounds } = await unpack(file);
  const [sound] = sounds;
  return { drops, recording: sound?.recording, samples: await sound?.samples() };
}
const whole = { drops: [drop], recording, samples: Float32Array.of(0.5, -0.25) };

test('what is packed comes back exactly', async () => {
  expect(await contents(await packed())).toEqual(whole);
});

/** Thousands of files are read. */
const LONG_MS = 120_000;

test('whatever byte is damaged, the file is refused or says the same', {
  timeout: LONG_MS,
}, async () => {
  const bytes = new Uint8Array(await (await packed()).arrayBuffer());
  let refused = 0;
  for (let at = 0; at < bytes.length; at += 1) {
    const damaged = bytes.slice();
    damaged[at] = (bytes[at] as number) ^ 1;
    const found = await contents(new Blob([damaged])).catch(
      (error: { kind: string }) => error.kind,
    );
    if (found === 'damaged' || found === 'huge') refused += 1;
    else expect(found, `byte ${at}`).toEqual(whole);
  }
  // The rest is dates, versions and the like.
  expect(refused).toBeGreaterThan(0.8 * bytes.length);
});

test('a file that is cut off, or no archive at all, is refused', async () => {
  const file = await packed();
  for (const part of [
    file.slice(0, Math.floor(file.size / 2)),
    new Blob(),
    new Blob(['time_s\n0.5\n']),
  ]) {
    await expect(unpack(part)).rejects.toMatchObject({ kind: 'damaged' });
  }
});

const BAD: readonly object[] = [
  { marks: {} },
  { marks: { edited: false, probability: 1, impacts: [{}] } },
  { recording: 'elsewhere' },
  { restitution: { value: 0.75, sd: 'x' } },
  { restitution: { value: 0.75, sd: {} } },
  { dropHeightM: { value: Number.NaN, sd: null } },
  { settings: { ball: { kind: {} } } },
  { settings: { ball: 'tennis' } },
  { settings: { inference: { draws: null } } },
  { surface: ['x'] },
  { restitutions: [{}] },
  { keptAt: 1e300 },
  { student: 5 },
  { name: 'x'.repeat(1_000_000) },
];

test.each(BAD)('a drop that the page could not show is refused by its name: %j', async (change) => {
  const bad = { ...drop, id: 'bad', ...change };
  const { drops, refused } = await unpack(await packed([drop, bad as typeof drop]));
  expect(drops).toEqual([drop]);
  expect(refused).toEqual('name' in change ? ['#2'] : [drop.name]);
  if ('recording' in change) return;
  const list = dropsOfList({ schema: 'bouncelab.kept-drops/2', drops: [bad, drop] });
  expect(list.drops).toEqual([{ ...drop, recording: null }]);
  expect(list.refused).toHaveLength(1);
});

test('a ZIP that bursts is refused', async () => {
  const zeros = new ZipWriter(new BlobWriter());
  const million = new BlobReader(new Blob([new Uint8Array(1e6)]));
  await zeros.add('drops.json', million);
  const bomb = await zeros.close();
  await expect(unpack(bomb)).rejects.toMatchObject({ kind: 'huge' });
  // One that states less than it holds: the length is in two places.
  const bytes = new Uint8Array(await bomb.arrayBuffer());
  const stated = [0x40, 0x42, 0x0f, 0];
  for (const at of bytes.keys()) {
    if (stated.every((byte, place) => bytes[at + place] === byte)) bytes[at + 2] = 0;
  }
  const [file] = await filesIn(new Blob([bytes]));
  expect(file?.size).toBe(0x4240);
  await expect(file?.blob()).rejects.toThrow();
});

test('a ZIP of too many files is refused', async () => {
  const writer = new ZipWriter(new BlobWriter());
  await writer.add('drops.json', new TextReader(''));
  const bytes = await (await writer.close()).arrayBuffer();
  // The end of a ZIP has 22 bytes: how many lines its list of files has, twice, the bytes of the list, and where it begins.
  const end = bytes.byteLength - 22;
  const about = new DataView(bytes, end);
  const start = about.getUint32(16, true);
  const line = bytes.slice(start, end);
  const lines = 10_001;
  about.setUint16(8, lines, true);
  about.setUint16(10, lines, true);
  about.setUint32(12, lines * line.byteLength, true);
  const list = new Array<ArrayBuffer>(lines).fill(line);
  const many = new Blob([bytes.slice(0, start), ...list, bytes.slice(end)]);
  await expect(filesIn(many)).rejects.toMatchObject({ kind: 'huge' });
});

test('a file of a later version says so', async () => {
  const zip = new ZipWriter(new BlobWriter());
  const list = { schema: 'bouncelab.archive/2', everything: 'else' };
  await zip.add('drops.json', new TextReader(JSON.stringify(list)), { level: 0 });
  await expect(unpack(await zip.close())).rejects.toMatchObject({ kind: 'newer' });
});
