/**
 * The words of the page: messages in Fluent, the files `page.ftl` and `names.ftl` of each language. English comes with
 * the page, the others when they are chosen, together with what the engine needs to speak them.
 */
import { FluentBundle, FluentNumber, FluentResource } from '@fluent/bundle';
import { batch, computed, signal } from '@preact/signals';
import englishNames from '../../../crates/bouncelab-report/messages/en/names.ftl?raw';
import englishPage from '../../../crates/bouncelab-report/messages/en/page.ftl?raw';
import { recall, remember } from '../address/memory.ts';
import { ENGLISH, type Messages } from '../lab/index.ts';

const KEY = 'bouncelab.language';
const FALLBACK = 'en';
/** What only the page shows, and names that the engine shows too. */
const PAGE = '/page.ftl';
const NAMES = '/names.ftl';
const english = [englishPage, englishNames];

/** All messages, file by file, but for English, which is part of page and engine. */
const files = import.meta.glob<string>(
  [
    '../../../crates/bouncelab-report/messages/*/*.ftl',
    '!../../../crates/bouncelab-report/messages/en/*.ftl',
    '!../../../crates/bouncelab-report/messages/*/{sheets,terminal}.ftl',
  ],
  { query: '?raw', import: 'default' },
);

/** What lesson sheets are written with, file by file. */
const ofSheets = import.meta.glob<string>(
  '../../../crates/bouncelab-report/messages/*/{common,sheets}.ftl',
  { query: '?raw', import: 'default' },
);

const codeOf = (path: string): string => path.replace(/^.*\/(.+)\/.+$/, '$1');

/** Codes of all languages, English first. */
export const languages: readonly string[] = [FALLBACK, ...new Set(Object.keys(files).map(codeOf))];

export const language = signal(FALLBACK);
/** For dates: the region of the reader, where the browser names one of this language. */
export const region = computed(() => {
  const isOfLanguage = (tag: string) => isTag(tag) && tag.split('-')[0] === language.value;
  return navigator.languages.find(isOfLanguage) ?? language.value;
});
const bundle = signal(bundleOf(FALLBACK, english));
/** In which language the engine writes reports and figures. */
export const messages = signal<Messages>(ENGLISH);

/** A browser may name what is no language, such as "C" or "en_US.UTF-8", which Intl throws on. */
function isTag(tag: string): boolean {
  try {
    return Intl.getCanonicalLocales(tag).length === 1;
  } catch {
    return false;
  }
}

/** Replaces the language of the browser by that of the page, if `Intl` refuses it: libraries ask for it. */
export function mendLanguage(): void {
  if (isTag(navigator.language)) return;
  Reflect.defineProperty(navigator, 'language', { value: language.peek(), configurable: true });
}

/** The name of a language in that language; a browser whose own language is unknown may know none. */
export function nameOf(code: string): string {
  let name = code;
  try {
    name = new Intl.DisplayNames([code], { type: 'language' }).of(code) ?? code;
  } catch {
    // Its code says which it is.
  }
  return name.charAt(0).toLocaleUpperCase(code) + name.slice(1);
}

/** What stands in a message: numbers choose its plural form. */
export type Values = Readonly<Record<string, string | number>>;

/** Whether there is a message with this id. */
export const hasText = (id: string): boolean => bundle.value.hasMessage(id);

/** A message in the language of the page; one that does not exist is shown as its id. */
export function text(id: string, values: Values = {}): string {
  const pattern = bundle.value.getMessage(id)?.value;
  if (!pattern) return id;
  const entries = Object.entries(values).map(([name, value]) => [
    name,
    typeof value === 'number' ? new FluentNumber(value, { useGrouping: false }) : value,
  ]);
  return bundle.value.formatPattern(pattern, Object.fromEntries(entries));
}

/** A message in parts: text and values in turn, where values stand out. */
export function parts(id: string, values: Values = {}): readonly string[] {
  const marked = Object.keys(values).map((name) => [name, `\u0001${name}\u0001`]);
  const all = text(id, Object.fromEntries(marked)).split('\u0001');
  return all.map((part, index) => (index % 2 === 0 ? part : String(values[part])));
}

function bundleOf(code: string, files: readonly string[]): FluentBundle {
  const made = new FluentBundle(code, { useIsolating: false });
  for (const source of files) made.addResource(new FluentResource(source));
  return made;
}

/** Words and answers in a language from now on. */
export async function learn(code: string): Promise<void> {
  const [page, sources] = code === FALLBACK ? [english, []] : await sourcesOf(code);
  batch(() => {
    bundle.value = bundleOf(code, page);
    messages.value = { code, sources };
    language.value = code;
  });
}

/** Speaks a language, as a whole page. */
export async function speak(code: string): Promise<void> {
  await learn(code);
  document.documentElement.lang = code;
  document.title = text('page-app-title');
}

/** Speaks a language that the reader chose, and remembers it. */
export async function choose(code: string): Promise<void> {
  remember(KEY, code);
  await speak(code);
}

/** The language that was chosen before, else the first one of the browser that is there. */
export function preferred(): string {
  const wanted = [recall(KEY) ?? '', ...navigator.languages];
  const codes = wanted.map((tag) => tag.toLowerCase().split(/[-_]/)[0] ?? '');
  return codes.find((code) => languages.includes(code)) ?? FALLBACK;
}

/** The messages of lesson sheets, in the language of the page. */
export async function sheetMessages(): Promise<Messages> {
  const code = language.peek();
  const own = Object.entries(ofSheets).filter(([path]) => codeOf(path) === code);
  return { code, sources: await Promise.all(own.map(([, load]) => load())) };
}

/** The messages of a language, file by file: those of the page, and those of the engine. */
async function sourcesOf(code: string): Promise<[string[], string[]]> {
  const own = Object.entries(files).filter(([path]) => codeOf(path) === code);
  const loaded = await Promise.all(own.map(async ([path, load]) => [path, await load()] as const));
  const ofPage = loaded.filter(([path]) => path.endsWith(PAGE) || path.endsWith(NAMES));
  const ofEngine = loaded.filter(([path]) => !path.endsWith(PAGE));
  return [ofPage.map(([, source]) => source), ofEngine.map(([, source]) => source)];
}
