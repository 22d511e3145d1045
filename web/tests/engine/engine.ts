/** The engine without the page, for the stories of the engine. */
import * as lab from '../../src/lab/index.ts';

declare global {
  var engine: typeof lab;
}

globalThis.engine = lab;
