/**
 * Runs in the audio thread: hands every sample of the first channel over, untouched, in blocks of a
 * twentieth of a second, and between them how many frames are missing. A file of its own, unbundled,
 * because an audio worklet loads nothing else.
 */
class Tap extends AudioWorkletProcessor {
  #block = new Float32Array(Math.max(128, Math.round(sampleRate / 20 / 128) * 128));
  #filled = 0;
  /** The frame that comes next; unknown before the first. */
  #next = Number.POSITIVE_INFINITY;

  process([[channel]]) {
    // Without a source there is no channel: its frames are missing when sound comes again.
    if (channel?.length > 0) this.#take(channel);
    return true;
  }

  #take(channel) {
    if (currentFrame > this.#next) {
      this.#handOver();
      this.port.postMessage(currentFrame - this.#next);
    }
    this.#next = currentFrame + channel.length;
    this.#block.set(channel, this.#filled);
    this.#filled += channel.length;
    if (this.#filled + channel.length > this.#block.length) this.#handOver();
  }

  #handOver() {
    const block = this.#block.slice(0, this.#filled);
    this.port.postMessage(block, [block.buffer]);
    this.#filled = 0;
  }
}

registerProcessor('tap', Tap);
