/** The words of the page in each language, read from its message files. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { FluentBundle, FluentResource } from '@fluent/bundle';

const FOLDER = join(import.meta.dirname, '../../../crates/bouncelab-report/messages');

/** Codes of all languages. */
export const LANGUAGES: readonly string[] = readdirSync(FOLDER);

/** Gives the messages of a language that take no arguments. */
export function wordsOf(language: string): (id: string) => string {
  const bundle = new FluentBundle(language, { useIsolating: false });
  const source = readFileSync(join(FOLDER, language, 'page.ftl'), 'utf8');
  bundle.addResource(new FluentResource(source));
  return (id) => {
    const pattern = bundle.getMessage(id)?.value;
    if (!pattern) throw new Error(`${language} has no message ${id}`);
    return bundle.formatPattern(pattern);
  };
}
