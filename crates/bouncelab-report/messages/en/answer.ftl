# What a person reads first of a drop: the answer, or why there is none.

answer-kept-first = At { $speed }, the speed of the first impact detected, the ball keeps { $share } of its speed, which is { $energy } of its energy.
answer-kept-asked = At { $speed } the ball keeps { $share } of its speed; at the first impact detected it kept { $energy } of its energy.
answer-kept-always = The ball keeps { $share } of its speed at each bounce, from { $fastest } down to { $slowest }, which is { $energy } of its energy.
answer-round = At { $speed } it keeps { $share }.
answer-fell = It fell from { $height }.
answer-fell-first = It fell from { $height } before the first impact detected.
answer-height-stated = The drop height is { $height }, by the times and the height that was stated.
answer-median = The ball kept { $share } of its speed, the median of its impacts from { $fastest } down to { $slowest }, corrected for drag.
answer-median-too-few = There is no median: { $count } of the impacts lie between two flights, and 3 are needed.
answer-none = Restitution and drop height cannot be stated. { $reason }
answer-ball = These numbers are for { $ball }.
answer-ball-assumed = These numbers are for { $ball }, which is assumed: the ball was not stated.
answer-line = The log-linear fit of the flight times, which neglects the air, gives { $share } and a drop height of { $height }.
answer-line-agrees = The log-linear fit of the flight times, which neglects the air, gives the same within the uncertainty: { $share } and a drop height of { $height }.
answer-line-differs = The log-linear fit of the flight times, which neglects the air, gives { $share } where the impacts corrected for drag give { $corrected }, and a drop height of { $height }.
