/** The engine for pages of others, and the element `<bounce-lab>`, which this registers. */

import { BounceLab } from './element.ts';

export * from '../../src/lab/index.ts';
export { BounceLab };

if (!customElements.get('bounce-lab')) customElements.define('bounce-lab', BounceLab);
