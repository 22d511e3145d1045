import type english from './languages/en.ts';

/** The shape of a language: that of English, whatever the words are. */
export type Texts = Widened<typeof english>;

type Widened<T> = T extends string
  ? string
  : T extends (...parameters: infer P) => infer R
    ? (...parameters: P) => Widened<R>
    : T extends readonly (infer U)[]
      ? readonly Widened<U>[]
      : { readonly [K in keyof T]: Widened<T[K]> };
