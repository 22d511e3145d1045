import './style/tokens.css';
import './style/base.css';
import './style/layout.css';
import './style/figure.css';
import { render } from 'preact';
import { App } from './app/App.tsx';
import { workOffline } from './app/offline.ts';
import { keepAnalysed } from './state/analysing.ts';
import { start } from './state/engine.ts';
import { keepDrawn } from './state/figures.ts';
import { loadKept } from './state/keeping.ts';
import { readLesson } from './state/lesson.ts';
import { followLink } from './state/linking.ts';
import { findOrphans } from './state/orphans.ts';
import { readSettings } from './state/settings.ts';
import { keepSimulated, readSimulation } from './state/simulating.ts';
import { keepRead } from './state/sound.ts';
import { workspace } from './state/workspace.ts';
import { followTheme } from './style/colours.ts';
import { mendLanguage, preferred, speak } from './text/language.ts';

/** Not awaited by the module: scripts that are loaded later import this one, and would wait for themselves. */
async function begin(): Promise<void> {
  followTheme();
  readSettings(false);
  readSimulation();
  readLesson();
  addEventListener('hashchange', () => {
    readSettings(workspace.peek() !== null);
    readSimulation();
    readLesson();
    void followLink();
  });
  await speak(preferred());
  mendLanguage();
  const place = document.getElementById('page');
  if (place) render(<App />, place);
  keepAnalysed();
  keepDrawn();
  keepRead();
  keepSimulated();
  void start();
  void followLink();
  void loadKept();
  // Drops that another tab has kept meanwhile are shown here too.
  addEventListener('visibilitychange', () => {
    if (!document.hidden) void loadKept();
  });
  // Without the browser's database there are no unkept recordings to offer.
  void findOrphans().catch(() => undefined);
  void workOffline();
}

void begin();
