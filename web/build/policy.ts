import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';

/** The header that `bouncelab serve` sends. */
const HEADER = join(import.meta.dirname, '../../crates/bouncelab-cli/src/policy.txt');

/**
 * What the page may do: run and fetch what comes with it, and nothing else. In the page it holds on
 * any web server; only a header can forbid frames.
 */
export const POLICY = readFileSync(HEADER, 'utf8').trim().replace("; frame-ancestors 'none'", '');

/** Puts the policy into the page when it is built; the development server needs more freedom. */
export function contentSecurityPolicy(): Plugin {
  return {
    name: 'bouncelab:content-security-policy',
    apply: 'build',
    transformIndexHtml: () => [
      {
        tag: 'meta',
        attrs: { 'http-equiv': 'Content-Security-Policy', content: POLICY },
        injectTo: 'head-prepend',
      },
    ],
  };
}
