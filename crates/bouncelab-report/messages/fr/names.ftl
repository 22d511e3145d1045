restitution-law-constant = constante
restitution-law-linear = linéaire
restitution-law-power = puissance
restitution-law-viscoelastic = viscoélastique
restitution-law-knee = coudée
restitution-law-smooth = lisse
