import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const ROOT = join(import.meta.dirname, '../../..');

/** Runs the command line, which `cargo xtask web e2e` builds and names. */
export function bouncelab(...words: string[]): string {
  const program = process.env['BOUNCELAB_PROGRAM'] ?? join(ROOT, 'target/debug/bouncelab');
  return execFileSync(program, words, {
    cwd: ROOT,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'ignore'],
    maxBuffer: 1 << 26,
  });
}

/** The same for a run that may end with "no drop". */
export function analysed(file: string, ...words: string[]): unknown {
  try {
    return JSON.parse(bouncelab('analyze', file, '--format', 'json', ...words));
  } catch (error) {
    return JSON.parse((error as { stdout: string }).stdout);
  }
}

/** A folder for the recordings of a test. */
export function folder(): string {
  return mkdtempSync(join(tmpdir(), 'sounds-'));
}

/** A made-up recording, and its true impact times. */
export function synth(path: string, ...words: string[]): { path: string; timesS: number[] } {
  const truth = path.replace(/\.wav$/, '-truth.json');
  bouncelab('synth', path, '--truth', truth, '--force', ...words);
  return { path, timesS: JSON.parse(readFileSync(truth, 'utf8')) };
}

/** A recording among the fixtures of the sound formats. */
export function fixture(name: string): string {
  return join(ROOT, 'crates/bouncelab-audio/tests/fixtures', name);
}
