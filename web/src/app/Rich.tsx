/** A sentence in pieces: every second piece is a number or a name, and stands out. */
export function Rich({ parts }: { readonly parts: readonly string[] }) {
  return (
    <>
      {parts.map((part, index) => (index % 2 === 1 ? <strong key={index}>{part}</strong> : part))}
    </>
  );
}
