# The sentences of the diagnostics, by their codes; docs/diagnostics.md says what each means and what to do.
# Advice that names an option or a button of a front end is in advice.ftl.

diagnostic-recording-silent = The recording is silent: all samples have the same value.
diagnostic-no-sound = No sound stands out from the background.
diagnostic-too-few-sounds = { $count ->
    [one] Only 1 sound stands out from the background
   *[other] Only { $count } sounds stand out from the background
  }; the detection of a drop needs at least { $needed } impacts.
diagnostic-periodic-sounds = { $count } sounds are periodic, about every { $interval_s }, like those of a clock, steps or a drum; the flights of a ball become shorter.
diagnostic-no-pattern = { $count } sounds stand out from the background, but no { $needed } of them have the decreasing intervals of a bouncing ball.
diagnostic-too-few-times = A flight needs two impact times, and there are fewer.
diagnostic-too-many-times = The list has { $count } times; no drop has more than { $most } impacts. List those of one drop. A sampled waveform needs a second column, the amplitude.
diagnostic-times-in-milliseconds = Impacts are more than 30 s apart, and no ball flies so long. Times are in seconds; below the heading time_ms they are in milliseconds.
diagnostic-flights-do-not-fall = The { $count } intervals between the times do not get shorter, as the flights of a bouncing ball do: they last { $first_s } s at the beginning and { $last_s } s at the end. These are samples, another clock or several drops; list the impact times of one drop.
diagnostic-times-by-threshold = The times are those at which the sound exceeded a threshold, which marks a faint impact later than a loud one. A recording of the sound gives better times.
diagnostic-times-of-intervals = The impact times are sums of the listed intervals; the first impact is at 0 s.
diagnostic-nothing-left = So many impacts were excluded that no flight remains.
diagnostic-distant-ball = A far fainter ball was detected from { $start_s } s to { $end_s } s ({ $impacts } impacts) and excluded.
diagnostic-drops-at-once = Two balls bounce at the same time from { $start_s } s to { $end_s } s: if they sound alike, an impact of one may be taken for one of the other.
diagnostic-clipped = { $samples ->
    [one] 1 sample is clipped
   *[other] { $samples } samples are clipped
  }: the recording level was too high; impact times are hardly affected, levels are.
diagnostic-earlier-impact = A sound at { $time_s } s, before the drop from { $start_s } s, may be an earlier impact, though it fits the others badly: if it is, the ball fell from higher than is stated.
diagnostic-sounds-unused = { $count } sounds near the drop from { $start_s } s are as loud as its impacts and were not used: other sounds, or a second ball.
diagnostic-possible-drop = Possible drop { $number }: from { $start_s } s, { $impacts } impacts, probability { $probability }. It counts only if you accept it (--accept { $number }).
diagnostic-no-candidate = There is no possible drop of the number { $number }, but { $count ->
    [0] none
   *[other] { $count }
  }.
diagnostic-nothing-to-exclude = No impact lies near { $time_s } s, so none was excluded there.
diagnostic-too-far-to-include = { $time_s } s lies more than { $reach_s } away from every drop, so it was not added.
diagnostic-sound-lost = Sound was lost at { $at_s } s: of { $impacts } impacts, the { $kept } of the longest part without a gap are used.
diagnostic-release-without-drop = No drop begins after the stated release at { $time_s } s.
diagnostic-height-of-another-unit = The stated height is { $stated_m }, but the detected fall is about { $detected_m }; { $meant_m } may be meant.

diagnostic-file-unreadable = The file cannot be read.
diagnostic-file-truncated = { $expected_s ->
    [none] The file is truncated or damaged, or holds more sound than its header counts: it was read up to { $read_s } s. If sound was inserted before that, later times are too late.
   *[other] The file is truncated: { $read_s } s of { $expected_s } s could be read. If the rest is not missing at the end, later times are too early.
  }
diagnostic-samples-not-finite = { $samples ->
    [one] 1 sample was not a number
   *[other] { $samples } samples were not numbers
  } and replaced by zero, the first at { $first_s } s.
diagnostic-bits-flipped = { $samples } samples jump by a power of two and back, the first at { $first_s } s: bits of the file were flipped, and impacts may be missing or wrong.
diagnostic-sound-missing = { $places ->
    [one] { $missing_s } s of sound are missing at { $first_s } s
   *[other] { $missing_s } s of sound are missing in { $places } places, the first at { $first_s } s
  }: silence stands there, and no flight across it is used.
diagnostic-clock-lost = { $places ->
    [one] The file is damaged at { $first_s } s
   *[other] The file is damaged in { $places } places, the first at { $first_s } s
  }, and does not say how much sound is missing: times before and after do not belong together, and no flight across is used.
diagnostic-sound-blank = { $places ->
    [one] The sound is exactly zero for { $blank_s } s at { $first_s } s
   *[other] The sound is exactly zero for { $blank_s } s in { $places } places, the first at { $first_s } s
  }, and not elsewhere: it may have been lost or overwritten there.
diagnostic-checksum-wrong = The results may be wrong: the sound is not that of which the file has the checksum or the length. It was changed somewhere from { $start_s } s to { $end_s } s, so that impacts anywhere there may be missing, moved or added.
diagnostic-format-changes = The sound changes its rate or channels at { $at_s } s; it was read up to there.
diagnostic-rate-in-doubt = { $implied_hz ->
    [none] The header states { $stated_hz } samples a second, which is unusual in this format and stated only once
   *[other] The header states { $stated_hz } samples a second, but its bytes a second are those of { $implied_hz }
  }: if the rate is wrong, all times are.
diagnostic-edit-list-ignored = The file's edit list reorders or warps the sound; it was read as recorded.

diagnostic-impacts-missed = { $count ->
    [one] One impact in between was not detected; it is counted.
   *[other] { $count } impacts in between were not detected; they are counted.
  }
diagnostic-impact-gains-energy = { $count ->
    [one] Impact { $impacts } has a restitution above 1
   *[other] Impacts { $impacts } have a restitution above 1
  }: a double detection, a moving surface, or another sound.
diagnostic-restitution-rises = The restitution corrected for drag rises with the impact speed, from { $slow } to { $fast }, unlike that of real balls; the ball is probably another one, heavier for its size.
diagnostic-impacts-doubtful = { $count ->
    [one] 1 impact is
   *[other] { $count } impacts are
  } more likely something else (probability below 1/2).
diagnostic-flight-grows = Flight { $flight } is longer than the flight before it, which is impossible on a surface at rest.

diagnostic-impacts-too-close = { $count ->
    [one] The impact at { $start_s } s follows
   *[other] { $count } impacts from { $start_s } s on follow
  } within twice the time for which the ball touches the surface ({ $contact_time_s }), and { $count ->
    [one] is
   *[other] are
  } left out. With long flights among them, the ball is probably another one, or its contact is shorter.
diagnostic-few-impacts = { $count ->
    [2] 2 impacts show a single flight and no restitution of the ball
    [3] 3 impacts show a single restitution of the ball, and not how it changes with speed
   *[other] { $count } impacts show few restitutions of the ball
  }; the rest of the result comes from the priors.
diagnostic-flights-may-be-two = Only { $count } impacts: if one between each two of them was not detected, the ball keeps { $restitution } of its speed, and it fell from { $height_m }. The times fit both.
diagnostic-law-needs-impacts = The { $law } restitution law needs { $needed } impacts between two flights to be distinguished from a constant, and there { $seen ->
    [one] is 1
   *[other] are { $seen }
  }: the change of restitution with speed comes from the prior.
diagnostic-impacts-odd = { $count ->
    [one] Impact { $impacts } is an outlier and has less weight: the ball may have drifted or hit an edge, or the sound is something else.
   *[other] Impacts { $impacts } are outliers and have less weight: the ball may have drifted or hit an edge, or the sounds are something else.
  }
diagnostic-scatter-exceeds-prior = Restitution scatters by about { $relative_sd } % from impact to impact, more than the { $assumed_relative_sd } % that are assumed: the intervals may be too narrow.
diagnostic-height-contradicts-times = The stated height of { $measured_m } contradicts the impacts, which indicate a fall from { $detected_m }; it is not used. Both would agree with a gravity of { $gravity_m_s2 }. The height, the ball or the sample rate may be wrong.
diagnostic-first-impact-doubtful = The first impact, at { $time_s } s, fits the others badly: with probability { $probability } it is another sound, or of an earlier drop, and the ball fell from { $height_m }.
diagnostic-release-contradicts-times = The stated release, { $stated_s } s before the first impact, contradicts the impacts, which indicate a fall of { $detected_s } s; it is not used.
diagnostic-first-impacts-missed = Impacts before the first one detected were missed, with probability { $probability }.
diagnostic-other-ball-fits-better = The times fit another kind of ball better than the stated one, at least { $odds } to 1: { $balls }. Check which ball it was.
diagnostic-never-rests = Some of the possible restitution laws lose so little at slow impacts that the ball would not come to rest in a reasonable time.
diagnostic-inference-off = No inference was requested.
diagnostic-inference-needs-impacts = An inference needs at least one flight, that is two impacts.
diagnostic-restitution-undetermined = There are too few impacts: with { $count } of them the restitution may be anything from { $least } to { $greatest }. Record at least three impacts, or measure and state the drop height.
diagnostic-contact-overlaps = Impacts { $first } and { $second }, at { $time_s } s, are { $interval_s } apart, and the ball touches the surface for { $contact_time_s }. One of them is probably an echo or another sound: exclude it. Otherwise correct the ball or its contact time.
diagnostic-no-model-fits = No physical model fits these times. Check that they are in seconds and of one drop, exclude other sounds, and check the ball.
diagnostic-sampling-not-converged = The times do not determine the drop: the computation of the uncertainties did not converge. Exclude impacts that are not of this drop, check the ball, or record more impacts.
diagnostic-sampling-failed = The times cannot be explained as those of one drop. Exclude other sounds, or analyse each drop by itself.
diagnostic-missed-in-a-row = { $missed } impacts in a row were missed after impact { $after }. Include them, or exclude the impacts after the gap.
diagnostic-flight-too-long = The flight after impact { $after } lasts { $duration_s }, which air drag makes impossible for this ball. Include an impact that was missed there, or check mass, diameter and the unit of the times.
diagnostic-gains-speed = The ball would gain speed at most impacts, which is impossible on a surface at rest; are the times in order, in seconds, and of one drop?
diagnostic-variances-confounded = The variances of these groups cannot be separated.

diagnostic-out-of-range = { $quantity } is { $value }{ $unit ->
    [none] {""}
   *[other] {" "}{ $unit }
  }; it must be { $range ->
    [above] finite and above { $low }
    [at-least] finite and at least { $low }
    [below] finite and below { $high }
    [at-most] finite and at most { $high }
    [above-below] above { $low } and below { $high }
    [above-at-most] above { $low } and at most { $high }
    [at-least-below] at least { $low } and below { $high }
    [at-least-at-most] from { $low } to { $high }
   *[finite] finite
  }
diagnostic-unknown-name = No { $kind } is called “{ $name }”; the nearest is “{ $nearest }” (known: { $known }).
diagnostic-reynolds-too-high = The drag table ends at Reynolds number { $max_reynolds }, but the ball reaches { $reynolds }; add a point there or choose the standard curve.
diagnostic-ball-floats = The ball weighs { $mass_kg } and displaces { $displaced_kg } of air, so it floats; check mass and diameter, or neglect buoyancy.
diagnostic-endless-drop = The ball still rises { $apex_m } after { $bounces } bounces; lower the restitution, stop at a greater height, or ask for at most { $bounces } bounces.
diagnostic-too-few-flights = A log-linear fit of the flight times needs at least 2 flights, and there { $flights ->
    [0] are none
    [one] is 1
   *[other] are { $flights }
  }; use a recording with at least 3 impacts, or a wider range of flights.
diagnostic-too-few-drops = This needs { $needed } drops or more, and there { $drops ->
    [0] are none
    [one] is 1
   *[other] are { $drops }
  }.
diagnostic-no-band = No band lies { $range } Hz, at least by half; at this sample rate the bands are { $bands } Hz.
diagnostic-settings-contradict = { $first } and { $second } contradict each other; leave out one.
diagnostic-not-in-order = { $what } number { $number } is not above the number before it; number them in order, once each.
diagnostic-no-channel = There is no channel { $channel }: the recording has { $channels ->
    [one] only one
   *[other] { $channels }, the first being 1
  }.
diagnostic-too-many-drops = There are { $drops } drops; only the first { $most }, until { $end_s } s, were analysed. Cut the recording there, and analyse the rest by itself.
diagnostic-too-many-channels = { $channels } channels are more than can be analysed together: at this sample rate at most { $most }; choose one of them.
diagnostic-each-of-reference = A share of a reference compares means: single drops have no share.
diagnostic-implausible-quantity = { $quantity }: { $value } { $unit }?{ $meant_unit ->
    [none] {""}
   *[other] {" "}Did you mean { $meant } { $meant_unit }?
  }
diagnostic-implausible-ball = A ball of { $mass_kg } and { $diameter_m } in diameter?{ $meant_g ->
    [none] { $meant_cm ->
        [none] { $meant_mm ->
            [none] {""}
           *[other] {" "}Did you mean { $meant_mm } mm?
          }
       *[other] {" "}Did you mean { $meant_cm } cm?
      }
   *[other] { $meant_mm ->
        [none] {" "}Did you mean { $meant_g } g?
       *[other] {" "}Did you mean { $meant_g } g and { $meant_mm } mm?
      }
  }

diagnostic-assumed-ball = The ball is { $ball }.
diagnostic-ball-not-stated = The ball was not stated: the intervals hold for every kind of ball that the times allow. State it, and they become narrower.
diagnostic-assumed-contact-time = The ball touches the surface for { $contact_time_s }.
diagnostic-assumed-rule-ball = The ball is { $ball }, as in the rule.
diagnostic-assumed-rule-height = The lowest point of the ball fell { $height_m } ± { $sd_m }, as in the rule.
diagnostic-assumed-air = Air of { $temperature_k } °C, { $pressure_pa } hPa, { $relative_humidity } % humidity.
diagnostic-assumed-gravity = Gravity { $gravity_m_s2 }.

diagnostic-prior-restitution = Restitution: uniform from 0 to 1.
diagnostic-prior-restitution-stated = Restitution over the impact speed, as stated: { $prior }.
diagnostic-prior-scatter = Scatter of restitution: about { $relative_sd } %, likely { $low_relative_sd } to { $high_relative_sd } %.
diagnostic-prior-slow-losses = Impacts slower than those detected: as the law says, or with losses that grow besides as the speed falls (by a power of about { $exponent }).
diagnostic-prior-exact = { $input }: exact.
diagnostic-prior-unknown = { $input }: unknown (a factor e either way).
diagnostic-prior-input = { $input }: known to { $relative_sd } %.
diagnostic-prior-height = Drop height: measured, { $height_m } ± { $sd_m }.
diagnostic-prior-height-flat = Drop height: uniform in its logarithm.
diagnostic-prior-release = Release: measured, { $release_s } s ± { $sd_s }.
diagnostic-prior-missed = Each further impact missed at the start: half as likely; where the sound was quiet, next to impossible. In a list of times nothing shows whether impacts were missed.

diagnostic-rule-without-limits = The rule states no limits.
diagnostic-procedure-not-kept = The procedure of the rule was not kept: { $item }.
diagnostic-drop-without-first-flight = The first flight of drop { $drop } was not detected: the rule asks for the rebound of the first impact.
diagnostic-rule-secondary = The text of this rule was not read, but one that cites it: check the current edition before you rely on a verdict.
diagnostic-model-differs = The model gives another value than the procedure of the rule, by more than the uncertainties of both; the verdict is by the procedure.
diagnostic-drops-that-decide = { $drops } drops with this mean and scatter would decide.
diagnostic-no-drops-decide = More drops would not decide: what all of them share is too uncertain, as the height of release and the contact time.
diagnostic-rule-needs-height = The rule states no height, and the drop height was not stated.
diagnostic-limit-within-uncertainty = A limit lies within the uncertainty; more or better drops would help.
diagnostic-rule-unverified = This rule was written from memory; do not rely on it.
diagnostic-formula-unverified = The text of the formula of this rule was not read ({ $read }).
diagnostic-rule-other-ball = The rule is for a ball of the kind { $ball }, and the stated ball has another mass or diameter: is it the right rule?
diagnostic-rule-without-point = The rule does not state at which point of the ball it measures; the lowest point is taken.
diagnostic-verdict-of-few-drops = { $drops ->
    [one] The verdict is for this one drop: it does not show the scatter between drops; three or more would.
   *[other] Two drops hardly show the scatter between drops, so their mean is uncertain; a third would help much.
  }
