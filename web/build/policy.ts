import type { Plugin } from 'vite';

/**
 * What the page may do: run and fetch what comes with it, and nothing else. The same text is sent
 * as a header by `bouncelab serve`; in the page it holds on any web server.
 */
export const POLICY = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "font-src 'self'",
  "connect-src 'self'",
  "media-src 'self' blob:",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

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
