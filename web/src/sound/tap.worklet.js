/**
 * Runs in the audio thread: hands every sample of the first channel over, untouched, in blocks of a
 * twentieth of a second. A file of its own, unbundled, because an audio worklet loads nothing else.
 */
class Tap extends AudioWorkletProcessor {
  #block = new Float32Array(Math.max(128, Math.round(sampleRate / 20 / 128) * 128));
  #filled = 0;

  process([input]) {
    const channel = input[0];
    // Without a source there is no channel, and then there is nothing to keep.
    if (!channel) return true;
    this.#block.set(channel, this.#filled);
    this.#filled += channel.length;
    if (this.#filled + 128 > this.#block.length) this.#handOver();
    return true;
  }

  #handOver() {
    const block = this.#block.slice(0, this.#filled);
    this.port.postMessage(block, [block.buffer]);
    this.#filled = 0;
  }
}

registerProcessor('tap', Tap);
