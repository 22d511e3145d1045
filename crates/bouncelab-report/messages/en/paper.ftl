# The numbers of the paper: what they are, and what to know of them.

paper-chapter-numbers = The numbers of the paper
paper-chapter-series = Restitution, time and distance without drag
paper-chapter-equations = Equations as printed, and as they must be
paper-chapter-beyond = Results beyond the paper
paper-chapter-flights = A drop whose log-linear fit is that of the paper: e = 0.9529 with drag
paper-weight = weight
paper-buoyancy = buoyancy
paper-buoyancy-note = it fixes the density of air, 1.2276 kg/m3
paper-buoyancy-over-weight = buoyancy over weight
paper-first-impact = first impact, no drag
paper-reynolds-number = Reynolds number there
paper-reynolds-number-note = not turbulent as printed: below the drag crisis, a laminar boundary layer
paper-terminal-speed = terminal speed, C_D = 0.4
paper-terminal-speed-note = 9.385 lies on the edge of rounding
paper-first-impact-with-drag = first impact, C_D = 0.4 (Eq. 15)
paper-drag-over-weight = drag over weight at 2.4 m/s, C_D(Re)
paper-drag-over-weight-note = the paper read its curve off a figure
paper-terminal-speed-of-sphere = terminal speed, C_D(Re)
paper-terminal-speed-of-sphere-note = the same
paper-rule-steel-least = e by the rule book, steel, least
paper-rule-steel-most = e by the rule book, steel, most
paper-rule-table-least = e by the rule book, table, least
paper-rule-table-most = e by the rule book, table, most
paper-height-error = error of h0 = 26.7 cm
paper-height-error-note = from the rounded 26.7 cm; the flight times are not printed
paper-restitution-of-time = e from 7.50 s after the first impact
paper-restitution-of-time-note = if the 7.50 s count from the first impact
paper-restitution-of-total-time = e from 7.50 s after the release (Eq. 7)
paper-restitution-of-total-time-note = Eq. 7 counts from the release
paper-total-path = path until rest at e = 0.94 (Eq. 8)
paper-equation-6-printed = h0 by Eq. 6 as printed: g 10^b/8
paper-equation-6-printed-note = 10^b = 2 v0/g must be squared
paper-equation-6 = h0 by Eq. 6 corrected: g (10^b)^2/8
paper-equation-13 = Eq. 13 at the first impact
paper-equation-13-note = the drop height: its left side is the distance y, not v
paper-equation-14 = Eq. 14 at the first impact
paper-equation-14-note = the same
paper-drag-twice = e of the fit for e = 0.935 with drag (Fig. 8)
paper-drag-twice-note = Fig. 8 takes the drag into account twice
paper-drag-twice-height = drop height of that fit
paper-behind-line = e whose fit is 0.9375 with drag
paper-behind-line-note = over ten flights
paper-behind-line-height = drop height of its fit
paper-explained = share of the difference to 30.5 cm due to drag
paper-explained-note = the rest: restitution that falls with speed, or more flights in the fit
paper-twenty-flights-height = drop height, same e, twenty flights
paper-twenty-flights-height-note = the fit depends on the number of flights
paper-lost-gravity = gravity lost to buoyancy and added mass
paper-lost-gravity-note = buoyancy alone 1.4 %; every height shrinks with it
paper-flight-time = T{ $of }
paper-time-until-rest = time until rest with drag, e = { $of }
paper-path-until-rest = path until rest with drag, e = { $of }

paper-verdict-agrees = agrees
paper-verdict-agrees-when-corrected = agrees when corrected
paper-verdict-agrees-within-reading = agrees within reading
paper-verdict-misprint = misprint
paper-verdict-differs = differs

paper-air-none = none
paper-air-constant = C_D = 0.4
paper-air-sphere = C_D(Re)
paper-air-all-of-air = C_D(Re), buoyancy, added mass
