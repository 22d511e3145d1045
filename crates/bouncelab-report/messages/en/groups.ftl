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
session-unlike = Outliers in their group, included in all results: { $names }.
session-incomparable = Nothing can be compared: { $reason }
session-groups-table = Restitution by group with its standard uncertainty, what of it all drops share, scatter between drops and between impacts, and the number of drops that would halve the interval
session-intervals-table = 95 % intervals of the restitution, of the next drop, and of the scatter between drops; repeatability and reproducibility standard deviations (ISO 5725)
session-without-table = With and without the outliers of each group
session-differences-table = Differences of groups: at the speed of the comparison, with the probability that they are above zero, and as a mean over all speeds that both groups have
session-groups = Groups
session-against-speed = Restitution against speed
session-differences-heading = Differences
session-in-order = In order of time
session-troubles = What did not work
session-conditions = Conditions
session-assumed = Not stated, and therefore assumed:
session-method = Method
session-method-drop = Each drop is inferred separately: fall, drag, scatter of the impacts, errors of the times. Its likelihood, without what was assumed before the data, goes into one model of all drops at the speeds of its own impacts. What all drops of a ball share (drag, air, mass, diameter, contact time) keeps the uncertainty that it has in a single drop.
session-method-group = A group has one curve of ln e over ln v, a cubic spline whose slope walks at random, about which its drops scatter in level. Given the scatter this is linear and Gaussian; the scatter is integrated out with an exponential prior of mean 1 % (Simpson et al. 2017).
session-hashes = The table of drops has the SHA-256 of every recording (content_sha256).

session-column-difference = difference
session-column-interval = 95 % interval
session-column-group = group
session-column-drops = drops
session-column-shared = shared
session-column-between-drops = between drops
session-column-between-impacts = between impacts
session-column-needed = needed
session-column-with = with
session-column-without = without
session-column-mean = restitution
session-column-next = next drop
session-column-count = how many
session-column-varies = varies by
session-too-many = too many

session-all-drops = all drops
session-no-inference = no drop has an inference that could be compared
session-no-speed = no drop has impacts as slow and as fast as { $speed } m/s
session-one-drop = One drop alone says little of the scatter between drops, so the interval is wide: drop the ball several times.
session-one-group = All drops are in one group, so there is nothing to compare. Differences need two groups: of another ball, another surface or another person.
session-no-curve = it says nothing of the restitution curve: too few impacts, or draws that their covariance does not describe
groups-assumed-of-some = { $assumption } (in { $count } of { $all } recordings).
session-scatter-table = Scatter of restitution beside that of the drops, relative
session-curve-table = Restitution at several impact speeds
session-heights = Drop heights
session-heights-table = Drop heights by the curve of the group
session-ruler = Stated heights are above those heard by { $value } (95 %: { $interval }): the zero of the ruler.
session-in-words = { $group }: restitution { $value } at { $speed } (95 %: { $interval }), from { $drops ->
    [one] 1 drop
   *[other] { $drops } drops
  } that scatter by { $scatter }.
session-difference-in-words = { $of } less { $less }: { $value } (95 %: { $interval }); it is above zero with a probability of { $probability }.
session-method-scatter = Operators, and what else makes no groups, scatter with a prior of mean 0.2 %. Differences are looked at one by one. Outliers are drops whose level has a modified z-score above 3.5 (Iglewicz and Hoaglin 1993); they are not removed.
session-column-drop = drop
session-column-repeatability = repeatability
session-column-reproducibility = reproducibility
session-column-above = above zero
session-column-over = over all speeds
factor-ball = ball
factor-surface = surface
factor-operator = operator
factor-student = student
factor-place = place
