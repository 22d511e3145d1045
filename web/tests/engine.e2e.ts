/** The engine in a real browser: workers, and what happens when things go wrong. Times are printed. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { build } from 'vite';
import { afterAll, afterEach, beforeAll, beforeEach, expect, test } from 'vitest';
import { launch, openPage } from './harness/browser.ts';
import { fixture, folder, synth } from './harness/program.ts';
import { Site } from './harness/site.ts';

let site: Site;
let browser: Browser;
let page: Page;
let troubles: string[];
let recording: { path: string; timesS: number[] };

beforeAll(async () => {
  await build({ configFile: join(import.meta.dirname, 'engine/vite.config.ts') });
  site = await Site.open(join(import.meta.dirname, '.engine'));
  browser = await launch();
  const words = ['--height', '50cm', '--restitution', '0.955', '--tail', '1s', '--lead-in', '1s'];
  recording = synth(join(folder(), 'twelve.wav'), ...words, '--bounces', '45');
});

afterAll(async () => {
  await browser?.close();
  await site?.close();
});

beforeEach(async () => {
  ({ page, troubles } = await openPage(browser, site.url));
});

afterEach(async () => {
  await page.context().close();
  expect(troubles).toEqual([]);
});

/** The content of a file for the page. */
function content(path: string): string {
  return readFileSync(path).toString('base64');
}

test('drops in a recording are detected and analysed, impact for impact', async () => {
  const found = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const file = () => new File([bytes], 'twelve.wav');
    const lab = new engine.Lab();
    await lab.catalogue();
    const times = { open: [] as number[], quick: [] as number[], full: [] as number[] };
    let durationS = 0;
    let impacts: number[] = [];
    for (let run = 0; run < 5; run += 1) {
      const started = performance.now();
      const recording = await lab.open(file());
      const opened = performance.now();
      let quick = opened;
      // A height of its own for each run, so that nothing is remembered.
      const settings = { drop: { height_m: 0.5 + run / 1e4 } };
      await lab.analyse(lab.request(recording, settings), () => {
        quick = performance.now();
      });
      times.open.push(opened - started);
      times.quick.push(quick - opened);
      times.full.push(performance.now() - quick);
      durationS = recording.durationS;
      impacts = recording.result.drops[0]?.impacts.map((impact) => impact.time_s) ?? [];
    }
    return { times, durationS, impacts };
  }, content(recording.path));
  const least = (values: number[]) => Math.min(...values);
  const { open, quick, full } = found.times;
  process.stdout.write(
    `${found.durationS.toFixed(1)} s of sound: detected in ${least(open).toFixed(0)} ms (with a new ` +
      `worker), analysed in ${least(quick).toFixed(0)} ms, with the inference in ` +
      `${least(full).toFixed(0)} ms more\n`,
  );
  expect(found.durationS).toBeGreaterThan(10);
  expect(found.impacts.length).toBe(recording.timesS.length);
  for (const [index, timeS] of recording.timesS.entries()) {
    expect(Math.abs((found.impacts[index] ?? 0) - timeS)).toBeLessThan(1e-3);
  }
});

test('what is detected live is what is detected in the recording', async () => {
  const found = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const lab = new engine.Lab();
    const recording = await lab.open(new File([bytes], 'twelve.wav'));
    const samples = await recording.samples(0, recording.durationS);
    const rate = recording.sound?.sampleRateHz ?? 1;
    const listening = await lab.listen(rate);
    const counts: number[] = [];
    let rested = false;
    for (let at = 0; at < samples.length; at += 4096) {
      const soFar = await listening.push(samples.slice(at, at + 4096));
      counts.push(soFar.drop?.impacts.length ?? 0);
      rested ||= soFar.at_rest;
    }
    const live = await listening.finish('live.wav');
    const wav = await (await live.wav())?.arrayBuffer();
    const again = await lab.open(new File([wav ?? ''], 'live.wav'));
    return {
      counts,
      rested,
      live: live.result.drops,
      whole: recording.result.drops,
      again: again.result.drops,
      same: (await again.samples(0, again.durationS)).every((sample, i) => sample === samples[i]),
    };
  }, content(recording.path));
  expect(found.live).toEqual(found.whole);
  expect(found.again).toEqual(found.whole);
  expect(found.same).toBe(true);
  expect(found.rested).toBe(true);
  const seen = found.counts.filter((count) => count > 0);
  expect(seen.length).toBeGreaterThan(found.counts.length / 2);
  expect(seen[0]).toBeLessThan(12);
});

test('the latest analysis wins, and a file can be called off', async () => {
  const found = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const lab = new engine.Lab();
    const recording = await lab.open(new File([bytes], 'twelve.wav'));
    const kinds = [0.4, 0.45, 0.5].map((height_m) =>
      lab
        .analyse(lab.request(recording, { drop: { height_m } }), () => undefined)
        .then(
          (analysed) => (analysed.document.drops[0]?.posterior ? 'full' : 'quick'),
          (error) => (engine.LabError.isMoot(error) ? 'superseded' : String(error)),
        ),
    );
    const abort = new AbortController();
    const file = new File([bytes], 'twelve.wav');
    const opening = lab.open(file, { signal: abort.signal }).catch((error) => error.kind);
    abort.abort();
    return { kinds: await Promise.all(kinds), cancelled: await opening };
  }, content(recording.path));
  expect(found.kinds).toEqual(['superseded', 'superseded', 'full']);
  expect(found.cancelled).toBe('cancelled');
});

test('every figure, the report, the table and the paper can be drawn', async () => {
  const found = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const lab = new engine.Lab();
    const recording = await lab.open(new File([bytes], 'twelve.wav'));
    const request = lab.request(recording, {});
    const analysed = await lab.analyse(request);
    const drawn = [await lab.waveform(recording, request)];
    const captions: string[] = [];
    for (const { name } of analysed.figures[0] ?? []) {
      const asked = { request, drop: 0, name, simulation: null };
      drawn.push(await lab.figure(asked));
      captions.push((await lab.chart(asked)).caption);
    }
    const isDrawn = ({ svg }: { svg: string }) =>
      new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement.localName === 'svg';
    return {
      names: drawn.map(({ name }) => name),
      bad: drawn.filter((figure) => !isDrawn(figure)).map(({ name }) => name),
      unexplained: captions.filter((caption) => caption.length < 10),
      facts: (await lab.paper()).facts.length,
      rows: (await lab.csv(request)).split('\n').length,
      report: await lab.report(recording, request, new Date('2026-01-02T12:00:00Z')),
    };
  }, content(recording.path));
  expect(found.bad).toEqual([]);
  expect(found.names).toContain('waveform');
  expect(found.names).toContain('posterior');
  expect(found.unexplained).toEqual([]);
  expect(found.facts).toBeGreaterThan(30);
  expect(found.rows).toBeGreaterThan(40);
  expect(found.report).toContain('<!DOCTYPE html>');
  expect(found.report).toContain('twelve.wav');
});

test('samples of a long file are read from any place, forwards and back', async () => {
  const found = await page.evaluate(async () => {
    const [rate, seconds] = [48_000, 240];
    const file = new Uint8Array(44 + 2 * rate * seconds);
    const view = new DataView(file.buffer);
    const write = (at: number, letters: string) => file.set(new TextEncoder().encode(letters), at);
    write(0, 'RIFF');
    view.setUint32(4, file.length - 8, true);
    write(8, 'WAVEfmt ');
    view.setUint32(16, 16, true);
    view.setUint16(20, 1, true);
    view.setUint16(22, 1, true);
    view.setUint32(24, rate, true);
    view.setUint32(28, 2 * rate, true);
    view.setUint16(32, 2, true);
    view.setUint16(34, 16, true);
    write(36, 'data');
    view.setUint32(40, file.length - 44, true);
    const wave = (n: number): number => (Math.imul(n, 2_654_435_761) >> 24) * 8;
    for (let n = 0; n < rate * seconds; n += 1) view.setInt16(44 + 2 * n, wave(n), true);
    const lab = new engine.Lab();
    const recording = await lab.open(new File([file], 'long.wav'));
    const differences = [];
    for (const fromS of [200, 1, 239.5, 0]) {
      const samples = await recording.samples(fromS, fromS + 1);
      const from = fromS * rate;
      const isWrong = (sample: number, n: number) => sample !== wave(from + n) / 32_768;
      differences.push({ length: samples.length, wrong: samples.filter(isWrong).length });
    }
    lab.close();
    return differences;
  });
  const second = { length: 48_000, wrong: 0 };
  expect(found).toEqual([second, second, { length: 24_000, wrong: 0 }, second]);
});

test('a marker snaps to the onset next to it; sound can be seen and simulated', async () => {
  const found = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const lab = new engine.Lab();
    const recording = await lab.open(new File([bytes], 'twelve.wav'));
    const impact = recording.result.drops[0]?.impacts[7];
    const timeS = impact?.time_s ?? 0;
    const { recording: demo, demo: about } = await lab.demo();
    const request = {
      settings: { gravity: { gravity_m_s2: 1.62 }, air: { density_kg_m3: 0 } },
      height_m: 1,
      restitution: '0.9',
      bounces: 5,
    };
    const scene = {
      voice: 'steel-ball',
      snr_db: 60,
      sample_rate_hz: 48_000,
      seed: 1,
      lead_in_s: 0.1,
      tail_s: 0.5,
    };
    const sound = await lab.synthesise(request, scene);
    const spectrogram = await recording.spectrogram(timeS - 0.1, timeS + 0.1, 100, 64);
    return {
      timeS,
      onset: await recording.onsetNear(timeS + 0.006),
      nothing: await recording.onsetNear(timeS + 0.15, 0.005),
      spectrogram: spectrogram?.cells.length,
      levels: recording.sound?.levels.map((level) => level.samplesPerBin),
      demo: demo.result.drops[0]?.impacts.length,
      about,
      flight: (await lab.simulate(request)).simulations[0]?.bounces[0]?.flight_time_s,
      seconds: sound.samples.length / sound.sampleRateHz,
    };
  }, content(recording.path));
  expect(Math.abs((found.onset?.time_s ?? 0) - found.timeS)).toBeLessThan(3e-4);
  expect(found.nothing).toBeNull();
  expect(found.spectrogram).toBe(6400);
  expect(found.levels?.[0]).toBe(64);
  expect(found.demo).toBeGreaterThan(50);
  expect(found.about.drop_height_m).toBe(0.305);
  // 2 e sqrt(2 h/g), in vacuum.
  expect(found.flight).toBeCloseTo(2 * 0.9 * Math.sqrt(2 / 1.62), 9);
  expect(found.seconds).toBeGreaterThan(5);
});

test('what is no recording is refused in words, and the next one is opened', async () => {
  const truncated = readFileSync(fixture('aac.m4a')).subarray(0, 700).toString('base64');
  const found = await page.evaluate(
    async ([base64, broken]) => {
      const bytes = (text: string | undefined) =>
        Uint8Array.from(atob(text ?? ''), (letter) => letter.charCodeAt(0));
      const lab = new engine.Lab();
      const refusal = (parts: BlobPart[], name: string) =>
        lab.open(new File(parts, name)).then(
          () => ({ kind: 'opened', message: '' }),
          (error) => ({ kind: error.kind as string, message: error.message as string }),
        );
      const noise = new Uint8Array(5000).map((_, index) => (index * 7919) % 251);
      return {
        empty: await refusal([], 'empty.wav'),
        text: await refusal(['Dear diary, today I dropped a ball.'], 'diary.doc'),
        noise: await refusal([noise], 'noise.mp3'),
        broken: await refusal([bytes(broken)], 'broken.m4a'),
        times: await refusal(['1.0\n1.0\n'], 'times.txt'),
        setting: await lab
          .open(new File([bytes(base64)], 'twelve.wav'))
          .then((recording) =>
            lab.analyse(lab.request(recording, { ball: { kind: 'table-tenis' } })),
          )
          .catch((error) => ({ kind: error.kind as string, message: error.message as string })),
      };
    },
    [content(recording.path), truncated],
  );
  expect(found.empty.kind).toBe('empty');
  expect(found.text.kind).toBe('unsupported');
  expect(found.text.message).toContain('diary.doc');
  expect(['unsupported', 'damaged']).toContain(found.noise.kind);
  expect(found.broken.kind).not.toBe('opened');
  expect(found.times.kind).toBe('times');
  expect(found.setting).toMatchObject({ kind: 'setting' });
});
