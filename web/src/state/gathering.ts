/**
 * Many drops at once: files that others saved, recordings, ZIP files of them, and links. What is damaged or
 * something else is named, the rest is kept; a drop that is in the table already is not added again.
 */
import { codesIn } from '../address/drop.ts';
import { type Diagnostic, type DropMarks, LabError, type Settings } from '../lab/index.ts';
import {
  ArchiveError,
  dropsOfList,
  filesIn,
  isArchive,
  LIST_FORMAT,
  unpack,
} from '../store/archive.ts';
import { addDrops, allDrops, type KeptDrop, soundOf } from '../store/drops.ts';
import { newId } from '../store/id.ts';
import { archiveFaultOf, keepArchived } from './archiving.ts';
import { catalogue, engine, faultOf, messageOf } from './engine.ts';
import type { Fault } from './faults.ts';
import { loadKept } from './keeping.ts';
import { askToLast } from './lasting.ts';
import { type Measured, measure, measureMarks } from './measuring.ts';
import { own } from './settings.ts';
import { stemOf, studentsOf } from './students.ts';

/** What came of it. */
export interface Gathered {
  readonly added: number;
  /** Drops that were in the table already. */
  readonly known: number;
  readonly refused: readonly Fault[];
}

/** A file, wherever it lies. */
interface Named {
  readonly path: string;
  /** In bytes, once it is unpacked. */
  readonly size: number;
  blob(): Promise<Blob>;
}

/** Something with drops in it, which is read when it is its turn. */
interface Source {
  readonly name: string;
  /** Adds those that are new; says how many, of how many, and the names of those that are no drops. */
  add(
    isNew: (drop: KeptDrop) => boolean,
    signal: AbortSignal,
  ): Promise<{ added: number; all: readonly KeptDrop[]; refused: readonly string[] }>;
}

/** Adds the drops of files and of the links in a text, until `signal`; `onSource` gets the name of what is read. */
export async function gather(
  files: readonly File[],
  pasted: string,
  onSource: (name: string) => void,
  signal: AbortSignal,
): Promise<Gathered> {
  const sounds = new Set((await allDrops()).map(({ marks }) => soundOf(marks)));
  const isNew = ({ marks }: KeptDrop): boolean => !sounds.has(soundOf(marks));
  let [added, known] = [0, 0];
  const refused: Fault[] = [];
  for await (const source of sourcesOf(files, pasted, refused)) {
    if (signal.aborted) break;
    onSource(source.name);
    try {
      const found = await source.add(isNew, signal);
      for (const name of found.refused) {
        refused.push({ key: 'bad-drop', about: `${source.name}: ${name}` });
      }
      added += found.added;
      known += found.all.length - found.added;
      for (const { marks } of found.all) sounds.add(soundOf(marks));
    } catch (error) {
      if (!signal.aborted) refused.push({ about: source.name, ...gatheringFaultOf(error) });
    }
  }
  void askToLast();
  await loadKept();
  return { added, known, refused };
}

/** What the page says of something that could not be added. */
function gatheringFaultOf(error: unknown): Fault {
  if (error instanceof NoDrop) return { key: 'no-drop' };
  if (error instanceof LabError) return faultOf(error);
  if (error instanceof ArchiveError) return archiveFaultOf(error);
  const isStorage = error instanceof DOMException;
  return isStorage ? { key: 'keep' } : { key: 'damaged', detail: messageOf(error) };
}

class NoDrop extends Error {}

async function* sourcesOf(
  files: readonly File[],
  pasted: string,
  refused: Fault[],
): AsyncGenerator<Source> {
  const named = files.map((file) => ({
    path: file.webkitRelativePath || file.name,
    size: file.size,
    blob: async () => file,
  }));
  yield* sourcesIn(named, '', 0, refused);
  yield* codesIn(pasted).map((code) => link(code, ''));
}

/** A ZIP in a ZIP is what a student saved; deeper ones are not looked into. */
const DEEPEST = 1;

/** All files are those of `owner`, if one is named. */
async function* sourcesIn(
  files: readonly Named[],
  owner: string,
  depth: number,
  refused: Fault[],
): AsyncGenerator<Source> {
  const seen = files.filter(({ path }) => !/(^|\/)(\.|__MACOSX\/|Thumbs\.db$)/.test(path));
  const students = studentsOf(seen.map(({ path }) => path));
  for (const [place, file] of seen.entries()) {
    const student = owner || (students[place] ?? '');
    try {
      yield* sourcesInFile(file, student, depth, refused);
    } catch (error) {
      refused.push({ about: file.path, ...gatheringFaultOf(error) });
    }
  }
}

async function* sourcesInFile(
  file: Named,
  student: string,
  depth: number,
  refused: Fault[],
): AsyncGenerator<Source> {
  const ending = /\.([^.]+)$/.exec(file.path.toLowerCase())?.[1] ?? '';
  if (ending === 'zip' && depth <= DEEPEST) {
    const blob = await file.blob();
    const inside = await filesIn(blob);
    // What is not in another ZIP has the name of the class, or of a copy of the table.
    const owner = depth === 0 ? '' : student;
    if (isArchive(inside)) yield archived(file.path, blob, owner);
    else yield* sourcesIn(inside, owner, depth + 1, refused);
    return;
  }
  if (ending === 'json') {
    yield listed(file, student);
  } else {
    const codes = MAY_HOLD_LINKS.has(ending) ? codesIn(await (await file.blob()).text()) : [];
    if (codes.length > 0) yield* codes.map((code) => link(code, student));
    else yield recorded(file, student);
  }
}

const MAY_HOLD_LINKS = new Set(['txt', 'csv', 'md', 'url', 'html', 'htm']);

/** What this page saved with all sounds. */
const archived = (name: string, blob: Blob, student: string): Source => ({
  name,
  add: async (isNew) => {
    const { drops, sounds, refused } = await unpack(blob);
    const theirs = drops.map((drop) => ({ ...drop, student: drop.student || student }));
    return { added: await keepArchived(theirs.filter(isNew), sounds), all: drops, refused };
  },
});

/** What this page saved as JSON: the table of drops, or one analysis; or a list of times. */
const listed = (file: Named, student: string): Source =>
  drops(file.path, async (signal) => {
    const blob = await file.blob();
    const content: unknown = JSON.parse(await blob.text());
    const { schema } = (content ?? {}) as { schema?: unknown };
    if (String(schema).startsWith(`${LIST_FORMAT}/`)) {
      const { drops, refused } = dropsOfList(content as object);
      const whose = (drop: KeptDrop): string => drop.student || student || drop.name;
      return { refused, all: drops.map((drop) => ({ ...drop, student: whose(drop) })) };
    }
    const measured = String(schema).startsWith(`${ANALYSIS}/`)
      ? await ofAnalysis(content as Analysis)
      : await measure(await engine().open({ name: file.path, blob }, { signal }), own.peek());
    return allOf(named(measured, stemOf(file.path), student));
  });

/** A recording, or a list of times. */
const recorded = (file: Named, student: string): Source =>
  drops(file.path, async (signal) => {
    const recording = await engine().open({ name: file.path, blob: await file.blob() }, { signal });
    return allOf(named(await measure(recording, own.peek()), stemOf(file.path), student));
  });

function link(code: string, student: string): Source {
  return drops(`…${code.slice(-8)}`, async () => {
    const { name, surface, settings, times_s } = await engine().linkedDrop(code);
    const measured = await measure(await engine().paste(times_s.join('\n')), settings);
    return allOf(named(measured, name, student || name, surface));
  });
}

/** What a source holds. */
interface Found {
  readonly all: readonly KeptDrop[];
  /** Names of what is no drop. */
  readonly refused: readonly string[];
}

const allOf = (all: readonly KeptDrop[]): Found => ({ all, refused: [] });

const drops = (name: string, read: (signal: AbortSignal) => Promise<Found>): Source => ({
  name,
  add: async (isNew, signal) => {
    const { all, refused } = await read(signal);
    if (all.length + refused.length === 0) throw new NoDrop(name);
    return { added: await addDrops(all.filter(isNew)), all, refused };
  },
});

/** Drops of one source, ready to be kept; several are numbered. */
function named(
  measured: readonly Measured[],
  name: string,
  student: string,
  surface = '',
): KeptDrop[] {
  return measured.map((drop, place) => ({
    ...drop,
    id: newId(),
    name: measured.length > 1 ? `${name} #${place + 1}` : name,
    keptAt: Date.now(),
    recording: null,
    student,
    surface,
  }));
}

/** The document of an analysis, as far as a drop can be analysed again by it. */
interface Analysis {
  readonly drops: readonly Omit<DropMarks, 'edited'>[];
  readonly settings: Settings & { readonly assumptions: readonly Diagnostic[] };
}

const ANALYSIS = 'bouncelab.analysis';

function ofAnalysis({ drops, settings: used }: Analysis): Promise<readonly Measured[]> {
  const { assumptions, ...all } = used;
  const { ball: _, ...others } = all;
  // The ball of the document is then only the most usual one.
  const isOpen = assumptions.some(({ code }) => code === 'ball-not-stated');
  const settings: Settings = isOpen ? others : all;
  const preset = catalogue
    .peek()
    ?.balls.find(
      ({ mass_kg, diameter_m }) =>
        mass_kg === settings.ball?.mass_kg && diameter_m === settings.ball?.diameter_m,
    );
  // Of a preset only what differs was measured: the rest is as uncertain as the preset says.
  const contact_time_s = settings.ball?.contact_time_s;
  const measured =
    contact_time_s === undefined || contact_time_s === preset?.contact_time_s
      ? {}
      : { contact_time_s };
  const stated = preset ? { ...settings, ball: { kind: preset.name, ...measured } } : settings;
  const marks = drops.map(({ impacts, probability }) => ({ impacts, probability, edited: false }));
  return marks.length === 0 ? Promise.resolve([]) : measureMarks(marks, stated);
}
