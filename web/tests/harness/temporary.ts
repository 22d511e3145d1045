/** What a run writes for itself lies in one folder, which is deleted at its end. */
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** Workers and browsers, which start later, take the folder for that of temporary files; the answer deletes it. */
export default function setup(): () => void {
  const folder = mkdtempSync(join(tmpdir(), 'bouncelab-e2e-'));
  process.env['TMPDIR'] = folder;
  return () => rmSync(folder, { recursive: true, force: true });
}
