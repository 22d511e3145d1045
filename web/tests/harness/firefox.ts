/** Firefox, that of the system, to which Playwright speaks by WebDriver BiDi; and which tests cannot run in it. */
import type { LaunchOptions } from 'playwright-core';
import type { Microphone } from './browser.ts';
import { folder } from './program.ts';

const path = process.env['BOUNCELAB_FIREFOX'];

/** The Firefox that is named, and where it saves files: Playwright hears of no download that a link begins. */
export const FIREFOX = path === undefined ? undefined : { path, downloads: folder() };

/** What the browser calls the style that Playwright tries to add to a page for a screenshot. */
export const STYLE_OF_PLAYWRIGHT = 'sha256-YjaKGiklmzC6wjXA513HAMmzus8VE61XCOT+SmwNZWA=';

interface Exception {
  readonly file: string;
  /** All of its tests, unless names are given. */
  readonly tests?: RegExp;
  readonly reason: string;
}

/** What cannot run in Firefox. */
const EXCEPTIONS: readonly Exception[] = [
  {
    file: 'edit.e2e.ts',
    tests: /double click/,
    reason: 'only the protocol of Chromium sets the time between two clicks',
  },
  { file: 'fonts.e2e.ts', reason: 'only the protocol of Chromium tells the fonts of a text' },
  {
    file: 'keep.e2e.ts',
    tests: /^the browser clears/,
    reason: 'only the protocol of Chromium clears the storage of an open page',
  },
  { file: 'kill.e2e.ts', reason: 'Playwright cannot return to the profile of a Firefox' },
  {
    file: 'report.e2e.ts',
    tests: /asks for nothing/,
    reason: 'Playwright does not hear of files that Firefox opens',
  },
  {
    file: 'report.e2e.ts',
    tests: /^the command of the documents/,
    reason: 'it is a command of Chromium',
  },
  {
    file: 'views.e2e.ts',
    tests: /^with the aid of .contrast|^where the system states the colours/,
    reason: 'only the protocol of Chromium gives the system colours of its own',
  },
];

/** Why a test cannot run in Firefox, if it cannot. */
export function reasonAgainst(file: string, test: string): string | undefined {
  return EXCEPTIONS.find((it) => it.file === file && (it.tests?.test(test) ?? true))?.reason;
}

/** How to start it with this microphone, whose sound is a tone. */
export function firefoxOptions(
  { path: executablePath, downloads: downloadsPath }: NonNullable<typeof FIREFOX>,
  microphone: Microphone,
  usual: LaunchOptions,
): LaunchOptions {
  const firefoxUserPrefs = {
    // The panel would take the keyboard from the page.
    'browser.download.alwaysOpenPanel': false,
    'media.navigator.streams.fake': microphone !== 'missing',
    'media.navigator.permission.disabled': microphone !== 'refused',
    'permissions.default.microphone': microphone === 'refused' ? 2 : 0,
  };
  // What is played to the card of the sound server can be recorded from it.
  const env = { ...usual.env, ...(microphone === 'missing' && { PULSE_SERVER: 'none' }) };
  return { ...usual, env, executablePath, downloadsPath, channel: 'moz-firefox', firefoxUserPrefs };
}
