import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { createInterface } from 'node:readline';
import {
  type Browser,
  type BrowserContext,
  type BrowserContextOptions,
  chromium,
  firefox,
  type LaunchOptions,
  type Page,
} from 'playwright-core';
import { hearing } from '../support/sounds.ts';
import { FIREFOX, firefoxOptions, STYLE_OF_PLAYWRIGHT } from './firefox.ts';
import { environment, type FontSet } from './fonts.ts';
import { SLOWDOWN } from './slowdown.ts';

const PLACES = [
  '/usr/bin/chromium',
  '/usr/bin/chromium-browser',
  '/usr/bin/google-chrome',
  '/usr/bin/google-chrome-stable',
];

/** What the microphone of the browser hears. */
export type Microphone = { file: string } | 'refused' | 'missing' | 'silence';

/** Without these, a browser on a closed network spends its time looking for its maker. */
const QUIET = [
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--mute-audio',
];

/** Without these, which Playwright gives the browsers that it launches, a browser may draw no frames of a page that it takes for hidden. */
const AWAKE = [
  '--disable-backgrounding-occluded-windows',
  '--disable-renderer-backgrounding',
  '--disable-background-timer-throttling',
  '--disable-dev-shm-usage',
];

/**
 * How long a state of the page is waited for, in milliseconds: as a test that hangs should end, not as
 * long as it takes. Busy machines take long.
 */
export const PATIENCE_MS = 240_000;

/** How a browser is launched. */
export interface Options {
  readonly microphone?: Microphone;
  /** A film that its camera plays, in the format Y4M. */
  readonly camera?: string;
  /** Those of the system, unless a set is named. */
  readonly fonts?: FontSet | undefined;
}

/** The Chromium of the tests. */
function chromiumHere(): string {
  const found = process.env['BOUNCELAB_CHROMIUM'] ?? PLACES.find((place) => existsSync(place));
  if (found === undefined) {
    throw new Error('there is no Chromium here; install it, or name it in BOUNCELAB_CHROMIUM');
  }
  return found;
}

/** A browser with this microphone and these fonts. */
export async function launch(options: Options = {}): Promise<Browser> {
  const { microphone = 'silence', camera, fonts } = options;
  const env = { ...process.env, ...(fonts && environment(fonts)) } as Record<string, string>;
  const usual = { env, timeout: PATIENCE_MS };
  if (FIREFOX) return launchFirefox(FIREFOX, microphone, usual);
  const seen = camera === undefined ? [] : [`--use-file-for-fake-video-capture=${camera}`];
  const args = ['--no-sandbox', ...QUIET, ...sound(microphone), ...seen];
  return chromium.launch({ executablePath: chromiumHere(), args, ...usual });
}

/** What each Firefox hears: its own microphone plays no file. */
const preparations = new WeakMap<Browser, Preparation>();

async function launchFirefox(
  which: NonNullable<typeof FIREFOX>,
  microphone: Microphone,
  usual: LaunchOptions,
): Promise<Browser> {
  const browser = await firefox.launch(firefoxOptions(which, microphone, usual));
  if (typeof microphone === 'object') preparations.set(browser, hearing(microphone.file));
  return browser;
}

/** A context that waits patiently. */
export async function newContext(
  browser: Browser,
  options: BrowserContextOptions = {},
): Promise<BrowserContext> {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(PATIENCE_MS);
  if (SLOWDOWN > 1 && !FIREFOX) context.on('page', slowDown);
  await preparations.get(browser)?.(context);
  return context;
}

/** Closes all pages, which would go on taking memory and time from the tests that follow. */
export async function closeContexts(browser: Browser): Promise<void> {
  for (const context of browser.contexts()) await context.close();
}

async function slowDown(page: Page): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setCPUThrottlingRate', { rate: SLOWDOWN });
}

/** A Chromium that can be killed. */
export interface Mortal {
  /** Its only page, empty at first: no other tab can hide it. Its context is that of the profile, which outlives it. */
  readonly page: Page;
  /** Ends all its processes at once, without a word. */
  kill(): void;
  /** When it is dead. */
  readonly death: Promise<unknown>;
}

/** A Chromium with a profile in this folder, in a process group of its own. */
export async function launchMortal(profile: string): Promise<Mortal> {
  const args = ['--no-sandbox', '--headless=new', ...QUIET, ...AWAKE, ...sound('silence')];
  const debugged = [
    '--disable-breakpad',
    '--remote-debugging-port=0',
    `--user-data-dir=${profile}`,
  ];
  const started = spawn(chromiumHere(), [...args, ...debugged, 'about:blank'], {
    detached: true,
    stdio: ['ignore', 'ignore', 'pipe'],
  });
  const death = once(started, 'exit');
  const address = await new Promise<string>((resolve, reject) => {
    createInterface(started.stderr).on('line', (line) => {
      const [, found] = /^DevTools listening on (ws:.*)$/.exec(line) ?? [];
      if (found !== undefined) resolve(found);
    });
    death.then(() => reject(new Error('Chromium ended before it could be spoken to')), reject);
  });
  const browser = await chromium.connectOverCDP(address, { timeout: PATIENCE_MS });
  const context = browser.contexts()[0] as BrowserContext;
  context.setDefaultTimeout(PATIENCE_MS);
  const page = context.pages()[0] ?? (await context.waitForEvent('page'));
  return { page, kill: () => process.kill(-(started.pid as number), 'SIGKILL'), death };
}

function sound(microphone: Microphone): string[] {
  if (microphone === 'missing') {
    return [];
  }
  const device = '--use-fake-device-for-media-stream';
  if (microphone === 'refused') {
    return [device, '--deny-permission-prompts'];
  }
  const granted = [device, '--use-fake-ui-for-media-stream'];
  return microphone === 'silence'
    ? granted
    : [...granted, `--use-file-for-fake-audio-capture=${microphone.file}%noloop`];
}

/** What is changed in a browser before it opens a page. */
export type Preparation = (context: BrowserContext) => Promise<void>;

/** A page that fails the test if anything goes wrong in it that nobody sees. */
export async function openPage(
  browser: Browser,
  url: string,
  options: BrowserContextOptions = {},
  prepare?: Preparation,
): Promise<{ page: Page; troubles: string[] }> {
  const context = await newContext(browser, options);
  await prepare?.(context);
  const page = await context.newPage();
  const troubles: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') {
      troubles.push(message.text());
    }
  });
  page.on('pageerror', (error) => {
    if (!error.message.includes(STYLE_OF_PLAYWRIGHT)) troubles.push(String(error));
  });
  page.on('request', (request) => {
    const asked = request.url();
    if (/^https?:/.test(asked) && !asked.startsWith(new URL(url).origin)) {
      troubles.push(`a request to another origin: ${asked}`);
    }
  });
  await page.goto(url);
  return { page, troubles };
}
