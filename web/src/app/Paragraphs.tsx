/** A text of several paragraphs. */
export function Paragraphs({ of }: { readonly of: readonly string[] }) {
  return (
    <>
      {of.map((paragraph) => (
        <p key={paragraph}>{paragraph}</p>
      ))}
    </>
  );
}
