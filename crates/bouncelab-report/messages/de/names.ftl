restitution-law-constant = gleichbleibend
restitution-law-linear = linear
restitution-law-power = Potenzgesetz
restitution-law-viscoelastic = viskoelastisch
restitution-law-knee = mit Knick
restitution-law-smooth = glatt, ohne Gesetz
