/** Reads back the WAV files that the page writes: one channel of 32-bit floats, exactly as recorded. */

const FLOAT = 3;

/** @throws RangeError if it is no such file, or not all of one. */
export function floatsOf(wav: ArrayBuffer): Float32Array<ArrayBuffer> {
  const format = chunk(wav, 'fmt ');
  const [kind, channels, bits] = [0, 2, 14].map((at) => format.getUint16(at, true));
  if (kind !== FLOAT || channels !== 1 || bits !== 32) throw new RangeError('another kind of WAV');
  const { byteOffset, byteLength } = chunk(wav, 'data');
  return new Float32Array(wav.slice(byteOffset, byteOffset + byteLength));
}

/** The content of the first chunk of this name. */
function chunk(wav: ArrayBuffer, name: string): DataView {
  const view = new DataView(wav);
  for (let at = 12; ; ) {
    const found = String.fromCharCode(...new Uint8Array(wav, at, 4));
    const size = view.getUint32(at + 4, true);
    if (found === name) return new DataView(wav, at + 8, size);
    at += 8 + size + (size % 2);
  }
}
