/** Hands a file to the reader, through the browser's own download. */
export function save(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  // The browser reads it in its own time.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

export const saveText = (text: string, type: string, name: string): void =>
  save(new Blob([text], { type }), name);

/** A name that every system accepts as the name of a file, without its ending. */
export function fileName(name: string): string {
  const stem = name.replace(/\.[a-z0-9]{1,5}$/i, '');
  const plain = stem.replace(/[^\p{L}\p{N}_-]+/gu, '-').replace(/^-+|-+$/g, '');
  return plain === '' ? 'drop' : plain;
}

/** Draws an SVG as PNG, on white paper, twice as fine as it is. */
export async function rasterised(svg: string, width: number, height: number): Promise<Blob> {
  const SCALE = 2;
  const image = new Image();
  const address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    image.src = address;
    await image.decode();
    return await onPaper(image, Math.round(SCALE * width), Math.round(SCALE * height));
  } finally {
    URL.revokeObjectURL(address);
  }
}

function onPaper(picture: HTMLImageElement, width: number, height: number): Promise<Blob> {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d');
  if (!context) return Promise.reject(new Error('no canvas'));
  context.fillStyle = 'white';
  context.fillRect(0, 0, width, height);
  context.drawImage(picture, 0, 0, width, height);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture'))), 'image/png');
  });
}
