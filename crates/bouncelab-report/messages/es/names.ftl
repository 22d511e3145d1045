restitution-law-constant = constante
restitution-law-linear = lineal
restitution-law-power = potencial
restitution-law-viscoelastic = viscoelástica
restitution-law-knee = con codo
restitution-law-smooth = suave
