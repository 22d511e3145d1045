/**
 * The browser's database, as promises. Two stores for sounds, so that a recording is written as it
 * comes: `recordings` says what each is, `blocks` holds the samples. `drops` holds what was kept, `jobs` the files of
 * test series, but for their recordings, which are in `sounds`.
 */

const NAME = 'bouncelab';
const VERSION = 2;

/** The stores, with what a value is found by. */
const STORES = {
  recordings: 'id',
  blocks: ['recording', 'index'],
  drops: 'id',
  jobs: 'id',
  sounds: ['job', 'file'],
} as const;
export type StoreName = keyof typeof STORES;

let opened: Promise<IDBDatabase> | undefined;

/** The next transaction opens the database again. */
function forget(): void {
  opened = undefined;
}

function open(): Promise<IDBDatabase> {
  opened ??= new Promise<IDBDatabase>((resolve, reject) => {
    const request = indexedDB.open(NAME, VERSION);
    request.onupgradeneeded = () => {
      const database = request.result;
      for (const [name, keyPath] of Object.entries(STORES)) {
        if (!database.objectStoreNames.contains(name)) {
          database.createObjectStore(name, { keyPath: keyPath as string | string[] });
        }
      }
    };
    request.onsuccess = () => {
      const database = request.result;
      // Another tab with a newer page must be able to upgrade, and the reader to clear the storage.
      database.onversionchange = () => {
        database.close();
        forget();
      };
      // The browser closed it, as when its storage is cleared or fails.
      database.onclose = forget;
      resolve(database);
    };
    request.onerror = () => reject(request.error ?? new Error('no database'));
  }).catch((error: unknown) => {
    forget();
    throw error;
  });
  return opened;
}

/**
 * Runs one transaction; resolves when it is on the disk, not before. If the database was closed, before
 * or on the way, nothing of it was done, and it is run once more.
 */
export async function transact<T>(
  stores: readonly StoreName[],
  mode: IDBTransactionMode,
  work: (transaction: IDBTransaction) => IDBRequest<T> | undefined,
): Promise<T | undefined> {
  const run = async () => attempt(await open(), stores, mode, work);
  return run().catch((error: unknown) => {
    if (!isClosed(error)) throw error;
    forget();
    return run();
  });
}

function attempt<T>(
  database: IDBDatabase,
  stores: readonly StoreName[],
  mode: IDBTransactionMode,
  work: (transaction: IDBTransaction) => IDBRequest<T> | undefined,
): Promise<T | undefined> {
  return new Promise((resolve, reject) => {
    // Browsers may call a transaction complete before the disk has it, unless durability is requested.
    const durability = mode === 'readwrite' ? 'strict' : 'default';
    const transaction = database.transaction(stores, mode, { durability });
    const request = work(transaction);
    transaction.oncomplete = () => resolve(request?.result);
    transaction.onabort = () =>
      reject(transaction.error ?? new DOMException('aborted', 'AbortError'));
  });
}

/** Adds a value, and does what goes with it, unless its id is there already. */
export function addIfNew(
  store: IDBObjectStore,
  value: { readonly id: string },
  also: () => void,
): void {
  const known = store.getKey(value.id);
  known.onsuccess = () => {
    if (known.result !== undefined) return;
    store.add(value);
    also();
  };
}

/** Every key that begins with this recording. */
export function blocksOf(recording: string): IDBKeyRange {
  return IDBKeyRange.bound([recording, 0], [recording, Number.POSITIVE_INFINITY]);
}

const named = (error: unknown, ...names: readonly string[]): boolean =>
  error instanceof DOMException && names.includes(error.name);

/** Whether an error says that the database was closed. */
const isClosed = (error: unknown): boolean => named(error, 'InvalidStateError', 'AbortError');

/** Whether an error says that the disk is full. */
export const isFull = (error: unknown): boolean => named(error, 'QuotaExceededError');
