/** The engine gives the numbers of the command line: same files, same documents. */
import { readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import * as decoding from '../src/lab/engine/decoders.js';
import * as science from '../src/lab/engine/engine.js';
import type { Analysed, AnalysisRequest, RecordingResult, Settings } from '../src/lab/index.ts';
import { analysed, bouncelab, fixture, folder, synth } from './harness/program.ts';

beforeAll(() => {
  const wasm = (part: string) =>
    readFileSync(join(import.meta.dirname, `../src/lab/engine/${part}_bg.wasm`));
  science.initSync({ module: wasm('engine') });
  decoding.initSync({ module: wasm('decoders') });
});

/** What the engine detects in a file. */
function detected(path: string): RecordingResult {
  const content = readFileSync(path);
  const readPart = (position: number, into: Uint8Array) => content.copy(into, 0, position);
  Object.assign(globalThis, { readPart });
  const opened = new decoding.Opened(content.length, path);
  const list = opened.list();
  if (list !== undefined) return JSON.parse(science.listed(list));
  const decoder = opened.decoder();
  const detector = new science.Detector(decoder.sampleRateHz(), decoder.channels(), null);
  let more = true;
  while (more) {
    more = decoder.decodeOn();
    for (let channel = 0; channel < decoder.channels(); channel += 1) {
      detector.push(channel, decoder.takeSamples(channel));
    }
  }
  detector.lose(decoder.gaps());
  return JSON.parse(detector.finish(decoder.format(), decoder.warnings()));
}

function request(name: string, found: RecordingResult, settings: Settings): AnalysisRequest {
  const { source, strongest_band, diagnostics, no_drop, candidates } = found;
  const drops = found.drops.map(({ impacts, probability }) => ({
    impacts,
    probability,
    edited: false,
  }));
  const inference = true;
  return {
    name,
    source,
    strongest_band,
    diagnostics,
    no_drop,
    candidates,
    drops,
    settings,
    inference,
  };
}

const english = () => new science.Translator('en', []);

function analyse(asked: AnalysisRequest): Analysed {
  return JSON.parse(new science.Analyst().analyse(JSON.stringify(asked), english()));
}

/** How far estimates and the ends of their intervals may be apart, as shares of the standard deviation. */
interface Shares {
  readonly value: number;
  readonly end: number;
}

const STRICT: Shares = { value: 1e-3, end: 1e-3 };
/**
 * Where the ball is open, the last bits of the weights of its kinds decide which draws of which kind are taken: of some
 * thousands a hundred others move a mean by 0.005 standard deviations, and the end of an interval by ten times that.
 */
const OPEN_BALL: Shares = { value: 0.02, end: 0.2 };

/**
 * Asserts that two documents agree: codes to the letter, times to 10 ns, levels to five digits, what comes
 * from draws to three, other numbers to seven, estimates and standard deviations to a share of the standard
 * deviation. Of correlations, residuals and shares of a variance it is their range that counts.
 */
function expectSame(
  found: unknown,
  expected: unknown,
  path = '$',
  shares = STRICT,
  sd?: number,
): void {
  if (typeof expected === 'number') {
    expect(found, path).toBeTypeOf('number');
    const isDrawn = /\.(posterior|diagnostics)\.|_sd_[a-z]+$/.test(path);
    const share = isDrawn ? shares.value : path.endsWith('_db') ? 1e-5 : 1e-7;
    const isInRange = /\.correlations\.|residual|\.share$/.test(path);
    const size = isInRange ? 1 : Math.abs(expected);
    const ofSd = path.includes('.interval') ? shares.end : shares.value;
    const allowed = sd === undefined ? share * size : ofSd * sd;
    expect(
      Math.abs((found as number) - expected),
      `${path}: ${found}, ${expected}`,
    ).toBeLessThanOrEqual(allowed + 1e-8);
  } else if (expected !== null && typeof expected === 'object') {
    expect(Object.keys(found as object), path).toEqual(Object.keys(expected));
    const own = (expected as { sd?: number }).sd;
    for (const [key, value] of Object.entries(expected)) {
      // Each front end adds its own advice.
      if (key === 'message') continue;
      const part = (found as Record<string, unknown>)[key];
      const isOf = /^(value|sd|interval\d+)$/.test(key);
      expectSame(part, value, `${path}.${key}`, shares, isOf ? own : sd);
    }
  } else {
    expect(found, path).toEqual(expected);
  }
}

/**
 * Asserts that the engine detects what the command line does, and that it makes the same document of it: of
 * the very same impacts, because the last bits of a time decide which draws are taken.
 */
function expectSameDocument(path: string, settings: Settings, ...words: string[]): void {
  const found = detected(path);
  const expected = analysed(path, ...words) as RecordingResult;
  const impactsOf = ({ drops }: RecordingResult) => drops.map((drop) => drop.impacts);
  expectSame(impactsOf(found), impactsOf(expected), `${basename(path)}.drops`);
  const asked = request(path, { ...found, drops: expected.drops }, settings);
  const shares = settings.ball ? STRICT : OPEN_BALL;
  expectSame(analyse(asked).document, expected, basename(path), shares);
}

describe('the same document as the command line', () => {
  const place = folder();

  test('of a recording, with everything assumed', () => {
    const { path } = synth(join(place, 'drop.wav'), '--seed', '3');
    expectSameDocument(path, {});
  });

  test('of a recording with two drops in noise, with a stated ball', () => {
    const { path } = synth(
      join(place, 'noisy.wav'),
      ...['--height', '60cm', '--restitution', '0.9', '--snr', '25', '--clicks', '1'],
      ...['--ball', 'tennis', '--voice', 'tennis', '--sample-rate', '48000', '--seed', '4'],
    );
    const settings: Settings = {
      ball: { kind: 'tennis' },
      air: {
        drag: 'constant:0.45',
        temperature_k: 298.15,
        pressure_pa: 95_000,
        relative_humidity: 0.3,
      },
      gravity: { latitude_deg: 47.5, altitude_m: 400 },
      drop: { height_m: 0.6, height_sd_m: 0.003 },
      inference: { restitution_laws: ['constant', 'power'] },
      analysis: { flights: [1, 8] },
    };
    const words = [
      ...['--ball', 'tennis', '--temperature', '25C', '--pressure', '950hPa', '--humidity', '30%'],
      ...['--latitude', '47.5', '--altitude', '400m', '--height', '60cm', '--height-sd', '3mm'],
      ...['--drag', 'constant:0.45', '--law', 'constant,power', '--flights', '1..8'],
    ];
    expectSameDocument(path, settings, ...words);
  });

  test('of a list of times', () => {
    const { path } = synth(join(place, 'detected.wav'), '--snr', '20', '--seed', '7');
    const { impacts = [] } = detected(path).drops[0] ?? {};
    const times = join(place, 'times.txt');
    writeFileSync(times, impacts.map((impact) => impact.time_s.toFixed(4)).join('\n'));
    const settings: Settings = {
      ball: { mass_kg: 0.0025, diameter_m: 0.038 },
      inference: { infer: ['drag'] },
    };
    const words = ['--mass', '2.5g', '--diameter', '38mm', '--infer', 'drag'];
    expectSameDocument(times, settings, ...words);
  });

  test('of an impact that was taken out and added elsewhere by hand', () => {
    const { path } = synth(join(place, 'edited.wav'), '--seed', '5');
    const found = detected(path);
    const { impacts = [], probability = 0 } = found.drops[0] ?? {};
    const gone = impacts[4]?.time_s ?? 0;
    // Moved a little, as by hand: draws for a drop that no impact fits depend on the last bits of its times.
    const added = gone + 1e-4;
    const unknown = { time_sd_s: null, level_db: null, quiet_before_s: null, ln_alike: null };
    const byHand = { number: 0, time_s: added, probability: 1, ...unknown };
    const edited = impacts.toSpliced(4, 1, byHand);
    const drops = [{ impacts: edited, probability, edited: true }];
    const { document } = analyse({ ...request(path, found, {}), drops });
    const words = ['--exclude', `${gone}s`, '--include', `${added}s`];
    expectSame(document, analysed(path, ...words));
  });

  // One program after another: a busy machine takes minutes.
  test('of every format', { timeout: 1_800_000 }, () => {
    const names = ['pcm16.wav', 'pcm24.wav', 'float32.wav', 'pcm16.aiff', 'lossless.flac'];
    names.push('lame-tag.mp3', 'vorbis.ogg', 'opus.ogg', 'opus.webm', 'browser.webm', 'aac.aac');
    names.push('aac.m4a', 'alac.m4a', 'trimmed.m4a', 'opus.mp4', 'video.mov', 'three-channels.wav');
    for (const path of names.map(fixture)) expectSameDocument(path, {});
  });

  test('of a simulation and of the paper', () => {
    const simulated = JSON.parse(
      science.simulate(
        JSON.stringify({
          settings: { ball: { kind: 'basketball' } },
          height_m: 1.8,
          restitution: 'linear:0.85,0.01',
          compare: ['none'],
        }),
        english(),
      ),
    );
    const words = ['--height', '1.8m', '--restitution', 'linear:0.85,0.01'];
    const printed = bouncelab(
      ...['simulate', '--ball', 'basketball', '--compare', 'none', '--format', 'json'],
      ...words,
    );
    expectSame(simulated, JSON.parse(printed));
    const paper = bouncelab('paper', '--no-figures', '--format', 'json');
    expectSame(JSON.parse(decoding.paperDocument('en', [])), JSON.parse(paper));
  });

  test('rows of a table, to the letter of their names', () => {
    const { path } = synth(join(place, 'rows.wav'), '--bounces', '8');
    const asked = JSON.stringify(request(path, detected(path), {}));
    const rows = new science.Analyst().csv(asked, english());
    const printed = bouncelab('analyze', path, '--format', 'csv');
    const table = (text: string) =>
      text
        .trim()
        .split('\n')
        .map((row) => row.split(','));
    expect(table(rows)[0]).toEqual(table(printed)[0]);
    expect(table(rows).length).toBe(table(printed).length);
  });
});
