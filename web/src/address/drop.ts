/** Drops as part of addresses, which the engine writes and reads. */

/** The parameter with the drop. */
export const DROP = 'drop';

/** The drops of all addresses in a text, each once. */
export const codesIn = (text: string): readonly string[] => [
  ...new Set(Array.from(text.matchAll(/[?&]drop=([\w-]+)/g), ([, code = '']) => code)),
];
