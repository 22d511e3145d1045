/**
 * Kept drops as one file: a ZIP, not compressed, of `drops.json` and a WAV for each sound,
 * `sounds/ID.wav`. docs/laboratory.md has the format.
 */
import { type KeptDrop, upToDate } from './drops.ts';
import type { StoredRecording } from './recordings.ts';
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
    /** `newer`: by a later version of the page. `damaged`: it is no archive, or not a whole one. */
    readonly kind: 'newer' | 'damaged',
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
 * Reads an archive, all of it, so that what is damaged is not added in part.
 *
 * @throws ArchiveError
 */
export async function unpack(
  file: Blob,
): Promise<{ drops: readonly KeptDrop[]; sounds: readonly ArchivedSound[] }> {
  try {
    const files = await checkedFiles(file);
    const list: unknown = JSON.parse((await files.get(LIST)?.text()) ?? '');
    const { drops, recordings } = contentsOf(list);
    const sounds = recordings.map((recording) => {
      const wav = files.get(nameOf(recording));
      if (!wav) throw new ArchiveError('damaged');
      return { recording, samples: () => samplesOf(wav) };
    });
    return { drops, sounds };
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
 * @throws ArchiveError if it has no list of them.
 */
export async function filesIn(file: Blob): Promise<readonly ZippedFile[]> {
  const { BlobReader, BlobWriter, ZipReader } = await zipped();
  const entries = await new ZipReader(new BlobReader(file), CHECKED)
    .getEntries()
    .catch((error: unknown) => {
      throw ArchiveError.of(error);
    });
  return entries.flatMap((entry) =>
    entry.directory
      ? []
      : {
          path: entry.filename,
          size: entry.uncompressedSize,
          blob: () => entry.getData(new BlobWriter()),
        },
  );
}

/** Whether it is an archive of kept drops. */
export const isArchive = (files: readonly ZippedFile[]): boolean =>
  files.some(({ path }) => path === LIST);

/** The files in a ZIP by their names. */
async function checkedFiles(file: Blob): Promise<Map<string, Blob>> {
  const files = new Map<string, Blob>();
  for (const { path, blob } of await filesIn(file)) files.set(path, await blob());
  return files;
}

/**
 * The drops of a saved list, which has no sounds.
 *
 * @throws ArchiveError
 */
export function dropsOfList({ schema, drops }: { schema?: unknown; drops?: unknown }): KeptDrop[] {
  const [format, version] = String(schema).split('/');
  if (format === LIST_FORMAT && Number(version) > LIST_VERSION) throw new ArchiveError('newer');
  if (format !== LIST_FORMAT || !isListOf(drops, isDrop)) throw new ArchiveError('damaged');
  return drops.map((drop) => ({ ...foreign(drop), recording: null }));
}

/** A drop that comes from elsewhere: what it adds to a study is found out here. */
function foreign(drop: KeptDrop): KeptDrop {
  const { comparable, ...others } = upToDate(drop);
  return others;
}

/** The list, if it is one that this version understands. */
function contentsOf(list: unknown): Contents {
  const { schema, drops, recordings } = list as { [K in 'schema' | keyof Contents]?: unknown };
  const [format, version] = String(schema).split('/');
  if (format === FORMAT && Number(version) > VERSION) throw new ArchiveError('newer');
  if (format !== FORMAT || Number(version) !== VERSION) throw new ArchiveError('damaged');
  if (!isListOf(drops, isDrop) || !isListOf(recordings, isRecording)) {
    throw new ArchiveError('damaged');
  }
  const known = new Set<string | null>([null, ...recordings.map(({ id }) => id)]);
  if (!drops.every(({ recording }) => known.has(recording))) throw new ArchiveError('damaged');
  return { drops: drops.map(foreign), recordings };
}

const isListOf = <T>(list: unknown, is: (value: unknown) => value is T): list is T[] =>
  Array.isArray(list) && list.every(is);

const isNumber = Number.isFinite;
const isText = (value: unknown): value is string => typeof value === 'string';
const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;
const isKnown = (value: unknown): boolean =>
  value === null || (isObject(value) && isNumber(value['value']));

function isRecording(value: unknown): value is StoredRecording {
  return (
    isObject(value) &&
    isText(value['id']) &&
    isText(value['name']) &&
    isNumber(value['rateHz']) &&
    isNumber(value['startedAt']) &&
    (value['gaps'] === undefined || isListOf(value['gaps'], isObject))
  );
}

/** All that the page uses without asking whether it is there. */
function isDrop(value: unknown): value is KeptDrop {
  if (!isObject(value) || !isObject(value['settings']) || !isObject(value['marks'])) return false;
  const { id, name, ball, keptAt, recording, restitution, dropHeightM, restitutions, marks } =
    value;
  return (
    [id, name, ball].every(isText) &&
    isNumber(keptAt) &&
    (recording === null || isText(recording)) &&
    [restitution, dropHeightM].every(isKnown) &&
    isListOf(restitutions, isObject) &&
    isListOf((marks as Record<string, unknown>)['impacts'], isObject)
  );
}
