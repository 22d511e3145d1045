import { LabError } from './error.ts';
import type { Call, FromWorker, Messages, Request, Response, ToWorker } from './protocol.ts';

/** The side of a worker that the page sees; tests put something else in its place. */
export interface Port {
  postMessage(message: ToWorker, transfer: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** The science, compiled; and the decoders where they are needed. */
export interface Modules {
  engine: WebAssembly.Module;
  decoders: WebAssembly.Module | null;
}

interface Pending {
  resolve(response: unknown): void;
  reject(error: LabError): void;
  progress: ((share: number) => void) | undefined;
}

/**
 * Calls to one worker, answered in order.
 *
 * If the engine in it fails, the worker is ended and the next call starts another: it holds no state that the page
 * needs.
 */
export class Connection {
  readonly #spawn: () => Port;
  readonly #modules: Promise<Modules>;
  readonly #messages: () => Messages;
  #port: Port | null = null;
  #pending = new Map<number, Pending>();
  #next = 0;

  /** Every call is answered in the language that `messages` has at that time. */
  constructor(spawn: () => Port, modules: Promise<Modules>, messages: () => Messages) {
    this.#spawn = spawn;
    this.#modules = modules;
    this.#messages = messages;
  }

  call<C extends Call>(
    call: C,
    request: Request<C>,
    options: { transfer?: Transferable[]; progress?: ((share: number) => void) | undefined } = {},
  ): Promise<Response<C>> {
    this.#next += 1;
    const id = this.#next;
    return new Promise<Response<C>>((resolve, reject) => {
      this.#pending.set(id, {
        resolve: (response) => resolve(response as Response<C>),
        reject,
        progress: options.progress,
      });
      const messages = this.#messages();
      const message = { kind: 'call', id, call, request, messages } as ToWorker;
      this.#open().postMessage(message, options.transfer ?? []);
    });
  }

  /** Ends the worker; what was asked of it is rejected with this error. */
  close(error = new LabError('cancelled', 'called off')): void {
    this.#port?.terminate();
    this.#port = null;
    const pending = this.#pending;
    this.#pending = new Map();
    for (const { reject } of pending.values()) {
      reject(error);
    }
  }

  #open(): Port {
    if (this.#port !== null) {
      return this.#port;
    }
    const port = this.#spawn();
    this.#port = port;
    port.onmessage = ({ data }) => this.#receive(data);
    port.onerror = (event) => this.#lose(event.message);
    this.#modules.then(
      (modules) => port.postMessage({ kind: 'start', ...modules }, []),
      (reason) => this.#lose(String(reason)),
    );
    return port;
  }

  #receive(message: FromWorker): void {
    const pending = this.#pending.get(message.id);
    if (message.kind === 'progress') {
      pending?.progress?.(message.share);
      return;
    }
    this.#pending.delete(message.id);
    if (message.kind === 'done') {
      pending?.resolve(message.response);
      return;
    }
    pending?.reject(LabError.of(message.refusal));
    if (message.broken) {
      this.#lose(message.refusal.message);
    }
  }

  #lose(reason: string): void {
    this.close(new LabError('fault', `the laboratory failed: ${reason}; please try again`));
  }
}
