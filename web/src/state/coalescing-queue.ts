/**
 * Runs one job at a time and, when it is done, only the latest of those that were asked for meanwhile:
 * while a marker is dragged, the picture follows as fast as the engine can, and never lags behind.
 */
export class CoalescingQueue<T> {
  #running = false;
  #waiting: T | undefined;

  constructor(private readonly work: (job: T) => Promise<void>) {}

  ask(job: T): void {
    this.#waiting = job;
    if (!this.#running) void this.#run();
  }

  async #run(): Promise<void> {
    this.#running = true;
    while (this.#waiting !== undefined) {
      const job = this.#waiting;
      this.#waiting = undefined;
      await this.work(job);
    }
    this.#running = false;
  }
}
