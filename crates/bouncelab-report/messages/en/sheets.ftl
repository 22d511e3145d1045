sheet-fields = Name: _________________________ Class: ______________ Date: ______________
sheet-page = The page on your phone: { $address }
sheet-set-up = A ball above a floor, its height h, and a phone beside it
sheet-qr-code = QR code of the page
sheet-need = You need
sheet-do = What to do
sheet-write = Write down
sheet-work = Work out
sheet-expected = What to expect
sheet-expected-made = Computed by bouncelab, with the air of a room (20 °C, sea level) and standard gravity. Restitution in the tables is assumed to be the same at every speed.
sheet-talk = Talk about it
sheet-teacher = For the teacher
sheet-teacher-collect = Collect: each group shares its drop as a link, and the table of drops of the page takes all links at once. It groups them by ball and surface, gives the mean of each group with its 95 % interval, and names the drops that do not fit.
sheet-teacher-quiet = A hard floor or a stone plate on a firm table, and silence for ten seconds, are all it takes. A phone lies within a metre, not on the plate.
sheet-no-air = without air
sheet-column-ball = ball
sheet-column-drop = drop
sheet-column-restitution = e
sheet-column-first = T₁ (s)
sheet-column-second = T₂ (s)
sheet-column-third = T₃ (s)
sheet-column-ratio = T₂ / T₁
sheet-column-height = height of bounce 1 (cm)
sheet-column-terminal = terminal speed (m/s)
sheet-column-speed = speed at impact 1 (m/s)
sheet-column-share = drag there, in % of the weight
sheet-column-gravity = 8 h T₂² / T₁⁴ (m/s²)
sheet-column-off = off by (%)
sheet-column-mean = mean

sheet-bounciness-title = How bouncy is a ball?
sheet-bounciness-aim = A ball keeps a share e of its speed at each bounce: its restitution. You find e with the ear of a phone, because each flight lasts about e times as long as the one before.
sheet-bounciness-need-1 = three different balls, a hard floor, a ruler or tape measure
sheet-bounciness-need-2 = a phone or computer with the page of bouncelab
sheet-bounciness-do-1 = Choose your ball on the page, put the phone beside the place where the ball will bounce, and tap “Listen”.
sheet-bounciness-do-2 = Hold the lowest point of the ball { $height } cm above the floor. Let go without a push. Wait until the ball rests.
sheet-bounciness-do-3 = Read the first flight times from the list of impacts: T₁ is the time from impact 1 to impact 2, T₂ from 2 to 3.
sheet-bounciness-do-4 = Drop each ball three times.
sheet-bounciness-work-1 = Divide T₂ by T₁ for each drop, and take the mean of each ball.
sheet-bounciness-work-2 = Which ball keeps most of its speed? Which share of its energy does it keep (e²)?
sheet-bounciness-work-3 = Compare your T₂ / T₁ with the e of the page. Which one is larger, and why?
sheet-bounciness-see = A { $ball } ball from { $height } cm, for several values of e. T₂ / T₁ is less than e: the air slows the ball too.
sheet-bounciness-talk-1 = Why does the time of a flight tell the speed at which it began?
sheet-bounciness-talk-2 = The height of a bounce is e² times the one before. How high is bounce 5 of your best ball?
sheet-bounciness-talk-3 = Three drops of the same ball differ. Is it the ball, the floor or the way you let go?
sheet-bounciness-teacher-1 = Without air, T₂ / T₁ = e. The difference in the table is nearly all the air: { $off } % for e = 0.90. The page takes the air out of its e.

sheet-air-title = How much does air take?
sheet-air-aim = Air slows every ball, a light and large one most. You measure by how much, with flight times that would all shrink by the same factor if there were no air.
sheet-air-need-1 = a table tennis ball, a tennis ball and a golf ball (or a steel ball), a hard floor, a tape measure
sheet-air-need-2 = a phone or computer with the page of bouncelab
sheet-air-do-1 = Choose the ball on the page, tap “Listen”, and drop the ball from { $height } cm.
sheet-air-do-2 = Write down the times of the first three flights of each ball.
sheet-air-do-3 = Look at the figure “Restitution” of each drop: once as if there were no air, once with the air taken out.
sheet-air-work-1 = Compute T₂ / T₁ and T₃ / T₂. Without air they would be equal, if the ball keeps the same share at each bounce.
sheet-air-work-2 = Which ball has the largest difference between T₂ / T₁ and T₃ / T₂? Why that one?
sheet-air-work-3 = Estimate the drag at the first impact from the terminal speed: drag / weight = (speed / terminal speed)².
sheet-air-see = Balls from { $height } cm that all have e = { $restitution }. The air makes T₂ / T₁ differ, and a little the time for which a ball touches the floor.
sheet-air-talk-1 = Why does the steel ball hardly feel the air although it is so small?
sheet-air-talk-2 = At later, slower flights T₃ / T₂ comes closer to e. Why?
sheet-air-talk-3 = A class measured a table tennis ball without thinking of air. Is their e too large or too small?
sheet-air-teacher-1 = The drag of a table tennis ball at its first impact is { $share } % of its weight. It makes T₂ / T₁ { $off } % smaller than e.
sheet-air-teacher-2 = The real e of a ball changes with speed, so T₃ / T₂ − T₂ / T₁ is not the air alone. The page separates the two, and says where the drop cannot.

sheet-gravity-title = Measure g with a ball
sheet-gravity-aim = From a known height and two flight times follows the acceleration of gravity g, without a stopwatch: the ball says itself how much it loses at each bounce.
sheet-gravity-need-1 = a heavy, small ball (golf or steel), a stone plate, a ruler to a millimetre
sheet-gravity-need-2 = a phone or computer with the page of bouncelab
sheet-gravity-do-1 = Measure the height h from the plate to the lowest point of the ball: { $height } cm, to a millimetre if you can.
sheet-gravity-do-2 = Tap “Listen” and let go without a push. Drop the ball five times.
sheet-gravity-do-3 = Write down T₁ and T₂ with four decimals.
sheet-gravity-work-1 = The ball lands with v = √(2 g h) and leaves with e v. So T₁ = 2 e v / g, and e = T₂ / T₁. Show that g = 8 h T₂² / T₁⁴.
sheet-gravity-work-2 = Compute g for each drop, then the mean and its standard error.
sheet-gravity-work-3 = On the page, give the height under “change”, tick “measure g”, and compare.
sheet-gravity-see = What the formula gives for balls from { $height } cm with e = { $restitution }, if g is { $gravity } m/s².
sheet-gravity-talk-1 = The tennis ball gives too small a g, although it feels less of the air than the table tennis ball. What else takes time at a bounce?
sheet-gravity-talk-2 = A millimetre of { $height } cm is { $share } %. How large is the error of g that follows from it?
sheet-gravity-talk-3 = g is 9.78 m/s² at the equator and 9.83 m/s² at the poles. Could you tell them apart?
sheet-gravity-teacher-1 = The formula has e squared: if e scatters by 0.5 % from bounce to bounce, g scatters by { $scatter } % from drop to drop. With five drops the mean is known to { $mean } %.
sheet-gravity-teacher-2 = The release matters most: a ball that is pushed or turned has another height. A magnet that lets go of a steel ball helps.
sheet-gravity-teacher-3 = A tennis ball touches the floor for { $contact } ms, which count as flight: g comes out { $soft } % too small. The air shortens T₁ and lowers T₂ / T₁; in this formula the two nearly cancel. The page takes both out.

sheet-ball-table-tennis-40 = table tennis
sheet-ball-tennis = tennis
sheet-ball-golf = golf
sheet-ball-steel = steel, 2 cm
