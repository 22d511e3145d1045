/**
 * Every word of the page in English. The other languages have the same shape: a key that one of them
 * lacks does not compile (see `text/texts.ts`).
 */
import type {
  LabReason,
  LayoutProblem,
  LooksLike,
  MissingContent,
  Stage,
  TimesProblem,
} from '../../lab/index.ts';

const plural = (count: number, one: string, many: string): string => (count === 1 ? one : many);

const LACKS: Record<MissingContent, string> = {
  content: 'Not a single byte of sound is in it.',
  sound: 'It has a header, but no sound.',
  time: 'There is no time in it.',
};

const LOOKS: Record<LooksLike, string> = {
  png: 'a PNG picture',
  jpeg: 'a JPEG picture',
  gif: 'a GIF picture',
  pdf: 'a PDF document',
  zip: 'a ZIP archive or an office document',
  gzip: 'a gzip archive',
  riff: 'a RIFF file without sound, such as AVI or WebP',
  caf: 'a Core Audio (CAF) recording, which is not read: export it as WAV or M4A',
  zeros: 'nothing but zeros',
  text: 'text',
  unknown: 'data of an unknown kind',
};

const STAGES: Record<Stage, string> = {
  header: 'Its header cannot be read',
  codec: 'Its decoder cannot be set up',
  sound: 'None of its sound can be decoded',
};

function timesProblem(problem: TimesProblem): string {
  switch (problem.code) {
    case 'ending':
      return 'The name of a list ends in .txt, .csv or .json.';
    case 'not-text':
      return 'This is no text. Save the list as UTF-8.';
    case 'not-table':
      return `This is no table (${problem.detail}).`;
    case 'not-array':
      return `A list of numbers was expected, as in [0.1, 0.45] (${problem.detail}).`;
    case 'no-time-column':
      return `No column is named time or time_s. There are: ${problem.found}.`;
    case 'nameless-columns':
      return `There are ${problem.columns} columns. Name the one with the times in a first line: time_s.`;
    case 'missing':
      return 'The time is missing.';
    case 'not-number':
      return `“${problem.text}” is no time in seconds, such as 0.125.`;
    case 'not-later':
      return `${problem.time_s} does not come after ${problem.before_s}. List the impacts in order.`;
  }
}

function layoutProblem(problem: LayoutProblem): string {
  switch (problem.code) {
    case 'too-slow':
      return `${problem.sample_rate_hz} samples a second are too few to time an impact: it takes at least ${problem.least_hz}.`;
    case 'too-fast':
      return `Its header claims ${problem.sample_rate_hz} samples a second; at most ${problem.most_hz} are read.`;
    case 'too-many-channels':
      return `It has ${problem.channels} channels; at most ${problem.most} are read.`;
  }
}

/** What exactly is wrong with a file. */
function reason(found: LabReason): string {
  switch (found.code) {
    case 'empty':
      return LACKS[found.what];
    case 'not-sound':
      return `It looks like ${LOOKS[found.looks_like]}.`;
    case 'malformed':
      return `${STAGES[found.stage]} (${found.format}: ${found.detail}).`;
    case 'no-audio-track':
      return `This ${found.format} file has no sound, or none of a known kind. Was the microphone off?`;
    case 'unsupported-codec':
      return `The sound in this ${found.format} file cannot be decoded: ${found.codec}. Export it as WAV or M4A.`;
    case 'unsupported-layout':
      return layoutProblem(found.problem);
    case 'times':
      return `${found.line === null ? '' : `Line ${found.line}: `}${timesProblem(found.problem)}`;
    case 'too-large':
      return `It has ${found.megabytes} MB.`;
    case 'too-long':
      return `It has more than ${found.minutes} minutes in ${found.channels} ${plural(found.channels, 'channel', 'channels')}.`;
    case 'no-memory':
      return 'This device has not enough memory for it.';
    case 'breaks-decoder':
      return 'It is damaged in a way that its decoder does not survive.';
    case 'unreadable':
      return 'The browser cannot read it. Was it moved or deleted?';
  }
}

export default {
  to: 'to',
  app: {
    title: 'bouncelab: drop a ball, hear the physics',
    skip: 'Skip to the content',
    nav: 'Pages',
    lab: 'Listen',
    simulate: 'Simulate',
    paper: 'Paper',
    drops: 'Drops',
    language: 'Language',
    toDark: 'Dark',
    toLight: 'Light',
    privacy: 'Nothing leaves this device: no account, no server, works offline.',
    version: (version: string) => `bouncelab ${version}`,
    engineFailed: 'The laboratory could not start.',
    engineFailedHint:
      'The browser did not load or run the WebAssembly part. Reload the page; if that does not help, use a current Firefox, Chrome, Edge or Safari.',
    newer: 'A newer version of this page is ready.',
    reload: 'Reload',
    undo: 'Undo',
    redo: 'Redo',
    cancel: 'Cancel',
    why: 'Why?',
    numberWanted: (least: string, most: string) =>
      `A number${most ? ` from ${least} to ${most}` : least && ` of at least ${least}`} is expected here.`,
    dropHere: 'Let go to hear it',
    unreadableLink: (parts: string) =>
      `Some of the set-up in the address was not understood and is left out: ${parts}.`,
  },
  lab: {
    invite: 'Drop a ball near your microphone.',
    inviteTouch: 'Drop a ball near your phone.',
    listen: 'Listen',
    stop: 'Stop',
    again: 'Listen again',
    open: 'open a file',
    paste: 'paste times',
    demo: 'try the demo',
    openLabel: 'Recording or list of impact times',
    pasteLabel: 'Impact times in seconds, one on each line',
    pasteHint:
      'From a spreadsheet, an oscilloscope or your own ears. Flights are what lies between.',
    pasteDo: 'Analyse',
    pastedName: 'pasted times',
    demoName: 'demo',
    recordingName: (date: string) => `drop ${date}`,
    starting: 'Asking for the microphone …',
    listening: 'Listening. Drop the ball.',
    soFar: (count: number) => `${count} ${plural(count, 'impact', 'impacts')} so far`,
    soFarKeeps: (share: string) => `it keeps about ${share} of its speed`,
    endsItself: 'It ends by itself when the ball rests.',
    result: 'Result',
    opening: (name: string) => `Reading ${name} …`,
    kept: (share: string) => ['The ball kept ', share, ' of its speed at each bounce.'],
    fell: (height: string) => ['It fell from ', height, '.'],
    cannotTell: 'These impacts are too few to tell how bouncy the ball is.',
    impacts: (count: number) => `${count} ${plural(count, 'impact', 'impacts')}`,
    uncertain: (count: number) => `${count} uncertain`,
    edited: 'edited by hand',
    dropOf: (index: number, count: number) => `Drop ${index} of ${count}`,
    dropsHeard: 'Drops in this recording',
    airExplains: (points: string) =>
      `Air drag explains ${points} points of what a straight-line fit would call lost bounciness.`,
    lineHeight: (height: string) => `That line would put the drop height at ${height}.`,
    airNothing: 'Air drag makes next to no difference here: the straight line says the same.',
    whyAir: [
      'A straight line through the logarithm of the flight times is the classic way to measure bounciness. But air slows the ball too, and the line takes that for energy lost in the bounce.',
      'The grey points leave the air out; the blue ones give the air its share. What remains is the ball and the surface.',
    ],
    refining: 'Weighing what the air and the ball can do …',
    more: 'All numbers',
    tells: 'What these silences can tell, and what not',
    narrowedLead: 'How much the sound narrowed down what was known before it:',
    narrowed: (unknown: string, share: string) => `${unknown}: ${share} of its width remains`,
    assumed: 'assumed',
    noDropTitle: 'No drop found.',
    noDropHint:
      'Put the microphone close to where the ball lands, on a hard surface, and let it bounce until it rests. If you can see the impacts in the waveform, mark them by hand: double-click, or press Enter at the cursor.',
    interruptedTitle: (date: string) => `A recording of ${date} was cut short.`,
    progress: 'How far it is',
    unkeptTitle: (date: string) => `The recording of ${date} is not in the table of drops.`,
    interruptedHint: 'Nothing of it is lost.',
    interruptedOpen: 'Open it',
    interruptedDrop: 'Throw it away',
  },
  words: {
    restitution: 'Restitution is the speed just after an impact over the speed just before it.',
  },
  reason,
  faults: {
    refused: {
      what: 'The browser may not use the microphone.',
      do: 'Allow it in the address bar (the lock or microphone sign) and tap Listen again. On a phone, also look into the settings of the browser app. You can open a recording instead.',
    },
    missing: {
      what: 'No microphone was found.',
      do: 'Plug one in and tap Listen again, or record with another device and open the file here.',
    },
    busy: {
      what: 'The microphone is used by another program.',
      do: 'Close calls and recorders, then tap Listen again.',
    },
    insecure: {
      what: 'Browsers give the microphone only to pages with https, or from this computer itself.',
      do: 'Open this page with https or through localhost. Recordings can be opened as it is.',
    },
    unsupported: {
      what: 'This browser cannot hand over raw sound.',
      do: 'Use a current Firefox, Chrome, Edge or Safari, or open a recording.',
    },
    ended: {
      what: 'The microphone was taken away: unplugged, or needed for a call.',
      do: 'What was heard until then is kept and analysed.',
    },
    unknown: {
      what: 'The microphone could not be opened.',
      do: 'Unplug and plug it in again, or restart the browser. You can open a recording instead.',
    },
    silent: {
      what: 'The microphone gives silence.',
      do: 'It may be muted by a switch or in the system settings.',
    },
    full: {
      what: 'The storage of the browser is full.',
      do: 'What you hear is whole in memory: save it as WAV now. Then delete drops that you do not need.',
    },
    unavailable: {
      what: 'The browser keeps nothing here (a private window?).',
      do: 'What you hear is whole in memory, until this page closes: save it as WAV.',
    },
    empty: {
      what: 'The file is empty.',
      do: 'Nothing was written into it. Was the recording stopped before it began? Record again or choose another file.',
    },
    'unsupported-file': {
      what: 'This is neither a recording nor a list of times.',
      do: 'Sounds: WAV, AIFF, FLAC, MP3, Ogg, Opus, WebM, M4A, MP4, MOV. Lists: one time in seconds on each line.',
    },
    damaged: {
      what: 'The file is damaged.',
      do: 'Copy or download it again. A file that a phone still writes cannot be read yet.',
    },
    times: {
      what: 'These times make no sense as impacts.',
      do: 'One time in seconds on each line, growing; a comma or a dot for decimals.',
    },
    huge: {
      what: 'The file is too large for a browser.',
      do: 'Up to 500 MB, and some forty minutes of sound. Cut it to the minutes with the drop, or use the command line: bouncelab analyze.',
    },
    setting: { what: 'A setting does not go with the others.', do: 'See below, at the settings.' },
    fault: {
      what: 'The laboratory stumbled over this.',
      do: 'What was recorded is kept. Reload the page and open it again; a report to the project helps.',
    },
    keep: {
      what: 'The drop could not be kept.',
      do: 'The storage of the browser is full or closed. Save the sound and the numbers as files instead.',
    },
  },
  wave: {
    title: 'Waveform',
    label: 'Waveform, place of the cursor',
    seconds: (value: string) => `${value} seconds`,
    impactAt: (number: number, seconds: string, certain: boolean) =>
      `impact ${number}, ${seconds}${certain ? '' : ', uncertain'}`,
    add: 'Add impact',
    remove: 'Remove',
    snap: 'Snap to the sound',
    zoomIn: 'Closer',
    zoomOut: 'Wider',
    all: 'All',
    play: 'Hear it',
    stop: 'Stop',
    speed: 'Speed',
    slower: (speed: string) => `${speed} ×`,
    spectrogram: 'Spectrogram',
    spectrogramLabel: 'Spectrogram: time to the right, pitch upwards, louder is darker',
    overview: 'The whole recording; drag to move',
    restore: 'As heard',
    list: 'List of impacts',
    number: 'No.',
    time: 'Time',
    flight: 'Flight after it',
    probability: 'Sure',
    level: 'Level',
    restitution: 'Restitution',
    actions: 'Change',
    removeOne: (number: number) => `Remove impact ${number}`,
    select: (number: number) => `Show impact ${number}`,
    added: (seconds: string) => `Impact added at ${seconds} s.`,
    removed: (number: number) => `Impact ${number} removed.`,
    moved: (number: number, seconds: string) => `Impact ${number} moved to ${seconds} s.`,
    undone: 'Undone.',
    redone: 'Done again.',
    keys: 'Arrow keys move the cursor, with Shift finely; Page Up and Page Down go from impact to impact; plus and minus zoom, 0 shows all; Enter adds an impact, Delete removes the chosen one, comma and full stop move it, S snaps it to the sound; Space plays; Ctrl+Z undoes.',
    pointer:
      'Drag to move, pinch or turn the wheel to zoom (click first), tap an impact to choose it, drag it to move it, double-tap to add one.',
    times: 'These are times only: there is no sound to show.',
  },
  figures: {
    title: 'Figures',
    against: (y: string, x: string) => `${y} against ${x}`,
    reset: 'Drag sideways to zoom, double-click to see all.',
    numbers: 'The same as numbers',
    saveSvg: 'SVG',
    savePng: 'PNG',
    save: 'Save this figure',
    // By the names of the engine.
    tabs: {
      restitution: 'Restitution',
      'flight-times': 'Flights',
      height: 'Height',
      'bounce-heights': 'Heights',
      'bounce-energies': 'Energy',
      comparison: 'Compare',
      posterior: 'Posterior',
      residuals: 'Residuals',
      budget: 'Budget',
      models: 'Laws',
      truncation: 'Truncation',
      drag: 'Drag',
      'drag-log': 'Drag (log)',
    },
  },
  quantities: {
    restitution: 'Restitution e',
    atSpeed: (speed: string) => `at ${speed}`,
    slope: 'Falls with speed by (−d ln e / d ln v)',
    dropHeight: 'Drop height',
    drag: 'Drag coefficient',
    terminal: 'Terminal speed',
    totalTime: 'From release to rest',
    totalPath: 'Path until rest',
    scatter: 'Scatter from bounce to bounce',
    timing: 'Error of the times',
    contact: 'Contact time',
    lineRestitution: 'Straight line: e',
    lineHeight: 'Straight line: drop height',
    lineFlights: 'Straight line: flights',
    energyKept: 'Straight line: energy kept',
    corrected: 'Each bounce corrected for air, median e',
    interval: (range: string) => `95 %: ${range}`,
  },
  settings: {
    ball: 'Ball',
    air: 'Air',
    gravity: 'g',
    change: 'change',
    title: 'What is known',
    assumedHint: 'What nobody stated is assumed, and marked so.',
    own: 'own ball',
    mass: 'Mass',
    diameter: 'Diameter',
    contact: 'Contact time',
    temperature: 'Temperature',
    pressure: 'Pressure',
    humidity: 'Humidity',
    vacuum: 'vacuum',
    noDrag: 'no air',
    gravityField: 'Gravity',
    latitude: 'Latitude',
    altitude: 'Above sea level',
    dragLaw: 'Drag of the air',
    dragNone: 'none, as if there were no air',
    dragConstant: 'constant, C_D = 0.4',
    restitutionLaw: 'Restitution',
    restitutionAny: 'any law that fits',
    laws: {
      constant: 'the same at every speed',
      linear: 'straight line in speed',
      power: 'power law',
      viscoelastic: 'viscoelastic',
      knee: 'constant below a knee',
    } as Record<string, string>,
    measured: 'The drop, if measured',
    height: 'Drop height',
    heightSd: '± of the height',
    flights: 'Flights in the straight line',
    flightsFrom: 'from',
    flightsTo: 'to',
    reset: 'Forget all settings',
    refused: 'These settings do not go together:',
    balls: {
      'table-tennis-40': 'table tennis 40+',
      'table-tennis-38': 'table tennis 38 mm',
      tennis: 'tennis',
      football: 'football',
      basketball: 'basketball',
      golf: 'golf',
      squash: 'squash',
      racquetball: 'racquetball',
      pickleball: 'pickleball',
      padel: 'padel',
    } as Record<string, string>,
  },
  keep: {
    title: 'Keep',
    keep: 'Keep this drop',
    kept: (name: string) => `Kept as “${name}”.`,
    name: 'Name',
    nameHint: 'for example: Anna, first try',
    seeAll: 'Table of drops',
    wav: 'Sound (WAV)',
    csv: 'Table (CSV)',
    json: 'All data (JSON)',
    share: 'Share this set-up',
    shared: 'The address with this set-up was copied.',
    shareByHand: 'Copy this address:',
    report: 'Report (HTML)',
  },
  simulate: {
    title: 'Drop a ball that does not exist',
    lead: 'Move a slider and see what changes; keep a run to compare it with the next.',
    height: 'Drop height',
    restitution: 'Restitution (at 1 m/s)',
    slope: 'Falls with speed by',
    slopeHint: '0: the same at every speed',
    ball: 'Ball',
    drag: 'Drag of the air',
    pressure: 'Air pressure',
    world: 'Where',
    worlds: {
      earth: 'Earth',
      moon: 'Moon',
      mars: 'Mars',
      venus: 'Venus',
      titan: 'Titan',
      jupiter: 'Jupiter',
    } as Record<string, string>,
    keepRun: 'Keep this run',
    hear: 'Hear it',
    stop: 'Stop',
    lay: 'Lay it over the measurement',
    takeOff: 'Take it off the measurement',
    laid: 'It lies over the measurement now, in the figure “Compare”.',
    analyse: 'Analyse it as if it were real',
    runs: 'Runs',
    thisRun: 'this run',
    run: (index: number) => `run ${index}`,
    remove: (name: string) => `Remove ${name}`,
    see: 'Height against time. With air the bounces come sooner and die earlier.',
    seeTimes:
      'Flight times on a logarithmic scale: without air and with constant restitution, a straight line.',
    says: (bounces: string, time: string, path: string) => [
      'It bounces ',
      bounces,
      ' times in ',
      time,
      ' and travels ',
      path,
      '.',
    ],
    terminal: (speed: string) => ['It could never fall faster than ', speed, ' here.'],
    noTerminal: ['There is no air to slow it down.'],
    losses: (surface: string, air: string) => [
      'Of its energy ',
      surface,
      ' goes into the bounces, ',
      air,
      ' into the air.',
    ],
    x: 'time (s)',
    y: 'height (cm)',
    flightY: 'flight time (s)',
    flightX: 'flight',
    impossible: 'This cannot be simulated:',
    address: 'The sliders are in the address: share it, and others see the same run.',
  },
  paper: {
    title: 'The paper, live',
    source: 'M. Nagurka, “Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment”',
    lead: 'Drop a table-tennis ball. Listen. The silences between the bounces tell how bouncy it is and from how high it fell, and they are off by 12 %. Here is the argument, with every number and figure computed as you read.',
    one: {
      title: '1. Silence as a ruler',
      text: [
        'Between two impacts the ball rises and falls for a time T. Without air it left with the speed gT/2 and rose to gT²/8. Nothing but a clock is needed.',
        'If each bounce keeps the share e of the speed, each flight is e times as long as the one before. On a logarithmic scale the flight times lie on a straight line: its slope is log e, and where it begins tells the drop height.',
      ],
      equation: 'log Tₙ = n log e + log (2v₀/g),   h₀ = v₀²/2g',
      see: 'The flight times of a drop from 30.5 cm, without air. Every point on the line; the line finds e and 30.5 cm exactly.',
    },
    two: {
      title: '2. The experiment, and its puzzle',
      text: [
        'The paper dropped a ball of 2.5 g and 38 mm from 30.5 cm. The straight line through its first ten flights said e = 0.9375 and a drop height of 26.7 cm.',
        'That is 3.8 cm too low, 12.3 %: far more than a tape measure errs. The paper names the drag of the air as the likely reason.',
      ],
    },
    three: {
      title: '3. How hard the air pulls',
      text: [
        'At the 2.4 m/s of the first impact, drag is only 6 % of the weight, and it fades with the square of the speed. The paper tries two laws: a constant coefficient of 0.4, and one that depends on the speed. They agree wherever it matters.',
      ],
      equation: 'F/W = ½ ρ A C_D v² / mg',
      see: 'Drag over weight against speed, by both laws. On the log scale a constant coefficient is a straight line of slope 2.',
      first: 'first impact',
      seeHeight:
        'The whole drop with e = 0.935, with air and without: six per cent of the weight, and the ball rests seconds earlier.',
    },
    four: {
      title: '4. Does drag solve the puzzle?',
      text: [
        'Let us do what the paper could not: make drops with air, run the same straight line over them, and see what it says. Choose the bounciness of the ball and how many flights go into the line.',
      ],
      e: 'True restitution of the ball, at 1 m/s',
      slope: 'Falls with speed by',
      flights: 'Flights in the straight line',
      lineSays: (e: string, h: string) => ['The line says e = ', e, ' and h₀ = ', h, '.'],
      paperSays: 'The paper’s line says e = 0.9375 and h₀ = 26.7 cm.',
      truth: 'True drop height: 30.5 cm.',
      hit: 'That is the paper’s result, to its last digit.',
      solveDrag: 'constant e, ten flights',
      solveMany: 'constant e, 21 flights',
      solveSlope: 'e falls with speed, ten flights',
      see: 'Drop height by the straight line, against the number of flights in it. Grey: without air, it never changes as long as the ball is equally bouncy at every speed. Vermilion: with air it sinks with every flight. Blue: what the paper’s line said.',
      x: 'flights in the line',
      y: 'drop height by the line (cm)',
      paperPoint: 'the paper',
    },
    five: {
      title: '5. The resolution',
      text: [
        'Drag with a constant restitution explains about half of the gap: a ball of e = 0.953 would give the paper’s 0.9375, but 28.8 cm.',
        'The rest takes one of two things. Either the ball is a little less bouncy when it is fast, as real balls are; or more flights went into the line than ten. A straight line cannot tell these apart, because its answer depends on how many flights go into it.',
        'So the laboratory on this page does not draw a line. It asks which falls, air and bounciness could have made these very silences, and how surely.',
      ],
      law: 'Restitution',
      drag: 'Air',
      flights: 'Flights',
      first: 'e at 2.4 m/s',
      slow: 'e at 0.5 m/s',
      height: 'The line says h₀',
      same: 'The paper’s 26.7 cm?',
      yes: 'yes',
      no: 'no',
      caption: 'Ways to make the straight line say e = 0.9375',
    },
    six: {
      title: '6. Every number of the paper',
      lead: 'As printed, and as computed here. Misprints of the equations are corrected.',
      quantity: 'Quantity',
      printed: 'Printed',
      computed: 'Computed',
      verdict: 'Verdict',
    },
    verdicts: {
      agrees: 'agrees',
      'agrees-when-corrected': 'agrees when corrected',
      'agrees-within-reading': 'agrees within reading',
      misprint: 'misprint',
      differs: 'differs',
      '': '',
    } as Record<string, string>,
    airNames: {
      none: 'no air',
      'C_D = 0.4': 'C_D = 0.4',
      'C_D(Re)': 'C_D(Re)',
      'C_D(Re), buoyancy, added mass': 'C_D(Re), buoyancy, added mass',
    } as Record<string, string>,
    lawNames: {
      constant: 'constant',
      viscoelastic: 'viscoelastic',
      linear: 'falling, linear',
      power: 'falling, power law',
      'knee at 1.5 m/s': 'falling above 1.5 m/s',
    } as Record<string, string>,
    tryIt: 'Now drop a ball yourself',
  },
  drops: {
    title: 'Table of drops',
    empty:
      'No drop is kept yet. After a drop, “Keep this drop” puts it here, in this browser only.',
    toLab: 'To the laboratory',
    name: 'Name',
    when: 'When',
    ball: 'Ball',
    e: 'Restitution e',
    h: 'Drop height',
    impacts: 'Impacts',
    actions: 'Change',
    open: 'Open',
    openOne: (name: string) => `Open ${name}`,
    delete: 'Delete',
    deleteOne: (name: string) => `Delete ${name}`,
    deleted: (name: string) => `“${name}” was deleted.`,
    choose: (name: string) => `Compare ${name}`,
    compare: 'Compare',
    rename: (name: string) => `Name of ${name}`,
    mean: 'Mean',
    scatter: 'Scatter (standard deviation)',
    ofDrops: (count: number) => `of ${count} ${plural(count, 'drop', 'drops')}`,
    scatterSentence: (mean: string, scatter: string, inside: string) => [
      'On average the ball kept ',
      mean,
      ' of its speed. From drop to drop this scattered by ',
      scatter,
      '; each single drop claims ± ',
      inside,
      '.',
    ],
    see: 'Restitution of each drop with its uncertainty. If the bars miss each other, something changed between the drops.',
    seeRestitution: 'Restitution against speed of the chosen drops, the air taken out.',
    x: 'drop',
    csv: 'Save the table (CSV)',
    json: 'Save all (JSON)',
    deleteAll: 'Delete all',
    deletedAll: (count: number) => `${count} ${plural(count, 'drop was', 'drops were')} deleted.`,
    unavailable: 'The browser keeps nothing here (a private window?).',
  },
};
