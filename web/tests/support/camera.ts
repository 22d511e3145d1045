/** What a camera sees: the QR codes that pages show, one after another. */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { folder } from '../harness/program.ts';

const [WIDTH, HEIGHT] = [640, 480];

/** Pictures a second, and for how many of them a code is seen. */
const [RATE, HELD] = [5, 5];

/** The grey levels of a picture of the code that a page shows, row by row. */
export const seen = (page: Page): Promise<number[]> =>
  page.locator('.shared .qr').evaluate(
    async (svg, [width, height]) => {
      const source = new XMLSerializer().serializeToString(svg);
      const image = new Image();
      image.src = URL.createObjectURL(new Blob([source], { type: 'image/svg+xml' }));
      await image.decode();
      const canvas = document.createElement('canvas');
      Object.assign(canvas, { width, height });
      const context = canvas.getContext('2d') as CanvasRenderingContext2D;
      context.fillStyle = 'silver';
      context.fillRect(0, 0, width, height);
      context.drawImage(image, 100, 20, 440, 440);
      const { data } = context.getImageData(0, 0, width, height);
      return Array.from({ length: width * height }, (_, at) => data[4 * at] ?? 0);
    },
    [WIDTH, HEIGHT] as const,
  );

/** A film of these pictures in the plain format Y4M, which a browser plays over and over again. */
export function film(pictures: readonly (readonly number[])[]): string {
  // Limited range, and colours without colour.
  const chroma = Buffer.alloc((WIDTH * HEIGHT) / 2, 128);
  const frames = pictures.flatMap((grey) => {
    const luma = Buffer.from(grey.map((level) => Math.round(16 + (level * 219) / 255)));
    return Array.from({ length: HELD }, () => [Buffer.from('FRAME\n'), luma, chroma]).flat();
  });
  const head = Buffer.from(`YUV4MPEG2 W${WIDTH} H${HEIGHT} F${RATE}:1 Ip A1:1 C420jpeg\n`);
  const path = join(folder(), 'camera.y4m');
  writeFileSync(path, Buffer.concat([head, ...frames]));
  return path;
}
