/** What the page and the package for other pages are built with alike. */
export const OUTPUT = {
  target: 'es2022',
  outDir: 'dist',
  emptyOutDir: true,
  // Nothing inline: the content security policy allows no data: scripts or styles.
  assetsInlineLimit: 0,
  // The size that counts is printed, and checked, by scripts/size.mjs.
  reportCompressedSize: false,
} as const;

/** Workers import the parts of the engine. */
export const WORKER = { format: 'es' } as const;
