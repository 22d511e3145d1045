# What the command line prints. Names of options and commands are not translated.

terminal-note = Note: { $text }
terminal-assumed = Assumed: { $list }
analyze-balls-heading = What the times say of each ball, against the one that was stated or assumed:
terminal-cannot-tell = { $what }: cannot tell: { $reason }

analyze-times = { $origin ->
    [none] { $name }: impact times
   *[other] { $name }: impact times, { $origin }
  }
analyze-sound = { $name }: { $format }, { $rate } kHz{ $channels ->
    [1] {""}
   *[other] , channel { $channel } of { $channels }
  }, { $duration } s
analyze-listening = { $onsets } sounds stand out from the background and { $impacts } impacts were detected, with the highest contrast from { $low } to { $high } Hz, { $above } dB above the preceding sound (--channel, --band).
analyze-drop = { $drops ->
    [1] Drop
   *[other] Drop { $number } of { $drops }
  }: { $count } impacts from { $first } s to { $last } s{ $uncertain ->
    [0] {""}
   *[other] , { $uncertain } uncertain (?)
  }{ $probability ->
    [none] {""}
   *[other] {" "}(a drop with probability { $probability })
  }
analyze-line = Log-linear fit
analyze-line-heading = Log-linear fit of the flight times, neglecting the air:
analyze-corrected = Corrected for drag
analyze-corrected-heading = Corrected for drag ({ $law }):
analyze-inference-heading = Inference, with air:

analyze-details-models = Models, with equal prior probability:
analyze-details-budget-restitution = Uncertainty budget of e:
analyze-details-budget-height = Uncertainty budget of h0:
analyze-details-contraction = Prior contraction by the data:
analyze-details-correlations = Correlations of the estimates:
analyze-details-impacts = Impacts in the fit:
analyze-details-priors = Priors:
analyze-details-sampling = Sampling: { $draws } independent draws, Pareto shape { $shape } (good below 0.7).
analyze-no-drop = { $name }: no drop found: { $reason }
analyze-detecting = detecting { $bar } { $done } s, { $left } left
analyze-inferring = inferring from { $impacts } impacts (--no-inference leaves it out)
analyze-one-report = a report is for one recording, and several were given; bouncelab session reports on several
analyze-cues-of-file = --cues copies a recording, so it needs a file instead of standard input
analyze-input-too-long = standard input is longer than 1 GiB, which is held in memory; save it to a file
analyze-one-labelled = labels, markers and motion are of one recording, and several were given; give one at a time
analyze-cues-need-sound = { $name } is a list of times, which has no sound to mark; --format audacity or textgrid writes labels

terminal-wrote = wrote { $file }
terminal-not-printed = { $browser } did not print the report: { $reason }
terminal-no-browser = A PDF is printed by Chromium, Chrome or Edge, and none was found. Install one, or write the report as .html and print it.
terminal-wrote-figure = wrote { $file }, .png, .pdf and .csv
terminal-first-figures = The first { $count } drops have figures of their own; results for programs have all.
terminal-all-shown = ... and { $count } more; --format csv has them all.

demo-heading = A drop from 30.5 cm, synthesised, detected and analysed ({ $file })
demo-truth = truth
demo-detected = measured
demo-flight-time-error = largest error of a flight time
demo-restitution-line = e, log-linear fit, 10 flights
demo-restitution-inference = e, inference
demo-height-line = drop height, log-linear fit
demo-height-inference = drop height, inference
demo-second-speed = speed of the second impact
demo-conclusion =
    The log-linear fit neglects the drag: its restitution and drop height are too low.
    The inference includes the air and recovers both.

simulate-heading = A drop of a ball ({ $ball }), simulated
simulate-bounces = bounces
simulate-first-speed = speed of the first impact
simulate-no-terminal-speed = none
simulate-total-time = time until the end
simulate-total-path = path until the end
simulate-initial-energy = energy at the start
simulate-lost-to-surface = lost to the surface
simulate-lost-to-air = lost to the air
simulate-each-bounce = Each bounce, with drag { $law }:
simulate-bounce = bounce
simulate-to-surface = to surface µJ
simulate-to-air = to air µJ
simulate-drag = drag { $law }

synth-made = { $file }: { $count ->
    [one] 1 impact
   *[other] { $count } impacts
  } in { $seconds } s, { $rate } Hz, seed { $seed }

puzzle-question = The discrepancy: what makes the log-linear fit give e = 0.9375 and h0 = 26.7 cm for a drop from 30.5 cm?
puzzle-flights = flights
puzzle-first = e at 2.4 m/s
puzzle-slow = e at 0.5 m/s
puzzle-height = fitted h0 cm
puzzle-solved = the paper's 26.7?
puzzle-yes = yes
puzzle-no = no
puzzle-answer =
    Each law was chosen so that the fit gives e = 0.9375; knees are at 1.5 m/s. Drag with a constant restitution
    gives 26.7 cm only with about 21 flights in the fit; with ten flights the restitution must
    also fall with speed. The log-linear fit cannot distinguish the two, because its result
    depends on the number of flights.
puzzle-quantity = quantity
puzzle-printed = printed
puzzle-computed = computed
puzzle-verdict = verdict

job-check-failed = The check of the method failed: the program does not find what is known. No job was made.
job-no-drop-added = No drop was added to the job.
job-damaged = { $count ->
    [one] A line of { $file } is damaged and does not count; `bouncelab job show` names every sound that has no line.
   *[other] { $count } lines of { $file } are damaged and do not count; `bouncelab job show` names every sound that has no line.
}
job-uncounted = { $file } is kept but does not count: nothing was written down of it, as after an interruption. If its drop is whole, { $command } counts it.

balls-numbers = { $ball }, contact { $contact }
balls-words = also: { $words }

listen-begins = listening to { $source }, { $rate } kHz, { $channels ->
    [one] 1 channel
   *[other] { $channels } channels
  }; { $file ->
    [none] nothing is saved
   *[other] saved in { $file } as it comes
  }
listen-saved-in = saved in { $file }
listen-not-saved = NOT SAVED
listen-silence = the microphone gives only silence: is it muted, or the wrong one (--devices)?
listen-fault = the analysis failed by a fault of the program; please report it
listen-goes-on = The recording goes on until you end it.
listen-lost = sound was lost: the computer was too slow, or the microphone had a fault; flights across the gap are excluded
listen-lost-in-all = { $frames } samples of each channel ({ $seconds } s) were lost in { $count ->
    [one] 1 place
   *[other] { $count } places
  }
listen-lacks-sound = not all of the sound was saved: where it was lost, the file has silence and says so
listen-not-analysed = a drop cannot be analysed: { $reason }
listen-once-more = drop { $number } again, from the whole recording
listen-heading = drop { $number }
listen-all-drops = All drops:
listen-saved = the sound is in { $file }; to analyse it again: { $command }
listen-left-out = the drop at { $start } s { $reason ->
    [distant] is of a ball far fainter than the others
   *[unlikely] is not confirmed by the whole recording
  } and is excluded
listen-impact = drop { $drop }: impact { $impact } at { $time } s after { $flight } ms{ $rests ->
    [yes] ; the ball rests
   *[no] {""}
  }
listen-line = e = { $restitution }, h0 = { $height } neglecting air
listen-corrected = e = { $restitution } corrected for drag
listen-too-loud = TOO LOUD: clipped
listen-level = level
listen-seconds = { $seconds } s
listen-drops = { $count ->
    [one] 1 drop
   *[other] { $count } drops
  }
listen-sounds = { $count ->
    [one] 1 sound
   *[other] { $count } sounds
  }
listen-lost-so-far = { $count } samples LOST
listen-ends = Ctrl-C stops
listen-at = at s
listen-e-line = e, no air
listen-h0-line = h0, no air
listen-mean = mean
listen-scatter = scatter
listen-save-failed = saving the sound failed: { $fault }; { $seconds } s are in the file. Listening continues
listen-end-not-saved = the end of the sound may be missing from the file: { $fault }
listen-device = name
listen-device-kind = what it is
listen-device-default = default

session-ball-assumed = Drag depends on the ball, which was not stated: state it with --ball, in the names of the recordings or in session.toml.
session-title = Session
session-speed = Restitution at an impact speed of { $speed } m/s:
session-legend =
    ±: standard uncertainty; shared: what of it all drops share (drag, air, ball, operators) and more drops do
    not reduce; between drops: their scatter beyond their own errors; { $wanted ->
        [none] needed: drops in all that would halve the interval
       *[other] needed: drops in all for a restitution known to ± { $wanted } (95 %)
      }
session-intervals = 95 % intervals, and the standard deviations of ISO 5725:
session-scatters = Scatter beside that of the drops, relative:
session-curves = Restitution against impact speed:
session-drop-heights = Drop heights:
session-outliers = Outliers in their group; are their metadata right?
session-outlier = { $name }: { $off } { $side ->
    [above] above
   *[below] below
  } the others of { $group }, { $score } standard deviations
session-outliers-count = They are included in all results above. With and without them:
session-exclude = --exclude NAME excludes one from everything.
session-differences = Differences of groups:
session-more = and { $count } more (--details)
session-tables = Tables: { $list }
session-no-drop = no recording holds a drop
session-damaged-journal = { $count } lines of the journal are truncated or damaged, and are ignored
session-died = its analysis ended its process twice, the second time alone ({ $how }); if it is long, give it more --memory, else please report it
session-unmatched-names = { $count ->
    [one] 1 name does
   *[other] { $count } names do
  } not fit the pattern "{ $pattern }": { $names }
session-noted-otherwise = { $first } and { $other } are the same sound, but the { $field } of the one is { $of-first } and that of the other { $of-other }; what is noted of the first counts
session-not-noted = not noted
session-by-hand = left out by hand
session-inference-left-out = drops are compared by the inference, which was left out (--no-inference)
session-progress = analysing { $bar } { $done } recordings, { $rate }, { $left } left
session-known = { $kept } of { $all } recordings were analysed in an earlier run
session-out-of-time = its analysis took more than { $seconds } s of processor time; give it more by --time-limit, or ask for less: fewer --draws, a shorter recording
session-restitution = Restitution

serve-address = The laboratory is at { $address } (Ctrl-C ends it)
serve-no-browser = no browser could be opened ({ $reason }); go to { $address } yourself
page-written = { $files } files are in { $folder }. A server that sends them by https gives phones the microphone.
