/** Sounds that a page uses: another page in the same browser neither offers nor deletes them. */

const PREFIX = 'bouncelab.sound.';

/** Absent where a page is not secure. */
const locks = (): LockManager | undefined => navigator.locks;

/** Holds a sound until this page is closed, or breaks down. */
export function lock(recording: string): void {
  void locks()?.request(PREFIX + recording, () => new Promise(() => undefined));
}

/** Sounds that some page uses, this one included. */
export async function locked(): Promise<ReadonlySet<string>> {
  const { held = [] } = (await locks()?.query()) ?? {};
  return new Set(held.map(({ name = '' }) => name.replace(PREFIX, '')));
}
