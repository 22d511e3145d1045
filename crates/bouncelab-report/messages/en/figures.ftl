# The words of the figures.

axis-amplitude = amplitude, relative to full scale
axis-bounce = bounce
axis-drag = drag / weight
axis-drag-coefficient = drag coefficient
axis-drop = drop
axis-drop-height = drop height
axis-energy-lost = energy lost
axis-flight = number of the flight
axis-flight-time = flight time
axis-height = height
axis-impact = impact
axis-impact-speed = speed at the impact
axis-off-line = residual of the fit
axis-rebound = rebound
axis-restitution = restitution: speed after / before
axis-restitution-at = restitution at { $speed }
axis-restitution-short = restitution
axis-share-of-reference = share of the reference
axis-speed = speed
axis-time = time

figure-bounce-energies-title = Where does the energy go?
figure-bounce-energies-tab = Energy
figure-bounce-energies-caption = The energy lost in each impact, and above it the energy lost to the air in the flight after it: the faster the ball, the larger the share of the air.
figure-bounce-energies-empty = There are no energies to show.
figure-bounce-energies-air = the air, in the flight after it
figure-bounce-energies-surface = the bounce

figure-bounce-heights-title = How high is each bounce?
figure-bounce-heights-tab = Heights
figure-bounce-heights-caption = Each bounce reaches about the same share of the height before it, so that the points lie near a straight line.
figure-bounce-heights-empty = There are no heights to show.

figure-budget-title = Where the uncertainty comes from
figure-budget-tab = Budget
figure-budget-caption = Each bar is the share of a source in the variance: to know the ball better, reduce the source at the top.
figure-budget-empty = There is no uncertainty to show.
figure-budget-axis = share of the variance
figure-budget-drop-height = drop height: { $value }
figure-budget-others = all others
figure-budget-restitution = restitution: { $value }

figure-calibration-title = Where the truth lies among the draws
figure-calibration-caption = Flat bars: the intervals are calibrated. A hill would mean intervals too wide, a valley too narrow, a slope a bias.
figure-calibration-empty = There are no ranks to show.
figure-calibration-drops = simulated drops
figure-calibration-expected = 99 % of bars end here if calibrated
figure-calibration-rank = rank of the truth

figure-comparison-title = The drop and a simulation of it
figure-comparison-tab = Compare
figure-comparison-caption = Where the curves differ, the model is incomplete, or an impact is another sound.
figure-comparison-empty = There are no heights to show.
figure-comparison-best-fit = simulated, with 95 %
figure-comparison-measured = measured
figure-comparison-simulation = your simulation

figure-detection-found-title = Impacts found in noise
figure-detection-found-caption = F1 is 1 where every impact as loud as the noise is found and nothing else is.
figure-detection-found-empty = There is nothing to compare: no curve has a point.
figure-detection-found-axis = F1
figure-detection-found-loudness = loudest impact above the noise

figure-detection-late-title = Faint impacts are not timed later than loud ones
figure-detection-late-caption = The first sample above a fixed level comes later for fainter impacts; the best fit of the whole waveform does not depend on loudness.
figure-detection-late-empty = There is nothing to compare: no curve has a point.
figure-detection-late-axis = later than the loudest
figure-detection-late-loudness = impact above the noise

figure-detection-stated-title = Errors of flight times against their stated standard errors
figure-detection-stated-caption = Of normal errors 68 % lie within one standard error.
figure-detection-stated-empty = There is nothing to compare: no curve has a point.
figure-detection-stated-axis = within one standard error
figure-detection-stated-loudness = loudest impact above the noise

figure-detection-timing-title = Errors of flight times and the Cramér-Rao bound
figure-detection-timing-caption = The Cramér-Rao bound is the least error with which a known sound in white noise can be timed.
figure-detection-timing-empty = There is nothing to compare: no curve has a point.
figure-detection-timing-axis = median error over that of the bound
figure-detection-timing-loudness = loudest impact above the noise

figure-drag-title = Air drag relative to weight
figure-drag-tab = Drag
figure-drag-caption = Drag grows nearly with the square of the speed and balances the weight at the terminal speed, where the curve reaches 1.
figure-drag-reached = Drag grows nearly with the square of the speed and balances the weight at the terminal speed, where the curve reaches 1; this drop reached { $speed }.
figure-drag-empty = There are no drag curves to show.
figure-drag-fastest = this drop: up to { $speed }

figure-drag-log-title = Air drag relative to weight
figure-drag-log-tab = Drag (log)
figure-drag-log-caption = A constant drag coefficient is a straight line here; the laws differ at low speed, where drag is too weak to matter.
figure-drag-log-reached = A constant drag coefficient is a straight line here; the laws differ at low speed, where drag is too weak to matter; this drop reached { $speed }.
figure-drag-log-empty = There are no drag curves to show.

figure-flight-times-title = Flight times and the log-linear fit
figure-flight-times-tab = With and without air
figure-flight-times-caption = Without air each flight would last the same share of the one before, { $ratio } by the fit; a bend in the lower panel shows drag, or a restitution that changes with speed.
figure-flight-times-no-line = { $count ->
    [one] 1 flight
   *[other] { $count } flights
}, without a fit.
figure-flight-times-empty = There are no flights to show.
figure-flight-times-line = log-linear fit: × { $ratio } each time
figure-flight-times-all = measured flights
figure-flight-times-unused = not used
figure-flight-times-used = flights used

figure-groups-title = Restitution of each group against speed
figure-groups-caption = Each dot is an impact; each line is the curve of a group, with its 95 % interval.
figure-groups-more = The first { $shown } of { $all } groups are shown.
figure-groups-empty = There are no impacts with a known restitution.

figure-height-title = Height of the ball
figure-height-tab = Height
figure-height-caption = Each hop is lower and shorter than the one before, so that infinitely many fit into a finite time.
figure-height-caption-apexes = Each hop is lower and shorter than the one before; dots are the measured tops of the hops.
figure-height-caption-models = The models start alike and differ with time, because a lower flight is also shorter.
figure-height-empty = There are no heights to show.
figure-height-apexes = measured apexes
figure-height-model = flight model, drag { $drag }

figure-intervals-title = Restitution of each group
figure-intervals-caption = Where the dark bars of two groups are far apart, the groups differ; where one lies within the light bar of the other, single drops cannot distinguish them.
figure-intervals-empty = There are no groups to compare.
figure-intervals-count = { $count ->
    [one] 1 drop
   *[other] { $count } drops
}
figure-intervals-drops = drops
figure-intervals-mean = restitution, 95 %
figure-intervals-next = next drop, 95 %
figure-intervals-outliers = outlier

figure-limits-title = The rebound and the limits
figure-limits-caption = A value whose bar lies between the limits is within them with a probability of 95 % or more.
figure-limits-empty = There is no value to compare with the limits.
figure-limits-accepted = accepted at this uncertainty
figure-limits-interval = 95 %
figure-limits-within = within the limits

figure-models-title = Which law is the most probable?
figure-models-tab = Laws
figure-models-caption = The longer the bar, the more probable the law; where no law dominates, the result is an average over all of them.
figure-models-empty = There are no models to compare.
figure-models-interval = drop height, 68 %
figure-models-probability = probability

figure-posterior-title = Joint posterior
figure-posterior-tab = Posterior
figure-posterior-caption = A round cloud: the data separate the two quantities. A tilted one: they are correlated. A histogram as wide as the grey curve: the data add no information to the prior.
figure-posterior-empty = There are no quantities to show.
figure-posterior-posterior = after the data: 68 % dark, 95 % light
figure-posterior-prior = before the data

figure-residuals-title = Residual of each impact
figure-residuals-tab = Residuals
figure-residuals-caption = Two of three impacts should lie in the dark band, 19 of 20 in the light one; an impact far outside hit an edge, or is another sound.
figure-residuals-empty = There are no residuals to show.
figure-residuals-axis = residual (standard deviations)
figure-residuals-impact = impact
figure-residuals-odd = outlier, less weight

figure-restitution-title = Restitution of each impact
figure-restitution-tab = Restitution
figure-restitution-caption = Restitution is the speed after an impact over the speed before it. The gap between grey and blue is due to the air; the log-linear fit attributes it to the impact.
figure-restitution-empty = There are no impacts with a known restitution.
figure-restitution-corrected = corrected for drag
figure-restitution-law = fitted law, 68 and 95 %
figure-restitution-line = log-linear fit: { $value }
figure-restitution-odd = outlier, less weight
figure-restitution-raw = neglecting the air

figure-run-title = Is there a drift?
figure-run-caption = Level of each drop, the median of its group taken off, in order: a slope or a step means that ball, surface or air changed.
figure-run-empty = There are no drops to show.
figure-run-off = ln e less the median of the group
figure-run-order = drop, in order
figure-run-outlier = outlier
figure-run-unchanged = if nothing changes

figure-truncation-title = Does the result depend on how many flights are used?
figure-truncation-tab = Truncation
figure-truncation-caption = A correct model gives the same result for any number of flights; the result of the log-linear fit changes, because it neglects the air.
figure-truncation-empty = There are no results to compare.
figure-truncation-flights = flights used
figure-truncation-inference = inference, with air
figure-truncation-line = log-linear fit
figure-truncation-stated = stated

figure-waveform-title = The sound and its impacts
figure-waveform-caption = { $impacts ->
    [one] 1 impact
   *[other] { $impacts } impacts
} of { $drops ->
    [one] one drop
   *[other] { $drops } drops
}{ $uncertain ->
    [0] {""}
   *[other] {" "}({ $uncertain } uncertain, open and orange)
}{ $pattern ->
    [yes] : their spacing shrinks by nearly the same ratio each time
   *[no] {""}
}.
figure-waveform-no-impacts = The sound, in which no impacts were found.
figure-waveform-empty = There is no sound to show.
figure-waveform-drop = drop { $number }
figure-waveform-impact = impact
figure-waveform-uncertain = uncertain impact

figure-drop-impacts-title = Restitution of each impact, drop by drop
figure-drop-impacts-caption = Corrected for drag. Drops of one ball on one surface should lie on one line.
figure-drop-impacts-more = The last { $shown } of { $all } drops are shown.
figure-drop-impacts-empty = There are no impacts with a known restitution.

figure-drops-title = Restitution of each drop
figure-drops-caption = How much a ball keeps of its speed, drop by drop; the bars are one standard deviation.
figure-drops-empty = There are no drops to show.

figure-lesson-title = The drop height by the log-linear fit
figure-lesson-caption = Without air, the fit gives the true height with any number of flights; with air, its height decreases with each further flight.
figure-lesson-empty = There are no flights to show.
figure-lesson-air = with air
figure-lesson-flights = flights in the fit
figure-lesson-height-of-line = drop height by the fit
figure-lesson-no-air = without air
figure-lesson-paper = as in the paper
figure-lesson-truth = true height

figure-lesson-height-title = The height with and without air
figure-lesson-height-caption = Two drops with the same restitution; the air shortens the drop.
figure-lesson-height-empty = There are no heights to show.

figure-lesson-line-title = Flight times without air
figure-lesson-line-caption = On this axis, flights that each last the same share of the one before lie on a straight line.
figure-lesson-line-empty = There are no flights to show.
figure-lesson-line-line = log-linear fit

figure-run-flight-times-title = Flight times
figure-run-flight-times-caption = On this axis, flights with constant restitution and no air lie on a straight line; a bend shows drag, or a restitution that changes with speed.
figure-run-flight-times-empty = There are no flights to show.

figure-runs-title = Height of the ball
figure-runs-caption = Each hop is lower and shorter than the one before.
figure-runs-empty = There are no heights to show.
