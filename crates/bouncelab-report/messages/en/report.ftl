# Reports: a drop in words and numbers, what was assumed, the method, and how to repeat it.

report-made-by = Report of bouncelab { $version }
report-made-on = Report of bouncelab { $version }, { $date }
report-note = Note
report-figure = Figure

report-drop = The drop
report-drop-of = Drop { $number } of { $count }
report-drops = The drops
report-no-drop = No drop was found: { $reason }
report-no-reason = nothing in it bounces.
report-drops-found = { $drops } drops with { $impacts } impacts were found.

report-kept = The ball kept { $share } of its speed at each bounce.
report-kept-and-fell = The ball kept { $share } of its speed at each bounce and fell from { $height }.
report-kept-and-fell-first = The ball kept { $share } of its speed at each bounce and fell from { $height } before the first impact detected.
report-kept-without-air = If there were no air, the ball kept { $share } of its speed at each bounce and fell from { $height }.
report-kept-unknown = How much the ball kept cannot be stated: { $reason }
report-impacts = { $count ->
    [one] One impact was detected, at { $first } s
   *[other] { $count } impacts were detected from { $first } s to { $last } s
  }, { $uncertain ->
    [0] none of them uncertain.
    [one] one of them uncertain.
   *[other] { $uncertain } of them uncertain.
  }
report-restitution = The restitution, speed after an impact over speed before it, is { $value } at { $speed }, with the air accounted for.
report-line-says = A straight line through the logarithms of the flight times, which takes no account of the air, gives { $share } ({ $difference ->
    [less] { $points } percentage points less
    [more] { $points } percentage points more
   *[none] the same
  }) and { $height }.

report-answers = Inference with air, and straight line without
report-impacts-heading = The impacts
report-impacts-table = Impacts, each with the flight after it and its restitution, without and with correction for drag (? marks uncertain ones)
report-line-heading = The straight line
report-line-flights = It goes through { $count ->
    [one] one flight.
   *[other] { $count } flights.
  }
report-line-fits = It goes through { $count } flights, with a coefficient of determination of { $determination }.
report-no-line = There is none: { $reason }

report-uncertainty = Where the uncertainty comes from
report-budget-restitution = Budget of the restitution
report-budget-drop-height = Budget of the drop height
report-laws = Which laws may be true
report-laws-table = Laws of equal probability before the data
report-contraction = What this recording determines
report-correlations = Correlations of the answers
report-uninformative = { $unknown }: these data say next to nothing; it is what was known before.
report-little-informative = { $unknown }: the data help a little; { $left } % of the prior uncertainty is left.
report-informative = { $unknown }: determined by the data; { $left } % of the prior uncertainty is left.
report-fit = How well it fits
report-fit-table = The impacts as the inference has them, with the energy that each took and its weight in the fit
report-sampling = The sampling is worth { $draws } independent draws; its Pareto shape is { $shape } (good below 0.7).
report-truncation = A method that is right does not change its answer with the number of flights it uses:

report-air = The air at these speeds
report-conditions = Conditions and assumptions
report-assumed = Nobody stated these, so they were assumed:
report-priors = Before it saw the data, the inference knew this:
report-source = Source
report-source-times = a list of impact times
report-source-sound = { $format }, { $rate } kHz, { $duration } s
report-samples = samples
report-microphone = microphone
report-channel = Channel
report-channel-of = { $channel } of { $count }
report-onsets = Sounds above the noise
report-ball = Ball
report-mass = Mass
report-diameter = Diameter
report-contact-time = Contact time
report-gravity = Gravity
report-air-density = Density of the air
report-drag-law = Drag law
report-displaced-air = Buoyancy and added mass
report-displaced-air-both = both taken into account
report-displaced-air-buoyancy = buoyancy only
report-displaced-air-added-mass = added mass only
report-displaced-air-none = left out
report-measured-height = Measured drop height
report-release = Release, in the recording
report-sampler = Sampling
report-sampler-draws = { $draws } draws, seed { $seed }

report-repeat = To repeat this
report-repeat-version = Version { $version } of bouncelab gives the same numbers from the same file and settings; the random numbers of the inference have a seed.
report-repeat-files = The files that were read, by their SHA-256 (sha256sum shows it):

report-method = Method
report-method-flight = A ball is heard only when it hits. The silence between two impacts is a flight, and its length T gives the height h of the flight, nearly independently of the air:
report-method-line = If each impact kept the same share e of the speed and there were no air, the logarithms of the flight times would lie on a straight line against the number n of the impact. Its slope gives the restitution e and its intercept b the drop height (Nagurka, Eqs. 4 and 6):
report-method-motion = The air takes speed as well, and pushes and carries the ball a little. With mass m, volume V and cross-section A of the ball, density ρ of the air, and a drag coefficient that follows the Reynolds number, the velocity v changes as
report-method-restitution = From each flight time follows the speed v at which the ball left the surface and the speed v′ at which it came back, and from two neighbouring flights the restitution of the impact between them:
report-method-noise = Two kinds of noise are kept apart: impacts scatter by a share σₑ of their restitution, and times have errors σₜ, which neighbouring impacts share through the derivatives J. Odd impacts count less (Student's t).
report-method-posterior = The inference weighs all values θ of what is unknown, under every restitution law and drag law M, by how well they explain the times t and by what was known before. Each quantity is stated as the median of that, ± its standard deviation; an interval of 95 % holds the truth with that probability if the assumptions hold.
report-references = References:
report-reference-drag = { $work }: the standard drag curve.
report-reference-scatter = { $work }: the scatter of impacts.
