/** The icons of the page; each stands next to its label. Drawn in the colour of the text. */
import type { ComponentChildren } from 'preact';

function Icon({ children }: { readonly children: ComponentChildren }) {
  return (
    <svg
      viewBox="0 0 16 16"
      fill="none"
      stroke="currentColor"
      stroke-width="1.5"
      stroke-linecap="round"
      stroke-linejoin="round"
      aria-hidden="true"
      focusable="false"
    >
      {children}
    </svg>
  );
}

export const HalfMoon = () => (
  <Icon>
    <path d="M13.5 9.6A6 6 0 1 1 6.4 2.5a4.8 4.8 0 0 0 7.1 7.1z" />
  </Icon>
);
export const Sun = () => (
  <Icon>
    <circle cx="8" cy="8" r="3" />
    <path d="M8 1v1.5M8 13.5V15M1 8h1.5M13.5 8H15M3 3l1 1M12 12l1 1M3 13l1-1M12 4l1-1" />
  </Icon>
);
export const Play = () => (
  <Icon>
    <path d="M4.5 2.5 13 8l-8.5 5.5z" fill="currentColor" />
  </Icon>
);
export const Pause = () => (
  <Icon>
    <path d="M4 3h8v10H4z" fill="currentColor" />
  </Icon>
);
export const Plus = () => (
  <Icon>
    <path d="M8 3v10M3 8h10" />
  </Icon>
);
export const Bin = () => (
  <Icon>
    <path d="M2.5 4.5h11M6 4.5v-2h4v2M4 4.5l.7 9h6.6l.7-9" />
  </Icon>
);
export const Back = () => (
  <Icon>
    <path d="M5.5 3 2.5 6l3 3M2.5 6h7a4 4 0 0 1 0 8H7" />
  </Icon>
);
export const Forth = () => (
  <Icon>
    <path d="m10.5 3 3 3-3 3M13.5 6h-7a4 4 0 0 0 0 8H9" />
  </Icon>
);
export const Closer = () => (
  <Icon>
    <circle cx="7" cy="7" r="4.5" />
    <path d="m10.5 10.5 4 4M5 7h4M7 5v4" />
  </Icon>
);
export const Wider = () => (
  <Icon>
    <circle cx="7" cy="7" r="4.5" />
    <path d="m10.5 10.5 4 4M5 7h4" />
  </Icon>
);
export const All = () => (
  <Icon>
    <path d="M1.5 4v8M14.5 4v8M4 8h8M6 5.5 3.5 8 6 10.5M10 5.5 12.5 8 10 10.5" />
  </Icon>
);
export const Magnet = () => (
  <Icon>
    <path d="M3 2.5v5a5 5 0 0 0 10 0v-5h-3v5a2 2 0 0 1-4 0v-5zM3 5h3M10 5h3" />
  </Icon>
);
/** A ball and the arc of its bounces. */
export const Wordmark = () => (
  <svg viewBox="0 0 24 24" aria-hidden="true" focusable="false">
    <path
      d="M2 21C3.5 9 8.500 9 10 21c1-7.500 4.500-7.500 5.500 0 .8-4.500 3-4.500 3.800 0 .5-2.500 1.700-2.500 2.200 0"
      fill="none"
      stroke="currentColor"
      stroke-width="2"
      stroke-linecap="round"
      stroke-linejoin="round"
    />
    <circle cx="6" cy="5.500" r="3.500" fill="currentColor" />
  </svg>
);
