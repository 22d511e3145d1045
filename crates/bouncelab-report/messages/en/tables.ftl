# Headings of columns, and names of quantities, laws and sources of uncertainty, as in tables and answers.

column-impact = impact
column-impacts = impacts
column-drop = drop
column-start = from s
column-time = time s
column-flight = flight s
column-apex = apex cm
column-speed = speed m/s
column-e = e
column-e-error = ± e
column-h0 = h0
column-ratio = e no drag
column-time-error = ± time µs
column-level = level dB
column-probability = probability
column-line = residual %
column-law = restitution law
column-drag = drag
column-evidence = ln evidence
column-ball = ball
column-bayes-factor = ln Bayes factor
column-source = source
column-alone = alone
column-variance = % of variance
column-unknown = unknown
column-width-left = % of prior width left
column-to-surface = to surface mJ
column-to-air = to air mJ
column-residual = residual
column-weight = weight
column-inference = inference, with air
column-plain = g T²/8
column-95 = 95 %
column-straight-line = log-linear fit, no air
column-corrected = corrected for drag

quantity-restitution = restitution
quantity-drop-height = drop height
quantity-energy-kept = energy kept
quantity-drag = drag coefficient
quantity-terminal-speed = terminal speed
quantity-gravity = gravity
quantity-total-time = time until rest
quantity-total-path = path until rest
quantity-slope = slope of restitution
quantity-scatter = scatter of restitution
quantity-timing = errors of the times
quantity-contact-time = contact time
quantity-height-to-reach = bounce { $bounce } reaches { $apex } from

quantity-interval = 95 %: { $interval }
quantity-at-speed = { $quantity } at { $speed }
quantity-of-impacts = median of { $count } impacts at { $slowest } to { $fastest } m/s
quantity-of-flights = before the first impact detected; { $count ->
    [one] 1 flight
   *[other] { $count } flights
  }
quantity-first-fall = before the first impact detected
quantity-stated = stated
quantity-missed = impacts missed before: { $list }
quantity-before-data = { $value } before the data
quantity-known = taken as known

source-impact-timing = timing of the impacts
source-restitution-scatter = scatter of restitution
source-release-time = release time
source-restitution-slope = slope of restitution
source-measured-height = measured height
source-drag-law = drag law
source-contact-time = contact time
source-gravity = gravity
source-air-density = air density
source-ball-mass = ball mass
source-ball-diameter = ball diameter
source-added-mass = added mass
source-choice-of-ball = which ball it is
source-choice-of-law = choice of law
source-number-of-impacts = number of impacts

drag-none = none
drag-constant = C_D = { $coefficient }
drag-standard = standard curve of a sphere
drag-table = own table
