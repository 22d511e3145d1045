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

/** How often a transaction is run at most: the browser closes the database more than once while it clears its storage. */
const MAX_ATTEMPTS = 4;

/**
 * Runs one transaction; resolves when it is on the disk, not before. If the database was closed, before
 * or on the way, it is run again: doing it twice must be as doing it once.
 */
export async function transact<T>(
  stores: readonly StoreName[],
  mode: IDBTransactionMode,
  work: (transaction: IDBTransaction) => IDBRequest<T> | undefined,
): Promise<T | undefined> {
  for (let number = 1; ; number += 1) {
    try {
      return await attempt(await open(), stores, mode, work);
    } catch (error) {
      if (!isClosed(error) || number === MAX_ATTEMPTS) throw error;
      forget();
    }
  }
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
    // A browser that clears its storage may close the database without a word to the transactions in it.
    const closed = () => reject(new DOMException('closed', 'AbortError'));
    database.addEventListener('close', closed);
    const end = (settle: () => void) => () => {
      database.removeEventListener('close', closed);
      settle();
    };
    transaction.oncomplete = end(() => resolve(request?.result));
    transaction.onabort = end(() =>
      reject(transaction.error ?? new DOMException('aborted', 'AbortError')),
    );
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

/** Whether an error says that the database was closed; Chromium calls it unknown when all storage is cleared. */
const isClosed = (error: unknown): boolean =>
  named(error, 'InvalidStateError', 'AbortError', 'UnknownError');

/** Whether an error says that the disk is full. */
export const isFull = (error: unknown): boolean => named(error, 'QuotaExceededError');
