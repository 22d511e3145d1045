# What the page itself says; whatever comes from the engine is in the other files.

page-app-title = bouncelab: drop a ball, hear the physics
page-app-skip = Skip to the content
page-app-nav = Pages
page-app-lab = Listen
page-app-simulate = Simulate
page-app-paper = Paper
page-app-drops = Drops
page-app-series = Tests
page-app-language = Language
page-app-to-dark = Dark
page-app-to-light = Light
page-app-privacy = Nothing leaves this device: no account, no server, works offline.
page-app-version = bouncelab { $version }
page-app-book = Tutorial and documents
page-app-engine-failed = The laboratory could not start.
page-app-engine-failed-hint = The browser did not load or run the WebAssembly part. Reload the page; if that does not help, use a current Firefox, Chrome, Edge or Safari.
page-app-newer = A newer version of this page is ready.
page-app-reload = Reload
page-app-undo = Undo
page-app-redo = Redo
page-app-cancel = Cancel
page-app-number-wanted = A number{ $most ->
    [none] { $least ->
        [none] {""}
       *[other] {" "}of at least { $least }
      }
   *[other] {" "}from { $least } to { $most }
  } is expected here.
page-app-drop-here = Release to open the file
page-app-unreadable-link = Some settings in the address are not valid and were ignored: { $parts }.

page-lab-invite = Drop a ball near your microphone.
page-lab-invite-touch = Drop a ball near your phone.
page-lab-lead = The times between the bounces tell how much of its speed and energy the ball keeps, and from how high it fell.
page-lab-listen = Listen
page-lab-stop = Stop
page-lab-again = Listen again
page-lab-open = open a file
page-lab-rate = Sampling rate
page-lab-rate-open = Read as sound
page-lab-paste = paste times
page-lab-demo = try the demo
page-lab-open-label = Recording or list of impact times
page-lab-paste-label = Impact times in seconds, one on each line
page-lab-paste-hint = From a spreadsheet or an oscilloscope. The flights are between the impacts.
page-lab-paste-do = Analyse
page-lab-pasted-name = pasted times
page-lab-demo-name = demo
page-lab-recording-name = drop { $date }
page-lab-starting = Asking for the microphone …
page-lab-listening = Listening. Drop the ball.
page-lab-hint-quiet = Nothing loud was heard yet: put the microphone nearer to where the ball lands.
page-lab-hint-no-bounces = There are sounds, but no bounces: put the phone nearer to where the ball lands, on a hard floor, and let it bounce until it rests.
page-lab-so-far = { $count ->
    [one] 1 impact so far
   *[other] { $count } impacts so far
  }
page-lab-so-far-keeps = it keeps about { $share } of its speed
page-lab-ends-itself = Listening ends when the ball rests.
page-lab-saved = { $seconds } s are saved.
page-lab-result = Result
page-lab-opening = Reading { $name } …
page-lab-cannot-tell = There are too few impacts to determine the restitution.
page-lab-impacts = { $count ->
    [one] 1 impact
   *[other] { $count } impacts
  }
page-lab-uncertain = { $count } uncertain
page-lab-edited = edited by hand
page-lab-drop-of = Drop { $index } of { $count }
page-lab-drops-heard = Drops in this recording
page-lab-why = With and without air
page-lab-why-air-1 = A straight line through the logarithms of the flight times (log-linear fit) is the classic way to measure restitution. But air also slows the ball, and the fit attributes this to the impacts.
page-lab-why-air-2 = The grey points neglect the air; the blue ones are corrected for drag. They show the ball and the surface alone.
page-lab-refining = Computing the inference with air …
page-lab-more = All numbers
page-lab-other-quantities = Other quantities
page-lab-tells = What this recording determines, and what not
page-lab-narrowed-lead = How much the recording reduced the prior uncertainty:
page-lab-narrowed = { $unknown }: { $share } of the width remains
page-lab-assumed = assumed
page-lab-no-drop-title = No drop found.
page-lab-possible-drop = Possibly a drop from { $start } s: { $impacts } impacts, probability { $probability }.
page-lab-accept = It is a drop
page-lab-no-drop-hint = Put the microphone close to where the ball lands, on a hard surface, and let it bounce until it rests. If you can see the impacts in the waveform, mark them by hand: double-click, or press Enter at the cursor.
page-lab-no-drop-hint-touch = Put the phone close to where the ball lands, on a hard surface, and let it bounce until it rests. If you can see the impacts in the waveform, mark them by hand with a double tap.
page-lab-interrupted-title = A recording of { $date } was interrupted.
page-lab-progress = Progress
page-lab-processed = The device changes the sound although it was asked not to: { $what }. Faint impacts may be missing. Another browser or an external microphone helps.
page-lab-processed-echoCancellation = echo cancellation
page-lab-processed-noiseSuppression = noise suppression
page-lab-processed-autoGainControl = automatic gain
page-lab-unkept-title = The recording of { $date } is not in the table of drops.
page-lab-interrupted-hint = It is kept, except perhaps for its last second or two.
page-lab-interrupted-open = Open it
page-lab-interrupted-drop = Delete it

page-rest-title = Speech and vibration, when the ball rests
page-rest-speech = Speak the answer
page-rest-vibration = Vibrate
page-rest-plus-minus = plus or minus

page-words-restitution = Restitution is the speed just after an impact over the speed just before it: 90 % means that the ball loses a tenth of its speed.
page-words-bounce-energies = Energy grows with the square of the speed: a ball that keeps 90 % of its speed keeps 81 % of its energy.
page-words-height = The drop height is computed from the times between the impacts. The curve shows how high the ball rose after each of them.
page-words-uncertainty = ± is the standard uncertainty: with a probability of about two thirds the true value lies within it, with 95 % within twice of it.
page-words-flight-times = A flight is the time from one impact to the next. Without air and with the same restitution at every speed, each would last the same part of the one before.
page-words-bounce-heights = How high the ball rose after each impact, computed from the time until the next one.
page-words-comparison = The height of the ball as the model computes it, and as you simulated it: where they differ, one of them is wrong.
page-words-posterior = The posterior is what is known after the measurement: how probable each value is, given the impact times and what was known before.
page-words-residuals = A residual is the measured time of an impact minus that of the model. They should scatter without a pattern.
page-words-budget = The budget of uncertainty lists its sources and the share of each. To know the answer better, begin with the largest.
page-words-models = A law says how the restitution depends on the speed. Each is weighed by how well it predicts the impact times.
page-words-truncation = The answer from the first two flights, three, and so on. It should not change with their number.
page-words-drag = Drag is the force of the air against the motion. It grows about with the square of the speed.
page-words-drag-log = The same on axes on which each step is a factor: a power of the speed is a straight line.

page-faults-refused-what = The browser may not use the microphone.
page-faults-refused-do = Allow it in the address bar (the lock or microphone sign) and tap Listen again. On a phone, also look into the settings of the browser app. You can open a recording instead.

page-faults-missing-what = No microphone was found.
page-faults-missing-do = Plug one in and tap Listen again, or record with another device and open the file here.

page-faults-busy-what = The microphone is used by another program.
page-faults-busy-do = Close calls and recorders, then tap Listen again.

page-faults-insecure-what = Browsers give the microphone only to pages with https, or from this computer itself.
page-faults-insecure-do = Open this page with https or through localhost. Recordings can be opened as it is.

page-faults-unsupported-what = This browser does not provide unprocessed sound.
page-faults-unsupported-do = Use a current Firefox, Chrome, Edge or Safari, or open a recording.

page-faults-ended-what = The microphone was disconnected: unplugged, or used by a call.
page-faults-ended-do = The sound recorded until then is kept and analysed.

page-faults-unknown-what = The microphone could not be opened.
page-faults-unknown-do = Unplug and plug it in again, or restart the browser. You can open a recording instead.

page-faults-silent-what = The microphone gives only silence.
page-faults-silent-do = It may be muted by a switch or in the system settings.

page-faults-full-what = The storage of the browser is full.
page-faults-full-do = The sound is complete in memory: save it as WAV now. Then delete drops that you do not need.

page-faults-unavailable-what = The browser stores nothing here (a private window?).
page-faults-unavailable-do = The sound is complete in memory until this page closes: save it as WAV.

page-faults-empty-what = The file is empty.
page-faults-empty-do = Nothing was written into it. Was the recording stopped before it began? Record again or choose another file.

page-faults-unsupported-file-what = This is neither a recording nor a list of times.
page-faults-unsupported-file-do = Sounds: { $formats }. Lists: one time in seconds on each line.

page-faults-damaged-what = The file is damaged.
page-faults-damaged-do = Copy or download it again. A file that a phone still writes cannot be read yet.

page-faults-times-what = These times cannot be impact times.
page-faults-times-do = Give one time in seconds on each line, in increasing order, with a comma or a point for decimals.
page-faults-rate-what = The table does not state when its samples were taken.
page-faults-rate-do = State the sampling rate: how many samples a second the device took, often 44100 or 48000.

page-faults-huge-what = The file is too large for a browser.
page-faults-huge-do = Up to two hours of sound in two channels, or four in one. Cut it to the minutes with the drop, or use the command line: bouncelab analyze.

page-faults-setting-what = A setting contradicts the others.
page-faults-setting-do = See below, at the settings.

page-faults-fault-what = The analysis failed.
page-faults-fault-do = What was recorded is kept. Reload the page and open it again; a report to the project helps.

page-faults-link-what = This link of a drop cannot be used.
page-faults-link-do = Copy the whole link, or scan the code again.

page-faults-no-drop-what = No bouncing ball was found in it.
page-faults-no-drop-do = Open it in the laboratory: there you can listen to it and mark impacts.

page-faults-series-full-what = The storage of the browser is full: this drop does not count yet.
page-faults-series-full-do = What was kept before is there, unchanged. Save this sound as a file, delete drops or series that you do not need, and try again.

page-faults-series-known-what = This recording counts already.
page-faults-series-known-do = Each recording counts once. Choose that of another drop.

page-faults-series-storage-what = The browser could not store it.
page-faults-series-storage-do = What was kept before is there, unchanged. A private window stores nothing: use an ordinary one.

page-faults-archive-what = This is no whole file of kept drops.
page-faults-archive-do = Copy or download it again, and add that one. What is kept here has not changed.

page-faults-bad-drop-what = This drop is none that this page could have kept.
page-faults-bad-drop-do = Ask for its recording or its link. The other drops of the file were added.

page-faults-archive-newer-what = A newer version of this page saved this file.
page-faults-archive-newer-do = Reload the page, and add the file again. What is kept here has not changed.

page-faults-archive-storage-what = Not all of the file could be kept.
page-faults-archive-storage-do = The storage of the browser is full or not available. Delete drops that you do not need, and add the file again; what was kept before has not changed.

page-faults-keep-what = The drop could not be kept.
page-faults-keep-do = The storage of the browser is full or not available. Save the sound and the numbers as files instead.

page-wave-title = Waveform
page-wave-label = Waveform, position of the cursor
page-wave-seconds = { $value } seconds
page-wave-impact-at = impact { $number }, { $seconds }{ $certain ->
    [yes] {""}
   *[no] , uncertain
  }
page-wave-add = Add impact
page-wave-remove = Remove
page-wave-snap = Snap to the sound
page-wave-zoom-in = Zoom in
page-wave-zoom-out = Zoom out
page-wave-all = All
page-wave-amplitude = Height of the waveform
page-wave-amplitude-whole = height: recording
page-wave-amplitude-view = height: view
page-wave-amplitude-decibels = height: decibels
page-wave-play = Play
page-wave-stop = Stop
page-wave-speed = Speed
page-wave-slower = { $speed } ×
page-wave-spectrogram = Spectrogram
page-wave-spectrogram-label = Spectrogram: time to the right, frequency upwards, louder is darker
page-wave-overview = The whole recording; drag to move
page-wave-restore = As detected
page-wave-list = List of impacts
page-wave-number = No.
page-wave-time = Time
page-wave-flight = Flight after it
page-wave-probability = Probability
page-wave-level = Level
page-wave-restitution = Restitution
page-wave-actions = Change
page-wave-remove-one = Remove impact { $number }
page-wave-select = Show impact { $number }
page-wave-added = Impact added at { $seconds } s.
page-wave-removed = Impact { $number } removed.
page-wave-moved = Impact { $number } moved to { $seconds } s.
page-wave-undone = Undone.
page-wave-redone = Redone.
page-wave-keys = Arrow keys move the cursor, with Shift in small steps; Page Up and Page Down go from impact to impact; plus and minus zoom, 0 shows all; Enter adds an impact, Delete removes the selected one, comma and full stop move it, S snaps it to the sound; Space plays; Ctrl+Z undoes.
page-wave-pointer = Drag to move, pinch or turn the wheel to zoom (click first), tap an impact to select it, drag it to move it, double-tap to add one.
page-wave-times = There are only times: no sound to show.

page-figures-title = Figures
page-figures-more = More figures
page-figures-fewer = Fewer figures
page-curve-label = Height of the ball against time; the first hop detected rises to { $height }
page-figures-against = { $y } against { $x }
page-figures-reset = Drag sideways to zoom, double-click to see all.
page-figures-numbers = The same as numbers
page-figures-save-svg = SVG
page-figures-save-png = PNG
page-figures-save-csv = CSV
page-figures-save = Save this figure

page-settings-ball = Ball
page-settings-air = Air
page-settings-gravity = g
page-settings-change = change
page-settings-title = Known quantities
page-settings-assumed-hint = Air and gravity that are not stated are assumed. Without a stated ball every kind of ball that the times allow counts, and the intervals are wider.
page-settings-own = own ball
page-settings-mass = Mass
page-settings-diameter = Diameter
page-settings-contact = Contact time
page-settings-temperature = Temperature
page-settings-pressure = Pressure
page-settings-humidity = Humidity
page-settings-vacuum = vacuum
page-settings-no-drag = no air
page-settings-gravity-field = Gravity
page-settings-measure-g = measure g: state the drop height too
page-settings-latitude = Latitude
page-settings-altitude = Altitude above sea level
page-settings-drag-law = Drag of the air
page-settings-drag-none = none, air neglected
page-settings-drag-standard = standard curve of a sphere
page-settings-drag-table = own table of C_D
page-settings-restitution-law = Restitution
page-settings-restitution-any = all laws
page-settings-measured = The drop, if measured
page-settings-height = Drop height
page-settings-height-sd = ± of the height
page-settings-flights = Flights of the log-linear fit
page-settings-flights-from = from
page-settings-flights-to = to
page-settings-reset = Reset all settings
page-settings-refused = These settings contradict each other:

page-ball-row = Which ball?
page-ball-other = other: size and weight

page-setup-named = { $name }: { $value }
page-setup-offered = This link states: { $what }. Your own drops do not have it unless you want it.
page-setup-laws = other models of the analysis
page-setup-take = use it for my drops
page-setup-leave = leave it
page-setup-unusual = Analysed with: { $what }.
page-setup-reset = Reset

page-keep-title = Keep
page-keep-keep = Keep this drop
page-keep-long-sound = The sound is longer than half an hour: only the drop is kept, and its file is not.
page-keep-kept = Kept as “{ $name }”.
page-keep-name = Name
page-keep-name-hint = for example: Anna, first try
page-keep-see-all = Table of drops
page-keep-lasting = The browser keeps what is here until you delete it.
page-keep-not-lasting = If space gets short, the browser may delete what is kept here: save a copy as a file.
page-keep-for-a-week = This browser deletes what a page keeps after seven days without a visit, unless the page is on the home screen (Share, “Add to Home Screen”): save a copy as a file.
page-keep-commas = tables with semicolons and decimal commas
page-keep-wav = Sound (WAV)
page-keep-csv = Table (CSV)
page-keep-json = All data (JSON)
page-keep-share = Share this set-up
page-keep-shared = The address with this set-up was copied.
page-keep-share-by-hand = Copy this address:
page-keep-report = Report (HTML)
page-keep-link = Share this drop
page-keep-link-qr = QR code of the address of this drop

page-simulate-title = Simulate a drop
page-simulate-lead = Move a slider and see what changes; keep a run to compare it with the next.
page-simulate-height = Drop height
page-simulate-restitution = Restitution (at 1 m/s)
page-simulate-slope = Falls with speed by
page-simulate-slope-hint = 0: the same at every speed
page-simulate-law = Restitution law
page-simulate-law-of-sliders = constant or falling, by the sliders
page-simulate-law-numbers = Law with its numbers
page-simulate-ball = Ball
page-simulate-drag = Drag of the air
page-simulate-pressure = Air pressure
page-simulate-body = Where

page-simulate-bodies-earth = Earth
page-simulate-bodies-moon = Moon
page-simulate-bodies-mars = Mars
page-simulate-bodies-venus = Venus
page-simulate-bodies-titan = Titan
page-simulate-bodies-jupiter = Jupiter
page-simulate-keep-run = Keep this run
page-simulate-hear = Play the sound
page-simulate-stop = Stop
page-simulate-lay = Compare with the measurement
page-simulate-take-off = Remove from the comparison
page-simulate-laid = It is compared with the measurement now, in the figure “Compare”.
page-simulate-analyse = Analyse its sound
page-simulate-runs = Runs
page-simulate-this-run = this run
page-simulate-run = run { $index }
page-simulate-remove = Remove { $name }
page-simulate-says = It bounces { $bounces } times in { $time } and travels { $path }.
page-simulate-terminal = Its terminal speed here is { $speed }.
page-simulate-no-terminal = There is no air, so there is no terminal speed.
page-simulate-losses = Of its energy { $surface } is lost in the impacts, { $air } to the air.
page-simulate-impossible = This cannot be simulated:
page-simulate-address = The address contains the settings: share it, and others see the same run.

page-paper-title = The paper
page-paper-source = M. Nagurka, “Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment”
page-paper-lead = Drop a table-tennis ball and listen. The times between the impacts give its restitution and its drop height, but the height comes out 12 % too low. This page explains why, and computes every number and figure while you read.

page-paper-one-title = 1. From times to heights
page-paper-one-text-1 = Between two impacts the ball rises and falls for a time T. Without air it leaves the surface with the speed gT/2 and rises to gT²/8. Only a clock is needed.
page-paper-one-text-2 = If each impact keeps the share e of the speed, each flight is e times as long as the one before. On a logarithmic scale the flight times lie on a straight line: its slope is log e, and its intercept gives the drop height. This is the log-linear fit.
page-paper-one-equation = log Tₙ = n log e + log (2v₀/g),   h₀ = v₀²/2g
page-paper-one-see = The flight times of a drop from 30.5 cm, without air. Every point is on the line; the fit gives e and 30.5 cm exactly.

page-paper-two-title = 2. The experiment, and a discrepancy
page-paper-two-text-1 = The paper dropped a ball of 2.5 g and 38 mm from 30.5 cm. The log-linear fit to its first ten flights gave e = 0.9375 and a drop height of 26.7 cm.
page-paper-two-text-2 = That is 3.8 cm or 12.3 % too low, far more than the error of a tape measure. The paper names air drag as the likely reason.

page-paper-three-title = 3. The strength of air drag
page-paper-three-text = At the 2.4 m/s of the first impact, drag is only 6 % of the weight, and it decreases with the square of the speed. The paper tries two laws: a constant coefficient of 0.4, and one that depends on the speed. They agree where drag matters.
page-paper-three-equation = F/W = ½ ρ A C_D v² / mg
page-paper-three-see = Drag over weight against speed, by both laws. On the log scale a constant coefficient is a straight line of slope 2.
page-paper-three-see-height = The whole drop with e = 0.935, with air and without: with a drag of six per cent of the weight, the ball rests seconds earlier.

page-paper-four-title = 4. Does drag explain the discrepancy?
page-paper-four-text = Simulate drops with air, apply the same log-linear fit, and compare with the paper. Choose the restitution of the ball and the number of flights in the fit.
page-paper-four-e = True restitution of the ball, at 1 m/s
page-paper-four-slope = Falls with speed by
page-paper-four-flights = Flights in the fit
page-paper-four-line-says = The fit gives e = { $e } and h₀ = { $h }.
page-paper-four-paper-says = The fit of the paper gives e = 0.9375 and h₀ = 26.7 cm.
page-paper-four-truth = True drop height: 30.5 cm.
page-paper-four-hit = That is the result of the paper, to its last digit.
page-paper-four-solve-drag = constant e, ten flights
page-paper-four-solve-many = constant e, 21 flights
page-paper-four-solve-slope = e falls with speed, ten flights
page-paper-four-see = Drop height by the log-linear fit, against the number of flights in it. Grey: without air it is the same for all numbers, if restitution is constant. Vermilion: with air it decreases with every flight. Blue: the result of the paper.

page-paper-five-title = 5. The explanation
page-paper-five-text-1 = Drag with a constant restitution explains about half of the difference: a ball of e = 0.953 gives the 0.9375 of the paper, but 28.8 cm.
page-paper-five-text-2 = There are two explanations of the rest: restitution falls a little with speed, as for real balls, or more than ten flights were used in the fit. The log-linear fit cannot distinguish them, because its result depends on the number of flights.
page-paper-five-text-3 = So the laboratory on this page infers drop height, drag and restitution together from the impact times, with their uncertainties.
page-paper-five-law = Restitution
page-paper-five-drag = Air
page-paper-five-flights = Flights
page-paper-five-first = e at 2.4 m/s
page-paper-five-slow = e at 0.5 m/s
page-paper-five-height = h₀ of the fit
page-paper-five-same = The paper’s 26.7 cm?
page-paper-five-yes = yes
page-paper-five-no = no
page-paper-five-caption = Models for which the log-linear fit gives e = 0.9375; knees are at 1.5 m/s

page-paper-six-title = 6. Every number of the paper
page-paper-six-lead = As printed, and as computed here. Misprints of the equations are corrected.
page-paper-six-quantity = Quantity
page-paper-six-printed = Printed
page-paper-six-computed = Computed
page-paper-six-verdict = Verdict

page-paper-verdicts-agrees = agrees
page-paper-verdicts-agrees-when-corrected = agrees when corrected
page-paper-verdicts-agrees-within-reading = agrees within reading
page-paper-verdicts-misprint = misprint
page-paper-verdicts-differs = differs
page-paper-verdicts- = {""}

page-paper-air-names-none = no air
page-paper-air-names-constant = C_D = 0.4
page-paper-air-names-sphere = C_D(Re)
page-paper-air-names-all-of-air = C_D(Re), buoyancy, added mass

page-paper-try-it = Now drop a ball yourself

page-drops-title = Table of drops
page-drops-empty = No drop is kept yet. After a drop, “Keep this drop” puts it here, in this browser only.
page-drops-to-lab = To the laboratory
page-drops-name = Name
page-drops-when = When
page-drops-ball = Ball
page-drops-e = Restitution e
page-drops-h = Drop height
page-drops-impacts = Impacts
page-drops-actions = Change
page-drops-open = Open
page-drops-open-one = Open { $name }
page-drops-delete = Delete
page-drops-delete-one = Delete { $name }
page-drops-deleted = “{ $name }” was deleted.
page-drops-choose = Compare { $name }
page-drops-compare = Compare
page-drops-rename = Name of { $name }
page-drops-mean = Mean
page-drops-scatter = Scatter (standard deviation)
page-drops-of-drops = { $count ->
    [one] of 1 drop
   *[other] of { $count } drops
  }
page-drops-scatter-sentence = On average the ball kept { $mean } of its speed. The standard deviation between drops was { $scatter }; each single drop states ± { $inside }.
page-drops-csv = Save the table (CSV)
page-drops-json = Save all (JSON)
page-drops-archive = Save all with sound (ZIP)
page-drops-archiving = Collecting the sounds …
page-drops-adding = Reading { $name } …
page-drops-added = { $count ->
    [0] Nothing in it is new.
    [one] 1 drop was added.
   *[other] { $count } drops were added.
  }
page-drops-delete-all = Delete all
page-drops-deleted-all = { $count ->
    [one] 1 drop was deleted.
   *[other] { $count } drops were deleted.
  }
page-drops-links = Links of other people’s drops, as many as you like
page-drops-links-do = Add to this table
page-drops-unavailable = The browser stores nothing here (a private window?).

page-class-ball = Ball
page-class-surface = Surface
page-class-student = Student
page-class-ball-of = Ball of { $name }
page-class-surface-of = Surface of { $name }
page-class-student-of = Student of { $name }
page-class-add = Add drops
page-class-add-hint = Files of any kind that this page saves or opens, as many as you like, also as ZIP; and links. What is damaged is named, the rest is added.
page-class-files = Choose files
page-class-files-label = Files with drops
page-class-known = { $count ->
    [one] 1 is in the table already.
   *[other] { $count } are in the table already.
  }
page-class-groups = Groups
page-class-details = Details
page-class-by = Group by
page-class-report = Save the report (HTML)
page-class-sheets = Lesson sheets
page-class-sheet-bounciness = How bouncy is a ball?
page-class-sheet-air = How much does air take?
page-class-sheet-gravity = Measure g with a ball
page-class-sheet-html = to print
page-class-sheet-markdown = as text to edit
page-class-sheets-hint = The address on the sheets is that of the lesson above, or of this page while no ball is chosen.

page-verdict-title = Judge by a rule
page-verdict-rule = Rule
page-verdict-reference = Reference surface
page-verdict-kept = Kept, as you state:
page-verdict-ball = The rule names no ball: choose it first.
page-verdict-unlike = These drops have different balls or other settings. Tick those of one ball.
page-verdict-report = Save the verdict (HTML)

page-lesson-title = What you drop
page-lesson-name = Your name
page-lesson-leave = leave the lesson
page-lesson-who = Write your name below, then hand the drop in.
page-lesson-make = Class: a link for all pupils
page-lesson-make-hint = Choose what the lesson drops. The page of a pupil then asks for name, ball, surface and height, and nothing else.
page-lesson-balls = Balls
page-lesson-surfaces = Surfaces, with commas between them
page-lesson-heights = Drop heights in cm, with semicolons between them; none if they are to be measured
page-lesson-qr = QR code of the lesson
page-hand-in = Hand in
page-hand-share = Share …
page-hand-copy = Copy the link
page-hand-copied = Copied.
page-scan = Scan QR codes
page-scan-stop = Stop scanning
page-scan-refused = The camera cannot be used. Allow it in the address bar, or let the links be sent.
page-class-all-balls = Ball of the { $count } chosen
page-class-all-surfaces = Surface of the { $count } chosen

page-reason-counted = It is recording { $number } of this series.
page-reason-empty-content = It contains no data.
page-reason-empty-sound = It has a header, but no sound.
page-reason-empty-time = There is no time in it.
page-reason-not-sound = It looks like { $kind }.
page-looks-png = a PNG picture
page-looks-jpeg = a JPEG picture
page-looks-gif = a GIF picture
page-looks-pdf = a PDF document
page-looks-zip = a ZIP archive or an office document
page-looks-gzip = a gzip archive
page-looks-riff = a RIFF file without sound, such as AVI or WebP
page-looks-zeros = nothing but zeros
page-looks-text = text
page-looks-unknown = data of an unknown kind
page-reason-malformed = { $stage ->
    [header] Its header cannot be read
    [codec] Its decoder cannot be set up
   *[sound] None of its sound can be decoded
  } ({ $format }: { $detail }).
page-reason-no-audio-track = This { $format } file has no sound, or none of a known kind. Was the microphone off?
page-reason-unsupported-codec = The sound in this { $format } file cannot be decoded: { $codec }. Export it as WAV or M4A.
page-reason-layout-too-slow = { $sample_rate_hz } samples a second are too few to time an impact: it takes at least { $min_hz }.
page-reason-layout-too-fast = Its header claims { $sample_rate_hz } samples a second; at most { $max_hz } are read.
page-reason-layout-too-many-channels = It has { $channels } channels; at most { $max } are read.
page-reason-lasts-too-long = It lasts longer than { $max_h } hours, which is as much as is read. Cut it into parts.
page-reason-times-line = Line { $line }: { $problem }
page-reason-times-ending = The name of a list ends in .txt, .csv, .tsv, .xls, .xlsx, .ods, .zip, .json, .TextGrid or .svl.
page-reason-times-not-text = It is not text. Save the list as text, CSV or a sheet.
page-reason-times-not-table = It is not a table ({ $detail }).
page-reason-times-not-file = It is a device or a pipe; save the list in a file.
page-reason-times-too-long = It is more than { $max_mb } MB of text; save the sound as WAV.
page-reason-times-not-sample = “{ $text }” is not a number; below its headings a sampled waveform has numbers alone.
page-reason-times-fewer-columns = { $found } of { $columns } numbers: a sampled waveform has one for the time and one for each channel in every row.
page-reason-times-uneven = It is { $interval_s } s after the row before, but rows are { $mean_s } s apart on average; the times of a sampled waveform have equal distances.
page-reason-times-sampled = It is a table of { $rows } samples, { $rate_hz } a second, and no list of impact times; sound needs at least { $min_hz } a second. List the times of the impacts.
page-reason-times-positions = It holds positions over time ({ $found }) and no impact times. Open the recording, or list the times of the impacts.
page-reason-times-several-drops = It has several columns of times ({ $found }) and { $rows } rows. A list has one drop: one column of times, or one row of stops.
page-reason-times-no-rate = { $rows } samples without times, and no list of impact times: save the sound as WAV, add a column of times, or open it in the laboratory and state its sampling rate.
page-reason-times-no-order = { $number } follows { $before }. Numbers without a heading are impact times, which increase, or intervals, which decrease. Write time_s or interval_s above them; samples need a column of times.
page-reason-times-not-interval = { $text } is no interval from one impact to the next, which is above 0 s.
page-reason-times-not-layer = It is not a layer of Sonic Visualiser with points. Export it again (File > Export Annotation Layer).
page-reason-times-no-list = None of its tables is a list of impact times: { $found }. Open a recording by itself, and recordings of a class as files or a folder.
page-reason-times-tables-disagree = The tables { $first } and { $second } hold different times. Keep one of them.
page-reason-times-of-recordings = It is a table about recordings, and no list of impact times. Open the recordings.
page-reason-times-not-array = A list of numbers was expected, as in [0.1, 0.45] ({ $detail }).
page-reason-times-not-text-grid = It is not a TextGrid of Praat, or not all of one. Save it from Praat again.
page-reason-times-no-point-tier = No tier has points, only intervals: { $found }. In Praat, add a tier with a point at each impact (Tier > Add point tier…).
page-reason-times-which-point-tier = Several tiers have points: { $found }. In Praat, name that of the impacts “impacts”.
page-reason-times-no-time-column = No heading has a word for time or impact with a unit, such as time_s, Time (s) or interval_s. There are: { $found }.
page-reason-times-nameless-columns = There are { $columns } columns. Name the one with the times in a first line: time_s.
page-reason-times-more-columns = It has { $found } columns, but the first line has { $columns }. Where commas are decimal, separate columns with semicolons.
page-reason-times-missing = The time is missing.
page-reason-times-not-number = “{ $text }” is not a time in seconds, such as 0.125.
page-reason-times-not-later = { $time_s } does not come after { $before_s }. List the impacts in order.
page-reason-too-long = It has more than { $minutes } minutes in { $channels ->
    [one] 1 channel
   *[other] { $channels } channels
  }.
page-reason-no-memory = This device has not enough memory for it.
page-reason-breaks-decoder = It is damaged, and its decoder fails on it.
page-reason-unreadable = The browser cannot read it. Was it moved or deleted?
page-reason-link-changed = It was changed, or is incomplete.
page-reason-link-other-version = Another version of this page made it; reload the page.
page-reason-link-times = A link holds 2 to 1000 impacts.
page-reason-link-too-long = The drop has too many impacts for a QR code.

page-series-title = Test series
page-series-lead = A test by a rule, drop after drop and place after place, with the report of a laboratory.
page-series-known = Kept in this browser
page-series-open = Go on with { $name }
page-series-delete = Delete
page-series-delete-hint = Its recordings go too. Save the series as a ZIP first if you need it.
page-series-delete-really = Delete { $name } with its recordings
page-series-new = A new series
page-series-name = Name, as of the floor or the ball
page-series-ball = Ball
page-series-places = Places
page-series-drops = Drops in each place
page-series-as-the-rule = What you leave empty is as the rule asks for. The method is first checked on a synthesised recording.
page-series-begin = Begin the series
page-series-all = All test series
page-series-complete = Every place has its drops.
page-series-damaged = { $count ->
    [one] A line of the journal is damaged and does not count.
   *[other] { $count } lines of the journal are damaged and do not count.
}
page-series-files = add recordings
page-series-files-label = Recordings of the next drops
page-series-operator = Who drops the ball
page-series-places-done = Places done: { $done } of { $all }
page-series-place-done = (done)
page-series-recordings = Recordings
page-series-repeat = Repeat drop { $number }
page-series-reason = Why it does not count
page-series-repeat-do = Repeat { $number }; its sound stays
page-series-notes = What the report states
page-series-notes-keep = Keep what is stated
page-series-report = Save the report (HTML)
page-series-one-page = Page for the client (HTML)
page-series-zip = Save the whole series (ZIP)
page-series-zip-hint = Unpacked, the ZIP is a folder for the program: bouncelab job show FOLDER. It has every recording with its SHA-256, also those that were repeated.
page-series-microphone = microphone
page-series-interrupted = microphone, interrupted
page-series-count-interrupted = Count it as the next drop
page-series-keep-again = Try again
page-series-save-sound = Save the sound as a file
