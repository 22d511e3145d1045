/**
 * The microphone as raw samples. The browser's own processing is switched off: echo cancellation,
 * noise suppression and gain control are made for voices and eat impacts.
 */

import tapUrl from './tap.worklet.js?url';

/** Why there is no sound; the page has a message for each. */
export type MicrophoneFault =
  | 'refused'
  | 'missing'
  | 'busy'
  | 'insecure'
  | 'unsupported'
  | 'ended'
  | 'unknown';

export class MicrophoneError extends Error {
  constructor(
    readonly fault: MicrophoneFault,
    cause?: unknown,
  ) {
    super(fault, { cause });
  }
}

/** The longest time that a browser may take to start, in milliseconds. */
const PATIENCE_MS = 5000;

/** What browsers do to voices, and what eats impacts. */
const PROCESSING = ['echoCancellation', 'noiseSuppression', 'autoGainControl'] as const;
export type Processing = (typeof PROCESSING)[number];

/** An open microphone. */
export interface Microphone {
  /** Samples a second, as the device really gives them. */
  readonly rateHz: number;
  /** What the device does to the sound although it was asked not to. */
  readonly processing: readonly Processing[];
  /** Stops the device; the indicator of the browser goes out. */
  close(): Promise<void>;
}

export interface MicrophoneEvents {
  block(samples: Float32Array<ArrayBuffer>): void;
  /** The number of frames missing between the last block and the next. */
  missing(frames: number): void;
  /** The device was removed, or the browser stopped the sound, such as for a call. */
  lost(): void;
  /** The device is there but gives silence, until it is unmuted. */
  muted(isMuted: boolean): void;
}

export async function openMicrophone(events: MicrophoneEvents): Promise<Microphone> {
  if (!globalThis.isSecureContext) throw new MicrophoneError('insecure');
  const devices = navigator.mediaDevices as MediaDevices | undefined;
  if (!devices || typeof AudioWorkletNode === 'undefined') {
    throw new MicrophoneError('unsupported');
  }
  const stream = await rawStream(devices);
  try {
    return await tap(stream, events);
  } catch (error) {
    stopAll(stream);
    throw new MicrophoneError('unknown', error);
  }
}

async function rawStream(devices: MediaDevices): Promise<MediaStream> {
  try {
    return await devices.getUserMedia({
      audio: {
        ...Object.fromEntries(PROCESSING.map((name) => [name, false])),
        channelCount: 1,
      },
    });
  } catch (error) {
    throw new MicrophoneError(faultOf(error), error);
  }
}

function faultOf(error: unknown): MicrophoneFault {
  switch (error instanceof DOMException ? error.name : '') {
    case 'NotAllowedError':
    case 'SecurityError':
      return 'refused';
    case 'NotFoundError':
    case 'OverconstrainedError':
      return 'missing';
    case 'NotReadableError':
    case 'AbortError':
      return 'busy';
    default:
      return 'unknown';
  }
}

async function tap(stream: MediaStream, events: MicrophoneEvents): Promise<Microphone> {
  const context = contextFor(stream);
  try {
    return await listenIn(context, stream, events);
  } catch (error) {
    await context.close();
    throw error;
  }
}

async function listenIn(
  context: AudioContext,
  stream: MediaStream,
  events: MicrophoneEvents,
): Promise<Microphone> {
  await context.audioWorklet.addModule(tapUrl);
  const source = context.createMediaStreamSource(stream);
  const node = new AudioWorkletNode(context, 'tap', { numberOfOutputs: 1 });
  node.port.onmessage = ({ data }: MessageEvent<Float32Array<ArrayBuffer> | number>) => {
    if (typeof data === 'number') events.missing(data);
    else events.block(data);
  };
  for (const track of stream.getAudioTracks()) {
    track.onended = () => events.lost();
    track.onmute = () => events.muted(true);
    track.onunmute = () => events.muted(false);
  }
  // A node that leads nowhere is not run by every browser; its output is silence.
  source.connect(node).connect(context.destination);
  await started(context);
  // Sound that is missing in the middle would make a flight too short: what comes after is not used.
  context.onstatechange = () => {
    if (context.state !== 'running') events.lost();
  };
  const settings = stream.getAudioTracks()[0]?.getSettings() ?? {};
  return {
    rateHz: context.sampleRate,
    processing: PROCESSING.filter((name) => settings[name] === true),
    close: async () => {
      stopAll(stream);
      node.port.onmessage = null;
      context.onstatechange = null;
      await context.close();
    },
  };
}

/** Where nothing can be played, Firefox neither starts nor gives a reason. */
async function started(context: AudioContext): Promise<void> {
  let clock: ReturnType<typeof setTimeout> | undefined;
  const tooLong = new Promise<never>((_, reject) => {
    clock = setTimeout(() => reject(new Error('the sound does not start')), PATIENCE_MS);
  });
  await Promise.race([context.resume(), tooLong]).finally(() => clearTimeout(clock));
}

/** At the device's own rate where it is known: resampling would move what the impacts look like. */
function contextFor(stream: MediaStream): AudioContext {
  const rate = stream.getAudioTracks()[0]?.getSettings().sampleRate;
  try {
    return new AudioContext(rate === undefined ? {} : { sampleRate: rate });
  } catch {
    return new AudioContext();
  }
}

function stopAll(stream: MediaStream): void {
  for (const track of stream.getTracks()) {
    track.onended = null;
    track.onmute = null;
    track.onunmute = null;
    track.stop();
  }
}
