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

quantity-restitution = restitution
quantity-restitution-e = restitution e
quantity-drop-height = drop height
quantity-energy-kept = energy kept
quantity-drag-coefficient = drag coefficient
quantity-terminal-speed = terminal speed
quantity-gravity = gravity
quantity-scatter = scatter from impact to impact
quantity-release-until-rest = release until rest
quantity-path-until-rest = path until rest
quantity-height-to-reach = height from which bounce { $bounce } reaches { $apex }

unknown-restitution = restitution
unknown-drop-height = drop height
unknown-drag = drag coefficient
unknown-slope = slope of restitution
unknown-scatter = scatter of restitution
unknown-timing = errors of the times
unknown-contact-time = contact time
unknown-gravity = gravity

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
source-choice-of-law = choice of law
source-number-of-impacts = number of impacts

restitution-law-constant = constant
restitution-law-linear = linear
restitution-law-power = power
restitution-law-viscoelastic = viscoelastic
restitution-law-knee = knee
restitution-law-smooth = smooth

drag-none = none
drag-constant = C_D = { $coefficient }
