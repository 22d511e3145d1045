/**
 * The words of the page. A language is one file in `languages/`, named by its code; nothing else names
 * it. English comes with the page, the others when they are chosen.
 */
import { batch, computed, signal } from '@preact/signals';
import { recall, remember } from '../address/memory.ts';
import { ENGLISH, type Messages } from '../lab/index.ts';
import english from './languages/en.ts';
import type { Texts } from './texts.ts';

const KEY = 'bouncelab.language';
const FALLBACK = 'en';

const others = import.meta.glob<Texts>(['./languages/*.ts', '!./languages/en.ts'], {
  import: 'default',
});

/** The messages of the engine, file by file; English is part of it. */
const messageFiles = import.meta.glob<string>(
  [
    '../../../crates/bouncelab-report/messages/*/*.ftl',
    '!../../../crates/bouncelab-report/messages/en/*.ftl',
    '!../../../crates/bouncelab-report/messages/*/terminal.ftl',
  ],
  { query: '?raw', import: 'default' },
);

const codeOf = (path: string): string => path.replace(/^.*\/(.+)\.ts$/, '$1');

/** Codes of all languages, English first. */
export const languages: readonly string[] = [FALLBACK, ...Object.keys(others).map(codeOf)];

export const language = signal(FALLBACK);
/** For dates: the region of the reader, where the browser names one of this language. */
export const region = computed(
  () => navigator.languages.find((tag) => tag.startsWith(language.value)) ?? language.value,
);
export const texts = signal<Texts>(english);
/** In which language the engine writes reports and figures. */
export const messages = signal<Messages>(ENGLISH);

/** The name of a language in that language. */
export function nameOf(code: string): string {
  const name = new Intl.DisplayNames([code], { type: 'language' }).of(code) ?? code;
  return name.charAt(0).toLocaleUpperCase(code) + name.slice(1);
}

export async function speak(code: string): Promise<void> {
  const [words, sources] = await Promise.all([wordsOf(code), messagesOf(code)]);
  batch(() => {
    texts.value = words;
    messages.value = { code, sources };
    language.value = code;
  });
  document.documentElement.lang = code;
  document.title = texts.value.app.title;
}

/** Speaks a language that the reader chose, and remembers it. */
export async function choose(code: string): Promise<void> {
  remember(KEY, code);
  await speak(code);
}

/** The language that was chosen before, else the first one of the browser that is there. */
export function preferred(): string {
  const wanted = [recall(KEY) ?? '', ...navigator.languages];
  const codes = wanted.map((tag) => tag.slice(0, 2).toLowerCase());
  return codes.find((code) => languages.includes(code)) ?? FALLBACK;
}

async function wordsOf(code: string): Promise<Texts> {
  const path = Object.keys(others).find((candidate) => codeOf(candidate) === code);
  const load = path === undefined ? undefined : others[path];
  return load ? load() : english;
}

async function messagesOf(code: string): Promise<string[]> {
  const files = Object.entries(messageFiles).filter(([path]) => path.includes(`/${code}/`));
  return Promise.all(files.map(([, load]) => load()));
}
