import { BlobWriter, TextReader, ZipWriter } from '@zip.js/zip.js/lib/zip-core-custom.js';
import { expect, test } from 'vitest';
import { pack, unpack } from './archive.ts';

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
    if (found === 'damaged') refused += 1;
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

test('a list that the page could not show is refused', async () => {
  for (const change of [{ marks: {} }, { name: 7 }, { recording: 'elsewhere' }]) {
    const file = await packed([{ ...drop, ...change } as typeof drop]);
    await expect(unpack(file)).rejects.toMatchObject({ kind: 'damaged' });
  }
});

test('a file of a later version says so', async () => {
  const zip = new ZipWriter(new BlobWriter());
  const list = { schema: 'bouncelab.archive/2', everything: 'else' };
  await zip.add('drops.json', new TextReader(JSON.stringify(list)), { level: 0 });
  await expect(unpack(await zip.close())).rejects.toMatchObject({ kind: 'newer' });
});
