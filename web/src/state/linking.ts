/** A drop as a link: made for others, opened where the address holds one, and kept where several are pasted. */
import { codesIn, DROP } from '../address/drop.ts';
import { addressOf, parseRoute } from '../address/route.ts';
import type { DropLink } from '../lab/index.ts';
import { putDrop } from '../store/drops.ts';
import { engine, faultOf } from './engine.ts';
import { loadKept, summaryOf } from './keeping.ts';
import { openLinked } from './opening.ts';
import { settings, writeSettings } from './settings.ts';
import { busy, fail, marks } from './workspace.ts';

/** The drop in the workspace as a link and a QR code. */
export function linkOfDrop(name: string): Promise<DropLink> {
  const drop = {
    name,
    settings: settings.peek(),
    times_s: marks.peek().map(({ timeS }) => timeS),
  };
  return engine().dropLink(drop, addressOf('lab', new URLSearchParams({ [DROP]: '' })));
}

/** Opens the drop of the address, if it holds one. */
export async function followLink(): Promise<void> {
  const { view, parameters } = parseRoute(location.hash);
  const code = parameters.get(DROP);
  if (view !== 'lab' || code === null || busy.peek()) return;
  try {
    const drop = await engine().linkedDrop(code);
    settings.value = drop.settings;
    await openLinked(drop);
    writeSettings();
  } catch (error) {
    fail({ key: 'link', detail: faultOf(error).detail });
  }
}

/** Keeps the drops of pasted links in the table; how many, and how many links are of no drop. */
export async function keepLinks(pasted: string): Promise<{ kept: number; refused: number }> {
  const codes = codesIn(pasted);
  let kept = 0;
  for (const code of codes) {
    const isKept = await keepLink(code).catch(() => false);
    if (isKept) kept += 1;
  }
  await loadKept();
  return { kept, refused: codes.length - kept };
}

async function keepLink(code: string): Promise<boolean> {
  const { name, settings, times_s } = await engine().linkedDrop(code);
  const request = engine().request(await engine().paste(times_s.join('\n')), settings);
  const { document, ball } = await engine().analyse(request);
  const [result, marks] = [document.drops[0], request.drops[0]];
  if (!result || !marks) return false;
  // A link that is pasted again is the same drop.
  const about = { id: code, name, keptAt: Date.now(), ball, settings, marks, recording: null };
  await putDrop({ ...about, ...summaryOf(result) });
  return true;
}
