/** Drops with a known truth, and the samples of what was saved. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Preparation } from '../harness/browser.ts';
import { folder, synth } from '../harness/program.ts';

export const TRUTH = { restitution: 0.93, heightM: 0.305 } as const;

/** A drop as WAV, made by `bouncelab synth`, with further options of it. */
export function drop(
  name: string,
  restitution: number = TRUTH.restitution,
  ...more: string[]
): string {
  const truth = ['--height', `${TRUTH.heightM}m`, '--restitution', String(restitution)];
  const scene = ['--lead-in', '1s', '--tail', '3s', '--sample-rate', '48000', '--bits', '16'];
  return synth(join(folder(), `${name}.wav`), ...truth, ...scene, ...more).path;
}

/**
 * Makes the pages of a context hear a recording, then silence, whatever the microphone of the browser
 * gives: on a busy machine a browser loses samples between the two, as a computer that is too slow does.
 * It is unplugged after `afterS` seconds of the sound, for `forS` seconds or as much longer as a page takes
 * that is too slow.
 */
export const hearing =
  (file: string, unplugged?: { afterS: number; forS: number }): Preparation =>
  async (context) => {
    const { rateHz, samples } = samplesOf(file);
    const bytes = Buffer.from(samples.buffer).toString('base64');
    await context.addInitScript(
      ({ rateHz, bytes, unplugged }) => {
        const raw = Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0));
        const samples = new Float32Array(raw.buffer);
        AudioContext.prototype.createMediaStreamSource = function () {
          const silence = 600 * rateHz;
          const buffer = this.createBuffer(1, samples.length + silence, rateHz);
          buffer.copyToChannel(samples, 0);
          const source = this.createBufferSource();
          source.buffer = buffer;
          source.start();
          // What leads nowhere stands still: it plays on while it is unplugged.
          source.connect(this.destination);
          const connect = source.connect.bind(source) as (to: AudioNode) => AudioNode;
          const until = (timeS: number) =>
            new Promise<void>((resolve) => {
              const look = () =>
                this.currentTime < timeS ? requestAnimationFrame(look) : resolve();
              look();
            });
          source.connect = ((to: AudioNode) => {
            const unplug = async ({ afterS, forS }: { afterS: number; forS: number }) => {
              await until(afterS);
              source.disconnect(to);
              await until(this.currentTime + forS);
              connect(to);
            };
            if (unplugged) void unplug(unplugged);
            return connect(to);
          }) as AudioNode['connect'];
          return source as AudioNode as MediaStreamAudioSourceNode;
        };
      },
      { rateHz, bytes, unplugged },
    );
  };

/** Samples of a WAV file of one channel, 16-bit or 32-bit float. */
export function samplesOf(file: string): { rateHz: number; samples: Float32Array } {
  const bytes = readFileSync(file);
  let rateHz = 0;
  let isFloat = false;
  for (let at = 12; at + 8 <= bytes.length; ) {
    const name = bytes.toString('latin1', at, at + 4);
    const size = bytes.readUInt32LE(at + 4);
    const body = bytes.subarray(at + 8, at + 8 + size);
    if (name === 'fmt ') {
      rateHz = body.readUInt32LE(4);
      isFloat = body.readUInt16LE(14) === 32;
    }
    if (name === 'data') {
      const count = Math.floor(body.length / (isFloat ? 4 : 2));
      const read = (i: number): number =>
        isFloat ? body.readFloatLE(4 * i) : body.readInt16LE(2 * i) / 32768;
      return { rateHz, samples: Float32Array.from({ length: count }, (_, i) => read(i)) };
    }
    at += 8 + size + (size % 2);
  }
  throw new Error(`${file} holds no samples`);
}

/**
 * Samples as a file of the Core Audio Format of Apple (its specification, "CAF file header" and the chunks "desc" and
 * "data"): 16-bit integers of one channel.
 */
export function cafOf({ rateHz, samples }: Sound): Buffer {
  const head = Buffer.alloc(68);
  head.write('caff');
  head.writeUInt16BE(1, 4);
  head.write('desc', 8);
  head.writeBigInt64BE(32n, 12);
  head.writeDoubleBE(rateHz, 20);
  head.write('lpcm', 28);
  // Flags: big-endian integers. Then bytes and frames of a packet, channels and bits.
  for (const [place, value] of [0, 2, 1, 1, 16].entries())
    head.writeUInt32BE(value, 32 + 4 * place);
  head.write('data', 52);
  head.writeBigInt64BE(BigInt(4 + 2 * samples.length), 56);
  const data = Buffer.alloc(2 * samples.length);
  for (const [at, sample] of samples.entries())
    data.writeInt16BE(Math.round(32767 * sample), 2 * at);
  return Buffer.concat([head, data]);
}

/** Sound as samples. */
export type Sound = ReturnType<typeof samplesOf>;

const BIN_S = 0.001;

/** The loudness of each millisecond. */
function loudness({ rateHz, samples }: Sound): number[] {
  const bins = Math.floor(samples.length / rateHz / BIN_S);
  return Array.from({ length: bins }, (_, bin) => {
    const [from, to] = [bin, bin + 1].map((edge) => Math.round(edge * BIN_S * rateHz));
    const part = samples.subarray(from, to);
    return Math.sqrt(part.reduce((sum, x) => sum + x * x, 0) / part.length);
  });
}

/** Where in a sound a part of it begins, in seconds, by its loudness. */
export function lagOf(part: Sound, whole: Sound): number {
  const [some, all] = [loudness(part), loudness(whole)];
  const distances = all.map((_, lag) =>
    some.reduce((sum, level, bin) => sum + (level - (all[bin + lag] ?? 0)) ** 2, 0),
  );
  return distances.indexOf(Math.min(...distances)) * BIN_S;
}
