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
    nothing: 'Hier gibt es nichts zu zeigen: Dafür braucht es mehr Aufpralle.',
    reset: 'Seitwärts ziehen vergrößert, ein Doppelklick zeigt wieder alles.',
    numbers: 'Dasselbe als Zahlen',
    saveSvg: 'SVG',
    savePng: 'PNG',
    save: 'Diese Abbildung speichern',
    straightLine: 'Gerade',
    noAir: 'ohne Luft gerechnet',
    withAir: 'Luft herausgerechnet',
    measured: 'gemessen',
    notUsed: 'nicht in der Geraden',
    model: 'Modell mit Luft',
    line95: 'wahrscheinlicher Bereich (95 %)',
    flights: {
      tab: 'Flüge',
      see: 'Ein Ball, der bei jedem Aufprall denselben Anteil behält, gibt hier eine Gerade; wo die Punkte abbiegen, wirken Luft oder Tempo mit.',
      x: 'Flug',
      y: 'Flugzeit (s)',
    },
    residuals: { y: 'Abweichung (%)' },
    restitution: {
      tab: 'Stoßzahl',
      see: 'Grau lässt die Luft weg, Blau rechnet sie heraus. Liegt Blau waagerecht, springt der Ball bei jedem Tempo gleich gut.',
      x: 'Aufpralltempo (m/s)',
      y: 'Stoßzahl',
    },
    heights: {
      tab: 'Höhen',
      see: 'Wie hoch der Ball nach jedem Aufprall stieg; auf dieser Skala ist eine gleichbleibende Stoßzahl ohne Luft eine Gerade.',
      x: 'Sprung',
      y: 'Höhe (cm)',
    },
    energy: {
      tab: 'Energie',
      see: 'Wohin die Energie bei jedem Sprung geht: in Ball und Untergrund oder in die Luft.',
      x: 'Sprung',
      y: 'Energie (mJ)',
      surface: 'beim Aufprall verloren',
      air: 'an die Luft verloren',
    },
    drag: {
      tab: 'Luft',
      see: 'Wie stark die Luft zieht, verglichen mit dem Gewicht. Der Ball dieses Versuchs war nie schneller als die blaue Linie.',
      x: 'Tempo (m/s)',
      y: 'Luftwiderstand durch Gewicht (%)',
      linear: 'gleichmäßige Skala',
      log: 'log. Skala',
      fastest: 'hier am schnellsten',
    },
    compare: {
      tab: 'Vergleich',
      see: 'Die Höhe des Balls, wie gehört, über einer Simulation mit demselben Ball und derselben Luft. Wo sie sich trennen, fehlt dem Modell etwas.',
      x: 'Zeit (s)',
      y: 'Höhe (cm)',
      simulated: 'bestes Modell',
      overlay: 'deine Simulation',
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
      'agrees when corrected': 'stimmt, berichtigt',
      'agrees within reading': 'stimmt, soweit ablesbar',
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
  engine: {
    'one impact in between was not heard; it is counted':
      'Ein Aufprall dazwischen wurde nicht gehört; er ist mitgezählt.',
    '{} impacts in between were not heard; they are counted':
      '{} Aufpralle dazwischen wurden nicht gehört; sie sind mitgezählt.',
    'impact {} would give energy (restitution above 1): a double trigger, a moving surface, or a sound that is no impact; leave it out by hand (--exclude TIME)':
      'Aufprall {} gäbe dem Ball Energie: doppelt ausgelöst, ein bewegter Untergrund oder kein Aufprall. Entferne ihn, wenn er im Schallbild falsch aussieht.',
    'impacts {} would give energy (restitution above 1): a double trigger, a moving surface, or a sound that is no impact; leave it out by hand (--exclude TIME)':
      'Die Aufpralle {} gäben dem Ball Energie: doppelt ausgelöst, ein bewegter Untergrund oder keine Aufpralle. Entferne sie, wenn sie im Schallbild falsch aussehen.',
    '1 impact is more likely something else (probability below 1/2)':
      'Ein Aufprall ist eher etwas anderes.',
    '{} impacts are more likely something else (probability below 1/2)':
      '{} Aufpralle sind eher etwas anderes.',
    'flight {} is longer than the one before it, which no surface at rest does':
      'Flug {} ist länger als der vor ihm, was auf ruhendem Untergrund nicht geht.',
    'flights of more than 30 s: times are read in seconds; are these milliseconds?':
      'Flüge von mehr als 30 s: Zeiten werden in Sekunden gelesen. Sind das Millisekunden?',
    'the sampling did not converge (Pareto shape {}; it should be below 0.7), so the intervals cannot be trusted; the impacts may not be of one drop':
      'Die Rechnung lief nicht zusammen (Pareto-Form {}; sie sollte unter 0,7 liegen), darum ist den Bereichen nicht zu trauen; vielleicht gehören die Aufpralle nicht zu einem Ball.',
    '{} impacts show a single flight and no restitution of the ball; the rest of the answer is what is known of balls in general':
      '{} Aufpralle zeigen nur einen Flug und keine Stoßzahl; der Rest der Antwort ist, was man von Bällen überhaupt weiß.',
    '{} impacts show a single restitution, taken to be the same at every speed, of the ball; the rest of the answer is what is known of balls in general':
      '{} Aufpralle zeigen eine einzige Stoßzahl, die für jedes Tempo gelten soll; der Rest der Antwort ist, was man von Bällen überhaupt weiß.',
    '{} impacts show few restitutions of the ball; the rest of the answer is what is known of balls in general':
      '{} Aufpralle zeigen nur wenige Stoßzahlen; der Rest der Antwort ist, was man von Bällen überhaupt weiß.',
    'impact {} is odd and counts less: the ball may have drifted, hit an edge, or the sound is something else':
      'Aufprall {} fällt aus der Reihe und zählt weniger: Der Ball ist vielleicht weggesprungen, traf eine Kante, oder der Laut ist etwas anderes.',
    'impacts {} are odd and count less: the ball may have drifted, hit an edge, or the sound is something else':
      'Die Aufpralle {} fallen aus der Reihe und zählen weniger: Der Ball ist vielleicht weggesprungen, traf eine Kante, oder die Laute sind etwas anderes.',
    'the measured height of {} m does not go with the flight times, which speak of {} m: both would be true if gravity were {} m/s2; a wrong sample rate, a wrong ball, or a wrong height':
      'Die gemessene Höhe von {} m passt nicht zu den Flugzeiten, die von {} m sprechen; beides stimmte bei einer Fallbeschleunigung von {} m/s². Falsche Abtastrate, falscher Ball oder falsche Höhe?',
    'impacts before the first one heard were missed, with probability {}':
      'Mit der Wahrscheinlichkeit {} fehlen Aufpralle vor dem ersten gehörten.',
    'the drop height is of the fall before the first impact heard; with the measured height (--height) missed impacts would show':
      'Die Fallhöhe ist die vor dem ersten gehörten Aufprall; mit einer gemessenen Höhe fielen verpasste Aufpralle auf.',
    'these flight times say next to nothing about drag: the drag coefficient is what is known of spheres':
      'Diese Flugzeiten sagen fast nichts über den Luftwiderstand: Der Beiwert ist, was man von Kugeln weiß.',
    'drag and falling restitution cannot be told apart from this recording; a measured drop height or a denser ball would':
      'Luftwiderstand und fallende Stoßzahl lassen sich an dieser Aufnahme nicht unterscheiden; eine gemessene Fallhöhe oder ein dichterer Ball könnte es.',
    'no restitution law wins; the answer is averaged over those that may be true':
      'Kein Gesetz der Stoßzahl gewinnt; die Antwort ist das Mittel über alle, die wahr sein können.',
    'with so little loss the ball does not come to rest in any reasonable time':
      'Bei so wenig Verlust kommt der Ball in keiner vernünftigen Zeit zur Ruhe.',
    'the recording is silent: all samples have the same value':
      'Die Aufnahme ist stumm: Jeder Abtastwert ist gleich.',
    'no sound stands out of the background': 'Kein Laut hebt sich vom Hintergrund ab.',
    'only 1 sound stands out of the background; a drop is told from chance by at least {} impacts':
      'Nur ein Laut hebt sich vom Hintergrund ab; einen springenden Ball erkennt man an mindestens {} Aufprallen.',
    'only {} sounds stand out of the background; a drop is told from chance by at least {} impacts':
      'Nur {} Laute heben sich vom Hintergrund ab; einen springenden Ball erkennt man an mindestens {} Aufprallen.',
    '{} sounds keep time, about every {} s, as of a clock, of steps or a drum; the flights of a ball shrink':
      '{} Laute kommen im Takt, etwa alle {} s, wie von einer Uhr, von Schritten oder einer Trommel; die Flüge eines Balls werden kürzer.',
    '{} sounds stand out of the background, but no {} of them come at shrinking intervals as the impacts of a ball do':
      '{} Laute heben sich ab, aber keine {} davon kommen in schrumpfenden Abständen wie die Aufpralle eines Balls.',
    'the file is cut short: {} s of {} s could be read':
      'Die Datei ist abgeschnitten: {} s von {} s waren lesbar.',
    'the file is cut short or damaged: it was read up to {} s':
      'Die Datei ist abgeschnitten oder beschädigt: Sie wurde bis {} s gelesen.',
    '{} damaged packet was replaced by silence, the first at {} s':
      '{} beschädigtes Stück wurde durch Stille ersetzt, bei {} s.',
    '{} damaged packets were replaced by silence, the first at {} s':
      '{} beschädigte Stücke wurden durch Stille ersetzt, das erste bei {} s.',
    '{} sample was not a number and replaced by zero, the first at {} s':
      '{} Abtastwert war keine Zahl und wurde zu Null, bei {} s.',
    '{} samples were not numbers and replaced by zero, the first at {} s':
      '{} Abtastwerte waren keine Zahlen und wurden zu Null, der erste bei {} s.',
    '{} s of sound are missing at {} s: later times are too early':
      '{} s Ton fehlen bei {} s: Spätere Zeiten sind zu früh.',
    'the sound changes its rate or channels at {} s; it was read up to there':
      'Der Ton wechselt bei {} s Rate oder Kanäle; er wurde bis dort gelesen.',
    "the file's edit list reorders or warps the sound; it was read as recorded":
      'Die Schnittliste der Datei ordnet den Ton um; er wurde gelesen, wie er aufgenommen ist.',
    '{} samples are clipped: the recorder was too loud; times suffer little, levels do':
      '{} Abtastwerte sind übersteuert: Die Aufnahme war zu laut; Zeiten leiden kaum, Pegel schon.',
    'the drag law {} is known up to Reynolds number {}, but the ball reaches {}; choose a law with a wider range (clift-grace-weber has no upper end) or a slower ball':
      'Das Widerstandsgesetz {} ist bis zur Reynolds-Zahl {} bekannt, der Ball erreicht aber {}; wähle ein Gesetz, das weiter reicht (Clift–Grace–Weber hat kein Ende), oder einen langsameren Ball.',
    'the ball weighs {} kg and displaces {} kg of air, so it floats; check mass and diameter, or switch buoyancy off':
      'Der Ball wiegt {} kg und verdrängt {} kg Luft, er schwebt also; prüfe Masse und Durchmesser.',
    'the ball still rises {} m after {} bounces; lower the restitution, stop at a greater height, or ask for at most {} bounces':
      'Der Ball steigt noch {} m nach {} Sprüngen; senke die Stoßzahl, oder begnüge dich mit {} Sprüngen.',
    '{} is {}; it must be {}': '{} ist {}; erlaubt ist: {}',
    'drag coefficient': 'Wider\u00adstands\u00adbeiwert',
    'slope of restitution': 'Gefälle der Stoßzahl',
    'scatter of restitution': 'Streuung der Stoßzahl',
    'errors of the times': 'Fehler der Zeiten',
    'contact time': 'Kontaktzeit',
    gravity: 'Fall\u00adbeschleu\u00adnigung',
    'The numbers of the paper': 'Die Zahlen des Aufsatzes',
    'Restitution, time and distance without drag': 'Stoßzahl, Zeit und Weg ohne Luftwiderstand',
    'Equations as printed, and as they must be':
      'Gleichungen, wie gedruckt und wie sie sein müssen',
    'What the paper did not say': 'Was der Aufsatz nicht sagt',
    'The drop that its straight line sees: e = 0.9529 with drag':
      'Der Ball, den seine Gerade sieht: e = 0,9529 mit Luftwiderstand',
    weight: 'Gewicht',
    buoyancy: 'Auftrieb',
    'it fixes the density of air, 1.2276 kg/m3': 'legt die Dichte der Luft fest, 1,2276 kg/m³',
    'buoyancy over weight': 'Auftrieb durch Gewicht',
    'first impact, no drag': 'erster Aufprall, ohne Luftwiderstand',
    'Reynolds number there': 'Reynolds-Zahl dort',
    'not turbulent as printed: below the drag crisis, a laminar boundary layer':
      'nicht turbulent wie gedruckt: unterhalb der Widerstandskrise, mit laminarer Grenzschicht',
    'terminal speed, C_D = 0.4': 'Endgeschwindigkeit, C_D = 0,4',
    '9.385 lies on the edge of rounding': '9,385 liegt auf der Grenze des Rundens',
    'first impact, C_D = 0.4 (Eq. 15)': 'erster Aufprall, C_D = 0,4 (Gl. 15)',
    'drag over weight at 2.4 m/s, C_D(Re)': 'Luftwiderstand durch Gewicht bei 2,4 m/s, C_D(Re)',
    'the paper read its curve off a figure': 'der Aufsatz las seine Kurve aus einer Abbildung ab',
    'terminal speed, C_D(Re)': 'Endgeschwindigkeit, C_D(Re)',
    'the same': 'dasselbe',
    'e by the rule book, steel, least': 'e nach dem Regelbuch, Stahl, kleinstes',
    'e by the rule book, steel, most': 'e nach dem Regelbuch, Stahl, größtes',
    'e by the rule book, table, least': 'e nach dem Regelbuch, Tisch, kleinstes',
    'e by the rule book, table, most': 'e nach dem Regelbuch, Tisch, größtes',
    'error of h0 = 26.7 cm': 'Fehler von h₀ = 26,7 cm',
    'from the rounded 26.7 cm; the flight times are not printed':
      'aus den gerundeten 26,7 cm; die Flugzeiten sind nicht gedruckt',
    'e from 7.50 s after the first impact': 'e aus 7,50 s nach dem ersten Aufprall',
    'if the 7.50 s count from the first impact': 'wenn die 7,50 s ab dem ersten Aufprall zählen',
    'e from 7.50 s after the release (Eq. 7)': 'e aus 7,50 s nach dem Loslassen (Gl. 7)',
    'Eq. 7 counts from the release': 'Gl. 7 zählt ab dem Loslassen',
    'path until rest at e = 0.94 (Eq. 8)': 'Weg bis zur Ruhe bei e = 0,94 (Gl. 8)',
    'h0 by Eq. 6 as printed: g 10^b/8': 'h₀ nach Gl. 6 wie gedruckt: g 10^b/8',
    '10^b = 2 v0/g must be squared': '10^b = 2 v₀/g gehört quadriert',
    'h0 by Eq. 6 corrected: g (10^b)^2/8': 'h₀ nach Gl. 6 berichtigt: g (10^b)²/8',
    'Eq. {} at the first impact': 'Gl. {} beim ersten Aufprall',
    'the drop height: its left side is the distance y, not v':
      'die Fallhöhe: links steht der Weg y, nicht v',
    'e = 0.935 with drag (Fig. 8) regresses to':
      'e = 0,935 mit Luftwiderstand (Abb. 8) gibt als Gerade',
    'Fig. 8 takes the drag into account twice': 'Abb. 8 rechnet den Luftwiderstand doppelt',
    'drop height of that straight line': 'Fallhöhe dieser Geraden',
    'e that regresses to 0.9375 with drag': 'e, das mit Luftwiderstand als Gerade 0,9375 gibt',
    'over ten flights': 'über zehn Flüge',
    'drop height of its straight line': 'Fallhöhe seiner Geraden',
    'share of the gap to 30.5 cm that drag explains':
      'Anteil der Lücke zu 30,5 cm, den der Luftwiderstand erklärt',
    'the rest: restitution that falls with speed, or more flights in the fit':
      'der Rest: eine Stoßzahl, die mit dem Tempo fällt, oder mehr Flüge in der Geraden',
    'drop height, same e, twenty flights': 'Fallhöhe, gleiches e, zwanzig Flüge',
    'the straight line depends on how many flights it is drawn through':
      'die Gerade hängt davon ab, durch wie viele Flüge sie geht',
    'gravity lost to buoyancy and added mass':
      'was Auftrieb und mitbewegte Luft der Fallbeschleunigung nehmen',
    'buoyancy alone 1.4 %; every height shrinks with it':
      'der Auftrieb allein 1,4 %; jede Höhe schrumpft mit',
    'time until rest with drag, e = {}': 'Zeit bis zur Ruhe mit Luftwiderstand, e = {}',
    'path until rest with drag, e = {}': 'Weg bis zur Ruhe mit Luftwiderstand, e = {}',
    // Der Bericht.
    Note: 'Hinweis',
    Figure: 'Abbildung',
    'Report of bouncelab {}, {}': 'Bericht von bouncelab {}, {}',
    'The drop': 'Der Versuch',
    'Drop {} of {}': 'Versuch {} von {}',
    'The drops': 'Die Versuche',
    'No drop was found: {}': 'Kein springender Ball gehört: {}',
    'nothing in it bounces': 'Nichts darin springt.',
    '{} drops with {} impacts were heard': '{} Versuche mit {} Aufprallen wurden gehört.',
    'The ball kept {} of its speed at each bounce and fell from {} before the first impact heard':
      'Der Ball behielt bei jedem Aufprall {} seines Tempos und fiel vor dem ersten gehörten Aufprall aus {} Höhe.',
    'The ball kept {} of its speed at each bounce and fell from {}':
      'Der Ball behielt bei jedem Aufprall {} seines Tempos und fiel aus {} Höhe.',
    'The ball kept {} of its speed at each bounce':
      'Der Ball behielt bei jedem Aufprall {} seines Tempos.',
    'If there were no air, the ball kept {} of its speed at each bounce and fell from {}':
      'Gäbe es keine Luft, hätte der Ball bei jedem Aufprall {} seines Tempos behalten und wäre aus {} Höhe gefallen.',
    'How much the ball kept cannot tell: {}':
      'Wie viel der Ball behielt, lässt sich nicht sagen: {}',
    '{} impacts were heard from {} s to {} s, {}. The restitution, speed after an impact over speed before it, is {} at {}, with the air accounted for':
      '{} Aufpralle wurden von {} s bis {} s gehört, {}. Die Stoßzahl, Tempo nach dem Aufprall durch Tempo davor, ist {} bei {}, die Luft herausgerechnet.',
    '1 impacts were heard from {} s to {} s, {}': '1 Aufprall wurde von {} s bis {} s gehört, {}.',
    '{} impacts were heard from {} s to {} s, {}':
      '{} Aufpralle wurden von {} s bis {} s gehört, {}.',
    'none of them uncertain': 'keiner davon unsicher',
    'one of them uncertain': 'einer davon unsicher',
    '{0} of them uncertain': '{} davon unsicher',
    'A straight line through the logarithms of the flight times, which knows no air, says {} ({}) and {}':
      'Eine Gerade durch die Logarithmen der Flugzeiten, die keine Luft kennt, sagt {} ({}) und {}.',
    '{} points less': '{} Prozentpunkte weniger',
    '{} points more': '{} Prozentpunkte mehr',
    'What the silences say, and what a straight line makes of them':
      'Was die Stille sagt, und was eine Gerade daraus macht',
    'There is no inference: {}': 'Es gibt keine Schätzung: {}',
    'inference, with air': 'Schätzung, mit Luft',
    'straight line, no air': 'Gerade, ohne Luft',
    'restitution e': 'Stoßzahl e',
    restitution: 'Stoßzahl',
    'drop height': 'Fallhöhe',
    'energy kept': 'behaltene Energie',
    'terminal speed': 'Endgeschwindigkeit',
    'scatter from impact to impact': 'Streuung von Aufprall zu Aufprall',
    'release until rest': 'vom Loslassen bis zur Ruhe',
    'path until rest': 'Weg bis zur Ruhe',
    'height from which bounce {} reaches {}': 'Höhe, aus der Sprung {} bis {} reicht',
    'cannot tell': 'nicht zu sagen',
    'The impacts': 'Die Aufpralle',
    'Impacts, each with the flight after it and its restitution, without and with correction for drag (? marks uncertain ones)':
      'Aufpralle, jeder mit dem Flug danach und seiner Stoßzahl, ohne Luft gerechnet und mit ihr (? heißt unsicher)',
    'The straight line': 'Die Gerade',
    'It goes through {} flights, with a coefficient of determination of {}':
      'Sie geht durch {} Flüge, mit einem Bestimmtheitsmaß von {}.',
    'It goes through {} flights': 'Sie geht durch {} Flüge.',
    'There is none: {}': 'Es gibt keine: {}',
    'Where the uncertainty comes from': 'Woher die Unsicherheit kommt',
    'Budget of the restitution': 'Beiträge zur Unsicherheit der Stoßzahl',
    'Budget of the drop height': 'Beiträge zur Unsicherheit der Fallhöhe',
    'Which laws may be true': 'Welche Gesetze wahr sein können',
    'Laws of equal probability before the data': 'Gesetze, vor den Daten gleich wahrscheinlich',
    'What this recording can tell': 'Was diese Aufnahme sagen kann',
    'Correlations of the answers': 'Korrelationen der Antworten',
    '{}: these data say next to nothing; it is what was known before':
      '{}: Diese Daten sagen fast nichts darüber; es bleibt bei dem, was man vorher wusste.',
    '{}: the data help a little; {} % of the prior uncertainty is left':
      '{}: Die Daten helfen ein wenig; {} % der vorigen Unsicherheit bleiben.',
    '{}: told by the data; {} % of the prior uncertainty is left':
      '{}: Das sagen die Daten; {} % der vorigen Unsicherheit bleiben.',
    'How well it fits': 'Wie gut es passt',
    'The impacts as the inference has them, with the energy each took and its weight in the fit':
      'Die Aufpralle, wie die Schätzung sie sieht, mit der Energie, die jeder nahm, und seinem Gewicht darin',
    'The sampling is worth {} independent draws; its Pareto shape is {} (good below 0.7)':
      'Die Stichprobe ist {} unabhängige Ziehungen wert; ihre Pareto-Form ist {} (gut unter 0,7).',
    'A method that is right does not change its answer with the number of flights it uses:':
      'Ein richtiges Verfahren sagt dasselbe, wie viele Flüge es auch benutzt:',
    'Conditions and assumptions': 'Bedingungen und Annahmen',
    'Nobody stated these, so they were assumed:':
      'Das hat niemand angegeben, darum ist es angenommen:',
    'Before it saw the data, the inference knew this:':
      'Ehe sie die Daten sah, wusste die Schätzung dies:',
    'The air at these speeds': 'Die Luft bei diesem Tempo',
    'To repeat this': 'Um das zu wiederholen',
    'Version {} of bouncelab gives the same numbers from the same file and settings; the random numbers of the inference have a seed':
      'Version {} von bouncelab gibt aus derselben Datei und denselben Einstellungen dieselben Zahlen; die Zufallszahlen der Schätzung haben einen festen Startwert.',
    // Das Verfahren.
    Method: 'Verfahren',
    'A ball is heard only when it hits. The silence between two impacts is a flight, and its length T tells the height h of the flight, nearly independently of the air:':
      'Einen Ball hört man nur, wenn er aufprallt. Die Stille zwischen zwei Aufprallen ist ein Flug, und ihre Dauer T sagt die Höhe h des Flugs, fast unabhängig von der Luft:',
    'If each impact kept the same share e of the speed and there were no air, the logarithms of the flight times would lie on a straight line against the number n of the impact. Its slope gives the restitution e and its intercept b the drop height (Nagurka, Eqs. 4 and 6):':
      'Behielte jeder Aufprall denselben Anteil e des Tempos und gäbe es keine Luft, so lägen die Logarithmen der Flugzeiten über der Nummer n des Aufpralls auf einer Geraden. Ihre Steigung gibt die Stoßzahl e, ihr Achsenabschnitt b die Fallhöhe (Nagurka, Gl. 4 und 6):',
    'The air takes speed as well, and pushes and carries the ball a little. With mass m, volume V and cross-section A of the ball, density ρ of the air, and a drag coefficient that follows the Reynolds number, the velocity v changes as':
      'Auch die Luft nimmt Tempo, und sie trägt den Ball ein wenig und bewegt sich mit ihm. Mit Masse m, Volumen V und Querschnitt A des Balls, Dichte ρ der Luft und einem Widerstandsbeiwert, der der Reynolds-Zahl folgt, ändert sich die Geschwindigkeit v so:',
    'From each flight time follows the speed v at which the ball left the surface and the speed v′ at which it came back, and from two neighbouring flights the restitution of the impact between them:':
      'Aus jeder Flugzeit folgt, mit welchem Tempo v der Ball den Untergrund verließ und mit welchem Tempo v′ er wiederkam, und aus zwei benachbarten Flügen die Stoßzahl des Aufpralls zwischen ihnen:',
    "Two kinds of noise are kept apart: impacts scatter by a share σₑ of their restitution, and times have errors σₜ, which neighbouring impacts share through the derivatives J. Odd impacts count less (Student's t)":
      'Zweierlei Rauschen wird getrennt: Aufpralle streuen um einen Anteil σₑ ihrer Stoßzahl, und Zeiten haben Fehler σₜ, die benachbarte Aufpralle über die Ableitungen J teilen. Aufpralle, die aus der Reihe fallen, zählen weniger (Student-t).',
    'The inference weighs all values θ of what is unknown, under every restitution law and drag law M, by how well they explain the times t and by what was known before. Each quantity is stated as the median of that, ± its standard deviation; an interval of 95 % holds the truth with that probability if the assumptions hold':
      'Die Schätzung wägt alle Werte θ dessen, was unbekannt ist, unter jedem Gesetz M von Stoßzahl und Luftwiderstand: danach, wie gut sie die Zeiten t erklären, und nach dem, was man vorher wusste. Von jeder Größe steht der Median da, ± ihre Standardabweichung; ein Bereich von 95 % enthält die Wahrheit mit dieser Wahrscheinlichkeit, wenn die Annahmen stimmen.',
    'References:': 'Literatur:',
    '{}: the standard drag curve': '{}: die übliche Kurve des Luftwiderstands',
    '{}: the scatter of impacts': '{}: die Streuung der Aufpralle',
    // Womit gehört wurde und was bekannt war.
    Source: 'Quelle',
    'a list of impact times': 'eine Liste von Aufprallzeiten',
    '{}, {} kHz, {} s': '{}, {} kHz, {} s',
    microphone: 'Mikrofon',
    Channel: 'Kanal',
    'Sounds above the noise': 'Laute über dem Rauschen',
    Ball: 'Ball',
    Mass: 'Masse',
    Diameter: 'Durchmesser',
    'Density of the air': 'Dichte der Luft',
    'Drag law': 'Widerstandsgesetz',
    'Buoyancy and added mass': 'Auftrieb und mitbewegte Luft',
    'both taken into account': 'beide berücksichtigt',
    'buoyancy only': 'nur der Auftrieb',
    'added mass only': 'nur mitbewegte Luft',
    'left out': 'weggelassen',
    'Measured drop height': 'Gemessene Fallhöhe',
    'Release, in the recording': 'Loslassen, in der Aufnahme',
    Sampling: 'Stichprobe',
    '{} draws, seed {}': '{} Ziehungen, Startwert {}',
    'table tennis 40+': 'Tischtennis 40+',
    'table tennis 38 mm (to 2000)': 'Tischtennis 38 mm (bis 2000)',
    tennis: 'Tennis',
    'football, size 5': 'Fußball, Größe 5',
    'basketball, size 7': 'Basketball, Größe 7',
    golf: 'Golf',
    squash: 'Squash',
    racquetball: 'Racquetball',
    pickleball: 'Pickleball',
    padel: 'Padel',
    'steel, {} mm': 'Stahl, {} mm',
    'glass, {} mm': 'Glas, {} mm',
    'the ball is {}': 'Der Ball: {}.',
    'it touches for {} ms': 'Er berührt den Untergrund {} ms lang.',
    'gravity {} m/s2': 'Fallbeschleunigung {} m/s².',
    'air of {} C, {} hPa, {} % humidity': 'Luft von {} °C, {} hPa, {} % Feuchte.',
    'restitution: anything from 0 to 1': 'Stoßzahl: alles von 0 bis 1.',
    'scatter of restitution: about {} %, within a factor of two':
      'Streuung der Stoßzahl: etwa {} %, auf einen Faktor zwei.',
    'drop height: anything (flat in its logarithm)':
      'Fallhöhe: beliebig (im Logarithmus gleich verteilt).',
    'drop height: measured, {} +- {} m': 'Fallhöhe: gemessen, {} ± {} m.',
    'release: measured, {} +- {} s': 'Loslassen: gemessen, {} ± {} s.',
    'a constant drag coefficient: as probable as the law':
      'Ein gleichbleibender Widerstandsbeiwert: so wahrscheinlich wie das Gesetz.',
    'each further impact missed at the start: half as likely':
      'Jeder weitere Aufprall, der am Anfang fehlt: halb so wahrscheinlich.',
    '{}: known to {} %': '{}: auf {} % bekannt.',
    '{}: unknown (a factor e either way)': '{}: unbekannt (ein Faktor e nach oben oder unten).',
    'drag coefficient, around the law': 'Widerstandsbeiwert, um das Gesetz herum',
    'stated errors of the times': 'angegebene Fehler der Zeiten',
    'air density': 'Dichte der Luft',
    'ball mass': 'Masse des Balls',
    'ball diameter': 'Durchmesser des Balls',
    'added mass': 'mitbewegte Luft',
    'choice of law': 'Wahl des Gesetzes',
    'number of impacts': 'Zahl der Aufpralle',
    'timing of the impacts': 'Zeiten der Aufpralle',
    'release time': 'Zeit des Loslassens',
    'measured height': 'gemessene Höhe',
    'all others': 'alles andere',
    // Gesetze.
    constant: 'gleich\u00adbleibend',
    linear: 'linear',
    power: 'Potenz\u00adgesetz',
    viscoelastic: 'visko\u00adelastisch',
    knee: 'mit Knick',
    none: 'keines',
    'constant:{}': 'C_D = {}',
    // Köpfe der Tabellen.
    drop: 'Versuch',
    'from s': 'ab s',
    impact: 'Aufprall',
    impacts: 'Aufpralle',
    'time s': 'Zeit s',
    'flight s': 'Flug s',
    'apex cm': 'Höhe cm',
    'speed m/s': 'Tempo m/s',
    'e no drag': 'e ohne Luft',
    '± time µs': '± Zeit µs',
    'level dB': 'Pegel dB',
    probability: 'Wahr\u00adschein\u00adlich\u00adkeit',
    'line %': 'Gerade %',
    'restitution law': 'Gesetz der Stoßzahl',
    drag: 'Luft\u00adwiderstand',
    'ln evidence': 'ln Evidenz',
    alone: 'allein',
    '% of variance': '% der Varianz',
    'to surface mJ': 'Untergrund mJ',
    'to air mJ': 'Luft mJ',
    residual: 'Abwei\u00adchung',
    // Die Abbildungen.
    'The sound and its impacts': 'Der Ton und seine Aufpralle',
    'uncertain impact': 'unsicherer Aufprall',
    'amplitude, relative to full scale': 'Ausschlag, bezogen auf Vollausschlag',
    'The sound, in which no impacts were found': 'Der Ton, in dem keine Aufpralle gefunden wurden.',
    '{}: their spacing shrinks by nearly the same ratio each time':
      '{}: Ihr Abstand schrumpft jedes Mal fast im selben Verhältnis.',
    '{} of one drop ({} uncertain, open and orange)':
      '{} eines Versuchs ({} unsicher, offen und orange)',
    '{} of {} drops ({} uncertain, open and orange)':
      '{} aus {} Versuchen ({} unsicher, offen und orange)',
    '{} of one drop': '{} eines Versuchs',
    '{} of {} drops': '{} aus {} Versuchen',
    'drop {0}': '{}. Versuch',
    'Flight times and the straight line': 'Die Flugzeiten und die Gerade',
    'measured flights': 'gemessene Flüge',
    'flights used': 'benutzte Flüge',
    'not used': 'nicht benutzt',
    'straight line: × {} each time': 'Gerade: jedes Mal × {}',
    'straight line: {}': 'Gerade: {}',
    'straight line': 'Gerade',
    'number of the flight': 'Nummer des Flugs',
    'flight time (s)': 'Flugzeit (s)',
    'off the line (%)': 'neben der Geraden (%)',
    '1 flight, without a line through them': '1 Flug, ohne eine Gerade.',
    '{} flights, without a line through them': '{} Flüge, ohne eine Gerade durch sie.',
    'Without air each flight would last the same share of the one before, {} by the line; a bend in the lower panel shows air drag, or a bounciness that changes with speed':
      'Ohne Luft dauerte jeder Flug denselben Anteil des vorigen, nach der Geraden {}; ein Bogen im unteren Feld zeigt Luftwiderstand oder eine Sprungkraft, die sich mit dem Tempo ändert.',
    'Bounciness of each impact': 'Die Sprungkraft bei jedem Aufprall',
    'corrected for drag': 'Luft herausgerechnet',
    'as if there were no air': 'ohne Luft gerechnet',
    'odd, counts less': 'aus der Reihe, zählt weniger',
    'fitted law, 68 and 95 %': 'angepasstes Gesetz, 68 und 95 %',
    'restitution: speed after / before': 'Stoßzahl: Tempo nachher / vorher',
    'speed at the impact (m/s)': 'Aufpralltempo (m/s)',
    'What the ball keeps of its speed at each impact; the gap between grey and blue is what the air takes, which a straight line counts as lost in the bounce':
      'Was der Ball bei jedem Aufprall von seinem Tempo behält; die Lücke zwischen Grau und Blau nimmt die Luft, und eine Gerade hält sie für Verlust beim Aufprall.',
    'Height of the ball': 'Die Höhe des Balls',
    'flight model, drag {}': 'Flugmodell, Luftwiderstand: {}',
    'your simulation': 'deine Simulation',
    'measured apexes': 'gemessene Scheitel',
    'Each hop is lower and shorter than the one before; dots are the measured tops of the hops':
      'Jeder Sprung ist niedriger und kürzer als der vorige; die Punkte sind die gemessenen Scheitel.',
    'How high is each bounce?': 'Wie hoch ist jeder Sprung?',
    bounce: 'Sprung',
    'Every bounce keeps about the same share of the height before it, so that the points lie near a straight line':
      'Jeder Sprung behält etwa denselben Anteil der Höhe vor ihm, sodass die Punkte nahe einer Geraden liegen.',
    'Where does the energy go?': 'Wohin geht die Energie?',
    'the air, in the flight after it': 'die Luft, im Flug danach',
    'the bounce': 'der Aufprall',
    'What each impact takes, and on top of it what the air takes in the flight after it: the faster the ball, the larger the share of the air':
      'Was jeder Aufprall nimmt, und darauf, was die Luft im Flug danach nimmt: je schneller der Ball, desto größer der Anteil der Luft.',
    'Air drag relative to weight': 'Luftwiderstand, verglichen mit dem Gewicht',
    'drag / weight': 'Luftwiderstand / Gewicht',
    'speed (m/s)': 'Tempo (m/s)',
    'this drop: up to {}': 'dieser Versuch: bis {}',
    'Drag grows nearly with the square of the speed and balances the weight at the terminal speed, where the curve reaches 1; this drop reached {}':
      'Der Luftwiderstand wächst fast mit dem Quadrat des Tempos und trägt bei der Endgeschwindigkeit, wo die Kurve 1 erreicht, das ganze Gewicht; dieser Versuch erreichte {}.',
    'A constant drag coefficient is a straight line here; the laws part at low speed, where drag is too weak to matter; this drop reached {}':
      'Ein gleichbleibender Beiwert ist hier eine Gerade; die Gesetze trennen sich bei kleinem Tempo, wo der Luftwiderstand nichts mehr ausmacht; dieser Versuch erreichte {}.',
    'How odd is each impact?': 'Wie weit fällt jeder Aufprall aus der Reihe?',
    'residual (standard deviations)': 'Abweichung (in Standardabweichungen)',
    'Two of three impacts should lie in the dark band, 19 of 20 in the light one; one far outside hit an edge, or is no impact':
      'Zwei von drei Aufprallen sollten im dunklen Band liegen, 19 von 20 im hellen; einer weit außerhalb traf eine Kante oder ist kein Aufprall.',
    'What is known of them together': 'Was man von allen zusammen weiß',
    'after the data: 68 % dark, 95 % light': 'nach den Daten: 68 % dunkel, 95 % hell',
    'before the data': 'vor den Daten',
    'A round cloud: the data tell the two quantities apart. A tilted one: what is added to one can be taken from the other. A histogram as wide as the grey curve: the data told nothing':
      'Eine runde Wolke: Die Daten unterscheiden die beiden Größen. Eine schräge: Was man der einen zugibt, lässt sich der anderen nehmen. Ein Histogramm so breit wie die graue Kurve: Die Daten haben nichts gesagt.',
    "Each bar is a source's share of the variance: to know the ball better, improve what is on top":
      'Jeder Balken ist der Anteil einer Quelle an der Varianz: Wer den Ball besser kennen will, verbessert, was oben steht.',
    'Which law is it?': 'Welches Gesetz ist es?',
    'The longer the bar, the more probable the law; where no bar wins, the answer is an average over all of them':
      'Je länger der Balken, desto wahrscheinlicher das Gesetz; wo keiner gewinnt, ist die Antwort ein Mittel über alle.',
    'Does the answer depend on how many flights are used?':
      'Hängt die Antwort an der Zahl der benutzten Flüge?',
    truth: 'Wahrheit',
    'A model that is right gives the same answer however many flights it uses; the answer of a straight line moves, because it knows no air':
      'Ein richtiges Modell gibt dieselbe Antwort, wie viele Flüge es auch benutzt; die einer Geraden wandert, weil sie keine Luft kennt.',
    'There are no flights to show': 'Hier gibt es keine Flüge zu zeigen.',
    'There are no heights to show': 'Hier gibt es keine Höhen zu zeigen.',
    'There are no energies to show': 'Hier gibt es keine Energien zu zeigen.',
    'There are no drag curves to show': 'Hier gibt es keine Widerstandskurven zu zeigen.',
    'There are no impacts with a known restitution':
      'Hier gibt es keinen Aufprall mit bekannter Stoßzahl.',
    // Was sich nicht sagen lässt, und warum.
    'a straight line through log flight time needs at least 2 flights, but there are {}; use a recording with at least 3 impacts, or a wider range of flights':
      'Eine Gerade durch die Logarithmen der Flugzeiten braucht mindestens 2 Flüge, hier sind es {}; nimm eine Aufnahme mit mindestens 3 Aufprallen oder mehr Flüge.',
    'a flight needs two impact times, and there are fewer':
      'Ein Flug braucht zwei Aufprallzeiten, und es sind weniger.',
    'an inference needs a flight, and a flight needs two impacts':
      'Eine Schätzung braucht einen Flug, und ein Flug braucht zwei Aufpralle.',
    '{} impacts in a row were missed after impact {}':
      '{} Aufpralle in Folge fehlen nach Aufprall {}.',
    'air drag makes so long a flight impossible for this ball; check mass, diameter and the unit of the times':
      'Der Luftwiderstand macht einen so langen Flug dieses Balls unmöglich; prüfe Masse, Durchmesser und die Einheit der Zeiten.',
    'no physical model explains these times; are they of one drop, in seconds, and is the ball the right one?':
      'Kein Modell erklärt diese Zeiten; sind sie von einem Versuch, in Sekunden, und ist es der richtige Ball?',
    'the ball would gain speed at each impact, which no surface at rest gives; are the times in order, in seconds, and of one drop?':
      'Der Ball gewänne bei jedem Aufprall an Tempo, was ruhender Untergrund nicht gibt; stehen die Zeiten der Reihe nach, in Sekunden, und sind sie von einem Versuch?',
    '{} and {0} more': '{} und {0} weitere',
    'the {} restitution law takes {} impacts between two flights to be told from a constant, and there is {}: how restitution changes is what was assumed':
      'Das Gesetz der Stoßzahl „{}“ braucht {} Aufpralle zwischen zwei Flügen, um von einer gleichbleibenden Stoßzahl zu unterscheiden zu sein, und hier gibt es {}: Wie sich die Stoßzahl ändert, ist angenommen.',
    'the {} restitution law takes {} impacts between two flights to be told from a constant, and there are {}: how restitution changes is what was assumed':
      'Das Gesetz der Stoßzahl „{}“ braucht {} Aufpralle zwischen zwei Flügen, um von einer gleichbleibenden Stoßzahl zu unterscheiden zu sein, und hier gibt es {}: Wie sich die Stoßzahl ändert, ist angenommen.',
    'a far fainter ball was heard from {} s to {} s ({} impacts) and left out':
      'Ein viel leiserer Ball wurde von {} s bis {} s gehört ({} Aufpralle) und weggelassen.',
    'the mass of a ball goes with its diameter': 'Zur Masse eines Balls gehört sein Durchmesser.',
    '"{}" is no diameter in metres': '„{}“ ist kein Durchmesser in Metern.',
    'no {} is called "{}"; the nearest is "{}" (known: {})':
      '{} „{}“ gibt es nicht; am nächsten kommt „{}“ (bekannt: {}).',
    // Größen und Grenzen von Einstellungen.
    'mass of the ball in kg': 'Masse des Balls in kg',
    'diameter of the ball in m': 'Durchmesser des Balls in m',
    'temperature of the air in K': 'Temperatur der Luft in K',
    'pressure of the air in Pa': 'Druck der Luft in Pa',
    'relative humidity': 'relative Feuchte',
    'density of the air in kg/m3': 'Dichte der Luft in kg/m³',
    'viscosity of the air in Pa s': 'Zähigkeit der Luft in Pa s',
    'gravity in m/s2': 'Fallbeschleunigung in m/s²',
    'latitude in degrees': 'Breite in Grad',
    'altitude in m': 'Höhe über dem Meer in m',
    'release height in m': 'Fallhöhe in m',
    'measured drop height in m': 'gemessene Fallhöhe in m',
    'standard uncertainty of the drop height in m': 'Unsicherheit der Fallhöhe in m',
    'standard uncertainty of the release time in s': 'Unsicherheit der Zeit des Loslassens in s',
    'impact speed at which to state the restitution in m/s':
      'Aufpralltempo, für das die Stoßzahl gelten soll, in m/s',
    'coefficient of restitution': 'Stoßzahl',
    'flight time in s': 'Flugzeit in s',
    'time between two impacts in s': 'Zeit zwischen zwei Aufprallen in s',
    'finite and above 0': 'endlich und größer als 0',
    'finite and not below 0': 'endlich und nicht kleiner als 0',
    'finite, in order, and longer than the contact time':
      'endlich, der Reihe nach und länger als die Kontaktzeit',
    'a number that is finite and not below 0, as in "constant:0.4"':
      'eine endliche Zahl, nicht kleiner als 0, wie in „constant:0.4“',
    'from 0 (dead) to 1 (lossless)': 'von 0 (tot) bis 1 (ohne Verlust)',
    'from 0 (dry) to 1 (saturated)': 'von 0 (trocken) bis 1 (gesättigt)',
    'from -90 (south) to 90 (north)': 'von −90 (Süden) bis 90 (Norden)',
    'from 250 to 330 (-23 to 57 degrees Celsius)': 'von 250 bis 330 (−23 bis 57 Grad Celsius)',
    'from {} to {}': 'von {} bis {}',
    // Was auf vieles passt.
    'time ({})': 'Zeit ({})',
    'height ({})': 'Höhe ({})',
    'drop height ({})': 'Fallhöhe ({})',
    'energy lost ({})': 'verlorene Energie ({})',
    'restitution: {0}': 'Stoßzahl: {}',
    'drop height: {0}': 'Fallhöhe: {}',
    '1 impact': '1 Aufprall',
    '{0} impacts': '{} Aufpralle',
    'constant, {}': 'konstant, {}',
    'linear, {}': 'linear, {}',
    'power, {}': 'Potenz, {}',
    'viscoelastic, {}': 'viskoelastisch, {}',
    'knee, {}': 'mit Knick, {}',
    '{0} to {0}': '{} bis {}',
    '{0} of {0}': '{} von {}',
  },
};

export default deutsch;
