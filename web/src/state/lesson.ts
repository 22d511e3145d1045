/** The lesson that the page takes part in, and who takes part. */
import { signal } from '@preact/signals';
import { type Lesson, lessonFromParameters, lessonToParameters } from '../address/lesson.ts';
import { recall, remember } from '../address/memory.ts';
import { parseRoute } from '../address/route.ts';

/** Under which names the browser remembers them: a lesson outlives a page that was closed by mistake. */
const LESSON = 'bouncelab.lesson';
const PUPIL = 'bouncelab.pupil';

export const lesson = signal<Lesson | null>(
  lessonFromParameters(new URLSearchParams(recall(LESSON) ?? '')),
);

/** What a pupil writes of a drop. */
interface Pupil {
  readonly name: string;
  readonly surface: string;
}

const NOBODY: Pupil = { name: '', surface: '' };
const written = signal<Pupil>({ ...NOBODY, name: recall(PUPIL) ?? '' });

/** Who drops the ball and on what; nobody outside a lesson. */
export const pupil = (): Pupil => (lesson.value ? written.value : NOBODY);

export function write(changes: Partial<Pupil>): void {
  written.value = { ...written.peek(), ...changes };
  remember(PUPIL, written.peek().name || null);
}

/** Begins the lesson of the address, if it holds one. */
export function readLesson(): void {
  const { view, parameters } = parseRoute(location.hash);
  const found = view === 'lab' ? lessonFromParameters(parameters) : null;
  if (found) begin(found);
}

function begin(next: Lesson): void {
  lesson.value = next;
  remember(LESSON, lessonToParameters(next).toString());
}

export function leaveLesson(): void {
  lesson.value = null;
  remember(LESSON, null);
  remember(PUPIL, null);
}
