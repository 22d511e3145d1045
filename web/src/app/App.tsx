import { useEffect, useRef, useState } from 'preact/hooks';
import { route } from '../address/route.ts';
import { phase } from '../state/bench.ts';
import { broken, catalogue } from '../state/engine.ts';
import { openFile } from '../state/opening.ts';
import { texts } from '../text/language.ts';
import { Drops } from '../views/drops/Drops.tsx';
import { Laboratory } from '../views/laboratory/Laboratory.tsx';
import { Paper } from '../views/paper/Paper.tsx';
import { Simulate } from '../views/simulate/Simulate.tsx';
import { Header } from './Header.tsx';
import { newer, takeOver } from './offline.ts';

export function App() {
  const main = useRef<HTMLElement>(null);
  const words = texts.value.app;
  const view = route.value.view;
  const first = useRef(true);

  // A new page is read from its beginning, also by a screen reader.
  // biome-ignore lint/correctness/useExhaustiveDependencies: it is about the change of page
  useEffect(() => {
    if (!first.current) {
      main.current?.focus({ preventScroll: true });
      scrollTo(0, 0);
    }
    first.current = false;
  }, [view]);

  return (
    <>
      <a
        class="skip"
        href="#main"
        onClick={(event) => {
          event.preventDefault();
          main.current?.focus();
        }}
      >
        {words.skip}
      </a>
      <Header />
      <main id="main" ref={main} tabIndex={-1}>
        <div class="page">
          <EngineTrouble />
          {view === 'lab' && <Laboratory />}
          {view === 'simulate' && <Simulate />}
          {view === 'paper' && <Paper />}
          {view === 'drops' && <Drops />}
        </div>
      </main>
      <Footer />
      <DropZone />
    </>
  );
}

function EngineTrouble() {
  const words = texts.value.app;
  if (broken.value === null) return null;
  return (
    <div class="notice" role="alert">
      <p>
        <strong>{words.engineFailed}</strong>
      </p>
      <p>{words.engineFailedHint}</p>
      <p class="small soft" lang="en">
        {broken.value}
      </p>
    </div>
  );
}

function Footer() {
  const words = texts.value.app;
  const version = catalogue.value?.version;
  return (
    <footer class="foot">
      <div class="page">
        <span>{words.privacy}</span>
        {version !== undefined && <span>{words.version(version)}</span>}
        {newer.value && (
          <span role="status">
            {words.newer}{' '}
            <button type="button" class="quiet slim" onClick={takeOver}>
              {words.reload}
            </button>
          </span>
        )}
      </div>
    </footer>
  );
}

/** A file that is dragged anywhere over the page may be dropped anywhere. */
function DropZone() {
  const [over, setOver] = useState(false);
  useEffect(() => {
    const listeners = new AbortController();
    const { signal } = listeners;
    const hasFile = (event: DragEvent): boolean =>
      event.dataTransfer?.types.includes('Files') ?? false;
    const busy = (): boolean => !['empty', 'ready'].includes(phase.peek().kind);
    addEventListener(
      'dragover',
      (event) => {
        if (!hasFile(event)) return;
        event.preventDefault();
        setOver(!busy());
      },
      { signal },
    );
    addEventListener(
      'dragleave',
      (event) => {
        if (event.relatedTarget === null) setOver(false);
      },
      { signal },
    );
    addEventListener(
      'drop',
      (event) => {
        if (!hasFile(event)) return;
        event.preventDefault();
        setOver(false);
        const file = event.dataTransfer?.files[0];
        if (!file || busy()) return;
        location.hash = '#lab';
        void openFile(file);
      },
      { signal },
    );
    return () => listeners.abort();
  }, []);
  return over ? <div class="drop-here">{texts.value.app.dropHere}</div> : null;
}
