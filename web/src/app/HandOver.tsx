import { useState } from 'preact/hooks';
import type { DropLink } from '../lab/index.ts';
import { text } from '../text/language.ts';

/** Modules that stay white around a QR code. */
const MARGIN = 4;

/** A link for other people: the share sheet of the device, a copy, a QR code, and the address itself. */
export function HandOver({ link, label }: { readonly link: DropLink; readonly label: string }) {
  const [copied, setCopied] = useState('');
  const { address } = link;
  const copy = async (): Promise<void> => {
    const isCopied = await navigator.clipboard?.writeText(address).then(
      () => true,
      () => false,
    );
    setCopied(isCopied ? address : '');
  };
  return (
    <div class="stack small shared">
      <div class="row tight">
        {'share' in navigator && (
          <button
            type="button"
            class="button"
            // To call it off is no error.
            onClick={() => void navigator.share({ url: address }).catch(() => undefined)}
          >
            {text('page-hand-share')}
          </button>
        )}
        <button type="button" class="button" onClick={() => void copy()}>
          {text('page-hand-copy')}
        </button>
        <span role="status">{copied === address && text('page-hand-copied')}</span>
      </div>
      <QrCode {...link} label={label} />
      <code>{address}</code>
    </div>
  );
}

function QrCode({ modules, path, label }: DropLink & { readonly label: string }) {
  const side = modules + 2 * MARGIN;
  return (
    <svg
      class="qr"
      viewBox={`${-MARGIN} ${-MARGIN} ${side} ${side}`}
      role="img"
      aria-label={label}
      shape-rendering="crispEdges"
    >
      <rect x={-MARGIN} y={-MARGIN} width={side} height={side} fill="white" />
      <path d={path} fill="black" />
    </svg>
  );
}
