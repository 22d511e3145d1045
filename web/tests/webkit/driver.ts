/** WebKitGTK's MiniBrowser over the protocol of WebDriver (W3C), on a screen of its own. */
import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';

/** The name of what holds the id of an element in an answer (WebDriver, section 12). */
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf';

/** A port that the driver is given. */
const PORT = 4872;

export class WebKit {
  readonly #session: string;
  readonly #started: readonly ChildProcess[];

  private constructor(session: string, started: readonly ChildProcess[]) {
    this.#session = session;
    this.#started = started;
  }

  /** Starts one without a locale, whose language is no language for WebKitGTK before version 2.50. */
  static async start(): Promise<WebKit> {
    const screen = spawn(
      'Xvfb',
      ['-displayfd', '1', '-screen', '0', '1280x1000x24', '-nolisten', 'tcp'],
      {
        stdio: ['ignore', 'pipe', 'ignore'],
      },
    );
    const [number] = await once(createInterface(screen.stdout), 'line');
    const env = { ...process.env, DISPLAY: `:${number}`, LC_ALL: 'C' };
    const driver = spawn('WebKitWebDriver', [`--port=${PORT}`], { env, stdio: 'ignore' });
    const started = [driver, screen];
    const capabilities = { alwaysMatch: { browserName: 'MiniBrowser' } };
    const { sessionId } = await patiently(() => ask('POST', '/session', { capabilities }));
    return new WebKit(sessionId, started);
  }

  async close(): Promise<void> {
    await ask('DELETE', `/session/${this.#session}`);
    for (const process of this.#started) process.kill();
  }

  #ask(method: string, path: string, body?: object) {
    return ask(method, `/session/${this.#session}${path}`, body);
  }

  open(url: string): Promise<void> {
    return this.#ask('POST', '/url', { url });
  }

  /** What a function of the page returns. */
  run<T>(code: () => T): Promise<T> {
    return this.#ask('POST', '/execute/sync', { script: `return (${code})()`, args: [] });
  }

  async #element(selector: string): Promise<string> {
    const found = await this.#ask('POST', '/element', { using: 'css selector', value: selector });
    return found[ELEMENT];
  }

  async click(selector: string): Promise<void> {
    await this.#ask('POST', `/element/${await this.#element(selector)}/click`, {});
  }

  /** Types into an element; a field for files takes their paths. */
  async type(selector: string, text: string): Promise<void> {
    await this.#ask('POST', `/element/${await this.#element(selector)}/value`, { text });
  }
}

// biome-ignore lint/suspicious/noExplicitAny: each command has an answer of its own.
async function ask(method: string, path: string, body?: object): Promise<any> {
  const response = await fetch(`http://127.0.0.1:${PORT}${path}`, {
    method,
    ...(body && { body: JSON.stringify(body) }),
  });
  const { value } = await response.json();
  if (!response.ok) throw new Error(`${method} ${path}: ${value.error}: ${value.message}`);
  return value;
}

/** Asks until the driver listens. */
async function patiently<T>(work: () => Promise<T>): Promise<T> {
  for (;;) {
    try {
      return await work();
    } catch (error) {
      if (!(error instanceof TypeError)) throw error;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }
}
