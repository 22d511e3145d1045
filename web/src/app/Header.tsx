import { hashOf, route, VIEWS, type View } from '../address/route.ts';
import { labAddress } from '../state/settings.ts';
import { dark, forced, theme } from '../style/colours.ts';
import { choose, language, languages, nameOf, text } from '../text/language.ts';
import { HalfMoon, Sun, Wordmark } from './icons.tsx';

export function Header() {
  return (
    <header class="head">
      <div class="page">
        <a class="wordmark" href={link('lab')}>
          <Wordmark />
          bouncelab
        </a>
        <nav aria-label={text('page-app-nav')}>
          {VIEWS.map((view) => (
            <a
              key={view}
              href={link(view)}
              aria-current={route.value.view === view ? 'page' : undefined}
            >
              {text(`page-app-${view}`)}
            </a>
          ))}
        </nav>
        <div class="tools">
          <LanguageChoice />
          {!forced.value && <ThemeSwitch />}
        </div>
      </div>
    </header>
  );
}

/** The laboratory keeps its set-up in its address, also on the way back to it. */
const link = (view: View): string => (view === 'lab' ? labAddress.value : hashOf(view));

function LanguageChoice() {
  return (
    <select
      aria-label={text('page-app-language')}
      value={language.value}
      onChange={(event) => void choose(event.currentTarget.value)}
    >
      {languages.map((code) => (
        <option key={code} value={code} lang={code}>
          {nameOf(code)}
        </option>
      ))}
    </select>
  );
}

function ThemeSwitch() {
  return (
    <button
      type="button"
      onClick={() => {
        theme.value = dark.value ? 'light' : 'dark';
      }}
    >
      {dark.value ? <Sun /> : <HalfMoon />}
      {dark.value ? text('page-app-to-light') : text('page-app-to-dark')}
    </button>
  );
}
