session-untitled = A session
session-counts = { $drops ->
    [one] 1 drop
   *[other] { $drops } drops
  } in { $recordings ->
    [one] 1 recording
   *[other] { $recordings } recordings
  }{ $without ->
    [0] {""}
   *[other] , { $without } without a drop
  }{ $failed ->
    [0] {""}
   *[other] , { $failed } not readable
  }{ $duplicates ->
    [0] {""}
   *[other] , { $duplicates } the same as another
  }
session-without-drop = Without a drop
session-failed = Not readable
session-duplicates = Same content as another recording, which is used
session-left-out = Not compared
session-odd = Remarks on drops
session-compared = Drops are compared by their restitution at an impact speed of { $speed } m/s, which most of them cover, corrected for drag.
session-unlike = Outliers in their group, included in all results: { $names }.
session-incomparable = Nothing can be compared: { $reason }
session-groups-table = Restitution by group: mean and its standard error, shared uncertainty, scatter between drops and between impacts, and the number of drops that would halve the interval
session-intervals-table = 95 % intervals of the mean, of the next drop, and of the scatter between drops
session-without-table = With and without the outliers of each group
session-varies-table = Variance components: standard deviation of the restitution by factor
session-differences-table = Differences by { $factor }, all else equal
session-trends-table = Change of restitution with numeric metadata, all else equal
session-groups = Groups
session-against-speed = Restitution against speed
session-what-varies = Variance components
session-differences-heading = Differences
session-in-order = In order of time
session-troubles = What did not work
session-conditions = Conditions
session-assumed = Not stated, and therefore assumed:
session-method = Method
session-method-drop = Each drop is inferred separately: fall, drag, scatter of the impacts, errors of the times. Its restitution at the common speed has an uncertainty of its own (timing, scatter of the impacts) and one that it shares with all drops of the ball (drag law, air, mass, diameter, contact time). Only the first averages out over drops.
session-method-group = A group is described by a random-effects model, a scatter between drops beside the error of each: restricted maximum likelihood (Viechtbauer 2005), standard error of Hartung and Knapp (2001) in the form of Röver, Knapp and Friede (2015), Student's t, Q-profile interval for the scatter (Viechtbauer 2007), interval for the next drop (Higgins, Thompson and Spiegelhalter 2009).
session-method-factors = Variance components, and differences with all else equal, come from a mixed model with crossed random factors (Patterson and Thompson 1971), degrees of freedom after Satterthwaite (Giesbrecht and Burns 1985); with a single factor from Welch (1947). Probabilities are adjusted for the number of differences (Holm 1979). Outliers are identified by modified z-scores above 3.5 (Iglewicz and Hoaglin 1993) and not removed.
session-hashes = The table of drops has the SHA-256 of every recording (content_sha256).

session-column-difference = difference
session-column-interval = 95 % interval
session-column-p-holm = p (Holm)
session-column-p = p
session-column-group = group
session-column-drops = drops
session-column-shared = shared
session-column-between-drops = between drops
session-column-between-impacts = between impacts
session-column-needed = needed
session-column-with = with
session-column-without = without
session-column-factor = with
session-column-levels = levels
session-column-slope = slope
session-column-mean = mean
session-column-next = next drop
session-column-count = how many
session-column-varies = varies by
session-per-metre = per m
session-per-kelvin = per K
session-all = all
session-too-many = too many
session-drop = drop
session-together = { $names } (always together)
session-too-few = too few to tell

session-all-drops = all drops
session-no-inference = no drop has an inference that could be compared
session-no-speed = no drop knows its restitution at { $speed } m/s: its impacts are slower or faster
session-unknown-there = it does not know its restitution at { $speed } m/s
session-one-drop = One drop alone says nothing of the scatter between drops, and so nothing of the interval of a mean: drop the ball several times.
session-one-group = All drops are in one group, so there is nothing to compare. Differences need two groups: of another ball, another surface or another person.
session-no-curve = it knows its restitution at no speed: too few impacts, or too small a range of speeds
groups-assumed-of-some = { $assumption } (in { $count } of { $all } recordings).
