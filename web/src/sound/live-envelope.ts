/** The last seconds of the recording as minimum and maximum of short bins, for drawing while listening. */
export class LiveEnvelope {
  readonly #bins: Float32Array;
  readonly #samplesPerBin: number;
  #bin = 0;
  #inBin = 0;

  constructor(
    rateHz: number,
    readonly seconds: number,
    readonly binsPerSecond: number,
  ) {
    this.#samplesPerBin = rateHz / binsPerSecond;
    this.#bins = new Float32Array(2 * Math.ceil(seconds * binsPerSecond));
  }

  /** Adds samples; returns their largest magnitude. */
  add(samples: Float32Array): number {
    let peak = 0;
    const capacity = this.#bins.length / 2;
    for (const sample of samples) {
      if (this.#inBin >= this.#samplesPerBin) {
        this.#inBin -= this.#samplesPerBin;
        this.#bin += 1;
        const at = 2 * (this.#bin % capacity);
        this.#bins[at] = 0;
        this.#bins[at + 1] = 0;
      }
      this.#inBin += 1;
      const at = 2 * (this.#bin % capacity);
      if (sample < (this.#bins[at] as number)) this.#bins[at] = sample;
      if (sample > (this.#bins[at + 1] as number)) this.#bins[at + 1] = sample;
      const size = Math.abs(sample);
      if (size > peak) peak = size;
    }
    return peak;
  }

  /** Number of the newest bin, from the beginning. */
  get newest(): number {
    return this.#bin;
  }

  /** Minimum and maximum of a bin, by its number from the beginning; zero if it is no longer stored. */
  bin(number: number): readonly [number, number] {
    const capacity = this.#bins.length / 2;
    if (number < 0 || number > this.#bin || number <= this.#bin - capacity) return [0, 0];
    const at = 2 * (number % capacity);
    return [this.#bins[at] as number, this.#bins[at + 1] as number];
  }
}
