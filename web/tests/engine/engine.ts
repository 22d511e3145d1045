/** The engine without the page, for its end-to-end tests. */
import * as lab from '../../src/lab/index.ts';

declare global {
  var engine: typeof lab;
}

globalThis.engine = lab;
