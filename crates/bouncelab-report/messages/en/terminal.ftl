# What the command line prints. Names of options and commands are not translated.

terminal-note = Note: { $text }
terminal-assumed = Assumed: { $list }.
terminal-cannot-tell = { $what }: cannot tell: { $reason }

analyze-times = { $name }: impact times
analyze-sound = { $name }: { $format }, { $rate } kHz{ $channels ->
    [1] {""}
   *[other] , channel { $channel } of { $channels }
  }, { $duration } s
analyze-listening = { $onsets } sounds stand out of the background and { $impacts } impacts were detected, clearest from { $low } to { $high } Hz, { $above } dB above the sound before them (--channel, --band).
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
analyze-line = Straight line
analyze-line-heading = Straight line through log flight time, as if there were no air:
analyze-line-flights = (before the first impact detected; { $count ->
    [one] 1 flight
   *[other] { $count } flights
  })
analyze-until-rest = until rest
analyze-corrected = Corrected for drag
analyze-corrected-heading = Corrected for drag ({ $ball }, { $law }):
analyze-corrected-impacts = (median of { $count } impacts at { $slowest } to { $fastest } m/s)
analyze-corrected-too-few = Corrected for drag: cannot tell a mean: { $count } of the impacts lie between two flights, and it takes 3.
analyze-inference = Inference
analyze-inference-heading = Inference, with air ({ $ball }):
analyze-at-speed = at { $speed }
analyze-before-data = { $value } before the data
analyze-known = taken as known
analyze-first-fall = before the first impact detected
analyze-missed = impacts missed before: { $list }
analyze-reach = bounce { $bounce } reaches { $apex } from
analyze-interval = 95 %: { $interval }

analyze-details-models = Models, of equal probability before the data:
analyze-details-budget-restitution = Where the uncertainty of e comes from:
analyze-details-budget-height = Where the uncertainty of h0 comes from:
analyze-details-contraction = How much the data narrowed what was known:
analyze-details-correlations = Correlations of the answers:
analyze-details-impacts = Impacts in the fit:
analyze-details-priors = Before the data:
analyze-details-sampling = Sampling: { $draws } independent draws, Pareto shape { $shape } (good below 0.7).
analyze-no-drop = { $name }: no drop found: { $reason }
analyze-one-report = a report is of one recording, and there are several: bouncelab session makes one of many
advice-allow-implausible = Correct it, or insist by --allow-implausible
