import { inKey } from './painters.ts';
import { type ChartSpec, keyOf, type Layer } from './spec.ts';

/** Names what is not named in the picture itself. */
export function Key({ spec }: { readonly spec: ChartSpec }) {
  const named = keyOf(spec).filter(inKey);
  if (named.length < 2) return null;
  return (
    <ul class="key">
      {named.map((layer) => (
        <li key={layer.label}>
          <span class={`swatch ${layer.meaning} ${shapeOf(layer)}`} aria-hidden="true" />
          {layer.label}
        </li>
      ))}
    </ul>
  );
}

function shapeOf(layer: Layer): string {
  if (layer.kind === 'points') return layer.hollow ? 'ring' : 'dot';
  if (layer.kind === 'band') return 'band';
  return layer.kind === 'line' ? 'stroke' : 'patch';
}
