/** Whether the browser keeps its database until the reader deletes it, or only while the storage suffices. */
import { signal } from '@preact/signals';

/** `null` as long as it is not known. */
export const lasting = signal<boolean | null>(null);

/** Absent where a page is not secure. */
const storage = (): StorageManager | undefined => navigator.storage;

/** Looks, without asking for anything. */
export async function lookAtLasting(): Promise<void> {
  lasting.value =
    (await storage()
      ?.persisted()
      .catch(() => false)) ?? false;
}

let answer: Promise<boolean> | undefined;

/** Asks, when something is first kept: some browsers decide by themselves, others ask the reader. */
export async function askToLast(): Promise<void> {
  answer ??=
    storage()
      ?.persist()
      .catch(() => false) ?? Promise.resolve(false);
  lasting.value = await answer;
}
