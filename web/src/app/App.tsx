import { useEffect, useRef, useState } from 'preact/hooks';
import { route } from '../address/route.ts';
import { stop } from '../sound/player.ts';
import { broken, catalogue } from '../state/engine.ts';
import { rescue } from '../state/keeping.ts';
import { openFile } from '../state/opening.ts';
import { goToLab } from '../state/settings.ts';
import { busy } from '../state/workspace.ts';
import { text } from '../text/language.ts';
import { Laboratory } from '../views/laboratory/Laboratory.tsx';
import { Header } from './Header.tsx';
import { later } from './later.tsx';
import { newer, takeOver } from './offline.ts';

const Simulate = later(async () => (await import('../views/simulate/Simulate.tsx')).Simulate);
const Paper = later(async () => (await import('../views/paper/Paper.tsx')).Paper);
const Series = later(async () => (await import('../views/series/Series.tsx')).Series);
const Drops = later(async () => (await import('../views/drops/Drops.tsx')).Drops);

export function App() {
  const main = useRef<HTMLElement>(null);
  const view = route.value.view;
  const first = useRef(true);

  // A new page is read from its beginning, also by a screen reader; what the last one plays ends.
  useEffect(() => {
    if (!first.current) {
      stop();
      main.current?.focus({ preventScroll: true });
      scrollTo(0, 0);
    }
    first.current = false;
  }, [view]);

  return (
    <>
      <button type="button" class="skip" onClick={() => main.current?.focus()}>
        {text('page-app-skip')}
      </button>
      <Header />
      <main id="main" ref={main} tabIndex={-1}>
        <div class="page">
          <Newer />
          <EngineTrouble />
          {view === 'lab' && <Laboratory />}
          {view === 'simulate' && <Simulate />}
          {view === 'paper' && <Paper />}
          {view === 'drops' && <Drops />}
          {view === 'series' && <Series />}
        </div>
      </main>
      <Footer />
      <DropZone />
    </>
  );
}

function EngineTrouble() {
  if (broken.value === null) return null;
  return (
    <div class="notice" role="alert">
      <p>
        <strong>{text('page-app-engine-failed')}</strong>
      </p>
      <p>{text('page-app-engine-failed-hint')}</p>
      <p class="small soft" lang="en">
        {broken.value}
      </p>
    </div>
  );
}

/** A newer page waits; what is open is kept. */
function Newer() {
  const [leaving, setLeaving] = useState(false);
  if (!newer.value || busy.value) return null;
  return (
    <p class="notice no-print" role="status">
      {text('page-app-newer')}{' '}
      <button
        type="button"
        class="quiet slim"
        disabled={leaving}
        onClick={() => {
          setLeaving(true);
          void rescue().then(takeOver);
        }}
      >
        {text('page-app-reload')}
      </button>
    </p>
  );
}

/** The book, where it lies beside the page and `index.html` says so. */
const book = document.querySelector<HTMLLinkElement>('link[rel=help]')?.href;

function Footer() {
  const version = catalogue.value?.version;
  return (
    <footer class="foot">
      <div class="page">
        <span>{text('page-app-privacy')}</span>
        {version !== undefined && <span>{text('page-app-version', { version })}</span>}
        {book !== undefined && <a href={book}>{text('page-app-book')}</a>}
      </div>
    </footer>
  );
}

async function gather(files: readonly File[]): Promise<void> {
  const { gatherHere } = await import('../views/drops/Gather.tsx');
  await gatherHere(files);
}

async function addToSeries(files: readonly File[]): Promise<void> {
  const { addFiles } = await import('../state/series.ts');
  await addFiles(files);
}

/** A file that is dragged anywhere over the page may be dropped anywhere. */
function DropZone() {
  const [over, setOver] = useState(false);
  useEffect(() => {
    const listeners = new AbortController();
    const on = <K extends keyof WindowEventMap>(
      kind: K,
      listener: (event: WindowEventMap[K]) => void,
    ): void => globalThis.addEventListener(kind, listener, { signal: listeners.signal });
    const hasFile = (event: DragEvent): boolean =>
      event.dataTransfer?.types.includes('Files') ?? false;
    on('dragover', (event) => {
      if (!hasFile(event)) return;
      event.preventDefault();
      setOver(!busy.peek());
    });
    on('dragleave', (event) => {
      if (event.relatedTarget === null) setOver(false);
    });
    on('drop', (event) => {
      if (!hasFile(event)) return;
      event.preventDefault();
      setOver(false);
      const [file, ...others] = event.dataTransfer?.files ?? [];
      if (!file || busy.peek()) return;
      const { view } = route.peek();
      if (view === 'drops') return void gather([file, ...others]);
      if (view === 'series') return void addToSeries([file, ...others]);
      goToLab();
      void openFile(file);
    });
    return () => listeners.abort();
  }, []);
  return over ? <div class="drop-here">{text('page-app-drop-here')}</div> : null;
}
