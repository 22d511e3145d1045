/** The element `<bounce-lab>`: a recording is chosen, and the answer stands below. */

import { type Analysed, Lab, LabError, type Settings } from '../../src/lab/index.ts';
import { languages, learn, messages, text } from '../../src/text/language.ts';
import { reasonText } from '../../src/text/reason.ts';

const STYLE = `
:host { display: block; font: inherit; max-width: 44rem; }
label { display: block; padding: 1rem; border: 2px dashed currentColor; border-radius: 0.5rem; cursor: pointer; }
label:focus-within, label.over { outline: 3px solid Highlight; }
input { display: block; margin-top: 0.5rem; font: inherit; max-width: 100%; }
p { margin: 0.75rem 0; }
svg { max-width: 100%; height: auto; }
`;

/** What a page can ask for by attributes. */
const ATTRIBUTES = ['src', 'ball', 'lang'] as const;

/** All elements of a page share one engine, which starts with the first. */
let engine: Lab | null = null;

function shared(): Lab {
  engine ??= new Lab(() => messages.value);
  return engine;
}

/**
 * ```html
 * <bounce-lab ball="table-tennis-40" lang="en"></bounce-lab>
 * ```
 */
export class BounceLab extends HTMLElement {
  static readonly observedAttributes = ATTRIBUTES;

  readonly #input = document.createElement('input');
  readonly #label = document.createElement('label');
  readonly #caption = document.createElement('span');
  readonly #answer = document.createElement('div');
  #settings: Settings = {};
  /** The work that the reader waits for; that before it no longer matters. */
  #work = 0;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(STYLE);
    root.adoptedStyleSheets = [sheet];
    this.#input.type = 'file';
    this.#label.append(this.#caption, this.#input);
    this.#answer.role = 'status';
    root.append(this.#label, this.#answer);
    this.#input.addEventListener('change', () => this.#take(this.#input.files));
    this.#label.addEventListener('dragover', (event) => {
      event.preventDefault();
      this.#label.classList.add('over');
    });
    this.#label.addEventListener('dragleave', () => this.#label.classList.remove('over'));
    this.#label.addEventListener('drop', (event) => {
      event.preventDefault();
      this.#label.classList.remove('over');
      this.#take(event.dataTransfer?.files ?? null);
    });
  }

  /** What is known besides the ball. */
  get settings(): Settings {
    return this.#settings;
  }

  set settings(settings: Settings) {
    this.#settings = settings;
  }

  connectedCallback(): void {
    void this.#speak();
  }

  attributeChangedCallback(name: (typeof ATTRIBUTES)[number], _: string | null, now: string): void {
    if (!this.isConnected) return;
    if (name === 'lang') void this.#speak();
    if (name === 'src' && now) void this.#fetch(now);
  }

  /** Analyses a recording; the answer is shown, and sent as an event. */
  async analyse(file: File | { name: string; blob: Blob }): Promise<Analysed | null> {
    this.#work += 1;
    const work = this.#work;
    this.#show([text('page-lab-opening', { name: file.name })]);
    try {
      const lab = shared();
      const recording = await lab.open(file);
      const ball = this.getAttribute('ball');
      const settings = ball
        ? { ...this.#settings, ball: { ...this.#settings.ball, kind: ball } }
        : this.#settings;
      const request = lab.request(recording, settings);
      const analysed = await lab.analyseBeside(request);
      if (work !== this.#work) return null;
      const sentences = analysed.headlines.flatMap((headline) => headline.sentences);
      const none = analysed.document.no_drop?.message;
      this.#show([...sentences.map((it) => it.join('')), ...(none ? [none] : [])]);
      if (recording.sound !== null) {
        const drawn = await lab.waveform(recording, request);
        if (work === this.#work) this.#draw(drawn.svg);
      }
      this.dispatchEvent(new CustomEvent('bouncelab-result', { detail: analysed }));
      return analysed;
    } catch (error) {
      if (work !== this.#work || LabError.isMoot(error)) return null;
      const reason = error instanceof LabError ? error.reason : null;
      this.#show([reason ? reasonText(reason) : String(error)]);
      this.dispatchEvent(new CustomEvent('bouncelab-error', { detail: error }));
      return null;
    }
  }

  async #speak(): Promise<void> {
    const wanted = this.closest('[lang]')?.getAttribute('lang') ?? 'en';
    const code = wanted.toLowerCase().split('-')[0] ?? 'en';
    await learn(languages.includes(code) ? code : 'en');
    this.#caption.textContent = text('page-lab-open-label');
    const source = this.getAttribute('src');
    if (source) await this.#fetch(source);
  }

  async #fetch(address: string): Promise<void> {
    const name = address.split('/').at(-1) ?? address;
    const answer = await fetch(address).catch(() => null);
    if (answer?.ok) {
      await this.analyse({ name, blob: await answer.blob() });
    } else {
      this.#show([reasonText({ code: 'unreadable' })]);
    }
  }

  #take(files: FileList | null): void {
    const [file] = files ?? [];
    if (file) void this.analyse(file);
  }

  #show(sentences: readonly string[]): void {
    this.#answer.replaceChildren(
      ...sentences.map((sentence) => {
        const line = document.createElement('p');
        line.textContent = sentence;
        return line;
      }),
    );
  }

  #draw(svg: string): void {
    const drawn = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
    this.#answer.append(document.importNode(drawn, true));
  }
}
