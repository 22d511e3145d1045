import { useEffect, useRef, useState } from 'preact/hooks';
import { codesIn } from '../../address/drop.ts';
import { engine } from '../../state/engine.ts';
import { text } from '../../text/language.ts';

/** Wide enough for the modules of a drop's code, and quick to look through, in pixels. */
const WIDTH = 720;

/** Reads the codes of drops with the camera, one after another. */
export function Scanner({ onDrop }: { readonly onDrop: (text: string) => Promise<void> }) {
  const [stream, setStream] = useState<MediaStream | null>(null);
  const [isRefused, setRefused] = useState(false);
  const video = useRef<HTMLVideoElement>(null);
  useEffect(() => {
    const shown = video.current;
    if (!stream || !shown) return undefined;
    shown.srcObject = stream;
    const over = new AbortController();
    void shown
      .play()
      .then(() => watch(shown, over.signal, onDrop))
      .catch(() => undefined);
    return () => {
      over.abort();
      for (const track of stream.getTracks()) track.stop();
    };
  }, [stream]);
  if (!navigator.mediaDevices) return null;
  const start = async (): Promise<void> => {
    setRefused(false);
    const wanted = { video: { facingMode: 'environment', width: { ideal: 1280 } } };
    const given = await navigator.mediaDevices.getUserMedia(wanted).catch(() => null);
    setRefused(given === null);
    setStream(given);
  };
  return (
    <div class="stack">
      <button
        type="button"
        class="button"
        onClick={() => (stream ? setStream(null) : void start())}
      >
        {stream ? text('page-scan-stop') : text('page-scan')}
      </button>
      {stream && <video ref={video} class="camera" muted playsInline />}
      {isRefused && (
        <p class="notice" role="alert">
          {text('page-scan-refused')}
        </p>
      )}
    </div>
  );
}

/** Looks at one picture after another until it is over; each code counts once in a row. */
async function watch(
  video: HTMLVideoElement,
  over: AbortSignal,
  onDrop: (text: string) => Promise<void>,
): Promise<void> {
  let last = '';
  while (!over.aborted) {
    const picture = greyOf(video);
    const read = picture && (await engine().readQrCode(picture.grey, picture.width));
    const [code = ''] = codesIn(read ?? '');
    if (read && code !== '' && code !== last && !over.aborted) {
      last = code;
      await onDrop(read);
    }
    await new Promise(requestAnimationFrame);
  }
}

/** The grey levels of what the camera sees, row by row. */
function greyOf(video: HTMLVideoElement): { grey: Uint8Array; width: number } | undefined {
  const scale = Math.min(1, WIDTH / video.videoWidth);
  const [width, height] = [
    Math.round(scale * video.videoWidth),
    Math.round(scale * video.videoHeight),
  ];
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context || !(width > 0) || !(height > 0)) return undefined;
  context.drawImage(video, 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  // Green has most of the brightness, and is the sharpest of a camera.
  return {
    grey: Uint8Array.from({ length: width * height }, (_, at) => data[4 * at + 1] ?? 0),
    width,
  };
}
