/**
 * Kept drops as one file: a ZIP, not compressed, of `drops.json` and a WAV for each sound,
 * `sounds/ID.wav`. docs/laboratory.md has the format.
 */
import { type KeptDrop, upToDate } from './drops.ts';
import type { StoredRecording } from './recordings.ts';
import { isDrop, isObject, isRecording, isText } from './schema.ts';
import { floatsOf } from './wav.ts';

export const FORMAT = 'bouncelab.archive';
export const VERSION = 1;
const LIST = 'drops.json';
/** The list of drops alone. */
export const LIST_FORMAT = 'bouncelab.kept-drops';
export const LIST_VERSION = 2;

const nameOf = ({ id }: StoredRecording): string => `sounds/${id}.wav`;

/** What is in the list. */
interface Contents {
  readonly drops: readonly KeptDrop[];
  readonly recordings: readonly StoredRecording[];
}

/** A sound, read when it is due. */
export interface ArchivedSound {
  readonly recording: StoredRecording;
  samples(): Promise<Float32Array<ArrayBuffer>>;
}

/** Why a file is not added. */
export class ArchiveError extends Error {
  constructor(
    /** `newer`: by a later version of the page. `damaged`: it is no archive, or not a whole one. `huge`: too much. */
    readonly kind: 'newer' | 'damaged' | 'huge',
    cause?: unknown,
  ) {
    super(kind, { cause });
  }

  /** Whatever goes wrong when a file is read. */
  static of(error: unknown): ArchiveError {
    return error instanceof ArchiveError ? error : new ArchiveError('damaged', error);
  }
}

/** What reads and writes ZIP files; it is loaded when it is needed. */
const zipped = () => import('@zip.js/zip.js/lib/zip-core-custom.js');
/** Nothing is compressed, so a second thread would have nothing to do. */
const PLAIN = { level: 0, useWebWorkers: false } as const;
const CHECKED = { checkSignature: true, useWebWorkers: false } as const;

/** Files as a ZIP; each is asked for when it is its turn. */
export async function zip(
  files: Iterable<readonly [path: string, content: () => Promise<Blob>]>,
): Promise<Blob> {
  const { BlobReader, BlobWriter, ZipWriter } = await zipped();
  const writer = new ZipWriter(new BlobWriter('application/zip'), PLAIN);
  for (const [path, content] of files) await writer.add(path, new BlobReader(await content()));
  return writer.close();
}

/** Writes an archive; each sound is asked for when it is its turn. */
export function pack(
  { drops, recordings }: Contents,
  wavOf: (recording: StoredRecording) => Promise<Blob>,
): Promise<Blob> {
  const list = { schema: `${FORMAT}/${VERSION}`, drops, recordings };
  return zip([
    [LIST, async () => new Blob([JSON.stringify(list, null, 2)])],
    ...recordings.map((recording) => [nameOf(recording), () => wavOf(recording)] as const),
  ]);
}

/**
 * Reads an archive, all of it, so that what is damaged is not added in part. `refused` are the names of drops that the
 * page could not show.
 *
 * @throws ArchiveError
 */
export async function unpack(file: Blob): Promise<{
  drops: readonly KeptDrop[];
  sounds: readonly ArchivedSound[];
  refused: readonly string[];
}> {
  try {
    const files = await checkedFiles(file);
    const list: unknown = JSON.parse((await files.get(LIST)?.text()) ?? '');
    const { drops, recordings, refused } = contentsOf(list);
    const sounds = recordings.map((recording) => {
      const wav = files.get(nameOf(recording));
      if (!wav) throw new ArchiveError('damaged');
      return { recording, samples: () => samplesOf(wav) };
    });
    return { drops, sounds, refused };
  } catch (error) {
    throw ArchiveError.of(error);
  }
}

async function samplesOf(wav: Blob): Promise<Float32Array<ArrayBuffer>> {
  try {
    return floatsOf(await wav.arrayBuffer());
  } catch (error) {
    throw ArchiveError.of(error);
  }
}

/** The most files of a ZIP, and bytes of one of them, that are read: as in the program. */
const MAX_FILES = 10_000;
const MAX_BYTES = 2 ** 28;
/** How many times as long an archive may be once it is unpacked. */
const MAX_RATIO = 16;

/** A file in a ZIP, read when it is due. */
export interface ZippedFile {
  readonly path: string;
  readonly size: number;
  /** With the checksum that the ZIP says. */
  blob(): Promise<Blob>;
}

/**
 * The files in a ZIP.
 *
 * @throws ArchiveError if it has no list of them, or too many.
 */
export async function filesIn(file: Blob): Promise<readonly ZippedFile[]> {
  const { BlobReader, ZipReader } = await zipped();
  const entries = await new ZipReader(new BlobReader(file), CHECKED)
    .getEntries()
    .catch((error: unknown) => {
      throw ArchiveError.of(error);
    });
  if (entries.length > MAX_FILES) throw new ArchiveError('huge');
  return entries.flatMap((entry) =>
    entry.directory
      ? []
      : {
          path: entry.filename,
          size: entry.uncompressedSize,
          blob: () => unpacked(entry.uncompressedSize, (to) => entry.getData(to)),
        },
  );
}

/** What is written, up to the length that the ZIP states. */
async function unpacked(
  size: number,
  write: (to: WritableStream<Uint8Array>) => Promise<unknown>,
): Promise<Blob> {
  if (size > MAX_BYTES) throw new ArchiveError('huge');
  let left = size;
  const limited = new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
    transform: (bytes, to) => {
      left -= bytes.length;
      if (left < 0) throw new ArchiveError('damaged');
      to.enqueue(bytes);
    },
  });
  const [blob] = await Promise.all([
    new Response(limited.readable).blob(),
    write(limited.writable as WritableStream<Uint8Array>),
  ]);
  return blob;
}

/** Whether it is an archive of kept drops. */
export const isArchive = (files: readonly ZippedFile[]): boolean =>
  files.some(({ path }) => path === LIST);

/** The files in a ZIP by their names. */
async function checkedFiles(file: Blob): Promise<Map<string, Blob>> {
  const files = new Map<string, Blob>();
  const inside = await filesIn(file);
  // All of them are in memory at once. The page compresses nothing, and other programs compress sound little.
  const bytes = inside.reduce((sum, { size }) => sum + size, 0);
  if (bytes > MAX_RATIO * file.size) throw new ArchiveError('huge');
  for (const { path, blob } of inside) files.set(path, await blob());
  return files;
}

/**
 * The drops of a saved list, which has no sounds, and the names of those that the page could not show.
 *
 * @throws ArchiveError
 */
export function dropsOfList({ schema, drops }: { schema?: unknown; drops?: unknown }): {
  drops: readonly KeptDrop[];
  refused: readonly string[];
} {
  const [format, version] = String(schema).split('/');
  if (format === LIST_FORMAT && Number(version) > LIST_VERSION) throw new ArchiveError('newer');
  if (format !== LIST_FORMAT || !Array.isArray(drops)) throw new ArchiveError('damaged');
  const { drops: kept, refused } = sifted(drops, () => true);
  return { drops: kept.map((drop) => ({ ...drop, recording: null })), refused };
}

/** A drop that comes from elsewhere: what it adds to a study is found out here. */
function foreign(drop: KeptDrop): KeptDrop {
  const { comparable, ...others } = upToDate(drop);
  return others;
}

/** The list, if it is one that this version understands. */
function contentsOf(list: unknown): Contents & { readonly refused: readonly string[] } {
  const { schema, drops, recordings } = list as { [K in 'schema' | keyof Contents]?: unknown };
  const [format, version] = String(schema).split('/');
  if (format === FORMAT && Number(version) > VERSION) throw new ArchiveError('newer');
  if (format !== FORMAT || Number(version) !== VERSION) throw new ArchiveError('damaged');
  if (!Array.isArray(drops) || !Array.isArray(recordings)) throw new ArchiveError('damaged');
  const sounds: readonly StoredRecording[] = recordings.filter(isRecording);
  const known = new Set<string | null>([null, ...sounds.map(({ id }) => id)]);
  return { ...sifted(drops, ({ recording }) => known.has(recording)), recordings: sounds };
}

/** Splits a list into drops that this page could have kept, and the names of the others. */
function sifted(
  drops: readonly unknown[],
  isKept: (drop: KeptDrop) => boolean,
): { drops: readonly KeptDrop[]; refused: readonly string[] } {
  const kept: KeptDrop[] = [];
  const refused: string[] = [];
  for (const [place, drop] of drops.entries()) {
    if (isDrop(drop) && isKept(drop)) kept.push(foreign(drop));
    else refused.push(nameIn(drop, place));
  }
  return { drops: kept, refused };
}

const nameIn = (drop: unknown, place: number): string =>
  isObject(drop) && isText(drop['name']) ? drop['name'] : `#${place + 1}`;
