# Names that the engine and the page show.

restitution-law-constant = constant
restitution-law-linear = linear
restitution-law-power = power
restitution-law-viscoelastic = viscoelastic
restitution-law-knee = knee
restitution-law-smooth = smooth

ball-unstated = not stated
ball-table-tennis = table tennis
ball-light-plastic = light plastic ball
ball-hard = hard ball (golf, steel, glass)
ball-soft-rubber = rubber ball (tennis, squash, superball)
ball-inflated = inflated ball (basketball, football)
ball-table-tennis-40 = table tennis 40+
ball-table-tennis-38 = table tennis 38 mm
ball-tennis = tennis
ball-football = football
ball-futsal = futsal
ball-basketball = basketball
ball-golf = golf
ball-squash = squash
ball-racquetball = racquetball
ball-pickleball = pickleball
ball-padel = padel
ball-marble = glass marble
ball-steel = steel ball
ball-rubber = rubber ball
ball-sized = { $ball }, { $diameter } mm
ball-measured = { $mass } g, { $diameter } mm
