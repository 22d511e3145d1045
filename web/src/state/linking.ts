/** A drop as a link: made for others, and opened where the address holds one. */
import { DROP } from '../address/drop.ts';
import { addressOf, parseRoute } from '../address/route.ts';
import type { DropLink } from '../lab/index.ts';
import { engine, faultOf } from './engine.ts';
import { pupil } from './lesson.ts';
import { openLinked } from './opening.ts';
import { settings } from './settings.ts';
import { busy, fail, marks } from './workspace.ts';

/** The drop in the workspace as a link and a QR code. */
export function linkOfDrop(name: string): Promise<DropLink> {
  const drop = {
    name,
    surface: pupil().surface,
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
    await openLinked(await engine().linkedDrop(code));
  } catch (error) {
    fail(faultOf(error));
  }
}
