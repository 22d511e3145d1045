# Names that the engine and the page show.

restitution-law-constant = constant
restitution-law-linear = linear
restitution-law-power = power
restitution-law-viscoelastic = viscoelastic
restitution-law-knee = knee
restitution-law-smooth = smooth
