# Reports: a drop in words and numbers, what was assumed, the method, and how to repeat it.

report-made-by = Report of bouncelab { $version }
report-made-on = Report of bouncelab { $version }, { $date }
report-note = Note
report-page = Page { $page } of { $pages }
report-figure = Figure
report-details = Details

report-drop = The drop
report-drop-of = Drop { $number } of { $count }
report-drops = The drops
report-no-drop = No drop was found: { $reason }
report-no-reason = nothing in it bounces.
report-drops-found = { $drops } drops with { $impacts } impacts were found.
report-first-drops = The first { $count } drops have sections of their own below; results for programs have all.

report-impacts = { $count ->
    [one] One impact was detected, at { $first } s
   *[other] { $count } impacts were detected from { $first } s to { $last } s
  }, { $uncertain ->
    [0] none of them uncertain.
    [one] one of them uncertain.
   *[other] { $uncertain } of them uncertain.
  }

report-answers = Inference with air, and log-linear fit without
report-quantities = Other quantities
report-quantities-table = Other quantities, with the method of each
report-impacts-heading = The impacts
report-impacts-table = Impacts with the following flight, and restitution without and with correction for drag (? marks uncertain impacts)
report-line-heading = The log-linear fit
report-line-flights = It uses { $count ->
    [one] one flight.
   *[other] { $count } flights.
  }
report-line-fits = It uses { $count } flights; its coefficient of determination is { $determination }.
report-no-line = There is no fit: { $reason }

report-uncertainty = Uncertainty budget
report-budget-restitution = Budget of the restitution
report-budget-drop-height = Budget of the drop height
report-laws = Comparison of the laws
report-laws-table = Laws, with equal prior probability
report-contraction = What this recording determines
report-correlations = Correlations of the estimates
report-uninformative = { $unknown }: the data add almost no information to the prior.
report-little-informative = { $unknown }: the data add some information; { $left } % of the prior uncertainty remains.
report-informative = { $unknown }: determined by the data; { $left } % of the prior uncertainty is left.
report-fit = Goodness of fit
report-fit-table = Impacts in the inference: energy losses, residual and weight in the fit
report-sampling = The sampling has { $draws } effective draws; its Pareto shape is { $shape } (good below 0.7).

report-air = The air at these speeds
report-conditions = Conditions and assumptions
report-assumed = Not stated, and therefore assumed:
report-priors = Priors of the inference
report-source = Source
report-source-times = { $origin ->
    [none] a list of impact times
   *[other] a list of impact times: { $origin }
  }
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
report-method-short = The impacts are detected in the sound; the time between two of them is that of a flight. The inference computes the posterior of restitution, drop height and drag from all flight times, with the fall through the air, restitution that scatters between impacts, and errors of the times. Each quantity is stated as the median ± standard deviation of its posterior; a 95 % credible interval contains the true value with that probability if the assumptions hold. The log-linear fit is a straight line through the logarithms of the flight times and neglects the air. The restitution is stated at the speed of the first impact detected and at a round speed, because that of most balls changes with the speed. Without a stated drop height, the drop height is that of the fall before the first impact detected; whether impacts were missed before it, the times do not show. The drag of one drop is hardly measured: the drag coefficient is mostly that known of spheres, and the intervals allow for its uncertainty, as for restitution that changes with speed in an unknown way. The formulas and the references are under Details.

report-formulas = The method with its formulas
report-method-flight = Only the impacts make a sound. The time T between two impacts is that of a flight, and gives its height h nearly independently of the air:
report-method-line = If each impact kept the same share e of the speed and there were no air, the logarithms of the flight times would lie on a straight line against the number n of the impact. Its slope gives the restitution e and its intercept b the drop height (Nagurka, Eqs. 4 and 6):
report-method-motion = Drag also reduces the speed, buoyancy acts against the weight, and the ball accelerates some of the air (added mass). With mass m, volume V and cross-section A of the ball, density ρ of the air, and a drag coefficient that depends on the Reynolds number, the velocity v changes as
report-method-restitution = From each flight time follows the speed v at which the ball left the surface and the speed v′ at which it came back, and from two neighbouring flights the restitution of the impact between them:
report-method-noise = Two kinds of noise are modelled: restitution scatters between impacts by a relative standard deviation σₑ, and times have errors σₜ, which neighbouring impacts share through the derivatives J. Outlying impacts have less weight (Student's t).
report-method-posterior = The inference computes the posterior of all unknowns θ, given the times t and the priors, under every restitution law and drag law M. Each quantity is stated as the median ± standard deviation of its posterior; a 95 % credible interval contains the true value with that probability if the assumptions hold.
report-references = References:
report-reference-drag = { $work }: the standard drag curve.
report-reference-scatter = { $work }: the scatter of impacts.
