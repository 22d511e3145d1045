/**
 * The fonts that a browser finds. What is wider with one font than with another must fit with both, so
 * the layout is tested with each set, whatever else is installed.
 */
import { existsSync, mkdtempSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';

export interface FontSet {
  /** The package of Debian that has the first of its families. */
  readonly name: string;
  /** In which order each kind of text looks for its letters. */
  readonly families: Readonly<Record<'sans-serif' | 'serif' | 'monospace', readonly string[]>>;
}

const DEJAVU: FontSet = {
  name: 'fonts-dejavu-core',
  families: {
    'sans-serif': ['DejaVu Sans'],
    serif: ['DejaVu Serif'],
    monospace: ['DejaVu Sans Mono'],
  },
};

/** Letters as wide as those of Arial and Times New Roman; the signs that it lacks are of the first. */
const LIBERATION: FontSet = {
  name: 'fonts-liberation',
  families: {
    'sans-serif': ['Liberation Sans', ...DEJAVU.families['sans-serif']],
    serif: ['Liberation Serif', ...DEJAVU.families.serif],
    monospace: ['Liberation Mono', ...DEJAVU.families.monospace],
  },
};

/** Those that Chromium alone brings along on Debian, and those that the checks install. */
const SETS = [DEJAVU, LIBERATION] as const;

const FOLDERS = ['/usr/share/fonts', '/usr/local/share/fonts'].filter(existsSync);

/** How the file of a family is named, without its style. */
const fileOf = (family: string): string => family.replaceAll(' ', '');

const installed = new Set(
  FOLDERS.flatMap((folder) => readdirSync(folder, { recursive: true, encoding: 'utf8' })).map(
    (path) => basename(path).replace(/(-Regular)?\.[ot]tf$/, ''),
  ),
);

const isInstalled = ({ families }: FontSet): boolean =>
  Object.values(families)
    .flat()
    .every((family) => installed.has(fileOf(family)));

/** The sets with which the layout can be tested here: `undefined` is whatever the system has. */
export const FONT_SETS: readonly (FontSet | undefined)[] = available();

function available(): readonly (FontSet | undefined)[] {
  const found = SETS.filter(isInstalled);
  for (const { name } of SETS.filter((set) => !isInstalled(set))) {
    process.stdout.write(`SKIPPED: the layout with ${name}, which is not installed\n`);
  }
  return found.length > 0 ? found : [undefined];
}

/** How tests and pictures are named that use a set. */
export const nameOf = (fonts: FontSet | undefined): string => fonts?.name ?? 'fonts of the system';

/** The variables with which a browser finds these fonts and no others. */
export function environment(fonts: FontSet): Record<string, string> {
  const folder = mkdtempSync(join(tmpdir(), 'fonts-'));
  const file = join(folder, 'fonts.conf');
  writeFileSync(file, configuration(fonts, folder));
  return { FONTCONFIG_FILE: file };
}

function configuration({ families }: FontSet, cache: string): string {
  const kinds = Object.entries({ 'system-ui': families['sans-serif'], ...families });
  const tag = (name: string, content: string): string => `<${name}>${content}</${name}>`;
  const named = (family: string): string => tag('family', family);
  const aliases = kinds.map(([kind, preferred]) =>
    tag('alias', named(kind) + tag('prefer', preferred.map(named).join(''))),
  );
  const accepted = Object.values(families)
    .flat()
    .map(fileOf)
    .flatMap((file) => [tag('glob', `*/${file}.*`), tag('glob', `*/${file}-*`)]);
  return [
    '<?xml version="1.0"?>',
    '<!DOCTYPE fontconfig SYSTEM "urn:fontconfig:fonts.dtd">',
    '<fontconfig>',
    ...FOLDERS.map((folder) => tag('dir', folder)),
    tag('cachedir', cache),
    // Also what asks for no kind.
    '<match><edit name="family" mode="append_last"><string>sans-serif</string></edit></match>',
    ...aliases,
    // A file that is accepted stays although it is rejected too. Folders have no dot.
    tag('selectfont', tag('rejectfont', tag('glob', '*.*')) + tag('acceptfont', accepted.join(''))),
    '</fontconfig>',
  ].join('\n');
}
