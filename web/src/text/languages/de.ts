import type {
  LabReason,
  LayoutProblem,
  LooksLike,
  MissingContent,
  Stage,
  TimesProblem,
} from '../../lab/index.ts';
import type { Texts } from '../texts.ts';

const zahl = (anzahl: number, eins: string, viele: string): string => (anzahl === 1 ? eins : viele);

const FEHLT: Record<MissingContent, string> = {
  content: 'Kein einziges Byte Ton ist darin.',
  sound: 'Sie hat einen Kopf, aber keinen Ton.',
  time: 'Es steht keine Zeit darin.',
};

const SIEHT_AUS: Record<LooksLike, string> = {
  png: 'ein PNG-Bild',
  jpeg: 'ein JPEG-Bild',
  gif: 'ein GIF-Bild',
  pdf: 'ein PDF-Dokument',
  zip: 'ein ZIP-Archiv oder ein Office-Dokument',
  gzip: 'ein gzip-Archiv',
  riff: 'eine RIFF-Datei ohne Ton, etwa AVI oder WebP',
  caf: 'eine Aufnahme in Core Audio (CAF), das nicht gelesen wird: Speichere sie als WAV oder M4A',
  zeros: 'lauter Nullen',
  text: 'Text',
  unknown: 'Daten unbekannter Art',
};

const SCHRITT: Record<Stage, string> = {
  header: 'Ihr Kopf ist nicht lesbar',
  codec: 'Ihr Decoder lässt sich nicht einrichten',
  sound: 'Nichts von ihrem Ton lässt sich decodieren',
};

function zeitenfehler(fehler: TimesProblem): string {
  switch (fehler.code) {
    case 'ending':
      return 'Der Name einer Liste endet auf .txt, .csv oder .json.';
    case 'not-text':
      return 'Das ist kein Text. Speichere die Liste als UTF-8.';
    case 'not-table':
      return `Das ist keine Tabelle (${fehler.detail}).`;
    case 'not-array':
      return `Erwartet war eine Liste von Zahlen wie [0.1, 0.45] (${fehler.detail}).`;
    case 'no-time-column':
      return `Keine Spalte heißt time oder time_s. Es gibt: ${fehler.found}.`;
    case 'nameless-columns':
      return `Es sind ${fehler.columns} Spalten. Benenne die mit den Zeiten in einer ersten Zeile: time_s.`;
    case 'missing':
      return 'Die Zeit fehlt.';
    case 'not-number':
      return `„${fehler.text}“ ist keine Zeit in Sekunden wie 0.125.`;
    case 'not-later':
      return `${komma(fehler.time_s)} kommt nicht nach ${komma(fehler.before_s)}. Die Aufpralle gehören der Reihe nach.`;
  }
}

function tonfehler(fehler: LayoutProblem): string {
  switch (fehler.code) {
    case 'too-slow':
      return `${fehler.sample_rate_hz} Abtastwerte je Sekunde sind zu wenige für die Zeit eines Aufpralls: Es braucht mindestens ${fehler.least_hz}.`;
    case 'too-fast':
      return `Ihr Kopf behauptet ${fehler.sample_rate_hz} Abtastwerte je Sekunde; gelesen werden höchstens ${fehler.most_hz}.`;
    case 'too-many-channels':
      return `Sie hat ${fehler.channels} Kanäle; gelesen werden höchstens ${fehler.most}.`;
  }
}

/** Was genau mit einer Datei nicht stimmt. */
function grund(fund: LabReason): string {
  switch (fund.code) {
    case 'empty':
      return FEHLT[fund.what];
    case 'not-sound':
      return `Sie sieht aus wie ${SIEHT_AUS[fund.looks_like]}.`;
    case 'malformed':
      return `${SCHRITT[fund.stage]} (${fund.format}: ${fund.detail}).`;
    case 'no-audio-track':
      return `Diese Datei (${fund.format}) hat keinen Ton, oder keinen bekannter Art. War das Mikrofon aus?`;
    case 'unsupported-codec':
      return `Der Ton dieser Datei (${fund.format}) lässt sich nicht decodieren: ${fund.codec}. Speichere sie als WAV oder M4A.`;
    case 'unsupported-layout':
      return tonfehler(fund.problem);
    case 'times':
      return `${fund.line === null ? '' : `Zeile ${fund.line}: `}${zeitenfehler(fund.problem)}`;
    case 'too-large':
      return `Sie hat ${fund.megabytes} MB.`;
    case 'too-long':
      return `Sie hat mehr als ${fund.minutes} Minuten in ${fund.channels} ${zahl(fund.channels, 'Kanal', 'Kanälen')}.`;
    case 'no-memory':
      return 'Dieses Gerät hat nicht genug Speicher dafür.';
    case 'breaks-decoder':
      return 'Sie ist so beschädigt, dass ihr Decoder daran zerbricht.';
    case 'unreadable':
      return 'Der Browser kann sie nicht lesen. Wurde sie verschoben oder gelöscht?';
  }
}

/** Eine Zahl, wie man sie im Deutschen schreibt. */
const komma = (zahl: number): string => String(zahl).replace('.', ',');

const deutsch: Texts = {
  to: 'bis',
  app: {
    title: 'bouncelab: Ball fallen lassen, Physik hören',
    skip: 'Zum Inhalt springen',
    nav: 'Seiten',
    lab: 'Zuhören',
    simulate: 'Simulieren',
    paper: 'Aufsatz',
    drops: 'Versuche',
    language: 'Sprache',
    toDark: 'Dunkel',
    toLight: 'Hell',
    privacy: 'Nichts verlässt dieses Gerät: kein Konto, kein Server, läuft auch ohne Netz.',
    version: (version) => `bouncelab ${version}`,
    engineFailed: 'Das Labor konnte nicht starten.',
    engineFailedHint:
      'Der Browser hat den WebAssembly-Teil nicht geladen oder nicht ausgeführt. Lade die Seite neu; hilft das nicht, nimm einen aktuellen Firefox, Chrome, Edge oder Safari.',
    newer: 'Eine neuere Fassung dieser Seite liegt bereit.',
    reload: 'Neu laden',
    undo: 'Rückgängig',
    redo: 'Wiederholen',
    cancel: 'Abbrechen',
    why: 'Warum?',
    numberWanted: (least, most) =>
      `Hier wird eine Zahl${most ? ` von ${least} bis ${most}` : least && ` ab ${least}`} erwartet.`,
    dropHere: 'Loslassen, dann wird zugehört',
    unreadableLink: (parts) =>
      `Einiges an den Einstellungen in der Adresse war nicht zu verstehen und bleibt weg: ${parts}.`,
  },
  lab: {
    invite: 'Lass einen Ball neben dem Mikrofon fallen.',
    inviteTouch: 'Lass einen Ball neben dem Handy fallen.',
    listen: 'Zuhören',
    stop: 'Stopp',
    again: 'Noch einmal zuhören',
    open: 'Datei öffnen',
    paste: 'Zeiten einfügen',
    demo: 'Beispiel ansehen',
    openLabel: 'Aufnahme oder Liste von Aufprallzeiten',
    pasteLabel: 'Aufprallzeiten in Sekunden, eine je Zeile',
    pasteHint:
      'Aus einer Tabelle, vom Oszilloskop oder nach Gehör. Was dazwischen liegt, sind die Flüge.',
    pasteDo: 'Auswerten',
    pastedName: 'eingefügte Zeiten',
    demoName: 'Beispiel',
    recordingName: (date) => `Versuch ${date}`,
    starting: 'Frage nach dem Mikrofon …',
    listening: 'Ich höre zu. Lass den Ball fallen.',
    soFar: (count) => `${count} ${zahl(count, 'Aufprall', 'Aufpralle')} bisher`,
    soFarKeeps: (share) => `er behält etwa ${share} seines Tempos`,
    endsItself: 'Es endet von selbst, wenn der Ball ruht.',
    result: 'Ergebnis',
    opening: (name) => `Lese ${name} …`,
    kept: (share) => ['Der Ball behielt bei jedem Aufprall ', share, ' seines Tempos.'],
    fell: (height) => ['Er fiel aus ', height, ' Höhe.'],
    cannotTell: 'Das sind zu wenige Aufpralle, um zu sagen, wie gut der Ball springt.',
    impacts: (count) => `${count} ${zahl(count, 'Aufprall', 'Aufpralle')}`,
    uncertain: (count) => `${count} unsicher`,
    edited: 'von Hand geändert',
    dropOf: (index, count) => `Versuch ${index} von ${count}`,
    dropsHeard: 'Versuche in dieser Aufnahme',
    airExplains: (points) =>
      `Der Luftwiderstand erklärt ${points} Prozentpunkte dessen, was eine Ausgleichsgerade für verlorene Sprungkraft hielte.`,
    lineHeight: (height) => `Die Fallhöhe wäre nach dieser Geraden ${height}.`,
    airNothing: 'Der Luftwiderstand macht hier fast nichts aus: Die Gerade sagt dasselbe.',
    whyAir: [
      'Eine Gerade durch die Logarithmen der Flugzeiten ist der klassische Weg zur Sprungkraft. Doch auch die Luft bremst den Ball, und die Gerade hält das für Verlust beim Aufprall.',
      'Die grauen Punkte lassen die Luft weg; die blauen rechnen sie heraus. Was bleibt, sind Ball und Untergrund.',
    ],
    refining: 'Wäge ab, was Luft und Ball vermögen …',
    more: 'Alle Zahlen',
    tells: 'Was diese Stille sagen kann, und was nicht',
    narrowedLead: 'Wie weit der Ton eingegrenzt hat, was man vorher schon wusste:',
    narrowed: (unknown, share) => `${unknown}: ${share} der Breite bleiben`,
    assumed: 'angenommen',
    noDropTitle: 'Kein springender Ball gehört.',
    noDropHint:
      'Stell das Mikrofon nah an die Stelle, wo der Ball aufkommt, nimm einen harten Untergrund und lass den Ball ausspringen. Siehst du die Aufpralle im Bild, dann markiere sie von Hand: Doppelklick, oder Eingabetaste am Zeiger.',
    interruptedTitle: (date) => `Eine Aufnahme vom ${date} wurde unterbrochen.`,
    progress: 'Wie weit es ist',
    unkeptTitle: (date) => `Die Aufnahme vom ${date} steht nicht in der Tabelle der Versuche.`,
    interruptedHint: 'Nichts davon ist verloren.',
    interruptedOpen: 'Öffnen',
    interruptedDrop: 'Wegwerfen',
  },
  words: {
    restitution:
      'Die Stoßzahl ist das Tempo gleich nach einem Aufprall geteilt durch das Tempo gleich davor.',
  },
  reason: grund,
  faults: {
    refused: {
      what: 'Der Browser darf das Mikrofon nicht benutzen.',
      do: 'Erlaube es in der Adressleiste (Schloss oder Mikrofon) und tippe noch einmal auf „Zuhören“. Auf dem Handy sieh auch in den Einstellungen der Browser-App nach. Du kannst stattdessen eine Aufnahme öffnen.',
    },
    missing: {
      what: 'Kein Mikrofon gefunden.',
      do: 'Stecke eines an und tippe noch einmal auf „Zuhören“, oder nimm mit einem anderen Gerät auf und öffne die Datei hier.',
    },
    busy: {
      what: 'Ein anderes Programm benutzt das Mikrofon.',
      do: 'Beende Anrufe und Aufnahmen und tippe noch einmal auf „Zuhören“.',
    },
    insecure: {
      what: 'Browser geben das Mikrofon nur Seiten mit https oder von diesem Rechner selbst.',
      do: 'Öffne die Seite über https oder localhost. Aufnahmen lassen sich auch so öffnen.',
    },
    unsupported: {
      what: 'Dieser Browser gibt keinen unbearbeiteten Ton heraus.',
      do: 'Nimm einen aktuellen Firefox, Chrome, Edge oder Safari, oder öffne eine Aufnahme.',
    },
    ended: {
      what: 'Das Mikrofon ist weg: ausgesteckt, oder ein Anruf braucht es.',
      do: 'Was bis dahin zu hören war, ist aufgehoben und ausgewertet.',
    },
    unknown: {
      what: 'Das Mikrofon ließ sich nicht öffnen.',
      do: 'Stecke es neu an oder starte den Browser neu. Du kannst stattdessen eine Aufnahme öffnen.',
    },
    silent: {
      what: 'Vom Mikrofon kommt nur Stille.',
      do: 'Vielleicht ist es am Schalter oder in den Systemeinstellungen stumm.',
    },
    full: {
      what: 'Der Speicher des Browsers ist voll.',
      do: 'Der Ton ist vollständig im Arbeitsspeicher: Speichere ihn jetzt als WAV. Lösche danach Versuche, die du nicht brauchst.',
    },
    unavailable: {
      what: 'Der Browser hebt hier nichts auf (ein privates Fenster?).',
      do: 'Der Ton ist vollständig im Arbeitsspeicher, bis diese Seite geschlossen wird: Speichere ihn als WAV.',
    },
    empty: {
      what: 'Die Datei ist leer.',
      do: 'Es wurde nichts hineingeschrieben. Endete die Aufnahme, bevor sie begann? Nimm neu auf oder wähle eine andere Datei.',
    },
    'unsupported-file': {
      what: 'Das ist weder eine Aufnahme noch eine Liste von Zeiten.',
      do: 'Ton: WAV, AIFF, FLAC, MP3, Ogg, Opus, WebM, M4A, MP4, MOV. Listen: eine Zeit in Sekunden je Zeile.',
    },
    damaged: {
      what: 'Die Datei ist beschädigt.',
      do: 'Kopiere oder lade sie neu. Eine Datei, an der das Handy noch schreibt, ist noch nicht lesbar.',
    },
    times: {
      what: 'Diese Zeiten ergeben als Aufpralle keinen Sinn.',
      do: 'Eine Zeit in Sekunden je Zeile, aufsteigend; Komma oder Punkt für Nachkommastellen.',
    },
    huge: {
      what: 'Die Datei ist zu groß für einen Browser.',
      do: 'Bis 500 MB und etwa vierzig Minuten Ton. Schneide sie auf die Minuten mit dem Ball, oder nimm die Kommandozeile: bouncelab analyze.',
    },
    setting: {
      what: 'Eine Einstellung passt nicht zu den anderen.',
      do: 'Siehe unten bei den Einstellungen.',
    },
    fault: {
      what: 'Darüber ist das Labor gestolpert.',
      do: 'Was aufgenommen wurde, ist aufgehoben. Lade die Seite neu und öffne es wieder; eine Meldung an das Projekt hilft.',
    },
    keep: {
      what: 'Der Versuch ließ sich nicht aufheben.',
      do: 'Der Speicher des Browsers ist voll oder gesperrt. Speichere stattdessen Ton und Zahlen als Dateien.',
    },
  },
  wave: {
    title: 'Schallbild',
    label: 'Schallbild, Ort des Zeigers',
    seconds: (value) => `${value} Sekunden`,
    impactAt: (number, seconds, certain) =>
      `Aufprall ${number}, ${seconds}${certain ? '' : ', unsicher'}`,
    add: 'Aufprall setzen',
    remove: 'Entfernen',
    snap: 'Am Ton einrasten',
    zoomIn: 'Näher',
    zoomOut: 'Weiter',
    all: 'Alles',
    play: 'Anhören',
    stop: 'Stopp',
    speed: 'Tempo',
    slower: (speed) => `${speed} ×`,
    spectrogram: 'Spektrogramm',
    spectrogramLabel: 'Spektrogramm: Zeit nach rechts, Tonhöhe nach oben, lauter ist dunkler',
    overview: 'Die ganze Aufnahme; ziehen verschiebt',
    restore: 'Wie gehört',
    list: 'Liste der Aufpralle',
    number: 'Nr.',
    time: 'Zeit',
    flight: 'Flug danach',
    probability: 'Sicher',
    level: 'Pegel',
    restitution: 'Stoßzahl',
    actions: 'Ändern',
    removeOne: (number) => `Aufprall ${number} entfernen`,
    select: (number) => `Aufprall ${number} zeigen`,
    added: (seconds) => `Aufprall bei ${seconds} s gesetzt.`,
    removed: (number) => `Aufprall ${number} entfernt.`,
    moved: (number, seconds) => `Aufprall ${number} auf ${seconds} s verschoben.`,
    undone: 'Rückgängig gemacht.',
    redone: 'Wiederholt.',
    keys: 'Pfeiltasten bewegen den Zeiger, mit Umschalttaste fein; Bild auf und Bild ab gehen von Aufprall zu Aufprall; Plus und Minus vergrößern und verkleinern, 0 zeigt alles; Eingabe setzt einen Aufprall, Entf entfernt den gewählten, Komma und Punkt schieben ihn, S rastet ihn am Ton ein; Leertaste spielt ab; Strg+Z macht rückgängig.',
    pointer:
      'Ziehen verschiebt, Spreizen oder Mausrad vergrößert (vorher anklicken), Tippen wählt einen Aufprall, Ziehen bewegt ihn, Doppeltippen setzt einen neuen.',
    times: 'Das sind nur Zeiten: Es gibt keinen Ton zu zeigen.',
  },
  figures: {
    title: 'Abbildungen',
    against: (y, x) => `${y} über ${x}`,
    reset: 'Seitwärts ziehen vergrößert, ein Doppelklick zeigt wieder alles.',
    numbers: 'Dasselbe als Zahlen',
    saveSvg: 'SVG',
    savePng: 'PNG',
    save: 'Diese Abbildung speichern',
    // By the names of the engine.
    tabs: {
      restitution: 'Stoßzahl',
      'flight-times': 'Flüge',
      height: 'Höhe',
      'bounce-heights': 'Höhen',
      'bounce-energies': 'Energie',
      comparison: 'Vergleich',
      posterior: 'Antwort',
      residuals: 'Abweichung',
      budget: 'Unsicherheit',
      models: 'Gesetze',
      truncation: 'Flugzahl',
      drag: 'Luft',
      'drag-log': 'Luft (log.)',
    },
  },
  quantities: {
    restitution: 'Stoßzahl e',
    atSpeed: (speed) => `bei ${speed}`,
    slope: 'Fällt mit dem Tempo um (−d ln e / d ln v)',
    dropHeight: 'Fallhöhe',
    drag: 'Widerstands\u00adbeiwert',
    terminal: 'End\u00adgeschwindigkeit',
    totalTime: 'Vom Loslassen bis zur Ruhe',
    totalPath: 'Weg bis zur Ruhe',
    scatter: 'Streuung von Aufprall zu Aufprall',
    timing: 'Fehler der Zeiten',
    contact: 'Kontaktzeit',
    lineRestitution: 'Gerade: e',
    lineHeight: 'Gerade: Fallhöhe',
    lineFlights: 'Gerade: Flüge',
    energyKept: 'Gerade: behaltene Energie',
    corrected: 'Jeder Aufprall ohne Luft, Median von e',
    interval: (range) => `95 %: ${range}`,
  },
  settings: {
    ball: 'Ball',
    air: 'Luft',
    gravity: 'g',
    change: 'ändern',
    title: 'Was bekannt ist',
    assumedHint: 'Was niemand angegeben hat, ist angenommen und so gekennzeichnet.',
    own: 'eigener Ball',
    mass: 'Masse',
    diameter: 'Durchmesser',
    contact: 'Kontaktzeit',
    temperature: 'Temperatur',
    pressure: 'Druck',
    humidity: 'Feuchte',
    vacuum: 'Vakuum',
    noDrag: 'ohne Luft',
    gravityField: 'Fallbeschleunigung',
    latitude: 'Breite',
    altitude: 'Höhe über dem Meer',
    dragLaw: 'Luftwiderstand',
    dragNone: 'keiner, als gäbe es keine Luft',
    dragConstant: 'gleichbleibend, C_D = 0,4',
    restitutionLaw: 'Stoßzahl',
    restitutionAny: 'jedes Gesetz, das passt',
    laws: {
      constant: 'bei jedem Tempo gleich',
      linear: 'Gerade im Tempo',
      power: 'Potenzgesetz',
      viscoelastic: 'viskoelastisch',
      knee: 'gleich bis zu einem Knick',
    },
    measured: 'Der Versuch, falls gemessen',
    height: 'Fallhöhe',
    heightSd: '± der Höhe',
    flights: 'Flüge in der Geraden',
    flightsFrom: 'von',
    flightsTo: 'bis',
    reset: 'Alle Einstellungen vergessen',
    refused: 'Diese Einstellungen passen nicht zusammen:',
    balls: {
      'table-tennis-40': 'Tischtennis 40+',
      'table-tennis-38': 'Tischtennis 38 mm',
      tennis: 'Tennis',
      football: 'Fußball',
      basketball: 'Basketball',
      golf: 'Golf',
      squash: 'Squash',
      racquetball: 'Racquetball',
      pickleball: 'Pickleball',
      padel: 'Padel',
    },
  },
  keep: {
    title: 'Aufheben',
    keep: 'Diesen Versuch aufheben',
    kept: (name) => `Aufgehoben als „${name}“.`,
    name: 'Name',
    nameHint: 'zum Beispiel: Anna, erster Versuch',
    seeAll: 'Tabelle der Versuche',
    wav: 'Ton (WAV)',
    csv: 'Tabelle (CSV)',
    json: 'Alle Daten (JSON)',
    share: 'Einstellungen teilen',
    shared: 'Die Adresse mit diesen Einstellungen ist kopiert.',
    shareByHand: 'Diese Adresse kopieren:',
    report: 'Bericht (HTML)',
  },
  simulate: {
    title: 'Lass einen Ball fallen, den es nicht gibt',
    lead: 'Schieb einen Regler und sieh, was sich ändert; behalte einen Lauf, um ihn mit dem nächsten zu vergleichen.',
    height: 'Fallhöhe',
    restitution: 'Stoßzahl (bei 1 m/s)',
    slope: 'Fällt mit dem Tempo um',
    slopeHint: '0: bei jedem Tempo gleich',
    ball: 'Ball',
    drag: 'Luftwiderstand',
    pressure: 'Luftdruck',
    world: 'Wo',
    worlds: {
      earth: 'Erde',
      moon: 'Mond',
      mars: 'Mars',
      venus: 'Venus',
      titan: 'Titan',
      jupiter: 'Jupiter',
    },
    keepRun: 'Diesen Lauf behalten',
    hear: 'Anhören',
    stop: 'Stopp',
    lay: 'Über die Messung legen',
    takeOff: 'Nicht mehr über die Messung legen',
    laid: 'Er liegt jetzt über der Messung, in der Abbildung „Vergleich“.',
    analyse: 'Auswerten, als wäre er echt',
    runs: 'Läufe',
    thisRun: 'dieser Lauf',
    run: (index) => `Lauf ${index}`,
    remove: (name) => `${name} entfernen`,
    see: 'Höhe über der Zeit. Mit Luft kommen die Sprünge früher und enden eher.',
    seeTimes:
      'Flugzeiten auf logarithmischer Skala: ohne Luft und bei gleichbleibender Stoßzahl eine Gerade.',
    says: (bounces, time, path) => [
      'Er springt ',
      bounces,
      ' Mal in ',
      time,
      ' und legt ',
      path,
      ' zurück.',
    ],
    terminal: (speed) => ['Schneller als ', speed, ' könnte er hier nie fallen.'],
    noTerminal: ['Keine Luft bremst ihn.'],
    losses: (surface, air) => [
      'Von seiner Energie gehen ',
      surface,
      ' in die Aufpralle, ',
      air,
      ' in die Luft.',
    ],
    x: 'Zeit (s)',
    y: 'Höhe (cm)',
    flightY: 'Flugzeit (s)',
    flightX: 'Flug',
    impossible: 'Das lässt sich nicht simulieren:',
    address: 'Die Regler stehen in der Adresse: Teile sie, und andere sehen denselben Lauf.',
  },
  paper: {
    title: 'Der Aufsatz, lebendig',
    source: 'M. Nagurka, „Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment“',
    lead: 'Lass einen Tischtennisball fallen. Hör zu. Die Stille zwischen den Aufprallen sagt, wie gut er springt und aus welcher Höhe er fiel, und sie liegt um 12 % daneben. Hier ist der Gedankengang, jede Zahl und jede Abbildung beim Lesen neu berechnet.',
    one: {
      title: '1. Stille als Maßstab',
      text: [
        'Zwischen zwei Aufprallen steigt und fällt der Ball eine Zeit T lang. Ohne Luft flog er mit dem Tempo gT/2 los und stieg auf gT²/8. Mehr als eine Uhr braucht man nicht.',
        'Behält jeder Aufprall den Anteil e des Tempos, so dauert jeder Flug e-mal so lang wie der vorige. Auf logarithmischer Skala liegen die Flugzeiten auf einer Geraden: Ihre Steigung ist log e, und wo sie beginnt, sagt die Fallhöhe.',
      ],
      equation: 'log Tₙ = n log e + log (2v₀/g),   h₀ = v₀²/2g',
      see: 'Die Flugzeiten eines Balls aus 30,5 cm, ohne Luft. Jeder Punkt auf der Geraden; sie findet e und 30,5 cm genau.',
    },
    two: {
      title: '2. Der Versuch und sein Rätsel',
      text: [
        'Im Aufsatz fiel ein Ball von 2,5 g und 38 mm aus 30,5 cm. Die Gerade durch die ersten zehn Flüge ergab e = 0,9375 und eine Fallhöhe von 26,7 cm.',
        'Das sind 3,8 cm zu wenig, 12,3 %: weit mehr, als ein Maßband irrt. Der Aufsatz nennt den Luftwiderstand als wahrscheinlichen Grund.',
      ],
    },
    three: {
      title: '3. Wie stark die Luft zieht',
      text: [
        'Bei den 2,4 m/s des ersten Aufpralls ist der Luftwiderstand nur 6 % des Gewichts, und er schwindet mit dem Quadrat des Tempos. Der Aufsatz erprobt zwei Gesetze: einen gleichbleibenden Beiwert von 0,4 und einen, der vom Tempo abhängt. Wo es darauf ankommt, stimmen sie überein.',
      ],
      equation: 'F/W = ½ ρ A C_D v² / mg',
      see: 'Luftwiderstand durch Gewicht über dem Tempo, nach beiden Gesetzen. Auf der log. Skala gibt ein gleichbleibender Beiwert eine Gerade der Steigung 2.',
      first: 'erster Aufprall',
      seeHeight:
        'Der ganze Fall mit e = 0,935, mit Luft und ohne: sechs Prozent des Gewichts, und der Ball ruht Sekunden früher.',
    },
    four: {
      title: '4. Löst der Luftwiderstand das Rätsel?',
      text: [
        'Tun wir, was der Aufsatz nicht konnte: Bälle in Luft springen lassen, dieselbe Gerade hindurchlegen und sehen, was sie sagt. Wähle, wie gut der Ball springt und wie viele Flüge in die Gerade gehen.',
      ],
      e: 'Wahre Stoßzahl des Balls, bei 1 m/s',
      slope: 'Fällt mit dem Tempo um',
      flights: 'Flüge in der Geraden',
      lineSays: (e, h) => ['Die Gerade sagt e = ', e, ' und h₀ = ', h, '.'],
      paperSays: 'Die Gerade des Aufsatzes sagt e = 0,9375 und h₀ = 26,7 cm.',
      truth: 'Wahre Fallhöhe: 30,5 cm.',
      hit: 'Das ist das Ergebnis des Aufsatzes, auf die letzte Stelle.',
      solveDrag: 'e gleich, zehn Flüge',
      solveMany: 'e gleich, 21 Flüge',
      solveSlope: 'e fällt mit dem Tempo, zehn Flüge',
      see: 'Fallhöhe nach der Geraden über der Zahl ihrer Flüge. Grau: Ohne Luft bleibt sie gleich, solange der Ball bei jedem Tempo gleich gut springt. Orangerot: Mit Luft sinkt sie mit jedem Flug. Blau: was die Gerade des Aufsatzes sagte.',
      x: 'Flüge in der Geraden',
      y: 'Fallhöhe nach der Geraden (cm)',
      paperPoint: 'der Aufsatz',
    },
    five: {
      title: '5. Die Auflösung',
      text: [
        'Luftwiderstand mit gleichbleibender Stoßzahl erklärt etwa die Hälfte der Lücke: Ein Ball mit e = 0,953 gäbe die 0,9375 des Aufsatzes, aber 28,8 cm.',
        'Der Rest braucht eines von zweien. Entweder springt der Ball etwas schlechter, wenn er schnell ist, wie echte Bälle es tun; oder es gingen mehr als zehn Flüge in die Gerade. Eine Gerade kann beides nicht unterscheiden, denn ihre Antwort hängt davon ab, wie viele Flüge in sie eingehen.',
        'Darum zieht das Labor auf dieser Seite keine Gerade. Es fragt, welche Fallhöhe, Luft und Sprungkraft genau diese Stille gemacht haben können, und wie sicher.',
      ],
      law: 'Stoßzahl',
      drag: 'Luft',
      flights: 'Flüge',
      first: 'e bei 2,4 m/s',
      slow: 'e bei 0,5 m/s',
      height: 'Die Gerade sagt h₀',
      same: 'Die 26,7 cm des Aufsatzes?',
      yes: 'ja',
      no: 'nein',
      caption: 'Wege, auf denen die Gerade e = 0,9375 sagt',
    },
    six: {
      title: '6. Alle Zahlen des Aufsatzes',
      lead: 'Wie gedruckt und wie hier berechnet. Druckfehler der Gleichungen sind berichtigt.',
      quantity: 'Größe',
      printed: 'Gedruckt',
      computed: 'Berechnet',
      verdict: 'Urteil',
    },
    verdicts: {
      agrees: 'stimmt',
      'agrees-when-corrected': 'stimmt, berichtigt',
      'agrees-within-reading': 'stimmt, soweit ablesbar',
      misprint: 'Druckfehler',
      differs: 'weicht ab',
      '': '',
    },
    airNames: {
      none: 'keine Luft',
      'C_D = 0.4': 'C_D = 0,4',
      'C_D(Re)': 'C_D(Re)',
      'C_D(Re), buoyancy, added mass': 'C_D(Re), Auftrieb, mitbewegte Luft',
    },
    lawNames: {
      constant: 'gleichbleibend',
      viscoelastic: 'viskoelastisch',
      linear: 'fallend, linear',
      power: 'fallend, Potenzgesetz',
      'knee at 1.5 m/s': 'fallend über 1,5 m/s',
    },
    tryIt: 'Jetzt selbst einen Ball fallen lassen',
  },
  drops: {
    title: 'Tabelle der Versuche',
    empty:
      'Noch ist kein Versuch aufgehoben. Nach einem Versuch legt „Diesen Versuch aufheben“ ihn hier ab, nur in diesem Browser.',
    toLab: 'Zum Labor',
    name: 'Name',
    when: 'Wann',
    ball: 'Ball',
    e: 'Stoßzahl e',
    h: 'Fallhöhe',
    impacts: 'Aufpralle',
    actions: 'Ändern',
    open: 'Öffnen',
    openOne: (name) => `${name} öffnen`,
    delete: 'Löschen',
    deleteOne: (name) => `${name} löschen`,
    deleted: (name) => `„${name}“ ist gelöscht.`,
    choose: (name) => `${name} vergleichen`,
    compare: 'Vergleich',
    rename: (name) => `Name von ${name}`,
    mean: 'Mittel',
    scatter: 'Streuung (Standardabweichung)',
    ofDrops: (count) => `von ${count} ${zahl(count, 'Versuch', 'Versuchen')}`,
    scatterSentence: (mean, scatter, inside) => [
      'Im Mittel behielt der Ball ',
      mean,
      ' seines Tempos. Von Versuch zu Versuch streute das um ',
      scatter,
      '; jeder einzelne Versuch gibt ± ',
      inside,
      ' an.',
    ],
    see: 'Stoßzahl jedes Versuchs mit ihrer Unsicherheit. Verfehlen die Balken einander, hat sich zwischen den Versuchen etwas geändert.',
    seeRestitution: 'Stoßzahl über dem Tempo der gewählten Versuche, die Luft herausgerechnet.',
    x: 'Versuch',
    csv: 'Tabelle speichern (CSV)',
    json: 'Alles speichern (JSON)',
    deleteAll: 'Alle löschen',
    deletedAll: (count) => `${count} ${zahl(count, 'Versuch ist', 'Versuche sind')} gelöscht.`,
    unavailable: 'Der Browser hebt hier nichts auf (ein privates Fenster?).',
  },
};

export default deutsch;
