import { existsSync } from 'node:fs';
import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';

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

/** A Chromium with this microphone. */
export async function launch(microphone: Microphone = 'silence'): Promise<Browser> {
  const executablePath =
    process.env['BOUNCELAB_CHROMIUM'] ?? PLACES.find((place) => existsSync(place));
  if (executablePath === undefined) {
    throw new Error('there is no Chromium here; install it, or name it in BOUNCELAB_CHROMIUM');
  }
  const args = ['--no-sandbox', ...QUIET, ...sound(microphone)];
  return chromium.launch({ executablePath, args });
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

/** A page that fails the test if anything goes wrong in it that nobody sees. */
export async function openPage(
  browser: Browser,
  url: string,
  options: BrowserContextOptions = {},
): Promise<{ page: Page; troubles: string[] }> {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const troubles: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') {
      troubles.push(message.text());
    }
  });
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on('request', (request) => {
    const asked = request.url();
    if (/^https?:/.test(asked) && !asked.startsWith(new URL(url).origin)) {
      troubles.push(`a request to another origin: ${asked}`);
    }
  });
  await page.goto(url);
  return { page, troubles };
}
