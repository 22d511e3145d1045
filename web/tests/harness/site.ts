import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { POLICY } from '../../build/policy.ts';
import { SLOWDOWN } from './slowdown.ts';

const MEDIA_TYPES: Record<string, string> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
  '.webmanifest': 'application/manifest+json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
};

/** A folder on localhost, served as `bouncelab serve` does. */
export class Site {
  readonly url: string;
  readonly #server: Server;

  private constructor(server: Server) {
    this.#server = server;
    this.url = `http://localhost:${(server.address() as AddressInfo).port}/`;
  }

  /** `dist`, or the folder in `BOUNCELAB_PAGE`, unless another is named. */
  static async open(
    folder = process.env['BOUNCELAB_PAGE'] ?? join(import.meta.dirname, '../../dist'),
  ): Promise<Site> {
    const server = createServer(async (request, response) => {
      const path = normalize(new URL(request.url ?? '/', 'http://localhost').pathname);
      const name = path.endsWith('/') ? `${path}index.html` : path;
      if (SLOWDOWN > 1) await pause(Math.random() * SLOWDOWN * 100);
      try {
        const plain = join(folder, name);
        const isSmall = existsSync(`${plain}.br`);
        const content = await readFile(isSmall ? `${plain}.br` : plain);
        response.writeHead(200, {
          'Content-Type': MEDIA_TYPES[extname(name)] ?? 'application/octet-stream',
          ...(isSmall && { 'Content-Encoding': 'br' }),
          'Content-Security-Policy': POLICY,
          'X-Content-Type-Options': 'nosniff',
          'Cache-Control': 'no-cache',
        });
        response.end(content);
      } catch {
        response.writeHead(404).end();
      }
    });
    await new Promise<void>((resolve) => server.listen(0, 'localhost', resolve));
    return new Site(server);
  }

  /** Afterwards the page must do without. */
  async close(): Promise<void> {
    this.#server.closeAllConnections();
    await new Promise((resolve) => this.#server.close(resolve));
  }
}
