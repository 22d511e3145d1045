import { useState } from 'preact/hooks';
import { FaultNotice } from '../../app/FaultNotice.tsx';
import type { DropLink as Link } from '../../lab/index.ts';
import { faultOf } from '../../state/engine.ts';
import type { Fault } from '../../state/faults.ts';
import { linkOfDrop } from '../../state/linking.ts';
import { analysed } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** Modules that stay white around a QR code. */
const MARGIN = 4;

/** What was made of which drop. */
interface Made {
  readonly of: unknown;
  readonly name: string;
  readonly link?: Link;
  readonly fault?: Fault;
}

/** The drop for another phone or computer, with the name that it was given: a link, and a QR code of it. */
export function DropLink({ name }: { readonly name: string }) {
  const [made, setMade] = useState<Made>();
  // An answer to other impacts or settings is another drop.
  const of = analysed.value;
  const make = (): Promise<void> =>
    linkOfDrop(name).then(
      (link) => setMade({ of, name, link }),
      (error: unknown) => setMade({ of, name, fault: faultOf(error) }),
    );
  const shown = made?.of === of && made.name === name ? made : undefined;
  return (
    <>
      <button type="button" class="quiet" onClick={() => void make()}>
        {text('page-keep-link')}
      </button>
      <div role="status" class="stack small shared">
        {shown?.link && (
          <>
            <p>
              {text('page-keep-link-by-hand')} <code>{shown.link.address}</code>
            </p>
            <QrCode {...shown.link} />
          </>
        )}
      </div>
      {shown?.fault && <FaultNotice fault={shown.fault} />}
    </>
  );
}

function QrCode({ modules, path }: Link) {
  const side = modules + 2 * MARGIN;
  return (
    <svg
      class="qr"
      viewBox={`${-MARGIN} ${-MARGIN} ${side} ${side}`}
      role="img"
      aria-label={text('page-keep-link-qr')}
      shape-rendering="crispEdges"
    >
      <rect x={-MARGIN} y={-MARGIN} width={side} height={side} fill="white" />
      <path d={path} fill="black" />
    </svg>
  );
}
