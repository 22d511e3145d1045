import { signal } from '@preact/signals';
import { recall, remember } from '../address/memory.ts';

/** A choice that the browser remembers: off, until it is made. */
export class Option {
  readonly #key: string;
  readonly #isOn;

  constructor(
    name: string,
    /** Whether the browser can do it. */
    readonly offered: boolean,
  ) {
    this.#key = `bouncelab.${name}`;
    this.#isOn = signal(recall(this.#key) === 'on');
  }

  get isOn(): boolean {
    return this.offered && this.#isOn.value;
  }

  choose(isOn: boolean): void {
    remember(this.#key, isOn ? 'on' : null);
    this.#isOn.value = isOn;
  }
}
